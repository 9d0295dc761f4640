"""Checks of the pictures: files are small, and marks lie at singular angles and edges of charts."""

from __future__ import annotations

import math

import pytest

pytest.importorskip("matplotlib")

from benchmarks import figures
from benchmarks.accuracy import curves
from benchmarks.accuracy.figures import X_AXES

LARGEST = 150_000


def test_the_committed_pictures_are_small():
    files = sorted(figures.FOLDER.glob("*"))
    assert [file.stem for file in files] == [
        "accuracy", "arm", "charts", "heavy_top", "inverse_kinematics_jax", "motion_equations", "screw"
    ]  # fmt: skip
    assert all(file.stat().st_size < LARGEST for file in files)


def test_panels_are_curves_that_are_computed():
    assert {name for name, _ in figures.PANELS.values()} <= X_AXES.keys() & curves.ANGLES.keys()


def test_circles_and_lines_are_where_charts_are_singular():
    axes, = figures.charts().axes
    circles = [line.get_xydata()[0] for line in axes.get_lines() if line.get_marker() == "o" and len(line.get_xydata())]
    at_full_turn = [size for angle, size in circles if angle == pytest.approx(2 * math.pi)]
    # 6 tan(π/3), 8 tan(π/4), 2π, 4 sin(π/2), 8 sin(π/4): cayley2 has none, and cayley1 ends before
    assert at_full_turn == pytest.approx([6 * 3**0.5, 8, 2 * math.pi, 4, 4 * 2**0.5], rel=1e-4)
    edges = [line.get_xdata()[0] for line in axes.get_lines() if line.get_linestyle() == ":" and len(line.get_xdata())]
    assert edges == pytest.approx([k * math.pi for k in (1, 2, 3, 4)])


def test_the_screw_begins_at_the_origin():
    path = figures.screw().axes[0].get_lines()[0].get_data_3d()
    assert [coordinate[0] for coordinate in path] == pytest.approx([0, 0, 0], abs=1e-12)
