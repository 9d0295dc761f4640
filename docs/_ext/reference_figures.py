"""Figures of the reference, drawn from values of the kernels."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.figure import Figure

from derive.output.files import put, put_picture
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


PANEL = re.compile(r'<g id="axes_\d+">\s*(?:<g id="patch_\d+">\s*<path d="(.*?)")?', re.DOTALL)
SIZE = re.compile(r'<svg (.*?)width="[^"]*" height="[^"]*" viewBox="0 0 (\S+) ([^"]+)"')
MARGIN, LABELS = 6.0, 48.0
"""Ground beyond the edge of a panel, and room for the labels at the left of a panel, in points."""


def first_panel(picture: str) -> str:
    """Return a picture of Matplotlib cut at the edge of its first panel, the left one or the upper one.

    Examples
    --------
    >>> panel = '<g id="axes_{0}"><g id="patch_{0}"><path d="M {1} 90 L {2} 90 L {2} 10 z"/></g></g>'
    >>> head = '<svg width="200pt" height="100pt" viewBox="0 0 200 100">'
    >>> first_panel(head + panel.format(1, 10, 90) + panel.format(2, 110, 190) + "</svg>").partition(">")[0]
    '<svg width="96pt" height="100pt" viewBox="0 0 96 100"'
    """
    numbers = [list(map(float, re.findall(r"-?\d+\.?\d*", path))) for path in PANEL.findall(picture)[:2]]
    size = SIZE.search(picture)
    assert size is not None
    width, height = map(float, size.group(2, 3))
    if len(numbers) > 1:
        first, second = numbers
        if not first:  # a panel in space has no box
            width = min(second[::2]) - LABELS
        elif min(second[::2]) > max(first[::2]):
            width = max(first[::2]) + MARGIN
        else:
            height = max(first[1::2]) + MARGIN
    cut = f'width="{width:g}pt" height="{height:g}pt" viewBox="0 0 {width:g} {height:g}"'
    return SIZE.sub(lambda found: f"<svg {found[1]}{cut}", picture, count=1)


def draw(folder: Path) -> None:
    """Write every figure into a folder, and a thumbnail of each example."""
    for path in sorted((folder.parents[1] / "figures").glob("*.svg")):
        cut = first_panel(path.read_text(encoding="utf-8"))
        put(folder / f"thumbnail_{path.name}", cut)
    with matplotlib.rc_context({"svg.hashsalt": "dualcay", "svg.fonttype": "path"}):
        for function in set(FIGURES.values()):
            figure = Figure(figsize=(6, 3), layout="constrained")
            axes = figure.subplots()
            axes.grid(alpha=0.3)
            function(axes)
            put_picture(folder / f"figure_{function.__name__}.svg", figure)
