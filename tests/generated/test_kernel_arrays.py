"""Kernels on arrays: batches, both layouts, broadcasting, strides, NaN in one element, wrong shapes."""

from __future__ import annotations

import inspect
import itertools
import re
from functools import partial
from types import ModuleType

import numpy as np
import pytest

import dualcay
from dualcay import _kernel, _prepared, _runtime
from tests.support import sampling, thorough
from tests.support.kernels import ALIKE, orders
from tests.support.layouts import BATCHES as BATCHES_OF_ONE
from tests.support.layouts import require_strides_of_one_ignored
from tests.support.signatures import (
    KINDS,
    SHAPES,
    SIGNATURES,
    assert_nearly_equal,
    components_last,
    inputs,
    rows_of,
)

FUNCTION = pytest.mark.parametrize("name", thorough.sampled(SIGNATURES, KINDS.values()))
OF_TWO = [name for name, row in SIGNATURES.items() if len(row.arguments) == 2]
FUNCTION_OF_TWO = pytest.mark.parametrize("name", thorough.sampled(OF_TWO, KINDS.values()))
BATCHES = [(), (1,), (7,), (2, 3), (2, 1, 4)]
EMPTY = [(0,), (3, 0), (0, 2)]
order = orders(ALIKE)


def by_rows(kernel: ModuleType, name: str, arguments: list[np.ndarray]) -> np.ndarray:
    """Call a function with components first; return its result with components last."""
    found = getattr(kernel, name)(*rows_of(name, arguments), axis=0)
    return components_last(found, len(SIGNATURES[name].result))


@FUNCTION
def test_batches_agree_with_single_poses_in_both_layouts(kernel: ModuleType, order: int, name: str) -> None:
    function, shape_of_one = getattr(kernel, name), SIGNATURES[name].result
    for shape in BATCHES:
        arguments = inputs(kernel, name, order, shape)
        result, alone = function(*arguments), np.empty(shape + shape_of_one)
        for index in np.ndindex(shape):
            alone[index] = function(*(a[index] for a in arguments))
        assert isinstance(result, np.ndarray)
        assert result.flags.writeable
        assert_nearly_equal(result, alone)
        assert_nearly_equal(by_rows(kernel, name, arguments), result)
    for shape in EMPTY:
        arguments = [np.zeros(shape + SHAPES[k]) for k in SIGNATURES[name].arguments]
        for result in (function(*arguments), by_rows(kernel, name, arguments)):
            assert result.shape == shape + shape_of_one
            assert result.dtype == np.float64


