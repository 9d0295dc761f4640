"""Plot of docs/benchmarks.md: time of ``pose`` against the number of poses in a call."""

from __future__ import annotations

from pathlib import Path

from benchmarks.maps import COMPILED, COPY, NUMPY, PART
from benchmarks.peers import load
from benchmarks.times import CHARTS, ROOT, Data, label
from derive.output.files import put_picture

FILE = ROOT / "docs" / "benchmarks.svg"
BLUE, RED = "#2F81C4", "#D5601A"
LOOKS = {
    **{(NUMPY, chart): (BLUE, style, "o") for chart, style in zip(CHARTS, ("-", "--"), strict=True)},
    **{(COMPILED, chart): (RED, style, "^") for chart, style in zip(CHARTS, ("-", "--"), strict=True)},
    ("SciPy", ""): ("#B58A12", ":", "v"), ("pytransform3d", ""): ("#8C6A4F", ":", "P"),
    ("jaxlie", ""): ("#C26A9B", ":", "X"), ("pinocchio", ""): ("#1F9E73", ":", "d"), (COPY, ""): ("#808890", "-", ""),
}  # fmt: skip
"""Colour, line style and marker by who makes the call and chart; lines of other libraries are dotted."""

NAMES = {
    "jaxlie": "jaxlie, jitted", "pinocchio": "pinocchio, pose by pose", NUMPY: "dualcay, NumPy",
    COMPILED: "dualcay, compiled",
}  # fmt: skip


def draw(data: Data, path: Path = FILE) -> None:
    """Draw the picture, if matplotlib is installed."""
    figure = load("matplotlib.figure")
    if figure is None:
        return
    from matplotlib import rc_context

    from benchmarks.style import STYLE, WIDTH

    with rc_context(STYLE):
        made = figure.Figure(figsize=(WIDTH, 3.8), layout="constrained")
        axes = made.subplots()
        for (by, chart), (colour, style, mark) in LOOKS.items():
            ns = data.ns(PART, by, "pose", chart)
            text = ", ".join([NAMES.get(by, by), *([label(chart)] if chart else [])])
            axes.loglog(list(ns), list(ns.values()), style, color=colour, marker=mark, ms=5, label=text)
        axes.set(xlabel="N, poses in a call", ylabel="ns per pose", ylim=(1, 2e6))
        axes.grid(alpha=0.25)
        axes.legend(loc="upper right", ncols=2, frameon=False, handlelength=2.5)
        put_picture(path, made)
