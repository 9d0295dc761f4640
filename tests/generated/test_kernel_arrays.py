"""Shapes: broadcasting, both layouts, empty, strided and read-only arrays, NaN element by element, wrong shapes."""

from __future__ import annotations

import inspect
import re
from types import ModuleType

import numpy as np
import pytest

import dualcay
from tests.support.kernels import ALIKE, load, orders
from tests.support.signatures import SHAPES, SIGNATURES, assert_nearly_equal, components_first, components_last, inputs

FUNCTION = pytest.mark.parametrize("name", SIGNATURES)
order = orders(ALIKE)
BATCHES = [(), (1,), (7,), (2, 3), (2, 1, 4)]


def one_by_one(kernel: ModuleType, name: str, arguments: list[np.ndarray], shape: tuple[int, ...]) -> np.ndarray:
    result = np.empty(shape + SIGNATURES[name].result)
    for index in np.ndindex(shape):
        result[index] = getattr(kernel, name)(*(a[index] for a in arguments))
    return result


@FUNCTION
@pytest.mark.parametrize("shape", BATCHES, ids=str)
def test_batches_are_their_poses_one_by_one(kernel: ModuleType, order: int, name: str, shape: tuple[int, ...]) -> None:
    arguments = inputs(kernel, name, order, shape)
    result = getattr(kernel, name)(*arguments)
    assert isinstance(result, np.ndarray)
    assert result.flags.writeable
    assert_nearly_equal(result, one_by_one(kernel, name, arguments, shape))


@FUNCTION
@pytest.mark.parametrize("shape", [*BATCHES, (0,), (3, 0)], ids=str)
def test_components_first_is_the_same_map(kernel: ModuleType, order: int, name: str, shape: tuple[int, ...]) -> None:
    signature, arguments = SIGNATURES[name], inputs(kernel, name, order, shape)
    rows = [components_first(a, len(SHAPES[k])) for a, k in zip(arguments, signature.arguments, strict=True)]
    result = getattr(kernel, name)(*rows, axis=0)
    assert result.shape == signature.result + shape
    expected = getattr(kernel, name)(*arguments, axis=-1)
    assert_nearly_equal(components_last(result, len(signature.result)), expected)


@FUNCTION
@pytest.mark.parametrize("shape", [(0,), (3, 0), (0, 2)], ids=str)
def test_empty_batches(kernel: ModuleType, order: int, name: str, shape: tuple[int, ...]) -> None:
    result = getattr(kernel, name)(*(np.zeros(shape + SHAPES[k]) for k in SIGNATURES[name].arguments))
    assert result.shape == shape + SIGNATURES[name].result
    assert result.dtype == np.float64


@pytest.mark.parametrize("name", [f for f, s in SIGNATURES.items() if len(s.arguments) == 2])
@pytest.mark.parametrize(
    ("first", "second", "shape"),
    [((5, 1), (4,), (5, 4)), ((), (3,), (3,)), ((3,), (), (3,)), ((2, 1, 3), (1, 4, 1), (2, 4, 3)), ((1,), (0,), (0,))],
    ids=str,
)
def test_leading_axes_broadcast(kernel: ModuleType, order: int, name: str, first, second, shape) -> None:
    kinds, rank = SIGNATURES[name].arguments, len(SIGNATURES[name].result)
    a, b = inputs(kernel, name, order, first)[0], inputs(kernel, name, order, second)[1]
    result = getattr(kernel, name)(a, b)
    assert result.shape == shape + SIGNATURES[name].result
    full = [np.broadcast_to(a, shape + SHAPES[kinds[0]]), np.broadcast_to(b, shape + SHAPES[kinds[1]])]
    assert_nearly_equal(result, getattr(kernel, name)(*(np.array(f) for f in full)))
    rows = getattr(kernel, name)(components_first(a, 1), components_first(b, 1), axis=0)
    assert_nearly_equal(components_last(rows, rank), result)


