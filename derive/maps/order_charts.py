"""Charts of order n with θ = α/2n: gains of quaternions, and branches at turns ``kπ/n`` of θ."""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Sequence
from typing import Any, TypeAlias

import mpmath
import sympy

from ..algebra import Coefficient, Quaternion
from ..algebra.arithmetic import Arithmetic, Pair
from . import polynomials
from .chart import Chart, Followed
from .elementary import alpha
from .polynomials import Triple
from .real_constants import NOISE, NOISE_GIVEN
from .scalars import QuaternionChart

Derivatives: TypeAlias = Triple
"""Value with its first and second derivatives."""


def by_length(before: Derivatives, after: Derivatives, m: Arithmetic) -> Derivatives:
    """Return r_k and its derivatives by r, from φ and its derivatives by the angle before and after the turn."""
    _, slope, bend = before
    slope = m.name("before", slope)
    rk, slope_k, bend_k = after
    ratio = m.name("slope", m.div(slope_k, slope))
    change = m.name("slopeo", m.div(bend_k - ratio * bend, slope))
    return m.name("rk", rk), ratio, m.name("bend", m.div(change, slope))


def beyond(x: Coefficient, table: Sequence[Coefficient], m: Arithmetic) -> tuple[Any, Coefficient, Pair]:
    """Return whether x lies beyond the first limit of the table, x or a number, and the turn of the last limit passed.

    The number that replaces an x within the limit is near the limit, where φ is regular.
    """
    first, *others = table[::3]
    # v at half a turn counts as principal despite rounding
    beside = m.name("beside1", m.beside(first, m.div(x - first, NOISE)))
    limits = [m.name("beyond1", m.less(first, beside))]
    limits += [m.name(f"beyond{j}", m.less(limit, x)) for j, limit in enumerate(others, 2)]
    cosine, sine = table[1:3]
    for j, (further, *values) in enumerate(zip(limits[1:], table[4::3], table[5::3], strict=True), 2):
        cosine = m.name(f"cosine{j}", m.where(further, values[0], cosine))
        sine = m.name(f"sine{j}", m.where(further, values[1], sine))
    return limits[0], m.name("place", m.where(limits[0], x, beside)), (cosine, sine)


def turn(n: int, branch: int) -> tuple[Any, Any]:
    step = mpmath.mpf(branch) / n
    return mpmath.cospi(step), mpmath.sinpi(step)


def square(phi: sympy.Expr, angle: sympy.Expr) -> Any:
    return mpmath.mpf(phi.subs(alpha, angle).evalf(mpmath.mp.dps + 5)) ** 2


# --- gain of a quaternion ----------------------------------------------------------------------------------------


def cayley_gain(n: int, q: Quaternion, size: Coefficient, m: Arithmetic) -> Coefficient:
    """Return ``tan(α/2n)/|vec q|`` with the sign of the scalar part, for a quaternion of norm `size`.

    The gain is infinite at α = nπ: for n = 1 at half a turn.
    """
    if n == 1:
        return m.div(1, q.scalar)
    sign, cosine = half_cosine(q, size, m)
    if has_ladder(n):
        return m.div(sign, _ladder(n, cosine, size, m))
    still, square, sine = half_sine(q, cosine, m)
    sine = m.name("sinq", square / sine)  # NaN instead of 1/∞ = 0 where the square overflows
    tangent = m.tan(m.div(m.atan2(sine, cosine), n))
    return sign * (m.where(still, 1, tangent) / m.where(still, n * cosine, sine))


def half_cosine(q: Quaternion, size: Coefficient, m: Arithmetic) -> Pair:
    """Return the sign of the scalar part, and their product; the sign is 1 if the part is noise, at half a turn."""
    negative = m.less(m.beside(size, m.div(q.scalar, NOISE_GIVEN)), size)
    sign = m.name("sign", m.where(negative, -1, 1))
    return sign, m.name("cos", sign * q.scalar)


def kept_inside(chart: Chart, gain: Coefficient, q: Quaternion, m: Arithmetic) -> Coefficient:
    """Return a gain with which v is not beyond an edge at half a turn, where the angle of a quaternion ends."""
    if chart.edge > sympy.pi:
        return gain
    v = gain * q.vector
    return m.name("kept", gain * chart.inside(m.name("x", v.dot(v)), m))


def half_sine(q: Quaternion, cosine: Coefficient, m: Arithmetic) -> tuple[Any, Coefficient, Coefficient]:
    """Return whether the vector part is 0, its square, and its length (for 0, an unused positive number)."""
    square = m.name("ss", q.vector.dot(q.vector))
    still = m.name("still", m.equal(square, 0))
    # avoid the root of 0: its derivative is infinite, and 0 · ∞ would spoil the gradient
    sine = m.name("sin", m.sqrt(m.where(still, cosine, square)))
    return still, square, sine


