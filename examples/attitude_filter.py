"""A Kalman filter by modified Rodrigues parameters
================================================

Run ``python examples/attitude_filter.py [--figure FILE]``.

A spacecraft tumbles without torque. A gyro with a drifting bias is read each second, a star tracker every 20. The state
is the MRP vector σ = tan(α/4) u and the bias. After each step with ‖σ‖ > 1, σ is switched to its shadow. The covariance
must follow: P becomes J P Jᵀ, with J = ∂σˢ/∂σ = 2 σσᵀ/‖σ‖⁴ − I/‖σ‖² for σ and I for the bias.

Three filters see the same data. One uses J, one leaves P as it is, as some flight software does, and one uses
2 ‖σ‖⁴ σσᵀ − ‖σ‖² I, a formula in use that is J at ‖σ‖ = 1 only; here ‖σ‖ is up to 1.18 before a switch. The normalized
squared error (NEES) of the six states, eᵀ P⁻¹ e, has the mean 6 if a filter knows its own errors.

.. image:: /figures/attitude_filter.svg
"""

# sphinx_gallery_thumbnail_path = 'reference/generated/thumbnail_attitude_filter.svg'

import argparse
from collections.abc import Callable, Sequence

import numpy as np
from scipy.stats import chi2

from dualcay.rotation import cayley2 as mrp

STARS, SETTLED = 20, 100  # steps of a second: between readings of the star tracker; until errors are averaged
GYRO, DRIFT, STAR, BIAS = 1e-4, 1e-6, 1e-3, 1e-3  # noise: rad/√s, rad/s/√s, rad; bias at the start: rad/s
INERTIA, SPIN = np.array([1.0, 1.6, 2.1]), np.array([0.05, 0.3, 0.08])  # kg m², rad/s
UNIT = np.eye(3)
TRANSPORTS = {
    "J P Jᵀ": lambda s: mrp.shadow_jacobian(s[..., 0]),  # s is σ as a column
    "P left as it is": lambda s: UNIT,
    "2|σ|⁴ σσᵀ − |σ|² I": lambda s: 2 * (s.mT @ s) ** 2 * (s @ s.mT) - s.mT @ s * UNIT,
}


def congruent(A: np.ndarray, P: np.ndarray) -> np.ndarray:
    """Return A P Aᵀ."""
    return A @ P @ A.mT


def blocks(A: np.ndarray, B: np.ndarray | float, D: np.ndarray | float) -> np.ndarray:
    """Return the matrices [[A, B], [0, D]] of σ and bias."""
    found = np.zeros((len(A), 6, 6))
    found[:, :3, :3], found[:, :3, 3:], found[:, 3:, 3:] = A, B, D
    return found


def simulate(runs: int, steps: int, seed: int = 1) -> tuple[np.ndarray, ...]:
    """Return σ, bias, gyro and σ of the star tracker by step and run; the turn of a step has a fixed axis."""
    rng = np.random.default_rng(seed)
    sigma, bias = [mrp.random((runs,), rng=rng)], [BIAS * rng.normal(size=(runs, 3))]
    omega, gyro = SPIN, []
    for _ in range(steps):
        gyro.append(omega + bias[-1] + GYRO * rng.normal(size=(runs, 3)))
        sigma.append(mrp.principal(mrp.body_retract(sigma[-1], omega)))
        bias.append(bias[-1] + DRIFT * rng.normal(size=(runs, 3)))
        middle = omega + np.cross(INERTIA * omega, omega) / INERTIA / 2  # Euler's equation, midpoint rule
        omega = omega + np.cross(INERTIA * middle, middle) / INERTIA
    truth = np.array(sigma)
    return truth, np.array(bias), np.array(gyro), mrp.body_retract(truth, STAR * rng.normal(size=truth.shape))


