"""The example of the heavy top: order 2, Newton's matrix, constraint and energy."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from examples import heavy_top as top

END = 0.1


@pytest.fixture(scope="module")
def centre() -> np.ndarray:
    found = solve_ivp(top.euler, (0, END), [*np.eye(3).ravel(), *top.SPIN], method="DOP853", rtol=1e-12, atol=1e-12)
    return found.y[:9, -1].reshape(3, 3) @ top.ARM


@pytest.mark.parametrize("name", top.CHARTS)
def test_order_two_and_a_fixed_point(name: str, centre: np.ndarray):
    errors = []
    for h in (2e-3, 1e-3):
        states, count = top.simulate(top.CHARTS[name], h, END)
        errors.append(np.linalg.norm(states[-1].pose[:3, 3] - centre))
        # rounding of some hundred products of poses
        assert max(np.abs(s.pose[:3, :3] @ top.ARM - s.pose[:3, 3]).max() for s in states) < 1e-13
        assert count <= 3
    # the next term is smaller by (Ω h)², at most 0.09 here
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.1)


@pytest.mark.parametrize("name", top.CHARTS)
def test_cotangent_jacobians_complete_the_derivative(name: str):
    chart, h = top.CHARTS[name], 4e-3
    states, _ = top.simulate(chart, h, 5 * h)
    rng = np.random.default_rng(0)
    v, force, direction = rng.normal(size=6) / 4, rng.normal(size=3) * 100, rng.normal(size=9)
    small = 1e-6

    def excess(t: float) -> np.ndarray:
        return top.balance(chart, states[-1], v + t * direction[:6], force + t * direction[6:], h, True)[1]

    expected = (excess(small) - excess(-small)) / (2 * small)
    # differences err by the square of the step, and by rounding over the step: about 1e-10 of the whole
    full, partial = (top.balance(chart, states[-1], v, force, h, used)[2] @ direction for used in (True, False))
    scale = np.abs(expected).max()
    assert np.abs(full - expected).max() < 1e-7 * scale
    assert np.abs(partial - expected).max() > 1e-3 * scale


def test_jacobians_save_iterations():
    with_jacobians, without = (top.simulate(top.cayley2, 1e-3, END, full)[1] for full in (True, False))
    assert with_jacobians < without - 0.5