@FUNCTION
def test_large_batches_cross_block_borders(name: str) -> None:
    kernel, count = load(3), 40_000
    arguments = [np.resize(a, (count, *a.shape[1:])) for a in inputs(kernel, name, 3, (97,))]
    result = getattr(kernel, name)(*arguments)
    few = getattr(kernel, name)(*(a[:97] for a in arguments))
    assert_nearly_equal(result, np.resize(few, result.shape))
    rows = [components_first(a, len(SHAPES[k])) for a, k in zip(arguments, SIGNATURES[name].arguments, strict=True)]
    rank = len(SIGNATURES[name].result)
    assert_nearly_equal(components_last(getattr(kernel, name)(*rows, axis=0), rank), result)


@FUNCTION
@pytest.mark.parametrize("axis", [-1, 0])
def test_strided_and_read_only_arrays(kernel: ModuleType, order: int, name: str, axis: int) -> None:
    arguments = inputs(kernel, name, order, (6, 4))
    kinds = SIGNATURES[name].arguments
    if axis == 0:
        arguments = [components_first(a, len(SHAPES[k])) for a, k in zip(arguments, kinds, strict=True)]
    expected = getattr(kernel, name)(*arguments, axis=axis)
    strided = []
    for a in arguments:
        spacious = np.full([2 * n for n in a.shape], np.nan)
        view = spacious[tuple(slice(None, None, 2) for _ in a.shape)]
        view[...] = a
        strided.append(view)
    forms = {
        "strided": strided,
        "Fortran": [np.asfortranarray(a) for a in arguments],
        "reversed twice": [np.ascontiguousarray(a[..., ::-1])[..., ::-1] for a in arguments],
        "nested lists": [a.tolist() for a in arguments],
    }
    for form in forms.values():
        assert_nearly_equal(getattr(kernel, name)(*form, axis=axis), expected)
    for a in arguments:
        a.flags.writeable = False
    before = [a.copy() for a in arguments]
    assert_nearly_equal(getattr(kernel, name)(*arguments, axis=axis), expected)
    for a, b in zip(arguments, before, strict=True):
        np.testing.assert_array_equal(a, b)


@FUNCTION
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("axis", [-1, 0])
def test_a_bad_number_stays_in_its_element(kernel: ModuleType, order: int, name: str, bad: float, axis: int) -> None:
    arguments, kinds = inputs(kernel, name, order, (9,)), SIGNATURES[name].arguments
    for i, kind in enumerate(kinds):
        for component in range(int(np.prod(SHAPES[kind]))):
            if kind == "T" and component >= 12:
                continue  # the last row is known
            spoiled = [a.copy() for a in arguments]
            spoiled[i].reshape(9, -1)[4, component] = bad
            given = spoiled
            if axis == 0:
                given = [components_first(a, len(SHAPES[k])) for a, k in zip(spoiled, kinds, strict=True)]
            result = getattr(kernel, name)(*given, axis=axis)
            if axis == 0:
                result = components_last(result, len(SIGNATURES[name].result))
            others = np.delete(result, 4, axis=0)
            assert_nearly_equal(others, np.delete(getattr(kernel, name)(*arguments), 4, axis=0))
            if np.isnan(bad):
                assert np.isnan(result[4]).any()


NAMES = {
    "quaternion": ["v"],
    "tensor": ["v"],
    "pose": ["v"],
    "tangent": ["v"],
    "tangent_inv": ["v"],
    "twist": ["v", "v_dot"],
    "rate": ["v", "omega"],
    "body_tangent": ["v"],
    "body_tangent_inv": ["v"],
    "inverse": ["v"],
    "body_twist": ["v", "v_dot"],
    "body_rate": ["v", "omega"],
    "from_quaternion": ["q", "branch"],
    "from_tensor": ["R", "branch"],
    "from_pose": ["T", "branch"],
    "shadow": ["v", "branch"],
    "principal": ["v"],
    "compose": ["v2", "v1"],
    "transform_point": ["v", "r"],
    "transform_line": ["v", "line"],
}
KEYWORDS = {
    "quaternion": {"scalar_first": True},
    "from_quaternion": {"check": False, "scalar_first": True},
    "from_tensor": {"check": False},
    "from_pose": {"check": False},
}


