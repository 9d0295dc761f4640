"""The example of the attitude filter: a consistent filter, two that are not, and the branch of its state."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import chi2

from examples import attitude_filter as example

RUNS, STEPS = 40, 240
EXACT, NONE, INVERTED = example.TRANSPORTS.values()


@pytest.fixture(scope="module")
def data() -> tuple[np.ndarray, ...]:
    return example.simulate(RUNS, STEPS)


def test_the_filter_knows_its_errors_with_the_right_covariance(data: tuple[np.ndarray, ...]):
    sizes, _, _, nees = example.estimate(data, EXACT)
    assert (sizes > 1).sum(axis=0).min() >= 5
    # runs are independent; at any time their sum is χ² of 6 RUNS, apart from the second order of errors below 1 %
    low, high = chi2.ppf((1e-5, 1 - 1e-5), 6 * RUNS) / RUNS
    mean = nees.mean(axis=1)
    assert low < mean.min()
    assert mean.max() < high


@pytest.mark.parametrize(("transport", "excess"), [(NONE, 100), (INVERTED, 2)])
def test_other_transports_of_covariance_are_far_too_sure(data: tuple[np.ndarray, ...], transport, excess: float):
    *_, nees = example.estimate(data, transport)
    assert nees[-1].mean() > 6 * excess


def test_formulas_agree_at_the_switch_for_size_one_only():
    sigma = np.array([[[0.6], [0], [0.8]], [[0.66], [0], [0.88]]])
    same, other = INVERTED(sigma) - EXACT(sigma)
    assert np.abs(same).max() < 1e-15
    assert np.abs(other).max() > 0.3
