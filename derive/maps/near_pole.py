r"""Angles near the pole nπ of φ in a chart of order n, by the distance γ = nπ − α.

The rounding error of α is relative to α, so that ``nπ − α`` has few digits near the pole. Sine and cosine of α/2 give
all digits of γ:

.. math:: \tan\tfrac\gamma2 = -\tan\tfrac\alpha2 \quad \text{for even } n \qquad \cot\tfrac\alpha2 \quad \text{for odd}
"""

from __future__ import annotations

import math
from typing import Any

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic

Sides = tuple[Any, Coefficient, Coefficient]


def sides(n: int, angle: Coefficient, sine: Coefficient, cosine: Coefficient, m: Arithmetic) -> Sides:
    """Return whether |α| is near nπ, the value γ if so or |α| if not, and the sign of α.

    ``sine >= 0`` and ``cosine`` belong to α/2, up to a common factor.
    """
    side = m.name("sideof", m.where(m.less(angle, 0), -1, 1))
    size = m.name("size", m.abs(angle))
    next_to = m.name("nextto", m.less(m.abs(size - round(n * math.pi)), 1))
    above, below = (cosine, sine) if n % 2 else (-sine, cosine)
    divisor = m.name("divisor", m.where(next_to, below, 1))
    left = 2 * side * m.atan2(above / divisor, 1)
    return next_to, m.name("rest", m.where(next_to, left, size)), side
