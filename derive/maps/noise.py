"""Rounding noise: how many roundings decide a side, an axis or a whole turn."""

from __future__ import annotations

from typing import Any

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic

NOISE = 64
"""Divisor in the test for rounding noise: a term is noise if ``sum + term/NOISE`` equals the sum.

Noise is below 16 to 32 eps of the sum. At half a turn, errors are up to 4 eps of the length for v, 4π eps for α, and
2π eps for ``cot(α/2)``.
"""

NOISE_GIVEN = NOISE // 4
"""Divisor for noise in given quaternions and matrices: a side that inverse maps take is one that v keeps."""

NOISE_OF_ANGLE = NOISE // 8
"""Divisor for noise in a given angle at the edge, where φ has the side of θ = α/2n ≤ π/2.

The rule lets α be off by 8 roundings of the edge, so θ by 8 π/2 < 13 roundings. `NOISE` allows 32 for cos θ.
"""

NOISE_OF_STEPS = 16 * NOISE
"""Divisor for noise across the axis at a whole turn, where a thousand steps add up their errors."""


def at_turn(sine: Coefficient, cosine: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
    """Return 1 where ``sin(α/2)`` is noise beside ``cos(α/2) > 0``, and 0 elsewhere.

    Where a pole of φ is a whole turn, its product with r = φ is not 0: nothing is lost there.
    """
    length = m.name("beside_turn", m.abs(m.where(m.less(m.abs(r), 1), sine, r * sine)))
    clear = m.name("clear_of_turn", m.less(cosine, m.beside(cosine, m.div(length, NOISE_GIVEN))))
    return m.where(clear, 0, 1)


def near_turn(fi: Coefficient, ai: Coefficient, m: Arithmetic) -> Any:
    """Return whether f_i is so large, beside ``a_i = 2 φ′``, that α is near a whole turn other than 0."""
    return m.name("turning", m.less(2 * ai, m.abs(fi)))
