"""A cloud of poses
================

Run ``python examples/pose_cloud.py [--runs N] [--steps N] [--figure FILE]``.

A robot drives a curve by odometry, and each step has a small error of heading and way. Where may it be at the end?
Errors of heading bend the cloud of its positions like a banana, which no ellipse of positions fits. In steps from the
mean pose the same cloud is an ellipsoid, and the exponential bends its ellipses.

`compose_covariance` predicts the covariance step by step, without a draw. `mean` finds that of drawn poses. To first
order in the errors both agree; here the heading is off by 0.4 rad, and 88 % of the poses lie in the region of 90 %.

.. image:: /figures/pose_cloud.svg
"""

# sphinx_gallery_thumbnail_path = 'reference/generated/thumbnail_pose_cloud.svg'

import argparse
from collections.abc import Sequence

import numpy as np

from dualcay import cayley2 as chart
from dualcay import compose_covariance, mean, plot, transform_point_covariance

STEP = np.array([0, 0, 0.01, 0.1, 0, 0])  # rad, m: to the left, forwards
NOISE = np.diag([0.005, 0.005, 0.05, 0.03, 0.03, 0.005]) ** 2  # rad², m²
SHARE, STEPS_WITHIN, PLACE_WITHIN = 0.9, 10.645, 6.251  # χ² of 6 and of 3 components has this share below


def predicted(steps: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the poses without error, and covariances of the steps from them in the body."""
    move = chart.body_retract(chart.identity(), STEP)
    v, P = [chart.identity()], [np.zeros((6, 6))]
    for _ in range(steps):
        P.append(compose_covariance(chart, v[-1], move, P[-1], NOISE))
        v.append(chart.compose(v[-1], move))
    return np.array(v), np.array(P)


def driven(runs: int, steps: int) -> np.ndarray:
    """Return the poses at the end of drives with errors."""
    rng, v = np.random.default_rng(0), np.zeros((runs, 6))
    for _ in range(steps):
        move = STEP + rng.multivariate_normal(np.zeros(6), NOISE, runs)
        v = chart.body_retract(v, move)
    return v


def positions(v: np.ndarray) -> np.ndarray:
    return chart.transform_point(v, np.zeros(3))


def distances(residual: np.ndarray, P: np.ndarray) -> np.ndarray:
    """Return rᵀ P⁻¹ r of each residual."""
    return np.einsum("ki,ki->k", residual, np.linalg.solve(P, residual.T).T)


def main(argv: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description="A cloud of poses")
    parser.add_argument("--runs", type=int, default=4000, help="drives with errors")
    parser.add_argument("--steps", type=int, default=60, help="steps of a drive")
    parser.add_argument("--figure", help="file for the picture")
    options = parser.parse_args(argv)
    v, P = predicted(options.steps)
    cloud = driven(options.runs, options.steps)
    m, found = mean(chart, cloud, covariance=True)
    place = transform_point_covariance(chart, v[-1], np.zeros(3), P[-1])
    names = ("roll", "pitch", "yaw", "forwards", "sideways", "up")
    print("deviation   predicted   drawn (rad, m)")
    for name, one, other in zip(names, *(np.sqrt(np.diag(S)) for S in (P[-1], found)), strict=True):
        print(f"{name:9} {one:11.3f} {other:7.3f}")
    within = np.mean(distances(chart.body_local(cloud, v[-1]), P[-1]) < STEPS_WITHIN)
    flat = np.mean(distances(positions(cloud) - positions(v[-1]), place) < PLACE_WITHIN)
    print(f"within the region of {SHARE:.0%}: {within:.1%} of the poses, {flat:.1%} of the positions in an ellipsoid")
    # five deviations of a mean and of a share, and a quarter of the heading's variance for what the first order omits
    omitted = P[-1, 2, 2] / 4
    off = abs(chart.body_local(m, v[-1])) / np.sqrt(np.diag(P[-1]))
    assert (off < 5 / np.sqrt(options.runs) + omitted).all()
    assert abs(within - SHARE) < 5 * np.sqrt(SHARE * (1 - SHARE) / options.runs) + omitted
    if options.figure:
        picture(options.figure, v, P, cloud, m, found)


def outline(P: np.ndarray, factor: float) -> np.ndarray:
    """Return steps around the ellipse of the two largest deviations."""
    sizes, axes = np.linalg.eigh(P)
    turn = np.linspace(0, 2 * np.pi, 200)[:, None]
    a, b = (axes[:, i] * np.sqrt(sizes[i] * factor) for i in (-1, -2))
    return np.cos(turn) * a + np.sin(turn) * b


def picture(file: str, v: np.ndarray, P: np.ndarray, cloud: np.ndarray, m: np.ndarray, found: np.ndarray) -> None:
    """Draw positions from above, and steps from the mean, each with its ellipses."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8.2, 4), layout="constrained")
    left, right = figure.subplots(1, 2)
    way = positions(v)
    left.plot(*way[:, :2].T, color="C7", linewidth=1, label="drive without error")
    left.plot(*positions(cloud)[:700, :2].T, ".", color="C0", markersize=2, label="ends of drives")
    place = transform_point_covariance(chart, v[-1], np.zeros(3), P[-1])
    style = {"color": "C1", "linewidth": 1.6, "label": "ellipse of positions"}
    plot.ellipsoids(way[-1], place, left, deviations=4.605**0.5, **style)
    left.plot(*positions(chart.body_retract(m, outline(found, 4.605)))[:, :2].T, color="C3", label="ellipse of steps")
    left.plot(*positions(m)[:2], "k+", markersize=10, label="mean")
    left.set(xlabel="x (m)", ylabel="y (m)")
    steps = chart.body_local(cloud, m)[:, [2, 4]]
    right.plot(*steps[:700].T, ".", color="C0", markersize=2)
    right.plot(*outline(found[np.ix_([2, 4], [2, 4])], 4.605).T, color="C3")
    right.set(xlabel="step from the mean: yaw (rad)", ylabel="step from the mean: sideways (m)")
    figure.legend(*left.get_legend_handles_labels(), loc="outside upper center", ncols=5)
    figure.savefig(file, metadata={"Date": None})


if __name__ == "__main__":
    main()
