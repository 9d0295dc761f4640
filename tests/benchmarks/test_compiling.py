"""Test of the section on compile times: one line per chart, a second one without rules, and rules restored."""

from __future__ import annotations

import pytest

from benchmarks import compiling

pytest.importorskip("jax")


def test_the_section_has_a_line_with_and_without_rules(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiling, "FAMILIES", ())
    monkeypatch.setattr(compiling, "ORDERS", (2, 3))
    monkeypatch.setattr(compiling, "CALLS", (1,))
    monkeypatch.setattr(compiling, "MODES", ("grad",))
    text = compiling.section(("cayley2", "cayley3"), ("cayley2",))
    forms = [tuple(cell.strip() for cell in line.split("|")[1:3]) for line in text.splitlines() if "| cayley" in line]
    assert forms == [("cayley2", "rules"), ("cayley2", "text"), ("cayley3", "rules")]
