r"""From a unit dual quaternion or a pose back to v: the n branches of the inverse Cayley map, shadows, principal v.

.. math:: v_k = \tan\frac{\alpha + 2 k \pi}{2 n}\,u, \qquad k = 0, \dots, n - 1 \qquad \text{CP23 (49)}

All v_k give the same pose. Branch 0 is the principal one. All functions take any real number type: SymPy, mpmath,
floats; they state the mathematics and do not guard small angles against cancellation.
"""

from __future__ import annotations

from ..algebra import Dual, Quaternion, Tensor, Vector, dual_part, real_part
from ..algebra.functions import atan2, cos, namespace, sin, tan
from .closed_forms import quaternion_from_vector
from .polynomials import pair_by_squaring, require_order
from .pose import Screw, natural_invariants, pose_from_tensor
from .sign_tests import is_zero, orientation


def vector_from_quaternion(n: int, q: Quaternion, branch: int = 0) -> Vector:
    """Return v of one branch from a unit dual quaternion, CP23 (47), (49).

    q and −q are the same pose: the sign with real scalar part ≥ 0 is taken; at 0 the given vector part stands.

    Parameters
    ----------
    n : int
        Order.
    q : Quaternion
        Unit dual quaternion (the norm is not checked).
    branch : int
        k, modulo n. A pure translation takes its direction as axis for k ≠ 0.

    Raises
    ------
    ZeroDivisorError
        Where v is infinite: Re α + 2πk = nπ.
    ValueError
        For a branch k ≠ 0 of the identity, which has no axis.
    """
    k = branch % require_order(n)
    q = q * (1 if is_zero(real_part(q.scalar)) else orientation(real_part(q.scalar)))
    w = q.vector
    if is_zero(w.re.dot(w.re)) and k == 0:
        # q = ±(1 + ε ρ/2), of which the principal v is ε ρ/2n: no axis needed
        v: Vector = w / (n * q.scalar)
    else:
        length, u = polar(w)
        v = u * tan((atan2(length, q.scalar) + k * namespace(*w.re, *w.du).pi) / n)
    return v


def vector_from_screw(n: int, screw: Screw, branch: int = 0) -> Vector:
    """Return ``tan((α + 2kπ)/2n) u`` of a screw, CP23 (49); `ZeroDivisorError` where it is infinite."""
    k = branch % require_order(n)
    v: Vector = screw.axis * tan((screw.angle + 2 * k * namespace(*screw.axis.re, screw.angle.re).pi) / (2 * n))
    return v


def vector_from_tensor(n: int, R: Tensor, branch: int = 0) -> Vector:
    """Return v of one branch from an orthogonal dual tensor, through its natural invariants.

    At Re α = π the axis is oriented so that its first non-zero component is positive. A translation by ρ is ``ε ρ/2n``
    on branch 0; on the others it takes ρ as axis, and the identity is a ValueError.
    """
    if branch % require_order(n) == 0 and all(is_zero(entry) for entry in R.re - Tensor.identity()):
        rho = pose_from_tensor(R).displacement
        return Vector.dual(rho * 0, rho / (2 * n))
    return vector_from_screw(n, natural_invariants(R), branch)


def axis(n: int, v: Vector) -> tuple[Vector, Dual]:
    """Return the axis u of the principal angle and the signed coefficient r of ``v = r u``.

    ``u = sign(p_n q_n) v/|v|``, since ``p q / (1+x)ⁿ`` has the sign of ``sin α`` on v. Where Re v = 0 the axis is that
    of the translation, ``v°/|v°|`` with moment zero. Where Re q_n = 0, a translation on another branch, the sign of
    its dual part makes it the axis of a positive translation. Where Re p_n = 0, α = π, v/|v| stands.

    Raises
    ------
    ValueError
        At v = 0, the identity, which has no axis.
    """
    length, direction = polar(v)
    p, q = pair_by_squaring(n, v.dot(v))
    sign = orientation(real_part(p)) * orientation(real_part(q), dual_part(q))
    if is_zero(real_part(length)):
        sign = 1
    return direction * sign, length * sign


def shadow(n: int, v: Vector, branch: int = 1) -> Vector:
    r"""Return v_k, the vector of the same pose that lies `branch` branches on (any integer, modulo n).

    .. math:: v_k = \frac{r \cos(k\pi/n) + \sin(k\pi/n)}{\cos(k\pi/n) - r \sin(k\pi/n)}\,u, \qquad v = r u

    with u and r of `axis`. ``shadow(shadow(v, j), k) = shadow(v, j + k)``.

    Raises
    ------
    ZeroDivisorError
        Where v_k is infinite.
    ValueError
        At v = 0, the identity, for k ≠ 0.
    """
    k = branch % require_order(n)
    if k == 0:
        return v
    u, r = axis(n, v)
    turn = k * namespace(*v.re, *v.du).pi / n
    cosine, sine = cos(turn), sin(turn)
    v_k: Vector = u * ((r * cosine + sine) / (cosine - r * sine))
    return v_k


def principal(n: int, v: Vector) -> Vector:
    """Return the shadow of smallest Re|v|, with 0 ≤ Re α ≤ π; at α = π the side of v's own quaternion stands."""
    return vector_from_quaternion(n, quaternion_from_vector(n, v))


def polar(w: Vector) -> tuple[Dual, Vector]:
    """Return magnitude and unit dual direction of a dual vector, CP23 Proposition 1 with moment 0 where Re w = 0."""
    length = w.magnitude()
    if not is_zero(w.re.dot(w.re)):
        return length, w / length
    if is_zero(w.du.dot(w.du)):
        raise ValueError("the identity has no axis: give branch 0, or the axis")
    return length, Vector.dual(w.du / w.du.magnitude(), w.re)
