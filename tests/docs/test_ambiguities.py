"""Tables of docs/explanation/ambiguities.md: their words are measured on each library that is installed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from pytransform3d import rotations, transformations
from scipy.linalg import expm

from tests.support import pages
from tests.support.libraries import jax, jaxlie

Row = dict[str, tuple[str, Any]]
"""Call as printed, and its result, by column."""

HALVES = np.array([3, 4, 5, 0, 1, 2])


def hat(w: np.ndarray) -> np.ndarray:
    """Return the matrix of w × …"""
    return np.cross(np.eye(3), w)


def motion(xi: np.ndarray) -> np.ndarray:
    """Return the 4x4 matrix of exponential coordinates [ω, v] by the matrix exponential."""
    return expm(np.block([[hat(xi[:3]), xi[3:, None]], [np.zeros((1, 4))]]))


def little(xi: np.ndarray) -> np.ndarray:
    """Return the 6x6 matrix ad of [ω, v]."""
    return np.block([[hat(xi[:3]), np.zeros((3, 3))], [hat(xi[3:]), hat(xi[:3])]])


def left(xi: np.ndarray) -> np.ndarray:
    """Return the sum of adᵏ/(k + 1)!, a block of a matrix exponential."""
    return expm(np.block([[little(xi), np.eye(6)], [np.zeros((6, 12))]]))[:6, 6:]


def halves(matrix: Any) -> np.ndarray:
    """Return the 6x6 matrix with the halves of rows and columns exchanged."""
    return np.asarray(matrix)[HALVES][:, HALVES]


XI, STEP = np.array([0.3, 0.5, 0.9, 1.0, 0.4, 0.2]), np.array([0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
T, D = motion(XI), motion(STEP)
Q, AXIS, ANGLE = T[:3, :3], XI[:3] / np.linalg.norm(XI[:3]), float(np.linalg.norm(XI[:3]))
MRP, MRP_STEP = np.tan(ANGLE / 4) * AXIS, np.tan(np.linalg.norm(STEP[:3]) / 4) * STEP[:3] / np.linalg.norm(STEP[:3])
REAL = np.array([np.cos(ANGLE / 2), *np.sin(ANGLE / 2) * AXIS])
LEFT = hat(T[:3, 3])
DUAL = np.array([-T[:3, 3] @ REAL[1:], *REAL[0] * T[:3, 3] + LEFT @ REAL[1:]]) / 2  # ½ (0, ρ) q
LAST = [1, 2, 3, 0]

WORDS: dict[str, dict[str, np.ndarray]] = {
    "quaternion": {"scalar first": REAL, "scalar last": REAL[LAST]},
    "matrix": {"body to space": Q, "space to body": Q.T},
    "product": {"R(a) R(b)": Q @ D[:3, :3], "R(b) R(a)": D[:3, :3] @ Q},
    "MRP": {"tan(α/4) u": MRP, "−tan(α/4) u": -MRP, "4 tan(α/4) u": 4 * MRP},
    "6-vector": {"[ω, v]": XI, "[v, ω]": XI[HALVES]},
    "6x6 matrix": {"[ω, v]": expm(little(XI)), "[v, ω]": halves(expm(little(XI)))},
    "dual quaternion": {
        "scalar first": np.concatenate([REAL, DUAL]),
        "scalar last": np.concatenate([REAL[LAST], DUAL[LAST]]),
    },
    "step δ": {"T·exp(δ)": T @ D, "exp(δ)·T": D @ T},
    "Jacobian of exp": {
        "left": left(XI),
        "right": left(-XI),
        "left, inverse": np.linalg.inv(left(XI)),
        "right, inverse": np.linalg.inv(left(-XI)),
    },
}
"""Possible words and their meanings, from matrix exponentials and half angles, by column."""


def word(column: str, value: Any) -> str:
    """Return the word whose meaning is the value, the sign of a quaternion aside; require that there is one."""
    found = np.asarray(value, float)
    signs = (1, -1) if "quaternion" in column else (1,)

    def means(meant: np.ndarray) -> bool:
        # entries are near 1 and far from singular angles: errors of some 1e-15
        return any(np.allclose(sign * found, meant, rtol=0, atol=1e-12) for sign in signs)

    fits = [name for name, meant in WORDS[column].items() if means(meant)]
    assert len(fits) == 1, f"{column}: {found} has the meaning of {fits or 'no word'}"
    return fits[0]


def of_dualcay() -> Row:
    from dualcay import cayley2, exponential, matrix6, rotation

    v, a, b = exponential.from_pose(T), rotation.cayley2.from_tensor(Q), rotation.cayley2.from_tensor(D[:3, :3])
    return {
        "quaternion": ("rotation.cayley2.quaternion", rotation.cayley2.quaternion(a)),
        "matrix": ("rotation.cayley2.tensor", rotation.cayley2.tensor(MRP)),
        "product": ("rotation.cayley2.compose(a, b)", rotation.cayley2.tensor(rotation.cayley2.compose(a, b))),
        "MRP": ("rotation.cayley2.from_tensor", a),
        "6-vector": ("exponential.from_pose", v),
        "6x6 matrix": ("exponential.adjoint", exponential.adjoint(v)),
        "dual quaternion": ("cayley2.quaternion", cayley2.quaternion(cayley2.from_pose(T))),
        "step δ": ("exponential.retract", exponential.pose(exponential.retract(v, STEP))),
        "Jacobian of exp": ("exponential.tangent", matrix6(exponential.tangent(v))),
    }


def of_scipy() -> Row:
    from scipy.spatial.transform import RigidTransform, Rotation

    a, b, pose = Rotation.from_matrix(Q), Rotation.from_matrix(D[:3, :3]), RigidTransform.from_matrix(T)
    return {
        "quaternion": ("as_quat", a.as_quat()),
        "matrix": ("as_matrix", Rotation.from_rotvec(XI[:3]).as_matrix()),
        "product": ("a * b", (a * b).as_matrix()),
        "MRP": ("as_mrp", a.as_mrp()),
        "6-vector": ("as_exp_coords", pose.as_exp_coords()),
        "dual quaternion": ("as_dual_quat", pose.as_dual_quat()),
    }


def of_pytransform3d() -> Row:
    return {
        "quaternion": ("quaternion_from_matrix", rotations.quaternion_from_matrix(Q)),
        "matrix": ("matrix_from_compact_axis_angle", rotations.matrix_from_compact_axis_angle(XI[:3])),
        "product": ("concat(a, b)", transformations.concat(T, D)[:3, :3]),
        "MRP": ("mrp_from_quaternion", rotations.mrp_from_quaternion(REAL)),
        "6-vector": (
            "exponential_coordinates_from_transform",
            transformations.exponential_coordinates_from_transform(T),
        ),
        "6x6 matrix": ("adjoint_from_transform", transformations.adjoint_from_transform(T)),
        "dual quaternion": ("dual_quaternion_from_transform", transformations.dual_quaternion_from_transform(T)),
        "Jacobian of exp": ("left_jacobian_SE3", transformations.left_jacobian_SE3(XI)),
    }


def of_pinocchio() -> Row:
    pinocchio = pytest.importorskip("pinocchio")
    pose, model = pinocchio.SE3(T), pinocchio.Model()
    model.addJoint(0, pinocchio.JointModelFreeFlyer(), pinocchio.SE3.Identity(), "body")
    stepped = pinocchio.integrate(model, pinocchio.SE3ToXYZQUAT(pose), STEP[HALVES])
    return {
        "quaternion": ("SE3ToXYZQUAT", pinocchio.SE3ToXYZQUAT(pose)[3:]),
        "matrix": ("exp3", pinocchio.exp3(XI[:3])),
        "product": ("a * b", (pose * pinocchio.SE3(D)).rotation),
        "6-vector": ("log6", pinocchio.log6(pose).vector),
        "6x6 matrix": ("SE3.action", pose.action),
        "step δ": ("integrate", pinocchio.XYZQUATToSE3(stepped).homogeneous),
        "Jacobian of exp": ("Jexp6", halves(pinocchio.Jexp6(XI[HALVES]))),
    }


def of_gtsam() -> Row:
    gtsam = pytest.importorskip("gtsam")
    pose = gtsam.Pose3(T)
    return {
        "quaternion": ("Rot3.Quaternion", gtsam.Rot3.Quaternion(*REAL).toQuaternion().coeffs()[[3, 0, 1, 2]]),
        "matrix": ("Rot3.Expmap", gtsam.Rot3.Expmap(XI[:3]).matrix()),
        "product": ("a * b", (gtsam.Rot3(Q) * gtsam.Rot3(D[:3, :3])).matrix()),
        "6-vector": ("Pose3.Logmap", gtsam.Pose3.Logmap(pose)),
        "6x6 matrix": ("Pose3.AdjointMap", pose.AdjointMap()),
        "step δ": ("retract", pose.retract(STEP).matrix()),
        "Jacobian of exp": ("Pose3.ExpmapDerivative", gtsam.Pose3.ExpmapDerivative(XI)),
    }


def of_jaxlie() -> Row:
    with jax.enable_x64(True):
        pose = jaxlie.SE3.from_matrix(T)
        return {
            "quaternion": ("SO3.wxyz", np.asarray(pose.rotation().wxyz)),
            "matrix": ("SO3.exp", np.asarray(jaxlie.SO3.exp(XI[:3]).as_matrix())),
            "product": ("a @ b", np.asarray((pose @ jaxlie.SE3.from_matrix(D)).as_matrix())[:3, :3]),
            "6-vector": ("SE3.log", np.asarray(pose.log())),
            "6x6 matrix": ("SE3.adjoint", np.asarray(pose.adjoint())),
            "step δ": ("manifold.rplus", np.asarray(jaxlie.manifold.rplus(pose, STEP[HALVES]).as_matrix())),
            "Jacobian of exp": ("SE3.jlog", halves(pose.jlog())),
        }


def of_basilisk() -> Row:
    kinematics = pytest.importorskip("Basilisk.utilities.RigidBodyKinematics")
    both = kinematics.addMRP(MRP, MRP_STEP)
    return {
        "quaternion": ("MRP2EP", kinematics.MRP2EP(MRP)),
        "matrix": ("MRP2C", kinematics.MRP2C(MRP)),
        "product": ("addMRP(a, b)", np.asarray(kinematics.MRP2C(both)).T),
        "MRP": ("C2MRP", kinematics.C2MRP(Q.T)),
    }


LIBRARIES: dict[str, Callable[[], Row]] = {
    "dualcay": of_dualcay,
    "SciPy": of_scipy,
    "pytransform3d": of_pytransform3d,
    "Pinocchio": of_pinocchio,
    "GTSAM": of_gtsam,
    "jaxlie": of_jaxlie,
    "Basilisk": of_basilisk,
}
STATED = {"ROS"}  # rows of definitions without a library to call


def tables(corner: str) -> dict[str, dict[str, str]]:
    """Return the cells of the page by library and column, without dashes, of all tables with this first heading."""
    cells: dict[str, dict[str, str]] = {}
    header: list[str] = []
    for line in (pages.ROOT / "docs/explanation/ambiguities.md").read_text(encoding="utf-8").splitlines():
        row = [cell.strip() for cell in line.strip("|").split("|")] if line.startswith("|") else []
        if not row:
            header = []
        elif not header:
            header = row
        elif header[0] == corner and not row[0].startswith("-"):
            found = zip(header[1:], row[1:], strict=True)
            cells.setdefault(row[0], {}).update({column: cell for column, cell in found if cell != "–"})
    return cells


@pytest.mark.parametrize(
    "library", [pytest.param(name, marks=pytest.mark.thorough if name == "jaxlie" else ()) for name in LIBRARIES]
)
def test_page_says_what_the_library_does(library: str) -> None:
    row = LIBRARIES[library]()
    assert tables("library")[library] == {column: word(column, value) for column, (_, value) in row.items()}
    assert tables("function in")[library] == {column: f"`{call}`" for column, (call, _) in row.items()}


def test_every_row_is_tested_or_stated() -> None:
    for corner in ("library", "function in"):
        assert tables(corner).keys() == LIBRARIES.keys() | STATED
        assert {column for row in tables(corner).values() for column in row} == WORDS.keys()


def test_a_value_has_one_word_or_none() -> None:
    assert word("matrix", Q.T) == "space to body"
    assert word("quaternion", -REAL) == "scalar first"
    for column, value in (("matrix", 2 * Q), ("MRP", XI[:3]), ("Jacobian of exp", halves(left(XI)))):
        with pytest.raises(AssertionError, match="no word"):
            word(column, value)


def test_quaternions_of_pytransform3d_multiply_in_the_other_order() -> None:
    a, b = rotations.quaternion_from_matrix(Q), rotations.quaternion_from_matrix(D[:3, :3])
    assert word("product", rotations.matrix_from_quaternion(rotations.concatenate_quaternions(a, b))) == "R(a) R(b)"
