"""Kernels of orders that are not committed: written to a temporary folder, tested with the same oracle and gates."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from dualcay import _runtime
from tests.support import packages, rotations, sampling
from tests.support.accuracy import FUNCTIONS, Trial
from tests.support.calculus import CALCULUS, CalculusTrial
from tests.support.rotations import RotationTrial

PACKAGE = "kernels_of_other_orders"


@pytest.fixture(scope="module")
def folder(shared) -> Iterator[Path]:
    parent = shared(PACKAGE, lambda place: packages.write([7, 11, 12], "numpy", place)).parent
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(parent))
        yield parent


@pytest.mark.parametrize(("order", "regime"), [*zip((7, 11) * 7, sampling.REGIMES, strict=True)])
def test_orders_seven_and_eleven(folder: Path, order: int, regime: str) -> None:
    other = importlib.import_module(f"{PACKAGE}.cayley{order}")
    assert Path(other.__file__ or "").parent.name == PACKAGE
    trial = Trial(other, order, regime, count=2)
    for name in FUNCTIONS:
        trial.check(name)


@pytest.mark.parametrize("regime", ["below pi", "pure translation", "near 2 pi", "shadow"])
def test_derivatives_group_operations_and_steps_of_order_seven(folder: Path, regime: str) -> None:
    trial = CalculusTrial(importlib.import_module(f"{PACKAGE}.cayley7"), 7, regime, count=1)
    for name in CALCULUS:
        trial.check(name)


def test_rotations_alone_of_order_seven(folder: Path) -> None:
    trial = RotationTrial(importlib.import_module(f"{PACKAGE}.rotation.cayley7"), 7, "shadow", count=1)
    for name in rotations.FUNCTIONS:
        trial.check(name)


@pytest.mark.parametrize(("dtype", "size"), [(np.float32, 1e4), (np.float64, 5e37)])
@pytest.mark.parametrize("order", [11, 12])
def test_orders_above_eight_overflow_beyond_the_fourth_power_of_one_plus_x(
    folder: Path, order: int, dtype: type, size: float
) -> None:
    """Expect accurate results where the eleventh power overflows (|v| > 57 or 1e14), and NaN where the fourth does.

    Allow the gate of shadows, 10 n eps, times 2n for one more derivative of powers of this degree.
    """
    module = importlib.import_module(f"{PACKAGE}.cayley{order}")
    count = _runtime.POINTWISE_MAX + 1  # fewer poses of float32 have the range of Python floats
    v = (size * sampling.dual_vectors("far", np.float64, count)).astype(dtype)
    w = sampling.dual_vectors("far too", np.float64, count).astype(dtype)
    forward = dict.fromkeys(("quaternion", "pose", "tensor", "tangent", "tangent_inv"), ())
    for name, given in {**forward, "tangent_dot": (w,), "twist_jacobian": (w,)}.items():
        function, eps = getattr(module, name), 10 * order * (2 * order if given else 1) * np.finfo(dtype).eps
        exact = function(v.astype(np.longdouble), *given)
        assert np.abs(function(v, *given) - exact).max() <= eps * np.abs(exact).max()
        assert np.isnan(function(100 * v, *given)).any(axis=tuple(range(1, exact.ndim))).all()
