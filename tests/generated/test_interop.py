"""Exchange with SciPy and ROS, compared with them, and of pose graphs with GTSAM if it is installed.

Orders of twists in other libraries are those of the tables in docs/coming_from, whose columns tests/docs compares.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from io import StringIO
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import sympy
from pytransform3d import transformations
from scipy.spatial import transform
from scipy.spatial.transform import RigidTransform, Rotation

import derive
import dualcay
from dualcay import (
    cayley1,
    cayley2,
    cayley3,
    exponential,
    interop,
    inverse_covariance,
    lambert,
    mean,
    rotation,
    scaled2,
    switch_event,
    unwrap,
)  # fmt: skip
from tests.support import traced
from tests.support.libraries import jax

POSES = (cayley1, cayley2, cayley3, exponential, lambert, scaled2)
ROTATIONS = tuple(getattr(rotation, name) for name in ("cayley1", "cayley2", "exponential"))
SHAPES = ((), (5,), (2, 3), (0,))
IDS = {"ids": lambda one: one.__name__}

V = cayley2.random(rng=0)
T = cayley2.pose(V)
TWIST = np.arange(1.0, 7.0)


def drawn(module: Any, shape: tuple[int, ...] = ()) -> np.ndarray:
    """Return vectors with angles up to 2 rad, where inverse maps magnify errors by at most 1/cos²(1) = 3.5."""
    return module.random(shape, max_angle=2.0, rng=len(shape))


def assert_same(found: Any, expected: Any) -> None:
    """Require equal shapes, and values within 64 eps: some ten roundings of numbers below 8, magnified by 3.5."""
    found, expected = np.asarray(found), np.asarray(expected)
    assert found.shape == expected.shape
    np.testing.assert_allclose(found, expected, rtol=0, atol=64 * np.finfo(float).eps)


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("module", POSES, **IDS)
def test_poses_of_scipy(module: Any, shape: tuple[int, ...]) -> None:
    v = drawn(module, shape)
    there = interop.to_rigid_transform(module, v)
    assert_same(there.as_matrix(), module.pose(v))
    assert_same(interop.from_rigid_transform(module, there), v)
    assert_same(interop.to_rotation(module, v).as_matrix(), module.pose(v)[..., :3, :3])
    turned = interop.from_rotation(module, interop.to_rotation(module, v))
    assert_same(turned[..., :3], v[..., :3])
    assert not turned[..., 3:].any()


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("module", ROTATIONS, **IDS)
def test_rotations_of_scipy(module: Any, shape: tuple[int, ...]) -> None:
    v = drawn(module, shape)
    there = interop.to_rotation(module, v)
    assert_same(there.as_matrix(), module.tensor(v))
    assert_same(interop.from_rotation(module, there), v)


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("module", POSES, **IDS)
def test_positions_and_quaternions_of_ros(module: Any, shape: tuple[int, ...]) -> None:
    v = drawn(module, shape)
    xyz, xyzw = interop.to_ros(module, v)
    there = RigidTransform.from_matrix(module.pose(v))
    assert_same(xyz, there.translation)
    assert_same(xyzw * np.sign(xyzw[..., 3:]), there.rotation.as_quat(canonical=True))
    assert_same(interop.from_ros(module, xyz, xyzw), v)
    assert_same(interop.from_ros(module, xyz, -xyzw, check=True), v)


def test_positions_broadcast_with_quaternions() -> None:
    xyzw = interop.to_ros(cayley3, drawn(cayley3, (4, 1)))[1]
    found = interop.from_ros(cayley3, np.arange(6).reshape(2, 3), xyzw)
    assert found.shape == (4, 2, 6)
    assert_same(cayley3.pose(found)[3, 1, :3, 3], [3, 4, 5])


@pytest.mark.parametrize("branch", [-2, -1, 1])
@pytest.mark.parametrize("module", [cayley3, exponential], **IDS)
@pytest.mark.parametrize("convert", ["rigid_transform", "rotation", "ros", "ros_message"])
def test_branches_are_those_of_the_chart(convert: str, module: Any, branch: int) -> None:
    there = getattr(interop, f"to_{convert}")(module, V)
    given = there if isinstance(there, tuple) else (there,)
    found = getattr(interop, f"from_{convert}")(module, *given, branch=branch)
    principal = getattr(interop, f"from_{convert}")(module, *given)
    assert_same(found, module.shadow(principal, branch))


@pytest.mark.parametrize(("kind", "names"), [("Pose", "position orientation"), ("Transform", "translation rotation")])
def test_messages_of_ros(kind: str, names: str) -> None:
    fields = interop.to_ros_message(cayley2, V, kind)
    assert list(fields) == names.split()
    assert all(type(number) is float for part in fields.values() for number in part.values())
    message = SimpleNamespace(**{name: SimpleNamespace(**part) for name, part in fields.items()})
    for one in (fields, message, SimpleNamespace(**fields)):
        assert_same(interop.from_ros_message(cayley2, one), V)
    xyz, xyzw = ([*part.values()] for part in fields.values())
    assert_same(transformations.transform_from_pq([*xyz, xyzw[3], *xyzw[:3]]), T)


@pytest.mark.parametrize("name", ["pose3example.txt", "pose3example-offdiagonal.txt"])
def test_cost_of_a_pose_graph_is_that_of_gtsam(name: str) -> None:
    """Read a file of GTSAM's own, and compare half r·Ω r."""
    gtsam = pytest.importorskip("gtsam", reason="GTSAM is not installed")
    path = gtsam.findExampleDataFile(name)
    read = interop.read_g2o(cayley2, path, convention="gtsam")
    x1, x2 = read.v[read.edges.T]
    r = cayley2.body_local(cayley2.between(x2, x1), read.motions)
    cost = np.einsum("ki,kij,kj", r, read.information, r) / 2
    graph, values = gtsam.readG2o(path, True)
    assert cost == pytest.approx(graph.error(values), rel=1e-9)


