"""Preintegration of inertial readings
===================================

Run ``python examples/preintegration.py [--figure FILE]``.

Gyroscope and accelerometer give many readings between two key frames. Preintegration sums them up, without the state
of the first frame and without gravity, in one element of SE_2(3): rotation, position, velocity. A new estimate of the
biases then moves the sum by its Jacobian, and no reading is integrated again. The element is a vector of nine numbers;
each step is ``compose`` of `dualcay.extended`, and each Jacobian the product of those of the kernels. They are compared
with numeric differentiation and with the sums of Forster, Carlone, Dellaert and Scaramuzza, On-Manifold
Preintegration for Real-Time Visual-Inertial Odometry, IEEE Trans. Robotics 33 (2017).

.. image:: /figures/preintegration.svg
"""

# sphinx_gallery_thumbnail_path = 'reference/generated/thumbnail_preintegration.svg'

import argparse
from collections.abc import Callable, Sequence

import numpy as np

from dualcay import rotation
from dualcay.extended import exponential as chart

GRAVITY = np.array([0, 0, -9.81])  # m/s²
BIAS = np.array([0.02, -0.01, 0.015, 0.1, -0.2, 0.15])  # of gyroscope (rad/s) and accelerometer (m/s²)
STEP = 1e-3  # of differences (rad/s, m/s²)
DIFFERENCES = 1e-9  # their error: STEP⁴/30 of a fifth derivative below 1000, and roundings of size 10 by STEP
ROUNDING = 1e-12  # a thousand roundings of numbers of size 10
ZERO = np.zeros((3, 3))
COASTING = np.kron([[0, 0, 0], [0, 0, 1], [0, 0, 0]], np.eye(3))  # the velocity part, at the place of the position part


