"""Numba target, in comparison with the oracle, the NumPy kernels in every layout and the documented interface."""

from __future__ import annotations

import importlib
import re
import shutil
import subprocess
import sys
from functools import partial
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from derive.codegen.signatures import KERNELS, geometry
from derive.codegen.targets import numba as printer
from tests.support import sampling
from tests.support.kernels import load
from tests.support.layouts import BATCHES, require_strides_of_one_ignored
from tests.support.libraries import numba
from tests.support.signatures import (
    SIGNATURES,
    assert_nearly_equal,
    components_first,
    components_last,
    inputs,
    rows_of,
)
from tests.support.trial import FUNCTIONS, Trial

pytestmark = pytest.mark.thorough

ORDER = 3
KINDS = {(row.arguments, row.result): name for name, row in SIGNATURES.items() if not name.startswith("dcay")}
"""Sample of functions, one for each kind of arguments and result: a loop over columns takes seconds to compile."""
REGIMES = ("uniform", "shadow", "pure translation", "below pi", "coordinate axes")
"""Regimes on both sides of each selection."""


@pytest.fixture
def inside(package):
    """Return the function ``compiled`` of the package, which makes a kernel callable from compiled code."""
    return importlib.import_module(package("numba")).compiled


@pytest.mark.parametrize("name", FUNCTIONS)
def test_gates_of_the_oracle_hold(compiled, name):
    for regime in REGIMES:
        Trial(compiled(ORDER), ORDER, regime, count=1).check(name)


@pytest.mark.parametrize("name", KINDS.values())
def test_rows_are_the_same_program(compiled, name):
    values = inputs(load(ORDER), name, ORDER, (3, 7))
    rank = len(SIGNATURES[name].result)
    last = getattr(compiled(ORDER), name)(*values)
    first = getattr(compiled(ORDER), name)(*(components_first(a, a.ndim - 2) for a in values), axis=0)
    assert_nearly_equal(components_last(first, rank), last, eps=40)
    assert_nearly_equal(last, getattr(load(ORDER), name)(*values), eps=40)


# compiled loops of further charts, with and without selections; validation covers the source of every order


@pytest.mark.parametrize(("name", "rank"), [("transform_point", 1), ("pose", 2)])
def test_parallel_loops(compiled, name, rank):
    """Test a result in one part and one in several."""
    values, parallel = inputs(load(ORDER), name, ORDER, (200,)), getattr(compiled(ORDER), name)
    expected, rows = getattr(load(ORDER), name)(*values), [components_first(a, 1) for a in values]
    assert_nearly_equal(parallel(*values, parallel=True), expected, eps=40)
    assert_nearly_equal(components_last(parallel(*rows, axis=0, parallel=True), rank), expected, eps=40)


def test_out_is_written_and_may_overlap(compiled):
    module, v = compiled(ORDER), sampling.poses(ORDER, "shadow", count=4)
    expected = load(ORDER).principal(v)
    out = np.empty_like(v)
    assert module.principal(v, out=out) is out
    assert_nearly_equal(out, expected)
    assert module.principal(v, out=v) is v
    assert_nearly_equal(v, expected)
    wide = np.empty((4, 4, 8))[..., ::2]
    pose = module.pose(v, out=wide)
    assert pose is wide
    assert_nearly_equal(np.ascontiguousarray(wide), load(ORDER).pose(v), eps=40)
    with pytest.raises(ValueError, match=r"out must have shape \(4, 4, 4\)"):
        module.pose(v, out=np.empty((4, 4)))


@pytest.mark.parametrize("name", list(KINDS.values())[::3])
def test_axes_of_length_1_may_have_any_stride(compiled, name):
    for shape in BATCHES:
        values = inputs(load(ORDER), name, ORDER, shape)
        for axis, given in ((-1, values), (0, rows_of(name, values))):
            function = partial(getattr(compiled(ORDER), name), axis=axis)
            require_strides_of_one_ignored(function, given, assert_nearly_equal)


