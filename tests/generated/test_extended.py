"""Poses with velocity: laws of SE_k(3) for every function, in every chart."""

from __future__ import annotations

import importlib
import inspect
import pickle
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm

import derive
import dualcay
from dualcay import extended, rotation
from dualcay.extended import ExtendedKernels
from tests.support import examples, packages, sampling

CHARTS = [name for name in dir(extended) if name != "ExtendedKernels"]
METHODS = {name: f for name, f in inspect.getmembers(ExtendedKernels, inspect.isfunction) if not name.startswith("_")}
FUNCTIONS = {name: f.__code__.co_varnames[1 : f.__code__.co_argcount] for name, f in METHODS.items()}
FUNCTIONS.pop("identity")
SHAPES = ((), (4,), (2, 3), (25,), (0,))

COMPLEX_STEP = 1e-30
"""Step along the imaginary axis; its square, the truncation error, is below the smallest rounding error."""

STEP, ERROR = 1e-3, 1e-9
"""Step h of differences of fourth order, and their relative error: h⁴/30 of a fifth derivative below 10⁴ first ones."""


@pytest.fixture(params=CHARTS)
def chart(request: pytest.FixtureRequest) -> Any:
    """Provide the functions of each chart."""
    return getattr(extended, request.param)


def drawn(chart: Any, name: str, shape: tuple[int, ...] = (), k: int = 2) -> np.ndarray:
    """Return a random argument of a function; two have a product by less than half a turn."""
    rng = sampling.generator(repr(chart), name, shape, k)
    if name == "T":
        return chart.pose(drawn(chart, "v", shape, k))
    if name not in ("v", "v1", "v2"):
        return 0.3 * rng.normal(size=(*shape, 3 + 3 * k))
    poses = chart.poses.random((*shape, k), max_angle=1.0, rng=rng)
    return np.concatenate([poses[..., 0, :3], poses[..., 3:].reshape(*shape, 3 * k)], axis=-1)


def given(chart: Any, function: str, shape: tuple[int, ...], k: int = 2) -> list[np.ndarray]:
    return [drawn(chart, name, shape, k) for name in FUNCTIONS[function]]


def several(found: Any) -> Sequence[np.ndarray]:
    return found if isinstance(found, tuple) else (found,)


def hat(w: np.ndarray) -> np.ndarray:
    """Return the matrix of the algebra of a twist."""
    k = w.shape[-1] // 3 - 1
    found = np.zeros((*w.shape[:-1], 3 + k, 3 + k))
    found[..., :3, :3] = np.cross(w[..., None, :3], np.eye(3)).swapaxes(-1, -2)
    found[..., :3, 3:] = w[..., 3:].reshape(*w.shape[:-1], k, 3).swapaxes(-1, -2)
    return found


def close(found: np.ndarray, expected: np.ndarray) -> None:
    """Require equal arrays up to four roundings of numbers below 8, magnified by up to 1/cos²(1.2) = 8."""
    np.testing.assert_allclose(found, expected, rtol=0, atol=256 * np.finfo(float).eps)


@pytest.mark.parametrize("k", [1, 2, 3])
def test_each_dual_part_has_the_bits_of_the_pose(chart: Any, k: int) -> None:
    for number, name in enumerate(FUNCTIONS):
        shape = SHAPES[number % len(SHAPES)]
        arguments = given(chart, name, shape, k)
        read, written = (1, 3) if name == "from_pose" else (3, 1 if name == "pose" else 3)
        for part in range(k):
            at = {width: [0, 1, 2, *range(3 + width * part, 3 + width * (part + 1))] for width in (1, 3)}
            mine = [a[..., at[1], :][..., at[1]] if read == 1 else a[..., at[3]] for a in arguments]
            poses = several(getattr(chart.poses, name)(*mine))
            for found, pose in zip(several(getattr(chart, name)(*arguments)), poses, strict=True):
                one = dualcay.matrix6(pose) if "tangent" in name else pose
                axes, size = found.ndim - len(shape), 3 + written * k
                assert found.shape == (*shape, *(size,) * axes), name
                rows = found[..., at[written], :] if axes == 2 else found
                assert np.array_equal(rows[..., at[written]], one), name
                assert axes == 1 or not np.delete(rows[..., 3:, :], at[written], axis=-1).any(), name


def test_components_may_come_first_and_results_go_to_an_array(chart: Any) -> None:
    for name in FUNCTIONS:
        arguments = given(chart, name, (2, 3))
        first = [np.moveaxis(a, (0, 1), (-2, -1)) for a in arguments]
        last = several(getattr(chart, name)(*arguments))
        for one, other in zip(several(getattr(chart, name)(*first, axis=0)), last, strict=True):
            close(np.moveaxis(one, (-2, -1), (0, 1)), other)
        if not name.endswith("_jacobians"):
            out = arguments[0] if last[0].shape == arguments[0].shape else np.empty_like(last[0])
            assert getattr(chart, name)(*arguments, out=out) is out
            assert np.array_equal(out, last[0]), name


