"""Array-api target in every library, in comparison with oracle, NumPy kernels and documented interface; its switch."""

from __future__ import annotations

import re
import subprocess
import sys
from functools import partial
from itertools import product
from pathlib import Path

import array_api_strict
import numpy as np
import pytest

import dualcay
from tests.support import libraries, sampling
from tests.support.kernels import load
from tests.support.layouts import BATCHES, require_strides_of_one_ignored
from tests.support.libraries import Through, jax
from tests.support.signatures import (
    SIGNATURES,
    assert_nearly_equal,
    components_first,
    components_last,
    inputs,
    rows_of,
)
from tests.support.trial import FUNCTIONS, Trial

ON_GPU = [pytest.param(library, marks=pytest.mark.gpu) for library in ("torch on a GPU", "cupy")]
LIBRARIES = [
    "numpy", "array-api-strict", "jax traced", "dask", pytest.param("jax", marks=pytest.mark.thorough),
    pytest.param("torch", marks=pytest.mark.torch), *ON_GPU
]  # fmt: skip
LIBRARY = pytest.mark.parametrize("library", LIBRARIES)
STRICT = pytest.mark.parametrize("library", LIBRARIES[1:])
"""Libraries but NumPy, whose functions the strict library is made of."""
# libraries based on NumPy warn of NaN and infinity at singular points
pytestmark = pytest.mark.filterwarnings("ignore:(invalid value|divide by zero):RuntimeWarning")

SOME = ("uniform", "pure translation", "shadow")
"""Regimes for libraries that compute with NumPy, in turn, since validation also computes with NumPy."""
REGIMES = (*SOME, "angle 1e-7", "below pi", "translation 1e6")
OWN_FUNCTIONS = ("torch", "torch on a GPU", "cupy")
"""Quick libraries that do not compute with NumPy; every regime is tried."""
FEW = ("pose", "compose", "shadow")
"""Sample for libraries that compile or plan every operation: one and two arguments, a real map."""
KINDS = {(len(row.arguments), len(row.result)): name for name, row in SIGNATURES.items()}
"""Sample of functions: one for each number of arguments and of result axes."""
SAMPLE = {"jax": FEW, "dask": FEW[::2], "jax traced": (*KINDS.values(), "from_pose", "compose")}
"""Functions that a slow library is tried with; others try all."""


@STRICT
def test_gates_of_the_oracle_hold_in_every_library(array_api, library):
    module = Through(array_api(3), library)
    for place, name in enumerate(SAMPLE.get(library, FUNCTIONS if library in OWN_FUNCTIONS else FUNCTIONS[::4])):
        for regime in REGIMES if library in OWN_FUNCTIONS else SOME[place % 3 :][:1]:
            Trial(module, 3, regime, count=1).check(name)


@pytest.mark.parametrize("library", ON_GPU)
def test_results_stay_on_the_gpu(array_api, library):
    convert, module, kernel = libraries.LIBRARIES[library](), array_api(2), load(2)
    for name in SIGNATURES:
        values = [convert(value) for value in inputs(kernel, name, 2, (5,))]
        assert getattr(module, name)(*values).device == values[0].device, name


@STRICT
def test_other_orders_agree_with_the_numpy_kernels(array_api, library):
    for order in (2,) if library in SAMPLE else (1, 8):
        module, kernel = Through(array_api(order), library), load(order)
        for name in SAMPLE.get(library, SIGNATURES):
            values = inputs(kernel, name, order, (5,))
            assert_nearly_equal(getattr(module, name)(*values), getattr(kernel, name)(*values), eps=40)


@LIBRARY
@pytest.mark.parametrize("dtype", [np.float32, np.complex128])
def test_types_are_kept(array_api, library, dtype):
    module = Through(array_api(3), library)
    for name in SAMPLE.get(library, SIGNATURES if dtype == np.float32 else KINDS.values()):
        signature, values = SIGNATURES[name], inputs(load(3), name, 3, (4,), dtype)
        if np.dtype(dtype).kind == "c" and not signature.complex:
            with pytest.raises(TypeError, match="must be real"):
                getattr(module, name)(*values)
        else:
            assert getattr(module, name)(*values).dtype == dtype


