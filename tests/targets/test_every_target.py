"""Tests of every target: printed text agrees with the formulas, and rotations alone with the NumPy kernels."""

from __future__ import annotations

import importlib
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from derive.codegen.build import print_package
from derive.codegen.signatures import PUBLIC, ROTATIONS
from derive.codegen.targets import TARGETS
from derive.maps import Cayley
from derive.output import files
from tests.support import thorough
from tests.support.libraries import Through
from tests.support.rotation_arguments import ROUNDINGS, arguments

# tests/derive/codegen/test_c_text.py interprets the C headers, also used by the native target
NAMES = [name for name in TARGETS if name not in ("c", "native", "numpy")]


@pytest.mark.smoke
def test_a_module_for_numpy_is_made_and_validated(tmp_path):
    require_validated("numpy", tmp_path)


@pytest.mark.parametrize("name", thorough.sampled(NAMES, {*NAMES} - {"matlab"}))
def test_a_module_is_made_and_validated(name, tmp_path):
    require_validated(name, tmp_path)


def require_validated(name, folder):
    target, chart = TARGETS[name], Cayley(3)
    files.write(folder, print_package([chart], target).texts)
    assert target.validate(folder, chart, geometry=True) > 100


@pytest.mark.parametrize(("target", "out"), [("numba", (None,)), ("array-api", ())])
def test_scalar_last_reorders_each_half_of_a_quaternion(package, target, out):
    runtime = importlib.import_module(f"{package(target)}._runtime")
    for last, first in (([1, 2, 3, 0], [0, 1, 2, 3]), ([1, 2, 3, 0, 5, 6, 7, 4], [0, 1, 2, 3, 4, 5, 6, 7])):
        size = len(last)
        found = runtime.from_scalar_last(np.array(last, float), -1, size)
        assert np.asarray(found).tolist() == first
        assert np.asarray(runtime.to_scalar_last(found, size, -1, *out)).tolist() == last


@pytest.mark.parametrize("target", ["numba", "array-api"])
def test_dir_of_a_module_lists_its_public_names(package, target):
    for table in ("", ".rotation"):
        module = importlib.import_module(f"{package(target)}{table}.cayley3")
        assert sorted(dir(module)) == sorted(module.__all__)


@pytest.mark.parametrize("target", ["numba", "array-api"])
def test_a_chart_that_is_not_there_is_no_attribute_and_its_command_is_named(package, target):
    for place in (package(target), f"{package(target)}.rotation"):
        home = importlib.import_module(place)
        for name, option in (("cayley9", "-n 9"), ("sine8", "--family sine8")):
            assert not hasattr(home, name)
            command = rf"dualcay generate {option} --target {target} -o FOLDER$"
            with pytest.raises(AttributeError, match=command):
                getattr(home, name)
            with pytest.raises(ImportError, match=command):
                exec(f"from {place} import {name}")


@pytest.mark.parametrize("target", ["numba", "array-api"])
def test_principal_refuses_complex_vectors_of_one_branch_charts(package, target):
    module = importlib.import_module(f"{package(target)}.cayley1")
    assert not module.CHART.returns
    with pytest.raises(TypeError, match="v must be real"):
        module.principal(np.full(6, 0.1 + 0j))


def test_compiled_functions_that_share_a_kernel_have_their_own_constants(package):
    shared = importlib.import_module(f"{package('numba')}._inside").SHARED
    assert shared == {name: (row.kernel, row.constants) for name, row in PUBLIC.items() if row.constants}


EPS = np.finfo(float).eps


def require_equal(module: Any, kernels: ModuleType, name: str) -> None:
    row = ROTATIONS.public[name]
    given, branch = arguments(row, kernels), (1,) if row.branch else ()
    expected, found = (getattr(one, name)(*given, *branch) for one in (kernels, module))
    for one, other in zip(*(r if isinstance(r, tuple) else (r,) for r in (found, expected)), strict=True):
        assert one.shape == other.shape, name
        assert np.all(abs(one - other) <= ROUNDINGS * EPS * abs(other).max(initial=1)), name


@pytest.mark.parametrize(
    ("order", "library"),
    [(1, "numpy"), (3, "numpy"), (1, "jax traced"), pytest.param(3, "jax", marks=pytest.mark.thorough)],
)
def test_functions_in_every_library(package, order, library):
    name = f"rotation.cayley{order}"
    module, kernels = (importlib.import_module(f"{place}.{name}") for place in (package("array-api"), "dualcay"))
    for function in list(ROTATIONS.public)[:: 3 if library == "jax traced" else 1]:
        require_equal(Through(module, library), kernels, function)


def test_compiled_functions(package):
    """Compile a sample of functions: one with a table, one with a branch, and one of two results."""
    module, kernels = (importlib.import_module(f"{place}.rotation.cayley3") for place in (package("numba"), "dualcay"))
    for function in ("twist", "shadow", "to_angle_axis"):
        require_equal(module, kernels, function)
    assert module.identity().tolist() == [0, 0, 0]
    assert module.random((2,), rng=0).shape == (2, 3)


def test_single_angle_may_be_a_python_number(package):
    module = importlib.import_module(f"{package('array-api')}.rotation.cayley2")
    v = module.from_angle_axis(np.pi / 2, np.array([0, 0, 1.0]))
    np.testing.assert_allclose(v, [0, 0, np.tan(np.pi / 8)], rtol=2 * EPS)  # errors of a tangent and a product
