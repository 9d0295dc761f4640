"""Keyword ``check`` of inverse maps, and quaternions with the scalar last."""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from dualcay import cayley3, interop, rotation
from tests.support import sampling
from tests.support.kernels import load
from tests.support.signatures import components_first

LAST = [1, 2, 3, 0, 5, 6, 7, 4]
REFLECTION = np.diag([1.0, 1.0, -1.0, 1.0])
TRANSPOSED = np.eye(4)
TRANSPOSED[3, :3] = 1, 2, 3
TURNED = [np.cos(0.5), np.sin(0.5), 0, 0]

WRONG: dict[str, tuple[str, Any, str]] = {
    "zeros": ("from_pose", np.zeros((4, 4)), "Q Qᵀ is not I, off by 1 "),
    "twice the identity": ("from_pose", 2 * np.eye(4), "det Q is not 1, off by 7 "),
    "a reflection": ("from_pose", REFLECTION, "det Q is not 1, off by 2 "),
    "a translation in the last row": ("from_pose", TRANSPOSED, "its last row is not [0, 0, 0, 1], off by 3 "),
    "NaN": ("from_pose", np.full((4, 4), np.nan), "off by nan "),
    "an infinite entry": ("from_pose", np.where(np.eye(4) > 0, np.inf, 0), "off by (inf|nan) "),
    "a quaternion of zeros": ("from_quaternion", np.zeros(8), "the square of its real part is not 1, off by 1 "),
    "a quaternion not of length 1": ("from_quaternion", [0, 0, 0, 1.1, 0, 0, 0, 0], "not 1, off by 0.21 "),
    "a dual part along the real one": ("from_quaternion", [*TURNED, *TURNED], "to its real part, off by 0.42 "),
    "a tensor of zeros": ("from_tensor", np.zeros((2, 3, 3)), "Q Qᵀ is not I"),
    "a reflection of a tensor": ("from_tensor", [-np.eye(3), np.zeros((3, 3))], "det Q is not 1, off by 2 "),
    "a dual part that stretches": ("from_tensor", [np.eye(3), np.eye(3)], "times Qᵀ is not skew, off by 0.5 "),
    "a moment alone": ("from_screw", [0, 0, 0, 0, 0, 1], "the square of its direction is not 1, off by 1 "),
    "a direction of length 2": ("from_screw", [0, 2, 0, 0, 0, 1], "the square of its direction is not 1, off by 3 "),
    "a moment along the direction": ("from_screw", [0, 0, 1, 0, 0, 1], "perpendicular to its direction, off by 0.5 "),
}


def way_back(kernel: ModuleType, name: str) -> Callable[..., np.ndarray]:
    """Return an inverse map as a function of one argument; ``from_screw`` gets the angle 0.3."""
    function = getattr(kernel, name)

    def from_line(line: Any, **given: Any) -> np.ndarray:
        angle = np.array([0.3, 0.0], np.result_type(np.asarray(line), np.float32))
        return function(angle, line, **given)

    return from_line if name == "from_screw" else function


def right(kernel: ModuleType, name: str, v: np.ndarray) -> np.ndarray:
    made = {"from_pose": kernel.pose, "from_quaternion": kernel.quaternion, "from_tensor": kernel.tensor}
    return made[name](v) if name in made else kernel.to_screw(v)[1]


@pytest.mark.parametrize("case", WRONG)
def test_invalid_poses_are_refused_with_check_only(kernel: ModuleType, case: str) -> None:
    name, value, message = WRONG[case]
    function = way_back(kernel, name)
    with np.errstate(all="ignore"):
        assert function(value).shape == (6,)
    with pytest.raises(ValueError, match=re.escape(message).replace(r"\(inf\|nan\)", "(inf|nan)")):
        function(value, check=True)


@pytest.mark.parametrize("name", ["from_pose", "from_quaternion", "from_tensor", "from_screw"])
@pytest.mark.parametrize("axis", [-1, 0])
def test_check_names_the_first_invalid_element(name: str, axis: int) -> None:
    kernel = load(3)
    function = way_back(kernel, name)
    value = right(kernel, name, sampling.poses(3, "uniform", count=6).reshape(2, 3, 6))
    rank = value.ndim - 2
    given = components_first(value, rank) if axis == 0 else value
    np.testing.assert_array_equal(function(given, axis=axis, check=True), function(given, axis=axis))
    value[1, 0] *= 3
    value[1, 2] *= 9
    given = components_first(value, rank) if axis == 0 else value
    place = "[..., 1, 0]" if axis == 0 else "[1, 0]"
    argument = {"from_pose": "T", "from_quaternion": "q", "from_tensor": "R", "from_screw": "line"}[name]
    with pytest.raises(ValueError, match=re.escape(f"{argument}{place} is no ")):
        function(given, axis=axis, check=True)
    with pytest.raises(ValueError, match=re.escape(f"{argument}[0] is no ")):
        function(value[1], check=True)


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.longdouble])
@pytest.mark.parametrize("name", ["from_pose", "from_quaternion", "from_tensor", "from_screw"])
def test_check_tolerance_is_the_square_root_of_eps(name: str, dtype: Any) -> None:
    """Scale arguments by 1 + s: the square changes by 2 s, the determinant by 3 s; the last row of a pose stays."""
    kernel, step = load(3), np.sqrt(np.finfo(dtype).eps)
    function = way_back(kernel, name)
    value = right(kernel, name, sampling.poses(3, "uniform", count=4)).astype(dtype)
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
    (cayley3.from_quaternion, ([1.005, 0, 0, 0, 0, 0, 0, 0],)),
    (cayley3.from_tensor, ([np.diag([1.005, 1, 1]), np.zeros((3, 3))],)),
    (cayley3.from_screw, ([0.3, 0], [1.005, 0, 0, 0, 0, 0])),
    (rotation.cayley3.from_quaternion, ([1.005, 0, 0, 0],)),
    (rotation.cayley3.from_tensor, (np.diag([1.005, 1, 1]),)),
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


def test_identity_with_scalar_last_needs_the_keyword(kernel: ModuleType, order: int) -> None:
    """Read the identity with the scalar first: it is a valid quaternion of half a turn, which no check refuses."""
    identity = np.array([0.0, 0, 0, 1, 0, 0, 0, 0])
    np.testing.assert_array_equal(kernel.from_quaternion(identity, scalar_first=False, check=True), np.zeros(6))
    if order > 1:
        angle, _ = kernel.to_screw(kernel.from_quaternion(identity, check=True))
        np.testing.assert_allclose(angle[0], np.pi)


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
