"""The example of rotation vectors: jumps in the record, none after unwrapping, and the order of interpolation."""

from __future__ import annotations

import numpy as np
import pytest

from dualcay import exponential, unwrap
from examples import rotation_vectors as example

TIMES = np.linspace(0, example.DURATION, 81)
BETWEEN = np.linspace(0, example.DURATION, 1601)


def largest(steps: int, how: str) -> float:
    """Return the largest error of interpolated rotations, in degrees."""
    times = np.linspace(0, example.DURATION, steps + 1)
    v = example.gripper(times)
    found = example.screws(BETWEEN, times, v) if how == "screws" else example.numbers(BETWEEN, times, v)
    if how == "unwrapped":
        found = example.numbers(BETWEEN, times, unwrap(exponential, v))
    return example.errors(found, example.gripper(BETWEEN))[0].max()


@pytest.mark.smoke
def test_the_record_jumps_and_the_unwrapped_sequence_does_not():
    recorded = example.gripper(TIMES)
    continuous = unwrap(exponential, recorded)
    steps = [np.linalg.norm(np.diff(v[:, :3], axis=0), axis=-1).max() for v in (recorded, continuous)]
    assert steps[0] > np.pi
    assert steps[1] < 0.3  # at most 1 rad/s for 0.1 s, and some room for the wobble of the axis
    # one pose by two formulas of size 10
    np.testing.assert_allclose(exponential.pose(continuous), exponential.pose(recorded), rtol=0, atol=1e-13)


def test_interpolation_is_of_second_order_without_jumps():
    for how in ("screws", "unwrapped"):
        assert largest(80, how) / largest(160, how) == pytest.approx(4, rel=0.1)  # the next term is 1 % of it
    assert largest(160, "recorded") > 90
