"""Checks of the benchmark of propagate: a row per tolerance and number of outputs, with errors that fall."""

from __future__ import annotations

import pytest

pytest.importorskip("matplotlib")

from benchmarks import propagate


def test_section_has_a_row_for_each_case() -> None:
    text = propagate.section((1e-5, 1e-9), 1.0, 1)
    rows = [line.split(" | ") for line in text.splitlines() if line.startswith("| 1e-")]
    assert len(rows) == 2 * len(propagate.COUNTS)
    assert all(float(rows[2][k].strip(" |")) < float(rows[0][k].strip(" |")) for k in (5, 6))
