"""Page of speeds: printed from its data, one time for one call, gates and faster libraries named."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest

from benchmarks import __main__ as command
from benchmarks import gates, page, slower, tables, times, timing
from benchmarks.maps import NUMPY, PART
from benchmarks.peers import LIBRARIES
from benchmarks.times import Data, Timed

PAGE = times.FILE.with_suffix(".md")
SIZES = (1, 100, 10_000)


def of(by: str, chart: str, ns: float, function: str = "pose", call: str = "", part: str = PART) -> Timed:
    call = call or (LIBRARIES[by].texts[function][0] if by in LIBRARIES else f"{chart}.{function}(v)")
    return Timed(part, by, chart, function, call, dict.fromkeys(SIZES, ns))


def data(*measured: Timed, commit: str = "1") -> Data:
    return Data(commit, {"SciPy": "1.17"}, measured)


# --- the committed page -----------------------------------------------------------------------------------------------


@pytest.mark.smoke
def test_page_is_printed_from_its_data() -> None:
    found, text = times.read(), PAGE.read_text(encoding="utf-8")
    kept = page.sections(text)
    kept.pop("")
    assert text == page.joined(page.head(found), kept | tables.sections(found))
    assert page.figures(found) in times.README.read_text(encoding="utf-8")


def test_one_call_of_a_library_has_one_time() -> None:
    each = [(of.part, of.by, of.chart, of.function, of.call) for of in times.read().times]
    assert len(each) == len({*each})
    called = {(by, call) for part, by, _, _, call in each if part == PART}
    for library, of in LIBRARIES.items():
        assert {(library, text) for text in (*of.texts.get("pose", ()), *of.texts.get("compose", ()))} <= called


def test_everything_slower_has_a_reason() -> None:
    missed = [gate.why for gate in gates.every(times.read()) if not gate.met]
    assert {*missed, *(faster.why for faster in slower.every(times.read()))} <= slower.REASONS.keys()


# --- data -------------------------------------------------------------------------------------------------------------


def test_times_of_missing_libraries_are_kept_with_their_commit() -> None:
    former = data(of("SciPy", "", 5.0), of(NUMPY, "cayley2", 2.0))
    kept = data(of(NUMPY, "cayley2", 1.0), commit="2").with_missing(former)
    again = data(of(NUMPY, "cayley2", 1.5), commit="3").with_missing(kept)
    for found in (kept, again):
        assert found.kept == {"SciPy": "1.17, commit 1"}
        assert found.ns(PART, "SciPy", "pose") == dict.fromkeys(SIZES, 5.0)
        assert "SciPy was missing: its times are those of 1.17, commit 1." in page.head(found)
    assert data(of("SciPy", "", 4.0)).with_missing(data(of("SciPy", "", 5.0))).kept == {}
    assert "not installed" in tables.sections(data(of(NUMPY, "cayley2", 1.0)))["maps"]


def test_parts_that_are_measured_later_name_their_commit() -> None:
    former = data(of(NUMPY, "cayley2", 2.0), of(NUMPY, "cayley2", 5.0, part="rows"))
    found = former.with_parts(data(of(NUMPY, "cayley2", 1.0, part="rows"), commit="2"))
    assert [timed.ns[1] for timed in found.times] == [2.0, 1.0]
    assert "commit 1," in page.head(found)
    assert "Part `rows` was measured later, at commit 2." in page.head(found)


# --- gates and faster libraries ---------------------------------------------------------------------------------------


def decided(*measured: Timed) -> dict[str, bool]:
    return {gate.what: gate.met for gate in gates.every(data(*measured))}


def test_missed_gates_are_named_first() -> None:
    found = decided(of("SciPy", "", 7.0), of(NUMPY, "exponential", 1.0), of(NUMPY, "cayley2", 1.0))
    assert found == {
        "pose, n = 2, N = 1: SciPy": False, "pose, exponential, N = 1: SciPy": True,
        "pose, exponential, N = 10000: SciPy": True, "pose, n = 2, N = 10000: SciPy": True,
    }  # fmt: skip
    assert [*found.values()] == sorted(found.values())


# --- the command ------------------------------------------------------------------------------------------------------


def test_command_writes_page_data_and_plot_and_keeps_other_sections(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    output = tmp_path / "speed.md"
    output.write_text(page.joined("# Speed", {"recorded": "## Former\n\n| a |\n|---|\n| 1 |\n"}), encoding="utf-8")
    monkeypatch.setattr(sys, "argv", ["benchmarks", "-o", str(output)])
    monkeypatch.setattr(command, "measure", lambda _: [of(NUMPY, "cayley2", 1.0), of("SciPy", "", 2.0)])
    monkeypatch.setattr(command.motion, "section", lambda: "## Motion")
    monkeypatch.setattr(command.propagate, "section", lambda: "## Propagation")
    monkeypatch.setattr(command.splines, "section", lambda: "## Splines")
    monkeypatch.setattr(command, "allocator_is_fixed", lambda: False)
    with pytest.raises(RuntimeError, match="not fixed"):
        command.main()
    monkeypatch.setattr(command, "allocator_is_fixed", lambda: True)
    command.main()
    whole = output.read_text(encoding="utf-8")
    assert whole.startswith(page.INTRODUCTION)
    assert "<details><summary>Table, 1 rows</summary>\n\n| a |" in whole
    assert whole.index("## Motion") < whole.index("## Propagation") < whole.index("## Former") < whole.index("## Gates")
    assert output.with_suffix(".svg").read_text(encoding="utf-8").startswith("<?xml")
    monkeypatch.setattr(sys, "argv", ["benchmarks", "-o", str(output), "--print"])
    command.main()
    assert output.read_text(encoding="utf-8") == whole


# --- the allocator ----------------------------------------------------------------------------------------------------

FIXED = """
from benchmarks.timing import allocator_is_fixed, fix_allocator
print(allocator_is_fixed(), flush=True)
fix_allocator()
"""


def environment(further: Mapping[str, str]) -> dict[str, str]:
    path = os.pathsep.join([str(times.ROOT), str(times.ROOT / "generated")])
    return {"PYTHONPATH": path, "PATH": os.environ["PATH"], **further}


def test_process_starts_again_with_a_fixed_allocator() -> None:
    for further, said in (({}, ["False", "True"]), (timing.ALLOCATOR, ["True"])):
        run = [sys.executable, "-c", FIXED]
        done = subprocess.run(run, env=environment(further), capture_output=True, text=True, check=True)
        assert done.stdout.split() == said


def test_every_command_that_measures_fixes_the_allocator() -> None:
    for file in (times.ROOT / "benchmarks").glob("*.py"):
        text = file.read_text(encoding="utf-8")
        if "from benchmarks.timing import" in text and '__name__ == "__main__"' in text:
            assert '__main__":\n    fix_allocator()\n    main()' in text, file.name
