"""Comparison of every kernel function with the 50-digit oracle, by order, regime and float type."""

from __future__ import annotations

import numpy as np
import pytest

from tests.support import errors, sampling
from tests.support.accuracy import FUNCTIONS, Trial
from tests.support.kernels import ORDERS, load
from tests.support.nilpotent import Nil
from tests.support.oracle import oracle_of

CASES = [(n, regime) for n in ORDERS for regime in sampling.REGIMES if sampling.has_regime(n, regime)]
BETWEEN = (4, 5)
"""Orders between a low one and a high one, whose programs are alike; they are tested among the thorough ones."""
CASE = pytest.mark.parametrize(
    ("order", "regime"),
    [
        pytest.param(n, r, id=f"n={n}, {r}", marks=[pytest.mark.thorough] if n in BETWEEN else []) for n, r in CASES
    ],
)


@CASE
def test_double_precision(order: int, regime: str) -> None:
    for name in FUNCTIONS:
        Trial(load(order), order, regime).check(name)


# All types run the same programs, so few cases suffice: orders and regimes in which types once differed.
OTHER = [(n, r) for n, r in CASES if n in (2, 3) and r in ("uniform", "middle band", "below pi", "shadow")]
OTHER_CASE = pytest.mark.parametrize(("order", "regime"), OTHER, ids=[f"n={n}, {regime}" for n, regime in OTHER])


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
