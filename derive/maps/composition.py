r"""Composition of displacements: of quaternions, of tensors, and of the vectors v of one order.

Everywhere the second argument acts first: ``compose(n, v2, v1)`` is the v of ``R(v2) R(v1)``, ``q(v2) q(v1)``.
"""

from __future__ import annotations

from ..algebra import Quaternion, Tensor, Vector, real_part
from .closed_forms import quaternion_from_vector
from .inverse import vector_from_quaternion
from .polynomials import require_order


def tensor_from_quaternion(q: Quaternion) -> Tensor:
    """Return ``I + 2 q0 skew(q) + 2 skew(q)²`` of a unit dual quaternion, CP23 (24).

    A homomorphism onto the orthogonal dual tensors, two to one: q and −q have the same image. The norm is not checked.
    """
    skew = Tensor.skew(q.vector)
    R: Tensor = Tensor.identity() + skew * (2 * q.scalar) + skew @ skew * 2
    return R


def compose_first_order(b2: Vector, b1: Vector) -> Vector:
    """Return ``(b1 + b2 + b2 × b1)/(1 − b1 · b2)``, composition at n = 1, CP23 (45).

    Raises
    ------
    ZeroDivisorError
        Where the composed rotation is by π: n = 1 cannot hold it.
    """
    composed: Vector = (b1 + b2 + b2.cross(b1)) / (1 - b1.dot(b2))
    return composed


def compose_second_order(s2: Vector, s1: Vector) -> Vector:
    r"""Return the composition at n = 2 of the product quaternion's own sign, CP23 (41).

    .. math::
        \sigma = \frac{(1 - \sigma_2^2)\,\sigma_1 + (1 - \sigma_1^2)\,\sigma_2 + 2\,\sigma_2 \times \sigma_1}
            {(1 - \sigma_2 \cdot \sigma_1)^2 + (\sigma_2 \times \sigma_1)^2}

    It is the principal v where that product has real scalar part ≥ 0, and its shadow elsewhere.

    Raises
    ------
    ZeroDivisorError
        Where the product is −1, at ``Re σ2 · σ1 = 1`` with ``Re σ2 ∥ Re σ1``: the shadow is v = 0 there.
    """
    cross, dot = s2.cross(s1), s2.dot(s1)
    numerator = s1 * (1 - s2.dot(s2)) + s2 * (1 - s1.dot(s1)) + cross * 2
    composed: Vector = numerator / ((1 - dot) ** 2 + cross.dot(cross))
    return composed


def compose(n: int, v2: Vector, v1: Vector) -> Vector:
    """Return the principal v of order n of the displacement v1 followed by v2.

    The closed forms CP23 (45) and (41) serve n = 1, and n = 2 where (41) is principal; everything else goes through
    the unit dual quaternions, CP23 (58).

    Raises
    ------
    ZeroDivisorError
        At n = 1 where the composed rotation is by π.
    """
    if require_order(n) == 1:
        return compose_first_order(v2, v1)
    product = quaternion_from_vector(n, v2) * quaternion_from_vector(n, v1)
    if n == 2 and real_part(product.scalar) >= 0:
        return compose_second_order(v2, v1)
    return vector_from_quaternion(n, product)
