"""Interface of kernel modules: import, documentation, lists of names, pickling."""

from __future__ import annotations

import inspect
import pickle
import pydoc

import numpy as np
import pytest

import dualcay
from derive.codegen.signatures import PUBLIC
from tests.support import sampling
from tests.support.kernels import ORDERS, load

PLAIN = {"singular_angles", "switch", "identity", "random"}
NAMES = sorted({*(alias for row in PUBLIC.values() for alias in (row.name, *row.aliases)), *PLAIN})


@pytest.mark.parametrize("order", ORDERS)
def test_a_module_exports_what_the_table_says(order: int) -> None:
    kernel = load(order)
    assert list(kernel.__all__) == dir(kernel) == NAMES
    assert {name for name in NAMES if callable(getattr(kernel, name))} == set(NAMES)


def test_dexp_is_the_tangent_operator_of_the_exponential() -> None:
    for module in (dualcay.exponential, dualcay.rotation.exponential):
        assert (module.dexp, module.dexp_inv) == (module.tangent, module.tangent_inv)
        assert {"dexp", "dexp_inv"} <= set(module.__all__)


@pytest.mark.parametrize("name", NAMES)
def test_every_function_has_its_documentation_and_signature(name: str) -> None:
    function = getattr(load(3), name)
    parameters = inspect.signature(function).parameters
    assert "self" not in parameters
    text = inspect.getdoc(function) or ""
    assert "Returns\n-------" in text
    for parameter in parameters:
        assert parameter in text, f"{name} does not say what {parameter} is"
    listed = text.partition("Parameters\n----------\n")[2].partition("\n\n")[0].splitlines()
    described = [part for line in listed if line[:1] not in ("", " ") for part in line.partition(" : ")[0].split(", ")]
    given = [part for part in described if part in parameters]
    assert given == [part for part in parameters if part in given], f"{name} lists {described}"


def test_help_tells_of_the_module_and_of_each_function() -> None:
    page = pydoc.render_doc(load(3), renderer=pydoc.plaintext)
    assert "Cayley map of order 3" in page
    assert all(f"{name} = " in page or f"{name}(" in page for name in NAMES)
    assert "loses rank" in pydoc.render_doc(load(3).tangent, renderer=pydoc.plaintext)


@pytest.mark.parametrize("order", ORDERS)
def test_functions_are_pickled_by_their_module(order: int) -> None:
    kernel = load(order)
    v = sampling.poses(order, "uniform", count=3)
    function = pickle.loads(pickle.dumps(kernel.pose))
    assert function == kernel.pose
    np.testing.assert_array_equal(function(v), kernel.pose(v))


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.longdouble])
def test_a_plain_number_takes_the_type_of_the_arrays(dtype: type) -> None:
    v = np.arange(6, dtype=dtype) / 8
    for t in (1, 0.5):
        assert dualcay.cayley3.interpolate(0 * v, v, t).dtype == dtype
    assert dualcay.cayley3.interpolate(0 * v, v, np.array(0.5)).dtype == np.result_type(dtype, np.float64)
