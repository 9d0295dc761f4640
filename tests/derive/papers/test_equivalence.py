"""A mutant is equivalent only if what was changed says the same whatever its letters stand for."""

from __future__ import annotations

import pytest

from derive.papers import PAPERS
from derive.papers.condurache_popa_2023.alphabet import alpha, n, u, v
from derive.papers.decide import ORDERS, decide
from derive.papers.equation import Equation, equation
from derive.papers.equivalence import equivalent
from derive.papers.karakilic_2010.marks import ordered
from derive.papers.language.notation import (
    Du,
    Re,
    both,
    cases,
    cos,
    cot,
    det,
    equal,
    implies,
    nonzero,
    norm,
    pm,
    sin,
    skew,
    tan,
)  # fmt: skip
from derive.papers.language.notation import identity as I
from derive.papers.language.terms import Letter, Number, Term, letters
from derive.papers.mutation import Score, try_mutants
from derive.papers.numbers.kinds import SIGN

a, b = (Letter(name, "dual number") for name in "ab")
w = Letter("w", "dual vector")
angle = Letter("f", "real angle")
ENTRY = equation("1", "title", 1, equal(a, a))
t, zero = tan(angle / 2), Number(0)


def same(before: Term, after: Term) -> bool:
    return equivalent(ENTRY, (before, after), ORDERS)


@pytest.mark.smoke
@pytest.mark.parametrize(
    ("before", "after"),
    [(equal(a, b * norm(v - w)), equal(a, b * norm(w - v))), (equal((a - b) ** 2, a), equal((b - a) ** 2, a)),
     (nonzero(Re(a - b)), nonzero(Re(b - a))), (equal(a - b, 0), equal(b - a, 0)), (nonzero(Re(a)), nonzero(Re(a**2))),
     (nonzero(Re(a)), nonzero(Re(1 / a))), (nonzero(Re(det(I - skew(v)))), nonzero(Re(det(I + skew(v))))),
     (both(ordered(zero, t), nonzero(a)), both(ordered(zero, cot(angle / 2)), nonzero(a))),
     (equal(u, pm(a * v)), equal(u, pm(-a * v))), (equal(a, cos(alpha / 2)), equal(a, cos(-alpha / 2))),
     (equal(a, (-Number(1)) ** n), equal(a, (-Number(1)) ** (n + 2))),
     (nonzero(cos(alpha)), nonzero(cos(alpha) ** 2)), (nonzero(tan(alpha)), nonzero(tan(alpha) ** 3)),
     (nonzero(a - b), nonzero(b - a)), (ordered(zero, t), ordered(zero, t**3))],
    ids=str,
)  # fmt: skip
def test_the_same_is_said_in_other_words(before: Term, after: Term) -> None:
    assert same(before, after)


@pytest.mark.parametrize(
    ("before", "after"),
    [(equal(a, a), equal(b, b)), (equal(a - b, a - b), equal(b - a, b - a)), (equal(a - b, b), equal(b - a, b)),
     (nonzero(Re(det(I - skew(v)))), nonzero(Re(det(I)))), (nonzero(Re(a)), nonzero(Du(a))),
     (nonzero(Re(1 - a**2)), nonzero(Re(1 - a**3))), (nonzero(Re(a)), nonzero(Re(a * b))),
     (ordered(zero, t), ordered(zero, -t)), (ordered(zero, t), ordered(zero, t**2)),
     (implies(nonzero(Re(a)), nonzero(b)), implies(nonzero(Re(1 / a)), nonzero(b))),
     (equal(b, cases((a, nonzero(Re(a))), (a, equal(a, 0)))), equal(b, cases((a, nonzero(Re(a))), (b, equal(a, 0))))),
     (equal(a, sin(alpha / 2)), equal(a, sin(-alpha / 2))), (equal(u, pm(v) + w), equal(u, pm(v) - w)),
     (nonzero(tan(alpha / 2)), nonzero(sin(alpha / 2))), (nonzero(cos(alpha)), nonzero(tan(alpha))),
     (nonzero(sin(alpha)), nonzero(1 - cos(alpha))),
     (equal(a, (-Number(1)) ** n), equal(a, (-Number(1)) ** (n + 1)))],
    ids=str,
)  # fmt: skip
def test_what_is_also_true_is_not_the_same(before: Term, after: Term) -> None:
    assert not same(before, after)


def _score(number: str) -> Score:
    (paper, entry), = ((p, e) for p in PAPERS for e in p.entries() if e.number == number)
    return try_mutants(decide(paper.slug, entry, paper.lost, count=False))


@pytest.mark.parametrize("entry", [e for e in PAPERS[0].entries() if e.number in ("18", "18-axis")], ids=str)
def test_a_sign_that_is_lost_is_not_the_same(entry: Equation) -> None:
    sign = next(x for x in letters(entry.readings[0].statement) if x.kind is SIGN)
    assert equivalent(entry, (sign * a, a * sign), ORDERS)
    assert not equivalent(entry, (sign * a, a), ORDERS)


def test_equivalent_mutants_are_counted_apart() -> None:
    score = _score("not-singular")
    assert [mutant.change for mutant in score.equivalent] == ["arguments of minus swapped"]
    assert {mutant.change for mutant in score.survivors} >= {"second part of minus dropped"}
    assert score.share < 1


def test_domains_of_real_parts_differ_from_those_of_dual_parts() -> None:
    assert not any(mutant.change == "condition: Re made Du" for mutant in _score("39").survivors)
