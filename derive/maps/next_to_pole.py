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
    backwards = m.name("backwards", m.less(angle, 0))
    size = m.name("size", m.abs(angle))
    next_to = m.name("nextto", m.less(m.abs(size - round(n * math.pi)), 1))
    if n % 2:
        rest = m.atan2(m.where(backwards, -cosine, cosine), sine)
    else:
        falling = m.name("falling", m.less(cosine, 0))
        ahead = m.name("ahead", m.where(falling, sine, -sine))
        rest = m.atan2(m.where(backwards, -ahead, ahead), m.where(falling, -cosine, cosine))
    return next_to, m.name("rest", m.where(next_to, 2 * rest, size)), m.name("sideof", m.where(backwards, -1, 1))
