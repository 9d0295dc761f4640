"""Batches: blocks cover them once, results do not depend on the cut, calls share no scratch memory."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest

from dualcay import _kernel, _runtime
from tests.support.kernels import ALIKE, orders
from tests.support.signatures import SIGNATURES, assert_nearly_equal, inputs

order = orders(ALIKE)


@pytest.mark.parametrize("batch", [(), (1,), (7,), (0,), (3, 0), (5, 7), (4, 3, 2), (2, 100), (100, 2), (3, 17, 5)])
@pytest.mark.parametrize("size", [1, 4, 10, 64, 1000])
def test_blocks_cover_a_batch_once(batch: tuple[int, ...], size: int) -> None:
    seen = np.zeros(batch, int)
    for index in _kernel.blocks(batch, size):
        assert seen[(*index, ...)].size <= size
        seen[(*index, ...)] += 1
    assert (seen == 1).all()


@pytest.mark.parametrize("name", SIGNATURES)
@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.longdouble])
@pytest.mark.parametrize("axis", [-1, 0])
def test_results_do_not_depend_on_the_cut(
    kernel: ModuleType, order: int, name: str, dtype: type, axis: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(_runtime, "POINTWISE_MAX", -1)
    arguments = inputs(kernel, name, order, (10, 4), dtype)
    if axis == 0:
        arguments = [np.ascontiguousarray(np.moveaxis(a, (0, 1), (-2, -1))) for a in arguments]
    whole = getattr(kernel, name)(*arguments, axis=axis)
    for size in (1, 3, 12):
        monkeypatch.setattr(_kernel, "BLOCK", size)
        assert_nearly_equal(getattr(kernel, name)(*arguments, axis=axis), whole)


def test_nested_call_has_its_own_scratch() -> None:
    scratch = _kernel.Scratch()
    outer, inner = scratch.take(1000), scratch.take(1000)
    assert not np.may_share_memory(outer, inner)
    assert outer.ctypes.data % _kernel.CACHE_LINE == inner.ctypes.data % _kernel.CACHE_LINE == 0
    scratch.give_back(inner)
    assert np.may_share_memory(scratch.take(500), inner)


@pytest.mark.parametrize("name", SIGNATURES)
def test_poses_one_by_one_agree_with_recorded_program(
    kernel: ModuleType, order: int, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    arguments = inputs(kernel, name, order, (3, 2))
    found = getattr(kernel, name)(*arguments)
    first = getattr(kernel, name)(*(np.moveaxis(a, (0, 1), (-2, -1)) for a in arguments), axis=0)
    np.testing.assert_array_equal(np.moveaxis(first, (-2, -1), (0, 1)), found)
    assert first.flags.c_contiguous
    monkeypatch.setattr(_runtime, "POINTWISE_MAX", -1)
    assert_nearly_equal(getattr(kernel, name)(*arguments), found, 64)
