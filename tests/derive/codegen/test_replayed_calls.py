"""Kernels are called as was written down: fewer calls, or all of one size, would still let all that is right pass.

Kernels are not called here: calls and comparisons are only noted.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from derive.codegen.cases import batches, cases
from derive.codegen.validation.calls import Call, Caller
from derive.codegen.validation.sample import Seen

import dualcay
from derive.codegen.lowered import lower_chart
from derive.codegen.rows import Table
from derive.codegen.signatures import POSES, ROTATIONS
from derive.codegen.targets import TARGETS
from derive.codegen.validation import replay
from derive.maps import Cayley, family
from derive.maps.chart import Chart

REPLAYED = {
    ("cayley3", "poses"): "15308 a996279da056",
    ("cayley3", "rotations"): "14834 e96db8d295bf",
    ("orthographic", "poses"): "1484 b7bb81e04a85",
    ("orthographic", "rotations"): "1472 8d504c03f204",
}
"""By chart and table: how many different calls and comparisons, and a digest of them."""

EXECUTED = {"poses": "95 cc7268c1a766", "rotations": "89 1433188365d0"}
"""By table: the same of functions and branches that are executed exactly, of a first chart and of a further one."""

SCALES = {"poses": "345 10c9bc473e50", "rotations": "320 47f8ca2c43ca"}
"""By table: the same of the scales of errors that compiled functions of Cayley maps are compared within."""

CHARTS = {chart.name: chart for chart in (Cayley(3), family("orthographic"))}
TABLES = {"poses": POSES, "rotations": ROTATIONS}


@pytest.fixture
def noted(monkeypatch: pytest.MonkeyPatch) -> set[str]:
    """What is called and compared, a text for each."""
    notes: set[str] = set()

    def run(
        caller: Caller, call: Call, given: Sequence[np.ndarray] | None = None, how: str = "", **options: Any
    ) -> tuple[np.ndarray, ...]:
        place = options.get("out")
        apart = [offset(array, place) for array in given or () if place is not None]
        missing = [np.flatnonzero(np.isnan(array)).tolist() for array in given or ()]
        notes.add(f"{text(call)} {how} {[*map(layout, given or ())]} {missing} {told(options)} {apart}")
        if place is not None:
            return (place,)
        dtype = np.dtype(complex) if any(map(np.iscomplexobj, given or ())) else call.dtype
        return tuple(np.zeros(call.result_shape(array.shape), dtype) for array in call.row.results)

    def refused(caller: Caller, call: Call, given: Sequence[np.ndarray], words: str, **options: Any) -> None:
        notes.add(f"{text(call)} refused {words} {told(options)}")

    def compare(caller: Caller, call: Call, results: Sequence[np.ndarray], how: str = "", **options: Any) -> None:
        notes.add(f"{text(call)} compared {how} {told(options)}")

    monkeypatch.setattr(Caller, "run", run)
    monkeypatch.setattr(Caller, "compare", compare)
    monkeypatch.setattr(Caller, "refused", refused)
    return notes


def text(call: Call) -> str:
    """A call; types by the letter that is the same everywhere."""
    picks = [(pick.shape, pick.tolist()) for pick in call.picks]
    return f"{call.name or call.row.name} {call.dtype.char} {picks} {call.axis} {call.branch or call.known.branch}"


def told(options: Mapping[str, Any]) -> str:
    """Options by name: of arrays their layout, of types their letter."""
    shown = {
        name: layout(value) if isinstance(value, np.ndarray) else getattr(value, "char", value)
        for name, value in sorted(options.items())
    }
    return str(shown)


def layout(array: np.ndarray) -> str:
    """Shape and steps of an array, whatever the size of its numbers."""
    return f"{array.shape} {[step // array.itemsize for step in array.strides]}"


def offset(array: np.ndarray, place: np.ndarray) -> str:
    """How many numbers the place of results begins behind an argument, where they share memory."""
    step = (place.ctypes.data - array.ctypes.data) // place.itemsize
    return f"{layout(place)} {step if np.may_share_memory(array, place) else 'apart'}"


def replayed(chart: Chart, table: Table) -> int:
    folder = Path(dualcay.__file__).parent
    return replay(folder, chart, TARGETS["numpy"].machinery, tables=[table], all_ways=chart.cayley)


def digest(notes: set[str]) -> str:
    return f"{len(notes)} {hashlib.sha256(chr(10).join(sorted(notes)).encode()).hexdigest()[:12]}"


@pytest.mark.parametrize(("chart", "table"), REPLAYED)
def test_calls_are_those_that_were_written_down(noted: set[str], chart: str, table: str) -> None:
    replayed(CHARTS[chart], TABLES[table])
    assert digest(noted) == REPLAYED[chart, table], "if the change is meant, write this down"


@pytest.mark.parametrize("table", EXECUTED)
def test_functions_are_those_that_were_written_down(table: str) -> None:
    seen, found = Seen(), TABLES[table]
    chosen = {
        f"{chart.name} {batch.function} {batch.branch} {batch.exact} {whole}"
        for chart in CHARTS.values()
        for batch, whole in seen.new(lower_chart(chart, found), batches(chart, found))
    }
    assert digest(chosen) == EXECUTED[table], "if the change is meant, write this down"


@pytest.mark.parametrize("table", SCALES)
def test_scales_are_those_that_were_written_down(table: str) -> None:
    found = {
        f"{number} {case.function} {case.branch} {[f'{scale:.6g}' for scale in case.scales]}"
        for number, case in enumerate(cases(Cayley(3), TABLES[table]))
    }
    assert digest(found) == SCALES[table], "if the change is meant, write this down"
