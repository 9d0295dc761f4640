"""Calls of array-api kernels with arrays of several libraries: NumPy arrays are converted to the other library."""

from __future__ import annotations

import importlib
from itertools import product

import numpy as np
import pytest

from derive.codegen.signatures import PUBLIC, ROTATIONS
from tests.support import conditions, traced
from tests.support.kernels import load
from tests.support.libraries import LIBRARIES, on_host
from tests.support.rotation_arguments import arguments
from tests.support.signatures import SIGNATURES, assert_nearly_equal, inputs

SEVERAL = [name for name, row in PUBLIC.items() if name in SIGNATURES and len(row.arguments) > 1]
OF_ROTATIONS = [name for name, row in ROTATIONS.public.items() if len(row.arguments) > 1]
FOREIGN = [
    "jax", "dask", pytest.param("torch", marks=pytest.mark.torch),
    *(pytest.param(library, marks=pytest.mark.gpu) for library in ("torch on a GPU", "cupy")),
]  # fmt: skip

V, W = np.array([0.1, 0.2, -0.3, 1.0, -2.0, 0.5]), np.array([0.4, -0.1, 0.2, 0.3, 0.6, -0.7])


@pytest.fixture(scope="module")
def strict():
    return pytest.importorskip("array_api_strict")


@pytest.fixture(scope="module")
def jax():
    module = pytest.importorskip("jax")
    LIBRARIES["jax"]()
    return module


@pytest.fixture
def module(array_api):
    return array_api(3)


@pytest.fixture
def rotations(package):
    return importlib.import_module(f"{package('array-api')}.rotation.cayley3")


def assert_taken(function, values, convert):
    """Require, for any mix with NumPy arrays, that results are arrays of the library, on its device, and right."""
    expected, like = several(function(*values)), convert(V)
    for chosen in product([True, False], repeat=len(values)):
        if any(chosen):
            given = [convert(value) if one else value for value, one in zip(values, chosen, strict=True)]
            for found, wanted in zip(several(function(*given)), expected, strict=True):
                assert (type(found), place(found)) == (type(like), place(like))
                assert_nearly_equal(on_host(found), wanted, eps=40)


def place(array):
    return getattr(array, "device", None)  # arrays of Dask have none


def several(found):
    return found if isinstance(found, tuple) else (found,)


# --- choice of the library ----------------------------------------------------------------------------------------


def test_numpy_arguments_are_converted_in_every_function_of_several_arrays(module, strict):
    assert {len(PUBLIC[name].arguments) for name in SEVERAL} == {2, 3}
    for name in SEVERAL:
        assert_taken(getattr(module, name), inputs(load(3), name, 3, (2,)), strict.asarray)


def test_every_function_of_rotations_takes_numpy_arguments(rotations, strict):
    kernels = importlib.import_module("dualcay.rotation.cayley3")
    assert "from_angle_axis" in OF_ROTATIONS
    for name in OF_ROTATIONS:
        assert_taken(getattr(rotations, name), arguments(ROTATIONS.public[name], kernels), strict.asarray)


def test_other_libraries_take_branch_and_check(module, strict):
    angle, line = np.array([0.5, 0.2]), np.array([0.6, 0, 0.8, 0, 2.0, 0])
    assert_taken(lambda a, u: module.from_screw(a, u, check=True), [angle, line], strict.asarray)
    for check, said in ((0.1, r"off by 0\.21 \(allowed 0\.1\)"), (-1, "check must be at least 0"), (True, "1.49e-08")):
        with pytest.raises(ValueError, match=said):
            module.from_screw(strict.asarray(angle), strict.asarray(1.1 * line), check=check)
    assert module.from_screw(strict.asarray(angle), strict.asarray(1.1 * line), check=0.3).shape == (6,)
    with pytest.raises(ValueError, match="off by nan"):
        module.from_screw(strict.asarray(angle), strict.asarray(np.nan * line), check=0.3)
    v = module.from_screw(strict.asarray(angle), line)
    shadow = module.shadow(v, 1)
    assert type(module.compose(V, shadow)) is type(v)
    assert_nearly_equal(np.asarray(shadow), module.shadow(np.asarray(v), 1))


@pytest.mark.parametrize("axis", [-1, 0])
@pytest.mark.parametrize(("kernels", "name"), conditions.REFUSALS)
def test_check_names_the_first_wrong_element_and_its_largest_violation(module, rotations, strict, kernels, name, axis):
    x = conditions.right(kernels, name, V)
    conditions.assert_refused(rotations if kernels == "rotations" else module, kernels, name, x, axis, strict.asarray)


def test_components_first(module, strict):
    values = inputs(load(3), "interpolate", 3, (2,))
    first = [value.T for value in values]
    assert_taken(lambda *given: module.interpolate(*given, axis=0), first, strict.asarray)