def test_orders_and_cayley_vectors_run_under_jit_of_jax() -> None:
    with jax.enable_x64(True):
        for convert in (interop.to_linear_angular, interop.from_cayley_4x4, interop.to_cayley_4x4):
            assert_same(traced.run(convert, TWIST), convert(TWIST))
        adjoint = cayley2.adjoint(V)
        assert_same(traced.run(interop.to_linear_angular_matrix, adjoint), interop.to_linear_angular_matrix(adjoint))
        assert isinstance(interop.to_linear_angular(jax.numpy.zeros(6)), jax.Array)


def test_covariances_keep_their_correlations() -> None:
    P = np.arange(36.0).reshape(6, 6)
    swapped = interop.to_linear_angular_matrix(np.stack([P, P.T]))
    assert (swapped[0, 0, 4], swapped[1, 0, 4]) == (P[3, 1], P[1, 3])
    np.testing.assert_array_equal(interop.from_linear_angular_matrix(swapped), [P, P.T])


def matrix_cayley(real: list[Any], translation: list[Any], order: int, scale: Any) -> sympy.Matrix:
    """Return the Cayley map of 4x4 matrices, from its definition, in exact arithmetic."""
    (x, y, z), (a, b, c) = ([sympy.sympify(part) / scale for part in half] for half in (real, translation))
    A, unit = sympy.Matrix([[0, -z, y, a], [z, 0, -x, b], [-y, x, 0, c], [0, 0, 0, 0]]), sympy.eye(4)
    return ((unit - A).inv() * (unit + A)) ** order


