"""Applications of derivatives: a consistent Kalman filter, and a pose graph with quadratic convergence."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest
from scipy.stats import chi2  # type: ignore[import-untyped]

from tests.support import sampling

RUNS, STEPS, SEEN, DT = 200, 40, 20, 0.05
POINTS = np.array([[1.0, 0, 0], [0, 2.0, 0], [0, 0, 1.5], [-1.0, 1.0, 0.5]])
SPREAD, RATE_NOISE, POINT_NOISE = 0.05, 0.02, 0.02


def transposed(a: np.ndarray) -> np.ndarray:
    return np.swapaxes(a, -1, -2)


def filtered(kernel: ModuleType, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Return final errors and covariances of all filter runs; twists and positions of known points are measured."""
    twist = np.array([0.6, -0.4, 0.8, 1.0, 0.2, -0.6])
    scale = kernel.rate(np.zeros(6), np.ones(6))[0]  # φ′(0), unit of v in this chart
    P = np.broadcast_to((SPREAD * scale) ** 2 * np.eye(6), (RUNS, 6, 6))
    true = np.zeros((RUNS, 6))
    v = true + SPREAD * scale * rng.normal(size=(RUNS, 6))
    for step in range(1, STEPS + 1):
        measured = twist + RATE_NOISE * rng.normal(size=(RUNS, 6))
        true = true + DT * kernel.rate(true, twist)
        F, G = np.eye(6) + DT * kernel.rate_jacobian(v, measured), DT * sixfold(kernel.tangent_inv(v))
        v = v + DT * kernel.rate(v, measured)
        P = F @ P @ transposed(F) + RATE_NOISE**2 * G @ transposed(G)
        if step % SEEN:
            continue
        seen = kernel.transform_point(true[:, None], POINTS) + POINT_NOISE * rng.normal(size=(RUNS, len(POINTS), 3))
        H = kernel.transform_point_jacobians(v[:, None], POINTS)[0].reshape(RUNS, -1, 6)
        S = H @ P @ transposed(H) + POINT_NOISE**2 * np.eye(H.shape[1])
        K = transposed(np.linalg.solve(S, H @ P))
        v = v + np.einsum("rij,rj->ri", K, (seen - kernel.transform_point(v[:, None], POINTS)).reshape(RUNS, -1))
        P = P - K @ H @ P
    return v - true, P


def sixfold(tensor: np.ndarray) -> np.ndarray:
    """Return the real matrix of a dual tensor."""
    re, du = tensor[:, 0], tensor[:, 1]
    return np.block([[re, 0 * re], [du, re]])


def test_a_kalman_filter_is_consistent(kernel: ModuleType, order: int) -> None:
    """Expect the sum of normalized squared errors of all runs within the 99 % interval of χ²."""
    error, P = filtered(kernel, sampling.generator("filter", order))
    total = np.einsum("ri,rij,rj->", error, np.linalg.inv(P), error)
    low, high = chi2.ppf((0.005, 0.995), 6 * RUNS)
    assert low < total < high
    # the interval shows an error of 25 % in the covariance
    assert not low < total / 1.25 < high
    assert not low < total * 1.25 < high


def test_a_pose_graph_converges_quadratically(kernel: ModuleType, order: int) -> None:
    """Solve a ring of six poses, each measured relative to the previous one, with the first held fixed."""
    count = 6
    rng = sampling.generator("graph", order)
    scale = kernel.rate(np.zeros(6), np.ones(6))[0]
    truth = scale * np.concatenate([0.25 * rng.normal(size=(count, 3)), rng.normal(size=(count, 3))], axis=-1)
    edges = [(i, (i + 1) % count) for i in range(count)]
    measured = np.array([kernel.between(truth[j], truth[i]) for i, j in edges])
    v = truth + 0.02 * scale * np.r_[np.zeros((1, 6)), rng.normal(size=(count - 1, 6))]
    steps = []
    for _ in range(6):
        J, residual = np.zeros((6 * count, 6 * count)), np.zeros(6 * count)
        for e, (i, j) in enumerate(edges):
            rows = slice(6 * e, 6 * e + 6)
            residual[rows] = kernel.between(v[j], v[i]) - measured[e]
            J[rows, 6 * j : 6 * j + 6], J[rows, 6 * i : 6 * i + 6] = kernel.between_jacobians(v[j], v[i])
        step = np.linalg.lstsq(J[:, 6:], -residual, rcond=None)[0]
        v[1:] += step.reshape(-1, 6)
        steps.append(np.linalg.norm(step) / scale)
    assert np.abs(v - truth).max() < 1e-11 * scale
    # with zero residual at the solution, Gauss-Newton converges quadratically, like Newton's method
    first, second, third = steps[:3]
    assert second < 5 * first**2
    assert third < max(5 * second**2, 1e-13)


def test_jacobians_follow_the_chain_rule(kernel: ModuleType, order: int) -> None:
    """Multiply Jacobians of a composition and of its inverse; expect the identity to 1e-12, at conditions below 100."""
    v2, v1 = (0.3 / order * sampling.dual_vectors(f"chain {i}") for i in (1, 2))
    v = kernel.compose(v2, v1)
    by_v2, by_v1 = kernel.compose_jacobians(v2, v1)
    undone, (by_v, by_one) = kernel.between(v, v2), kernel.between_jacobians(v, v2)  # R(v2)⁻¹ R(v) = R(v1)
    np.testing.assert_allclose(undone, v1, rtol=0, atol=1e-12)
    np.testing.assert_allclose(by_v @ by_v1, np.broadcast_to(np.eye(6), by_v.shape), rtol=0, atol=1e-12)
    np.testing.assert_allclose(by_v @ by_v2 + by_one, 0 * by_v, rtol=0, atol=1e-12)


@pytest.mark.parametrize("regime", ["uniform", "shadow", "pure translation", "identity"])
def test_steps_are_taken_on_the_branch_of_v_and_found_again(kernel: ModuleType, order: int, regime: str) -> None:
    """Expect v after a zero step, also on shadows, and small steps recovered by ``local``, both to 1e-9."""
    if not sampling.has_regime(order, regime):
        return
    v, delta = sampling.poses(order, regime), 1e-3 * sampling.dual_vectors("steps")
    for step, back in ((kernel.retract, kernel.local), (kernel.body_retract, kernel.body_local)):
        size = np.abs(v).max(axis=-1, keepdims=True)
        assert (np.abs(step(v, np.zeros(6)) - v) <= 1e-9 * size).all()
        np.testing.assert_allclose(back(step(v, delta), v), delta, rtol=0, atol=1e-9)


def test_powers_do_not_depend_on_the_chart(kernel: ModuleType, order: int) -> None:
    """Expect equal powers of a generalized force (τ·v̇) and of its wrench, and the same force from the body wrench."""
    v, v_dot, z = (sampling.dual_vectors(f"power {i}") / (order if i == 1 else 1) for i in (1, 2, 3))
    tau, omega = kernel.cotangent(v, z), kernel.twist(v, v_dot)
    power = (z[:, 3:] * omega[:, :3] + z[:, :3] * omega[:, 3:]).sum(-1)
    np.testing.assert_allclose((tau[:, 3:] * v_dot[:, :3] + tau[:, :3] * v_dot[:, 3:]).sum(-1), power, rtol=1e-11)
    there = np.linalg.solve(kernel.adjoint(v), z[..., None])[..., 0]
    np.testing.assert_allclose(kernel.body_cotangent(v, there), tau, rtol=1e-11, atol=1e-12)
