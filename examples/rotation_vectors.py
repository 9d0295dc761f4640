"""Rotation vectors that jump at half a turn
=========================================

Run ``python examples/rotation_vectors.py [--rate HZ] [--figure FILE]``.

Data sets of robots record poses as position and rotation vector, by a logarithm that returns angles up to π. A gripper
that points down stays near π: there the vectors w and (1 − 2π/‖w‖) w are one rotation, and a record jumps between
the two whenever the angle passes π. Interpolation from number to number, as in resampling or a learned policy, then
sweeps the gripper through a whole turn.

`unwrap` chooses the branch that continues the sequence. The vectors may be interpolated after that, as any numbers;
`interpolate` follows the screw from pose to pose and needs no unwrapping.

.. image:: /figures/rotation_vectors.svg
"""

# sphinx_gallery_thumbnail_path = 'reference/generated/thumbnail_rotation_vectors.svg'

import argparse
from collections.abc import Sequence

import numpy as np

from dualcay import exponential, unwrap

DOWN = np.array([np.pi, 0, 0, 0, 0, 0])  # the gripper points down
DURATION = 8.0  # s


def gripper(t: np.ndarray) -> np.ndarray:
    """Return the poses of a gripper that looks around while it moves: dual rotation vectors, angle up to π."""
    wave = np.stack([np.sin(1.3 * t), np.sin(0.9 * t + 1), np.sin(0.7 * t + 2)], axis=-1)
    swing = np.concatenate([[0.5, 0.3, 0.8] * wave, [0.1, 0.2, 0.1] * wave[:, ::-1]], axis=-1)  # rad, m
    return exponential.compose(swing, DOWN)


def numbers(t: np.ndarray, times: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Interpolate each component on its own."""
    return np.stack([np.interp(t, times, component) for component in v.T], axis=-1)


def screws(t: np.ndarray, times: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Interpolate by the screw between neighbouring poses."""
    i = np.clip(np.searchsorted(times, t, side="right") - 1, 0, len(times) - 2)
    return exponential.interpolate(v[i], v[i + 1], (t - times[i]) / (times[i + 1] - times[i]))


def errors(found: np.ndarray, truth: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the angle in degrees and the distance in millimetres between poses."""
    apart = exponential.principal(exponential.between(found, truth))
    distance = exponential.pose(found)[:, :3, 3] - exponential.pose(truth)[:, :3, 3]
    return np.degrees(np.linalg.norm(apart[:, :3], axis=-1)), 1e3 * np.linalg.norm(distance, axis=-1)


def main(argv: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description="Rotation vectors that jump at half a turn")
    parser.add_argument("--rate", type=float, default=10, help="recorded poses per second")
    parser.add_argument("--figure", help="file for the picture")
    options = parser.parse_args(argv)
    times = np.linspace(0, DURATION, round(DURATION * options.rate) + 1)
    recorded = gripper(times)
    continuous, branch = unwrap(exponential, recorded, branch=True)
    jumps = np.count_nonzero(np.linalg.norm(np.diff(recorded[:, :3], axis=0), axis=-1) > np.pi)
    print(f"{len(times)} poses, {jumps} jumps; branches after unwrap: {', '.join(map(str, np.unique(branch)))}")
    assert jumps
    assert np.linalg.norm(np.diff(continuous[:, :3], axis=0), axis=-1).max() < 3 / options.rate
    assert np.abs(exponential.pose(continuous) - exponential.pose(recorded)).max() < 1e-13
    t = np.linspace(0, DURATION, 4001)
    truth = gripper(t)
    found = {
        "numbers as recorded": numbers(t, times, recorded),
        "numbers after unwrap": numbers(t, times, continuous),
        "screws": screws(t, times, recorded),
    }
    print("interpolated           largest error   position")
    angles = {}
    for name, v in found.items():
        angles[name], distance = errors(v, truth)
        print(f"{name:21} {angles[name].max():10.2f} deg {distance.max():7.2f} mm")
        # of second order in the time between poses; through a whole turn where a record jumps
        assert angles[name].max() > 90 if name == "numbers as recorded" else angles[name].max() < 9.5 / options.rate**2
    if options.figure:
        picture(options.figure, times, recorded, continuous, t, angles)


def picture(
    file: str,
    times: np.ndarray,
    recorded: np.ndarray,
    continuous: np.ndarray,
    t: np.ndarray,
    angles: dict[str, np.ndarray],
) -> None:
    """Draw the rotation vectors before and after unwrapping, and the errors of interpolation."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8.2, 4), layout="constrained")
    left, right = figure.subplots(1, 2)
    for i, name in enumerate("xyz"):
        left.plot(times, recorded[:, i], ".", color=f"C{i}", markersize=4, label=f"{name}, recorded")
        left.plot(times, continuous[:, i], color=f"C{i}", linewidth=1, label=f"{name}, after unwrap")
    left.set(xlabel="time (s)", ylabel="rotation vector (rad)", ylim=(-4.6, 8))
    left.legend(ncols=2, loc="upper center")
    for name, error in angles.items():
        right.semilogy(t, np.maximum(error, 1e-4), label=name)
    right.set(xlabel="time (s)", ylabel="error of interpolated rotation (deg)", ylim=(1e-3, 1e4))
    right.legend(loc="upper right")
    figure.savefig(file, metadata={"Date": None})


if __name__ == "__main__":
    main()
