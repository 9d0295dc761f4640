"""Slopes of scalar programs as text, printed from the theorems on every φ that state them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache

import sympy

from ...proof import phi_theorems as every
from ...proof.notation import alpha, prime, rate

NAMES = {every.rho: "rate", every.phi_1: "phi_slope", every.scalar_part: "e0", every.vector_part: "ss"}
"""Names in printed text of symbols that have another name in theorems."""

UNKNOWN = {every.phi, every.phi_2, every.phi_3, every.cosine, every.sine}
"""Symbols that rules of differentiation do not know: they take other equations."""

STRETCH = 2 * every.phi_1 * every.share
"""Factor between slopes of the share of the vector by x and by α², which is called far."""


def _terms(theorem: str) -> dict[sympy.Expr, sympy.Expr]:
    """Return the terms of a theorem that have a name in printed text: slopes, whose names end in y, and rates."""
    found: dict[sympy.Expr, sympy.Expr] = {symbol: sympy.Symbol(name) for symbol, name in NAMES.items()}
    for symbol in (every.s, every.w, every.f, every.g, every.h, every.fi, every.hi, every.rho, every.share):
        value, name = symbol, NAMES.get(symbol, symbol.name)
        for _ in range(3):
            name += "y"
            found[prime(value)] = sympy.Symbol(name) / 2
            value = 2 * prime(value)
    if theorem == "any phi: share of the vector":
        slope, bend, second = (sympy.Symbol(name) / STRETCH for name in ("slope", "bend", "second"))
        found |= {prime(every.share): slope, prime(every.phi_1): bend, prime(STRETCH * prime(every.share)): second}
    return found | {alpha: sympy.sqrt(sympy.Symbol("far", positive=True))}


@cache
def slopes() -> Mapping[str, str]:
    """Return the right side of the equation of each slope, by its name; a second equation holds far from α = 0.

    The rate of a gain gives its derivatives by the scalar part e0 and by half the square ss of the vector part.
    """
    found: dict[str, str] = {}
    every.any_phi()  # an equation that is not proved is not printed
    for theorem in every.ANY_PHI:
        terms = _terms(theorem.name)
        for equation in theorem.claim:
            left, right = (side.xreplace(terms).xreplace(terms) for side in (equation.left, equation.right))
            if left.is_Symbol and left.is_commutative and not right.free_symbols & UNKNOWN:
                found[f"{left}_far" if left.name in found else left.name] = _text(right)
            elif left == rate(every.gain):
                parts = {rate(sympy.Symbol("e0")): sympy.Dummy(), rate(sympy.Symbol("ss")): 2 * sympy.Dummy()}
                (e0, half) = (moved.as_coeff_Mul()[1] for moved in parts.values())
                change = right.xreplace(parts)
                found |= {"gain_by_e0": _text(change.diff(e0)), "gain_by_half_ss": _text(change.diff(half))}
    return found


def _text(value: sympy.Expr) -> str:
    """Return an expression as Python text, with spaces around products and quotients."""
    return re.sub(r"(?<!\*)([*/])(?!\*)", r" \1 ", sympy.sstr(value, order="none"))
