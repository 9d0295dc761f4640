"""Mutants of statements and of their domains: enumeration, and refutation by evaluation."""

from __future__ import annotations

import pytest

from derive.papers import PAPERS
from derive.papers.decide import decide
from derive.papers.equation import Entry, equation
from derive.papers.language.operator_table import Re, cross, equal, iff, implies, nonzero, zero
from derive.papers.language.printed import Number, Symbol, Term, text
from tests.mutants.mutant import EQUIVALENT, KILLED, SURVIVED
from tests.mutants.statements import changed, domains, evaluated, is_true, trials, true_statements

a, b = Symbol("a", "dual number"), Symbol("b", "dual number")
u, v, p = Symbol("u", "dual vector"), Symbol("v", "dual vector"), Symbol("p", "proposition")
SQUARE = equal((a + b) ** 2, a**2 + 2 * (a * b) + b**2)
EVERY = 97
"""Stride of the sample: every 97th mutant of the papers is evaluated here; `make mutants` draws from all mutants."""


def entry(statement: Term = SQUARE, **rest: object) -> Entry:
    return equation("1", "title", 1, statement, said="in words", **rest)


def fates(tried: Entry, statement: Term) -> list[str]:
    return [trial().kind for _, trial in trials(tried, statement)]


@pytest.mark.parametrize(
    ("statement", "texts"),
    [(a + a, ["a-a", "a"]), (a - a, ["a+a", "a", "-a"]), (a * b, ["a", "b"]), (Number(2), ["3"]), (a, []),
     (p, ["not p"]), (cross(u, v), ["v×u"]), (a**2, ["2^a", "a^3"]), (-a, ["a"]), (nonzero(a), ["not a≠0"]),
     (equal(a, b + 1), ["a=b-1", "a=b", "a=1", "a=b+2"])],
    ids=str,
)  # fmt: skip
def test_mutants_of_a_statement(statement: Term, texts: list[str]) -> None:
    assert [text(mutant) for _, mutant in changed(statement)] == texts


def test_claims_and_both_directions_of_an_equivalence_are_changed() -> None:
    changes = {change for change, _ in changed(iff(zero(a), implies(Symbol("claim", "proposition"), nonzero(a))))}
    assert {"claim negated", "arguments of implies swapped"} <= changes
    assert {"second part of implies negated", "second part of iff negated"} <= changes


def test_domains_are_changed_or_dropped() -> None:
    condition, claimed = nonzero(Re(a)), nonzero(b)
    found = {change: (e.condition, e.claimed) for change, e in domains(entry(condition=condition, claimed=claimed))}
    assert found.pop("condition dropped") == (None, claimed)
    assert found.pop("claimed domain dropped") == (condition, None)
    assert {change: text(c if change.startswith("condition") else d) for change, (c, d) in found.items()} == {
        "condition: negated": "not Re a≠0", "condition: Re made Du": "Du a≠0", "claimed domain: negated": "not b≠0",
    }  # fmt: skip
    assert list(domains(entry())) == []


def test_true_statement_is_a_reading_or_the_correction() -> None:
    wrong = equal((a + b) ** 2, a**2 + b**2)
    assert true_statements(decide("paper", entry(), "")) == (SQUARE,)
    assert true_statements(decide("paper", entry(wrong, corrected=SQUARE), "")) == (SQUARE,)


def test_mutant_is_refuted_or_meaningless_or_survives() -> None:
    for mutant, fate in ((a, KILLED), (cross(a, b), EQUIVALENT), (a + b, SURVIVED)):
        assert evaluated(lambda right=mutant: is_true(entry(), equal(a + b, right))).kind == fate


def test_every_mutant_of_an_identity_is_refuted() -> None:
    found = fates(entry(), SQUARE)
    assert len(found) > 10
    assert SURVIVED not in found


def test_wrong_conditions_and_too_narrow_domains_are_noticed() -> None:
    quotient = equal(a / b * b, a)
    for domain in ({"condition": nonzero(Re(b))}, {"claimed": nonzero(Re(b)), "stated": (1, "for Re b ≠ 0")}):
        assert SURVIVED not in fates(entry(quotient, **domain), quotient)
    narrow = entry(claimed=nonzero(Re(b)), stated=(1, "for Re b ≠ 0"))
    assert dict(trials(narrow, SQUARE))["claimed domain dropped"]().kind == SURVIVED


def test_most_mutants_of_the_papers_are_refuted() -> None:
    tried = []
    for paper in PAPERS:
        for one in paper.entries():
            statement = one.corrected if one.corrected is not None else one.readings[0].statement
            tried += [trial for _, trial in trials(one, statement)]
    found = [trial().kind for trial in tried[::EVERY]]
    killed = found.count(KILLED)
    assert killed > 50
    assert killed >= 0.9 * (killed + found.count(SURVIVED))