@pytest.mark.parametrize("name", NAMES)
def test_arguments_have_the_documented_names(kernel: ModuleType, order: int, name: str) -> None:
    parameters = inspect.signature(getattr(kernel, name)).parameters
    further = KEYWORDS.get(name, {})
    assert list(parameters) == [*NAMES[name], "axis", "out", *further]
    assert {keyword: parameters[keyword].default for keyword in further} == further
    assert parameters["axis"].default == -1
    assert parameters["out"].default is None
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
    kinds = SIGNATURES[name].arguments
    for i, kind in enumerate(kinds):
        for shape in WRONG[kind] if SHAPES[kind] else ():  # any shape is one of numbers
            arguments = [np.zeros(SHAPES[k]) for k in kinds]
            arguments[i] = np.zeros(shape)
            for form in (arguments, [a.tolist() for a in arguments]):
                with pytest.raises(ValueError, match=re.escape(str(shape))) as caught:
                    getattr(kernel, name)(*form)
                message = str(caught.value)
                assert all(str(n) in message.replace(str(shape), "") for n in SHAPES[kind]), message


@FUNCTION
def test_wrong_component_axes_are_named_with_components_first(kernel: ModuleType, order: int, name: str) -> None:
    kinds = SIGNATURES[name].arguments
    arguments = [np.zeros((*SHAPES[k], 11)) for k in kinds]
    arguments[0] = np.zeros((11, *SHAPES[kinds[0]]))
    with pytest.raises(ValueError, match=re.escape(str(arguments[0].shape))):
        getattr(kernel, name)(*arguments, axis=0)


@FUNCTION
@pytest.mark.parametrize("axis", [1, -2, 2])
def test_another_axis_is_an_error(kernel: ModuleType, order: int, name: str, axis: int) -> None:
    arguments = [np.zeros((6, *SHAPES[k])) for k in SIGNATURES[name].arguments]
    with pytest.raises(ValueError, match="axis"):
        getattr(kernel, name)(*arguments, axis=axis)


@pytest.mark.parametrize("name", [f for f, s in SIGNATURES.items() if len(s.arguments) == 2])
def test_batches_that_do_not_broadcast_are_an_error(kernel: ModuleType, order: int, name: str) -> None:
    kinds = SIGNATURES[name].arguments
    a, b = np.zeros((3, *SHAPES[kinds[0]])), np.zeros((4, *SHAPES[kinds[1]]))
    with pytest.raises(ValueError, match=r"\(3,\).*\(4,\)"):
        getattr(kernel, name)(a, b)
    with pytest.raises(ValueError, match=r"\(3,\).*\(4,\)"):
        getattr(kernel, name)(a.T, b.T, axis=0)


def test_screws_broadcast(kernel: ModuleType, order: int) -> None:
    angle = np.array([[[0.3, 1.0]], [[1.2, -2.0]]])  # (2, 1, 2)
    axis = np.array([[0, 0, 1, 0.5, 0, 0], [0.6, 0.8, 0, 0, 0, 1.0], [1, 0, 0, 0, 0, 0]])  # (3, 6)
    v = kernel.from_screw(angle, axis)
    assert v.shape == (2, 3, 6)
    for i, j in np.ndindex(2, 3):
        assert_nearly_equal(v[i, j], kernel.from_screw(angle[i, 0], axis[j]))
    back, direction = kernel.to_screw(v)
    assert back.shape == (2, 3, 2)
    assert direction.shape == (2, 3, 6)
    assert_nearly_equal(back, np.broadcast_to(angle, (2, 3, 2)), 40)
    assert_nearly_equal(direction, np.broadcast_to(axis, (2, 3, 6)), 40)
    assert kernel.from_screw(np.zeros((0, 2)), np.zeros((0, 6))).shape == (0, 6)
    for wrong in ((np.zeros(3), axis), (angle, np.zeros(5)), (np.zeros((4, 2)), axis)):
        with pytest.raises(ValueError, match=r"\(3,\)|\(5,\)|\(4,\)"):
            kernel.from_screw(*wrong)
    with pytest.raises(ValueError, match=r"\(5,\)"):
        kernel.to_screw(np.zeros(5))


@pytest.mark.parametrize("shape", [(3, 3), (2, 3, 2), (6, 6), (3, 3, 3), (18,)])
def test_matrix6_names_a_wrong_shape(shape: tuple[int, ...]) -> None:
    with pytest.raises(ValueError, match=re.escape(str(shape))):
        dualcay.matrix6(np.zeros(shape))
