"""Branches of a chart of order n: turns of θ = α/2n by kπ/n, for values and programs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import mpmath
import sympy

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic
from . import polynomials
from .chart import Chart
from .families import alpha
from .polynomials import Pair, Triple

Derivatives: TypeAlias = Triple
"""Value with its first and second derivatives."""

NOISE = 16
"""Divisor that detects noise: a term is rounding noise if, divided by it, the term leaves a sum unchanged.

Such a term is below 8 eps of the sum. At half a turn, errors are up to 4 eps of the length for v, 4π eps for α, and
2π eps for ``cot(α/2)``.
"""


def by_length(before: Derivatives, after: Derivatives, m: Arithmetic) -> Derivatives:
    """Return r_k and its derivatives by r, from φ and its derivatives by the angle before and after the turn."""
    _, slope, bend = before
    slope = m.name("before", slope)
    rk, slope_k, bend_k = after
    ratio = m.name("slope", m.div(slope_k, slope))
    change = m.name("slopeo", m.div(bend_k - ratio * bend, slope))
    return m.name("rk", rk), ratio, m.name("bend", m.div(change, slope))


def beyond(x: Coefficient, table: Sequence[Coefficient], m: Arithmetic) -> tuple[Any, Pair]:
    """Return whether x lies beyond the first limit of the table, and the turn of the last limit that x exceeds."""
    first, *others = table[::3]
    # up to rounding, v at half a turn is on the first branch
    limits = [m.name("beyond1", m.less(first, first + m.div(x - first, NOISE)))]
    limits += [m.name(f"beyond{j}", m.less(limit, x)) for j, limit in enumerate(others, 2)]
    cosine, sine = table[1:3]
    for j, (further, *values) in enumerate(zip(limits[1:], table[4::3], table[5::3], strict=True), 2):
        cosine = m.name(f"cosine{j}", m.where(further, values[0], cosine))
        sine = m.name(f"sine{j}", m.where(further, values[1], sine))
    return limits[0], (cosine, sine)


def turn(n: int, branch: int) -> tuple[Any, Any]:
    """Return cosine and sine of kπ/n."""
    step = mpmath.mpf(branch) / n
    return mpmath.cospi(step), mpmath.sinpi(step)


def square(phi: sympy.Expr, angle: sympy.Expr) -> Any:
    """Return φ² of an angle, in the working precision of mpmath."""
    return mpmath.mpf(phi.subs(alpha, angle).evalf(mpmath.mp.dps + 5)) ** 2


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

    def beyond(self, x: Coefficient, table: Sequence[Coefficient], m: Arithmetic) -> tuple[Any, Pair]:
        return beyond(x, table, m)

    def turn(self, branch: int) -> tuple[Any, Any]:
        return turn(self.order, branch)

    def returns(self) -> tuple[tuple[Any, Any, Any], ...]:
        """Return φ² at ``(2j − 1)π``, and the cosine and sine of the turn back by jπ/n, for each turn back."""
        turns = range(1, self.order // 2 + 1)
        return tuple((square(self.phi, (2 * j - 1) * sympy.pi), *self.turn(-j)) for j in turns)
