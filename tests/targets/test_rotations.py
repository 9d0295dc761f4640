"""Rotations alone in other targets: agreement with the NumPy kernels."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from types import ModuleType
from typing import Any

import jax
import numpy as np
import pytest

from derive.codegen.signatures import ROTATIONS
from tests.support.rotation_arguments import ROUNDINGS, arguments

EPS = np.finfo(float).eps
COMPILED = ("tensor", "twist", "compose", "shadow", "from_angle_axis", "to_angle_axis", "rate_jacobian")
"""Sample of functions, one of each kind: a function takes a second to compile."""


def require_equal(module: ModuleType, kernels: ModuleType, name: str, make: Callable[[np.ndarray], Any]) -> None:
    row = ROTATIONS.public[name]
    given, branch = arguments(row, kernels), (1,) if row.branch else ()
    expected, found = getattr(kernels, name)(*given, *branch), getattr(module, name)(*map(make, given), *branch)
    for one, other in zip(*(r if isinstance(r, tuple) else (r,) for r in (found, expected)), strict=True):
        assert one.shape == other.shape, name
        assert np.all(abs(np.asarray(one) - other) <= ROUNDINGS * EPS * abs(other).max(initial=1)), name


@pytest.mark.parametrize("order", [1, 3])
@pytest.mark.parametrize("make", [np.asarray, jax.numpy.asarray], ids=["numpy", "jax"])
def test_every_function_in_every_library(package, order, make):
    jax.config.update("jax_enable_x64", True)
    name = f"rotation.cayley{order}"
    module, kernels = (importlib.import_module(f"{place}.{name}") for place in (package("array-api"), "dualcay"))
    for function in ROTATIONS.public if make is np.asarray or order == 3 else COMPILED:
        require_equal(module, kernels, function, make)


def test_compiled_functions(package):
    module, kernels = (importlib.import_module(f"{place}.rotation.cayley3") for place in (package("numba"), "dualcay"))
    for function in COMPILED:
        require_equal(module, kernels, function, np.asarray)
    assert module.identity().tolist() == [0, 0, 0]
    assert module.random((2,), rng=0).shape == (2, 3)


def test_single_angle_may_be_a_python_number(package):
    module = importlib.import_module(f"{package('array-api')}.rotation.cayley2")
    v = module.from_angle_axis(np.pi / 2, np.array([0, 0, 1.0]))
    np.testing.assert_allclose(v, [0, 0, np.tan(np.pi / 8)], rtol=2 * EPS)  # errors of a tangent and a product
