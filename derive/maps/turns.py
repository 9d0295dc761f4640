r"""From branch to branch of a Cayley map: the axis of the principal angle, and the step of kπ/n in θ = α/2n.

One formula serves values and programs. v_k = r_k u comes from v = r u by ``r_k = (r cos + sin)/(cos − r sin)`` with the
cosine and sine of ``kπ/n``, CP23 (49).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import mpmath

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic
from .cayley_scalars import CayleyScalars


def direction(n: int, at: CayleyScalars, y: Coefficient, m: Arithmetic) -> Coefficient:
    """Return sign(p q): u = sign(p q) v/|v|. Where p = 0 that of q, where q = 0 the translation along v decides."""
    negative = m.name("pneg", m.less(at.p, 0))
    flipped = m.name("qp", m.where(negative, m.name("mq", -at.q), at.q))
    backwards = m.both(m.equal(at.q, 0), m.less(y, 0))
    return m.name("sign", _in_range(n, at, m) * m.where(m.either(m.less(flipped, 0), backwards), -1, 1))


def natural(
    n: int, at: CayleyScalars, y: Coefficient, r: Coefficient, m: Arithmetic
) -> tuple[Coefficient, Coefficient, Coefficient]:
    """Return the principal angle ``2 atan2(r |q|, |p|)``, ``dα/dr = 2n/(1 + x)``, and the direction."""
    sign = direction(n, at, y, m)
    p = m.where(m.name("pneg", m.less(at.p, 0)), -at.p, at.p)
    q = m.where(m.less(at.q, 0), m.name("mq", -at.q), at.q)
    angle = 2 * m.atan2(r * q, p) * _in_range(n, at, m)
    return m.name("angle", angle), m.name("slope", 2 * n / (1 + at.x)), sign


def _in_range(n: int, at: CayleyScalars, m: Arithmetic) -> Coefficient:
    """1, or NaN where p has overflowed and its sign says nothing, or x, and v/|v| is nothing."""
    largest = at.x if n == 1 else at.p
    return m.name("one", largest - largest + 1)


def turned(r: Coefficient, turn: Sequence[Coefficient], m: Arithmetic) -> tuple[Coefficient, Coefficient]:
    """Return ``(r cos + sin)/(cos − r sin)`` and its derivative ``1/(cos − r sin)²``."""
    cosine, sine = turn
    inverse = m.name("iden", m.div(1, cosine - r * sine))
    return m.name("rk", (r * cosine + sine) * inverse), m.name("slope", inverse * inverse)


def beyond(x: Coefficient, table: Sequence[Coefficient], m: Arithmetic) -> tuple[Any, Sequence[Coefficient]]:
    """Return whether x lies beyond the first limit of the table, and the turn of the last limit it lies beyond."""
    limits = [m.name(f"beyond{j}", m.less(limit, x)) for j, limit in enumerate(table[::3], 1)]
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
    """By steps of π/n, the ``tan²((2j − 1)π/2n)`` beyond which θ goes back by one more, and its turn."""
    for j in range(1, n // 2 + 1):
        half = mpmath.mpf(2 * j - 1) / (2 * n)
        yield ((mpmath.sinpi(half) / mpmath.cospi(half)) ** 2, *turn(n, -j))
