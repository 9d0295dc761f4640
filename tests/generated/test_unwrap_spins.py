"""Continuous branches of recordings through whole turns, where noise hides the axis of a row."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest

import dualcay
from dualcay import unwrap
from dualcay._sequences import TOLERANCE
from tests.generated.test_switching import charts

POSES, ROTATIONS = dualcay.exponential, dualcay.rotation.exponential
DTYPES = [np.float64, np.float32]
SCREW = np.array([0, 0.6, 0.8, 0.3, 0.27, -0.14])
"""Axis through a point beside the origin, with a shift along it."""


def spin(module: ModuleType, rows: int = 41, step: float = np.pi / 4) -> np.ndarray:
    return np.outer(np.arange(rows) * step, SCREW[: len(module.identity())])


def recorded(module: ModuleType, w: np.ndarray, dtype: type) -> np.ndarray:
    """Return exponential coordinates as vectors of a chart on its principal branch, within rounding of the dtype."""
    return module.principal(module.from_exponential(w).astype(dtype))


def shaken(w: np.ndarray, size: np.ndarray | float, seed: int = 0) -> np.ndarray:
    """Return poses after small turns about random axes."""
    turns = np.zeros(w.shape)
    turns[..., :3] = np.random.default_rng(seed).normal(size=(*w.shape[:-1], 3))
    turns *= size / np.linalg.norm(turns, axis=-1, keepdims=True)
    return (POSES if w.shape[-1] == 6 else ROTATIONS).compose(turns, w)


def steps(v: np.ndarray) -> np.ndarray:
    """Return the lengths of steps, in their rotation part and as a whole."""
    changes = np.diff(v.astype(float), axis=0)
    return np.array([np.linalg.norm(changes[..., :3], axis=-1), np.linalg.norm(changes, axis=-1)])


@pytest.mark.smoke
@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("module", [POSES, ROTATIONS], ids=["poses", "rotations"])
def test_rows_within_the_tolerance_of_a_whole_turn_continue_a_spin(module: ModuleType, dtype: type) -> None:
    """Allow the turn of a row, ten times in its dual part, and 100 units of rounding of vectors up to 10π."""
    true, eps = spin(module), np.finfo(dtype).eps
    for exponent in range(-16, -5):
        for all_rows in (True, False):
            size = 10.0**exponent
            given = shaken(true, size * ((np.arange(41) % 8 == 0) | all_rows)[:, None], seed=exponent + 20)
            set_above = None if size < 2**13 * eps else 4 * size
            found = unwrap(module, recorded(module, given, dtype), tolerance=set_above)
            lost = (10 + 100 * all_rows) * size + 100 * eps * 10 * np.pi  # an axis at 45° loses 31/sin(π/8) turns
            np.testing.assert_allclose(found, true, rtol=0, atol=lost, err_msg=f"{size}, all rows: {all_rows}")


@pytest.mark.parametrize("module", [POSES, ROTATIONS], ids=["poses", "rotations"])
def test_one_row_beyond_the_tolerance_costs_its_neighbours_alone(module: ModuleType) -> None:
    true = spin(module)
    for row in (8, 16, 24, 32, 40):
        for size in 10.0 ** np.arange(-10, -5):
            given = recorded(module, shaken(true, size * (np.arange(41) == row)[:, None], seed=row), np.float64)
            found, branch = unwrap(module, given, branch=True)
            others = np.arange(41) != row
            np.testing.assert_allclose(found[others], true[others], rtol=0, atol=1e-11)
            np.testing.assert_array_equal(found[row], given[row])
            assert branch[row] == 0


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("table", ["", "rotation"])
def test_any_sequence_jumps_no_more_and_no_further_than_principal_vectors(table: str, dtype: type) -> None:
    """Count in random walks and in spins with noise of every size; steps beside a whole turn may be longer.

    Poses keep the tolerance, relative to translations of up to 30.
    """
    rng, tolerance = np.random.default_rng(5), TOLERANCE * np.finfo(dtype).eps
    for module in charts(table):
        n = len(module.identity())
        walk = np.cumsum(0.7 * rng.normal(size=(40, 30, n)), axis=0)
        turning = np.arange(40)[:, None, None] * rng.choice([np.pi / 4, np.pi / 5, np.pi / 2], size=(30, 1)) * SCREW[:n]
        sizes = 10 ** rng.uniform(-17, -1, size=(40, 30, 1))
        few = sizes * (rng.uniform(size=sizes.shape) < 0.1)
        for w in (walk, shaken(turning, sizes), shaken(turning, few)):
            given = recorded(module, w, dtype)
            found = unwrap(module, given)
            half_turn = abs(module.from_exponential((np.pi + 1e-3) * np.eye(n)[0])[0])  # rounding of dtypes is less
            after, before = steps(found), steps(given)
            assert np.all(np.sum(after[0] > half_turn, axis=0) <= np.sum(before[0] > half_turn, axis=0))
            alone = np.linalg.norm(module.to_exponential(given)[..., :3], axis=-1) < 1.01 * np.sqrt(tolerance)
            after[:, alone[1:] | alone[:-1]] = 0
            assert np.all(after.max(axis=1) <= before.max(axis=1) * (1 + 1e-9)), module.__name__
            kind = module.pose if n == 6 else module.tensor
            poses = (kind(v.astype(float)) for v in (found, given))
            np.testing.assert_allclose(*poses, rtol=0, atol=2 * tolerance * 30)


@pytest.mark.parametrize("name", ["lambert", "breusing", "sine3", "cayley3", "exponential"])
def test_keyframes_at_the_last_allowed_angle_are_continued_in_every_dtype(name: str) -> None:
    """A quarter turn before the edge of a chart, rounding of an angle decides nothing."""
    for module in (getattr(dualcay, name), getattr(dualcay.rotation, name)):
        n = len(module.identity())
        axes = np.random.default_rng(1).normal(size=(300, 3))
        axes /= np.linalg.norm(axes, axis=-1, keepdims=True)
        w = np.pad(np.multiply.outer(np.radians([0, 90, 180, 270]), axes), ((0, 0), (0, 0), (0, n - 3)))
        for dtype in DTYPES:
            found = unwrap(module, recorded(module, w, dtype))
            np.testing.assert_allclose(found, module.from_exponential(w), rtol=0, atol=100 * np.finfo(dtype).eps)


def test_a_tolerance_is_a_number_from_0_to_1() -> None:
    for wrong in (-1e-9, 2.0, np.nan):
        with pytest.raises(ValueError, match="tolerance must be from 0 to 1, got "):
            unwrap(POSES, spin(POSES), tolerance=wrong)
    beside = recorded(ROTATIONS, shaken(spin(ROTATIONS), 1e-13 * (np.arange(41) == 8)[:, None]), np.float64)
    np.testing.assert_array_equal(unwrap(ROTATIONS, beside, tolerance=0)[8], beside[8])


def test_rows_near_a_whole_turn_keep_an_axis_that_differs_from_their_neighbours() -> None:
    """Turn the axis by 1 mrad a row, ten times more in a row than the tolerance allows at 1e-7 rad."""
    tilt = 1e-3 * np.arange(41)
    axes = np.stack([np.sin(tilt), 0 * tilt, np.cos(tilt)], axis=1)
    for beside in (-1e-7, 1e-7):
        w = (np.arange(41) * np.pi / 4 + beside * (np.arange(41) % 8 == 0))[1:, None] * axes[1:]
        found = unwrap(ROTATIONS, recorded(ROTATIONS, w, np.float64))
        np.testing.assert_allclose(found, w, rtol=0, atol=1e-6)  # rounding of an axis at 1e-7 rad, ten times over