@pytest.mark.parametrize(
    ("name", "order", "scale"),
    [
        ("cayley3", 3, 1), ("scaled1", 1, 2),
        *(pytest.param(f"cayley{n}", n, 1, marks=pytest.mark.thorough) for n in (1, 2, 4, 5)),
    ],
)  # fmt: skip
def test_cayley_vectors_of_4x4_matrices_as_identity(name: str, order: int, scale: int) -> None:
    """Decide the equality as rational functions; both maps turn with the frame, so the third axis may lie along v."""
    r, a, b, c = sympy.symbols("r a b c")
    v = [0, 0, r, a, b, c]
    chart = derive.family(name) if scale > 1 else derive.Cayley(order)
    re, du = chart.tensor.matrix(v)
    moment = du * re.T
    pose = sympy.eye(4)
    pose[:3, :3], pose[:3, 3] = re, sympy.Matrix([moment[2, 1], moment[0, 2], moment[1, 0]])
    vector = list(interop.to_cayley_4x4(np.array(v, object), scale))
    found = matrix_cayley(vector[:3], vector[3:], order, scale) - pose
    assert all(sympy.cancel(entry) == 0 for entry in found)
    back = interop.from_cayley_4x4(np.array(vector, object), scale)
    assert all(sympy.cancel(one - other) == 0 for one, other in zip(back, v, strict=True))
    control = matrix_cayley(v[:3], v[3:], order, scale) - pose
    assert any(sympy.cancel(entry) != 0 for entry in control)


def test_cayley_vectors_of_4x4_matrices_off_the_axes() -> None:
    v = [sympy.Rational(k, 7) for k in (1, -2, 3, 5, 4, -6)]
    vector = list(interop.to_cayley_4x4(np.array(v, object)))
    found = np.array(matrix_cayley(vector[:3], vector[3:], 3, 1).tolist(), float)
    assert_same(found, cayley3.pose(np.array(v, float)))
    batch = drawn(cayley2, (2, 3))
    assert_same(interop.from_cayley_4x4(interop.to_cayley_4x4(batch, 0.5), 0.5), batch)


TURN, NO_POSES = rotation.cayley2, "must be a kernel module of poses, as cayley2 is, got "
REFUSED: tuple[tuple[Callable[..., object], tuple[Any, ...], type[Exception], str], ...] = (
    (interop.to_rigid_transform, (TURN, np.zeros(3)), TypeError, NO_POSES),
    (interop.from_rigid_transform, (TURN, None), TypeError, NO_POSES),
    (interop.to_ros, (TURN, np.zeros(3)), TypeError, NO_POSES),
    (interop.from_ros, (TURN, np.zeros(3), np.ones(4)), TypeError, NO_POSES),
    (interop.from_ros, (cayley2, np.zeros(4), np.ones(4)), ValueError, r"xyz must have shape (..., 3), got (4,)"),
    (interop.from_ros, (cayley2, np.zeros(3), 1.0), ValueError, r"xyzw must have shape (..., 4), got ()"),
    (interop.to_ros_message, (cayley2, V, "Twist"), ValueError, "kind must be one of 'Pose', 'Transform', got 'Twist'"),
    (interop.to_ros_message, (cayley2, [V, V]), ValueError, "v must have shape (6,), since a message holds one pose"),
    (interop.from_ros_message, (cayley2, {"position": {}}), TypeError, "must be a Pose (position, orientation) or "),
    (interop.to_linear_angular, ([0] * 3,), ValueError, "twist must have shape (..., 6), got (3,)"),
    (interop.to_linear_angular_matrix, (np.eye(5),), ValueError, "matrix must have shape (..., 6, 6), got (5, 5)"),
    (interop.to_cayley_4x4, ([0] * 3,), ValueError, "v must have shape (..., 6), got (3,)"),
    (interop.from_cayley_4x4, ([0] * 3,), ValueError, "vector must have shape (..., 6), got (3,)"),
)


CHARTS_FIRST = (
    *(partial(getattr(interop, name), file=StringIO()) for name in interop.__all__ if name.startswith("read_")),
    *(partial(getattr(interop, name), v=V) for name in ("to_rotation", "to_rigid_transform", "to_ros")),
    partial(interop.from_rotation, rotation=Rotation.identity()), partial(unwrap, v=V), partial(mean, v=V),
    partial(inverse_covariance, v=V, covariance=np.eye(6)), switch_event,
)  # fmt: skip