def test_complex_vectors(compiled):
    v = sampling.poses(ORDER, "uniform") + 0.01j
    got = compiled(ORDER).quaternion(v)
    assert got.dtype == np.complex128
    np.testing.assert_allclose(got, load(ORDER).quaternion(v), atol=1e-14)
    with pytest.raises(TypeError, match="v must be real"):
        compiled(ORDER).principal(v)


def test_wrong_arguments_are_named(compiled):
    module = compiled(ORDER)
    with pytest.raises(ValueError, match=r"v must have shape \(\.\.\., 6\), got \(6, 5\)"):
        module.pose(np.zeros((6, 5)))
    with pytest.raises(TypeError, match="v must be of a type Numba compiles"):
        module.pose(np.zeros(6, np.longdouble))
    with pytest.raises(ValueError, match="broadcast together"):
        module.rate(np.zeros((2, 6)), np.zeros((3, 6)))
    assert module.pose(np.zeros((0, 6))).shape == (0, 4, 4)
    with pytest.raises(ValueError, match=r"det Q is not 1, off by 0\.33 \(allowed 0\.3\)"):
        module.from_pose(np.diag([1.1, 1.1, 1.1, 1]), check=0.3)
    assert module.from_pose(np.diag([1.1, 1.1, 1.1, 1]), check=0.4).shape == (6,)
    with pytest.raises(ValueError, match=r"covariance must be symmetric, got entries that differ by 1$"):
        module.switch(np.ones((2, 6)), covariance=np.stack([np.eye(6), np.tri(6)]))


def test_singular_points_are_ieee_results_without_a_warning(compiled):
    assert np.isnan(compiled(ORDER).shadow(np.zeros(6))).all()
    half_turn = np.eye(8)[1]
    assert not np.isfinite(compiled(1).from_quaternion(half_turn)).all()


def test_no_loop_stores_more_than_is_vectorised():
    for name, program in geometry().items():
        loops = printer.loops(KERNELS[name], program)
        assert all(rows.count("out[") <= printer.MOST_OUTPUTS for rows in loops.rows)
        assert all("".join(loops.rows).count(f"out[{i}, i]") == 1 for i in range(len(program.outputs)))
        assert all(loops.alone.count(f"out[{i}]") == 1 for i in range(len(program.outputs)))


@pytest.mark.parametrize("name", ["quaternion", "tensor", "pose", "tangent", "twist", "rate", "shadow", "principal"])
def test_loops_without_trigonometry_are_vectorised(compiled, name, monkeypatch):
    module = compiled(ORDER)
    kernel = module.CHART.kernels[name]
    # loops from the disk cache have no LLVM text, so they are compiled again
    loops = [numba.jit(**loop.targetoptions)(loop.py_func) for loop in kernel.loops]
    monkeypatch.setattr(kernel, "loops", loops)
    getattr(module, name)(*(components_first(a, 1) for a in inputs(load(ORDER), name, ORDER, (9,))), axis=0)
    for loop in loops:
        (text,) = loop.inspect_llvm().values()
        assert re.search(r"= fmul .*<\d+ x double>", text)


