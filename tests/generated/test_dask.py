"""Kernels on Dask arrays: shapes and dtypes before computing, values equal in every bit, a cluster of processes."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import dask.array as da
import numpy as np
import pytest

from derive.codegen.rows import Function
from derive.codegen.signatures import POSES, ROTATIONS
from dualcay import cayley3, exponential, rotation
from dualcay._checks import LAWS, ROTATION_LAWS, Law
from dualcay.dask import apply
from tests.support import thorough

RNG = np.random.default_rng(20)
COUNT, CHUNKS, OTHERS = 120, (30, 60, 30), (60, 60)  # blocks above 20 poses: smaller ones run on Python floats
MODULES = ((cayley3, POSES), (rotation.cayley3, ROTATIONS))
ROWS = [(module, row) for module, table in MODULES for row in table.public.values()]


def arguments(row: Function, axis: int) -> list[np.ndarray]:
    """Return random arguments for a batch; kernels take those that are no rotations too."""
    shapes = [array.shape for array in row.arguments]
    return [RNG.uniform(-1, 1, (*shape, COUNT) if axis == 0 else (COUNT, *shape)) for shape in shapes]


def chunked(array: np.ndarray, chunks: tuple[int, ...], axis: int) -> Any:
    """Return a Dask array with chunks along the batch."""
    inner = array.shape[:-1] if axis == 0 else array.shape[1:]
    return da.from_array(array, chunks=(*inner, chunks) if axis == 0 else (chunks, *inner))


def assert_same(lazy: Any, serial: Any) -> None:
    """Require equal shapes and dtypes before computing, and equal bits after it."""
    for one, expected in zip(*(x if isinstance(x, tuple) else (x,) for x in (lazy, serial)), strict=True):
        assert (one.shape, one.dtype) == (expected.shape, expected.dtype)
        computed = one.compute(scheduler="synchronous")
        assert (computed.shape, computed.dtype) == (expected.shape, expected.dtype)
        np.testing.assert_array_equal(computed, expected)


@thorough.shares(1, 3)
def test_every_function_equals_the_kernel_on_arrays(share: int) -> None:
    """Every function passes one text, with its shapes; a share of them is tried along each axis."""
    for place, (module, row) in enumerate(ROWS):
        axis, kernel = -(place % 2), getattr(module, row.name)
        if place // 2 % share:
            continue
        given = arguments(row, axis)
        lazy = [chunked(array, chunks, axis) for array, chunks in zip(given, (CHUNKS, OTHERS, CHUNKS))]
        with np.errstate(all="ignore"):
            assert_same(apply(kernel, *lazy, axis=axis), kernel(*given, axis=axis))


@pytest.mark.smoke
def test_chunks_of_several_arguments_are_aligned() -> None:
    given = arguments(POSES.public["compose"], -1)
    lazy = [chunked(array, chunks, -1) for array, chunks in zip(given, (CHUNKS, OTHERS))]
    result = apply(cayley3.compose_jacobians, *lazy)
    assert [one.chunks for one in result] == [((30, 30, 30, 30), (6,), (6,))] * 2
    assert_same(result, cayley3.compose_jacobians(*given))


def test_batches_broadcast_with_arrays_of_numpy_and_plain_numbers() -> None:
    v, r = RNG.uniform(-1, 1, (5, 1, 6)), RNG.uniform(-1, 1, (30, 3))
    assert_same(apply(cayley3.transform_point, da.from_array(v, chunks=(2, 1, 6)), r), cayley3.transform_point(v, r))
    assert_same(apply(cayley3.pose, da.from_array(v[0, 0])), cayley3.pose(v[0, 0]))
    assert_same(apply(cayley3.pose, v[:0]), cayley3.pose(v[:0]))
    assert_same(
        apply(cayley3.interpolate, da.from_array(v[:, 0]), v2=v[0], t=0.3), cayley3.interpolate(v[:, 0], v[0], 0.3)
    )
    for dtype in (np.float32, np.longdouble, int):
        one, two = (3 * v).astype(dtype), (2 * v[:1]).astype(dtype)
        assert_same(apply(cayley3.interpolate, da.from_array(one), two, 0.3), cayley3.interpolate(one, two, 0.3))


def test_further_arguments_reach_the_kernel() -> None:
    v = RNG.uniform(-1, 1, (COUNT, 6))
    lazy = chunked(v, CHUNKS, -1)
    assert_same(apply(cayley3.shadow, lazy, branch=2), cayley3.shadow(v, branch=2))
    poses = apply(cayley3.pose, lazy)
    assert_same(apply(cayley3.from_pose, poses, check=True), cayley3.from_pose(cayley3.pose(v), check=True))
    with pytest.raises(ValueError, match="is no homogeneous matrix"):
        apply(cayley3.from_pose, 2 * poses, check=True).compute(scheduler="synchronous")


CHECKS = [
    (module, table.public[name], law)
    for (module, table), laws in zip(MODULES, (LAWS, ROTATION_LAWS), strict=True)
    for name, law in laws.items()
]


@pytest.mark.parametrize("axis", [-1, 0])
@pytest.mark.parametrize(("module", "row", "law"), CHECKS, ids=lambda x: getattr(x, "name", ""))
def test_check_names_the_element_of_the_whole_array(module: Any, row: Function, law: Law, axis: int) -> None:
    """Violate the condition of one element after another, in blocks along three axes of the batch."""
    kernel, inverse = getattr(module, row.name), getattr(module, row.name.replace("from_", "to_"), None)
    found = (inverse or getattr(module, row.name[5:]))(RNG.uniform(-1, 1, (5, 3, 4, module.identity().size)))
    whole = [*found] if isinstance(found, tuple) else [found]
    place = [array.name for array in row.arguments].index(law.argument)
    for index in [(0, 0, 0), (1, 0, 2), (2, 0, 0), (4, 1, 3), (3, 2, 0)]:
        given = [array.copy() for array in whole]
        given[place][index] *= 2
        chunks = [((2, 3), (1, 2), (3, 1), *array.shape[3:]) for array in given]
        if axis == 0:
            given = [np.moveaxis(array, (0, 1, 2), (-3, -2, -1)) for array in given]
            chunks = [(*one[3:], *one[:3]) for one in chunks]
        with pytest.raises(ValueError, match=f"{law.argument}.* is no") as expected:
            kernel(*given, axis=axis, check=True)
        lazy = apply(kernel, *map(da.from_array, given, chunks), axis=axis, check=True)
        with pytest.raises(ValueError, match="is no") as caught:
            lazy.compute(scheduler="synchronous")
        assert str(caught.value) == str(expected.value)


def test_sizes_of_chunks_may_be_unknown() -> None:
    v = RNG.uniform(-1, 1, (COUNT, 6))
    lazy = chunked(v, (60, 60), -1)
    chosen = apply(cayley3.pose, lazy[lazy[:, 0] > 0])
    assert np.isnan(chosen.shape[0])
    np.testing.assert_array_equal(chosen.compute(scheduler="synchronous"), cayley3.pose(v[v[:, 0] > 0]))
    poses = apply(cayley3.from_pose, da.concatenate([chosen, 2 * chosen.blocks[:1]]), check=True)
    with pytest.raises(ValueError, match=r"^in block \(2, 0, 0\), T\[0\] is no homogeneous matrix"):
        poses.compute(scheduler="synchronous")


V = da.zeros((COUNT, 6), chunks=(CHUNKS, 6))
REFUSED = [
    (cayley3.pose, [V.rechunk((40, 3))], {}, ValueError, r"one chunk .*\(3, 3\)\): call v.rechunk\({1: -1}\)"),
    (cayley3.pose, [V.T.rechunk((3, 40))], {"axis": 0}, ValueError, r"v must have one chunk .*v.rechunk\({0: -1}\)"),
    (cayley3.pose, [V[:, :5]], {}, ValueError, r"v must have shape \(..., 6\), got \(120, 5\)"),
    (cayley3.twist, [V, V.T], {"axis": 0}, ValueError, r"v must have shape \(6, ...\), got \(120, 6\)"),
    (cayley3.compose, [V, V[:7]], {}, ValueError, r"broadcast together, got \(120,\) of v2 and \(7,\) of v1"),
    (cayley3.pose, [V], {"axis": 1}, ValueError, "axis must be -1"),
    (cayley3.compose, [V], {}, TypeError, r"compose takes 2 arrays \(v2, v1\), got 1"),
    (cayley3.principal, [V + 0j], {}, TypeError, "v must be real"),
    (cayley3.pose, [V], {"out": V}, TypeError, "out cannot be given"),
    (cayley3.identity, [], {}, TypeError, "must be a function of a kernel module"),
    (cayley3.switch, [V], {}, TypeError, "with arrays of fixed number and shape"),
    (np.sin, [V], {}, TypeError, "must be a function of a kernel module"),
]


@pytest.mark.parametrize(("kernel", "arrays", "options", "error", "message"), REFUSED)
def test_wrong_arguments_are_refused_before_computing(
    kernel: Any, arrays: Any, options: Any, error: Any, message: str
) -> None:
    with pytest.raises(error, match=message):
        apply(kernel, *arrays, **options)


def test_missing_dask_is_an_error_that_says_how_to_install_it() -> None:
    code = "import sys; sys.modules['dask'] = None; import dualcay; print(len(dir(dualcay))); dualcay.dask.apply(None)"
    path = str(Path(cayley3.__file__).parents[1])
    run = [sys.executable, "-c", code]
    done = subprocess.run(run, env={**os.environ, "PYTHONPATH": path}, capture_output=True, text=True)
    assert int(done.stdout) > 15
    assert done.stderr.splitlines()[-1] == 'ImportError: dualcay.dask needs Dask: pip install "dask[array]"'


@pytest.fixture(scope="module")
def client() -> Iterator[Any]:
    """Provide two worker processes on the loopback, at any free port."""
    import distributed  # late, since it takes a second in each process that collects tests

    options = {"n_workers": 2, "threads_per_worker": 1, "host": "127.0.0.1", "dashboard_address": "127.0.0.1:0"}
    with distributed.LocalCluster(**options) as cluster, distributed.Client(cluster) as client:
        yield client


@pytest.mark.thorough
def test_two_processes_give_the_same_bits(client: Any) -> None:
    v, w = RNG.uniform(-1, 1, (2, 20_000, 6))
    lazy = [da.from_array(array, chunks=(chunks, 6)) for array, chunks in ((v, 3000), (w, 4500))]
    assert len(set(client.run(os.getpid).values()) - {os.getpid()}) == 2
    for kernel in (cayley3.compose, exponential.compose, exponential.retract):
        np.testing.assert_array_equal(client.compute(apply(kernel, *lazy)).result(), kernel(v, w))
    found = client.compute(apply(cayley3.compose_jacobians, *lazy), sync=True)
    np.testing.assert_array_equal(found, cayley3.compose_jacobians(v, w))