@LIBRARY
def test_integers_become_floating_point_numbers(array_api, library):
    for dtype in (int, np.uint8):
        got = Through(array_api(2), library).pose(np.array([[0, 1, 0, 2, 0, 0]], dtype))
        assert got.dtype.kind == "f"
        np.testing.assert_allclose(got, load(2).pose([[0.0, 1, 0, 2, 0, 0]]), rtol=1e-6, atol=1e-6)


@STRICT
def test_components_first_and_broadcasting(array_api, library):
    module = Through(array_api(3), library)
    for name in FEW[1:2] if library == "dask" else SAMPLE.get(library, SIGNATURES):
        kinds, result, _ = SIGNATURES[name]
        values = inputs(load(3), name, 3, (2, 3))
        last = getattr(module, name)(*values)
        first = [components_first(a, a.ndim - 2) for a in values]
        assert last.shape == (2, 3, *result)
        assert_nearly_equal(components_last(getattr(module, name)(*first, axis=0), len(result)), last)
        if len(kinds) == 2:
            for place, shape in ((0, (3,)), ((0, 0), ())):  # batches of fewer axes: their axes are the last ones
                found = getattr(module, name)(values[0], values[1][place])
                assert found.shape == last.shape
                np.testing.assert_array_equal(found[(0,) * (2 - len(shape))], last[(0,) * (2 - len(shape))])
        one = getattr(module, name)(*(np.asarray(a[1, 2]) for a in values))
        assert_nearly_equal(one, last[1, 2])


@pytest.mark.parametrize("axis", [-1, 0])
def test_axes_of_length_1_may_have_any_stride(array_api, axis):
    for name, shape in product(SIGNATURES, BATCHES[2:4]):
        values = inputs(load(3), name, 3, shape)
        given = rows_of(name, values) if axis == 0 else values
        function = partial(getattr(array_api(3), name), axis=axis)
        require_strides_of_one_ignored(function, given, assert_nearly_equal, out=False)


@LIBRARY
def test_empty_batches(array_api, library):
    if library == "dask":
        library = "numpy"  # dask arrays need at least one chunk
    assert Through(array_api(3), library).pose(np.empty((0, 6))).shape == (0, 4, 4)


@LIBRARY
def test_wrong_arguments_are_named(array_api, library):
    module = Through(array_api(3), library)
    with pytest.raises(ValueError, match=r"v must have shape \(\.\.\., 6\), got \(6, 5\)"):
        module.pose(np.zeros((6, 5)))
    with pytest.raises(ValueError, match="axis must be -1"):
        module.pose(np.zeros((6, 5)), axis=1)
    with pytest.raises(ValueError, match=r"broadcast together, got \(2,\) of v and \(3,\) of r"):
        module.transform_point(np.zeros((2, 6)), np.zeros((3, 3)))
    with pytest.raises(TypeError, match="branch must be an integer"):
        module.shadow(np.zeros((2, 6)), 0.5)
    with pytest.raises(TypeError, match=r"v must be an array of NumPy, JAX, PyTorch or the like, got list"):
        array_api(3).pose([0.0] * 6)


@LIBRARY
def test_nan_stays_in_its_element_and_the_identity_has_no_other_branch(array_api, library):
    module = Through(array_api(3), library)
    v = sampling.poses(3, "uniform", count=4)
    v[1, 0] = np.nan
    for name in (*FEW[::2], *(("quaternion", "tangent", "tangent_inv", "principal") if library != "dask" else ())):
        finite = np.isfinite(getattr(module, name)(v)).reshape(4, -1).all(axis=-1)
        assert finite.tolist() == [True, False, True, True]
    assert np.isnan(module.shadow(np.zeros((1, 6)), 1)).all()
    assert (module.principal(np.zeros((1, 6))) == 0).all()


