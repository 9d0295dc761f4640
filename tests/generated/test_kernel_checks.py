"""Keyword ``check`` of inverse maps, and quaternions with the scalar last."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import partial
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from dualcay import cayley3, interop, rotation
from tests.support import sampling
from tests.support.conditions import KERNELS, REFUSALS, assert_refused, right, way_back
from tests.support.signatures import components_first

LAST = [1, 2, 3, 0, 5, 6, 7, 4]


@pytest.mark.parametrize("axis", [-1, 0])
@pytest.mark.parametrize(("kernels", "name"), REFUSALS)
def test_check_names_the_first_wrong_element_and_its_largest_violation(kernels: str, name: str, axis: int) -> None:
    x, function = right(kernels, name, sampling.poses(3, "uniform", count=6)), way_back(KERNELS[kernels], name)
    given = components_first(x, x.ndim - 1) if axis == 0 else x
    np.testing.assert_array_equal(function(given, axis=axis, check=True), function(given, axis=axis))
    assert_refused(KERNELS[kernels], kernels, name, x[0], axis)
    with np.errstate(all="ignore"):
        assert function(0 * given, axis=axis).shape == function(given, axis=axis).shape  # refused with check only
    with pytest.raises(ValueError, match=r"off by (inf|nan) "):  # and no warning
        function(np.full_like(given, np.inf), axis=axis, check=True)


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.longdouble])
@pytest.mark.parametrize(("kernels", "name"), REFUSALS)
def test_check_tolerance_is_the_square_root_of_eps(kernels: str, name: str, dtype: Any) -> None:
    """Scale arguments by 1 + s: the square changes by 2 s, the determinant by 3 s; the last row of a pose stays."""
    step, function = np.sqrt(np.finfo(dtype).eps), way_back(KERNELS[kernels], name)
    value = right(kernels, name, sampling.poses(3, "uniform", count=4)).astype(dtype)
    scaled = (slice(None), slice(3)) if name == "from_pose" else ()
    for part, passes in ((step / 8, True), (2 * step, False)):
        off = value.copy()
        off[scaled] *= 1 + part
        if passes:
            assert function(off, check=True).dtype == dtype
        else:
            with pytest.raises(ValueError, match="is no "):
                function(off, check=True)


LIMITED: list[tuple[Callable[..., Any], tuple[Any, ...]]] = [
    (cayley3.from_pose, (np.diag([1.005, 1, 1, 1]),)),
    (cayley3.from_screw, ([0.3, 0], [1.005, 0, 0, 0, 0, 0])),
    (rotation.cayley3.from_angle_axis, (0.3, [1.005, 0, 0])),
    (partial(interop.from_ros, cayley3), ([1, 2, 3], [0, 0, 0, 1.005])),
]
"""Functions with arguments whose largest violation is 0.010025, that of the square of 1.005."""


@pytest.mark.parametrize(("function", "given"), LIMITED)
def test_check_may_be_the_largest_violation_allowed(function: Callable[..., Any], given: tuple[Any, ...]) -> None:
    unchecked = function(*given)
    for allowed in (0.0101, np.float32(0.0101), Fraction(101, 10000), 1, np.int64(1), np.inf, False, np.False_):
        np.testing.assert_array_equal(function(*given, check=allowed), unchecked)
    for refused in (0.01, np.float64(0.01), 1e-12, 0, 0.0):
        with pytest.raises(ValueError, match=rf"off by 0\.01 \(allowed {float(refused):g}\)"):
            function(*given, check=refused)
    for usual in (True, np.True_):
        with pytest.raises(ValueError, match=r"off by 0\.01 \(allowed 1\.49e-08\)"):
            function(*given, check=usual)
    for negative in (-1e-3, -1, np.nan):
        with pytest.raises(ValueError, match=f"check must be at least 0, got {negative!r}"):
            function(*given, check=negative)
    for wrong in (None, "1e-3", 1j, [0.1], np.array([0.1])):
        with pytest.raises(TypeError, match="check must be a bool or a number, the largest violation allowed, got "):
            function(*given, check=wrong)
    with pytest.raises(ValueError, match="off by nan"):
        function(*given[:-1], np.multiply(given[-1], np.nan), check=1e3)


def test_a_violation_of_the_allowed_size_passes() -> None:
    assert rotation.cayley3.from_quaternion([1.5, 0, 0, 0], check=1.25).shape == (3,)


@pytest.mark.parametrize("regime", ["translation 1e6", "angle 1e-12", "pure translation", "at pi", "identity"])
def test_rounded_poses_pass_the_check(kernel: ModuleType, order: int, regime: str) -> None:
    v = sampling.poses(order, regime if sampling.has_regime(order, regime) else "uniform", count=6)
    assert kernel.from_pose(kernel.pose(v), check=True).shape == v.shape
    assert kernel.from_tensor(kernel.tensor(v), check=True).shape == v.shape
    assert kernel.from_quaternion(kernel.quaternion(v), check=True).shape == v.shape
    if regime != "identity":
        assert kernel.from_screw(*kernel.to_screw(v), check=True).shape == v.shape


def test_type_and_shape_errors_come_before_the_check(kernel: ModuleType) -> None:
    """Expect the errors of type and shape that are raised without ``check``; an empty batch is valid."""
    with pytest.raises(TypeError, match="T must be real"):
        kernel.from_pose(np.zeros((4, 4), complex), check=True)
    with pytest.raises(ValueError, match=r"T must have shape \(\.\.\., 4, 4\), got \(3,\)"):
        kernel.from_pose(np.zeros(3), check=True)
    assert kernel.from_pose(np.zeros((0, 4, 4)), check=True).shape == (0, 6)


# --- scalar last ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("axis", [-1, 0])
@pytest.mark.parametrize("shape", [(), (3,), (2, 30)], ids=str)
def test_scalar_last_quaternions(kernel: ModuleType, order: int, axis: int, shape: tuple[int, ...]) -> None:
    v = sampling.poses(order, "uniform", count=int(np.prod(shape))).reshape(*shape, 6)
    v = components_first(v, 1) if axis == 0 else v
    q = kernel.quaternion(v, axis=axis)
    last = kernel.quaternion(v, axis=axis, scalar_first=False)
    np.testing.assert_array_equal(last, q.take(LAST, axis))
    for branch in (0, order - 1):
        expected = kernel.from_quaternion(q, branch, axis=axis)
        found = kernel.from_quaternion(last, branch, axis=axis, scalar_first=False, check=True)
        np.testing.assert_array_equal(found, expected)
    out = np.empty_like(q)
    assert kernel.quaternion(v, axis=axis, out=out, scalar_first=False) is out
    np.testing.assert_array_equal(out, last)


def test_scalar_last_refuses_the_same_arguments(kernel: ModuleType) -> None:
    with pytest.raises(ValueError, match=r"q must have shape \(\.\.\., 8\), got \(7,\)"):
        kernel.from_quaternion(np.zeros(7), scalar_first=False)
    with pytest.raises(TypeError, match="q must be real"):
        kernel.from_quaternion(np.zeros(8, complex), scalar_first=False)
    with pytest.raises(ValueError, match=r"out must have shape \(8,\), got \(6,\)"):
        kernel.quaternion(np.zeros(6), scalar_first=False, out=np.zeros(6))
    with pytest.raises(TypeError, match="out must be able to hold float64, got dtype int64"):
        kernel.quaternion(np.zeros(6), scalar_first=False, out=np.zeros(8, np.int64))
    assert kernel.quaternion(np.zeros(6, np.complex64), scalar_first=False).dtype == np.complex64