def estimate(data: Sequence[np.ndarray], transport: Callable[[np.ndarray], np.ndarray]) -> tuple[np.ndarray, ...]:
    """Return |σ|, errors of attitude (rad, body frame) and bias, their covariance and NEES, by step and run."""
    truth, biases, readings, stars = data
    sigma, bias, found = stars[0], np.zeros_like(biases[0]), []
    P = blocks(congruent(mrp.body_tangent_inv(sigma), STAR**2 * UNIT), 0, BIAS**2 * UNIT)
    for k, gyro in enumerate(readings, start=1):
        by_sigma, by_turn = mrp.body_retract_jacobians(sigma, gyro - bias)
        P = congruent(blocks(by_sigma, -by_turn, UNIT), P)
        P += blocks(congruent(by_turn, GYRO**2 * UNIT), 0, DRIFT**2 * UNIT)
        sigma = mrp.body_retract(sigma, gyro - bias)
        column = sigma[..., None]
        square, sigma = column.mT @ column, mrp.principal(sigma)
        P = congruent(blocks(np.where(square > 1, transport(column), UNIT), 0, UNIT), P)
        if k % STARS == 0:
            H = np.concatenate([mrp.body_tangent(sigma), np.zeros_like(by_turn)], axis=-1)
            gain = np.linalg.solve(congruent(H, P) + STAR**2 * UNIT, H @ P).mT
            change = (gain @ mrp.body_local(stars[k], sigma)[..., None])[..., 0]
            P = congruent(np.eye(6) - gain @ H, P) + congruent(gain, STAR**2 * UNIT)
            sigma, bias = sigma + change[:, :3], bias + change[:, 3:]
        error = np.concatenate([mrp.body_local(truth[k], sigma), biases[k] - bias], axis=-1)
        bounds = congruent(blocks(mrp.body_tangent(sigma), 0, UNIT), P)
        nees = np.sum(error * np.linalg.solve(bounds, error[..., None])[..., 0], axis=-1)
        found.append((np.sqrt(square[:, 0, 0]), error, bounds, nees))
    return tuple(map(np.array, zip(*found)))


def main(argv: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description="Attitude filter by modified Rodrigues parameters")
    parser.add_argument("--runs", type=int, default=100, help="number of runs")
    parser.add_argument("--steps", type=int, default=600, help="number of steps of a second")
    parser.add_argument("--figure", help="file for the picture")
    options = parser.parse_args(argv)
    data = simulate(options.runs, options.steps)
    found = {name: estimate(data, transport) for name, transport in TRANSPORTS.items()}
    low, high = chi2.ppf((0.025, 0.975), 6 * options.runs) / options.runs
    sizes = found["J P Jᵀ"][0]
    print(f"{options.runs} runs with {(sizes > 1).sum(axis=0).mean():.1f} switches each")
    print(f"covariance at a switch   mean NEES   times from {low:.2f} to {high:.2f}   attitude error")
    for name, (_, error, _, nees) in found.items():
        mean, angle = nees[SETTLED:].mean(axis=1), np.degrees(np.linalg.norm(error[SETTLED:, :, :3], axis=-1))
        print(f"{name:22} {mean.mean():11.2f} {np.mean((low < mean) & (mean < high)):22.0%} {angle.mean():16.4f} deg")
        assert low < mean.mean() < high if name == "J P Jᵀ" else mean.mean() > 2 * high
    if options.figure:
        from matplotlib.figure import Figure

        figure = Figure(figsize=(8.2, 6), layout="constrained")
        top, middle, last = figure.subplots(3, 1, sharex=True)
        times = np.arange(1, options.steps + 1)
        top.plot(times, sizes[:, 0])
        top.vlines(times[sizes[:, 0] > 1], 0, 1.2, "C7", ":", linewidth=1)
        for (name, (_, error, P, nees)), color in zip(found.items(), ("C0", "C3", "C1")):
            middle.plot(times, np.degrees(error[:, 0, 0]), color)
            middle.plot(times, np.outer(np.degrees(np.sqrt(P[:, 0, 0, 0])), (-3, 3)), color, linestyle=":", linewidth=1)
            last.semilogy(times, nees.mean(axis=1), color, label=name)
        last.axhspan(low, high, color="C0", alpha=0.2)
        top.set_ylabel("|σ| and switches")
        middle.set(ylabel="error about x, ±3σ (deg)", ylim=(-1, 1))
        last.set(xlabel="time (s)", ylabel=f"mean NEES of {options.runs} runs")
        last.legend()
        figure.savefig(options.figure, metadata={"Date": None})


if __name__ == "__main__":
    main()
