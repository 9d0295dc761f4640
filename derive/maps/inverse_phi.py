r"""From |v| back to the angle, for any φ: ``a(x) = α/|v|`` near v = 0, and a first guess beyond.

Near 0 ``a`` is a polynomial that interpolates it, with a remainder that is proved. On the circle |α| = R let φ be at
least ``√m`` in size, and ``Re φ/(φ′(0) α) > 0``; then (the minimum principle) φ has no other zero inside, so that for
|x| < m just one pair ±α inside has ``φ² = x`` (Rouché): a is analytic there, and at most ``R/√m``. What interpolation
at N + 1 Chebyshev points misses on [0, X] is then at most ``4 R/√m ρ^(−N)/(ρ − 1)``, with the ellipse of foci 0 and X
and sum ρ of half axes (over half their distance) inside |x| < m. Sizes on the circle are those of `intervals`.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import mpmath
import sympy

from .edges import DIGITS, Edge, angle_of, real_value
from .expressions import PhiError
from .families import alpha, evaluate
from .intervals import smallest
from .split import Polynomial, polynomial

NEAR = mpmath.mpf("1.3")
"""The angle up to which a(x) is interpolated, or a fifth of the edge if that is less."""
RADII = [mpmath.mpf(k) / 2 for k in range(16, 2, -1)]
GOAL = mpmath.mpf(10) ** -21
DEGREES = range(8, 40)
DERIVATIVES = 3


# --- near 0 ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Ratio:
    """a(x) and three derivatives below a limit as polynomials, and what they are off by at most."""

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
    for share in (1, 2, 4):
        try:
            return _ratio(phi, edge, NEAR / share)
        except PhiError as error:
            refused = error
    raise refused


def _ratio(phi: sympy.Expr, edge: Edge, near: Any) -> Ratio:
    with mpmath.workdps(DIGITS):
        end = mpmath.mpf(edge.angle.evalf(DIGITS))
        size = mpmath.mpf(evaluate(phi, alpha, min(near, end / 5))) ** 2
        limit = Fraction(int(size * 64) or 1, 64)
        X = mpmath.mpf(limit.numerator) / limit.denominator
        bound, within = _circle(phi, X)
        half_sum = (within - X / 2) / (X / 4)  # ρ + 1/ρ of the ellipse whose half axis reaches from X/2 to m
        rho = half_sum / 2 + mpmath.sqrt(half_sum**2 / 4 - 1)
        degree = next((n for n in DEGREES if _missed(bound, rho, n, X) < GOAL), None)
        if degree is None:
            raise PhiError(f"phi = {phi} would need a polynomial of degree above {DEGREES[-1]} near 0")
        coefficients = _interpolated(phi, edge, X, degree)
        scale = int(mpmath.ceil(mpmath.log(X, 2)))
        found = []
        for _ in range(DERIVATIVES + 1):
            found.append(polynomial([c * mpmath.mpf(2) ** (scale * k) for k, c in enumerate(coefficients)], scale))
            coefficients = [k * c for k, c in enumerate(coefficients)][1:]
        off = _missed(bound, rho, degree, X) + max(split.rounding for split in found)
        return Ratio(tuple(found), limit, float(off))


def _missed(bound: Any, rho: Any, degree: int, X: Any) -> Any:
    """By the polynomial and its first three derivatives on [0, X]: Cauchy's estimate on the best ellipse between."""
    found = []
    for share in range(1, 16):
        inner = rho ** (mpmath.mpf(share) / 16)
        apart = X / 4 * (inner + 1 / inner - 2)  # of the interval from that ellipse
        found.append(4 * bound * (inner / rho) ** degree / (rho / inner - 1) * 6 * max(1, apart**-3))
    return max(4 * bound * rho**-degree / (rho - 1), min(found))


def _interpolated(phi: sympy.Expr, edge: Edge, X: Any, degree: int) -> list[Any]:
    nodes = [X / 2 * (1 + mpmath.cospi((mpmath.mpf(k) + mpmath.mpf(1) / 2) / (degree + 1))) for k in range(degree + 1)]
    values = [angle_of(phi, edge, mpmath.sqrt(x)) / mpmath.sqrt(x) for x in nodes]
    matrix = mpmath.matrix(degree + 1, degree + 1)
    for i, x in enumerate(nodes):
        for k in range(degree + 1):
            matrix[i, k] = (x / X) ** k
    solved = mpmath.lu_solve(matrix, mpmath.matrix(values))
    return [solved[k] / X**k for k in range(degree + 1)]


def _circle(phi: sympy.Expr, X: Any) -> tuple[Any, Any]:
    """The bound of a, and the m within which it is analytic: of all circles that serve, that of the largest m."""
    best: tuple[Any, Any] | None = None
    for radius in RADII:
        found = smallest(phi, radius)
        if found is not None and found**2 > 2 * X and (best is None or found**2 > best[1]):
            best = radius / found, found**2
    if best is None:
        raise PhiError(f"nothing proves that the inverse of phi = {phi} is analytic near 0")
    return best


