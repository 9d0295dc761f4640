"""Composition at n = 1 and 2 in closed form: of dual Rodrigues vectors, and of modified ones.

Components are in the space frame, in the order of the basis.
"""

from __future__ import annotations

from ..algebra import Vector


def compose_first_order(b2: Vector, b1: Vector) -> Vector:
    """Return ``(b1 + b2 + b2 × b1)/(1 − b1 · b2)``, composition at n = 1, CP23 (45): b1 acts first.

    A composed rotation by π, which n = 1 cannot represent, raises ZeroDivisorError.
    """
    composed: Vector = (b1 + b2 + b2.cross(b1)) / (1 - b1.dot(b2))
    return composed


def compose_second_order(s2: Vector, s1: Vector) -> Vector:
    r"""Return the composition at n = 2, CP23 (41): s1 acts first, and the sign of the product quaternion is kept.

    .. math::
        \sigma = \frac{(1 - \sigma_2^2)\,\sigma_1 + (1 - \sigma_1^2)\,\sigma_2 + 2\,\sigma_2 \times \sigma_1}
            {(1 - \sigma_2 \cdot \sigma_1)^2 + (\sigma_2 \times \sigma_1)^2}

    The result is the principal v where the product has real scalar part ≥ 0, and its shadow elsewhere. A product −1,
    where the shadow is v = 0, raises ZeroDivisorError.
    """
    cross, dot = s2.cross(s1), s2.dot(s1)
    numerator = s1 * (1 - s2.dot(s2)) + s2 * (1 - s1.dot(s1)) + cross * 2
    composed: Vector = numerator / ((1 - dot) ** 2 + cross.dot(cross))
    return composed
