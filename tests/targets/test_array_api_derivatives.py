"""Derivatives of kernels by JAX and PyTorch, in all modes: they equal differences of the oracle at every regime."""

from __future__ import annotations

import importlib

import numpy as np
import pytest

from derive.codegen.signatures import PUBLIC
from tests.support import packages
from tests.support.derivatives import GATE, ROUND, Case, by_jax, by_torch, errors, points
from tests.support.libraries import LIBRARIES, QUICKLY

pytestmark = pytest.mark.filterwarnings("ignore:.torch.jit:DeprecationWarning")  # PyTorch's own, in forward mode
CHARTS = ("exponential", "cayley1", "cayley2", "cayley3", "sine3", "breusing", "scaled2")
UNDEFINED = ("angle", "to_screw", "shadow", "shadow_jacobian", "from_screw", "interpolate")
"""Functions of an axis, which have no derivative at the identity or at translations, and grow without bound beside."""

SMOOTH = [name for name in PUBLIC if name not in UNDEFINED and not name.endswith("_jacobians")]
SIDES = ("principal", "compose", "between", "local", "body_local", "from_quaternion", "from_tensor", "from_pose")
"""Functions that choose a side, so that they jump at half a turn."""


@pytest.fixture(scope="module")
def charts(shared):
    """Provide a function that returns the array-api module of a chart."""
    LIBRARIES["jax"]()
    families = [name for name in CHARTS if not name.startswith("cayley")]
    folder = shared("derivatives", lambda place: packages.write((1, 2, 3), "array-api", place, families))
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(folder.parent))
        yield lambda name: importlib.import_module(f"{folder.name}.{name}")


def worst(module, chart, name, library, dtype=np.float64, regimes=()):
    """Return errors above the gate by regime."""
    kernel, found = importlib.import_module(f"dualcay.{chart}"), {}
    for regime, v in points(kernel):
        skipped = (regime == "half turn" and name in SIDES) or not np.isfinite(kernel.pose(v)).all()
        if not skipped and (not regimes or regime in regimes):
            for mode, error in errors(Case(chart, name, v), module, library, dtype).items():
                if not error <= GATE * (1 + (name in ROUND)):  # a round trip has the errors of two kernels
                    found[regime, mode] = error
    return found


def hessian(module, w):
    """Return the derivatives of half the square of a round trip, which is half the square of w, to second order."""
    import jax

    def square(v):
        return (module.from_quaternion(module.quaternion(v)) ** 2).sum() / 2

    return np.asarray(jax.jit(jax.hessian(square), compiler_options=QUICKLY)(w))


@pytest.mark.parametrize("ruled", [True, pytest.param(False, marks=pytest.mark.thorough)])
def test_a_round_trip_is_the_identity_to_second_order(charts, ruled, monkeypatch):
    """Expect the unit matrix at a translation; without slopes of scalar programs the text gives another one."""
    if not ruled:
        monkeypatch.setattr(charts("_slopes"), "SLOPES", {})
    found = hessian(charts("exponential"), np.array([0, 0, 0, 1.0, 2, 3]))
    assert (abs(found - np.eye(6)).max() < 1e-13) == ruled  # NaN is false


@pytest.mark.thorough
def test_steps_have_second_derivatives(charts):
    """Compare with differences of the oracle, at half a turn, where the text of tangents cancels."""
    assert not worst(charts("exponential"), "exponential", "retract", by_jax, regimes=("π -1e-09",))


@pytest.mark.torch
@pytest.mark.thorough
@pytest.mark.parametrize("name", SMOOTH)
@pytest.mark.parametrize("chart", CHARTS)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_derivatives_by_torch(charts, chart, name, dtype):
    assert not worst(charts(chart), chart, name, by_torch, dtype)


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["pose", "from_pose", "compose", "retract", "local", "to_exponential", "tangent"])
@pytest.mark.parametrize("chart", ["exponential", "cayley2"])
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_derivatives_by_jax(charts, chart, name, dtype):
    regimes = ("translation", "angle 1e-16, translation 1e+06", "π -1e-09")
    assert not worst(charts(chart), chart, name, by_jax, dtype, regimes)
