"""Files of TUM, KITTI, EuRoC and g2o: compared with SciPy, round trips to the last bit, errors with their line."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import fields, replace
from io import StringIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import RigidTransform, Rotation

from dualcay import cayley2, cayley3, exponential, interop, rotation
from dualcay.interop import PoseGraph

CHARTS = (cayley2, cayley3, exponential)
LABELS = {"ids": lambda one: one.__name__}
RNG = np.random.default_rng(5)
XYZ, XYZW = RNG.normal(size=(4, 3)), Rotation.random(4, rng=RNG).as_quat()
POSES = RigidTransform.from_components(XYZ, Rotation.from_quat(XYZW)).as_matrix()
TIMES = 1403636580.838555648 + np.arange(4)
WXYZ = XYZW[:, [3, 0, 1, 2]]


def text_of(*columns: Any, separator: str = " ", form: Callable[[float], str] = repr) -> str:
    """Return rows of numbers as lines."""
    return "".join(separator.join(map(form, row)) + "\n" for row in np.column_stack(columns).tolist())


def written(write: Callable[..., None], module: Any, *given: Any, **options: Any) -> str:
    stream = StringIO()
    write(module, stream, *given, **options)
    return stream.getvalue()


def table(text: str) -> np.ndarray:
    return np.array([line.split() for line in text.splitlines()], float)


@pytest.mark.parametrize("module", CHARTS, **LABELS)
def test_poses_read_are_those_of_scipy(module: Any) -> None:
    t, v = interop.read_tum(module, StringIO(f"# time\n\n{text_of(TIMES, XYZ, XYZW)}"))
    np.testing.assert_array_equal(t, TIMES)
    np.testing.assert_allclose(module.pose(v), POSES, rtol=0, atol=1e-14)
    v = interop.read_kitti(module, StringIO(text_of(POSES[:, :3].reshape(4, 12))))
    np.testing.assert_allclose(module.pose(v), POSES, rtol=0, atol=1e-14)
    ns = [1403636580838555648 + 7 * k for k in range(4)]
    lines = text_of(XYZ, WXYZ, np.zeros((4, 9)), separator=",").splitlines()
    csv = "\n".join(["#timestamp, p_x", *(f"{one},{line}" for one, line in zip(ns, lines, strict=True))])
    found, v = interop.read_euroc(module, StringIO(csv))
    assert found.dtype == np.int64
    assert found.tolist() == ns
    np.testing.assert_allclose(module.pose(v), POSES, rtol=0, atol=1e-14)


@pytest.mark.parametrize("module", CHARTS, **LABELS)
def test_round_trips_keep_every_bit(module: Any, tmp_path: Path) -> None:
    """Numbers of the file are those of `to_ros` and `pose`, and what is read is what these give."""
    v, file = module.from_pose(POSES), tmp_path / "poses.txt"
    interop.write_tum(module, file, TIMES, v)
    np.testing.assert_array_equal(table(file.read_text()), np.column_stack([TIMES, *interop.to_ros(module, v)]))
    t, back = interop.read_tum(module, file)
    np.testing.assert_array_equal(t, TIMES)
    np.testing.assert_array_equal(back, interop.from_ros(module, *interop.to_ros(module, v)))
    interop.write_kitti(module, str(file), v)
    np.testing.assert_array_equal(table(file.read_text()), module.pose(v)[:, :3].reshape(4, 12))
    np.testing.assert_array_equal(interop.read_kitti(module, file), module.from_pose(module.pose(v)))
    assert written(interop.write_tum, module, [], np.empty((0, 6))) == ""
    assert interop.read_tum(module, StringIO(""))[1].shape == interop.read_kitti(module, StringIO("")).shape == (0, 6)


@pytest.mark.parametrize("digits", range(4, 10))
def test_rounded_numbers_are_read_and_their_violation_is_told(digits: int) -> None:
    form = f"{{:.{digits}f}}".format
    files = (
        (interop.read_tum, text_of(XYZ[:, 0], XYZ, XYZW, form=form), "unit quaternion"),
        (interop.read_kitti, text_of(POSES[:, :3].reshape(4, 12), form=form), "homogeneous matrix"),
    )
    for read, text, noun in files:
        found = read(cayley2, StringIO(text))
        v = found[1] if isinstance(found, tuple) else found
        np.testing.assert_allclose(cayley2.pose(v), POSES, rtol=0, atol=5 * 10.0**-digits)
        with pytest.raises(ValueError, match=rf"^file:[1-4]: .* is no {noun}.* off by \d.* \(allowed 1e-12\)$"):
            read(cayley2, StringIO(text), check=1e-12)


def made() -> PoseGraph:
    """Return four poses on a loop, whose motions are off by small steps; the third pose has the greatest number."""
    v = cayley2.from_pose(POSES)
    edges = np.array([[0, 1], [1, 2], [2, 3], [3, 0]])
    motions = cayley2.body_retract(cayley2.between(v[edges[:, 1]], v[edges[:, 0]]), 1e-5 * RNG.normal(size=(4, 6)))
    information = np.einsum("kij,klj->kil", *2 * [RNG.normal(size=(4, 6, 6))])
    return PoseGraph(np.array([2, 0, 17, 3]), v, edges, motions, information, np.array([2]))


@pytest.mark.parametrize("convention", ["g2o", "gtsam"])
def test_graphs_round_trip_to_the_last_bit(convention: str) -> None:
    text = written(interop.write_g2o, cayley2, GRAPH, convention=convention)
    read = interop.read_g2o(cayley2, StringIO(text), convention=convention)
    for field in fields(PoseGraph):
        given, found = (getattr(one, field.name) for one in (GRAPH, read))
        if field.name in ("v", "motions"):
            given = interop.from_ros(cayley2, *interop.to_ros(cayley2, given))
        np.testing.assert_array_equal(found, given)


def test_cost_of_a_graph_is_that_of_g2o() -> None:
    """Half of e·Ω e, where e is the translation and the vector part of the quaternion of Z⁻¹ X1⁻¹ X2, by SciPy."""
    text, costs = written(interop.write_g2o, cayley2, GRAPH), []
    lines = [line.split() for line in text.splitlines() if not line.startswith("FIX")]
    numbers = {tuple(line[1 : 2 + line[0].startswith("EDGE")]): np.array(line[-7 - 21 * (line[0][0] == "E") :], float)
               for line in lines}  # fmt: skip
    pose = {name: RigidTransform.from_components(n[:3], Rotation.from_quat(n[3:7])) for name, n in numbers.items()}
    for name, z in pose.items():
        if len(name) == 2:
            off = z.inv() * pose[name[:1]].inv() * pose[name[1:]]
            error = np.concatenate([off.translation, off.rotation.as_quat(canonical=True)[:3]])
            omega = np.zeros((6, 6))
            omega[np.triu_indices(6)] = numbers[name][7:]
            costs.append(error @ (omega + np.triu(omega, 1).T) @ error)
    read = interop.read_g2o(cayley2, StringIO(text))
    x1, x2 = read.v[read.edges.T]
    r = cayley2.body_local(cayley2.between(x2, x1), read.motions)
    np.testing.assert_allclose(np.einsum("ki,kij,kj->k", r, read.information, r), costs, rtol=1e-4)


GRAPH = made()
UNIT = "0 0 0 0 0 0 1"
WRONG = (
    (interop.read_tum, "0 1 2 3 0 0 1", "expected 8 numbers (timestamp tx ty tz qx qy qz qw), got 7"),
    (interop.read_tum, f"0 {UNIT} 9", "expected 8 numbers"),
    (interop.read_tum, "0 1 2 x 0 0 0 1", "tz must be a finite number, got 'x'"),
    (interop.read_tum, "nan 1 2 3 0 0 0 1", "timestamp must be a finite number, got 'nan'"),
    (interop.read_tum, "0 1 2 3 0 0 0 1.001", "qx qy qz qw is no unit quaternion: its square is not 1, off by 0.002"),
    (interop.read_tum, "0 1 2 3 0 0 0 0", "off by 1 (allowed 0.001)"),
    (interop.read_kitti, "1 0 0 1 0 1 0 2 0 0 1", "expected 12 numbers (r11 r12 r13 tx r21"),
    (interop.read_kitti, "1 0 0 1 0 -1 0 2 0 0 1 3", "det Q is not 1, off by 2"),
    (interop.read_euroc, "1.5,1,2,3,1,0,0,0", "timestamp must be a whole number of 64 bits, got '1.5'"),
    (interop.read_euroc, f"{10**20},1,2,3,1,0,0,0", "timestamp must be a whole number of 64 bits"),
    (interop.read_euroc, "1,5,,0,0,1,0,0,0", "py must be a finite number, got ''"),
    (interop.read_euroc, "1,1,2,3,2,0,0,0", "qw qx qy qz is no unit quaternion"),
    (interop.read_g2o, f"VERTEX_SE3:QUAT 4 {UNIT}\nEDGE_SE3:QUAT 4 4 {UNIT} {'1 ' * 6}-2{' 1' * 14}",
     "i22 on the diagonal must not be negative, got -2"),
    (interop.read_euroc, "1,1,2,3,1,0,0", "expected 7 numbers (px py pz qw qx qy qz), got 6"),
    (interop.read_g2o, "VERTEX_SE2 0 0 0 0", "expected VERTEX_SE3:QUAT, EDGE_SE3:QUAT, FIX, got 'VERTEX_SE2'"),
    (interop.read_g2o, f"VERTEX_SE3:QUAT {UNIT}", "expected 7 numbers (tx ty tz qx qy qz qw), got 6"),
    (interop.read_g2o, f"VERTEX_SE3:QUAT a {UNIT}", "id must be a whole number of 64 bits, got 'a'"),
    (interop.read_g2o, f"EDGE_SE3:QUAT 0 1 {UNIT} 1 2", "expected 28 numbers (tx ty tz qx qy qz qw i11 i12"),
    (interop.read_g2o, "FIX 4", "expected the id of a VERTEX_SE3:QUAT, got 4"),
    (interop.read_g2o, f"VERTEX_SE3:QUAT 4 {UNIT}\nVERTEX_SE3:QUAT 4 {UNIT}", "expected another id, got 4 again"),
    (interop.read_g2o, "VERTEX_SE3:QUAT 0 0 0 0 1 0 0 1", "off by 1 (allowed 0.001)"),
)  # fmt: skip


@pytest.mark.parametrize(("read", "text", "message"), WRONG)
def test_a_wrong_line_is_named(read: Callable[..., Any], text: str, message: str, tmp_path: Path) -> None:
    file = tmp_path / "poses.txt"
    file.write_text(f"# poses\n{text}\n", encoding="utf-8")
    with pytest.raises(ValueError, match=rf"poses\.txt:{text.count(chr(10)) + 2}: .*{re.escape(message)}"):
        read(cayley2, file)


def test_nothing_is_written_of_wrong_poses(tmp_path: Path) -> None:
    file, v = tmp_path / "poses.txt", np.zeros((3, 6))
    v[2, 0] = np.nan
    with pytest.raises(ValueError, match="v must be finite, got nan in row 2"):
        interop.write_tum(cayley2, file, [0, 1, 2], v)
    for one in (np.zeros(6), 3.0):
        with pytest.raises(ValueError, match=r"v must have shape \(T, 6\), a row for each pose, got \("):
            interop.write_kitti(cayley2, file, one)
    with pytest.raises(ValueError, match=r"times t \(T,\), then vectors v \(T, 6\), got \(3, 6\), then \(3,\)"):
        interop.write_tum(cayley2, file, v, [0, 1, 2])
    with pytest.raises(TypeError, match="file must be a path or a text file, got 5"):
        interop.write_kitti(cayley2, 5, v[:2])
    with pytest.raises(TypeError, match="graph must be a PoseGraph, got ndarray"):
        interop.write_g2o(cayley2, file, v)
    with pytest.raises(ValueError, match=r"^information\[1, 0, 0\] on the diagonal must not be negative, got -1$"):
        interop.write_g2o(cayley2, file, replace(GRAPH, information=[np.eye(6), np.diag([-1, 1, 1, 1, 1, 1])] * 2))
    with pytest.raises(ValueError, match=r"t must have shape \(2,\), got \(3,\)"):
        interop.write_tum(cayley2, file, [0, 1, 2], v[:2])
    with pytest.raises(TypeError, match="module must be a kernel module of poses"):
        interop.write_kitti(rotation.cayley2, file, np.zeros((1, 3)))
    with pytest.raises(ValueError, match="convention must be one of 'g2o', 'gtsam', got 'ros'"):
        interop.write_g2o(cayley2, file, GRAPH, convention="ros")
    assert not file.exists()
