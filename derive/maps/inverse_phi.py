r"""From |v| back to the angle, for any φ: where φ ends, ``a(x) = α/|v|`` near v = 0, and a first guess beyond.

Near 0 ``a`` is a polynomial that interpolates it, with a remainder that is proved. On the circle |α| = R let φ be at
least ``√m`` in size, and ``Re φ/(φ′(0) α) > 0``; then (the minimum principle) φ has no other zero inside, so that for
|x| < m just one pair ±α inside has ``φ² = x`` (Rouché): a is analytic there, and at most ``R/√m``. What interpolation
at N + 1 Chebyshev points misses on [0, X] is then at most ``4 R/√m ρ^(−N)/(ρ − 1)``, with the ellipse of foci 0 and X
and sum ρ of half axes (over half their distance) inside |x| < m. Sizes on the circle are taken by interval arithmetic
on small arcs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import mpmath
import sympy

from .expressions import PhiError
from .families import alpha, evaluate
from .split import Polynomial, polynomial

DIGITS = 60
FURTHEST = 4
"""Where a chart without an edge is cut, in units of π."""
GRID = 2000
NEAR = mpmath.mpf("1.3")
"""The angle up to which a(x) is interpolated, or a fifth of the edge if that is less."""
ARCS = 128
RADII = [mpmath.mpf(k) / 2 for k in range(16, 2, -1)]
GOAL = mpmath.mpf(10) ** -21
DEGREES = range(8, 40)
DERIVATIVES = 3
NOT_INTERVALS = "interval arithmetic does not know it"


@dataclass(frozen=True)
class Edge:
    """Where φ ends: at φ′ = 0 (a fold), at a pole, or cut at 4π."""

    angle: sympy.Expr
    kind: str


def edge_of(phi: sympy.Expr) -> Edge:
    """The first φ′ = 0 or pole of φ.

    Raises
    ------
    PhiError
        If φ does not increase from 0, or is no real number.
    """
    slope = phi.diff(alpha)
    with mpmath.workdps(DIGITS):
        step = FURTHEST * mpmath.pi / GRID
        before = _real(slope, mpmath.mpf(0), phi)
        if not before > 0:
            raise PhiError(f"phi'(0) = {mpmath.nstr(before, 5)}, and has to be positive")
        for k in range(1, GRID + 1):
            try:
                now, size = _real(slope, k * step, phi), _real(phi, k * step, phi)
            except (PhiError, ZeroDivisionError):
                return _pole(phi, (k - 1) * step, k * step)
            if now <= 0 or size <= 0:
                jumped = now > 10 * before or size <= 0
                return _pole(phi, (k - 1) * step, k * step) if jumped else _fold(phi, slope, (k - 1) * step, k * step)
            before = now
    return Edge(FURTHEST * sympy.pi, "cut")


def _real(expression: sympy.Expr, at: Any, phi: sympy.Expr) -> Any:
    value = evaluate(expression, alpha, at)
    if isinstance(value, mpmath.mpc):
        if value.imag != 0:
            raise PhiError(f"phi = {phi} is no real number at alpha = {mpmath.nstr(at, 5)}")
        value = value.real
    return mpmath.mpf(value)


def _fold(phi: sympy.Expr, slope: sympy.Expr, low: Any, high: Any) -> Edge:
    root = mpmath.findroot(lambda a: _real(slope, a, phi), (low, high), solver="anderson", tol=mpmath.mpf(10) ** -50)
    return Edge(_named(root), "fold")


def _pole(phi: sympy.Expr, low: Any, high: Any) -> Edge:
    """Where 1/φ changes sign, or φ stops being real."""

    def inside(at: Any) -> bool:
        try:
            return bool(_real(phi, at, phi) > 0)
        except (PhiError, ZeroDivisionError):
            return False

    for _ in range(220):
        middle = (low + high) / 2
        low, high = (middle, high) if inside(middle) else (low, middle)
    if not _real(phi, low, phi) > 10**6:
        where = f"beyond alpha = {mpmath.nstr(low, 6)}, where it neither turns nor goes to infinity"
        raise PhiError(f"phi = {phi} is no real number {where}")
    return Edge(_named(low), "pole")


def _named(root: Any) -> sympy.Expr:
    """A multiple of π or the root of a fraction, where it is one to 40 digits; else a decimal."""
    for value, make in ((root / mpmath.pi, lambda q: q * sympy.pi), (root**2, sympy.sqrt)):
        near = Fraction(int(mpmath.nint(value * 5040)), 5040)
        if abs(value - mpmath.mpf(near.numerator) / near.denominator) < mpmath.mpf(10) ** -40:
            return make(sympy.Rational(near.numerator, near.denominator))
    return sympy.Float(mpmath.nstr(root, 50), 50)


def _end(phi: sympy.Expr, edge: Edge, size: Any) -> Any:
    """The edge, or an angle beyond that of a length."""
    if not edge.angle.is_infinite:
        return mpmath.mpf(edge.angle.evalf(mpmath.mp.dps + 5))
    high = mpmath.mpf(1)
    while _real(phi, high, phi) <= size:
        high = 2 * high
    return high


def angle_of(phi: sympy.Expr, edge: Edge, size: Any) -> Any:
    """φ⁻¹ by Newton's method between bounds, in the working precision."""
    slope = phi.diff(alpha)
    low, high = mpmath.mpf(0), _end(phi, edge, size)
    guess = min(size / evaluate(slope, alpha, low), high / 2)
    for _ in range(8 * mpmath.mp.prec):
        miss = _real(phi, guess, phi) - size
        low, high = (low, guess) if miss > 0 else (guess, high)
        better = guess - miss / _real(slope, guess, phi)
        if not low <= better <= high:
            better = (low + high) / 2
        guess, step = better, abs(better - guess)
        if step <= 8 * mpmath.eps * better:
            break
    return guess


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
        found = _smallest(phi, radius)
        if found is not None and found**2 > 2 * X and (best is None or found**2 > best[1]):
            best = radius / found, found**2
    if best is None:
        raise PhiError(f"nothing proves that the inverse of phi = {phi} is analytic near 0")
    return best


