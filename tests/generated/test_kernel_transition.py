"""Derivatives of v by its start and by the vector of another chart."""

from __future__ import annotations

import importlib
import itertools

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import dualcay
from dualcay import cayley2, cayley3, exponential, matrix6
from tests.support import sampling

CHARTS = ("cayley2", "cayley3", "scaled2", "exponential")
FRAMES = ("", "body_")
START = np.array([0.2, -0.1, 0.3, 0.5, -1.0, 0.7])
"""Exponential coordinates of the initial pose; with `twist` the rotation angle stays below 3."""

EPS = float(np.finfo(float).eps)
COMPLEX_STEP = 1e-30  # complex steps subtract nothing
INTEGRATED = 1e-10  # about 100 steps with relative errors of 1e-13 each, which grow by less than 10
DIFFERENCE = 1e-11  # longdouble: h^4/30 of fifth derivatives below 1e4 for h = 1e-4, and rounding 1e-19/h


def twist(t: float) -> np.ndarray:
    return np.array([np.cos(t), 0.4 * np.sin(2 * t), 0.3, t, -0.5, np.sin(3 * t)])


def chart(name: str):
    return importlib.import_module(f"dualcay.{name}")


def varied(name: str, frame: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Integrate v and ∂v/∂v0 by the variational equation; return v0, v and the derivative."""
    module = chart(name)
    rate = getattr(module, f"{frame}rate")

    def slope(t: float, state: np.ndarray) -> np.ndarray:
        v, jacobian = state[:6], state[6:].reshape(6, 6)
        by_v = rate(v + 1j * COMPLEX_STEP * np.eye(6), twist(t)).imag.T / COMPLEX_STEP
        return np.concatenate([rate(v, twist(t)), (by_v @ jacobian).ravel()])

    v0 = module.from_exponential(START)
    start = np.concatenate([v0, np.eye(6).ravel()])
    state = solve_ivp(slope, (0, 1.5), start, method="DOP853", rtol=1e-13, atol=1e-14).y[:, -1]
    return v0, state[:6], state[6:].reshape(6, 6)


@pytest.mark.parametrize(("name", "frame"), [*itertools.product(CHARTS, FRAMES)])
def test_transition_solves_the_variational_equation(name: str, frame: str) -> None:
    v0, v, expected = varied(name, frame)
    assert np.linalg.norm(expected - np.eye(6)) > 0.1
    found = getattr(chart(name), f"{frame}transition")(v, v0)
    np.testing.assert_allclose(found, expected, rtol=0, atol=INTEGRATED * abs(expected).max())
    other = getattr(chart(name), "transition" if frame else "body_transition")(v, v0)
    assert abs(other - expected).max() > 1e-2
    real = getattr(chart(f"rotation.{name}"), f"{frame}transition")(v[:3], v0[:3])
    np.testing.assert_allclose(real, expected[:3, :3], rtol=0, atol=INTEGRATED * abs(expected).max())


def assert_equal(found: np.ndarray, expected: np.ndarray) -> None:
    """Compare within the rounding of a product of five 6x6 matrices with condition numbers below 1e3."""
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-11 * abs(expected).max())


@pytest.mark.parametrize("name", CHARTS)
def test_covariance_of_the_pose_is_the_same_after_transition_and_in_every_branch_and_chart(name: str) -> None:
    """Compare Σ = T P Tᵀ: constant in the frame whose twist is not given, moved with the pose in the other frame."""
    module, root = chart(name), sampling.dual_vectors("covariance", count=6)
    v0, step = module.from_exponential(START), np.array([0.9, -0.4, 0.8, 1, 0.5, -2])

    def spread(operator: np.ndarray, by: np.ndarray) -> np.ndarray:
        onto = matrix6(operator) @ by @ root
        return onto @ onto.T

    for frame, other in (FRAMES, FRAMES[::-1]):
        v = getattr(module, f"{frame}retract")(v0, step)
        by_v0 = getattr(module, f"{frame}transition")(v, v0)
        still, given = (getattr(module, f"{each}tangent") for each in (other, frame))
        assert_equal(spread(still(v), by_v0), spread(still(v0), np.eye(6)))
        now, then = module.adjoint(v), module.adjoint(v0)
        moved = np.linalg.solve(now, then) if frame else now @ np.linalg.inv(then)
        assert_equal(spread(given(v), by_v0), moved @ spread(given(v0), np.eye(6)) @ moved.T)
    images = [(module, module.shadow(v0, 1), module.shadow_jacobian(v0, 1))]
    for target in map(chart, CHARTS):
        images.append((target, dualcay.convert(v0, module, target), dualcay.convert_jacobian(v0, module, target)))
    for (target, w, by_v0), frame in itertools.product(images, FRAMES):
        here, there = (getattr(each, f"{frame}tangent") for each in (module, target))
        assert_equal(spread(there(w), by_v0), spread(here(v0), np.eye(6)))


ANGLES = np.pi * np.array([0.02, 0.6, 1.3, 2.6, 4.5])
"""Rotation angles in the exponential chart; the last ones lie beyond the edges of other charts."""


@pytest.mark.parametrize("name", [*CHARTS, "cayley1", "lambert", "breusing"])
def test_convert_jacobian_is_the_derivative_of_convert(name: str) -> None:
    target, axis = chart(name), np.array([0.48, 0.6, 0.64, 1, 0.4, -1.125], np.longdouble)
    w = exponential.from_screw(np.stack([ANGLES, 0.3 + 0 * ANGLES], -1).astype(np.longdouble), axis)
    h = np.longdouble(1e-4)

    def central(step: np.longdouble) -> np.ndarray:
        moved = [dualcay.convert(w + sign * step * np.eye(6)[:, None], exponential, target) for sign in (1, -1)]
        return np.moveaxis((moved[0] - moved[1]) / (2 * step), 0, -1)

    expected = (4 * central(h) - central(2 * h)) / 3
    found = dualcay.convert_jacobian(w, exponential, target)
    assert found.dtype == np.longdouble
    sizes = abs(expected).max(axis=(1, 2), keepdims=True)
    assert (abs(found - expected) < DIFFERENCE * sizes).all()
    real = dualcay.convert_jacobian(w[:, :3], chart("rotation.exponential"), chart(f"rotation.{name}"))
    assert (abs(real - expected[:, :3, :3]) < DIFFERENCE * sizes).all()


def test_convert_jacobian_of_the_same_chart_and_of_the_identity() -> None:
    v = cayley3.from_exponential(START)
    np.testing.assert_allclose(dualcay.convert_jacobian(v, cayley3, cayley3), np.eye(6), rtol=0, atol=1e-14)
    found = dualcay.convert_jacobian(np.zeros(6), cayley3, exponential)
    np.testing.assert_array_equal(found, 6 * np.eye(6))


@pytest.mark.parametrize("distance", [1e-2, 1e-5])
def test_convert_jacobian_loses_digits_by_the_distance_from_a_whole_turn(distance: float) -> None:
    """Allow 16 roundings of T⁻¹ T: T⁻¹ is of order 1/distance, its dual part of order 1/distance²."""
    v = cayley3.from_exponential(np.array([2 * np.pi - distance, 0, 0, 0.1, 0.2, 0.3]))
    expected = dualcay.convert_jacobian(v.astype(np.longdouble), cayley3, exponential)
    errors = abs(dualcay.convert_jacobian(v, cayley3, exponential) - expected) / abs(expected).max()
    real, every = 16 * EPS / distance, 16 * EPS / distance**2
    assert errors[:3, :3].max() < real
    assert EPS / distance < errors.max() < every


def test_convert_jacobian_of_nan_is_nan_in_that_element_alone() -> None:
    found = dualcay.convert_jacobian(np.array([START / 9, np.full(6, np.nan)]), cayley3, exponential)
    assert np.isfinite(found[0]).all()
    assert np.isnan(found[1]).all()


def test_convert_jacobian_keeps_layouts_and_types_and_names_errors() -> None:
    v = sampling.dual_vectors("layouts", count=6).reshape(2, 3, 6).astype(np.float32) / 8
    expected = dualcay.convert_jacobian(v, cayley3, cayley2)
    out = np.empty((6, 6, 2, 3), np.float32)
    assert dualcay.convert_jacobian(np.moveaxis(v, -1, 0), cayley3, cayley2, axis=0, out=out) is out
    np.testing.assert_allclose(np.moveaxis(out, (0, 1), (-2, -1)), expected, rtol=1e-5, atol=1e-6)
    assert expected.dtype == np.float32
    assert dualcay.convert_jacobian(np.zeros((0, 6)), cayley3, cayley2).shape == (0, 6, 6)
    with pytest.raises(TypeError, match="v must be real"):
        dualcay.convert_jacobian(v * 1j, cayley3, cayley2)
    with pytest.raises(TypeError, match="target must be a kernel module"):
        dualcay.convert_jacobian(v, cayley3, "cayley2")
    with pytest.raises(ValueError, match=r"out must have shape \(2, 3, 6, 6\), got \(6, 6\)"):
        dualcay.convert_jacobian(v, cayley3, cayley2, out=np.empty((6, 6)))
