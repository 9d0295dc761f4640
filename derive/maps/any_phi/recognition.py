r"""Exact decision whether a φ is a multiple of ``α``, ``tan(α/2n)`` or ``sin(α/2n)``, written in any form.

Let u be the greatest common divisor of the factors of α. Sines, cosines and tangents of multiples of uα are rational
functions of ``E = exp(i u α)``. In lowest terms each has one form:

.. math:: \tan\frac{j u \alpha}{2} = \frac{1}{i} \frac{E^j - 1}{E^j + 1} \qquad
    \sin j u \alpha = \frac{1}{2 i} \frac{E^{2j} - 1}{E^j}
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from typing import Any

import sympy
from sympy.functions.elementary.trigonometric import TrigonometricFunction
from sympy.polys.polyerrors import CoercionFailed

from ..families import alpha

HARMONICS_MAX = 64
"""Limit of k in multiples kuα, which bounds the degree of polynomials in E."""

I, E = sympy.I, sympy.Symbol("E")
BY_EXPONENTIAL: Mapping[Any, Callable[[int], sympy.Expr]] = {
    sympy.sin: lambda k: (E**k - E**-k) / (2 * I),
    sympy.cos: lambda k: (E**k + E**-k) / 2,
    sympy.tan: lambda k: (E ** (2 * k) - 1) / (E ** (2 * k) + 1) / I,
    sympy.cot: lambda k: (E ** (2 * k) + 1) / (E ** (2 * k) - 1) * I,
}

Form = tuple[Fraction, Any, int]
"""Form (K, function, n) of ``K function(α/2n)``; (K, None, 1) for ``K α``."""


def multiple_of_known(phi: sympy.Expr) -> Form | None:
    """Return the form of φ; None for any other function."""
    if phi.is_rational_function(alpha):
        factor = sympy.cancel(phi / alpha)
        return (_fraction(factor), None, 1) if _is_positive_rational(factor) else None
    atoms = phi.atoms(TrigonometricFunction)
    shares = {atom: atom.args[0] / alpha for atom in atoms}
    if not atoms or not all(atom.func in BY_EXPONENTIAL and shares[atom].is_Rational for atom in atoms):
        return None
    unit = abs(reduce(sympy.Rational.gcd, shares.values()))
    counts = {atom: int(share / unit) for atom, share in shares.items()}
    if max(map(abs, counts.values())) > HARMONICS_MAX:
        return None
    rational = phi.xreplace({atom: BY_EXPONENTIAL[atom.func](counts[atom]) for atom in atoms})
    if not rational.is_rational_function(E) or rational.free_symbols != {E}:
        return None
    return _form(rational, _fraction(unit))


def _form(rational: sympy.Expr, unit: Fraction) -> Form | None:
    """Return the form of a rational function of E, by comparison with tangent and sine in lowest terms."""
    try:
        above, below = (sympy.Poly(part, E, domain="QQ_I") for part in sympy.fraction(sympy.together(rational)))
    except CoercionFailed:  # an irrational coefficient
        return None
    above, below = above.cancel(below, include=True)
    degree, leading = above.degree(), above.LC()
    if above.all_coeffs() != [leading, *[0] * (degree - 1), -leading]:
        return None
    ratio = leading / below.LC()
    if below == sympy.Poly(E**degree + 1, E, domain="QQ_I") * below.LC():
        return _with_order(I * ratio, sympy.tan, degree * unit)
    if degree % 2 == 0 and below == sympy.Poly(E ** (degree // 2), E, domain="QQ_I") * below.LC():
        return _with_order(2 * I * ratio, sympy.sin, degree * unit)
    return None


def _with_order(factor: sympy.Expr, function: Any, share: Fraction) -> Form | None:
    """Return the form of ``factor · function(share α/2)``, whose order is 1/share."""
    factor = sympy.expand(factor)
    known = share.numerator == 1 and _is_positive_rational(factor)
    return (_fraction(factor), function, share.denominator) if known else None


def _is_positive_rational(value: sympy.Expr) -> bool:
    return bool(value.is_Rational and value > 0)


def _fraction(value: sympy.Rational) -> Fraction:
    return Fraction(int(value.p), int(value.q))
