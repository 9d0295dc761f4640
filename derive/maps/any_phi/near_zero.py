r"""Ratio ``a(x) = α/|v|`` near v = 0, as a polynomial with a proved bound of its error.

Let ``|φ| ≥ √m`` and ``Re φ/(φ′(0) α) > 0`` on the circle |α| = R, as proved by interval arithmetic. By the minimum
principle, α = 0 is the only zero of φ inside. By Rouché's theorem, one pair ±α inside has ``φ² = x``, for |x| < m.
Hence a is analytic for |x| < m, and |a| is at most ``R/√m``.

The polynomial interpolates a at N + 1 Chebyshev points of [0, X]. Its error is at most ``4 R/√m ρ^(−N)/(ρ − 1)``. Here
ρ is the sum of the half axes of an ellipse, divided by X/2. The ellipse has foci 0 and X and lies inside |x| < m.
Errors are in units of a(0) and X.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

import mpmath
import sympy

from ..angle import angle_of, real_value
from ..elementary import alpha, evaluate
from ..grammar import PhiError
from ..real_constants import Polynomial, polynomial
from .edges import PHI_DIGITS, Edge
from .intervals import Intervals, Undecided, precise

NEAR_ANGLE = mpmath.mpf("1.3")
"""Largest angle for the interpolation of a(x); a fifth of the edge, if less."""
RADII = [mpmath.mpf(k) / 2 for k in range(16, 2, -1)] + [mpmath.mpf(k) / 16 for k in range(22, 2, -2)]
RADII += [mpmath.mpf(k) / 128 for k in range(14, 3, -1)]
"""Radii of circles that are tried."""
NEAR_DIVISORS = (1, 2, 4, 8, 16, 32, 64, 128)
"""Divisors of `NEAR_ANGLE`, tried in this order until a bound of the error is proved."""
ERROR_MAX = mpmath.mpf(10) ** -21
LIMIT_RANGE = mpmath.mpf(2) ** -22, mpmath.mpf(2) ** 18
"""Least and largest limit of x, so that limits are fractions of small integers."""
DEGREES = range(8, 40)
DERIVATIVES = 3
ARCS, PARTS = 128, 12
"""Number of arcs on a quarter of a circle, and of squares along a radius of the disc."""
NEEDED = f"phi/alpha needs a positive real part on a circle |alpha| = R in the complex plane, R >= {RADII[-1]}"


class UnitError(PhiError):
    """Error for a φ whose values near 0 are too small or too large for fractions of small integers."""


@dataclass(frozen=True)
class Ratio:
    """Polynomials for a(x) and three derivatives, below a limit of x."""

    polynomials: tuple[Polynomial, ...]
    limit: Fraction
    remainder: float  # bound of their errors, in units of a(0) and of the limit


def ratio(phi: sympy.Expr, edge: Edge) -> Ratio:
    """Return polynomials that interpolate ``α/|v|`` near 0; `PhiError` if no circle proves that a is analytic."""
    refused = list[PhiError]()
    for share in NEAR_DIVISORS:
        try:
            return _ratio(phi, edge, NEAR_ANGLE / share)
        except PhiError as error:
            refused.append(error)
    raise min(refused, key=lambda error: isinstance(error, UnitError))


def _ratio(phi: sympy.Expr, edge: Edge, near: Any) -> Ratio:
    with mpmath.workdps(PHI_DIGITS):
        end = mpmath.mpf(edge.angle.evalf(PHI_DIGITS))
        slope = mpmath.mpf(evaluate(phi.diff(alpha), alpha, mpmath.mpf(0)))
        limit = _rounded_down(phi, mpmath.mpf(evaluate(phi, alpha, min(near, end / 5))) ** 2)
        bound, within = _circle(phi, mpmath.mpf(limit.numerator) / limit.denominator)

        def share(x: Any) -> Any:
            return angle_of(phi, edge.angle, mpmath.sqrt(x)) / mpmath.sqrt(x)

        return _fitted(phi, share, limit, bound * slope, within, 1 / slope)


def length_ratio(phi: sympy.Expr, angle: Any) -> Ratio:
    """Return polynomials for φ/α as a function of α², up to an angle or a little beyond; `PhiError` if none is proved.

    On a circle |α| = R about a disc in which φ is analytic, |φ/α| is at most ``max |φ|/R``, and so it is inside.
    """
    with mpmath.workdps(PHI_DIGITS):
        limit = Fraction(int(64 * angle**2) + 1, 64)
        slope = mpmath.mpf(evaluate(phi.diff(alpha), alpha, mpmath.mpf(0)))

        def share(square: Any) -> Any:
            return real_value(phi, mpmath.sqrt(square), phi) / mpmath.sqrt(square)

        for radius in RADII:
            if radius**2 > 2 * angle**2 and is_analytic(phi, radius, 2 * PARTS) and (most := largest(phi, radius)):
                return _fitted(phi, share, limit, most / (radius * slope), radius**2, slope)
        raise PhiError(f"nothing proves that phi = {phi} is analytic in a disc |alpha| < {mpmath.nstr(2 * angle, 3)}")


def _fitted(phi: sympy.Expr, share: Callable[[Any], Any], limit: Fraction, bound: Any, within: Any, unit: Any) -> Ratio:
    """Return polynomials that interpolate a function of x below a limit; `PhiError` if the degree were too high.

    The function is analytic for |x| < `within`, and at most `bound` there in units of its value at 0, the `unit`.
    """
    X = mpmath.mpf(limit.numerator) / limit.denominator
    half_sum = (within - X / 2) / (X / 4)  # ρ + 1/ρ of the ellipse whose half axis reaches from X/2 to m
    rho = half_sum / 2 + mpmath.sqrt(half_sum**2 / 4 - 1)
    degree = next((n for n in DEGREES if _error_bound(bound, rho, n) < ERROR_MAX), None)
    if degree is None:
        raise PhiError(f"phi = {phi} would need a polynomial of degree above {DEGREES[-1]} near 0")
    nodes = chebyshev_points(0, X, degree + 1)
    fit = interpolated([x / X for x in nodes], [share(x) for x in nodes])
    coefficients = [c / X**k for k, c in enumerate(fit)]
    scale = int(mpmath.ceil(mpmath.log(X, 2)))
    found = []
    for _ in range(DERIVATIVES + 1):
        found.append(polynomial([c * mpmath.mpf(2) ** (scale * k) for k, c in enumerate(coefficients)], scale))
        coefficients = [k * c for k, c in enumerate(coefficients)][1:]
    rounding = max(split.rounding * X**count for count, split in enumerate(found)) / unit
    return Ratio(tuple(found), limit, float(_error_bound(bound, rho, degree) + rounding))


def _rounded_down(phi: sympy.Expr, size: Any) -> Fraction:
    if not LIMIT_RANGE[0] < size < LIMIT_RANGE[1]:
        few = "small" if size < 1 else "large"
        raise UnitError(f"phi = {phi} is too {few} near 0, {mpmath.nstr(mpmath.sqrt(size), 3)}: take a multiple of it")
    denominator = max(64, 2 ** int(mpmath.ceil(mpmath.log(4 / size, 2))))
    return Fraction(int(size * denominator), denominator)


def _error_bound(bound: Any, rho: Any, degree: int) -> Any:
    """Return a bound of the error of the polynomial and its three derivatives, by Cauchy's estimate on an ellipse."""
    found = []
    for share in range(1, 16):
        inner = rho ** (mpmath.mpf(share) / 16)
        apart = (inner + 1 / inner - 2) / 4  # distance of the interval from the inner ellipse
        found.append(4 * bound * (inner / rho) ** degree / (rho / inner - 1) * 6 * max(1, apart**-3))
    return min(found)


