"""Checks of the benchmark of motion equations: its programs compute the equations, and errors fall with tolerances."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from benchmarks import motion, timing
from tests.support import motions


@pytest.mark.parametrize("name", motion.EQUATIONS)
def test_straight_lines_compute_the_equations(name: str) -> None:
    equation = motion.EQUATIONS[name]
    y = equation.initial(motions.pose(0.4))
    # same operations in the same order; libraries may round tan differently
    expected = equation.rhs(0.4, y, motions.space_twist)
    np.testing.assert_allclose(motion.straight_line(equation)(0.4, y), expected, rtol=0, atol=1e-14)


def test_section_has_a_row_for_each_equation_and_a_picture(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(timing, "SECONDS", 1e-6)
    monkeypatch.setattr(motion, "ROUNDS", 1)
    text = motion.section((1e-5, 1e-7), 1.0, tmp_path / "motion.png")
    assert (tmp_path / "motion.png").read_bytes().startswith(b"\x89PNG")
    assert all(text.count(f"\n| {name} | {equation.states} |") == 1 for name, equation in motion.EQUATIONS.items())


def test_work_is_interpolated_within_the_measured_errors() -> None:
    found = [motion.Run(1000, 2.0, 1e-4), motion.Run(4000, 8.0, 1e-8)]
    assert motion.work(found, 1e-6) == ("2000", "4.0")
    assert motion.work(found, 1e-9) == motion.work(found, 1e-3) == ("–", "–")
