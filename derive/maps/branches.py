r"""Branches of a chart of order n: the axis of the principal angle, and turns of θ = α/2n by kπ/n.

For the Cayley map, v_k = r_k u follows from v = r u by ``r_k = (r cos + sin)/(cos − r sin)``, with the cosine and sine
of ``kπ/n``, CP23 (49). The formulas serve both values and programs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import mpmath
import sympy

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic
from . import polynomials
from .cayley_scalars import CayleyScalars

Derivatives = tuple[Coefficient, Coefficient, Coefficient]
"""Value with its first and second derivatives."""

NOISE = 16
"""Divisor that detects noise: a term is rounding noise if, divided by it, the term leaves a sum unchanged.

Such a term is below 8 eps of the sum. At half a turn, errors are up to 4 eps of the length for v, 4π eps for α, and
2π eps for ``cot(α/2)``.
"""


def direction(n: int, at: CayleyScalars, y: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
    """Return the sign of p q, for the axis ``u = sign(p q) v/|v|``.

    For p = 0 return the sign of q; for q = 0 return the sign of the translation along v.
    """
    sign, _ = _direction(n, at, y, r, m)
    return sign


def _direction(
    n: int, at: CayleyScalars, y: Coefficient, r: Coefficient, m: Arithmetic
) -> tuple[Coefficient, Coefficient]:
    """Return the direction and ``r |q|``; both are NaN where p, ``r |q|`` or (n = 1) x overflows.

    At half a turn p is 0 up to rounding and q > 0; the direction of v is kept then.
    """
    sine = m.name("rq", r * m.abs(at.q))
    either = at.x if n == 1 else m.name("either", sine + at.p)
    one = m.name("one", either - either + 1)
    if n == 1:
        return one, sine * one
    negative = m.name("qneg", m.less(at.q, 0))
    kept = m.name("kept", m.where(negative, 0, sine))
    turned = m.name("qp", m.where(m.less(kept + m.div(at.p, NOISE), kept), -at.q, at.q))
    backwards = m.both(m.equal(at.q, 0), m.less(y, 0))
    return m.name("sign", one * m.where(m.either(m.less(turned, 0), backwards), -1, 1)), sine * one


def natural(
    n: int, at: CayleyScalars, y: Coefficient, r: Coefficient, m: Arithmetic
) -> tuple[Coefficient, Coefficient, Coefficient]:
    """Return the principal angle ``2 atan2(r |q|, |p|)``, ``dα/dr = 2n/(1 + x)``, and the sign from `direction`."""
    sign, sine = _direction(n, at, y, r, m)
    return m.name("angle", 2 * m.atan2(sine, m.abs(at.p))), m.name("slope", 2 * n / (1 + at.x)), sign


def turned(r: Coefficient, turn: Sequence[Coefficient], m: Arithmetic) -> Derivatives:
    """Return ``r_k = (r cos + sin)/(cos − r sin)``, ``dr_k/dr = 1/(cos − r sin)²`` and the second derivative."""
    cosine, sine = turn
    inverse = m.name("iden", m.div(1, cosine - r * sine))
    slope = m.name("slope", inverse * inverse)
    return m.name("rk", (r * cosine + sine) * inverse), slope, m.name("bend", 2 * (sine * inverse) * slope)


def by_length(before: Derivatives, after: Derivatives, m: Arithmetic) -> Derivatives:
    """Return r_k and its derivatives by r, from φ and its derivatives by the angle before and after the turn."""
    _, slope, bend = before
    slope = m.name("before", slope)
    rk, slope_k, bend_k = after
    ratio = m.name("slope", m.div(slope_k, slope))
    change = m.name("slopeo", m.div(bend_k - ratio * bend, slope))
    return m.name("rk", rk), ratio, m.name("bend", m.div(change, slope))


def beyond(x: Coefficient, table: Sequence[Coefficient], m: Arithmetic) -> tuple[Any, Sequence[Coefficient]]:
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


def returns(n: int) -> Iterator[tuple[Any, Any, Any]]:
    """Yield the limit ``tan²((2j − 1)π/2n)`` of x, and the cosine and sine of the turn, for each turn back by jπ/n."""
    for j in range(1, n // 2 + 1):
        half = mpmath.mpf(2 * j - 1) / (2 * n)
        yield ((mpmath.sinpi(half) / mpmath.cospi(half)) ** 2, *turn(n, -j))


class BranchesOfOrder:
    """Edge and branches of a chart of order n: |Re α| < nπ, and θ turns by π/n from one of n branches to the next."""

    order: int

    @property
    def edge(self) -> sympy.Expr:
        return self.order * sympy.pi

    @property
    def branches(self) -> int:
        return self.order

    @property
    def singular_angles(self) -> tuple[sympy.Expr, ...]:
        """Return the angles Re α = 2πk > 0 where T loses rank, then the edge nπ, where v or T is infinite."""
        return polynomials.singular_angles(self.order)

    def beyond(
        self, x: Coefficient, table: Sequence[Coefficient], m: Arithmetic
    ) -> tuple[Any, Sequence[Coefficient]]:
        return beyond(x, table, m)

    def turn(self, branch: int) -> tuple[Any, Any]:
        return turn(self.order, branch)