def chebyshev_points(low: Any, high: Any, count: int) -> list[Any]:
    half = mpmath.mpf(1) / 2
    return [low + (high - low) * (1 + mpmath.cospi((k + half) / count)) / 2 for k in range(count)]


def interpolated(nodes: Sequence[Any], values: Sequence[Any]) -> list[Any]:
    powers = mpmath.matrix([[t**k for k in range(len(nodes))] for t in nodes])
    return list(mpmath.lu_solve(powers, mpmath.matrix(values)))


def _circle(phi: sympy.Expr, X: Any) -> tuple[Any, Any]:
    """Return a bound of |a|, and m such that a is analytic for |x| < m, from the circle with the largest m."""
    found = [(least, radius) for radius in RADII if (least := smallest(phi, radius)) is not None]
    for least, radius in sorted(found, key=lambda pair: -pair[0]):
        if least**2 > 2 * X and is_analytic(phi, radius):
            return radius / least, least**2
    raise PhiError(f"nothing proves that the inverse of phi = {phi} is analytic near 0: {NEEDED}")


@lru_cache(maxsize=256)
def smallest(phi: sympy.Expr, radius: Any) -> Any:
    """Return a lower bound of |φ| on a quarter of a circle, above 0; None unless ``Re φ/(φ′(0) α) > 0`` is proved."""
    least = mpmath.inf
    with precise() as at:
        slope = real_value(phi.diff(alpha), mpmath.mpf(0), phi)
        try:
            for box in _arcs(at, radius):
                value = at.enclosure(phi, box)
                if not at.bounds((value / box).real)[0] * slope > 0:
                    return None
                least = min(least, at.size(value)[0])
        except Undecided:
            return None
    return least


def largest(phi: sympy.Expr, radius: Any) -> Any:
    """Return an upper bound of |φ| on a circle; None if nothing is proved."""
    with precise() as at:
        try:
            return max(at.size(at.enclosure(phi, box))[1] for box in _arcs(at, radius))
        except Undecided:
            return None


@lru_cache(maxsize=256)
def is_analytic(phi: sympy.Expr, radius: Any, parts: int = PARTS) -> bool:
    """Return whether φ is proved to be analytic in a quarter of a disc."""
    with precise() as at:
        try:
            for box in _squares(at, radius, parts):
                at.enclosure(phi, box)
        except Undecided:
            return False
    return True


def _arcs(at: Intervals, radius: Any) -> Iterator[Any]:
    for k in range(ARCS):
        angle = at.interval(mpmath.pi * k / (2 * ARCS), mpmath.pi * (k + 1) / (2 * ARCS))
        size = at.interval(radius, radius)
        yield at.rectangle(size * at.real.cos(angle), size * at.real.sin(angle))


def _squares(at: Intervals, radius: Any, parts: int) -> Iterator[Any]:
    sides = [at.interval(radius * i / parts, radius * (i + 1) / parts) for i in range(parts)]
    for i, j in itertools.product(range(parts), repeat=2):
        if i * i + j * j < parts * parts:
            yield at.rectangle(sides[i], sides[j])
