"""Angle of a length ``|v|`` beyond the range of `near_zero`, by a proved number of Newton's steps from a guess.

A guess is φ⁻¹ in closed form, a fitted polynomial, or the middle of a bracket after a proved number of halvings. Let e
bound the error of a guess on an interval of angles. If ``K = max |φ″|/(2 min φ′)`` on this interval widened by e, the
error after a step is at most ``K e²``. Intervals up to the edge, and bounds of φ′ and φ″ on them, prove the numbers of
steps and halvings. A φ for which no number is proved is refused.
"""

from __future__ import annotations

import itertools
import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property, lru_cache
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
from .edges import Edge, closed_inverse, with_quotients
from .intervals import Intervals, Undecided, precise
from .near_zero import chebyshev_points, interpolated
from .phi_values import PhiValues

GUESS_DEGREE = 12
"""Degree of a fitted polynomial."""
TOLERANCE = mpmath.mpf(10) ** -30
"""Error after Newton's last step, relative to the distance to the edge, or to the angle if the edge is a cut."""
STEPS_MAX, STEPS_HALVED = 7, 5
"""Largest number of Newton steps, and the number after halvings."""
HALVINGS_MAX = 32
DIGITS_LEFT = {"pole": 53, "fold": 27, "cut": 0}
"""Distance to the edge, in binary digits, to which steps are proved; floats resolve no angles nearer to it."""
PARTS, PARTS_MAX = 48, 6000
PARTED_MAX, PARTED_FOR_FEWER = 16, {"steps": 3, "count": 13}
"""Largest number of times that an interval is halved to prove any number, and to prove fewer steps or halvings."""


def _share(x: Coefficient, size: Any, m: Arithmetic) -> Coefficient:
    return m.name("share", times(1 / size, x, m, "ratio"))


