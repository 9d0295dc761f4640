"""Derivatives of kernels by JAX and PyTorch, in all modes: they equal differences of the oracle at every regime."""

from __future__ import annotations

import importlib
import itertools
from functools import partial

import numpy as np
import pytest

from derive.about import FAMILIES, ORDERS
from derive.codegen.signatures import POSES
from tests.support import packages, sampling, traced
from tests.support.derivatives import GATE, OF_AXIS, Case, above_gate, by_jax, by_torch, by_traces, tries
from tests.support.kernels import load
from tests.support.libraries import LIBRARIES, QUICKLY, jax

pytestmark = pytest.mark.filterwarnings("ignore:.torch.jit:DeprecationWarning")  # PyTorch's own, in forward mode
SEED, BY_TORCH, BY_JAX = 3, 16, 1
"""Seed and numbers of functions that are tried; ``python -m tests.support.derivatives`` tries more."""

FIRST = ("to_exponential", "from_exponential", "principal", "to_screw", "from_pose")
"""Functions that PyTorch tries first: each has a root, an angle or a choice."""


def titled(one):
    chart, name, table, dtype = one
    return f"{chart}-{name}-{table.name or 'pose'}-{dtype.__name__}"


@pytest.fixture(scope="module")
def every(shared):
    """Provide the name of a package of all charts."""
    folder = shared("derivatives", lambda place: packages.write(ORDERS, "array-api", place, FAMILIES))
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(folder.parent))
        yield folder.name


@pytest.fixture
def package(package):
    return package("array-api")


AT_REST = ("cayley3", "exponential", "sine3")
"""Charts in which functions are tried at rest, in turn."""


@pytest.mark.parametrize("every", [5, pytest.param(1, marks=pytest.mark.thorough)])
def test_derivatives_of_every_function_at_rest(package, every):
    """Leave out functions of an axis, which have none there."""
    LIBRARIES["jax"]()
    tried = [name for name in POSES.public if name not in OF_AXIS][::every]
    cases = [(chart, Case(chart, name)) for chart, name in zip(itertools.cycle(AT_REST), tried)]
    modules = {chart: importlib.import_module(f"{package}.{chart}") for chart in AT_REST}
    found = {f"{chart}.{case.row.name}": case.error_at_rest(modules[chart]) for chart, case in cases}
    assert {name: error for name, error in found.items() if not error <= GATE} == {}


NEAR_REST = (0.0, 1e-300, 1e-20, 1e-16, 1e-12, 1e-8, 1e-4, 0.1)


@pytest.mark.parametrize("chart", ["exponential", "sine3"])
def test_maps_there_and_back_are_the_identity(package, chart):
    """Allow 2000 eps of the identity; derivatives of quotients that cancel lose all digits at short vectors."""
    LIBRARIES["jax"]()
    module = importlib.import_module(f"{package}.{chart}")
    jacobian = jax.jacfwd(lambda v: module.from_pose(module.pose(v)))
    for size in NEAR_REST:
        found = traced.run(jacobian, np.array([size, size / 2, 0, 1, 2, 3]))
        np.testing.assert_allclose(found, np.eye(6), rtol=0, atol=2000 * 2.0**-52)


def test_derivatives_of_a_map(package):
    assert not above_gate(package, ("cayley2", "quaternion", POSES, np.float64), by_traces, share=5)


@pytest.mark.thorough
@pytest.mark.parametrize("one", tries(SEED)[:BY_JAX], ids=titled)
def test_derivatives_by_jax(every, one):
    assert not above_gate(every, one, by_jax)


@pytest.mark.torch
@pytest.mark.thorough
@pytest.mark.parametrize("one", sorted(tries(SEED), key=lambda one: one[1] not in FIRST)[:BY_TORCH], ids=titled)
def test_derivatives_by_torch(every, one):
    assert not above_gate(every, one, by_torch)


# --- beyond the regimes: functions of a batch, arguments off the group, motions beyond half a turn ------------------


@pytest.mark.thorough
def test_hessian_of_a_batch_with_every_regime(package):
    """Expect the unit matrix from half the square of a round trip; one bad row would spoil the whole batch."""
    LIBRARIES["jax"]()
    import jax

    module = importlib.import_module(f"{package}.exponential")
    rows = np.array([[0, 0, 0, 0, 0, 0.0], [0, 0, 0, 1, 2, 3], [1e-300, 0, 0, 1, 2, 3], [0.3, -0.2, 0.5, 1, 2, 3]])

    def loss(given):
        return (module.from_quaternion(module.quaternion(given)) ** 2).sum() / 2

    found = np.asarray(jax.jit(jax.hessian(loss), compiler_options=QUICKLY)(rows)).reshape(24, 24)
    np.testing.assert_allclose(found, np.eye(24), rtol=0, atol=1e-13)


def jacobian_by_jax(function, v):
    LIBRARIES["jax"]()
    import jax

    return np.asarray(jax.jit(jax.jacrev(function), compiler_options=QUICKLY)(v))


def jacobian_by_torch(function, v):
    import torch

    return torch.autograd.functional.jacobian(function, torch.asarray(v)).numpy()


BOTH = pytest.mark.parametrize("jacobian", [jacobian_by_jax, pytest.param(jacobian_by_torch, marks=pytest.mark.torch)])


@BOTH
@pytest.mark.thorough
@pytest.mark.parametrize("road", ["quaternion", "tensor", "pose"])
def test_inverse_maps_have_finite_derivatives_in_every_entry(package, road, jacobian):
    module = importlib.import_module(f"{package}.cayley3")
    for regime in ("uniform", "pure translation", "identity"):
        given = getattr(load(3), road)(sampling.poses(3, regime)[0])
        assert np.isfinite(jacobian(getattr(module, f"from_{road}"), given)).all()


@BOTH
@pytest.mark.thorough
@pytest.mark.parametrize("angle", [np.pi, 5.0])
def test_steps_of_half_a_turn_and_more(package, angle, jacobian):
    """Compare derivatives by δ with emitted Jacobians; tan(|δ|/2) is huge at half a turn."""
    module, v = importlib.import_module(f"{package}.cayley3"), sampling.poses(3, "uniform")[0]
    delta = np.array([angle / 3, -2 * angle / 3, 2 * angle / 3, 1, 2, 3])
    expected = load(3).retract_jacobians(v, delta)[1]
    found = jacobian(partial(module.retract, v), delta)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 * abs(expected).max())
