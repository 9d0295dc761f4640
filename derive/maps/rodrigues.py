r"""Dual Rodrigues vector and dual Cayley formula, K10 (Karakılıç 2010); composition at n = 1 and 2 in closed form.

An orthogonal dual tensor A with dual angle ``f + ε f*`` about the unit dual vector ŝ (its screw axis) has

.. math:: B = (A - I)(A + I)^{-1} = \widetilde{b}, \qquad A = (I + B)(I - B)^{-1}, \qquad
        b = \tan\tfrac{f + ε f^*}{2}\,ŝ

The vector b is v of order n = 1. Components are in the space frame, in the order of the basis.
"""

from __future__ import annotations

from typing import Any

from ..algebra import Tensor, Vector, functions


def cayley_matrix(A: Tensor) -> Tensor:
    """Return ``B = (A − I)(A + I)⁻¹``, K10 section 2: skew-symmetric where A is orthogonal.

    A half turn or a reflection A raises ZeroDivisionError, since ``A + I`` is exactly singular.
    """
    unit = Tensor.identity()
    return (A - unit) @ (A + unit).inverse()


def cayley_formula(b: Vector) -> Tensor:
    """Return ``A = (I + B)(I − B)⁻¹`` with ``B = skew(b)``, K10's Cayley formula; ``det(I − B) = 1 + b·b``."""
    unit, B = Tensor.identity(), Tensor.skew(b)
    return (unit + B) @ (unit - B).inverse()


def rodrigues_vector(A: Tensor) -> Vector:
    """Return b with ``A x − x = b × (A x + x)`` for all x, from the invariants: ``b = 2 vect A / (1 + tr A)``.

    No inverse is taken, so the result is independent of `cayley_matrix`. It is singular at half turns.
    """
    b: Vector = A.vect() * 2 / (1 + A.trace())
    return b


def direction(b: Vector, library: Any = functions) -> Vector:
    """Return ``ŝ = b/|b|`` of a dual vector with Re b ≠ 0, K10 (7); `library` provides ``sqrt`` of the coefficients."""
    s: Vector = b / library.sqrt(b.dot(b))
    return s


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
