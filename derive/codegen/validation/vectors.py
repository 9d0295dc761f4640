"""Vectors of a chart at given numbers, computed from φ, the natural invariants of a pose and the branch of its angle.

These values are independent of the scalars and inverse map of the chart, whose results must agree with them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property, lru_cache, reduce
from typing import Any

import mpmath
import sympy

from ...algebra import Dual, Quaternion, Tensor, Vector, dual_part, real_part
from ...algebra.functions import atan2
from ...algebra.pose import Screw, is_zero, natural_invariants, orientation, polar, quaternion_from_screw
from ...maps.angle import angle_of
from ...maps.chart import Chart
from ...maps.elementary import alpha, evaluate
from . import reals
from .reals import INFINITE, NAN, Real, nearest

Flat = tuple[Any, ...]  # components of an array, in C order
DIGITS_CANCELLED, POWER_CANCELLED = 50, 10
"""Digits that terms of a scalar may lose by cancellation for each derivative, and those per digit of a small angle."""
BRANCHES_MAX = 8
SOME_BRANCHES = (0, 1, -1, 2)
"""Branches of cases in a chart with infinitely many; other charts have cases on the first `BRANCHES_MAX` branches."""

EDGE_UNITS = 2**20  # relative distance from the edge, in machine epsilons, at which φ′ is compared with φ′(0)
NEWTON_STEPS = 2  # steps from half of the digits of an angle to all of them, and one to spare
REACH = 0.9  # share of a given angle that seeded vectors may reach

REST = Screw(Dual(Real(0), Real(0)), Vector.dual(*(3 * (NAN,),) * 2))
"""Screw of the identity, which has no axis."""

IDENTITY: Flat = (*Tensor.identity(), *(0 * Tensor.identity()))


@dataclass(frozen=True)
class Vectors:
    """Vectors v_k = φ(α + 2πk) u of a chart in the working precision; the edge has ``precision`` bits."""

    chart: Chart
    precision: int = field(default_factory=reals.precision)

    @cached_property
    def edge(self) -> Any:
        """Limit of Re α, beyond which no v exists."""
        return self._number(self.chart.edge)

    @cached_property
    def is_folded(self) -> bool:
        """True if v ends at the edge with φ′ = 0; false if v is infinite there or no edge exists."""
        if not self.edge.is_finite():
            return False
        with reals.bits(self.precision):
            return bool(abs(self.slope(self.edge * (1 - EDGE_UNITS * reals.rounding()))) < self.slope(0))

    @cached_property
    def first_pole(self) -> Any:
        """Smallest Re α > 0 where v, T or T⁻¹ is singular."""
        return self._number(self.chart.singular_angles[0])

    def _number(self, angle: sympy.Expr) -> Any:
        with reals.bits(self.precision):
            return INFINITE if angle.is_infinite else Real(angle.evalf(mpmath.mp.dps + 5))

    @cached_property
    def _known(self) -> dict[Any, Any]:
        """Cache of computed values: points often share a length or a vector."""
        return {}

    def once(self, compute: Callable[..., Any], *given: Any) -> Any:
        """Return ``compute(*given)``, computed once in each precision."""
        place = reals.precision(), compute.__name__, reals.key(given)
        if place not in self._known:
            self._known[place] = compute(*given)
        return self._known[place]

    def size(self, angle: Any) -> Any:
        """Return φ of a real or dual angle."""
        return evaluate(self.chart.phi, alpha, angle)

    def slope(self, angle: Any) -> Any:
        """Return φ′ of a real angle."""
        return evaluate(_slope(self.chart.phi), alpha, angle)

    def angle(self, size: Any) -> Any:
        """Return the angle α = φ⁻¹(size) ≥ 0 of a real or dual length; raise ArithmeticError beyond the edge."""
        root = self.once(self._root, real_part(size))
        return Dual(root, size.du / self.slope(root)) if isinstance(size, Dual) else root

    def _root(self, size: Any) -> Any:
        with reals.bits(reals.precision() // 2):
            root = Real(angle_of(self.chart.phi, self.chart.edge, mpmath.mpf(size)))
        for _ in range(NEWTON_STEPS if size != 0 else 0):
            root = (root - (self.size(root) - size) / self.slope(root)).mid()
        if abs(self.size(root) - size) <= reals.rounding(1 / 2) * size:
            return root
        found = mpmath.nstr(mpmath.mpf(size))
        raise ArithmeticError(f"no angle below {self.chart.edge} has |v| = {found} in {self.chart.name}")

    def reaches(self, size: Any) -> bool:
        try:
            self.angle(size)
        except ArithmeticError:
            return False
        return True

    def component(self, most: Any, angle: Any) -> float:
        """Return the largest component of seeded vectors: ``most``, or less to keep their angles below ``angle``."""
        return float(min(most, self.size(REACH * angle) / Real(3).sqrt()) if angle.is_finite() else most)

    def derivatives(self, expression: sympy.Expr, x: sympy.Symbol, square: Any, order: int) -> Sequence[Any]:
        """Return an even function of α and its derivatives by x."""
        return tuple(+value for value in self.once(self._derivatives, expression, square, order))

    def _derivatives(self, expression: sympy.Expr, square: Any, order: int) -> list[Any]:
        angle, least = self.angle(square.sqrt()), reals.rounding(1 / 2)
        at: Any = max(angle, least)  # changes an even function by least² = eps only
        lost = DIGITS_CANCELLED - POWER_CANCELLED * min(0, int(mpmath.log10(at)))
        with reals.digits(mpmath.mp.dps + lost * max(order, 1)):
            for _ in range(order):  # a further dual part for each derivative by x, with dα/dx = 1/(2 φ φ′)
                at = Dual(at, 1 / (2 * self.size(at) * self.slope(at)))
            value, found = evaluate(expression, alpha, at), list[Any]()
            for count in range(order, -1, -1):
                found.append(reduce(lambda part, _: real_part(part), range(count), value))
                value = dual_part(value)
        return found

    # --- from natural invariants --------------------------------------------------------------------------------

    def at(self, screw: Screw, branch: int = 0) -> Vector:
        """Return ``φ(α + 2πk) u``; NaN beyond the edge."""
        angle = self._turned(screw, branch)
        return along(screw.axis, self.size(angle) if abs(angle.re) <= self.edge else Dual(NAN, NAN))

    def finite(self, screw: Screw, branch: int, least: float) -> bool:
        """Tell whether v exists and its margin to the edge, cos(π/2 · Re α/edge), exceeds ``least``."""
        share = self._turned(screw, branch).re / self.edge
        return bool(abs(share) < 1 and (share / 2).cos_pi() > least)

    def _turned(self, screw: Screw, branch: int) -> Dual:
        """Return α + 2πk, with k reduced modulo the number of branches to bring the angle nearest to 0."""
        count = self.chart.branches
        turns = nearest((screw.angle.re / (2 * Real.pi()) + branch) / count) if count else 0
        angle: Dual = screw.angle + 2 * Real.pi() * (branch - count * turns)
        return angle

    @property
    def tried(self) -> tuple[int, ...]:
        """Branches of cases, the principal one first."""
        return tuple(range(min(self.chart.branches, BRANCHES_MAX))) or SOME_BRANCHES

    def back(self, branch: int) -> int:
        """Return the branch that leads from a vector on ``branch`` back to the principal one."""
        return self.chart.branches - branch if self.chart.branches else -branch

    def of_quaternion(self, q: Quaternion, branch: int = 0) -> Vector:
        """Return v on a branch from q if its scalar part is >= 0, else from −q."""
        return self.at(screw_of_quaternion(q), branch)

    def of_tensor(self, R: Tensor, branch: int = 0) -> Vector:
        """Return v of an orthogonal dual tensor on a branch."""
        return self.at(natural_invariants(R) if flat(R) != IDENTITY else REST, branch)

    # --- to natural invariants ----------------------------------------------------------------------------------

    def screw(self, v: Vector) -> tuple[Screw, int]:
        """Return the screw of the pose of v, with 0 ≤ Re α ≤ π, and the branch of v.

        The axis has the direction of ``sin(α/2) u`` at odd multiples of π, and of the translation at even ones.
        """
        length, u = axial(v)
        angle = self.angle(length)
        halves = angle.re / Real.pi()
        exact = is_whole(halves)
        turns = nearest((nearest(halves) if exact else halves) / Real(2))  # ties to even keep sin(α/2)
        rest = (nearest(halves) - 2 * turns) * Real.pi() if exact else angle.re - 2 * turns * Real.pi()
        sign = orientation(rest, angle.du)
        return Screw(Dual(rest, angle.du) * sign, u * sign), turns * sign

    def quaternion(self, v: Vector) -> Quaternion:
        """Return ``cos(α/2) + sin(α/2) u``."""
        found: Quaternion = self.once(self._quaternion, *flat(v))
        return found

    def _quaternion(self, *components: Any) -> Quaternion:
        length, u = polar(dual(components))
        return quaternion_from_screw(Screw(self.angle(length), u))

    def shadow(self, v: Vector, branch: int) -> Vector:
        """Return the vector of the same pose, moved on by a number of branches."""
        screw, own = self.screw(v)
        return self.at(screw, own + branch)

    def odd_half_turns(self) -> list[int]:
        """Return the odd multiples 1, 3, 5 … of π below the edge, which separate the tried branches."""
        return [halves for halves in range(1, 2 * BRANCHES_MAX, 2) if halves * sympy.pi < self.chart.edge]


_slope = lru_cache(maxsize=256)(lambda phi: phi.diff(alpha))


def vectors_of(chart: Chart) -> Vectors:
    """Return the `Vectors` of a chart in the working precision, with the values computed so far."""
    return _vectors(chart, reals.precision())


_vectors = lru_cache(maxsize=4)(Vectors)


def screw_of_quaternion(q: Quaternion) -> Screw:
    """Return the screw of q if its scalar part is >= 0, else of −q."""
    q = q * orientation(real_part(q.scalar))
    length, u = axial(q.vector)
    return Screw(2 * atan2(length, q.scalar), u)


def axial(v: Vector) -> tuple[Dual, Vector]:
    """Return magnitude and direction of a dual vector; the direction of 0 is NaN."""
    return (REST.angle, REST.axis) if all(map(is_zero, flat(v))) else polar(v)


def along(axis: Vector, size: Dual) -> Vector:
    """Return the axis times a size; without an axis, NaN, or 0 for size 0."""
    if axis.c1.re.is_nan():
        return Vector.dual(*(3 * (size.re,),) * 2) if size == 0 else axis
    v: Vector = axis * size
    return v


def is_whole(number: Any) -> bool:
    """Tell whether a number is an integer to four fifths of the working digits."""
    return bool(abs(number - nearest(number)) < reals.rounding(0.8))


def dual(components: Sequence[Any]) -> Vector:
    return Vector.dual(components[:3], components[3:])


def flat(value: Vector | Tensor | Quaternion) -> Flat:
    """Return the components of a dual array, real part first."""
    return (*value.re, *value.du)
