"""First guess of the angle from ``|v|``, for Newton's method: φ⁻¹ in closed form, or a fitted polynomial."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, Protocol

import mpmath
import sympy

from ...algebra import Coefficient
from ...algebra.arithmetic import PLAIN, Arithmetic
from ..families import alpha
from .closed_inverse import closed_inverse
from .edges import DIGITS, Edge, angle_of, real_value
from .grammar import PhiError
from .lowering import Lowering
from .near_zero import chebyshev_points, interpolated
from .real_constants import Polynomial, plus, polynomial, times

GUESS_DEGREE = 12
"""Degree of a fitted polynomial."""
GUARDED_STEPS = (4, 8, 16, 32)
"""Numbers of guarded steps, tried in this order."""
TOLERANCE = mpmath.mpf(10) ** -30
STEPS_MAX = 7


def _share(x: Coefficient, size: Any, m: Arithmetic) -> Coefficient:
    """Return x divided by a constant."""
    return m.name("share", times(1 / size, x, m, "ratio"))


@dataclass(frozen=True)
class Guess(ABC):
    """Angle near φ⁻¹(r), with the number of Newton steps from it to the root.

    ``edge`` is the edge of the chart as a number.
    """

    edge: Any
    steps: int

    @abstractmethod
    def at(self, x: Any) -> Any:
        """Return the guess at ``x = r²``, an mpmath number."""

    @abstractmethod
    def lowered(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """Return the guess at x and ``r = √x``, in the operations of an arithmetic."""


@dataclass(frozen=True)
class Closed(Guess):
    """Guess by φ⁻¹ in closed form. One Newton step corrects rounding. ``size`` is x at the edge, or infinity."""

    inverse: sympy.Expr
    size: Any

    def at(self, x: Any) -> Any:
        try:
            return real_value(self.inverse, mpmath.sqrt(x), self.inverse)
        except ZeroDivisionError:
            raise PhiError(f"{self.inverse} divides by zero at alpha = {mpmath.nstr(mpmath.sqrt(x), 5)}") from None

    def lowered(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """Return the guess; beyond the edge, where logarithms and roots are undefined, the guess at length 0."""
        if mpmath.isfinite(self.size):
            r = m.name("shorter", m.where(m.less(_share(x, self.size, m), 1), r, r - r))
        return Lowering(r, m).at(self.inverse)


class Variable(Protocol):
    """Variable z of a fit: the angle, or its distance to the edge, is close to a polynomial in z."""

    @property
    def from_edge(self) -> bool:
        """Return whether the angle is ``edge − z G(z)`` instead of ``G(z)``."""

    def of(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """Return z at x and ``r = √x``."""

    def back(self, z: Any) -> Any:
        """Return x from z."""


@dataclass(frozen=True)
class Fold:
    """Variable ``z = √(1 − x/X)``, in which the angle is analytic at a fold."""

    size: Any
    from_edge = True

    def of(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        share = _share(x, self.size, m)
        return m.sqrt(m.where(m.less(share, 1), 1 - share, share))

    def back(self, z: Any) -> Any:
        return self.size * (1 - z * z)


@dataclass(frozen=True)
class Pole:
    """Variable ``z = 1/√(1 + x/S)``, in which the angle is analytic at a pole."""

    size: Any
    from_edge = True

    def of(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        return m.div(1, m.sqrt(1 + _share(x, self.size, m)))

    def back(self, z: Any) -> Any:
        return self.size * (1 / (z * z) - 1)


class Length:
    """Variable ``z = r``, for charts without an edge."""

    from_edge = False

    def of(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        return r

    def back(self, z: Any) -> Any:
        return z * z


class Logarithm:
    """Variable ``z = log(1 + r)``, for a fast-growing φ."""

    from_edge = False

    def of(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        return m.log1p(r)

    def back(self, z: Any) -> Any:
        return mpmath.expm1(z) ** 2


@dataclass(frozen=True)
class Fitted(Guess):
    """Guess by a polynomial G in a variable z."""

    variable: Variable
    polynomial: Polynomial

    def at(self, x: Any) -> Any:
        return self.lowered(x, mpmath.sqrt(x), PLAIN)

    def lowered(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        z = m.name("z", self.variable.of(x, r, m))
        G = self.polynomial.at(z, m, "first")
        return plus(-(z * G), self.edge, m, "fromedge") if self.variable.from_edge else G


@dataclass(frozen=True)
class Guarded(Guess):
    """Guess by Newton's method between bounds, with bisection where a step leaves the bounds."""

    phi: sympy.Expr
    start: Fitted
    count: int

    def at(self, x: Any) -> Any:
        return self.lowered(x, mpmath.sqrt(x), PLAIN)

    def lowered(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        end = plus(r - r, self.edge, m, "end")
        low, high, better = r - r, end, self.start.lowered(x, r, m)
        for step in range(self.count):
            outside = m.either(m.less(better, low), m.less(high, better))
            angle = m.name(f"guarded{step}", m.where(outside, m.div(low + high, 2), better))
            at = Lowering(m.corrected(angle), m)
            miss = m.name(f"miss{step}", at.derivative(self.phi, 0) - r)
            above = m.name(f"above{step}", m.less(0, miss))
            low = m.name(f"low{step}", m.where(above, low, angle))
            high = m.name(f"high{step}", m.where(above, angle, high))
            better = m.name(f"better{step}", angle - m.div(miss, at.derivative(self.phi, 1)))
        return better


def guess(phi: sympy.Expr, edge: Edge, limit: Fraction) -> Guess:
    """Return the first guess for x beyond a limit.

    Raises
    ------
    PhiError
        If no guess leads to the root at every angle.
    """
    with mpmath.workdps(DIGITS):
        end, start = mpmath.mpf(edge.angle.evalf(DIGITS)), mpmath.mpf(limit.numerator) / limit.denominator
        first = angle_of(phi, edge.angle, mpmath.sqrt(start)) * mpmath.mpf("0.98")
        for found in _guesses(phi, edge, first, end):
            try:
                return replace(found, steps=max(found.steps, _steps(phi, edge, found, first)))
            except PhiError as error:
                refused = error
        raise refused


def _guesses(phi: sympy.Expr, edge: Edge, first: Any, end: Any) -> Iterator[Guess]:
    """Yield guesses in the order of trial."""
    size = mpmath.inf if edge.kind == "pole" else _square(phi, end)
    # near a fold √(1 − x/X) determines the angle better than the length does
    if edge.kind != "fold" and (inverse := closed_inverse(phi)) is not None:
        yield Closed(end, 1, inverse.replace(sympy.asinh, _asinh).replace(sympy.atanh, _atanh), size)
    variables: Sequence[Variable] = (Length(), Logarithm())
    if edge.kind != "cut":
        variables = (Fold(size),) if edge.kind == "fold" else (Pole(_square(phi, end / 2)),)
    fitted = [_fitted(phi, edge, variable, first, end) for variable in variables]
    yield from fitted
    yield from (Guarded(end, 1, phi, fitted[0], count) for count in GUARDED_STEPS)


def _asinh(r: sympy.Expr) -> sympy.Expr:
    return sympy.log(r + sympy.sqrt(1 + r**2))


def _atanh(r: sympy.Expr) -> sympy.Expr:
    return sympy.log((1 + r) / (1 - r)) / 2


def _fitted(phi: sympy.Expr, edge: Edge, variable: Variable, first: Any, end: Any) -> Fitted:
    ends = [_value(variable, _square(phi, first)), 0 if variable.from_edge else _value(variable, _square(phi, end))]
    low, high = sorted(map(mpmath.mpf, ends))
    nodes = chebyshev_points(low, high, GUESS_DEGREE + 1)
    angles = [angle_of(phi, edge.angle, mpmath.sqrt(variable.back(z))) for z in nodes]
    values = [(end - a) / z if variable.from_edge else a for z, a in zip(nodes, angles, strict=True)]
    centre, scale = (low + high) / 2, int(mpmath.ceil(mpmath.log((high - low) / 2, 2)))
    middle = Fraction(int(mpmath.nint(centre * 2 ** (4 - scale))), 1) * Fraction(2) ** (scale - 4)
    centre = mpmath.mpf(middle.numerator) / middle.denominator
    coefficients = interpolated([(z - centre) / mpmath.mpf(2) ** scale for z in nodes], values)
    return Fitted(end, 1, variable, polynomial(coefficients, scale, 1, middle))


def _value(variable: Variable, x: Any) -> Any:
    return variable.of(x, mpmath.sqrt(x), PLAIN)


def _square(phi: sympy.Expr, angle: Any) -> Any:
    return real_value(phi, angle, phi) ** 2


def _steps(phi: sympy.Expr, edge: Edge, start: Guess, first: Any) -> int:
    """Return the largest number of Newton steps needed, over many angles up to the edge and near it.

    The tolerance is relative to the distance to the edge; for a cut, to the angle.
    """
    slope, most, end = phi.diff(alpha), 0, start.edge
    shares = [mpmath.mpf(k) / 97 for k in range(97)] + [1 - mpmath.mpf(10) ** -k for k in range(2, 9)]
    for share in shares:
        exact = first + (end - first) * share
        at, r = start.at(_square(phi, exact)), real_value(phi, exact, phi)
        left = exact if edge.kind == "cut" else end - exact
        for step in range(STEPS_MAX + 1):
            if abs(at - exact) <= TOLERANCE * left:
                most = max(most, step)
                break
            if not 0 < at < (2 * end if edge.kind == "cut" else end):
                raise PhiError(f"phi = {phi} is not inverted near alpha = {mpmath.nstr(exact, 5)}: a guess fails")
            at = at - (real_value(phi, at, phi) - r) / real_value(slope, at, phi)
        else:
            raise PhiError(f"phi = {phi} is not inverted near alpha = {mpmath.nstr(exact, 5)} in {STEPS_MAX} steps")
    return most
