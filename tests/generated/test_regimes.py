"""Law of regimes: every function of a vector is right, not finite or an error, in every regime of every chart."""

from __future__ import annotations

import itertools
import warnings
from collections.abc import Callable, Iterator
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import dualcay
from derive import about
from dualcay import exponential
from tests.support import families, regimes, thorough
from tests.support.regimes import Call
from tests.support.subjects import OUTSIDE, REGIMES, Subject, subject

CHARTS = (*(f"cayley{n}" for n in about.ORDERS), *about.FAMILIES)
ENDING = [name for name in CHARTS if subject(name).ends]
EPS = np.finfo(float).eps
SAMPLE = 88
"""Share of functions that a chart is tried with in one regime by default; the next chart and regime take others."""
OUTSIDE_SAMPLE = 12
"""Share of functions that are tried with vectors outside a chart, which need no oracle."""

THOROUGH = 8
"""Share of functions that a chart is tried with in one regime by the thorough tests."""


@pytest.fixture(autouse=True)
def warnings_are_errors() -> Iterator[None]:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


def chosen(chart: Subject, regime: str, place: int, share: int, dtype: Any = np.float64) -> Iterator[Call]:
    """Yield calls of a share of the functions of vectors, with all vectors outside and one of the others."""
    names = [name for name, row in chart.table.public.items() if regimes.takes_vectors(row)]
    several = min(share, OUTSIDE_SAMPLE)
    for turn, name in enumerate(names):
        in_turn = (turn + 7 * place) % share == 0
        if in_turn or (turn + place) % several == 0:
            found = list(regimes.calls(chart, name, regime, dtype))
            inside = [call for call in found if call.fate != OUTSIDE]
            yield from (call for call in found if call.fate == OUTSIDE)
            if in_turn and inside:
                yield inside[(3 * place + turn) % len(inside)]


def wrong(calls: Iterator[Call]) -> list[str]:
    return [reason for reason in (call.judged() for call in calls) if reason]


@thorough.shares(THOROUGH, SAMPLE)
@pytest.mark.parametrize("table", ["", "rotation"])
@pytest.mark.parametrize("name", CHARTS)
def test_every_function_is_right_or_not_finite(name: str, table: str, share: int) -> None:
    for place, regime in enumerate(REGIMES, CHARTS.index(name) + 5 * bool(table)):
        chart = subject(name, table, regimes.DIGITS.get(regime, families.DIGITS))
        dtype = np.float32 if place % 4 == 3 and share > 1 else np.float64
        assert wrong(chosen(chart, regime, place, share, dtype)) == [], regime


NEXT_AXES = [1, 2, 0, 4, 5, 3]
PRODUCTS = ("compose", "between", "retract", "body_retract", "local", "body_local", "interpolate")


@pytest.mark.parametrize(
    ("name", "table"), thorough.in_turn((name for name in CHARTS if subject(name).edge < np.inf), ("", "rotation"))
)
def test_products_of_long_vectors_are_those_of_shorter_ones(name: str, table: str) -> None:
    """Expect rotations of vectors of length 1e15 for longer ones, or no finite result.

    Vectors of these lengths have one pose to 1e-15; 1e-12 leaves room for sums of rounding errors. At the power 0.2506
    the square of the quaternion of n = 2 overflows beyond the second vector of `interpolate`, but not at the first.
    """
    chart, steps = subject(name, table), subject("exponential", table)
    powers = (0.06, 0.1, 0.2, 0.2506, 0.253, 0.3, 0.34, 0.45, 0.51, 0.8)
    long = chart.at([float(np.finfo(float).max) ** power for power in powers], np.float64)
    short = np.tile(chart.at([1e15], np.float64), (len(powers), 1))
    for function, crowd in itertools.product(PRODUCTS, (1, 3)):
        made, time = steps if "local" in function else chart, [1.7] * (function == "interpolate")
        for turned in (False, True) if "retract" not in function else (False,):  # two long vectors, or a usual one
            pairs = ((v, v[:, NEXT_AXES[: v.shape[1]]] if turned else np.full_like(v, 0.1)) for v in (long, short))
            found, wanted = (getattr(chart.module, function)(*np.tile(pair, (1, crowd, 1)), *time) for pair in pairs)
            finite = np.isfinite(found).all(axis=-1) & np.isfinite(wanted).all(axis=-1)
            one, other = (made.module.tensor(w).reshape(len(w), -1)[:, :9] for w in (found, wanted))
            assert not (abs(one - other).max(axis=-1)[finite] > 1e-12).any(), (function, turned, found, wanted)
    angles, usual = (np.linalg.norm(chart.module.to_exponential(v)[:, :3], axis=-1) for v in (long, short))
    assert not (abs(angles - usual) > 1e-12 * usual).any(), angles


@thorough.shares(1, SAMPLE)
@pytest.mark.parametrize("name", CHARTS)
def test_inverse_maps_are_right_or_not_finite(name: str, share: int) -> None:
    """Half turns and poses of other norms are right, and what is no pose gives no finite vector."""
    for place, (table, regime) in enumerate(itertools.product(("", "rotation"), regimes.INVERSE_REGIMES)):
        chart = subject(name, table, regimes.DIGITS.get(regime, families.DIGITS))
        maps = [function for function in regimes.POSES_OF if function in chart.table.public]
        for function in maps if share == 1 else [maps[(place + CHARTS.index(name)) % len(maps)]]:
            found = list(regimes.inverse_calls(chart, function, regime))
            assert wrong(iter(found[place % max(len(found), 1) :: 1 if share == 1 else 5])) == [], (table, regime)


