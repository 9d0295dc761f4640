"""Tangent operators, twists and rates, in comparison with derivatives of tensor and pose and with each other."""

from __future__ import annotations

import importlib
from types import ModuleType

import numpy as np
import pytest

import dualcay
from tests.support import errors, sampling
from tests.support.errors import assert_close
from tests.support.nilpotent import Nil
from tests.support.sampling import reached

EPS = float(np.finfo(float).eps)
REGIMES = ("uniform", "angle 1e-12", "angle 1e-7", "middle band", "below pi", "shadow", "translation 1e6", "identity")
REGIME = pytest.mark.parametrize("regime", REGIMES)
COMPLEX_STEP = 1e-40  # complex steps subtract nothing, so only underflow limits the step


def vect(m: np.ndarray) -> np.ndarray:
    return np.stack([m[..., 2, 1] - m[..., 1, 2], m[..., 0, 2] - m[..., 2, 0], m[..., 1, 0] - m[..., 0, 1]], -1) / 2


def spin(tensor: np.ndarray, change: np.ndarray) -> np.ndarray:
    """Return vect(Ṙ Rᵀ) of dual tensors."""
    (r, r_du), (c, c_du) = np.moveaxis(tensor, -3, 0), np.moveaxis(change, -3, 0)
    back, back_du = np.swapaxes(r, -1, -2), np.swapaxes(r_du, -1, -2)
    return np.concatenate([vect(c @ back), vect(c_du @ back + c @ back_du)], axis=-1)


def twist_of_pose(pose: np.ndarray, change: np.ndarray) -> np.ndarray:
    """Return [ω, v] of Ṫ T⁻¹ = [[skew ω, v], [0, 0]]."""
    velocity = change @ np.linalg.inv(pose)
    return np.concatenate([vect(velocity[..., :3, :3]), velocity[..., :3, 3]], axis=-1)


def allowed(order: int, v: np.ndarray) -> Nil:
    """Return the scale of T e_j = vect(Ṙ Rᵀ): the scale of T times the scales of both tensors."""
    local = errors.scales(order, v)
    return local.tangent * local.tensor * local.tensor


@REGIME
def test_complex_steps_of_the_tensor(kernel: ModuleType, order: int, regime: str) -> None:
    v = reached(order, regime)
    operators = dualcay.matrix6(kernel.tangent(v))
    for j, direction in enumerate(np.eye(6)):
        change = kernel.tensor(v + 1j * COMPLEX_STEP * direction).imag / COMPLEX_STEP
        for i, found in enumerate(spin(kernel.tensor(v), change)):
            assert_close(found, operators[i, :, j], allowed(order, v[i]), errors.AGREE * EPS)


@REGIME
def test_operators_of_the_body_take_rates_to_body_twists_and_back(kernel: ModuleType, order: int, regime: str) -> None:
    """Check that body operators transpose each part of the dual tensor, and not the 6x6 matrix."""
    v = reached(order, regime)
    space, body = kernel.tangent(v), kernel.body_tangent(v)
    np.testing.assert_array_equal(body, np.swapaxes(space, -1, -2))
    np.testing.assert_array_equal(kernel.body_tangent_inv(v), np.swapaxes(kernel.tangent_inv(v), -1, -2))
    rates = sampling.dual_vectors("rates", count=len(v))
    twists = np.einsum("...ij,...j->...i", dualcay.matrix6(body), rates)
    for i, twist in enumerate(kernel.body_twist(v, rates)):
        assert_close(twists[i], twist, allowed(order, v[i]) * errors.size(rates[i]), errors.AGREE * EPS)
    if regime == "uniform":
        wrong = np.einsum("...ji,...j->...i", dualcay.matrix6(space), rates)
        assert (abs(wrong - twists).max(axis=-1) > 0.01).all()


@REGIME
def test_complex_steps_of_the_pose(kernel: ModuleType, order: int, regime: str) -> None:
    v = reached(order, regime)
    rates = sampling.dual_vectors("rates", count=len(v))
    change = kernel.pose(v + 1j * COMPLEX_STEP * rates).imag / COMPLEX_STEP
    found = twist_of_pose(kernel.pose(v), change)
    for i, twist in enumerate(kernel.twist(v, rates)):
        assert_close(found[i], twist, allowed(order, v[i]) * errors.size(rates[i]), errors.AGREE * EPS)