def _smallest(phi: sympy.Expr, radius: Any) -> Any:
    """The least |φ| on a quarter of a circle, rounded down; None where nothing is proved of it."""
    with mpmath.workdps(DIGITS):
        slope = mpmath.mpf(evaluate(phi.diff(alpha), alpha, mpmath.mpf(0)))
    least = mpmath.inf
    try:
        for box in _cells(radius):
            _interval(phi, box)
        for box in _arcs(radius):
            value = _interval(phi, box)
            if not (value / box / slope).real > 0:
                return None
            least = min(least, mpmath.mpf(abs(value).a))
    except (ZeroDivisionError, ValueError, TypeError):
        return None
    return least if least > 0 and mpmath.isfinite(least) else None


def _arcs(radius: Any) -> Iterator[Any]:
    iv = mpmath.iv
    for k in range(ARCS):
        angle = iv.mpf([k, k + 1]) * iv.pi / (2 * ARCS)
        yield iv.mpc(iv.mpf(radius) * iv.cos(angle), iv.mpf(radius) * iv.sin(angle))


def _cells(radius: Any, parts: int = 12) -> Iterator[Any]:
    """Squares that cover a quarter of the disc: φ is analytic in each, or an error."""
    iv = mpmath.iv
    side = iv.mpf(radius) / parts
    for i in range(parts):
        for j in range(parts):
            if i * i + j * j < parts * parts:
                yield iv.mpc(side * iv.mpf([i, i + 1]), side * iv.mpf([j, j + 1]))


