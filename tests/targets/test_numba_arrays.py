"""Array handling of the Numba target, around stand-ins and a kernel of two operations, which compiles in a second."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from derive.codegen.package import shared_texts
from derive.codegen.targets import TARGETS
from derive.codegen.validation.loading import loaded
from derive.output import files

TOY = """
from ._compiled import Compiled, Kernel, Programs, number, prange, reciprocal, where


def toy(a, b):
    (third,) = c_third(a[1])
    return where(a[0] < 0, b[0], number(2, a[0]) * a[0]), third, reciprocal(b[0], 3)


def toy_rows(a, b, out):
    for i in prange(out.shape[1]):
        out[0, i], out[1, i], out[2, i] = toy((a[0, i], a[1, i]), (b[0, i],))


def toy_row(a, b, like, out):
    out[0], out[1], out[2] = toy((a[0], a[1]), (b[0],))


def third(x):
    return (x / number(3, x) * x,)


def other(x):
    return (x,)


KERNEL = Kernel(toy, (toy_rows,), toy_row, (("a", (2,)), ("b", (1,))), (3,), real=True)


def made(owner, scalar):
    return Compiled(KERNEL, Programs((toy,), {"third": scalar}, owner))
"""
"""Module with a kernel of a chart's scalar program, as geometry and charts are printed."""


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Provide the name of a package of the run-time files and the kernel, without a chart."""
    folder: Path = tmp_path_factory.mktemp("kernels")
    files.write(folder, shared_texts(TARGETS["numba"]))
    (folder / "toy.py").write_text(TOY, encoding="utf-8")
    with loaded(folder) as name, pytest.MonkeyPatch.context() as patch:
        patch.setattr("numba.config.CACHE_DIR", str(tmp_path_factory.mktemp("numba")))
        yield name


@pytest.fixture
def runtime(package: str) -> Any:
    return importlib.import_module(f"{package}._runtime")


@pytest.fixture
def toy(package: str) -> Any:
    return importlib.import_module(f"{package}.toy")


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


def expected(a: Any, b: Any) -> Any:
    """Return the results of the kernel by operations in the type of the arguments."""
    third = (Fraction(1) if a.dtype.hasobject else a.dtype.type(1)) / 3
    chosen = np.where(a[:, 0] < 0, b[:, 0], 2 * a[:, 0])
    return np.stack([chosen, a[:, 1] / 3 * a[:, 1], third + 0 * b[:, 0]], axis=-1)


def test_loops_compute_in_the_type_of_their_arguments(toy: Any) -> None:
    """Compare columns and rows to the bit, of types in turn, and of fractions by the uncompiled text."""
    compiled = toy.made("one", toy.third)
    for dtype in (np.float32, np.float64, object):
        a, b = (np.array([[Fraction(7 * i - 40 + k, 5) for k in range(n)] for i in range(12)]) for n in (2, 1))
        a, b = a.astype(dtype), b.astype(dtype)
        last, first = np.empty((12, 3), dtype), np.empty((3, 12), dtype)
        compiled.over_last([a, b], last)
        compiled.over_rows([a.T, b.T], first, parallel=False)
        assert np.array_equal(last, expected(a, b))
        assert np.array_equal(first, last.T)


def test_parallel_calls_take_parallel_loops(toy: Any) -> None:
    compiled, called = toy.made("one", toy.third), []
    vars(compiled).update(
        loops=[lambda *_: called.append("loops")], parallel_loops=[lambda *_: called.append("parallel")]
    )
    for parallel in (False, True):
        compiled.over_rows([np.empty((2, 1)), np.empty((1, 1))], np.empty((3, 1)), parallel)
    assert called == ["loops", "parallel"]
    assert toy.made("one", toy.third).parallel_loops[0].targetoptions["parallel"] is True


def test_copies_of_a_loop_have_the_names_and_programs_of_their_charts(toy: Any, package: str) -> None:
    """Require what Numba's cache on disk knows them by: other names for charts, another digest for other programs."""
    one, two = toy.made("one", toy.third), toy.made("two", toy.other)
    a, b, found = np.array([3.0, 6.0]), np.array([0.0]), np.empty(3)
    for each, wanted in ((one, 12.0), (two, 6.0)):
        each.over_last([a, b], found)
        assert found[1] == wanted
    assert [each.kernel.row.__qualname__ for each in (one, two)] == ["one.toy_row", "two.toy_row"]
    digest = importlib.import_module(f"{package}._compiled").digest
    digests = [digest({"first": toy.toy, "second": scalar}) for scalar in (toy.third, toy.other, toy.third)]
    assert digests[0] != digests[1]
    assert digests[0] == digests[2]