@pytest.mark.parametrize("k", [1, 2, 4])
def test_products_are_those_of_matrices(chart: Any, k: int) -> None:
    v, w, step = (drawn(chart, name, (25,), k) for name in ("v", "v2", "delta"))
    X, Y, E = chart.pose(v), chart.pose(w), np.array([expm(one) for one in hat(step)])
    close(chart.pose(chart.compose(w, v)), Y @ X)
    close(chart.pose(chart.between(w, v)), np.linalg.inv(X) @ Y)
    close(chart.pose(chart.inverse(v)) @ X, np.broadcast_to(np.eye(3 + k), X.shape))
    close(chart.from_pose(X, check=True), chart.compose(v, chart.identity(k=k)))
    close(chart.pose(chart.from_exponential(step)), E)
    close(chart.to_exponential(chart.from_exponential(step)), step)
    close(chart.pose(chart.retract(v, step)), E @ X)
    close(chart.pose(chart.body_retract(v, step)), X @ E)
    close(chart.local(chart.retract(v, step), v), step)
    close(chart.body_local(chart.body_retract(v, step), v), step)
    close(hat(np.einsum("nij,nj->ni", chart.adjoint(v), step)), X @ hat(step) @ np.linalg.inv(X))


def test_twists_are_those_of_moving_matrices(chart: Any) -> None:
    v, v_dot = given(chart, "twist", (25,))
    X, X_dot = chart.pose(v), chart.pose(v + 1j * COMPLEX_STEP * v_dot).imag / COMPLEX_STEP
    for frame, moved in (("", X_dot @ np.linalg.inv(X)), ("body_", np.linalg.inv(X) @ X_dot)):
        twist = getattr(chart, f"{frame}twist")(v, v_dot)
        close(hat(twist), moved)
        close(getattr(chart, f"{frame}rate")(v, twist), v_dot)
        T, T_inv = (getattr(chart, f"{frame}{name}")(v) for name in ("tangent", "tangent_inv"))
        close(np.einsum("nij,nj->ni", T, v_dot), twist)
        close(T_inv @ T, np.broadcast_to(np.eye(9), T.shape))


@pytest.mark.parametrize("name", [name for name in FUNCTIONS if "_jacobian" in name])
def test_jacobians_equal_complex_steps_or_differences(chart: Any, name: str) -> None:
    function, arguments = getattr(chart, name.partition("_jacobian")[0]), given(chart, name, (10, 1))
    for place, found in enumerate(several(getattr(chart, name)(*arguments))):

        def moved(step: np.ndarray, place: int = place) -> Any:
            return function(*(a + step if i == place else a for i, a in enumerate(arguments)))

        if name.endswith("_jacobians"):  # these choose branches, which complex numbers do not have
            near, back, far, far_back = (moved(h * STEP * np.eye(9)) for h in (1, -1, 2, -2))
            slopes = (8 * (near - back) - (far - far_back)) / (12 * STEP)
            assert abs(found[:, 0] - slopes.swapaxes(-1, -2)).max() <= ERROR * abs(slopes).max()
        else:
            close(found[:, 0], moved(1j * COMPLEX_STEP * np.eye(9)).imag.swapaxes(-1, -2) / COMPLEX_STEP)


def test_wrong_arguments_are_refused_by_name() -> None:
    chart, galilean = extended.cayley2, np.eye(5) + np.diag([0, 0, 0, 0.1], k=1)
    for wrong in (np.zeros(7), np.zeros((9, 2)), np.zeros(3), 1.0):
        with pytest.raises(ValueError, match=r"v must have shape \(\.\.\., 3 \+ 3k\) with k >= 1, got \("):
            chart.pose(wrong)
    with pytest.raises(ValueError, match=r"v must have shape \(3 \+ 3k, \.\.\.\)"):
        chart.pose(np.zeros((2, 9)), axis=0)
    with pytest.raises(ValueError, match=r"v1 must have shape \(\.\.\., 9\), got \(6,\)"):
        chart.compose(np.zeros(9), np.zeros(6))
    for wrong in (np.zeros((3, 3)), np.zeros((5, 4)), np.zeros(5)):
        with pytest.raises(ValueError, match=r"T must have shape \(\.\.\., 3 \+ k, 3 \+ k\) with k >= 1"):
            chart.from_pose(wrong)
    with pytest.raises(ValueError, match=r"T is no matrix of SE_2\(3\): its last rows are not \[0, I\], off by 0.1"):
        chart.from_pose(galilean, check=True)
    with pytest.raises(TypeError, match="poses must be a kernel module of poses, as cayley3 is"):
        ExtendedKernels(rotation.cayley2)
    with pytest.raises(AttributeError, match="dualcay generate -n 6 -o FOLDER"):
        extended.cayley6  # noqa: B018


def test_every_chart_is_found_once_and_survives_pickle(tmp_path: Path) -> None:
    for name in CHARTS:
        assert pickle.loads(pickle.dumps(getattr(extended, name))) is getattr(extended, name)
    own = packages.imported(derive.Cayley(1), tmp_path)
    theirs = importlib.import_module(f"{own.__package__}.extended").cayley1
    assert np.array_equal(theirs.pose(np.arange(9) / 10)[:4, :4], own.pose(np.arange(6) / 10))


def test_examples_in_docstrings_hold() -> None:
    assert examples.of_docstrings(METHODS.values()) == ""
