"""Tests of sections that are measured and written apart, and of pictures."""

from __future__ import annotations

from pathlib import Path

import mpmath
import numpy as np
import pytest

from benchmarks import conditioning, figures
from tests.support import motions, sampling

pytest.importorskip("matplotlib")

from benchmarks import compiling, motion, propagate, splines, timing


def test_section_on_propagate_has_a_row_for_each_case() -> None:
    text = propagate.section((1e-5, 1e-9), 1.0, 1)
    rows = [line.split(" | ") for line in text.splitlines() if line.startswith("| 1e-")]
    assert len(rows) == 2 * len(propagate.COUNTS)
    assert all(float(rows[2][k].strip(" |")) < float(rows[0][k].strip(" |")) for k in (5, 6))


def test_section_on_splines_has_a_row_for_each_quantity_and_no_time_of_scipy_for_v() -> None:
    rows = [line.split(" | ") for line in splines.section((1, 9), 1).splitlines()[4:12]]
    assert [row[1] for row in rows] == ["1"] * 4 + ["9"] * 4
    assert [row[4] == "– |" for row in rows] == [False, False, False, True] * 2


@pytest.mark.thorough
def test_section_on_compiling_has_a_line_with_and_without_rules(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("jax")
    monkeypatch.setattr(compiling, "FAMILIES", ())
    monkeypatch.setattr(compiling, "ORDERS", (2, 3))
    monkeypatch.setattr(compiling, "CALLS", (1,))
    monkeypatch.setattr(compiling, "MODES", ("grad",))
    text = compiling.section(("cayley2", "cayley3"), ("cayley2",))
    forms = [tuple(cell.strip() for cell in line.split("|")[1:3]) for line in text.splitlines() if "| cayley" in line]
    assert forms == [("cayley2", "rules"), ("cayley2", "text"), ("cayley3", "rules")]


@pytest.mark.parametrize("name", motion.EQUATIONS)
def test_straight_lines_compute_the_equations(name: str) -> None:
    equation = motion.EQUATIONS[name]
    y = motions.start(equation, 0.4)
    # same operations in the same order; libraries may round tan differently
    expected = equation.rhs(0.4, y, motions.space_twist)
    np.testing.assert_allclose(motion.straight_line(equation)(0.4, y), expected, rtol=0, atol=1e-14)


def test_section_on_motion_has_a_row_for_each_equation(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(timing, "SECONDS", 1e-6)
    monkeypatch.setattr(motion, "ROUNDS", 1)
    text = motion.section((1e-5, 1e-7), 1.0, tmp_path / "motion.svg")
    assert (tmp_path / "motion.svg").read_text(encoding="utf-8").startswith("<?xml")
    assert all(text.count(f"\n| {name} | {equation.states} |") == 1 for name, equation in motion.EQUATIONS.items())


# --- pictures ---------------------------------------------------------------------------------------------------------

LARGEST = 200_000


def test_the_committed_pictures_are_small():
    files = sorted(figures.FOLDER.glob("*"))
    examples = figures.FOLDER.parents[1].glob("examples/*.py")
    drawn = {f"{file.stem}.svg" for file in examples if "--figure" in file.read_text(encoding="utf-8")}
    measured = {f"{name}.svg" for name in ("accuracy", "charts", "motion", "motion_equations", "screw")}
    assert {file.name for file in files} == measured | drawn
    assert all(file.stat().st_size < LARGEST for file in files)


@pytest.mark.parametrize(
    ("order", "branch", "near_half_turn"), [(3, 0, False), (3, 1, False), (8, 3, False), (2, 0, True), (1, 0, True)]
)
def test_errors_are_of_the_size_of_the_condition(order: int, branch: int, near_half_turn: bool) -> None:
    """Allow a factor of 20 at distances up to 1e-6: errors consist of some roundings in different directions."""
    directions = sampling.unit_vectors(sampling.generator("conditioning"), (4,))
    with mpmath.workdps(30):
        for distance in ("1e-6", "1e-10"):
            alpha = mpmath.pi - mpmath.mpf(distance) if near_half_turn else mpmath.mpf(distance)
            lost = conditioning.condition(order, branch, alpha)
            assert lost < 2 if (order, branch) in ((3, 0), (2, 0)) else lost > 1e5
            assert lost / 20 < conditioning.relative_error(order, branch, alpha, directions) < 20 * lost