def side_of_step(
    e: Quaternion, size: Coefficient, turn: Coefficient, m: Arithmetic
) -> tuple[Coefficient, Any, Coefficient, Coefficient]:
    """Return the sign with which e is a step of at most half a turn from q̂(v), and data of ``α/2`` of sign times e.

    These are whether α is beyond half a turn, ``size (1 + |cos(α/2)|)``, and the square of vec e, NaN if it overflows.
    A factor of vec e with all digits divides by this square where α is beyond half a turn.
    """
    side = m.name("side", m.where(m.less(m.beside(1, m.div(turn, NOISE_GIVEN)), 1), -1, 1))
    cosine = m.name("cosine", side * e.scalar)
    beyond_half = m.name("beyondhalf", m.less(cosine, 0))
    square = m.name("ss", e.vector.dot(e.vector))
    more = m.name("more", m.where(beyond_half, size - cosine, size + cosine) + (square - square))
    return side, beyond_half, more, square


def has_ladder(n: int) -> bool:
    """Return whether n is a power of two: then log2(n) half-angle formulas lead from α/2 to α/2n."""
    return n & (n - 1) == 0


def _ladder(n: int, cosine: Coefficient, size: Coefficient, m: Arithmetic) -> Coefficient:
    """Return ``size · sin(α/2)/tan(α/2n)`` for n = 2^m, from ``size · cos(α/2)``."""
    divisor: Coefficient = 1
    c = cosine if n == 2 else m.name("cos1", m.div(cosine, size))
    unit = size if n == 2 else 1
    step = 1
    while n > 2:
        n //= 2
        step += 1
        c = m.name(f"cos{step}", m.sqrt(m.div(1 + c, 2)))
        divisor = divisor * (2 * c)
    total = divisor * (unit + c)
    return total if unit is size else total * size


def near_pole(
    n: int, angle: Coefficient, sine: Coefficient, cosine: Coefficient, m: Arithmetic
) -> tuple[Any, Coefficient, Coefficient]:
    """Return whether |α| is near the pole nπ, then ``nπ − |α|`` if it is near or |α| if not, then the sign of α.

    The arguments ``sine >= 0`` and ``cosine`` belong to α/2, up to a common factor. They give all digits of the
    distance; the rounded angle does not. The tangent of half of it is ``−tan(α/2)`` for even n, else ``cot(α/2)``.
    """
    side = m.name("sideof", m.where(m.less(angle, 0), -1, 1))
    size = m.name("size", m.abs(angle))
    next_to = m.name("nextto", m.less(m.abs(size - round(n * math.pi)), 1))
    above, below = (cosine, sine) if n % 2 else (-sine, cosine)
    divisor = m.name("divisor", m.where(next_to, below, 1))
    left = 2 * side * m.atan2(above / divisor, 1)
    return next_to, m.name("rest", m.where(next_to, left, size)), side


# --- charts ------------------------------------------------------------------------------------------------------


