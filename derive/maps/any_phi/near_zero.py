r"""From |v| back to the angle near v = 0, for any φ: ``a(x) = α/|v|``.

In its place stands a polynomial that interpolates it, with a remainder that is proved, in units of a(0) and of X. On
the circle |α| = R let φ be at least ``√m`` in size, and ``Re φ/(φ′(0) α) > 0``; then (the minimum principle) φ has no
other zero inside, so that for |x| < m just one pair ±α inside has ``φ² = x`` (Rouché): a is analytic there, and at most
``R/√m``. What interpolation at N + 1 Chebyshev points misses on [0, X] is then at most ``4 R/√m ρ^(−N)/(ρ − 1)``, with
the ellipse of foci 0 and X and sum ρ of half axes (over half their distance) inside |x| < m. Sizes on the circle are
those of `intervals`.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import mpmath
import sympy

from ..families import alpha
from .edges import DIGITS, Edge, angle_of
from .elementary import evaluate
from .grammar import PhiError
from .intervals import is_analytic, smallest
from .real_constants import Polynomial, polynomial

NEAR = mpmath.mpf("1.3")
"""The angle up to which a(x) is interpolated, or a fifth of the edge if that is less."""
RADII = [mpmath.mpf(k) / 2 for k in range(16, 2, -1)] + [mpmath.mpf(k) / 16 for k in range(22, 2, -2)]
SHARES = (1, 2, 4, 8, 16)
"""Of that angle: the first for which a remainder can be proved is taken."""
GOAL = mpmath.mpf(10) ** -21
SIZES = mpmath.mpf(2) ** -22, mpmath.mpf(2) ** 18
"""Between these is the square of a length, that a limit is made of."""
DEGREES = range(8, 40)
DERIVATIVES = 3


@dataclass(frozen=True)
class Ratio:
    """a(x) and three derivatives below a limit as polynomials.

    ``remainder`` is what they are off by at most, in units of a(0), and of x the limit.
    """

    polynomials: tuple[Polynomial, ...]
    limit: Fraction
    remainder: float


def ratio(phi: sympy.Expr, edge: Edge) -> Ratio:
    """Interpolate α/|v| near 0.

    Raises
    ------
    PhiError
        If no circle proves that it is analytic.
    """
    for share in SHARES:
        try:
            return _ratio(phi, edge, NEAR / share)
        except PhiError as error:
            refused = error
    raise refused


def _ratio(phi: sympy.Expr, edge: Edge, near: Any) -> Ratio:
    with mpmath.workdps(DIGITS):
        end, slope = mpmath.mpf(edge.angle.evalf(DIGITS)), mpmath.mpf(evaluate(phi.diff(alpha), alpha, mpmath.mpf(0)))
        limit = _rounded_down(phi, mpmath.mpf(evaluate(phi, alpha, min(near, end / 5))) ** 2)
        X = mpmath.mpf(limit.numerator) / limit.denominator
        bound, within = _circle(phi, X)
        half_sum = (within - X / 2) / (X / 4)  # ρ + 1/ρ of the ellipse whose half axis reaches from X/2 to m
        rho = half_sum / 2 + mpmath.sqrt(half_sum**2 / 4 - 1)
        degree = next((n for n in DEGREES if _missed(bound * slope, rho, n) < GOAL), None)
        if degree is None:
            raise PhiError(f"phi = {phi} would need a polynomial of degree above {DEGREES[-1]} near 0")
        coefficients = _interpolated(phi, edge, X, degree)
        scale = int(mpmath.ceil(mpmath.log(X, 2)))
        found = []
        for _ in range(DERIVATIVES + 1):
            found.append(polynomial([c * mpmath.mpf(2) ** (scale * k) for k, c in enumerate(coefficients)], scale))
            coefficients = [k * c for k, c in enumerate(coefficients)][1:]
        rounding = max(split.rounding * X**count for count, split in enumerate(found)) * slope
        return Ratio(tuple(found), limit, float(_missed(bound * slope, rho, degree) + rounding))


def _rounded_down(phi: sympy.Expr, size: Any) -> Fraction:
    """To a 64th, of what is small to a quarter at most: a fraction of small integers."""
    if not SIZES[0] < size < SIZES[1]:
        few = "small" if size < 1 else "large"
        raise PhiError(f"phi = {phi} is too {few} near 0, {mpmath.nstr(mpmath.sqrt(size), 3)}: take a multiple of it")
    denominator = max(64, 2 ** int(mpmath.ceil(mpmath.log(4 / size, 2))))
    return Fraction(int(size * denominator), denominator)


def _missed(bound: Any, rho: Any, degree: int) -> Any:
    """By the polynomial and its first three derivatives on [0, 1]: Cauchy's estimate on the best ellipse between."""
    found = []
    for share in range(1, 16):
        inner = rho ** (mpmath.mpf(share) / 16)
        apart = (inner + 1 / inner - 2) / 4  # of the interval from that ellipse
        found.append(4 * bound * (inner / rho) ** degree / (rho / inner - 1) * 6 * max(1, apart**-3))
    return max(4 * bound * rho**-degree / (rho - 1), min(found))


def _interpolated(phi: sympy.Expr, edge: Edge, X: Any, degree: int) -> list[Any]:
    nodes = [X / 2 * (1 + mpmath.cospi((mpmath.mpf(k) + mpmath.mpf(1) / 2) / (degree + 1))) for k in range(degree + 1)]
    values = [angle_of(phi, edge.angle, mpmath.sqrt(x)) / mpmath.sqrt(x) for x in nodes]
    matrix = mpmath.matrix(degree + 1, degree + 1)
    for i, x in enumerate(nodes):
        for k in range(degree + 1):
            matrix[i, k] = (x / X) ** k
    solved = mpmath.lu_solve(matrix, mpmath.matrix(values))
    return [solved[k] / X**k for k in range(degree + 1)]


def _circle(phi: sympy.Expr, X: Any) -> tuple[Any, Any]:
    """The bound of a, and the m within which it is analytic: of all circles that serve, that of the largest m."""
    found = [(least, radius) for radius in RADII if (least := smallest(phi, radius)) is not None]
    for least, radius in sorted(found, key=lambda pair: -pair[0]):
        if least**2 > 2 * X and is_analytic(phi, radius):
            return radius / least, least**2
    raise PhiError(f"nothing proves that the inverse of phi = {phi} is analytic near 0")
