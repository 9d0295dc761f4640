"""Comparison of every kernel function with the 50-digit oracle, by order, regime and float type, also rotations."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from derive.codegen.signatures import ROTATIONS
from dualcay import _runtime
from tests.support import cases, errors, kernels, rotations, sampling
from tests.support.accuracy import FUNCTIONS, Trial
from tests.support.calculus import CALCULUS, EVERY, CalculusTrial
from tests.support.kernels import ORDERS, load
from tests.support.nilpotent import Nil
from tests.support.oracle import oracle_of
from tests.support.rotations import RotationTrial

CASES = [(n, regime) for n in ORDERS for regime in sampling.REGIMES if sampling.has_regime(n, regime)]
BETWEEN = (4, 5)
"""Orders between a low one and a high one, whose programs are alike; they are tested among the thorough ones."""
CASE = pytest.mark.parametrize(
    ("order", "regime"),
    [pytest.param(n, r, id=f"n={n}, {r}", marks=[pytest.mark.thorough] if n in BETWEEN else []) for n, r in CASES],
)


@CASE
def test_double_precision(order: int, regime: str) -> None:
    for name in FUNCTIONS:
        Trial(load(order), order, regime).check(name)


# All types run the same programs, so few cases suffice: orders and regimes in which types once differed.
OTHER = [(n, r) for n, r in CASES if n in (2, 3) and r in ("uniform", "middle band", "below pi", "shadow")]
OTHER_CASE = pytest.mark.parametrize(("order", "regime"), OTHER, ids=[f"n={n}, {regime}" for n, regime in OTHER])


def test_batches_of_trials_run_recorded_programs() -> None:
    """Expect more poses than run one by one, since float32 runs in double precision there."""
    given: list[np.ndarray] = []
    trial = Trial(SimpleNamespace(pose=lambda v: given.append(v) or v), 3, "uniform", np.float32)
    assert trial.module.pose(trial.v).tolist() == trial.v.tolist()
    assert len(given[0]) > _runtime.POINTWISE_MAX


@OTHER_CASE
@pytest.mark.parametrize("dtype", [np.float32, np.longdouble])
def test_other_float_types(order: int, regime: str, dtype: type) -> None:
    for name in FUNCTIONS:
        Trial(load(order), order, regime, dtype).check(name)


COMPLEX_MAPS = ("quaternion", "tensor", "tangent", "tangent_inv", "twist", "rate", "body_twist", "body_rate")
# The error of a complex product is at most √5 u; the error of a real product is at most u.
COMPLEX = errors.GENERAL * np.sqrt(5)


@pytest.mark.parametrize("dtype", [np.complex64, np.complex128])
@pytest.mark.parametrize("name", [*COMPLEX_MAPS, "pose", "transform_line"])
def test_complex_vectors_are_the_analytic_continuation(name: str, dtype: type, order: int) -> None:
    oracle = oracle_of(order)
    rng = sampling.generator("complex", name, order)
    # |v| is a few tenths over n, because maps grow like (1 + |v|)^n along imaginary v.
    v, w = (0.2 / order * (rng.normal(size=(2, 6)) + 1j * rng.normal(size=(2, 6)))).astype(dtype), None
    if name in ("twist", "rate", "body_twist", "body_rate", "transform_line"):
        w = (rng.normal(size=(2, 6)) + 1j * rng.normal(size=(2, 6))).astype(dtype)
    arguments = [(a,) for a in v] if w is None else list(zip(v, w, strict=True))
    results = getattr(load(order), name)(*(np.stack(column) for column in zip(*arguments, strict=True)))
    assert results.dtype == dtype
    for argument, got in zip(arguments, results, strict=True):
        exact = getattr(oracle, name)(*argument)
        re, du = errors.parts(exact)
        # Terms of the dual part hardly cancel, so both norms bound them.
        scale = Nil(errors.norm(re), errors.norm(du) + errors.norm(re))
        assert max(errors.errors(got, exact, scale, oracle)) <= COMPLEX


# --- derivatives, group operations, steps, and rotations alone --------------------------------------------------------

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
    assert all(hasattr(CalculusTrial, name) for name in EVERY)
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


KEPT, _ = cases.read()


@pytest.mark.thorough
@pytest.mark.parametrize("order", sorted({case.order for case in KEPT}), ids=lambda n: f"n={n}")
def test_worst_cases_stay_within_their_gates(order: int, tmp_path: Path) -> None:
    kernels.write([order], tmp_path)
    for case in KEPT:
        if case.order == order:
            case.trial(load(order, tmp_path, case.table)).check(case.function)