@pytest.mark.thorough
@pytest.mark.parametrize("name", CHARTS)
def test_every_function_in_single_precision(name: str) -> None:
    for place, regime in enumerate(REGIMES, CHARTS.index(name)):
        assert wrong(chosen(subject(name), regime, place, 2 * THOROUGH, np.float32)) == [], regime


@pytest.mark.parametrize("table", ["", "rotation"])
@pytest.mark.parametrize("name", ENDING)
def test_all_functions_agree_at_the_edge(name: str, table: str) -> None:
    """Expect the edge's angle at |v| = 1 exactly, in every form, and v itself where a pose has one vector."""
    chart = subject(name, table)
    v = chart.at([chart.size(chart.edge)], np.float64, 0.0)[1]
    for given in (v, np.repeat(v[None], 25, axis=0)):
        angle = np.ravel(chart.module.angle(given))[0]
        assert abs(angle - chart.edge) <= 2 * EPS * chart.edge
        turned = chart.module.to_exponential(given).reshape(-1, v.size)[0, :3]
        assert abs(np.linalg.norm(turned) - chart.edge) <= 4 * EPS * chart.edge
        assert np.isfinite(chart.module.quaternion(given)[..., :4]).all()
        if chart.module.CHART.branches == 1:
            np.testing.assert_array_equal(chart.module.principal(given), given)


@pytest.mark.parametrize("table", ["", "rotation"])
def test_functions_that_combine_others_end_too(table: str) -> None:
    """A switch has the principal vector; a change of chart of a vector outside is not finite."""
    for name, dtype in itertools.product(ENDING, (np.float32, np.float64)):
        chart, other = subject(name, table), subject("exponential", table).module
        for _, v in (*REGIMES["beyond the edge"](chart, dtype), *REGIMES["not finite"](chart, dtype)):
            np.testing.assert_array_equal(chart.module.switch(v), chart.module.principal(v))
            moved, rate = chart.module.switch(v, np.ones_like(v))
            for found in (moved, rate, dualcay.convert(v, chart.module, other), chart.module.shadow(v, 0)):
                assert not np.isfinite(found).all(axis=-1).any()
            assert not np.isfinite(dualcay.convert_jacobian(v, chart.module, other)).all(axis=(-2, -1)).any()


@pytest.mark.parametrize("angle", [2.0, 1e3, 1e6, 1e9, 1e12])
def test_large_angles_lose_no_digits_on_the_way_back(angle: float) -> None:
    """Expect the pose of exponential coordinates in short ones, to 16 eps, plus 3e-6 eps of the angle for shadows."""
    turns = round(angle / (2 * np.pi))
    for v in np.array([[0, 0, angle, 1, -2, 0], [0, -angle, 0, 0, 0, 0]]):
        short = [exponential.principal(v), *(exponential.shadow(v, k) for k in (turns, -turns))]
        short = [w for w in short if np.linalg.norm(w[:3]) < 4]
        assert len(short) == 2 + (turns == 0)
        for w in short:
            off = abs(exponential.tensor(w)[0] - exponential.tensor(v)[0]).max()
            assert off <= (16 + 3e-6 * angle * (w is not short[0])) * EPS


def _finite(chart: Subject, v: np.ndarray) -> np.ndarray:
    return np.asarray(chart.module.angle(np.where(np.isfinite(v) & (abs(v) < 1), v, 0.5)))


def _underflowing(chart: Subject, v: np.ndarray) -> np.ndarray:
    found = np.array(chart.module.angle(v))
    found[..., 0] *= (np.asarray(v)[..., :3] ** 2).sum(-1) > 0
    return found


CONTROLS: dict[str, tuple[str, str, Callable[[Subject, np.ndarray], Any]]] = {
    "finite beyond the edge": ("angle", "beyond the edge", _finite),
    "finite for NaN": ("angle", "not finite", _finite),
    "0 at tiny vectors": ("angle", "tiny", _underflowing),
    "half the angle before the edge": ("angle", "edge", lambda chart, v: chart.module.angle(v) / 2),
    "not finite at half a turn": ("principal", "half turn", lambda chart, v: v * np.nan),
    "another branch at half a turn": ("principal", "half turn", lambda chart, v: 2 * np.asarray(v)),
    "digits lost far away": ("pose", "far", lambda chart, v: chart.module.pose(v).astype(np.float32).astype(float)),
    "single differs from batch": ("angle", "far", lambda chart, v: chart.module.angle(v) * [1, np.nan][v.ndim - 1]),
}


@pytest.mark.parametrize("fault", CONTROLS)
def test_a_broken_edge_is_seen(fault: str) -> None:
    """Control: each fault of a function is refused by the law."""
    function, regime, broken = CONTROLS[fault]
    chart = subject("lambert", digits=regimes.DIGITS.get(regime, families.DIGITS))
    kept = {name: getattr(chart.module, name) for name in ("CHART", "__name__", "identity", "singular_angles")}
    known: Any = SimpleNamespace(**kept, **{function: lambda v: broken(chart, v)})
    assert any(call.judged() for call in regimes.calls(Subject(known, chart.oracle), function, regime))
