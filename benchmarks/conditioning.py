"""Conditioning of vectors from poses: docs/conditioning.svg, by ``python -m benchmarks.conditioning``.

Each pose is a product of two rotations in doubles, with known angle and axis. Results of ``from_pose`` are compared
with φ(α + 2πk) u to 30 digits. Lines show the effect of a rotation error of eps: the axis moves by
``1/(2 sin(α/2))`` eps and the angle by eps, so v_k moves by ``|φ_k|/(2 sin(α/2))`` eps and ``φ_k′`` eps. Errors are
relative to |v_k| or φ′(0), whichever is larger.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import mpmath
import numpy as np

from derive.output.files import put_picture

if TYPE_CHECKING:
    from matplotlib.axes import Axes

from tests.support import kernels, sampling

FILE = Path(__file__).parents[1] / "docs" / "conditioning.svg"
DISTANCES = 10.0 ** np.linspace(-12, 0, 37)
AXES = 16
EPS = float(np.finfo(float).eps)
FLOOR = 0.1

# Colours of Okabe and Ito; markers differ as well.
PANELS = {
    "rotation angle α": [
        (3, 0, "#000000", "o"), (3, 1, "#0072B2", "s"), (5, 1, "#E69F00", "^"), (8, 3, "#009E73", "D"),
    ],
    "distance to half a turn, π − α": [
        (2, 0, "#000000", "o"), (1, 0, "#0072B2", "s"), (3, 1, "#E69F00", "^"), (5, 2, "#009E73", "D"),
    ],
}  # fmt: skip


def rotation(alpha: mpmath.mpf, axis: np.ndarray) -> mpmath.matrix:
    """Return a rotation matrix by Rodrigues' formula."""
    a, b, c = map(mpmath.mpf, axis)
    skew = mpmath.matrix([[0, -c, b], [c, 0, -a], [-b, a, 0]]) / mpmath.sqrt(a * a + b * b + c * c)
    return mpmath.eye(3) + mpmath.sin(alpha) * skew + (1 - mpmath.cos(alpha)) * skew**2


def computed_poses(alpha: mpmath.mpf, axes: np.ndarray) -> np.ndarray:
    """Return rotations by an angle about axes, as products of two rounded rotations."""
    poses = np.zeros((len(axes), 4, 4))
    poses[:, 3, 3] = 1
    for pose, axis, other in zip(poses, axes, np.roll(axes, 1, axis=0), strict=True):
        first = rotation(mpmath.mpf(1), other)
        second = first.T * rotation(alpha, axis)
        pose[:3, :3] = np.matmul(*(np.array(m.tolist(), dtype=float) for m in (first, second)))
    return poses


def relative_error(order: int, branch: int, alpha: mpmath.mpf, axes: np.ndarray) -> float:
    """Return the largest error of ``from_pose`` over all axes, in eps of `unit`."""
    size = mpmath.tan((alpha + 2 * mpmath.pi * branch) / (2 * order))
    found = kernels.load(order).from_pose(computed_poses(alpha, axes), branch)[:, :3]
    errors = []
    for v, u in zip(found, axes, strict=True):
        length = mpmath.sqrt(sum(mpmath.mpf(c) ** 2 for c in u))
        errors.append(mpmath.sqrt(sum((mpmath.mpf(a) - size * mpmath.mpf(b) / length) ** 2 for a, b in zip(v, u))))
    return float(max(errors) / unit(order, size)) / EPS


def unit(order: int, size: mpmath.mpf) -> mpmath.mpf:
    """Return the reference length for errors of v_k: |v_k| or φ′(0), whichever is larger."""
    return max(abs(size), mpmath.mpf(1) / (2 * order))


def condition(order: int, branch: int, alpha: mpmath.mpf) -> float:
    """Return the condition of v_k: its change, relative to `unit`, per change of the rotation."""
    size = mpmath.tan((alpha + 2 * mpmath.pi * branch) / (2 * order))
    moved = max((1 + size**2) / (2 * order), abs(size) / (2 * mpmath.sin(alpha / 2)))
    return float(moved / unit(order, size))


def draw(axes: Axes, label: str, angles: list[mpmath.mpf], directions: np.ndarray) -> None:
    for order, branch, colour, marker in PANELS[label]:
        errors = [max(FLOOR, relative_error(order, branch, alpha, directions)) for alpha in angles]
        near = "" if branch else " (principal)"
        axes.loglog(DISTANCES, errors, marker, color=colour, ms=4, label=f"n = {order}, k = {branch}{near}")
        axes.loglog(DISTANCES, [condition(order, branch, alpha) for alpha in angles], color=colour, lw=1)
    axes.set(xlabel=label, ylim=(FLOOR, 1e16))
    axes.grid(alpha=0.3)
    axes.legend(frameon=False)


def main() -> None:
    """Draw the figure on conditioning."""
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    from benchmarks.style import STYLE, WIDTH

    directions = sampling.unit_vectors(sampling.generator("conditioning"), (AXES,))
    labels = list(PANELS)
    with rc_context(STYLE), mpmath.workdps(30):
        figure = Figure(figsize=(WIDTH, 3.8), layout="constrained")
        left, right = figure.subplots(1, 2, sharey=True)
        draw(left, labels[0], [mpmath.mpf(d) for d in DISTANCES], directions)
        draw(right, labels[1], [mpmath.pi - mpmath.mpf(d) for d in DISTANCES], directions)
        left.set_ylabel("error of $v_k$ from a pose (eps)")
        figure.suptitle("Digits of $v_k$: measured (markers), and what eps in the rotation may do (lines)")
        put_picture(FILE, figure)


if __name__ == "__main__":
    main()
