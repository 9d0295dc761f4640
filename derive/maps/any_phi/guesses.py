"""Guesses of the angle of a length ``|v|``, each followed by Newton's steps: φ⁻¹ in closed form, a fit, or halvings.

A guess bounds its error on intervals of angles; `first_guess` proves the numbers of steps and halvings.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import mpmath
import sympy

from ...algebra import Coefficient
from ...algebra.arithmetic import PLAIN, Arithmetic
from ..angle import real_value
from ..elementary import alpha, elementary
from ..real_constants import NOISE, Polynomial, plus, times
from .intervals import Intervals
from .phi_values import PhiValues


def _share(x: Coefficient, size: Any, m: Arithmetic) -> Coefficient:
    return m.name("share", times(1 / size, x, m, "ratio"))


def from_end(x: Coefficient, size: Any, m: Arithmetic) -> Coefficient:
    """Return ``√(1 − x/X)``, for X at the end of a chart: 0 there, up to rounding, and NaN beyond."""
    left = m.name("lack", 1 - _share(x, size, m))
    noise = m.both(m.less(left, 0), m.equal(m.beside(NOISE, left), NOISE))
    return m.name("rootlack", m.sqrt(m.where(noise, 0, left)))


@dataclass(frozen=True)
class Guess(ABC):
    """Angle near φ⁻¹(r), and the number of steps of Newton's method from there."""

    phi: sympy.Expr
    edge: Any  # of the chart, as a number
    size: Any  # x at the edge, or infinity
    steps: int

    @property
    def to_edge(self) -> bool:
        return bool(mpmath.isinf(self.size))

    @abstractmethod
    def lowered(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """Return the guess at x, with ``r = √x``, by the operations of a given arithmetic."""

    def solved(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """Return the angle at x and ``r = √x``."""
        angle = m.name("guess", self.lowered(x, r, m))
        for step in range(self.steps):
            at = PhiValues(m.corrected(angle), m)
            change = m.name(f"change{step}", m.div(at.derivative(self.phi, 0) - r, at.derivative(self.phi, 1)))
            if self.to_edge:  # beside a fold or pole, rounding makes a step that is longer than the way to the edge
                left = m.name(f"left{step}", -plus(angle, -self.edge, m, f"before{step}"))
                change = m.where(m.less(m.abs(change), left), change, 0)
            angle = m.name(f"alpha{step}", angle - change)
        return angle

    def error(self, at: Intervals, low: Any, high: Any) -> Any:
        """Return a bound of the error of the guess for angles of an interval."""
        return mpmath.mpf(0)


@dataclass(frozen=True)
class Closed(Guess):
    """Guess by φ⁻¹ in closed form. One Newton step corrects rounding."""

    inverse: sympy.Expr

    def lowered(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        return PhiValues(r, m).at(self.inverse)


@dataclass(frozen=True)
class Variable:
    """Variable z of a fit, for an angle close to a polynomial ``G(z)``, or to ``edge − z G(z)``.

    The function ``of`` returns z at x and ``r = √x``, and ``back`` returns x from z. The function ``rise`` returns
    dz/dr from r and z, also of intervals. The flag ``from_edge`` selects ``edge − z G(z)``.
    """

    name: str
    of: Callable[[Coefficient, Coefficient, Arithmetic], Coefficient]
    back: Callable[[Any], Any]
    rise: Callable[[Any, Any], Any]
    from_edge: bool = False


LENGTH = Variable("Length", lambda x, r, m: r, lambda z: z * z, lambda r, z: 1 + 0 * r)
"""Variable ``z = r``, for charts without an edge."""

LOGARITHM = Variable("Logarithm", lambda x, r, m: m.log1p(r), lambda z: mpmath.expm1(z) ** 2, lambda r, z: 1 / (1 + r))
"""Variable ``z = log(1 + r)``, for a fast-growing φ."""


def fold(size: Any, order: sympy.Rational) -> Variable:
    """Return the variable ``z = (1 − x/X)^(1/(order + 1))``, for which the angle is analytic at a fold."""
    count = int(order) + 1
    return Variable(
        "Fold",
        lambda x, r, m: PhiValues(from_end(x, size, m), m).at(alpha ** sympy.Rational(2, count)),
        lambda z: size * (1 - z**count),
        lambda r, z: -r / z ** (count - 1) * (mpmath.mpf(2) / (count * size)),
        True,
    )


def pole(length: Any, order: sympy.Rational) -> Variable:
    """Return the variable ``z = (1 + r/S)^(−1/order)``, in which the angle is analytic at a pole and at 0."""

    def of(x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        share = m.name("share", times(1 / length, r, m, "ratio"))
        return PhiValues(1 + share, m).at(alpha ** (-1 / order))

    power = mpmath.mpf(order.p) / order.q
    return Variable(
        "Pole", of, lambda z: (length * (z**-power - 1)) ** 2, lambda r, z: -z / (r + length) * (1 / power), True
    )


@dataclass(frozen=True)
class Fitted(Guess):
    """Guess by a polynomial G in a variable z."""

    variable: Variable
    polynomial: Polynomial

    @property
    def to_edge(self) -> bool:
        return self.variable.from_edge

    def lowered(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        z = m.name("z", self.variable.of(x, r, m))
        G = self.polynomial.at(z, m, "first")
        return plus(-(z * G), self.edge, m, "fromedge") if self.variable.from_edge else G

    def error(self, at: Intervals, low: Any, high: Any) -> Any:
        """Return a bound of the error: of the guess at the middle, and by the mean value theorem beside it."""
        middle, whole = (low + high) / 2, at.interval(low, high)
        (_, z), *ends = map(self._place, (middle, low, high))
        off = max(abs(end - z) for _, end in ends)
        g, steep, bend = self._guess(z, off)
        slope = at.interval(steep - off * bend, steep + off * bend)
        rates = slope * self.variable.rise(*(at.interval(*sorted(pair)) for pair in zip(*ends, strict=True)))
        drift = at.size(rates * at.enclosure(derivatives(self.phi)[0], whole) - 1)[1]
        return abs(g - middle) + (high - low) / 2 * drift

    @cached_property
    def _places(self) -> dict[Any, tuple[Any, Any]]:
        """Cache of `_place`: an interval shares its ends with its neighbours, and its middle with its halves."""
        return {}

    def _place(self, angle: Any) -> tuple[Any, Any]:
        if angle not in self._places:
            r = real_value(self.phi, angle, self.phi)
            self._places[angle] = r, self.variable.of(r * r, r, PLAIN)
        return self._places[angle]

    def _guess(self, z: Any, off: Any) -> tuple[Any, Any, Any]:
        """Return the guess at z, its derivative there, and a bound of its second derivative not further than off."""
        unit = mpmath.ldexp(1, self.polynomial.scale)
        t = (z - mpmath.mpf(self.polynomial.centre.numerator) / self.polynomial.centre.denominator) / unit
        c = self.polynomial.coefficients
        G, steep = mpmath.polyval(c[::-1], t, derivative=True)
        first, second = ([abs(math.perm(k, d) * a) for k, a in enumerate(c)][:d - 1 : -1] for d in (1, 2))
        bends = [mpmath.polyval(of, abs(t) + off / unit) / unit**d for d, of in ((1, first), (2, second))]
        if not self.variable.from_edge:
            return G, steep / unit, bends[1]
        return self.edge - z * G, -G - z * steep / unit, 2 * bends[0] + (abs(z) + off) * bends[1]


@dataclass(frozen=True)
class Halved(Guess):
    """Guess by halving a bracket. Newton's steps on f, for ``f = target(r)``, may not leave the last bracket by far.

    For a pole of order k, f is ``φ^(−1/k)``, which is analytic at the pole; otherwise it is φ.
    """

    f: sympy.Expr
    order: sympy.Rational | None  # of the pole
    count: int

    @cached_property
    def bends(self) -> tuple[sympy.Expr, ...]:
        """Expression of ``f″/f′`` by φ, which intervals bound well except near the pole."""
        slope, bend = derivatives(self.phi)
        return (bend / slope - (1 + 1 / self.order) * slope / self.phi,) if self.order else ()

    def _target(self, r: Coefficient, m: Arithmetic) -> Coefficient:
        return PhiValues(r, m).at(alpha if self.order is None else alpha ** (-1 / self.order))

    def lowered(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        target, low = m.name("target", self._target(r, m)), r - r
        high = plus(r - r, self.edge, m, "end")
        for step in range(self.count):
            middle = m.name(f"middle{step}", m.div(low + high, 2))
            at = PhiValues(m.corrected(middle), m).at(self.f)
            above = m.name(f"above{step}", m.less(at, target) if self.order else m.less(target, at))
            low = m.name(f"low{step}", m.where(above, low, middle))
            high = m.name(f"high{step}", m.where(above, middle, high))
        return m.div(low + high, 2)

    def solved(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        start = angle = m.name("guess", self.lowered(x, r, m))
        target, width = m.name("aim", self._target(r, m)), self.edge / 2**self.count
        for step in range(self.steps):
            at = PhiValues(m.corrected(angle), m)
            better = m.name(f"better{step}", angle - m.div(at.at(self.f) - target, at.derivative(self.f, 1)))
            off = m.abs(times(1 / width, better - start, m, f"off{step}"))
            angle = m.name(f"alpha{step}", m.where(m.less(off, 1), better, angle))
        return angle

    def error(self, at: Intervals, low: Any, high: Any) -> Any:
        return self.edge / 2 ** (self.count + 1)


@lru_cache(maxsize=64)
def derivatives(f: sympy.Expr) -> tuple[sympy.Expr, sympy.Expr]:
    """Return the first and the second derivative by α, in elementary functions."""
    return elementary(f).diff(alpha), elementary(f).diff(alpha, 2)