# --- beyond ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Guess:
    """An angle near φ⁻¹(r), ``e − z G(z)`` or ``G(r)``, and how many of Newton's steps lead from it to the root.

    At a fold ``z = √(1 − x/X)``, at a pole ``z = 1/√(1 + x/S)``: functions of which the angle is analytic at the edge.
    """

    kind: str
    polynomial: Polynomial
    size: Any
    edge: Any
    steps: int

    def at(self, x: Any) -> Any:
        """The guess at a number of mpmath."""
        if self.kind == "cut":
            return self.polynomial.value(mpmath.sqrt(x))
        z = self.variable(x)
        return self.edge - z * self.polynomial.value(z)

    def variable(self, x: Any) -> Any:
        return _variable(self.kind, self.size, x)


def _variable(kind: str, size: Any, x: Any) -> Any:
    if kind == "fold":
        return mpmath.sqrt(max(1 - x / size, 0))
    return 1 / mpmath.sqrt(1 + x / size) if kind == "pole" else mpmath.sqrt(x)


def _back(kind: str, size: Any, z: Any) -> Any:
    """The x of a variable."""
    if kind == "fold":
        return size * (1 - z * z)
    return size * (1 / (z * z) - 1) if kind == "pole" else z * z


FIT = 12
"""The degree of a first guess."""
CONVERGED = mpmath.mpf(10) ** -30
MOST_STEPS = 7


def guess(phi: sympy.Expr, edge: Edge, limit: Fraction) -> Guess:
    """Fit a first guess beyond a limit of x.

    Raises
    ------
    PhiError
        If Newton's method does not lead from it to the root everywhere.
    """
    with mpmath.workdps(DIGITS):
        end, start = mpmath.mpf(edge.angle.evalf(DIGITS)), mpmath.mpf(limit.numerator) / limit.denominator
        first = angle_of(phi, edge, mpmath.sqrt(start)) * mpmath.mpf("0.98")
        kind, size = edge.kind, _size(phi, edge, end)
        count = FIT + 1
        ends = [_variable(kind, size, _square(phi, a)) for a in (first, end if kind == "cut" else first)]
        low, high = (min(ends), max(ends)) if kind == "cut" else (mpmath.mpf(0), ends[0])
        shares = [(1 + mpmath.cospi((mpmath.mpf(k) + mpmath.mpf(1) / 2) / count)) / 2 for k in range(count)]
        nodes = [low + (high - low) * share for share in shares]
        angles = [angle_of(phi, edge, mpmath.sqrt(_back(kind, size, z))) for z in nodes]
        values = [a if kind == "cut" else (end - a) / z for z, a in zip(nodes, angles, strict=True)]
        matrix = mpmath.matrix(count, count)
        centre, scale = (low + high) / 2, int(mpmath.ceil(mpmath.log((high - low) / 2, 2)))
        middle = Fraction(int(mpmath.nint(centre * 2 ** (4 - scale))), 1) * Fraction(2) ** (scale - 4)
        centre = mpmath.mpf(middle.numerator) / middle.denominator
        for i, z in enumerate(nodes):
            for k in range(count):
                matrix[i, k] = ((z - centre) / mpmath.mpf(2) ** scale) ** k
        solved = mpmath.lu_solve(matrix, mpmath.matrix(values))
        fitted = polynomial(list(solved), scale, 1, middle)
        found = Guess(kind, fitted, size, end, 0)
        return Guess(kind, fitted, size, end, _steps(phi, edge, found, first, end))


def _size(phi: sympy.Expr, edge: Edge, end: Any) -> Any:
    """X of a fold, S of a pole."""
    if edge.kind == "fold":
        return _square(phi, end)
    return _square(phi, end / 2) if edge.kind == "pole" else mpmath.mpf(1)


def _square(phi: sympy.Expr, angle: Any) -> Any:
    return real_value(phi, angle, phi) ** 2


def _steps(phi: sympy.Expr, edge: Edge, start: Guess, first: Any, end: Any) -> int:
    """The most that are needed at many angles up to the edge, and near it, to a share of what is left to it."""
    slope, most = phi.diff(alpha), 0
    shares = [mpmath.mpf(k) / 97 for k in range(97)] + [1 - mpmath.mpf(10) ** -k for k in range(2, 9)]
    for share in shares:
        exact = first + (end - first) * share
        at, r = start.at(_square(phi, exact)), real_value(phi, exact, phi)
        left = exact if edge.kind == "cut" else end - exact
        for step in range(MOST_STEPS + 1):
            if abs(at - exact) <= CONVERGED * left:
                most = max(most, step)
                break
            if not 0 < at < (2 * end if edge.kind == "cut" else end):
                raise PhiError(f"phi = {phi} is not inverted near alpha = {mpmath.nstr(exact, 5)}: a guess fails")
            at = at - (real_value(phi, at, phi) - r) / real_value(slope, at, phi)
        else:
            raise PhiError(f"phi = {phi} is not inverted near alpha = {mpmath.nstr(exact, 5)} in {MOST_STEPS} steps")
    return most
