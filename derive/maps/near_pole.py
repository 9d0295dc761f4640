r"""Angles next to nπ, where φ of a chart of order n has its pole: by how far it is from there.

An angle of a few turns is known to some eps of itself, and so is what is left of it to nπ, however little that is. Of
sine and cosine of α/2 all digits of it can be had: with ``γ = nπ − α``

.. math:: \tan\tfrac\gamma2 = -\tan\tfrac\alpha2 \quad \text{for even } n \qquad \cot\tfrac\alpha2 \quad \text{for odd}
"""

from __future__ import annotations

import math
from typing import Any

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic

Sides = tuple[Any, Coefficient, Coefficient]


def sides(n: int, angle: Coefficient, sine: Coefficient, cosine: Coefficient, m: Arithmetic) -> Sides:
    """Return whether |α| is next to nπ, the rest γ where it is and |α| elsewhere, and the sign of α.

    ``sine >= 0`` and cosine are those of α/2 but for their length and a common sign.
    """
    side = m.name("sideof", m.where(m.less(angle, 0), -1, 1))
    size = m.name("size", m.abs(angle))
    next_to = m.name("nextto", m.less(m.abs(size - round(n * math.pi)), 1))
    above, below = (cosine, sine) if n % 2 else (-sine, cosine)
    divisor = m.name("divisor", m.where(next_to, below, 1))
    left = 2 * side * m.atan2(above / divisor, 1)
    return next_to, m.name("rest", m.where(next_to, left, size)), side
