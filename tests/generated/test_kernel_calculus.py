"""Comparison of derivatives, group operations, steps, motions, and rotations alone with the 50-digit oracle."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from derive.codegen.signatures import PUBLIC, ROTATIONS
from tests.support import rotations
from tests.support.accuracy import Trial
from tests.support.calculus import CALCULUS, EVERY, CalculusTrial
from tests.support.kernels import load
from tests.support.rotations import RotationTrial

# Functions that multiply several operators run in few orders and regimes, because exact values are slow.
SEVERAL = [(1, "uniform"), (2, "shadow"), (3, "angle 1e-12"), (3, "at pi"), (8, "pure translation"), (8, "below pi")]
ALONE = [(1, "below pi"), (2, "above pi"), (3, "shadow"), (8, "identity")]


@pytest.mark.parametrize(("order", "regime"), SEVERAL)
def test_derivatives_group_operations_and_steps(order: int, regime: str) -> None:
    trial = CalculusTrial(load(order), order, regime, count=2)
    for name in CALCULUS:
        trial.check(name)


@pytest.mark.parametrize(("order", "regime"), ALONE)
def test_rotations_alone(order: int, regime: str) -> None:
    trial = RotationTrial(load(order, table=ROTATIONS.name), order, regime, count=2)
    for name in rotations.FUNCTIONS:
        trial.check(name)


def test_trials_cover_every_public_function() -> None:
    assert set(EVERY) - {"round_trip"} == set(PUBLIC)
    assert {ROTATIONS.sources[name].name for name in rotations.FUNCTIONS} == set(ROTATIONS.public)


@pytest.mark.parametrize("kind", [CalculusTrial, RotationTrial])
def test_relative_error_of_1e_12_fails_the_trial(kind: type[Trial]) -> None:
    module = load(3, table=ROTATIONS.name if kind is RotationTrial else "")
    off = SimpleNamespace(**{name: slightly_off(getattr(module, name)) for name in module.__all__ if name.islower()})
    trial = kind(off, 3, "uniform", count=2)  # regime with different results in every row
    for name in rotations.FUNCTIONS if kind is RotationTrial else EVERY:
        assert trial.worst(name) > 1, name


def slightly_off(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function with results too large by a factor 1 + 1e-12; whole numbers stay unchanged."""

    def off(array: np.ndarray) -> np.ndarray:
        return np.where(array % 1 == 0, array, array * (1 + 1e-12))

    def call(*arguments: Any) -> Any:
        found = function(*arguments)
        return tuple(map(off, found)) if isinstance(found, tuple) else off(found)

    return call