def _interval(e: sympy.Expr, z: Any) -> Any:
    """An expression on a complex interval; ValueError where a branch cut or a pole may be met."""
    iv = mpmath.iv
    if e == alpha:
        return z
    if not e.free_symbols:
        with mpmath.workdps(DIGITS):
            value = mpmath.mpf(e.evalf(DIGITS))
        off = abs(value) * mpmath.mpf(2) ** -45
        return iv.mpf([value - off, value + off])
    arguments = [_interval(a, z) for a in e.args if not (e.is_Pow and a == e.exp)]
    if e.is_Add or e.is_Mul:
        first, *rest = arguments
        for other in rest:
            first = first + other if e.is_Add else first * other
        return first
    if e.is_Pow and e.exp.is_Integer:
        power = arguments[0]
        for _ in range(abs(int(e.exp)) - 1):
            power = power * arguments[0]
        return power if e.exp > 0 else 1 / _away(power)
    if e.is_Pow and e.exp.is_Rational:
        return iv.exp(_log(arguments[0]) * int(e.exp.p) / int(e.exp.q))
    return _functions()[e.func](_complex(arguments[0]))


def _functions() -> dict[Any, Callable[[Any], Any]]:
    iv = mpmath.iv
    i = iv.mpc(0, 1)
    return {
        sympy.sin: iv.sin, sympy.cos: iv.cos, sympy.exp: iv.exp, sympy.log: _log,
        sympy.tan: lambda a: iv.sin(a) / _away(iv.cos(a)),
        sympy.sinh: lambda a: (iv.exp(a) - iv.exp(-a)) / 2,
        sympy.cosh: lambda a: (iv.exp(a) + iv.exp(-a)) / 2,
        sympy.tanh: lambda a: (iv.exp(a) - iv.exp(-a)) / _away(iv.exp(a) + iv.exp(-a)),
        sympy.asin: lambda a: -i * _log(i * a + iv.exp(_log(1 - a * a) / 2)),
        sympy.acos: lambda a: iv.pi / 2 + i * _log(i * a + iv.exp(_log(1 - a * a) / 2)),
        sympy.atan: lambda a: i / 2 * (_log(1 - i * a) - _log(1 + i * a)),
    }  # fmt: skip


def _away(value: Any) -> Any:
    """The value, which has to be no zero."""
    if not abs(value).a > 0:
        raise ValueError(NOT_INTERVALS)
    return value


def _log(value: Any) -> Any:
    """The principal logarithm, of what has a positive real part."""
    if not _complex(value).real.a > 0:
        raise ValueError(NOT_INTERVALS)
    return mpmath.iv.log(_complex(value))


def _complex(value: Any) -> Any:
    return value if hasattr(value, "_mpci_") else mpmath.iv.mpc(value)


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
    return _real(phi, angle, phi) ** 2


def _steps(phi: sympy.Expr, edge: Edge, start: Guess, first: Any, end: Any) -> int:
    """The most that are needed at many angles up to the edge, and near it, to a share of what is left to it."""
    slope, most = phi.diff(alpha), 0
    shares = [mpmath.mpf(k) / 97 for k in range(97)] + [1 - mpmath.mpf(10) ** -k for k in range(2, 9)]
    for share in shares:
        exact = first + (end - first) * share
        at, r = start.at(_square(phi, exact)), _real(phi, exact, phi)
        left = exact if edge.kind == "cut" else end - exact
        for step in range(MOST_STEPS + 1):
            if abs(at - exact) <= CONVERGED * left:
                most = max(most, step)
                break
            if not 0 < at < (2 * end if edge.kind == "cut" else end):
                raise PhiError(f"phi = {phi} is not inverted near alpha = {mpmath.nstr(exact, 5)}: a guess fails")
            at = at - (_real(phi, at, phi) - r) / _real(slope, at, phi)
        else:
            raise PhiError(f"phi = {phi} is not inverted near alpha = {mpmath.nstr(exact, 5)} in {MOST_STEPS} steps")
    return most
