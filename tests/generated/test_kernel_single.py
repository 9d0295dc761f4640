"""IEEE results at singular points without exceptions or warnings, equal in single poses and batches."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterator
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest

from derive.codegen.signatures import PUBLIC
from dualcay import _geometry, _numbers
from tests.support import thorough
from tests.support.kernels import LAWS, load
from tests.support.signatures import SIGNATURES, components_last, rows_of


@pytest.fixture(autouse=True)
def warnings_are_errors() -> Iterator[None]:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


BRANCHED = {name for name, row in PUBLIC.items() if row.branch}

SPECIAL = {
    "v": [
        *np.array([
            [0, 0, 0, 0, 0, 0], [-0.0, -0.0, -0.0, -0.0, -0.0, -0.0],
            [1.0, 0, 0, 0, 0, 0],  # pole of tangent_inv for n = 4 and 8, half a turn for n = 2
            [0, -1.0, 0, 0.3, 0.2, 0.1], [0, 0, 0, 0, 0, 2.0], [1e200, 0, 0, 0, 1e-200, 0],
            [0, 0, 0, np.inf, 0, 0], [0, np.nan, 0, 1.0, 0, 0],
        ]),
        *(np.full(6, size) for size in (1e-320, 1e160, 1.7e308, np.inf, np.nan)),
    ],
    "q": [
        *np.array([
            [0, 0, 0, 0, 0, 0, 0, 0], [0, 1.0, 0, 0, 0, 0, 0, 0], [0, 0, 0, 1.0, -0.5, 0, 0, 0],
            [1.0, 0, 0, 0, 0, 0, 0, 0], [-1.0, 0, 0, 0, 0, 1.0, 0, 0], [1.0, 0, 0, 0, 0, 1.0, 0, 0],
        ]),
        *(np.full(8, size) for size in (np.inf, np.nan, 1e200)),
    ],
    "T": [
        np.eye(4), np.zeros((4, 4)), np.diag([1.0, -1, -1, 1]), np.diag([-1.0, 1, -1, 1]),
        *(np.full((4, 4), size) for size in (np.nan, np.inf, 1e200)),
    ],
    "r": [np.full(3, size) for size in (0.0, np.nan, np.inf, 1e308)],
    "t": [*map(np.array, (0.0, 1.0, 0.5, -3.0, 1e-320, 1e308, np.inf, np.nan, 2.0, -0.0, 1 / 3))],
}  # fmt: skip
SPECIAL["w"] = SPECIAL["v"]
SPECIAL["R"] = [np.stack([t[:3, :3], 0 * t[:3, :3]]) for t in SPECIAL["T"][:4]] + [np.full((2, 3, 3), np.nan)]
for _values in SPECIAL.values():  # shared by all tests; a kernel that writes into an argument fails
    for _value in _values:
        _value.flags.writeable = False


@pytest.mark.parametrize(("name", "order"), thorough.in_turn(SIGNATURES, LAWS))
def test_special_arguments_give_no_warning_and_batches_agree(order: int, name: str) -> None:
    """Compare single results with a batch of all special arguments, long enough for the recorded program."""
    function, kinds = getattr(load(order), name), SIGNATURES[name].arguments
    # the third argument has the same values in reverse order
    rest = [*zip(*(SPECIAL[kind][:: 1 - 2 * i] for i, kind in enumerate(kinds[1:])))] or [()]
    given = [np.stack(values) for values in zip(*((first, *one) for first in SPECIAL[kinds[0]] for one in rest))]
    times = -(-25 // len(given[0]))
    crowd = [np.concatenate([array] * times) for array in given]
    for branch in ({}, {"branch": 1}) if name in BRANCHED else ({},):
        singles = np.stack([function(*one, **branch) for one in zip(*given)] * times)
        rows = components_last(function(*rows_of(name, crowd), **branch, axis=0), singles.ndim - 1)
        for batch in (function(*crowd, **branch), rows):
            differing = np.isfinite(singles) != np.isfinite(batch)
            assert not differing.any(), [[array[i] for array in crowd] for i in np.argwhere(differing)[:, 0]]
            found, expected = (np.nan_to_num(a, posinf=0, neginf=0).reshape(len(a), -1) for a in (batch, singles))
            unit, size = 16 * np.finfo(float).eps, abs(expected).max(axis=1, initial=1, keepdims=True)
            assert (abs(found - expected) <= unit * abs(expected) + unit * size).all()


def test_special_screws_give_no_warning(kernel: ModuleType, order: int) -> None:
    for v in SPECIAL["v"]:
        kernel.to_screw(v)
        kernel.to_screw(v[None])
    for angle in ([0.0, 0.0], [order * np.pi, 1.0], [np.inf, 0], [np.nan, 1.0], [1e300, 1e300]):
        for axis in ([0, 0, 1.0, 0, 0, 0], [np.nan] * 6, [0.0] * 6):
            kernel.from_screw(angle, axis)
            kernel.from_screw(np.array([angle] * 3), np.array([axis] * 3))


def test_error_state_of_the_caller_is_kept() -> None:
    """Expect no warning under any setting of the caller, and the same setting afterwards."""
    kernel = load(4)
    with np.errstate(all="raise"):
        kernel.tangent_inv(np.array([1.0, 0, 0, 0, 0, 0]))
        kernel.tangent_inv(np.array([[1.0, 0, 0, 0, 0, 0]] * 3))
        assert set(np.geterr().values()) == {"raise"}


@pytest.mark.parametrize(("order", "size"), [(3, 4e19), (5, 1e10), (8, 1e6)])
def test_overflow_of_p_gives_nan_screws_and_shadows(order: int, size: float) -> None:
    module = load(order)
    v = np.array([size, 0, 0, 1, 0, 0], np.float32)
    crowd = np.tile(v, (40, 1))
    for results in (module.shadow(crowd, 1), *module.to_screw(crowd)):
        assert np.isnan(results).all()
    np.testing.assert_array_equal(module.shadow(v, 1), module.shadow(v.astype(np.float64), 1).astype(np.float32))


@pytest.mark.parametrize("size", [1e100, 1e155])
def test_coordinates_whose_square_overflows_have_no_vector(size: float) -> None:
    """Take φ = arctan α, which has a limit: its share of an infinite length would be 0."""
    chart = SimpleNamespace(
        reached=lambda m, alpha: (alpha,),
        coefficient=lambda m, alpha: (math.atan(alpha), 1 / (1 + alpha * alpha), alpha),
        inside=lambda m, x: (1,),
    )
    v = _geometry.from_exponential(_numbers.Floats, chart, [0.6 * size, 0, 0.8 * size, 0, 0, 0])
    assert np.allclose(v[:3], [0.3 * np.pi, 0, 0.4 * np.pi]) if size < 1e154 else not np.isfinite(v).any()