@REGIME
def test_complex_steps_of_the_quaternion(kernel: ModuleType, order: int, regime: str) -> None:
    """Compare with q̇ = ω q / 2, in the real and the dual part."""
    v = reached(order, regime)
    rates = sampling.dual_vectors("rates", count=len(v))
    change = kernel.quaternion(v + 1j * COMPLEX_STEP * rates).imag / COMPLEX_STEP
    q, w = kernel.quaternion(v), kernel.twist(v, rates)

    def product(omega: np.ndarray, p: np.ndarray) -> np.ndarray:
        scalar = -np.einsum("ij,ij->i", omega, p[:, 1:])
        return np.concatenate([scalar[:, None], p[:, :1] * omega + np.cross(omega, p[:, 1:])], axis=-1) / 2

    expected = [product(w[:, :3], q[:, :4]), product(w[:, 3:], q[:, :4]) + product(w[:, :3], q[:, 4:])]
    for i, (found, wanted) in enumerate(zip(change, np.concatenate(expected, axis=-1), strict=True)):
        assert_close(found, wanted, allowed(order, v[i]) * errors.size(rates[i]), errors.AGREE * EPS)


@REGIME
def test_twist_and_rate_are_the_operators_applied_and_undo_each_other(
    kernel: ModuleType, order: int, regime: str
) -> None:
    v = reached(order, regime)
    w = sampling.dual_vectors("twists", count=len(v))
    forth, back = dualcay.matrix6(kernel.tangent(v)), dualcay.matrix6(kernel.tangent_inv(v))
    twist, rate = kernel.twist(v, w), kernel.rate(v, w)
    again, undone = kernel.rate(v, twist), kernel.twist(v, rate)
    identity = np.eye(6)
    for i in range(len(v)):
        local, size = errors.scales(order, v[i]), errors.size(w[i])
        inverse, tolerance = local.near_pole, errors.AGREE * EPS
        assert_close(twist[i], forth[i] @ w[i], local.tangent * size, tolerance)
        assert_close(rate[i], back[i] @ w[i], inverse * size, tolerance)
        assert_close(again[i], w[i], inverse * local.tangent * size, tolerance)
        assert_close(undone[i], w[i], inverse * local.tangent * size, tolerance)
        for j in range(3):
            assert_close(forth[i] @ back[i][:, j], identity[:, j], inverse * local.tangent, tolerance)


@REGIME
def test_body_twists_are_space_twists_turned_back(kernel: ModuleType, order: int, regime: str) -> None:
    v = reached(order, regime)
    w = sampling.dual_vectors("twists", count=len(v))
    space = kernel.transform_line(v, kernel.body_twist(v, w))
    again = kernel.body_rate(v, kernel.body_twist(v, w))
    from_space = kernel.rate(v, kernel.transform_line(v, w))
    transposed = np.swapaxes(kernel.tangent(v), -1, -2)
    for i in range(len(v)):
        local, size = errors.scales(order, v[i]), errors.size(w[i])
        tolerance = errors.AGREE * EPS
        assert_close(space[i], kernel.twist(v[i], w[i]), allowed(order, v[i]) * size, tolerance)
        applied = dualcay.matrix6(transposed[i]) @ w[i]
        assert_close(kernel.body_twist(v[i], w[i]), applied, local.tangent * size, tolerance)
        assert_close(again[i], w[i], local.near_pole * local.tangent * size, tolerance)
        assert_close(kernel.body_rate(v[i], w[i]), from_space[i], local.near_pole * local.tensor * size, tolerance)


TINY, SMALL = 1e-300, 1e-6


@pytest.mark.parametrize("chart", ["cayley3", "cayley5", "lambert", "sine3", "exponential", "scaled4"])
def test_jacobian_of_a_shadow_is_finite_where_x_underflows(chart: str) -> None:
    kernels = importlib.import_module(f"dualcay.{chart}")
    direction = np.array([1.0, 2.0, -2.0]) / 3
    tiny, small = (kernels.shadow_jacobian([*(size * direction), 0, 0, 0], 1) for size in (TINY, SMALL))
    along, across = direction, np.array([2.0, 1.0, 2.0]) / 3
    assert np.isfinite(tiny).all()
    for block in (slice(0, 3), slice(3, 6)):
        # across the axis, the Jacobian is r_k/r and grows like 1/r
        expected = across @ small[block, block] @ across * SMALL
        assert across @ tiny[block, block] @ across * TINY == pytest.approx(expected, rel=1e-5)
    slope = kernels.shadow_jacobian([TINY, 0, 0, 0.1, 0, 0], 1)
    assert np.isfinite(slope).all(axis=1)[0]
    assert slope[0, 0] == pytest.approx(along @ small[:3, :3] @ along, rel=1e-4, abs=1e-4)
    assert not np.isnan(slope).any()
