"""Array handling of the Numba target: arguments on the fast path, and results written directly by loops."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from derive.codegen.package import shared_texts
from derive.codegen.targets import TARGETS
from derive.codegen.validation.loading import loaded
from derive.output import files


@pytest.fixture(scope="module")
def runtime(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    """Provide the run-time module from the templates, without compilation."""
    folder: Path = tmp_path_factory.mktemp("kernels")
    files.write(folder, shared_texts(TARGETS["numba"]))
    with loaded(folder) as package:
        yield importlib.import_module(f"{package}._runtime")


def added(arrays: list[Any], result: Any) -> None:
    """Stand in for a kernel: compute 3 result components from two arguments of 2 components."""
    first, second = arrays
    result[...] = np.stack([first[..., 0], second[..., 1], first[..., 1] + second[..., 0]], axis=-1)


ADDED = SimpleNamespace(parts=[(2,), (2,)], sizes=[2, 2], size=3, source=SimpleNamespace(shape=(3,)), over_last=added)


def test_float64_arrays_of_one_batch_take_the_fast_path(runtime: Any) -> None:
    given = np.arange(6.0).reshape(3, 2), np.arange(6.0, 12).reshape(3, 2)
    found = runtime._directly(ADDED, given, ())
    assert np.array_equal(found, [[0, 7, 7], [2, 9, 11], [4, 11, 15]])
    first, second = given
    for others in ((first[:2], second), (first[0], second), (first[:0], second[:0]), (first[:, :1], second)):
        assert runtime._directly(ADDED, others, ()) is None
    assert runtime._directly(ADDED, (first.astype(np.float32), second), ()) is None
    assert runtime._directly(ADDED, (first.tolist(), second), ()) is None


def test_loops_write_directly_into_contiguous_separate_results(runtime: Any) -> None:
    shape, dtype, given = (4, 3), np.dtype(np.float64), [np.zeros((4, 2))]
    right = np.zeros(shape)
    assert runtime._place(right, shape, dtype, given) is right
    strided, turned = np.zeros((4, 6))[:, ::2], np.zeros((3, 4)).T
    over = np.zeros(20)
    for out, arrays in (
        (strided, given),
        (turned, given),
        (np.zeros(shape, np.longdouble), given),
        (over[:12].reshape(shape), [over[8:16].reshape(4, 2)]),
    ):
        assert runtime._place(out, shape, dtype, arrays) is not out
