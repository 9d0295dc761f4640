"""First guess of the angle from ``|v|``, for Newton's method: φ⁻¹ in closed form, or a fitted polynomial."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import mpmath
import sympy

from ...algebra import Coefficient
from ...algebra.arithmetic import PLAIN, Arithmetic
from ..angle_of_length import angle_of, real_value
from ..families import alpha
from ..phi_error import PhiError
from ..real_constants import Polynomial, plus, polynomial, times
from ..scalars import NOISE
from .edges import PHI_DIGITS, Edge, closed_inverse
from .near_zero import chebyshev_points, interpolated
from .phi_values import PhiValues

GUESS_DEGREE = 12
"""Degree of a fitted polynomial."""
GUARDED_STEPS = (4, 8, 16, 32)
"""Numbers of guarded steps, tried in this order."""
ASINH = sympy.Lambda(alpha, sympy.log(alpha + sympy.sqrt(1 + alpha**2)))
ATANH = sympy.Lambda(alpha, sympy.log((1 + alpha) / (1 - alpha)) / 2)
TOLERANCE = mpmath.mpf(10) ** -30
STEPS_MAX = 7


def _share(x: Coefficient, size: Any, m: Arithmetic) -> Coefficient:
    return m.name("share", times(1 / size, x, m, "ratio"))


def from_end(x: Coefficient, size: Any, m: Arithmetic) -> Coefficient:
    """Return ``√(1 − x/X)``, for X at the end of a chart: 0 there, up to rounding, and NaN beyond."""
    left = m.name("short", 1 - _share(x, size, m))
    noise = m.both(m.less(left, 0), m.equal(NOISE + left, NOISE))
    return m.name("rootshort", m.sqrt(m.where(noise, 0, left)))


@dataclass(frozen=True)
class Guess(ABC):
    """Angle near φ⁻¹(r)."""

    edge: Any  # of the chart, as a number
    size: Any  # x at the edge, or infinity
    steps: int  # of Newton's method from this angle to the root

    def at(self, x: Any) -> Any:
        """Return the guess at ``x = r²``, an mpmath number."""
        return self.lowered(x, mpmath.sqrt(x), PLAIN)

    @abstractmethod
    def lowered(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """Return the guess at x and ``r = √x``, in the operations of an arithmetic."""


@dataclass(frozen=True)
class Closed(Guess):
    """Guess by φ⁻¹ in closed form. One Newton step corrects rounding."""

    inverse: sympy.Expr

    def at(self, x: Any) -> Any:
        try:
            return real_value(self.inverse, mpmath.sqrt(x), self.inverse)
        except ZeroDivisionError:
            raise PhiError(f"{self.inverse} divides by zero at alpha = {mpmath.nstr(mpmath.sqrt(x), 5)}") from None

    def lowered(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        return PhiValues(r, m).at(self.inverse)


@dataclass(frozen=True)
class Variable:
    """Variable z of a fit, for an angle close to a polynomial ``G(z)``, or to ``edge − z G(z)``.

    The function ``of`` returns z at x and ``r = √x``, and ``back`` returns x from z. The flag ``from_edge`` selects
    ``edge − z G(z)``.
    """

    name: str
    of: Callable[[Coefficient, Coefficient, Arithmetic], Coefficient]
    back: Callable[[Any], Any]
    from_edge: bool = False


LENGTH = Variable("Length", lambda x, r, m: r, lambda z: z * z)
"""Variable ``z = r``, for charts without an edge."""

LOGARITHM = Variable("Logarithm", lambda x, r, m: m.log1p(r), lambda z: mpmath.expm1(z) ** 2)
"""Variable ``z = log(1 + r)``, for a fast-growing φ."""


def fold(size: Any) -> Variable:
    """Return the variable ``z = √(1 − x/X)``, for which the angle is analytic at a fold."""
    return Variable("Fold", lambda x, r, m: from_end(x, size, m), lambda z: size * (1 - z * z), True)


def pole(size: Any) -> Variable:
    """Return the variable ``z = 1/√(1 + x/S)``, in which the angle is analytic at a pole."""

    def of(x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        return m.div(1, m.sqrt(1 + _share(x, size, m)))

    return Variable("Pole", of, lambda z: size * (1 / (z * z) - 1), True)


@dataclass(frozen=True)
class Fitted(Guess):
    """Guess by a polynomial G in a variable z."""

    variable: Variable
    polynomial: Polynomial

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

    def lowered(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        end = plus(r - r, self.edge, m, "end")
        low, high, better = r - r, end, self.start.lowered(x, r, m)
        for step in range(self.count):
            outside = m.either(m.less(better, low), m.less(high, better))
            angle = m.name(f"guarded{step}", m.where(outside, m.div(low + high, 2), better))
            at = PhiValues(m.corrected(angle), m)
            miss = m.name(f"miss{step}", at.derivative(self.phi, 0) - r)
            above = m.name(f"above{step}", m.less(0, miss))
            low = m.name(f"low{step}", m.where(above, low, angle))
            high = m.name(f"high{step}", m.where(above, angle, high))
            better = m.name(f"better{step}", angle - m.div(miss, at.derivative(self.phi, 1)))
        return better


def guess(phi: sympy.Expr, edge: Edge, limit: Fraction) -> Guess:
    """Return the first guess for x beyond a limit; `PhiError` if no guess leads to the root at every angle."""
    with mpmath.workdps(PHI_DIGITS):
        end, start = mpmath.mpf(edge.angle.evalf(PHI_DIGITS)), mpmath.mpf(limit.numerator) / limit.denominator
        first = angle_of(phi, edge.angle, mpmath.sqrt(start)) * mpmath.mpf("0.98")
        for found in _guesses(phi, edge, first, end):
            try:
                return replace(found, steps=max(found.steps, _steps(phi, edge, found, first)))
            except PhiError as error:
                refused = error
        raise refused


def _guesses(phi: sympy.Expr, edge: Edge, first: Any, end: Any) -> Iterator[Guess]:
    size = mpmath.inf if edge.kind == "pole" else _square(phi, end)
    # near a fold √(1 − x/X) determines the angle more accurately than the length does
    if edge.kind != "fold" and (inverse := closed_inverse(phi)) is not None:
        yield Closed(end, size, 1, inverse.replace(sympy.asinh, ASINH).replace(sympy.atanh, ATANH))
    variables = [LENGTH, LOGARITHM]
    if edge.kind != "cut":
        variables = [fold(size) if edge.kind == "fold" else pole(_square(phi, end / 2))]
    fitted = [_fitted(phi, edge, variable, first, end) for variable in variables]
    yield from fitted
    yield from (Guarded(end, size, 1, phi, fitted[0], count) for count in GUARDED_STEPS)


def _fitted(phi: sympy.Expr, edge: Edge, variable: Variable, first: Any, end: Any) -> Fitted:
    def value(angle: Any) -> Any:
        r = real_value(phi, angle, phi)
        return variable.of(r**2, mpmath.sqrt(r**2), PLAIN)

    ends = [value(first), 0 if variable.from_edge else value(end)]
    low, high = sorted(map(mpmath.mpf, ends))
    nodes = chebyshev_points(low, high, GUESS_DEGREE + 1)
    angles = [angle_of(phi, edge.angle, mpmath.sqrt(variable.back(z))) for z in nodes]
    values = [(end - a) / z if variable.from_edge else a for z, a in zip(nodes, angles, strict=True)]
    centre, scale = (low + high) / 2, int(mpmath.ceil(mpmath.log((high - low) / 2, 2)))
    middle = Fraction(int(mpmath.nint(centre * 2 ** (4 - scale))), 1) * Fraction(2) ** (scale - 4)
    centre = mpmath.mpf(middle.numerator) / middle.denominator
    coefficients = interpolated([(z - centre) / mpmath.mpf(2) ** scale for z in nodes], values)
    size = mpmath.inf if edge.kind == "pole" else _square(phi, end)
    return Fitted(end, size, 1, variable, polynomial(coefficients, scale, 1, middle))


def _square(phi: sympy.Expr, angle: Any) -> Any:
    return real_value(phi, angle, phi) ** 2


def _steps(phi: sympy.Expr, edge: Edge, start: Guess, first: Any) -> int:
    """Return the largest number of Newton steps needed, over many angles up to the edge and near it.

    The tolerance is relative to the distance to the edge, or to the angle if the edge is a cut.
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
