"""Camera path with a smooth acceleration
======================================

Run ``python examples/camera_path.py [--rate HZ] [--figure FILE]``.

A camera flies by ten key frames, from rest to rest. Screws from frame to frame are continuous, but the angular velocity
jumps at each frame: a drive cannot follow, and the picture jerks. `PoseSpline` passes the frames with continuous
velocity and acceleration. `RotationSpline` of SciPy does so too, for the rotations alone.

Then the camera records its own path, with noise. `PoseSpline.fit` finds the path again by least squares.

.. image:: /figures/camera_path.svg
"""

# sphinx_gallery_thumbnail_path = 'reference/generated/thumbnail_camera_path.svg'

import argparse
from collections.abc import Sequence

import numpy as np
from scipy.spatial.transform import Rotation, RotationSpline

from dualcay import PoseSpline, cayley2, exponential, plot

FRAMES, DURATION = 10, 9.0  # s
NOISE = np.repeat([0.01, 0.02], 3)  # rad, m


def frames(t: np.ndarray) -> np.ndarray:
    """Return key frames of a camera on a loop, which looks ahead and sways."""
    angle = 2 * np.pi * t / DURATION
    sway = 0.3 * np.sin(2.5 * angle)
    poses = exponential.pose(np.outer(angle, np.eye(6)[2])) @ exponential.pose(np.outer(sway, np.eye(6)[0]))
    poses[:, :3, 3] = np.stack([4 * np.sin(angle), 2 - 2 * np.cos(angle), 1 + 0.5 * np.cos(3 * angle)], axis=-1)
    return poses


def main(argv: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description="Camera path with a smooth acceleration")
    parser.add_argument("--rate", type=float, default=50, help="recorded poses per second")
    parser.add_argument("--figure", help="file for the picture")
    options = parser.parse_args(argv)
    times = np.linspace(0, DURATION, FRAMES)
    key = frames(times)
    key_v = exponential.from_pose(key)
    path = PoseSpline(cayley2, times, key, boundary="clamped")
    rotations = RotationSpline(times, Rotation.from_matrix(key[:, :3, :3]))
    t = np.linspace(0, DURATION, 1801)
    accelerations = {
        "PoseSpline, from rest to rest": path.acceleration(t)[:, :3],
        "PoseSpline, natural": PoseSpline(cayley2, times, key).acceleration(t)[:, :3],
        "RotationSpline of SciPy": rotations(t, 2),
    }
    sizes = {name: np.linalg.norm(values, axis=-1) for name, values in accelerations.items()}
    print("largest angular acceleration (rad/s²)")
    for name, size in sizes.items():
        print(f"{name:30} {size.max():6.2f}")
    screws = exponential.local(key_v[1:], key_v[:-1]) / np.diff(times)[:, None]
    jerk = np.linalg.norm(np.diff(screws[:, :3], axis=0), axis=-1).max()
    print(f"screws from frame to frame: angular velocity jumps by up to {jerk:.2f} rad/s")
    assert jerk > 0.5
    jump = np.abs(path.acceleration(times[1:-1]) - path.acceleration(np.nextafter(times[1:-1], 0))).max()
    assert np.abs(path.pose(times) - key).max() < 1e-12
    assert np.abs(path.twist(times[[0, -1]])).max() < 1e-12
    assert jump < 1e-11

    recorded = np.linspace(0, DURATION, round(DURATION * options.rate) + 1)
    noise = NOISE * np.random.default_rng(1).normal(size=(len(recorded), 6))
    noisy = cayley2.body_retract(path(recorded), noise)
    fitted = PoseSpline.fit(cayley2, recorded, noisy, times, weights=np.tile(1 / NOISE**2, (len(recorded), 1)))
    apart = cayley2.body_local(fitted(t), path(t)) / NOISE
    error = np.sqrt(np.mean(apart**2))
    print(f"fit to {len(recorded)} noisy poses: error {error:.2f} of the noise")
    # 12 control poses share the noise of all: √(12/N) of it, within a third
    assert 0.6 < error / np.sqrt((FRAMES + 2) / len(recorded)) < 1.4
    if options.figure:
        picture(options.figure, times, key, path, sizes)


def picture(file: str, times: np.ndarray, key: np.ndarray, path: PoseSpline, sizes: dict[str, np.ndarray]) -> None:
    """Draw the path from above with its frames, and the angular accelerations."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8.2, 4), layout="constrained")
    left, right = figure.subplots(1, 2)
    t = np.linspace(0, DURATION, 1801)
    plot.trajectory(path.pose(t), left, label="spline")
    left.plot(*key[:, :2, 3].T, "o", markersize=5, label="key frames")
    plot.frames(path.pose(t[::60]), left, length=0.5, linewidth=1.2)
    left.set(xlabel="x (m)", ylabel="y (m)")
    left.legend(loc="center")
    for name, size in sizes.items():
        right.plot(t, size, label=name)
    right.plot(times, 0 * times, "o", markersize=5, color="C1")
    right.set(
        xlabel="time (s)", ylabel="angular acceleration (rad/s²)", ylim=(-0.2, 1.35 * max(map(max, sizes.values())))
    )
    right.legend(loc="upper right")
    figure.savefig(file, metadata={"Date": None})


if __name__ == "__main__":
    main()
