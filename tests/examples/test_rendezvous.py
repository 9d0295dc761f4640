"""The example of the rendezvous: docking, and the covariance of `propagate` against random runs."""

from __future__ import annotations

import numpy as np

from dualcay import cayley2, propagate
from examples import rendezvous as example

RUNS = 400


def test_the_chaser_docks():
    path = example.approach()
    assert cayley2.angle(example.START)[0] > 2.8
    # the slower root of s² + 0.2 s + 0.01 is −0.1 1/s: (1 + 9) e⁻⁹ of the start, and small terms beyond the first order
    assert np.linalg.norm(path(example.END)[:6]) < 2 * 10 * np.exp(-9) * np.linalg.norm(example.START)


def test_covariance_agrees_with_random_runs():
    path, t = example.approach(), np.linspace(0, example.END, example.STEPS + 1)
    _, by_step = cayley2.body_retract_jacobians(example.START, np.zeros(6))
    start = by_step @ np.diag(example.DEVIATION**2) @ by_step.T
    runs = example.random_runs(path, RUNS)

    def found(noise: np.ndarray | None) -> float:
        motion = propagate(
            cayley2, example.START, lambda t: path(t)[6:], t, frame="body", covariance=start, noise=noise
        )
        return example.nees(motion.v[1:], motion.covariance[1:], runs)[-1]

    # the mean of χ² of 6 over independent runs, within four deviations and 2 % for the second order
    assert abs(found(np.diag(example.NOISE**2)) - 6) < 4 * np.sqrt(12 / RUNS) + 0.12
    assert found(None) > 8  # without the noise, which adds about as much as the start has
