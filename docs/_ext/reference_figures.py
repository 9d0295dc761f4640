"""Figures of the reference, drawn from values of the kernels."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib import image
from matplotlib.figure import Figure

from dualcay import unwrap as continued
from dualcay.rotation import cayley1, cayley2, cayley3, exponential

DEGREES = 180 / np.pi


def _turns(last: float) -> tuple[Any, Any]:
    """Return rotation angles above 0 up to the last one, and their rotation vectors about the z axis."""
    angles = np.linspace(0, last, 400)[1:]
    return angles, angles[:, None] * np.array([0, 0, 1.0])


def shadow(axes: Any) -> None:
    """Component of v_k along the axis for the three branches of ``cayley3``, against the angle of the rotation."""
    angles, turns = _turns(np.pi)
    v = cayley3.from_exponential(turns)
    for k in range(3):
        axes.plot(angles * DEGREES, cayley3.shadow(v, k)[:, 2], label=f"k = {k}")
    axes.set(xlabel="rotation angle (°)", ylabel="component of $v_k$", ylim=(-4, 4), xlim=(0, 180))
    axes.legend()


def tangent(axes: Any) -> None:
    """Condition number of the tangent operator of rotations against the angle: it is infinite at a loss of rank."""
    angles, turns = _turns(2 * np.pi * 0.999)
    for module in (cayley1, cayley2, cayley3, exponential):
        reached = angles < module.singular_angles()[0] * 0.999
        condition = np.linalg.cond(module.tangent(module.from_exponential(turns[reached])))
        axes.semilogy(angles[reached] * DEGREES, condition, label=module.__name__.rpartition(".")[2])
    axes.set(xlabel="rotation angle (°)", ylabel="condition number of $T$", xlim=(0, 360), ylim=(0.8, 300))
    axes.legend()


def unwrap(axes: Any) -> None:
    """Recorded rotation vectors of a steady turn jump at half a turn; ``unwrap`` chooses branches that continue."""
    angles, turns = _turns(4 * np.pi)
    recorded = exponential.principal(turns[::8])
    axes.plot(angles[::8] * DEGREES, recorded[:, 2], ".", label="recorded")
    axes.plot(angles[::8] * DEGREES, np.array(continued(exponential, recorded))[:, 2], label="unwrapped")
    axes.set(xlabel="angle turned (°)", ylabel="component (rad)", xlim=(0, 720))
    axes.legend()


FIGURES: Mapping[str, Callable[[Any], None]] = {
    "shadow": shadow, "principal": shadow, "tangent": tangent, "tangent_inv": tangent, "unwrap": unwrap,
}  # fmt: skip
"""Figure of a function, by the function's name."""


GAP, PANEL = 5, 0.3
"""Width of the ground between two panels in pixels at least, and share of a panel in the picture at least."""


def first_panel(picture: Any) -> Any:
    """Return the part of a picture before its first gap: the left panel, or the upper one of a column.

    Examples
    --------
    >>> picture = np.zeros((40, 100, 3))
    >>> picture[:, 45:55] = 1  # white ground between two panels
    >>> first_panel(picture).shape
    (40, 45, 3)
    """
    white = (picture[..., :3] > 0.99).all(-1) | (picture[..., 3:] < 0.01).any(-1)
    for axis in (1, 0):
        empty = white.all(1 - axis)
        size = len(empty)
        for end in range(int(PANEL * size), size - int(PANEL * size)):
            if empty[end : end + GAP].all():
                return picture[:, :end] if axis else picture[:end]
    return picture


def draw(folder: Path) -> None:
    """Write every figure into a folder, and a thumbnail of each example."""
    for path in sorted((folder.parents[1] / "figures").glob("*.png")):
        image.imsave(folder / f"thumbnail_{path.name}", first_panel(image.imread(path)))
    with matplotlib.rc_context({"svg.hashsalt": "dualcay", "svg.fonttype": "path"}):
        for function in set(FIGURES.values()):
            figure = Figure(figsize=(6, 3), layout="constrained")
            axes = figure.subplots()
            axes.grid(alpha=0.3)
            function(axes)
            figure.savefig(folder / f"figure_{function.__name__}.svg", metadata={"Date": None})
