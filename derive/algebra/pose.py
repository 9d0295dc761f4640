r"""Poses, orthogonal dual tensors, screws and lines: the isomorphism φ, structural and natural invariants.

A pose takes body to space by a rotation Q and a displacement ρ of the origin (length units). CP23 (14) represents it by
the orthogonal dual tensor ``R = (I + ε skew(ρ)) Q``. A line through the point p with unit direction a is the unit dual
vector ``a + ε p × a`` (direction, moment about the origin). All functions take any real number type.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import sympy

from . import Coefficient, Dual, Quaternion, Tensor, Vector, functions
from .functions import atan2, cos, cot, sin


@dataclass(frozen=True, slots=True)
class Pose:
    """Element of SE(3), ``r -> Q r + ρ``, by its structural invariants Q and ρ (CP23 Theorem 1)."""

    rotation: Tensor
    displacement: Vector

    def __matmul__(self, other: Pose) -> Pose:
        """Return the composed pose: first `other`, then this pose."""
        return Pose(self.rotation @ other.rotation, self.rotation @ other.displacement + self.displacement)

    def inverse(self) -> Pose:
        """Return the inverse pose ``(Qᵀ, −Qᵀ ρ)``."""
        back = self.rotation.transpose
        return Pose(back, -(back @ self.displacement))

    def apply(self, point: Vector) -> Vector:
        """Return the moved point ``Q r + ρ``."""
        return self.rotation @ point + self.displacement


@dataclass(frozen=True, slots=True)
class Screw:
    """Natural invariants of a pose, CP23 Theorem 3.

    `angle` is the dual angle ``α + ε d`` (rotation, translation along the axis). `axis` is the unit dual vector
    ``u + ε u°`` of the Mozzi-Chasles axis (direction, moment about the space origin).
    """

    angle: Dual
    axis: Vector


def tensor_from_pose(pose: Pose) -> Tensor:
    """Return φ of the pose, ``(I + ε skew(ρ)) Q``, CP23 (14), (15): an isomorphism onto the orthogonal dual tensors."""
    return Tensor.dual(pose.rotation, Tensor.skew(pose.displacement) @ pose.rotation)


def pose_from_tensor(R: Tensor) -> Pose:
    """Return φ⁻¹ of an orthogonal dual tensor, ``Q = Re R``, ``ρ = vect(Du R Qᵀ)``, CP23 (16); R is not checked."""
    Q = R.re
    return Pose(Q, (R.du @ Q.transpose).vect())


def natural_invariants(R: Tensor) -> Screw:
    r"""Return the dual angle, 0 ≤ α ≤ π, and the unit dual axis of an orthogonal dual tensor, CP23 (18).

    With ``w = vect Q = sin α u`` and ``tr Q = 1 + 2 cos α``, ``α = atan2(|w|, (tr Q − 1)/2)``. The axis u depends on
    the trace:

    * −1 < tr Q < 3: ``u = w/|w|``;
    * tr Q = −1 (Q is symmetric, α = π): u from ``Q + I = 2 u⊗u``. Both signs are right; the first non-zero
      component is made positive;
    * tr Q = 3 (Q = I, α = 0, a translation): ``u = ρ/|ρ|``, with moment zero; any parallel axis would do.

    The second case is the limit of ``(Q + Qᵀ)/2 − cos α I = (1 − cos α) u⊗u``. This equation, with the sign from w,
    gives u for all tr Q < 1, because ``w/|w|`` loses digits towards α = π.

    .. math::
        d = \rho \cdot u, \qquad
        u^\circ = \tfrac12 \rho \times u + \tfrac12 \cot\tfrac\alpha2\,u \times (\rho \times u)

    Orthogonality is not checked. Zero tests of w and ρ are exact (`is_zero`). The identity has no axis: ValueError.
    """
    pose = pose_from_tensor(R)
    Q, rho = pose.rotation, pose.displacement
    w, cosine = Q.vect(), (Q.trace() - 1) / 2
    if cosine < 0:
        u = _axis_past_quarter_turn(Q, w, cosine)
    elif not is_zero(w.dot(w)):
        u = w / w.magnitude()
    elif not is_zero(rho.dot(rho)):
        distance = rho.magnitude()
        return Screw(Dual(0 * cosine, distance), Vector.dual(rho / distance, rho * 0))
    else:
        raise ValueError("the identity has no axis: every unit dual vector would do")
    angle = atan2(w.magnitude(), cosine)
    across = rho.cross(u)
    moment = across / 2 + u.cross(across) * cot(angle / 2) / 2
    return Screw(Dual(angle, rho.dot(u)), Vector.dual(u, moment))


def tensor_from_screw(screw: Screw) -> Tensor:
    """Return ``I + sin α skew(u) + (1 − cos α) skew(u)²`` in dual numbers, CP23 (17)."""
    skew = Tensor.skew(screw.axis)
    R: Tensor = Tensor.identity() + skew * sin(screw.angle) + skew @ skew * (1 - cos(screw.angle))
    return R


def quaternion_from_screw(screw: Screw) -> Quaternion:
    """Return the unit dual quaternion ``cos(α/2) + sin(α/2) u``, CP23 (23)."""
    half = screw.angle / 2
    return Quaternion(cos(half), screw.axis * sin(half))


def polar(w: Vector) -> tuple[Dual, Vector]:
    """Return magnitude and unit dual direction of a dual vector, CP23 Proposition 1; the moment is 0 where Re w = 0."""
    length = w.magnitude()
    if not is_zero(w.re.dot(w.re)):
        return length, w / length
    if is_zero(w.du.dot(w.du)):
        raise ValueError("the identity has no axis: give branch 0, or the axis")
    return length, Vector.dual(w.du / w.du.magnitude(), w.re)


def _axis_past_quarter_turn(Q: Tensor, w: Vector, cosine: Coefficient) -> Vector:
    """Return u from ``(1 − cos α) u⊗u``, by the column with the largest diagonal entry."""
    outer = (Q + Q.transpose) / 2 - Tensor.identity() * cosine
    k = max(range(3), key=lambda i: outer[i, i])
    column = Vector(outer[0, k], outer[1, k], outer[2, k])
    u: Vector = column / (column.magnitude() * orientation(column.dot(w), *column))
    return u


def foot(line: Vector) -> Vector:
    """Return the point of the line that is nearest to the origin, ``a × a*``."""
    return line.re.cross(line.du)


def distance(
    a: Vector, b: Vector, library: Any = functions, magnitude: Callable[[Coefficient], Coefficient] = abs
) -> Coefficient:
    """Return the shortest distance between two lines that are not parallel, ``|(q − p)·(a × b)| / |a × b|``."""
    normal = a.re.cross(b.re)
    return magnitude((foot(b) - foot(a)).dot(normal)) / library.sqrt(normal.dot(normal))


def distance_of_parallels(a: Vector, b: Vector, library: Any = functions) -> Coefficient:
    """Return the distance between two parallel lines of either orientation, ``|(q − p) × a|``."""
    across = (foot(b) - foot(a)).cross(a.re)
    return library.sqrt(across.dot(across))


def is_zero(value: Coefficient) -> bool:
    """Return whether a number is exactly zero; roots in SymPy numbers are rationalised and expanded first."""
    if isinstance(value, sympy.Expr):
        value = sympy.expand(sympy.radsimp(value))
    return bool(value == 0)


def orientation(*values: Coefficient) -> int:
    """Return the sign, 1 or −1, of the first non-zero value; 1 if there is none."""
    for value in values:
        if not is_zero(value):
            return 1 if value > 0 else -1
    return 1