@FUNCTION
def test_recorded_program_agrees_with_single_poses_and_any_block_size(
    kernel: ModuleType, order: int, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    for dtype in (np.float32, np.float64, np.longdouble):
        arguments = inputs(kernel, name, order, (10, 2), dtype)
        if dtype == np.float64:
            alone = getattr(kernel, name)(*arguments)
        with monkeypatch.context() as patch:
            patch.setattr(_runtime, "POINTWISE_MAX", -1)
            patch.setattr(_prepared, "RUNS_BEFORE_PACKING", 1)
            _prepared._kept.clear()
            whole = getattr(kernel, name)(*arguments)
            if dtype == np.float64:
                assert_nearly_equal(whole, alone, 64)
            patch.setattr(_kernel, "PREPARED_MAX", -1)
            np.testing.assert_array_equal(getattr(kernel, name)(*arguments), whole)  # blocks: equal in every bit
            for size in (3, 12):
                patch.setattr(_kernel, "BLOCK", size)
                assert_nearly_equal(getattr(kernel, name)(*arguments), whole)
                assert_nearly_equal(by_rows(kernel, name, arguments), whole)


def test_blocks_cover_a_batch_once() -> None:
    batches = [(), (1,), (7,), (0,), (3, 0), (5, 7), (4, 3, 2), (2, 100), (100, 2), (3, 17, 5)]
    for batch, size in itertools.product(batches, (1, 4, 10, 64, 1000)):
        seen = np.zeros(batch, int)
        for index in _kernel.blocks(batch, size):
            assert seen[(*index, ...)].size <= size
            seen[(*index, ...)] += 1
        assert (seen == 1).all(), (batch, size)


BROADCAST = [
    ((5, 1), (4,), (5, 4)), ((), (3,), (3,)), ((3,), (), (3,)), ((2, 1, 3), (1, 4, 1), (2, 4, 3)), ((1,), (0,), (0,)),
]  # fmt: skip


@FUNCTION_OF_TWO
def test_leading_axes_broadcast_or_are_refused(kernel: ModuleType, order: int, name: str) -> None:
    kinds = SIGNATURES[name].arguments
    for first, second, shape in BROADCAST:
        a, b = inputs(kernel, name, order, first)[0], inputs(kernel, name, order, second)[1]
        result = getattr(kernel, name)(a, b)
        assert result.shape == shape + SIGNATURES[name].result
        full = [np.array(np.broadcast_to(x, shape + SHAPES[kind])) for x, kind in zip((a, b), kinds, strict=True)]
        assert_nearly_equal(result, getattr(kernel, name)(*full))
        assert_nearly_equal(by_rows(kernel, name, [a, b]), result)
    a, b = (np.zeros((count, *SHAPES[kind])) for count, kind in zip((3, 4), kinds, strict=True))
    for given, axis in (((a, b), -1), ((a.T, b.T), 0)):
        with pytest.raises(ValueError, match=r"\(3,\).*\(4,\)"):
            getattr(kernel, name)(*given, axis=axis)


@FUNCTION_OF_TWO
def test_what_depends_on_an_argument_of_fewer_poses_has_the_same_bits(
    kernel: ModuleType, order: int, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    kinds = SIGNATURES[name].arguments
    for most in ({_kernel: "PREPARED_MAX", _runtime: "POINTWISE_MAX"}).items():
        monkeypatch.setattr(*most, -1)
    for first, second, shape in BROADCAST:
        few = [inputs(kernel, name, order, of)[place] for place, of in enumerate((first, second))]
        full = [np.array(np.broadcast_to(x, shape + SHAPES[kind])) for x, kind in zip(few, kinds, strict=True)]
        for call in (getattr(kernel, name), lambda *given: by_rows(kernel, name, given)):
            np.testing.assert_array_equal(call(*few), call(*full))


@FUNCTION
@pytest.mark.parametrize("axis", [-1, 0])
def test_strided_and_read_only_arrays_are_read_and_kept(kernel: ModuleType, order: int, name: str, axis: int) -> None:
    arguments = inputs(kernel, name, order, (6, 4))
    arguments = rows_of(name, arguments) if axis == 0 else arguments
    expected = getattr(kernel, name)(*arguments, axis=axis)
    strided = [np.repeat(np.repeat(a, 2, 0), 2, -1)[::2, ..., ::2] for a in arguments]
    turned = [np.ascontiguousarray(a[..., ::-1])[..., ::-1] for a in arguments]
    forms = [strided, [np.asfortranarray(a) for a in arguments], turned, [a.tolist() for a in arguments], arguments]
    before = [a.copy() for a in arguments]
    for a in arguments:
        a.flags.writeable = False
    for form in forms:
        assert_nearly_equal(getattr(kernel, name)(*form, axis=axis), expected)
    for a, b in zip(arguments, before, strict=True):
        np.testing.assert_array_equal(a, b)


@FUNCTION
@pytest.mark.parametrize("axis", [-1, 0])
@pytest.mark.parametrize("most", [{}, {"POINTWISE_MAX": -1, "PREPARED_MAX": -1}], ids=len)
def test_axes_of_length_1_may_have_any_stride(
    kernel: ModuleType, order: int, name: str, axis: int, most: dict[str, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Call pose by pose, as a prepared program and block by block, also with ``out``."""
    for limit, value in most.items():
        monkeypatch.setattr(_kernel if hasattr(_kernel, limit) else _runtime, limit, value)
    for shape in BATCHES_OF_ONE:
        arguments = inputs(kernel, name, order, shape)
        given = rows_of(name, arguments) if axis == 0 else arguments
        require_strides_of_one_ignored(partial(getattr(kernel, name), axis=axis), given, assert_nearly_equal)


@FUNCTION
@pytest.mark.parametrize("axis", [-1, 0])
def test_nan_and_infinity_stay_in_their_element(kernel: ModuleType, order: int, name: str, axis: int) -> None:
    arguments, kinds = inputs(kernel, name, order, (9,)), SIGNATURES[name].arguments
    undisturbed = np.delete(getattr(kernel, name)(*arguments), 4, axis=0)
    for i, kind in enumerate(kinds):
        for component in range(12 if kind == "T" else int(np.prod(SHAPES[kind]))):  # the last row of T is constant
            for bad in (np.nan, np.inf, -np.inf):
                spoiled = [a.copy() for a in arguments]
                spoiled[i].reshape(9, -1)[4, component] = bad
                result = by_rows(kernel, name, spoiled) if axis == 0 else getattr(kernel, name)(*spoiled)
                assert_nearly_equal(np.delete(result, 4, axis=0), undisturbed)
                assert np.isnan(result[4]).any() or not np.isnan(bad)


OF_V = (
    "quaternion", "tensor", "pose", "tangent", "tangent_inv", "body_tangent", "body_tangent_inv", "inverse",
    "principal",
)  # fmt: skip
NAMES = {
    **dict.fromkeys(OF_V, ("v",)),
    **dict.fromkeys(("twist", "body_twist"), ("v", "v_dot")), **dict.fromkeys(("rate", "body_rate"), ("v", "omega")),
    "from_quaternion": ("q", "branch"), "from_tensor": ("R", "branch"), "from_pose": ("T", "branch"),
    "shadow": ("v", "branch"), "compose": ("v2", "v1"), "transform_point": ("v", "r"), "transform_line": ("v", "line"),
}  # fmt: skip
KEYWORDS = {
    "quaternion": {"scalar_first": True}, "from_quaternion": {"check": False, "scalar_first": True},
    "from_tensor": {"check": False}, "from_pose": {"check": False},
}  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_arguments_have_the_documented_names(kernel: ModuleType, order: int, name: str) -> None:
    parameters = inspect.signature(getattr(kernel, name)).parameters
    further = {"axis": -1, "out": None} | KEYWORDS.get(name, {})
    assert list(parameters) == [*NAMES[name], *further]
    assert {keyword: parameters[keyword].default for keyword in further} == further
    if "branch" in parameters:
        assert parameters["branch"].default == (1 if name == "shadow" else 0)
    arguments = inputs(kernel, name, order, (2,))
    by_name = getattr(kernel, name)(**dict(zip(NAMES[name], arguments, strict=False)))
    np.testing.assert_array_equal(by_name, getattr(kernel, name)(*arguments))


WRONG = {
    "v": [(5,), (7,), (2, 3), (6, 5), ()],
    "w": [(5,), (2, 3), (6, 5), ()],
    "q": [(4,), (7,), (8, 7), ()],
    "R": [(3, 3), (2, 3), (2, 3, 4), (3, 3, 3), (2, 9), (18,), ()],
    "T": [(3, 4), (4,), (4, 3), (16,), (4, 4, 3), ()],
    "r": [(2,), (4,), (3, 2), ()],
}


@FUNCTION
def test_wrong_component_axes_are_named(kernel: ModuleType, order: int, name: str) -> None:
    function, kinds = getattr(kernel, name), SIGNATURES[name].arguments
    for i, kind in enumerate(kinds):
        for shape in WRONG[kind] if SHAPES[kind] else ():  # an argument without components accepts every shape
            arguments = [np.zeros(SHAPES[k]) for k in kinds]
            arguments[i] = np.zeros(shape)
            for form in (arguments, [a.tolist() for a in arguments]):
                with pytest.raises(ValueError, match=re.escape(str(shape))) as caught:
                    function(*form)
                message = str(caught.value)
                assert all(str(n) in message.replace(str(shape), "") for n in SHAPES[kind]), message
    first = [np.zeros((*SHAPES[k], 11)) for k in kinds]
    first[0] = np.zeros((11, *SHAPES[kinds[0]]))
    with pytest.raises(ValueError, match=re.escape(str(first[0].shape))):
        function(*first, axis=0)
    for axis in (1, -2, 2):
        with pytest.raises(ValueError, match="axis"):
            function(*(np.zeros((6, *SHAPES[k])) for k in kinds), axis=axis)


def test_screws_broadcast(kernel: ModuleType, order: int) -> None:
    angle = np.array([[[0.3, 1.0]], [[1.2, -2.0]]])  # (2, 1, 2)
    axis = np.array([[0, 0, 1, 0.5, 0, 0], [0.6, 0.8, 0, 0, 0, 1.0], [1, 0, 0, 0, 0, 0]])  # (3, 6)
    v = kernel.from_screw(angle, axis)
    assert v.shape == (2, 3, 6)
    for i, j in np.ndindex(2, 3):
        assert_nearly_equal(v[i, j], kernel.from_screw(angle[i, 0], axis[j]))
    back, direction = kernel.to_screw(v)
    assert_nearly_equal(back, np.broadcast_to(angle, (2, 3, 2)), 40)
    assert_nearly_equal(direction, np.broadcast_to(axis, (2, 3, 6)), 40)
    assert kernel.from_screw(np.zeros((0, 2)), np.zeros((0, 6))).shape == (0, 6)
    out = np.empty((2, 3, 6))
    assert kernel.from_screw(angle, axis, out=out) is out
    assert_nearly_equal(out, v)
    for wrong in ((np.zeros(3), axis), (angle, np.zeros(5)), (np.zeros((4, 2)), axis)):
        with pytest.raises(ValueError, match=r"\(3,\)|\(5,\)|\(4,\)"):
            kernel.from_screw(*wrong)
    with pytest.raises(ValueError, match=r"\(5,\)"):
        kernel.to_screw(np.zeros(5))


def test_matrix6_acts_on_twists_as_the_dual_tensor_does_and_names_a_wrong_shape(order: int, kernel: ModuleType) -> None:
    d = kernel.tangent(sampling.poses(order, "uniform", count=6).reshape(2, 3, 6))
    m = dualcay.matrix6(d)
    assert m.shape == (2, 3, 6, 6)
    assert m.dtype == d.dtype
    np.testing.assert_array_equal(m[..., :3, :3], d[..., 0, :, :])
    np.testing.assert_array_equal(m[..., 3:, 3:], d[..., 0, :, :])
    np.testing.assert_array_equal(m[..., 3:, :3], d[..., 1, :, :])
    np.testing.assert_array_equal(m[..., :3, 3:], 0)
    for shape in ((3, 3), (2, 3, 2), (6, 6), (3, 3, 3), (18,)):
        with pytest.raises(ValueError, match=re.escape(str(shape))):
            dualcay.matrix6(np.zeros(shape))
