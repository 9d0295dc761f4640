"""Tests of every target: printed text agrees with the formulas."""

from __future__ import annotations

import importlib

import numpy as np
import pytest

from derive.codegen.build import print_package
from derive.codegen.signatures import PUBLIC
from derive.codegen.targets import TARGETS
from derive.maps import Cayley
from derive.output import files

# tests/derive/codegen/test_c_text.py interprets the C headers, also used by the native target
NAMES = [name for name in TARGETS if name not in ("c", "native", "numpy")]


@pytest.mark.smoke
def test_a_module_for_numpy_is_made_and_validated(tmp_path):
    require_validated("numpy", tmp_path)


@pytest.mark.parametrize("name", NAMES)
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
def test_principal_refuses_complex_vectors_of_one_branch_charts(package, target):
    module = importlib.import_module(f"{package(target)}.cayley1")
    assert not module.CHART.returns
    with pytest.raises(TypeError, match="v must be real"):
        module.principal(np.full(6, 0.1 + 0j))


def test_compiled_functions_that_share_a_kernel_have_their_own_constants(package):
    shared = importlib.import_module(f"{package('numba')}._inside").SHARED
    assert shared == {name: (row.kernel, row.constants) for name, row in PUBLIC.items() if row.constants}