def from_end(x: Coefficient, size: Any, m: Arithmetic) -> Coefficient:
    """Return ``√(1 − x/X)``, for X at the end of a chart: 0 there, up to rounding, and NaN beyond."""
    left = m.name("lack", 1 - _share(x, size, m))
    noise = m.both(m.less(left, 0), m.equal(NOISE + left, NOISE))
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
        """Tell whether φ′ is 0 or infinite at the edge."""
        return bool(mpmath.isinf(self.size))

    @abstractmethod
    def lowered(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """Return the guess at x and ``r = √x``, in the operations of an arithmetic."""

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


def fold(size: Any) -> Variable:
    """Return the variable ``z = √(1 − x/X)``, for which the angle is analytic at a fold."""
    return Variable(
        "Fold",
        lambda x, r, m: from_end(x, size, m),
        lambda z: size * (1 - z * z),
        lambda r, z: -r / z * (1 / size),
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
        drift = at.size(rates * at.enclosure(_derivatives(self.phi)[0], whole) - 1)[1]
        return abs(g - middle) + (high - low) / 2 * drift

    @cached_property
    def _places(self) -> dict[Any, tuple[Any, Any]]:
        """Cache of `_place`: an interval shares its ends with its neighbours, and its middle with its halves."""
        return {}

    def _place(self, angle: Any) -> tuple[Any, Any]:
        """Return the length and the variable at an angle."""
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
        slope, bend = _derivatives(self.phi)
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


def guess(phi: sympy.Expr, edge: Edge, limit: Fraction) -> Guess:
    """Return the first guess for x beyond a limit; `PhiError` if no guess is proved to lead to the root."""
    if edge.kind == "pole" and not edge.order:
        raise PhiError(f"phi = {phi} grows like a logarithm near its edge {edge.angle}: floats lose the angle there")
    if edge.kind == "fold" and edge.order > 1:
        raise PhiError(f"phi' of phi = {phi} has a double zero at its edge {edge.angle}: floats lose the angle there")
    with precise() as at:
        end, start = mpmath.mpf(edge.angle.evalf(mpmath.mp.dps)), mpmath.mpf(limit.numerator) / limit.denominator
        first = angle_of(phi, edge.angle, mpmath.sqrt(start)) * mpmath.mpf("0.98")
        for found in _guesses(phi, edge, first, end):
            if (proved := _proved(at, edge, found, first)) is not None:
                return proved
    reason = "no first guess is proved to lead Newton's method to the angle of every length"
    raise PhiError(f"phi = {phi} is not inverted to full precision: {reason}")


def _guesses(phi: sympy.Expr, edge: Edge, first: Any, end: Any) -> Iterator[Guess]:
    size = mpmath.inf if edge.kind == "pole" else _square(phi, end)
    # near a fold √(1 − x/X) determines the angle more accurately than the length does
    if edge.kind != "fold" and (inverse := closed_inverse(phi)) is not None:
        yield Closed(phi, end, size, 1, inverse)
    variables = [LENGTH, LOGARITHM]
    if edge.kind != "cut":
        variables = [fold(size) if edge.kind == "fold" else pole(real_value(phi, end / 2, phi), edge.order)]
    for variable in variables:
        yield _fitted(phi, edge, variable, first, end)
    halved = Halved(phi, end, size, STEPS_HALVED, phi, None, 1)
    if edge.kind != "pole":
        yield halved
    else:
        powers = with_quotients(phi).as_powers_dict()
        f = sympy.Mul(*(base ** (-power / edge.order) for base, power in powers.items()))
        yield replace(halved, f=f, order=edge.order)


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
    return Fitted(phi, end, size, 1, variable, polynomial(coefficients, scale, 1, middle))


def _square(phi: sympy.Expr, angle: Any) -> Any:
    return real_value(phi, angle, phi) ** 2


# --- proofs of the number of steps --------------------------------------------------------------------------------


def _proved(at: Intervals, edge: Edge, found: Guess, first: Any) -> Guess | None:
    """Return a guess with the number of steps or halvings that is proved at all angles beyond the first; else None."""
    if isinstance(found, Closed):
        return found  # exact up to rounding
    parts = _parts(edge, first, found.edge)[::-1]
    pending, most = [(low, high, 0) for low, high in parts], 1
    for low, _ in parts:
        if (need := _needed(at, edge, found, low, low, most)) is None:
            return None  # no smaller interval can help
        most = max(most, need)
    proved, most = ("count", most + 1) if isinstance(found, Halved) else ("steps", most)
    for _ in range(PARTS_MAX):
        if not pending:
            return replace(found, **{proved: most})
        low, high, depth = pending.pop()
        need = _needed(at, edge, found, low, high, most)
        if need is not None and (need <= most or depth >= PARTED_FOR_FEWER[proved]):
            most = max(most, need)
        elif depth == PARTED_MAX:
            return None
        else:
            middle = (low + high) / 2
            pending += [(middle, high, depth + 1), (low, middle, depth + 1)]
    return None


def _parts(edge: Edge, first: Any, end: Any) -> list[tuple[Any, Any]]:
    """Return intervals from the first angle to the edge, or to the last angle before it that floats resolve."""
    if edge.kind == "cut":
        ends = [first + (end - first) * k / PARTS for k in range(PARTS + 1)]
    else:
        ends = [end - (end - first) * mpmath.mpf(2) ** (-k / 4) for k in range(4 * DIGITS_LEFT[edge.kind])]
    return list(itertools.pairwise(ends))


def _needed(at: Intervals, edge: Edge, found: Guess, low: Any, high: Any, least: int) -> int | None:
    """Return the number of steps, or from ``least`` on of halvings, that an interval needs; None if none is proved."""
    left = low if edge.kind == "cut" else found.edge - high
    try:
        if not isinstance(found, Halved):
            error = found.error(at, low, high)
            if found.to_edge and 4 * error > left:
                return None  # a step could be longer than the way to the edge
            return _steps(at, found.phi, error, low, high, left)
        for count in range(least, HALVINGS_MAX):
            error = replace(found, count=count).error(at, low, high)
            steps = _steps(at, found.f, error, low, high, found.edge if found.order else left, found.bends)
            if steps is not None and steps <= found.steps:
                return count
    except (Undecided, ZeroDivisionError):
        pass
    return None


def _steps(
    at: Intervals, f: sympy.Expr, error: Any, low: Any, high: Any, left: Any, bends: Sequence[sympy.Expr] = ()
) -> int | None:
    """Return the number of Newton steps on f after which the error is within the tolerance; None if not proved.

    ``bends`` are further expressions of ``f″/f′``.
    """
    around, width = at.interval(low - error, high + error), high - low + 2 * error
    ratio = min((_ratio(at, f, around), *(_bounded(at, bend, around, width) for bend in bends)))
    for step in range(STEPS_MAX + 1):
        if error <= TOLERANCE * left:
            return step
        if not 2 * ratio * error <= 1:
            return None
        error = ratio * error**2
    return None


def _ratio(at: Intervals, f: sympy.Expr, around: Any) -> Any:
    """Return ``max |f″|/(2 min |f′|)``, infinite if nothing is proved."""
    try:
        steep, bend = (at.size(at.enclosure(of, around)) for of in _derivatives(f))
        return bend[1] / (2 * steep[0]) if steep[0] else mpmath.inf
    except Undecided:
        return mpmath.inf


def _bounded(at: Intervals, bend: sympy.Expr, around: Any, width: Any) -> Any:
    """Return a bound of the same ratio from a bound b of ``f″/f′``: f′ changes by at most ``e^(w b)`` on a width w."""
    try:
        most = at.size(at.enclosure(bend, around))[1]
        return most / 2 * mpmath.exp(width * most)
    except Undecided:
        return mpmath.inf


@lru_cache(maxsize=64)
def _derivatives(f: sympy.Expr) -> tuple[sympy.Expr, sympy.Expr]:
    return f.diff(alpha), f.diff(alpha, 2)