@pytest.mark.parametrize("module", [np, rotation, "cayley2"])
def test_what_is_no_chart_is_named(module: Any) -> None:
    for function in CHARTS_FIRST:
        with pytest.raises(TypeError, match=r"^module must be a kernel module.*, as cayley2 is, got "):
            function(module)


@pytest.mark.parametrize(("function", "given", "error", "message"), REFUSED)
def test_wrong_arguments_are_refused(
    function: Callable[..., object], given: tuple[Any, ...], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=re.escape(message)):
        function(*given)


def test_quaternion_of_an_empty_message_is_nan_or_refused_if_checked() -> None:
    message = {"position": dict.fromkeys("xyz", 0.0), "orientation": dict.fromkeys("xyzw", 0.0)}
    assert np.isnan(interop.from_ros_message(cayley2, message)).all()
    with pytest.raises(ValueError, match=r"xyzw is no unit quaternion: its square is not 1, off by 1 \(allowed 0\.5\)"):
        interop.from_ros_message(cayley2, message, check=0.5)
    message |= {"position": {"x": 1, "y": 2, "z": 3}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 2}}
    np.testing.assert_array_equal(interop.from_ros_message(exponential, message), [0, 0, 0, 1, 2, 3])


@pytest.mark.parametrize("dtype", [np.float64, np.float32, np.longdouble])
@pytest.mark.parametrize("module", [getattr(dualcay, name) for name in dualcay._modules()], **IDS)
def test_a_position_stays_whatever_the_norm_of_the_quaternion(module: Any, dtype: Any) -> None:
    """Norms down to the least number that keeps 24 bits of the components, and up to the largest one."""
    xyz = np.array([1.0, -2.0, 3.0], dtype)
    v = drawn(exponential, (5,))
    xyzw = exponential.quaternion(v, scalar_first=False)[:, :4].astype(dtype)
    wanted, small = interop.from_ros(module, xyz, xyzw), np.finfo(dtype).tiny
    assert wanted.dtype == dtype
    for norm in (small, 1e-30, 0.3, 0.999999, 1.000001, 2.0, 1e30, np.finfo(dtype).max / 4):
        off = xyzw * dtype(norm)
        for sign in (1, -1):
            found = interop.from_ros(module, xyz, sign * off)
            np.testing.assert_allclose(found, wanted, rtol=0, atol=100 * max(np.finfo(dtype).eps, 1e-18))
        pose = module.pose(found)
        np.testing.assert_allclose(pose[:, :3, 3], np.tile(xyz, (5, 1)), rtol=0, atol=400 * np.finfo(dtype).eps)
    for wrong in (0 * xyzw, np.where(np.arange(4) == 1, np.nan, xyzw), np.where(np.arange(4) == 2, np.inf, xyzw)):
        assert np.isnan(interop.from_ros(module, xyz, wrong)).all()


def test_missing_scipy_is_an_error_that_says_how_to_install_it() -> None:
    code = (
        "import sys; sys.modules['scipy'] = None; from dualcay import cayley2, interop\n"
        "print(interop.from_ros(cayley2, [0, 0, 0], [0, 0, 0, 1])); interop.to_rotation(cayley2, cayley2.identity())"
    )
    path = str(Path(interop.__file__).parents[1])
    run = [sys.executable, "-c", code]
    done = subprocess.run(run, env={**os.environ, "PYTHONPATH": path}, capture_output=True, text=True)
    assert done.stdout == "[0. 0. 0. 0. 0. 0.]\n"
    said = 'ImportError: Rotation needs SciPy 1.16 or later: pip install "scipy>=1.16"'
    assert done.stderr.splitlines()[-1] == said


def test_old_scipy_is_an_error_that_says_which_is_needed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(transform, "RigidTransform")
    with pytest.raises(ImportError, match=r"RigidTransform needs SciPy 1\.16 or later"):
        interop.to_rigid_transform(cayley2, V)
