"""Descriptions of functions and arrays in plain text, for targets whose functions take plain numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache

from ..maps.cayley import EQUATIONS
from .package import cited
from .rows import Array, Table
from .signatures import POSES

ALWAYS = "Defined for every v."
POLES = "inf or NaN where `tangent_inv` has a pole."
LOST = (
    "Branches k != 0 lose digits near the identity, as the axis does;"
    " branches that end at half a turn lose them there."
)


@dataclass(frozen=True)
class Section:
    """Functions that belong together, with the lines that describe each; a ``note`` stands above some of them."""

    title: str
    functions: Mapping[str, tuple[str, ...]]
    note: str = ""


_FORWARD = {
    "quaternion": (
        "Quaternion of v, CP23 {quaternion}: q = s + w v.",
        "The scalar is >= 0 for rotation angles up to pi; the closed form gives the sign on shadows.",
    ),
    "tensor": ("Tensor R of v, CP23 {tensor}, from body to space axes.",),
    "transform_point": ("Point moved from the body frame to the space frame.",),
    "inverse": ("Vector -v of the inverse, R(-v) = R(v)^T.",),
    "adjoint": ("Real matrix that transforms twists and wrenches from the body frame to the space frame.",),
    "transform_point_jacobians": (
        "Derivatives of transform_point(v, r) by v and by r; the latter is the rotation matrix.",
    ),
}
_FRAME = {
    "{body}tangent": (
        "Tangent operator of the {frame} frame, CP23 {T_by}: {omega} = {T} v_dot. Defined for every v.",
        "It loses rank at the angles 2 k pi of `singular_angles`.",
    ),
    "{body}tangent_inv": (
        "Inverse tangent operator of the {frame} frame, CP23 {T_inv_by}: v_dot = {T_inv} {omega}.",
        "inf or NaN at its poles, the angles 2 k pi of `singular_angles`.",
    ),
    "{body}twist": (
        f"Twist in the {{frame}} frame from the rate of v, CP23 (86): {{omega}} = {{T}} v_dot{{further}}. {ALWAYS}",
    ),
    "{body}rate": (
        "Rate of v from the twist in the {frame} frame, CP23 {rate_by}: v_dot = {T_inv} {omega}.", POLES,
    ),
    "{body}cotangent": (
        f"Generalized force of a wrench in the {{frame}} frame: tau = {{dual_T}} z. {ALWAYS}",
    ),
    "{body}tangent_dot": (f"Time derivative of {{T}}. {ALWAYS}",),
    "{body}twist_dot": (f"Time derivative of the twist in the {{frame}} frame. {ALWAYS}",),
    "{body}rate_dot": (
        "Second time derivative of v from the twist in the {frame} frame and its derivative.", POLES,
    ),
}  # fmt: skip
_FRAME_JACOBIANS = {
    "{body}twist_jacobian": (
        f"Derivative by v of the twist in the {{frame}} frame at fixed v_dot: d({{T}} v_dot)/dv. {ALWAYS}",
    ),
    "{body}cotangent_jacobian": (
        "Derivative by v of the generalized force of a fixed wrench in the {frame} frame: d({dual_T} z)/dv. "
        + ALWAYS,
    ),
    "{body}rate_jacobian": (
        "Derivative by v of the rate of v at a fixed twist in the {frame} frame: d({T_inv} omega)/dv.", POLES,
    ),
    "{body}transition": (
        "Derivative of v by its initial value v0 in a motion with a given twist in the {frame} frame: {transition}.",
        "inf or NaN where `tangent_inv` of v has a pole.",
    ),
    "{body}retract": ("Vector w with R(w) = {moved}, on the branch nearest v: a step in the {frame} frame.",),
    "{body}retract_jacobians": (
        "Derivatives of w = {body}retract(v, delta) by v and delta, on its branch: T(w)^-1 {by_v}, T(w)^-1 {by_delta}.",
    ),
    "{body}local": (
        "Step delta in the {frame} frame from v1 to v2: R(v2) = {from_v1}, with rotation angle at most pi.",
    ),
    "{body}local_jacobians": ("Derivatives of delta = {body}local(v2, v1) by v2 and v1: {local_by}.",),
}  # fmt: skip
_FRAMES = (
    {"body": "", "frame": "space", "T": "T", "dual_T": "T^T", "T_inv": "T^-1", "omega": "omega", "further": "",
     "rate_by": "(87), (90)", "T_by": "{tangent}", "T_inv_by": "{tangent_inv}", "moved": "exp(delta) R(v)",
     "from_v1": "exp(delta) R(v1)", "by_v": "exp(delta) T(v)", "by_delta": "dexp(delta)",
     "transition": "T(v)^-T T(v0)^T", "local_by": "dexp(delta)^-1 T(v2), -dexp(-delta)^-1 T(v1)"},
    {"body": "body_", "frame": "body", "T": "T^T", "dual_T": "T", "T_inv": "T^-T", "omega": "omega_B",
     "further": " = R^T omega", "rate_by": "(87), (91)", "T_by": "(86)", "T_inv_by": "(91)",
     "moved": "R(v) exp(delta)", "from_v1": "R(v1) exp(delta)", "by_v": "T(v)", "by_delta": "R(v) dexp(delta)",
     "transition": "T(v)^-1 T(v0)", "local_by": "dexp(-delta)^-1 T(v2)^T, -dexp(delta)^-1 T(v1)^T"},
)  # fmt: skip
_BRANCHES = {
    "shadow": (
        "Vector of the same pose or rotation after k branches, CP23 (49); v itself for k = 0.",
        "alpha is the principal angle and u its axis, u = sign(p q) v/|v|. If the sign is undecided, the vector part",
        "of the quaternion gives it, then v. The axis of a pure translation is its direction.",
        "inf or NaN where the branch is at its pole; NaN at the identity.",
        LOST,
    ),
    "shadow_jacobian": (
        "Derivative of shadow(v, branch) by v, T(v_k)^-1 T(v); the unit matrix for k = 0.",
        "Defined at whole turns too, where T(v) has no inverse. For k != 0 it is inf or NaN if there is no rotation,",
        "or if v or its shadow is at the edge of the chart.",
    ),
    "principal": ("Shadow with the smallest rotation angle, in [0, pi]; v itself if it is principal, and at a tie.",),
    "switch": (
        "Principal vector v_k with its rate and covariance, J v_dot and J P J^T for J = T(v_k)^-1 T(v); as given if v",
        "is principal. All is computed for every v, so that the time does not depend on v. The covariance is",
        "symmetric; of the argument only the upper triangle is read, unless v is principal.",
    ),
    "from_quaternion": (
        "Vector of a quaternion, k = branch, CP23 (47), (49). Any norm but zero stands for the normalised form.",
        "q and -q give the same v: the sign with scalar >= 0 is used. If the scalar is 0 up to rounding, the vector",
        "part keeps its sign. NaN or infinity in any component gives NaN.",
        "Infinite where the branch is at an edge with a pole, as branch 0 of cayley1 at the angle pi.",
        "On branches k != 0 the axis of a pure translation is its direction, and the identity gives NaN.",
        LOST,
    ),
    "from_tensor": (
        "Vector of a tensor, k = branch. The tensor is not checked: errors are first order in the violation.",
        "At the angle pi the first component of the axis that is not 0 up to rounding is positive. Branches and edge",
        "as in `from_quaternion`.",
    ),
    "to_exponential": ("Exponential coordinates alpha u of v on its own branch, alpha not folded to [0, pi].",),
    "from_exponential": (
        "Vector phi(alpha) u of exponential coordinates alpha u, on their branch.",
        "An alpha beyond the edge of the chart is reduced by the fewest whole turns that lead back.",
    ),
    "angle": ("Angle of v on its own branch, not folded to [0, pi]: v = phi(alpha) u.",),
}
_COMPOSITION = {
    "compose": (
        "Principal vector of R(v2) R(v1), CP23 (58): v1 acts first. The product of quaternions gives the sign at the",
        "rotation angle pi; v is infinite there if the chart has a pole at pi.",
    ),
    "between": (
        "Principal vector of R(v1)^-1 R(v2), from v1 to v2 in the frame of v1.",
        "Infinite at the angle pi if the chart has a pole there.",
    ),
    "compose_jacobians": (
        "Derivatives of v = compose(v2, v1) by v2 and v1, on its branch: T(v)^-1 T(v2), T(v)^-1 R(v2) T(v1).",
    ),
    "between_jacobians": ("Derivatives of between(v2, v1) by v2 and by v1, on its branch.",),
    "interpolate": (
        "Vector on the shorter motion of constant twist from v1 (t = 0) to v2 (t = 1); t is one number.",
        "The result follows v continuously from v1, so at t = 1 it is v2 or one of its shadows. If v1 and v2 are half",
        "a turn apart, the quaternion product selects the motion. NaN beyond the edge of a chart, unless phi repeats.",
    ),
}
_POSES = {
    "pose": (
        "Homogeneous matrix of v, CP23 (16) of {tensor}: Q and rho = Re(T) v_dual, from body to space. " + ALWAYS,
        "The Cayley map of 4x4 matrices differs: it has the same rotation and another translation.",
    ),
    "transform_line": (
        f"Line, or any dual vector, moved from the body frame to the space frame: R line, CP23 (66). {ALWAYS}",
    ),
    "transform_line_jacobians": (f"Derivatives of transform_line(v, line) by v and by line. {ALWAYS}",),
    "from_pose": (
        "Vector of a homogeneous matrix, k = branch. The matrix is not checked: errors are first order in the",
        "violation. The last row is not read. Angle pi, branches and edge as in `from_tensor`.",
    ),
    "from_screw": (
        "Vector phi(alpha) u of a dual angle and an axis; infinite at the edge of the chart.",
        "The axis is a unit dual vector, direction and moment about the origin. It is not checked.",
    ),
    "to_screw": (
        "Dual angle and axis of v, the natural invariants of CP23 Theorem 3; the rotation angle is in [0, pi].",
        "A pure translation has its direction and moment 0; the identity has no axis (NaN).",
    ),
}
_ROTATIONS = {
    "from_angle_axis": (
        "Vector phi(alpha) u of an angle and a unit vector (not checked); infinite at the edge of the chart.",
    ),
    "to_angle_axis": ("Angle in [0, pi] and axis of v; the identity has no axis (NaN).",),
}


@cache
def sections(table: Table) -> tuple[Section, ...]:
    """Return the public functions of a table with their descriptions, in the order of print."""
    numbers = {name: cited(found) for name, found in EQUATIONS.items()}

    def described(title: str, rows: Mapping[str, tuple[str, ...]], note: str = "", **words: str) -> Section:
        filled = {name.format(**words): tuple(line.format(**numbers, **words) for line in rows[name]) for name in rows}
        return Section(title, filled, note)

    def frames() -> Iterator[Section]:
        for row in _FRAMES:
            words = {name: text.format(**numbers) for name, text in row.items()}
            title = f"{words['frame']} frame, with the tangent operator {words['T']}"
            yield described(title, _FRAME, **words)
            note = "Jacobians by rows: a row per component of the result, a column per component of the argument"
            yield described("", _FRAME_JACOBIANS, note, **words)

    last = ("poses, lines and screws", _POSES) if table is POSES else ("angle and axis", _ROTATIONS)
    found = (
        described("forward maps: defined for every v", _FORWARD), *frames(),
        described("branches: vectors phi(alpha + 2 k pi) u of the same pose or rotation, k = branch", _BRANCHES),
        described("composition", _COMPOSITION), described(*last),
    )  # fmt: skip
    table.require_complete("descriptions", [name for one in found for name in one.functions], table.composed)
    return found


ARRAYS: Mapping[str, tuple[str, str]] = {
    "v": ("vector of the chart: real part (dimensionless), dual part (length unit of the pose)",
          "vector of the chart (dimensionless)"),
    "v_dot": ("time derivative of v (1/s)",) * 2,
    "omega": ("twist [omega, v]: angular velocity (rad/s), velocity of the body point at the space origin; of body "
              "functions in body axes, velocity of the body origin", "angular velocity (rad/s)"),
    "z": ("wrench [f, m]: force, moment about the space origin (body functions: the body origin)", "moment"),
    "tau": ("generalized force: tau[3:].v_dot[:3] + tau[:3].v_dot[3:] = m.omega + f.v, the power",
            "generalized force: tau.v_dot = z.omega, the power"),
    "v_ddot": ("derivative of v_dot (1/s^2)",) * 2,
    "omega_dot": ("time derivative of omega",) * 2,
    "delta": ("step in exponential coordinates: rotation vector (rad), translation part",
              "step in exponential coordinates (rad)"),
    "w": ("exponential coordinates alpha u: rotation vector (rad), dual part", "rotation vector alpha u (rad)"),
    "jacobian": ("real matrix by rows",) * 2,
    "covariance": ("covariance of v by rows, symmetric",) * 2,
    "q": ("unit dual quaternion, scalar first in each half", "unit quaternion, scalar first"),
    "tensor": ("dual tensor: nine entries by rows, nine entries by rows", "matrix by rows, from body to space axes"),
    "tangent": ("dual tensor: nine entries by rows, nine entries by rows", "matrix by rows"),
    "pose": ("homogeneous matrix [[Q, rho], [0, 1]] by rows: Q takes body to space axes, rho is the displacement of "
             "the origin", ""),
    "r": ("point (length unit of the pose)", "point"),
    "line": ("Pluecker coordinates: direction, moment about the space origin", "unit vector of the axis"),
    "t": ("fraction of the motion from v1 to v2",) * 2,
    "angle": ("rotation angle (rad), translation along the axis", "rotation angle (rad)"),
}  # fmt: skip
"""Arrays of poses and of rotations, with units, frame and order of the components."""
_LIKE = {
    "v_k": "v", "v_back": "v", "v_moved": "v", "v0": "v", "v1": "v", "v2": "v", "v_dot_k": "v_dot", "R": "tensor",
    "covariance_k": "covariance", "T": "pose", "u": "line", "tangent_dot": "tangent", "adjoint": "jacobian",
}


def about(array: Array, table: Table) -> str:
    """Return the description of an array of a function in a table."""
    moved = {"moved": "line" if array.size == POSES.functions["transform_line"].results[0].size else "r"}
    known = "jacobian" if array.name.startswith("by_") else {**_LIKE, **moved}.get(array.name, array.name)
    return ARRAYS[known][table is not POSES]
