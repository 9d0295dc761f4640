"""Two spacecraft meet
===================

Run ``python examples/rendezvous.py [--figure FILE]``.

A target turns slowly about its own axis. A chaser approaches it under a controller of the whole pose: an acceleration
proportional to v, the vector of its pose in the frame of the target, and to its twist there. The target's own motion is
cancelled by feed-forward. At v = 0 the two are docked.

On the way the chaser knows its pose from its start and from the twist that it measures, with noise. `propagate`
integrates pose and covariance along the twist in the frame of the body. Random runs with the same noise check it.

.. image:: /figures/rendezvous.svg
"""

# sphinx_gallery_thumbnail_path = 'reference/generated/thumbnail_rendezvous.svg'

import argparse
from collections.abc import Sequence
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from dualcay import cayley2 as chart
from dualcay import matrix6, plot, propagate

START = np.array([0.15, 0.8, -0.3, 1.7, -3, 1.2])  # v of the chaser at the start: tan(α/4) u, a turn by 164 degrees
TURNING = np.array([0.0, 0, 0.02, 0, 0, 0])  # twist of the target in its own frame, rad/s
STIFFNESS, DAMPING = 4 * 0.01, 0.2  # 1/s², times 4 because v is a quarter of angle and distance; 1/s
DEVIATION = np.array([0.01, 0.01, 0.01, 0.05, 0.05, 0.05])  # of the pose at the start: rad, m
NOISE = np.array([1e-3, 1e-3, 1e-3, 3e-3, 3e-3, 3e-3])  # of the measured twist: rad/√s, m/√s
END, STEPS = 90.0, 360  # s


def closed_loop(t: float, y: np.ndarray) -> np.ndarray:
    """Return the derivatives of the relative v and its body twist."""
    return np.concatenate([chart.body_rate(y[:6], y[6:]), -STIFFNESS * y[:6] - DAMPING * y[6:]])


def approach() -> Any:
    """Return the relative v and twist of the body as a function of time."""
    at_start = -chart.adjoint(chart.inverse(START)) @ TURNING  # the chaser is at rest, the target turns
    exactly = {"method": "DOP853", "rtol": 1e-10, "atol": 1e-12, "dense_output": True}
    return solve_ivp(closed_loop, (0, END), [*START, *at_start], **exactly).sol


def random_runs(path: Any, runs: int, seed: int = 1) -> np.ndarray:
    """Return v of random runs at the end of each step; a step has a constant twist and its integrated noise."""
    rng, h = np.random.default_rng(seed), END / STEPS
    v, found = chart.body_retract(START, DEVIATION * rng.normal(size=(runs, 6))), []
    for k in range(STEPS):
        noise = np.sqrt(h) * NOISE * rng.normal(size=(runs, 6))
        v = chart.body_retract(v, h * path((k + 0.5) * h)[6:] + noise)
        found.append(v)
    return np.array(found)


def of_position(v: np.ndarray, P: np.ndarray) -> np.ndarray:
    """Return the covariance of the chaser's position in the frame of the target."""
    by_v, _ = chart.transform_point_jacobians(v, np.zeros(3))
    return by_v @ P @ by_v.mT


def nees(v: np.ndarray, P: np.ndarray, runs: np.ndarray) -> np.ndarray:
    """Return the mean of eᵀ P⁻¹ e over random runs: 6 if P is their covariance."""
    apart = (matrix6(chart.body_tangent_inv(v))[:, None] @ chart.body_local(runs, v[:, None])[..., None])[..., 0]
    return np.mean(np.sum(apart * np.linalg.solve(P[:, None], apart[..., None])[..., 0], axis=-1), axis=-1)


def main(argv: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description="Rendezvous of two spacecraft")
    parser.add_argument("--runs", type=int, default=5000, help="number of random runs")
    parser.add_argument("--figure", help="file for the picture")
    options = parser.parse_args(argv)
    path, t = approach(), np.linspace(0, END, STEPS + 1)
    _, by_step = chart.body_retract_jacobians(START, np.zeros(6))
    start = by_step @ np.diag(DEVIATION**2) @ by_step.T
    noise = np.diag(NOISE**2)
    motion = propagate(chart, START, lambda t: path(t)[6:], t, frame="body", covariance=start, noise=noise)
    runs = random_runs(path, options.runs)
    drawn = np.std(chart.pose(runs)[..., :3, 3], axis=1)
    known = np.sqrt(np.diagonal(of_position(motion.v, motion.covariance), axis1=-2, axis2=-1))
    consistent = nees(motion.v[1:], motion.covariance[1:], runs)
    chaser = path(t)[6:].T + (chart.adjoint(chart.inverse(motion.v)) @ TURNING)
    apart = np.abs(motion.v - path(t)[:6].T).max()
    print(f"propagate differs from the controller's own integration by {apart:.1e}")
    assert apart < 1e-8
    print(f"largest angular velocity of the chaser: {np.linalg.norm(chaser[:, :3], axis=-1).max():.3f} rad/s")
    print("time    angle       distance    deviations of position: propagate      random runs         NEES")
    for k in range(STEPS // 6, STEPS + 1, STEPS // 6):
        angle, distance = np.degrees(chart.angle(motion.v[k])[0]), np.linalg.norm(motion.pose[k, :3, 3])
        print(f"{t[k]:3.0f} s {angle:8.2f} deg {distance:8.3f} m", end="   ")
        print(*(np.array2string(x, precision=4, floatmode="fixed") for x in (known[k], drawn[k - 1])), end="")
        print(f"{consistent[k - 1]:8.2f}")
    # the slower root of s² + 0.2 s + 0.01 is −0.1 1/s: (1 + 9) e⁻⁹ of the start, and small terms beyond the first order
    assert np.linalg.norm(motion.v[-1]) < 2 * 10 * np.exp(-9) * np.linalg.norm(START)
    # the mean of χ² of 6 over independent runs, within four deviations and 2 % for the second order
    assert np.all(np.abs(consistent - 6) < 4 * np.sqrt(12 / options.runs) + 0.12)
    if options.figure:
        from matplotlib.figure import Figure

        figure = Figure(figsize=(8.2, 3.6), layout="constrained")
        left, right = figure.subplots(1, 2, width_ratios=(3, 2))
        places = chart.pose(runs)[..., :3, 3]
        some = np.arange(STEPS // 18, STEPS, STEPS // 9)
        left.plot(*places[some - 1, :300, 1::-1].reshape(-1, 2).T, ".", color="C7", markersize=1, rasterized=True)
        spread = of_position(motion.v[some], motion.covariance[some])
        plot.ellipsoids(motion.pose[some, :3, 3], spread, left, plane="yx", color="C1", linewidth=1.6)
        plot.trajectory(motion, left, plane="yx", color="C0")
        left.set(xlabel="y in the frame of the target (m), 3σ ellipses and random runs", ylabel="x (m)")
        for i, name in enumerate("xyz"):
            right.plot(t, 1e3 * known[:, i], color=f"C{i}", label=f"{name}, propagate")
            right.plot(t[10::10], 1e3 * drawn[9::10, i], ".", color=f"C{i}")
        right.set(xlabel="time (s)", ylabel="deviation of position (mm)")
        right.legend()
        figure.savefig(options.figure, metadata={"Date": None})


if __name__ == "__main__":
    main()
