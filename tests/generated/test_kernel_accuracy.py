"""Every kernel function against the 50-digit oracle: orders x regimes x float types."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from derive.codegen.signatures import PUBLIC, ROTATIONS
from tests.support import errors, rotations, sampling
from tests.support.accuracy import FUNCTIONS, Trial
from tests.support.calculus import CALCULUS, EVERY, CalculusTrial
from tests.support.kernels import ORDERS, load
from tests.support.nilpotent import Nil
from tests.support.oracle import oracle_of
from tests.support.rotations import RotationTrial

CASES = [(n, regime) for n in ORDERS for regime in sampling.REGIMES if sampling.has_regime(n, regime)]
CASE = pytest.mark.parametrize(("order", "regime"), CASES, ids=[f"n={n}, {regime}" for n, regime in CASES])
FUNCTION = pytest.mark.parametrize("name", FUNCTIONS)


@CASE
@FUNCTION
def test_double_precision(name: str, order: int, regime: str) -> None:
    Trial(load(order), order, regime).check(name)


# The other types run the same programs: the orders and regimes in which they have once been different elsewhere.
OTHER = [(n, r) for n, r in CASES if n in (2, 3) and r in ("uniform", "middle band", "below pi", "shadow")]
OTHER_CASE = pytest.mark.parametrize(("order", "regime"), OTHER, ids=[f"n={n}, {regime}" for n, regime in OTHER])


@OTHER_CASE
@FUNCTION
@pytest.mark.parametrize("dtype", [np.float32, np.longdouble])
def test_other_float_types(name: str, order: int, regime: str, dtype: type) -> None:
    Trial(load(order), order, regime, dtype).check(name)


# Products of several operators: all functions, but not in all orders and regimes, for exact values take long.
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


def test_every_function_of_users_is_tried() -> None:
    assert set(EVERY) - {"round_trip"} == set(PUBLIC)
    assert {ROTATIONS.sources[name].name for name in rotations.FUNCTIONS} == set(ROTATIONS.public)


@pytest.mark.parametrize("kind", [CalculusTrial, RotationTrial])
def test_results_that_are_off_by_little_are_noticed(kind: type[Trial]) -> None:
    module = load(3, table=ROTATIONS.name if kind is RotationTrial else "")
    off = SimpleNamespace(**{name: slightly_off(getattr(module, name)) for name in module.__all__ if name.islower()})
    trial = kind(off, 3, "uniform", count=2)  # of which no two are alike
    for name in rotations.FUNCTIONS if kind is RotationTrial else EVERY:
        assert trial.worst(name) > 1, name


def slightly_off(function: Callable[..., Any]) -> Callable[..., Any]:
    """Its results, a part in 1e12 too large, but for what is exactly 0 or 1."""

    def off(array: np.ndarray) -> np.ndarray:
        return np.where(array % 1 == 0, array, array * (1 + 1e-12))

    def call(*arguments: Any) -> Any:
        found = function(*arguments)
        return tuple(map(off, found)) if isinstance(found, tuple) else off(found)

    return call


COMPLEX_MAPS = ("quaternion", "tensor", "tangent", "tangent_inv", "twist", "rate", "body_twist", "body_rate")
# A complex product has an error of at most √5 u where a real one has u.
COMPLEX = errors.GENERAL * np.sqrt(5)


@pytest.mark.parametrize("dtype", [np.complex64, np.complex128])
@pytest.mark.parametrize("name", [*COMPLEX_MAPS, "pose", "transform_line"])
def test_complex_vectors_are_the_analytic_continuation(name: str, dtype: type, order: int) -> None:
    oracle = oracle_of(order)
    rng = sampling.generator("complex", name, order)
    # |v| of a few tenths over n: along imaginary v the maps grow like (1 + |v|)^n.
    v, w = (0.2 / order * (rng.normal(size=(2, 6)) + 1j * rng.normal(size=(2, 6)))).astype(dtype), None
    if name in ("twist", "rate", "body_twist", "body_rate", "transform_line"):
        w = (rng.normal(size=(2, 6)) + 1j * rng.normal(size=(2, 6))).astype(dtype)
    arguments = [(a,) for a in v] if w is None else list(zip(v, w, strict=True))
    results = getattr(load(order), name)(*(np.stack(column) for column in zip(*arguments, strict=True)))
    assert results.dtype == dtype
    for argument, got in zip(arguments, results, strict=True):
        exact = getattr(oracle, name)(*argument)
        re, du = errors.parts(exact)
        # No cancellation to speak of: the dual part's terms are bounded by both norms.
        scale = Nil(errors.norm(re), errors.norm(du) + errors.norm(re))
        assert max(errors.errors(got, exact, scale, oracle)) <= COMPLEX
