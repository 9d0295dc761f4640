"""Certificates of theorems on sums of binomials: the sums as integer lists, and the laws that they obey.

A law is a polynomial in n, x and series. It is checked at n = 1 … `CHECKED` only, by other means than the proof.
"""

from __future__ import annotations

from typing import Any

import sympy

from .identity import Proof
from .notation import Shifted, j, n, text, x

CHECKED = 12
"""Last order at which the laws are checked."""
EMPTY: dict[str, Any] = {"relations": [], "factors": [], "free": [], "origin": {}, "equations": []}


def series(proof: Proof) -> dict[str, Any]:
    """Return the sums and the laws of a theorem whose right sides are sums of binomials."""
    given = [premise.equation for premise in proof.premises if not isinstance(premise.equation.left, sympy.binomial)]
    sums = {e.left: e.right for e in (*proof.claim, *given) if isinstance(e.right, sympy.Sum)}
    uses: dict[sympy.Expr, tuple[str, int, int]] = {}
    laws = []
    for equation in (e for e in given if e.left not in sums or not isinstance(e.right, sympy.Sum)):
        start = isinstance(equation.left, Shifted) and equation.left.args[2].is_Integer
        laws.append((equation.text, start, _named(equation.left, sums, uses) - _named(equation.right, sums, uses)))
    symbols = {use: sympy.Symbol(f"use{place}") for place, use in enumerate(uses)}
    variables = [n, x, *symbols.values()]
    shown = [
        {"label": label, "start": bool(start), "law": _terms(law.xreplace(symbols), variables)}
        for label, start, law in laws
    ]
    return {
        "last": CHECKED,
        "sums": {text(term): _sum(value) for term, value in sums.items()},
        "part": {**EMPTY, "variables": ["n", "x", *map(str, symbols.values())]},
        "uses": list(uses.values()),
        "laws": shown,
    }  # fmt: skip


def _named(e: sympy.Expr, sums: Any, uses: dict[sympy.Expr, tuple[str, int, int]]) -> sympy.Expr:
    """Note each series in an expression, with a, b such that its index is ``a n + b``, and return the expression."""
    if isinstance(e, Shifted):
        index = sympy.Poly(e.args[2], n)
        uses[e] = (text(e.args[0]), int(index.coeff_monomial(n)), int(index.coeff_monomial(1)))
        return e
    for term in sums:
        if e.has(term):
            uses[term] = (text(term), 1, 0)
    return e


def _terms(law: sympy.Expr, variables: list[Any]) -> list[list[Any]]:
    """Return a polynomial with integer coefficients, after multiplication by a common denominator."""
    _, cleared = sympy.Poly(law, *variables).clear_denoms(convert=True)
    return [[int(c), list(exponents)] for exponents, c in cleared.terms()]


def _sum(value: sympy.Sum) -> dict[str, Any]:
    """Return a sum over j: its start, the exponent of x less j, and its summands."""
    ((_, start, _),) = value.limits
    exponent = value.function.as_powers_dict()[x]
    general = sympy.expand(value.function / x**exponent)
    summands = [_summand(product) for product in sympy.Add.make_args(general)]
    return {"start": int(start), "offset": int(exponent - j), "summands": summands}


def _summand(product: sympy.Expr) -> list[Any]:
    """Return numerator, denominator, power of n, whether the sign alternates, and the index pair of a binomial."""
    number, rest = product.as_coeff_Mul()
    powers = rest.as_powers_dict()
    (choose,) = (factor for factor in powers if isinstance(factor, sympy.binomial))
    alternating = any(base == -1 for base in powers)
    pair = [[int(e.coeff(n)), int(e.coeff(j)), int(e.xreplace({n: 0 * n, j: 0 * j}))] for e in choose.args]
    return [int(number.p), int(number.q), int(powers.get(n, 0)), alternating, *pair]