@pytest.fixture
def imported(package, tmp_path, monkeypatch):
    """Provide a function that changes a module in a copy of the package and imports the copy, like another process."""
    name = package("numba")
    source = next(Path(p) / name for p in sys.path if (Path(p) / name).is_dir())
    folder = shutil.copytree(source, tmp_path / "kept_on_disk", ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.syspath_prepend(tmp_path)

    def again(order: int, old: str = "", new: str = "") -> ModuleType:
        path = folder / f"cayley{order}.py"
        text = path.read_text(encoding="utf-8")
        assert old in text
        path.write_text(text.replace(old, new), encoding="utf-8")
        for loaded in [key for key in sys.modules if key.partition(".")[0] == folder.name]:
            monkeypatch.delitem(sys.modules, loaded)
        importlib.invalidate_caches()
        return importlib.import_module(f"{folder.name}.cayley{order}")

    return again


def test_compiled_loops_are_kept_on_disk_for_each_chart_and_its_scalars(imported):
    v = components_first(sampling.poses(ORDER, "uniform"), 1)

    def hits(module: ModuleType) -> int:
        (loop,) = module.CHART.kernels["quaternion"].loops
        return sum(loop.stats.cache_hits.values())

    for order, kept in ((3, 0), (3, 1), (4, 0)):
        module = imported(order)
        assert_nearly_equal(module.quaternion(v, axis=0), load(order).quaternion(v, axis=0), eps=40)
        assert hits(module) == kept
    negative = imported(3, "s = p * r", "s = -p * r")
    assert_nearly_equal(negative.quaternion(v, axis=0)[0], -load(3).quaternion(v, axis=0)[0], eps=40)
    assert hits(negative) == 0


def test_without_numba_the_import_says_what_is_missing(package):
    name = package("numba")
    folder = Path(sys.modules[name].__file__).parent.parent if name in sys.modules else None
    folder = folder or next(Path(p) for p in sys.path if (Path(p) / name).is_dir())
    code = (
        f"import sys; sys.path.insert(0, {str(folder)!r}); import importlib.util as u; find = u.find_spec\n"
        "u.find_spec = lambda name, *a: None if name == 'numba' else find(name, *a)\n"
        f"import {name}"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert f"ImportError: {name} is compiled by Numba, which is not installed: pip install numba" in done.stderr


def test_kernels_are_callable_from_compiled_code(compiled, inside):
    """Call functions of the space and the body frame, which share a kernel with different constants."""
    rate, twist = inside(compiled(ORDER).rate), inside(compiled(ORDER).body_twist)

    @numba.njit
    def both(v, omega, v_dot, back):
        for i in range(len(v)):
            rate(v[i], omega[i], v_dot[i])
            twist(v[i], v_dot[i], back[i])

    for dtype, eps in ((np.float64, 40), (np.float32, 40)):
        v, omega = inputs(load(ORDER), "rate", ORDER, (4,), dtype)
        v_dot, back = np.empty_like(v), np.empty_like(v)
        both(v, omega, v_dot, back)
        assert_nearly_equal(v_dot, load(ORDER).rate(v, omega), eps=eps)
        assert_nearly_equal(back, load(ORDER).body_twist(v, v_dot), eps=eps)


def test_compiled_functions_are_cached(compiled, inside):
    """Check that each function is compiled once, and separately for other constants of the same kernel."""
    module = compiled(ORDER)
    assert inside(module.twist) is inside(module.twist)
    assert inside(module.twist) is not inside(module.body_twist)


def test_functions_without_kernel_are_refused(compiled, inside):
    module = compiled(ORDER)
    for other in (np.tan, module.shadow, module.principal, module.singular_angles, load(ORDER).pose, 3):
        with pytest.raises(TypeError, match=r"expected a function .* that is a kernel, as cayley3\.pose, got"):
            inside(other)


def test_compiled_kernel_refuses_arrays_of_other_sizes(compiled, inside):
    pose, v = inside(compiled(ORDER).pose), np.zeros(6)
    memory = np.zeros((8, 16))
    for given in ((v, memory[0].reshape(4, 4)), (v, memory[0, :15]), (v, memory[:2].ravel()), (v[:5], memory[0])):
        with pytest.raises(ValueError, match="expected arrays of one axis with 6, 16 components"):
            pose(*given)
    assert not memory.any()


@pytest.mark.parametrize("dtype", [">f4", ">f8"])
def test_byte_swapped_arrays_are_converted(compiled, dtype):
    v = sampling.poses(ORDER, "uniform").astype(dtype)
    got = compiled(ORDER).pose(v)
    assert got.dtype == np.dtype(dtype).newbyteorder("=")
    np.testing.assert_array_equal(got, compiled(ORDER).pose(v.astype(got.dtype)))
