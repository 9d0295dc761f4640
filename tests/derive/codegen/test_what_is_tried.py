"""Cases of validation are those that were written down: fewer or weaker ones would still let all that is right pass."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest
from derive.codegen.validation.sample import Seen

import dualcay
from derive.codegen.signatures import POSES, ROTATIONS
from derive.codegen.targets import TARGETS
from derive.codegen.validation import replay
from derive.codegen.validation.run import validate
from derive.maps import Cayley, family
from tests.support import tried


def changed(kind: str, table: str) -> Mapping[str, tuple[str | None, str | None]]:
    """What is tried otherwise than was written down."""
    known, found = tried.committed()[f"{kind} of {table}"], tried.tried(kind, table)
    names = sorted(known.keys() | found.keys())
    return {name: (known.get(name), found.get(name)) for name in names if known.get(name) != found.get(name)}


MEANT = "if the change is meant: python -m tests.support.tried"


@pytest.mark.parametrize("table", tried.TABLES)
def test_a_text_is_executed_on_what_was_written_down(table: str) -> None:
    assert not changed("batches", table), MEANT


@pytest.mark.parametrize("table", tried.TABLES)
def test_functions_are_called_with_what_was_written_down(table: str) -> None:
    assert not changed("cases", table), MEANT


@pytest.mark.parametrize("table", tried.TABLES)
def test_arrays_are_filled_with_what_was_written_down(table: str) -> None:
    assert not changed("samples", table), MEANT


def test_another_number_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    first, *others = tried.cases(tried.EDGED, ROTATIONS)
    monkeypatch.setattr(tried, "cases", lambda chart, table: others)
    assert changed("cases", "rotations").keys() == {f"{tried.EDGED.name}.{first.function}"}


CALLS = {("cayley3", POSES): (1113, 8978), ("cayley3", ROTATIONS): (1004, 8226),
         ("orthographic", POSES): (723, 763), ("orthographic", ROTATIONS): (663, 757)}  # fmt: skip
"""Calls that are compared exactly, and on floats, of a first chart and of a further one."""


def test_kernels_are_called_as_often_as_was_written_down() -> None:
    folder, seen = Path(dualcay.__file__).parent, Seen()
    found = {
        (chart.name, table): (
            validate(folder, chart, seen.new, [table]),
            replay(folder, chart, TARGETS["numpy"].machinery, tables=[table], all_ways=chart.cayley),
        )
        for chart in (Cayley(3), family("orthographic"))
        for table in (POSES, ROTATIONS)
    }
    assert found == CALLS