@pytest.mark.parametrize("library", FOREIGN)
def test_other_libraries_take_numpy_arguments(module, library):
    assert_taken(module.twist, [np.array([V, W]), np.array([W, V])], LIBRARIES[library]())


@pytest.mark.parametrize("name", ["convert", "convert_jacobian"])
def test_conversion_stays_in_the_library(package, module, strict, name):
    convert = getattr(importlib.import_module(package("array-api")), name)
    other = importlib.import_module(f"{package('array-api')}.cayley2")
    v = module.compose(V, strict.asarray(W))
    found = convert(v, module, other)
    assert type(found) is type(strict.asarray(W))
    assert_nearly_equal(np.asarray(found), convert(np.asarray(v), module, other), eps=40)


# --- types, devices, arguments that are no arrays -----------------------------------------------------------------


def test_types_match_the_library_alone(module, strict):
    single = strict.asarray(W, dtype=strict.float32)
    for v, expected in ((np.float32(V), strict.float32), (V, strict.float64), ((10 * V).astype(int), strict.float32)):
        assert module.twist(v, single).dtype == module.twist(single, v).dtype == expected
    assert module.twist(W, strict.asarray((10 * V).astype(int))).dtype == strict.float64


def test_numbers_and_lists_take_the_type_of_the_arrays(module, strict):
    v, w = np.float32(V), strict.asarray(W, dtype=strict.float32)
    found = module.twist(V.tolist(), w)
    assert found.dtype == strict.float32
    assert_nearly_equal(np.asarray(found), np.asarray(module.twist(strict.asarray(v), w)))
    assert module.interpolate(tuple(V), w, 0.5).dtype == strict.float32
    np.testing.assert_array_equal(module.twist(V, W.tolist()), module.twist(V, W))
    np.testing.assert_array_equal(module.twist([V.tolist()], W), module.twist(V[None], W))


def test_numpy_arguments_move_to_the_device_of_the_other(module, strict):
    device = strict.Device("device1")
    w = strict.asarray(W, device=device)
    assert module.twist(V, w).device == module.twist(w, V).device == device
    assert module.interpolate(V, w, 0.5).device == device


def test_two_libraries_beside_numpy_are_named(module, strict, jax):
    one, other = strict.asarray(W), jax.numpy.asarray(W)
    with pytest.raises(TypeError, match=r"got v of array_api_strict and v_dot of jax\.numpy"):
        module.twist(one, other)
    with pytest.raises(TypeError, match=r"got v_dot of jax\.numpy and v_ddot of array_api_strict"):
        module.twist_dot(V, other, one)
    with pytest.raises(TypeError, match=r"got v2 of array_api_strict and t of jax\.numpy"):
        module.interpolate(V.tolist(), one, other[0])


def test_arguments_that_are_not_arrays_are_named(module, strict):
    for first in (W, strict.asarray(W)):
        with pytest.raises(TypeError, match="v_dot must be an array of NumPy, JAX, PyTorch or the like, got dict"):
            module.twist(first, {})
    with pytest.raises(TypeError, match="v must be an array of NumPy, JAX, PyTorch or the like, got list"):
        module.twist(V.tolist(), W.tolist())
    with pytest.raises(ValueError, match=r"v must have shape \(\.\.\., 6\), got \(5,\)"):
        module.twist(V.tolist()[:5], W)


# --- traced arrays: none may be converted to a NumPy array -------------------------------------------------------


@pytest.mark.parametrize("name", ["twist", "compose"])
def test_a_constant_first_argument_in_traced_functions(module, jax, name):
    function, batch = getattr(module, name), np.stack([W, 2 * W])
    assert_nearly_equal(traced.run(lambda w: function(V, w), W), function(V, W), eps=40)
    assert_nearly_equal(traced.run(jax.vmap(lambda w: function(V, w)), batch), function(V, batch), eps=40)


def test_gradients_by_the_second_argument(module, jax):
    """Compare gradients of summed results with column sums of the tangent operator and of the composition Jacobian."""
    kernel = load(3)

    def slope(function):
        return traced.run(jax.grad(lambda w: function(V, w).sum()), W)

    np.testing.assert_allclose(slope(module.twist), kernel.twist(V, np.eye(6)).sum(axis=-1), rtol=1e-12)
    np.testing.assert_allclose(slope(module.compose), kernel.compose_jacobians(V, W)[1].sum(axis=0), rtol=1e-12)


def test_a_traced_parameter_between_constant_poses(module, jax):
    found = traced.run(lambda t: module.interpolate(V, W, t), np.array(0.25))
    assert_nearly_equal(found, module.interpolate(V, W, 0.25), eps=40)