def motion(t: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the state X of a flight in a figure of eight, the angular velocity and what an accelerometer feels."""
    rates = np.array([0.4, 0.8, 0.5])
    turned, sizes = np.stack([0.3 * np.sin(t), 0.2 * np.cos(2 * t), 0.4 * t], -1), np.array([10, 5, 1.0])
    turning = np.stack([0.3 * np.cos(t), -0.4 * np.sin(2 * t), 0.4 + 0 * t], -1)
    Q, phase = rotation.exponential.tensor(turned), rates * t[..., None]
    X = np.zeros((*t.shape, 5, 5)) + np.eye(5)
    X[..., :3, :3] = Q
    X[..., :3, 3], X[..., :3, 4] = sizes * np.sin(phase), sizes * rates * np.cos(phase)
    force = -sizes * rates**2 * np.sin(phase) - GRAVITY
    return X, rotation.exponential.body_twist(turned, turning), np.einsum("...ji,...j->...i", Q, force)


def coasting(time: float) -> np.ndarray:
    """Return the matrix that moves the position by velocity times time, an automorphism of SE_2(3).

    It replaces ε of the velocity by ε + time ε' with that of the position. Vectors of all charts have this matrix.
    """
    return np.eye(9) + time * COASTING


Step = Callable[[np.ndarray, np.ndarray, float], tuple[np.ndarray, np.ndarray]]


def turning_step(gyro: np.ndarray, force: np.ndarray, dt: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the exponential coordinates of a step whose force turns with the body, and their derivative by biases."""
    by_bias = -dt * np.block([[np.eye(3), ZERO], [ZERO, np.eye(3) * dt / 2], [ZERO, np.eye(3)]])
    return np.concatenate([gyro * dt, force * dt**2 / 2, force * dt], -1), by_bias


def fixed_step(gyro: np.ndarray, force: np.ndarray, dt: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the vector of ``[[exp(gyro dt), force dt²/2, force dt], [0, I]]``, and its derivative by the biases.

    Dual parts of a vector are rates of its real part: T⁻¹ times the columns.
    """
    whole, by_bias = turning_step(gyro, force, dt)
    turn, columns = whole * np.repeat([1, 0], [3, 6]), whole * np.repeat([0, 1], [3, 6])
    by_turn, by_columns = by_bias * np.repeat([1, 0], [3, 3]), by_bias * np.repeat([0, 1], [3, 3])
    derivative = by_turn + chart.rate_jacobian(turn, columns) @ by_turn + chart.tangent_inv(turn) @ by_columns
    return turn + chart.rate(turn, columns), derivative


def preintegrated(
    gyro: np.ndarray, force: np.ndarray, bias: np.ndarray, dt: float, step: Step = turning_step
) -> tuple[np.ndarray, np.ndarray]:
    """Return the vectors of the sums of readings (count, ..., 3), and their derivatives by the biases (..., 9, 6)."""
    total, by_bias = np.zeros((*gyro.shape[1:-1], 9)), np.zeros((*gyro.shape[1:-1], 9, 6))
    for ω, f in zip(gyro - bias[..., :3], force - bias[..., 3:], strict=True):
        moved, (one, by_one) = total @ coasting(dt).T, step(ω, f, dt)
        by_moved, by_step = chart.compose_jacobians(moved, one)
        total, by_bias = chart.compose(moved, one), by_moved @ coasting(dt) @ by_bias + by_step @ by_one
    return total, by_bias


def forster(gyro: np.ndarray, force: np.ndarray, dt: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the matrix of the sum of readings (count, 3) and its derivatives by the biases, as the paper has them."""
    X, R_g, s_g, s_a, p_g, p_a = np.eye(5), *np.zeros((5, 3, 3))
    for ω, f in zip(gyro, force, strict=True):
        R, turn, skew = X[:3, :3].copy(), rotation.exponential.tensor(ω * dt), np.cross(f, np.eye(3)).T
        p_g, p_a = p_g + s_g * dt - R @ skew @ R_g * dt**2 / 2, p_a + s_a * dt - R * dt**2 / 2
        s_g, s_a = s_g - R @ skew @ R_g * dt, s_a - R * dt
        R_g = turn.T @ R_g - rotation.exponential.body_tangent(ω * dt) * dt
        X[:3, 3] += X[:3, 4] * dt + R @ f * dt**2 / 2
        X[:3, 4] += R @ f * dt
        X[:3, :3] = R @ turn
    return X, np.block([[R_g, np.zeros((3, 3))], [p_g, p_a], [s_g, s_a]])


def predicted(v: np.ndarray, total: np.ndarray, time: float) -> np.ndarray:
    """Return the state after a sum of readings from the state v at its beginning."""
    fall = np.concatenate([np.zeros(3), GRAVITY * time**2 / 2, GRAVITY * time])
    return chart.compose(fall, chart.compose(v @ coasting(time).T, total))


def main(argv: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description="Preintegration of inertial readings")
    parser.add_argument("--rate", type=int, default=200, help="readings a second")
    parser.add_argument("--frames", type=int, default=16, help="key frames, one a second")
    parser.add_argument("--figure", help="file for the picture")
    options = parser.parse_args(argv)
    frames, errors = np.arange(options.frames + 1.0), {}
    X, *_ = motion(frames)
    v = chart.from_pose(X)
    for rate in (options.rate // 2, options.rate):
        dt = 1 / rate
        _, gyro, force = motion(frames[:-1] + dt * (np.arange(rate)[:, None] + 0.5))  # at the middle of each step
        for step in (fixed_step, turning_step):
            total, _ = preintegrated(gyro + BIAS[:3], force + BIAS[3:], BIAS, dt, step)
            errors[step, rate] = abs(chart.pose(predicted(v[:-1], total, 1.0)) - X[1:]).max()
    gyro, force = gyro + BIAS[:3], force + BIAS[3:]
    for step, words, order in ((fixed_step, "fixed", 1), (turning_step, "turning", 2)):
        coarse, fine = errors[step, options.rate // 2], errors[step, options.rate]
        print(f"force {words} in a step: errors after one second {coarse:.1e}, with twice the readings {fine:.1e}")
        assert abs(np.log2(coarse / fine) - order) < 0.1

    old, by_bias = preintegrated(gyro, force, 0 * BIAS, dt)  # of an estimate without biases
    h = STEP * np.eye(6)[:, None]
    near, back, far, far_back = (preintegrated(gyro[:, None], force[:, None], s * h, dt)[0] for s in (1, -1, 2, -2))
    slopes = np.moveaxis(8 * (near - back) - (far - far_back), 0, -1) / (12 * STEP)
    print(f"Jacobians by biases against numeric differentiation: {abs(by_bias - slopes).max():.1e}")
    assert abs(by_bias - slopes).max() < DIFFERENCES
    printed, J = forster(gyro[:, 0], force[:, 0], dt)
    total, by_all = preintegrated(gyro[:, 0], force[:, 0], 0 * BIAS, dt, fixed_step)
    Q, body = printed[:3, :3], chart.body_tangent(total) @ by_all
    gaps = abs(chart.pose(total) - printed).max(), abs([*body[:3], *(Q @ body[3:6]), *(Q @ body[6:])] - J).max()
    print(f"sums of Forster et al. with a fixed force: differences {gaps[0]:.1e}, Jacobians {gaps[1]:.1e}")
    assert max(gaps) < ROUNDING

    sizes, left = np.logspace(-2, 0, 9), []
    for size in sizes:
        delta = chart.local(old + by_bias @ (size * BIAS), preintegrated(gyro, force, size * BIAS, dt)[0])
        left.append(abs(delta).reshape(-1, 3, 3).max((0, 2)))
    print("first-order correction by the whole bias, errors (rad, m, m/s):", *(f"{e:.1e}" for e in left[-1]))
    assert np.all(np.diff(np.log(left), axis=0) > 1.8 * np.diff(np.log(sizes))[:, None])  # of second order
    if options.figure:
        from matplotlib.figure import Figure

        figure = Figure(figsize=(8.2, 3.6), layout="constrained")
        plane, right = figure.subplots(1, 2)
        fine, _, _ = motion(np.linspace(0, frames[-1], 500))
        plane.plot(*fine[:, :2, 3].T, "k", linewidth=0.8, label="flight")
        new = old + by_bias @ BIAS
        for label, sums, style in (("biases ignored", old, "C1x"), ("corrected by the Jacobian", new, "C0.")):
            ends = chart.pose(predicted(v[:-1], sums, 1.0))
            plane.plot(*ends[:, :2, 3].T, style, label=label)
        plane.set(xlabel="x (m)", ylabel="y (m)", ylim=(-6, 13), title="position after each second", aspect="equal")
        plane.legend(loc="upper center")
        for label, error in zip(("rotation (rad)", "position (m)", "velocity (m/s)"), np.transpose(left), strict=True):
            right.loglog(sizes, error, "o-", label=label)
        right.set(xlabel="change of the biases, in parts of the whole", title="error of a correction by the Jacobian")
        right.legend()
        figure.savefig(options.figure, metadata={"Date": None})


if __name__ == "__main__":
    main()
