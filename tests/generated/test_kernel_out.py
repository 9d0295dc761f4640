"""The out argument: identity, layouts, overlap with an input, and refusals."""

from __future__ import annotations

import re
from types import ModuleType

import numpy as np
import pytest

from tests.support.kernels import ALIKE, load, orders
from tests.support.signatures import SHAPES, SIGNATURES, assert_nearly_equal, components_first, inputs

order = orders(ALIKE)
FUNCTION = pytest.mark.parametrize("name", SIGNATURES)


def arranged(kernel: ModuleType, name: str, order: int, shape: tuple[int, ...], axis: int) -> list[np.ndarray]:
    arguments = inputs(kernel, name, order, shape)
    if axis == 0:
        kinds = SIGNATURES[name].arguments
        return [components_first(a, len(SHAPES[k])) for a, k in zip(arguments, kinds, strict=True)]
    return arguments


@FUNCTION
@pytest.mark.parametrize("axis", [-1, 0])
@pytest.mark.parametrize("shape", [(), (5,), (2, 3), (0,)], ids=str)
def test_out_is_filled_and_returned(kernel: ModuleType, order: int, name: str, shape, axis: int) -> None:
    arguments = arranged(kernel, name, order, shape, axis)
    expected = getattr(kernel, name)(*arguments, axis=axis)
    spacious = np.full([2 * n for n in expected.shape], np.nan)
    outs = {
        "contiguous": np.full(expected.shape, np.nan),
        "Fortran": np.full(expected.shape, np.nan, order="F"),
        "strided": spacious[tuple(slice(None, None, 2) for _ in expected.shape)],
    }
    for out in outs.values():
        assert getattr(kernel, name)(*arguments, axis=axis, out=out) is out
        assert_nearly_equal(out, expected)
    assert np.isnan(spacious[tuple(slice(1, None, 2) for _ in expected.shape)]).all()


@FUNCTION
@pytest.mark.parametrize("axis", [-1, 0])
@pytest.mark.parametrize("count", [1, 50, 30_000])
def test_out_may_overlap_an_input(name: str, axis: int, count: int) -> None:
    """In one buffer, out before, upon and after the input: no element may be read after it was written."""
    kernel = load(3)
    few = inputs(kernel, name, 3, (min(count, 50),))
    arguments = [np.resize(a, (count, *a.shape[1:])) for a in few]
    kinds = SIGNATURES[name].arguments
    if axis == 0:
        arguments = [components_first(a, len(SHAPES[k])) for a, k in zip(arguments, kinds, strict=True)]
    expected = getattr(kernel, name)(*arguments, axis=axis)
    for i, argument in enumerate(arguments):
        room = max(argument.size, expected.size)
        for start, out_start in ((0, 0), (7, 0), (0, 7), (room // 2, 0), (0, room // 2)):
            buffer = np.zeros(2 * room + 7)
            given = list(arguments)
            given[i] = buffer[start : start + argument.size].reshape(argument.shape)
            given[i][...] = argument
            out = buffer[out_start : out_start + expected.size].reshape(expected.shape)
            assert getattr(kernel, name)(*given, axis=axis, out=out) is out
            assert_nearly_equal(out, expected)


@pytest.mark.parametrize("name", [f for f, s in SIGNATURES.items() if s.arguments[0] in "vw" and s.result == (6,)])
def test_in_place_updates(kernel: ModuleType, order: int, name: str) -> None:
    arguments = inputs(kernel, name, order, (4,))
    expected = getattr(kernel, name)(*arguments)
    for i in (i for i, argument in enumerate(arguments) if argument.shape == expected.shape):
        given = [a.copy() for a in arguments]
        getattr(kernel, name)(*given, out=given[i])
        assert_nearly_equal(given[i], expected)
        transposed = [a.copy() for a in arguments]
        getattr(kernel, name)(*transposed, out=transposed[i][::-1])
        assert_nearly_equal(transposed[i][::-1], expected)


@FUNCTION
@pytest.mark.parametrize("axis", [-1, 0])
def test_out_of_a_wrong_shape_is_named(kernel: ModuleType, order: int, name: str, axis: int) -> None:
    arguments = arranged(kernel, name, order, (5,), axis)
    right = getattr(kernel, name)(*arguments, axis=axis).shape
    for wrong in ((7, *right[1:]), right[:-1], (1, *right), (*right[:-1], right[-1] + 1)):
        with pytest.raises(ValueError, match=f"{re.escape(str(right))}.*{re.escape(str(wrong))}"):
            getattr(kernel, name)(*arguments, axis=axis, out=np.zeros(wrong))
    single = [a[0] if axis == -1 else a[..., 0] for a in arguments]
    with pytest.raises(ValueError, match="out"):
        getattr(kernel, name)(*single, axis=axis, out=np.zeros(right))


@FUNCTION
def test_out_of_a_wrong_type_is_refused(kernel: ModuleType, order: int, name: str) -> None:
    for shape in ((), (5,)):
        arguments = inputs(kernel, name, order, shape)
        right = getattr(kernel, name)(*arguments).shape
        for out in (np.zeros(right, int), np.zeros(right, bool), np.zeros(right).tolist()):
            with pytest.raises(TypeError, match="out"):
                getattr(kernel, name)(*arguments, out=out)
        frozen = np.zeros(right)
        frozen.flags.writeable = False
        with pytest.raises(ValueError, match="read-only"):
            getattr(kernel, name)(*arguments, out=frozen)


def test_out_of_from_screw(kernel: ModuleType, order: int) -> None:
    angle, axis = np.array([[0.5, 1.0], [1.0, 2.0]]), np.array([0.6, 0, 0.8, 0, 1.0, 0])
    out = np.empty((2, 6))
    assert kernel.from_screw(angle, axis, out=out) is out
    assert_nearly_equal(out, kernel.from_screw(angle, axis))