def test_dask_arrays_stay_lazy_and_keep_their_blocks(array_api):
    import dask.array

    v = sampling.poses(3, "uniform", count=4)
    lazy = dask.array.from_array(v, chunks=(2, 6))
    pose = array_api(3).from_pose(array_api(3).pose(lazy))
    assert isinstance(pose, dask.array.Array)
    assert pose.dtype == v.dtype
    assert pose.chunks == ((2, 2), (6,))
    assert_nearly_equal(pose.compute(), load(3).from_pose(load(3).pose(v)), eps=40)


def test_matrix6(array_api):
    package = sys.modules[array_api(3).__package__]
    D = load(3).tangent(sampling.poses(3, "uniform"))
    np.testing.assert_array_equal(package.matrix6(D), dualcay.matrix6(D))


def test_the_package_imports_no_array_library(array_api):
    module = array_api(3)
    folder = Path(module.__file__).parent
    code = (
        f"import sys; sys.path.insert(0, {str(folder.parent)!r}); import {folder.name}.cayley3; "
        "print(sorted({'numpy', 'jax', 'torch', 'dask', 'sympy'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
    for path in set(folder.glob("*.py")) - {folder / "_jax.py", folder / "_torch.py"}:  # imported for their arrays
        text = path.read_text(encoding="utf-8")
        assert not re.search(r"^\s*(?:import|from) (?:numpy|jax|torch|dask)|\beval\(", text, re.MULTILINE), path.name


def arguments() -> list[np.ndarray]:
    rng = np.random.default_rng(0)
    root = rng.normal(size=(5, 6, 6))
    return [rng.normal(size=(5, 6)), rng.normal(size=(5, 6)), root @ root.swapaxes(-1, -2)]


@pytest.mark.parametrize("library", ["numpy", "array-api-strict", "jax traced"])
def test_a_switch_agrees_with_the_numpy_kernels(array_api, library):
    """Compare to 1e-12: entries reach 60, and both targets run the same programs."""
    found, wanted = Through(array_api(2), library).switch(*arguments()), dualcay.cayley2.switch(*arguments())
    changed = np.any(wanted[0] != arguments()[0], axis=-1)
    assert changed.sum() == 4
    for a, b, given in zip(found, wanted, arguments(), strict=True):
        np.testing.assert_allclose(a, b, rtol=0, atol=1e-12)
        np.testing.assert_array_equal(a[~changed], given[~changed])


def test_a_switch_of_an_infinite_vector_leaves_no_rate(array_api):
    """Take a chart of one branch, where v itself stays."""
    v = np.array([np.inf, 0, 0, 0, 0, 0])
    for module in (array_api(1), dualcay.cayley1):
        with np.errstate(all="ignore"):
            _, *found = module.switch(v, np.ones(6), np.eye(6))
        assert not any(np.isfinite(part).any() for part in found)


def test_covariances_that_are_not_symmetric_are_refused_where_values_are_known(array_api):
    v, v_dot, P = arguments()
    P[3, 1, 2] += 1e-6
    for make, axis in product((np.asarray, array_api_strict.asarray), (-1, 0)):
        given = [v, v_dot, P] if axis else [v.T, v_dot.T, np.moveaxis(P, 0, -1)]
        with pytest.raises(ValueError, match="covariance must be symmetric, got entries that differ by 1e-06"):
            array_api(2).switch(*map(make, given), axis=axis)
    assert Through(array_api(2), "jax traced").switch(v, v_dot, P)[2].shape == P.shape


def test_a_scan_that_switches_never_leaves_the_principal_branch(array_api):
    module, omega = array_api(2), jax.numpy.array([1, 0.2, 0.3, 0.1, 0, 0])

    def step(v, _):
        v = module.switch(v + 0.01 * module.rate(v, omega))
        return v, v

    _, v = jax.lax.scan(step, jax.numpy.zeros(6), None, length=1000)
    sizes = np.linalg.norm(np.asarray(v)[:, :3], axis=-1)
    assert 0.99 < sizes.max() <= 1 + 1e-6
    assert np.count_nonzero(np.diff(np.asarray(v)[:, 0]) < -0.5) == 2  # 10 s at 1.06 rad/s pass π and 3π
