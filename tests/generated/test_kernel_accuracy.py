"""Comparison of every kernel function with the oracle, by order, regime and float type, also of rotations alone."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from derive.codegen.signatures import PUBLIC, ROTATIONS
from dualcay import _runtime
from tests.support import cases, errors, kernels, packages, sampling, thorough
from tests.support.kernels import load
from tests.support.nilpotent import Nil
from tests.support.oracle import oracle_of
from tests.support.trial import FUNCTIONS, Trial

OTHER_ORDERS = (11, 12) if "native" not in kernels.BACKENDS else ()
"""Orders that are not committed, and so have no compiled functions."""
WHOLE = 3
"""Order at which most functions are tried in a regime. Others take fewer in turn, since geometry is one text."""

REACHED = [(n, regime) for n in (1, 2, 3, 8) for regime in sampling.REGIMES if sampling.has_regime(n, regime)]
CASES = [(n, regime, table) for n, regime in REACHED for table in ("", ROTATIONS.name)]
CASES += [(n, regime, "") for n, regime in zip(OTHER_ORDERS * 7, sampling.REGIMES, strict=False)]


@pytest.fixture(scope="module")
def folder(shared: Callable[[str, Callable[[Path], object]], Path]) -> Path:
    return shared("kernels_of_other_orders", lambda place: packages.write(OTHER_ORDERS, "numpy", place))


QUICK = (2, WHOLE, *OTHER_ORDERS)
"""Orders of normal runs."""


@thorough.shares(6, 24)
@pytest.mark.parametrize(
    ("order", "regime", "table"),
    [pytest.param(*case, marks=() if case[0] in QUICK else pytest.mark.thorough) for case in CASES],
)
def test_every_function_agrees_with_the_oracle(folder: Path, order: int, regime: str, table: str, share: int) -> None:
    """Functions with slow exact values have one vector, others three, with another largest component each."""
    trials = [Trial(load(order, folder, table), order, regime, count=count) for count in (1, 3)]
    rows, every = list(trials[0].chart.table.public.values()), share // (1 + 2 * (order == WHOLE))
    for row in rows[(order + sampling.REGIMES.index(regime)) % every :: every]:
        trials[row.source in FUNCTIONS].check(row.name)


@pytest.mark.parametrize(("order", "dtype"), thorough.in_turn([2, 3], [np.longdouble, np.float32]))
def test_other_float_types(order: int, dtype: type) -> None:
    """Few cases suffice, since all types run the same programs."""
    for place, regime in enumerate(("uniform", "middle band", "below pi", "shadow")):
        tried = Trial(load(order), order, regime, dtype, count=1)
        for name in list(PUBLIC)[place::8]:
            tried.check(name)


COMPLEX_MAPS = ("quaternion", "tensor", "tangent", "tangent_inv", "twist", "rate", "body_twist", "body_rate")
# The error of a complex product is at most √5 u; the error of a real product is at most u.
COMPLEX = errors.GENERAL * np.sqrt(5)


@pytest.mark.parametrize(
    ("name", "dtype"), thorough.in_turn([*COMPLEX_MAPS, "pose", "transform_line"], [np.complex64, np.complex128])
)
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


@thorough.shares(1, 24)
@pytest.mark.parametrize("table", ["", ROTATIONS.name], ids=["poses", "rotations"])
def test_relative_error_of_1e_12_fails_the_trial(table: str, share: int) -> None:
    """Control: errors of functions are noticed."""
    module = load(3, table=table)
    known = {name: getattr(module, name) for name in ("CHART", "__name__", "identity", "singular_angles")}
    off = SimpleNamespace(**{name: slightly_off(getattr(module, name)) for name in module.__all__ if name.islower()})
    vars(off).update(known)
    tried = Trial(off, 3, "uniform", count=2)  # regime with different results in every row
    for name in list(tried.chart.table.public)[::share]:
        assert any(call.judged() for call in tried.calls(name)), name


def slightly_off(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function with results too large by a factor 1 + 1e-12; whole numbers stay unchanged."""

    def off(array: np.ndarray) -> np.ndarray:
        return np.where(array % 1 == 0, array, array * (1 + 1e-12))

    def call(*arguments: Any) -> Any:
        found = function(*arguments)
        return tuple(map(off, found)) if isinstance(found, tuple) else off(found)

    return call


@thorough.shares(1, 8)
def test_kept_cases_stay_within_their_gates(folder: Path, share: int) -> None:
    """The worst inputs found; those of high orders are tried where kernels are measured."""
    for case in cases.read()[0][::share]:
        if case.order in (*kernels.ORDERS, *OTHER_ORDERS):
            assert case.call(load(case.order, folder, case.table)).judged() == ""


@pytest.mark.parametrize(("dtype", "size"), [(np.float32, 1e4), (np.float64, 5e37)])
@pytest.mark.parametrize("order", OTHER_ORDERS)
def test_orders_above_eight_overflow_beyond_the_fourth_power_of_one_plus_x(
    folder: Path, order: int, dtype: type, size: float
) -> None:
    """Expect accurate results where the eleventh power overflows (|v| > 57 or 1e14), and NaN where the fourth does.

    Allow the gate of shadows, 10 n eps, times 2n for one more derivative of powers of this degree.
    """
    module = load(order, folder)
    count = _runtime.POINTWISE_MAX + 1  # fewer poses of float32 have the range of Python floats
    v = (size * sampling.dual_vectors("far", np.float64, count)).astype(dtype)
    w = sampling.dual_vectors("far too", np.float64, count).astype(dtype)
    forward = dict.fromkeys(("quaternion", "pose", "tensor", "tangent", "tangent_inv"), ())
    for name, given in {**forward, "tangent_dot": (w,), "twist_jacobian": (w,)}.items():
        function, eps = getattr(module, name), 10 * order * (2 * order if given else 1) * np.finfo(dtype).eps
        exact = function(v.astype(np.longdouble), *given)
        assert np.abs(function(v, *given) - exact).max() <= eps * np.abs(exact).max()
        assert np.isnan(function(100 * v, *given)).any(axis=tuple(range(1, exact.ndim))).all()
