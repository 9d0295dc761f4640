r"""Composition at n = 1 and 2 in closed form: the second argument acts first, as in ``R(v2) R(v1)``."""

from __future__ import annotations

from ..algebra import Quaternion, Tensor, Vector


def tensor_from_quaternion(q: Quaternion) -> Tensor:
    """Return ``I + 2 q0 skew(q) + 2 skew(q)²`` of a unit dual quaternion, CP23 (24).

    The homomorphism onto the orthogonal dual tensors is two to one: q and −q have one image. The norm is not checked.
    """
    skew = Tensor.skew(q.vector)
    R: Tensor = Tensor.identity() + skew * (2 * q.scalar) + skew @ skew * 2
    return R


def compose_first_order(b2: Vector, b1: Vector) -> Vector:
    """Return ``(b1 + b2 + b2 × b1)/(1 − b1 · b2)``, composition at n = 1, CP23 (45).

    Raises
    ------
    ZeroDivisorError
        If the composed rotation is by π, which n = 1 cannot represent.
    """
    composed: Vector = (b1 + b2 + b2.cross(b1)) / (1 - b1.dot(b2))
    return composed


def compose_second_order(s2: Vector, s1: Vector) -> Vector:
    r"""Return the composition at n = 2 from the product quaternion, without a change of its sign, CP23 (41).

    .. math::
        \sigma = \frac{(1 - \sigma_2^2)\,\sigma_1 + (1 - \sigma_1^2)\,\sigma_2 + 2\,\sigma_2 \times \sigma_1}
            {(1 - \sigma_2 \cdot \sigma_1)^2 + (\sigma_2 \times \sigma_1)^2}

    The result is the principal v where the product has real scalar part ≥ 0, and its shadow elsewhere.

    Raises
    ------
    ZeroDivisorError
        If the product is −1, at ``Re σ2 · σ1 = 1`` with ``Re σ2 ∥ Re σ1``: the shadow is v = 0 there.
    """
    cross, dot = s2.cross(s1), s2.dot(s1)
    numerator = s1 * (1 - s2.dot(s2)) + s2 * (1 - s1.dot(s1)) + cross * 2
    composed: Vector = numerator / ((1 - dot) ** 2 + cross.dot(cross))
    return composed
