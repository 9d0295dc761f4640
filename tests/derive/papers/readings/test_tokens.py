"""What an extraction leaves of a formula, and which chains of equations a statement consists of."""

from __future__ import annotations

import pytest

from derive.papers.condurache_popa_2023.alphabet import LOST
from derive.papers.condurache_popa_2023.marks import limit
from derive.papers.language.notation import (
    Re,
    binomial,
    both,
    cross,
    dot,
    dyad,
    equal,
    factorial,
    iff,
    implies,
    nonzero,
    norm,
    pm,
    remark,
    root,
    sin,
    skew,
    transpose,
    triple,
    words,
)  # fmt: skip
from derive.papers.language.terms import Letter, Term, text
from derive.papers.readings.tokens import Place, Token, equations, surviving

a, b, c, n = (*(Letter(name, "dual number") for name in "abc"), Letter("n", "order"))
u, v = (Letter(name, "dual vector") for name in "uv")
SIGNS = {Place.BEFORE: "{0}_", Place.AFTER: "_{0}", Place.BETWEEN: "_{0}_", None: "{0}"}


def shown(token: Token) -> str:
    """A part as it is; a mark with _ where its terms are."""
    if token.mark is not None:
        assert token.term is None
        return SIGNS[token.place].format(token.mark.name)
    assert token.term is not None
    return text(token.term)


@pytest.mark.parametrize(
    ("side", "tokens"),
    [(a, "a"), (a - b, "a b"), (a + b, "a _plus_ b"), (-a, "a"), (a / (b + 2), "a b _plus_ 2"), (a**2, "a 2"),
     (root(a) * norm(v), "a v"), (dyad(u, v), "u v"), (dot(u, v), "u _dot_ v"), (cross(u, v), "u _cross_ v"),
     (skew(u) * v, "u _skew v"), (transpose(skew(u)), "u _skew _transpose"), (pm(a - b), "pm_ a b"),
     (Re(a) + b, "Re_ a _plus_ b"), (sin(a) * b, "sin_ a b"), (factorial(n), "n _factorial"),
     (norm(v) ** 2 * a, "|v|^2 a"), (norm(v) ** 4, "|v|^4"), (norm(v) ** 3, "v 3"), (norm(u - v) ** 2, "u v 2"),
     (norm(v) ** n, "v n"), (a ** norm(v), "a v"),
     (binomial(n, a), "n a"), (triple(u, v, u), "u,v,u")],
    ids=str,
)  # fmt: skip
def test_marks_survive_where_the_extraction_shows_them(side: Term, tokens: str) -> None:
    assert " ".join(map(shown, surviving(side, LOST))) == tokens


def test_what_is_not_lost_survives() -> None:
    assert [shown(token) for token in surviving(a - norm(v) / b, "/")] == ["a", "_minus_", "|v|", "b"]


# ---- chains ----------------------------------------------------------------------------------------------------------

first, second = equal(a, b), equal(b, c, a)


@pytest.mark.parametrize(
    ("statement", "chains"),
    [(first, ((a, b),)), (second, ((b, c, a),)), (remark(second, words("x", "x")), ((b, c, a),)),
     (both(first, second), ((a, b), (b, c, a))), (iff(first, second), ((a, b), (b, c, a))),
     (both(first, remark(second, words("x", "x"))), ((a, b), (b, c, a))),
     (implies(first, second), ()), (nonzero(a), ()), (both(first, nonzero(a)), ()), (a, ()),
     (remark(nonzero(a), words("x", "x")), ()), (equal(limit(n, a * n), b), ((a * n, b),)),
     (equal(sin(a), b), ((sin(a), b),))],
    ids=str,
)  # fmt: skip
def test_a_statement_consists_of_chains_of_equations(statement: Term, chains) -> None:
    assert equations(statement) == chains