class BranchesOfOrder(Chart):
    """Edge and branches of a chart of order n: |Re α| < nπ, and θ turns by π/n from one of n branches to the next."""

    @property
    def edge(self) -> sympy.Expr:
        return self.order * sympy.pi

    @property
    def branches(self) -> int:
        return self.order

    @property
    def singular_angles(self) -> tuple[sympy.Expr, ...]:
        """Angles Re α = 2πk > 0 where T loses rank, then the edge nπ, where v or T is infinite."""
        return polynomials.singular_angles(self.order)

    def beyond(self, x: Coefficient, table: Sequence[Coefficient], m: Arithmetic) -> tuple[Any, Coefficient, Pair]:
        return beyond(x, table, m)

    def turn(self, branch: int) -> tuple[Any, Any]:
        return turn(self.order, branch)

    def returns(self) -> tuple[tuple[Any, Any, Any], ...]:
        """Return φ² at ``(2j − 1)π``, and the cosine and sine of the turn back by jπ/n, for each turn back."""
        turns = range(1, self.order // 2 + 1)
        return tuple((square(self.phi, (2 * j - 1) * sympy.pi), *self.turn(-j)) for j in turns)


class OrderChart(BranchesOfOrder, QuaternionChart):
    """Chart v = φ(α) u of order n: φ is a function of θ = α/2n with its edge at θ = π/2.

    ``q̂ = (cos θ + σ v)ⁿ`` with ``σ = sin θ/|v|``: CP23 (60) with ``a = cos θ/σ``. Turns of θ are reduced to |θ| < π/2.
    """

    @abstractmethod
    def phi_derivatives(self, sine: Coefficient, cosine: Coefficient, m: Arithmetic, mark: str = "") -> Derivatives:
        """Return φ and its first two derivatives by θ, from sine and cosine of θ; `mark` is a suffix for names."""

    @abstractmethod
    def cosine(self, x: Coefficient, m: Arithmetic) -> Pair:
        """Return cos θ and ``σ = sin θ/|v|`` at x."""

    @abstractmethod
    def over_sine(self, cosine: Coefficient, m: Arithmetic) -> Pair:
        """Return numerator and denominator of ``φ/sin θ``."""

    def coefficient(self, angle: Coefficient, m: Arithmetic) -> Pair:
        """Return φ and φ′ at the angle reduced to (−nπ, nπ], where cos θ ≥ 0."""
        return self._folded(*double_angle(m.name("t", m.tan(m.div(angle, 4 * self.order))), m), m)

    def _folded(self, sine: Coefficient, cosine: Coefficient, m: Arithmetic) -> Pair:
        further = m.name("further", cosine)
        # at a fold, an angle that rounding puts beyond the edge counts as within
        beyond = m.less(m.beside(1, m.div(further, NOISE)), 1) if self.folds else m.less(further, 0)
        side = m.name("side", m.where(beyond, -1, 1))
        r, slope, _ = self.phi_derivatives(m.name("sin", side * sine), m.name("cos", side * further), m)
        return m.name("r", r), m.name("slope", m.div(slope, 2 * self.order))

    # --- inverse map ------------------------------------------------------------------------------------------------

    def gain(self, q: Quaternion, size: Coefficient, m: Arithmetic) -> Coefficient:
        """Return ``φ/sin(α/2)``, by half-angle formulas where n is a power of two."""
        sign, cosine = half_cosine(q, size, m)
        found = self._by_halves if has_ladder(self.order) else self._by_angle
        above, below = found(q, cosine, size, m)
        return kept_inside(self, m.name("gain", m.div(sign * above, below)), q, m)

    def _by_halves(self, q: Quaternion, cosine: Coefficient, size: Coefficient, m: Arithmetic) -> Pair:
        below = size
        c = cosine if self.order == 1 else m.name("cos0", m.div(cosine, size))
        for step in range(1, self.order.bit_length()):
            c = m.name(f"cos{step}", m.sqrt(m.div(1 + c, 2)))
            below = below * (2 * c)
        above, root = self.over_sine(c, m)
        return above, below * root

    def _by_angle(self, q: Quaternion, cosine: Coefficient, size: Coefficient, m: Arithmetic) -> Pair:
        still, _, sine = half_sine(q, cosine, m)
        t = m.name("t", m.tan(m.div(m.atan2(sine, cosine), 2 * self.order)))
        of_angle, cos = double_angle(t, m)
        above, below = self.over_sine(m.name("costheta", cos), m)
        at_rest, below_rest = self.over_sine(1, m)
        return (
            m.where(still, at_rest, of_angle * above),
            m.where(still, self.order * cosine * below_rest, sine * below),
        )

    # --- branches ---------------------------------------------------------------------------------------------------

    def followed(
        self, x: Coefficient, along: Coefficient, e: Quaternion, size: Coefficient, turn: Coefficient, m: Arithmetic
    ) -> Followed:
        if self.order > 2:
            return super().followed(x, along, e, size, turn, m)
        if self.order == 1:
            side, cosine = half_cosine(e, size, m)
            below, c = size, m.name("known", m.div(cosine, size))
        else:
            side, beyond_half, more, square = side_of_step(e, size, turn, m)
            half = m.name("half", m.sqrt(m.div(m.div(more, size), 2)))
            sine = m.name("sine", m.div(m.sqrt(m.where(beyond_half, square, 1 + square)), size))
            c = m.name("known", m.where(beyond_half, m.div(sine, 2 * half), half))
            below = size * (2 * c)
        above, root = self.over_sine(c, m)
        factor = m.name("factor", m.div(side * above, below * root))
        return Followed(factor, 0, m.name("fe", factor * e.scalar), c)

    def unfolded(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        c, sigma = self.cosine(x, m)
        return 2 * self.order * m.atan2(r * sigma, c)

    def turned(self, r: Coefficient, turn: Sequence[Coefficient], m: Arithmetic) -> Derivatives:
        (cosine, sine), rr = turn, m.name("rr", r * r)
        c, sigma = self.cosine(rr, m)
        s = m.name("s", r * sigma)
        further = m.name("further", c * cosine - s * sine)
        side = m.name("side", m.where(m.less(further, 0), -1, 1))
        sine_k, cosine_k = m.name("sk", side * (s * cosine + c * sine)), m.name("ck", side * further)
        return by_length(self.phi_derivatives(s, c, m), self.phi_derivatives(sine_k, cosine_k, m, "k"), m)


def double_angle(t: Coefficient, m: Arithmetic) -> Pair:
    """Return sine and cosine of twice the angle whose tangent is t."""
    tt = m.name("tt", t * t)
    below = m.name("below", 1 + tt)
    return 2 * t / below, (1 - tt) / below


def half_angle(angle: Coefficient, length: Coefficient, m: Arithmetic) -> Pair:
    """Return ``cos(α/2)`` and ``sin(α/2)/length``."""
    sine, cosine = double_angle(m.name("t", m.tan(m.div(angle, 4))), m)
    return cosine, sine / length
