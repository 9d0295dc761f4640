"""Changes of a statement, each once, and what became of them."""

from __future__ import annotations

import pytest

from derive.papers.decide import ORDERS, decide
from derive.papers.equation import Equation, equation
from derive.papers.language.notation import Re, cross, equal, nonzero
from derive.papers.language.terms import Number, Symbol, Term, text
from derive.papers.mutation import Score, Survivor, domains, mutants, trials, true_statements, try_mutant, try_mutants

a, b = Symbol("a", "dual number"), Symbol("b", "dual number")
u, v, p = Symbol("u", "dual vector"), Symbol("v", "dual vector"), Symbol("p", "proposition")
SQUARE = equal((a + b) ** 2, a**2 + 2 * (a * b) + b**2)


def entry(statement: Term = SQUARE, **rest: object) -> Equation:
    return equation("1", "title", 1, statement, said="in words", **rest)


@pytest.mark.parametrize(
    ("statement", "changed"),
    [(a + a, ["a-a", "a"]), (a - a, ["a+a", "a", "-a"]), (a * b, ["a", "b"]), (Number(2), ["3"]), (a, []),
     (p, ["not p"]), (cross(u, v), ["v×u"]), (a**2, ["2^a", "a^3"]), (-a, ["a"]), (nonzero(a), ["not a≠0"]),
     (equal(a, b + 1), ["a=b-1", "a=b", "a=1", "a=b+2"])],
    ids=str,
)  # fmt: skip
def test_a_statement_has_these_mutants_each_once(statement: Term, changed: list[str]) -> None:
    assert [text(mutant) for _, mutant in mutants(statement)] == changed


def test_a_domain_is_changed_or_dropped() -> None:
    condition, claimed = nonzero(Re(a)), nonzero(b)
    changed = {what: (e.condition, e.claimed) for what, e in domains(entry(condition=condition, claimed=claimed))}
    assert changed.pop("condition dropped") == (None, claimed)
    assert changed.pop("claimed domain dropped") == (condition, None)
    assert {what: text(c) for what, (c, _) in changed.items() if what.startswith("condition")} == {
        "condition: negated": "not Re a≠0", "condition: Re made Du": "Du a≠0",
    }  # fmt: skip
    assert {what: text(c) for what, (_, c) in changed.items() if what.startswith("claimed")} == {
        "claimed domain: negated": "not b≠0"
    }
    assert list(domains(entry())) == []


def test_what_is_found_true_is_changed() -> None:
    wrong = equal((a + b) ** 2, a**2 + b**2)
    assert true_statements(decide("paper", entry(), "")) == (SQUARE,)
    assert true_statements(decide("paper", entry(wrong, corrected=SQUARE), "")) == (SQUARE,)


def test_a_mutant_is_killed_or_survives_or_combines_what_cannot_be() -> None:
    assert try_mutant(entry(), "x", equal(a + b, a)) == Score(killed=1)
    assert try_mutant(entry(), "x", equal(a + b, cross(a, b))) == Score(meaningless=1)
    assert try_mutant(entry(), "x", equal(a, a)) == Score(survivors=[Survivor("1", "x", "a=a")])


def test_a_survivor_of_a_domain_shows_the_statement() -> None:
    narrow = entry(claimed=nonzero(Re(b)), stated=(1, "for Re b ≠ 0"))
    found = dict(trials(narrow, SQUARE, ORDERS))["claimed domain dropped"]()
    assert found == Score(survivors=[Survivor("1", "claimed domain dropped", text(SQUARE))])


def test_only_every_so_many_mutants_are_tried() -> None:
    result = decide("paper", entry(equal(a + b, b + a)), "")
    count = len(list(trials(result.equation, result.equation.readings[0].statement)))
    scores = [try_mutants(result, every) for every in (1, 2, 3)]
    tried = [score.killed + score.meaningless + len(score.survivors) for score in scores]
    assert tried == [count, len(range(1, count, 2)), len(range(1, count, 3))]


def test_scores_add_up() -> None:
    one, two = Survivor("1", "x", "a"), Survivor("2", "y", "b")
    total = Score(3, 2, [one]) + Score(4, 1, [two])
    assert total == Score(7, 3, [one, two])
    assert total.share == 7 / 9
    assert Score().share == Score(killed=2).share == 1
    assert Score(survivors=[one]).share == 0
