"""The vectors of a chart at given numbers, from φ alone: natural invariants of a pose, and branches of its angle.

No scalar of the chart is used, nor its way back: what they compute has to agree with this.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from typing import Any

import mpmath
import sympy

from ...algebra import Dual, Quaternion, Tensor, Vector, real_part
from ...algebra.functions import atan2
from ...maps.any_phi.edges import angle_of
from ...maps.any_phi.elementary import evaluate
from ...maps.chart import Chart
from ...maps.families import alpha, by_square
from ...maps.inverse import polar
from ...maps.pose import Screw, natural_invariants, quaternion_from_screw
from ...maps.sign_tests import is_zero, orientation

CANCELLED = 250
"""Digits that terms of a scalar or its slope may lose: α⁻⁷ at least."""

MAX_BRANCHES = 8
ENDLESS = (0, 1, -1, 2)
"""Branches that are tried, at most, and where there is no end of them."""

FEW = 2**20
"""Units of rounding before the edge: where φ′ is small, or great."""

SHORT = 0.9
"""Of an angle: what vectors drawn at random may reach of it."""


@dataclass(frozen=True)
class Vectors:
    """v_k = φ(α + 2πk) u of a chart, in the working precision of mpmath; where it ends, in that of the beginning."""

    chart: Chart
    precision: int = field(default_factory=lambda: mpmath.mp.prec)

    @cached_property
    def edge(self) -> Any:
        """Re α beyond which there is no v."""
        return self._number(self.chart.edge)

    @cached_property
    def is_folded(self) -> bool:
        """Whether v ends at the edge, with φ′ = 0; else it is infinite there, or there is none."""
        if mpmath.isinf(self.edge):
            return False
        with mpmath.workprec(self.precision):
            return bool(abs(self.slope(self.edge * (1 - FEW * mpmath.eps))) < self.slope(0))

    @cached_property
    def first_pole(self) -> Any:
        """The least Re α > 0 where v, T or its inverse is singular."""
        return self._number(self.chart.singular_angles[0])

    def _number(self, angle: sympy.Expr) -> Any:
        with mpmath.workprec(self.precision):
            return mpmath.inf if angle.is_infinite else mpmath.mpf(angle.evalf(mpmath.mp.dps + 5))

    @cached_property
    def _slope(self) -> sympy.Expr:
        return self.chart.phi.diff(alpha)

    @cached_property
    def _roots(self) -> dict[tuple[int, Any], Any]:
        """Angles that have been found, by precision and length."""
        return {}

    @cached_property
    def _quaternions(self) -> dict[tuple[Any, ...], Quaternion]:
        """Quaternions that have been computed, by precision and components of v."""
        return {}

    @cached_property
    def _values(self) -> dict[tuple[int, sympy.Expr, Any, int], tuple[Any, ...]]:
        """Values and slopes of functions of α that have been computed: points differ in other components more often."""
        return {}

    @cached_property
    def _slopes(self) -> dict[sympy.Expr, sympy.Expr]:
        """Derivatives by x that have been taken."""
        return {}

    def size(self, angle: Any) -> Any:
        """φ of a real or dual angle."""
        return evaluate(self.chart.phi, alpha, angle)

    def slope(self, angle: Any) -> Any:
        """φ′ of a real angle."""
        return evaluate(self._slope, alpha, angle)

    def angle(self, size: Any) -> Any:
        """φ⁻¹ of a length, real or dual: α ≥ 0.

        Raises
        ------
        ArithmeticError
            If no angle before the edge has this length.
        """
        length = real_part(size)
        at = mpmath.mp.prec, length
        if at not in self._roots:
            self._roots[at] = self._root(length)
        root = self._roots[at]
        return Dual(root, size.du / self.slope(root)) if isinstance(size, Dual) else root

    def _root(self, size: Any) -> Any:
        root = angle_of(self.chart.phi, self.chart.edge, size)
        if abs(self.size(root) - size) <= mpmath.sqrt(mpmath.eps) * size:
            return root
        raise ArithmeticError(f"no angle below {self.chart.edge} has |v| = {mpmath.nstr(size)} in {self.chart.name}")

    def reaches(self, size: Any) -> bool:
        """Whether there is a vector of this length."""
        try:
            self.angle(size)
        except ArithmeticError:
            return False
        return True

    def component(self, most: Any, angle: Any) -> float:
        """The largest component of vectors drawn at random: this, or less where they would come near an angle."""
        return float(most if mpmath.isinf(angle) else min(most, self.size(SHORT * angle) / mpmath.sqrt(3)))

    def derivatives(self, expression: sympy.Expr, square: Any, order: int) -> Sequence[Any]:
        """An even function of α and its derivatives by x; terms may cancel near 0, so more digits are taken."""
        key = mpmath.mp.prec, expression, square, order
        if key not in self._values:
            angle, least = self.angle(mpmath.sqrt(square)), mpmath.sqrt(mpmath.eps)
            with mpmath.workdps(mpmath.mp.dps + CANCELLED * max(order, 1)):
                at = max(angle, least)  # an even function: off by the square of that
                found = []
                for _ in range(order + 1):
                    found.append(evaluate(expression, alpha, at))
                    expression = self._by_square(expression)
                self._values[key] = tuple(found)
        return tuple(+value for value in self._values[key])

    def _by_square(self, expression: sympy.Expr) -> sympy.Expr:
        if expression not in self._slopes:
            self._slopes[expression] = by_square(expression, self.chart.phi)
        return self._slopes[expression]

    # --- from natural invariants --------------------------------------------------------------------------------

    def at(self, screw: Screw, branch: int = 0) -> Vector:
        """``φ(α + 2πk) u``; beyond the edge there is none."""
        angle = self._turned(screw, branch)
        v: Vector = screw.axis * (self.size(angle) if abs(angle.re) <= self.edge else Dual(mpmath.nan, mpmath.nan))
        return v

    def finite(self, screw: Screw, branch: int, least: float) -> bool:
        """Whether that is a vector and not near the edge: sin(π/2) of what is left of it is above ``least``."""
        share = self._turned(screw, branch).re / self.edge
        return bool(abs(share) < 1 and mpmath.cospi(share / 2) > least)

    def _turned(self, screw: Screw, branch: int) -> Dual:
        """α + 2πk, branches taken modulo their number, where there is one, so that it is nearest to 0."""
        count = self.chart.branches
        nearest = mpmath.nint((screw.angle.re / (2 * mpmath.pi) + branch) / count) if count else 0
        angle: Dual = screw.angle + 2 * mpmath.pi * (branch - count * int(nearest))
        return angle

    @property
    def tried(self) -> tuple[int, ...]:
        """Branches that cases are about, the principal one first."""
        return tuple(range(min(self.chart.branches, MAX_BRANCHES))) or ENDLESS

    def back(self, branch: int) -> int:
        """The number of branches that leads back from a branch."""
        return self.chart.branches - branch if self.chart.branches else -branch

    def of_quaternion(self, q: Quaternion, branch: int = 0) -> Vector:
        """v of one branch; scalar part >= 0 is taken, and where it is 0, the given vector part stands."""
        q = q * (1 if is_zero(real_part(q.scalar)) else orientation(real_part(q.scalar)))
        length, u = polar(q.vector)
        return self.at(Screw(2 * atan2(length, q.scalar), u), branch)

    def of_tensor(self, R: Tensor, branch: int = 0) -> Vector:
        """v of one branch of an orthogonal dual tensor."""
        return self.at(natural_invariants(R), branch)

    # --- back to them -------------------------------------------------------------------------------------------

    def screw(self, v: Vector) -> tuple[Screw, int]:
        """The screw of v's pose, 0 ≤ Re α ≤ π, and the branch that v is on.

        At an odd multiple of π the vector part of v's own quaternion, ``sin(α/2) u``, points along the axis; at an even
        one the translation does.
        """
        length, u = polar(v)
        angle = self.angle(length)
        halves = angle.re / mpmath.pi
        exact = is_whole(halves)
        turns = int(mpmath.nint((mpmath.nint(halves) if exact else halves) / 2))  # half to even: sin(α/2) > 0
        rest = (mpmath.nint(halves) - 2 * turns) * mpmath.pi if exact else angle.re - 2 * turns * mpmath.pi
        sign = orientation(rest, angle.du)
        return Screw(Dual(rest, angle.du) * sign, u * sign), turns * sign

    def quaternion(self, v: Vector) -> Quaternion:
        """``cos(α/2) + sin(α/2) u``."""
        at = mpmath.mp.prec, *v.re, *v.du
        if at not in self._quaternions:  # most quotients of differences move another argument
            length, u = polar(v)
            self._quaternions[at] = quaternion_from_screw(Screw(self.angle(length), u))
        return self._quaternions[at]

    def shadow(self, v: Vector, branch: int) -> Vector:
        """The vector of the same pose that lies so many branches on."""
        screw, own = self.screw(v)
        return self.at(screw, own + branch)

    def odd_half_turns(self) -> Iterator[int]:
        """1, 3, 5 …: the half turns below the edge, between branches that are tried."""
        for halves in range(1, 2 * MAX_BRANCHES, 2):
            if halves * sympy.pi < self.chart.edge:
                yield halves


def vectors_of(chart: Chart) -> Vectors:
    """Those of a chart in the working precision: asked for again, what has been computed of them is known."""
    return _vectors(chart, mpmath.mp.prec)


_vectors = lru_cache(maxsize=2)(Vectors)


def is_whole(number: Any) -> bool:
    """Whether a number is an integer but for rounding, which has four fifths of the digits to stay above."""
    return bool(abs(number - mpmath.nint(number)) < mpmath.eps ** mpmath.mpf("0.8"))
