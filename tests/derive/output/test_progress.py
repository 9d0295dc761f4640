"""Progress bars, on a terminal and in a notebook after a while; tables that fit a given width."""

from __future__ import annotations

import io
import sys
import threading
from collections.abc import Callable
from pathlib import Path

import pytest
from rich.progress import Progress, TaskID

import derive
from derive.codegen import build
from derive.output import shown
from derive.output.shown import WIDTH, Column, Grid, columns


class Terminal(io.StringIO):
    """Stream of a terminal."""

    def isatty(self) -> bool:
        return True


def on_terminal(monkeypatch: pytest.MonkeyPatch, after: float) -> Terminal:
    """Put a terminal in place of stderr, and let bars appear after some seconds."""
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setattr(shown, "BAR_AFTER", after)
    monkeypatch.delenv("TTY_INTERACTIVE", raising=False)
    monkeypatch.setenv("TERM", "xterm")
    return terminal


def long_work() -> None:
    """Report two of three steps, the second one when any bar has appeared."""
    with shown.bar(3) as step:
        step("first [/x]")
        for thread in threading.enumerate():
            if isinstance(thread, threading.Timer):
                thread.join()
        step("second")


def test_bar_appears_after_a_while_and_goes(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = on_terminal(monkeypatch, 0.1)
    long_work()
    text = terminal.getvalue()
    assert "first [/x]" in text
    assert "1/3" in text
    assert text.endswith("\x1b[2K")  # the line of the bar is erased


def test_short_work_has_no_bar(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = on_terminal(monkeypatch, 3600.0)
    with shown.bar(3) as step:
        step("first")
    assert terminal.getvalue() == ""


LONG: dict[str, Callable[[], object]] = {
    "equation (3)": lambda: derive.verify("karakilic-2010", "2,3"),
    "cayley3": lambda: derive.compare([2, 3]),
    "proofs of cayley9": lambda: derive.Cayley(9).prove(),
}


@pytest.fixture
def reported(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Return the lines given to bars; a bar itself shows only those at its moments of drawing."""
    lines: list[str] = []
    update = Progress.update

    def recorded(bar: Progress, *task: TaskID, description: str, advance: float) -> None:
        lines.append(description)
        update(bar, *task, description=description, advance=advance)

    monkeypatch.setattr(Progress, "update", recorded)
    return lines


@pytest.mark.parametrize("line", LONG)
def test_long_functions_have_a_bar(line: str, reported: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = on_terminal(monkeypatch, 0.0)
    LONG[line]()
    assert any(line in each for each in reported)
    assert "━" in terminal.getvalue()


def test_generate_has_a_bar(
    without_validation: None, tmp_path: Path, reported: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    terminal = on_terminal(monkeypatch, 0.0)
    derive.generate([4], output=tmp_path)
    assert "cayley4: printing" in reported
    derive.generate([1], output=tmp_path)
    assert {"cayley1: printing", "cayley3 (checks the geometry that all charts share): printing"} <= {*reported}
    assert "━" in terminal.getvalue()


def test_progress_explains_the_chart_of_the_geometry_and_no_other() -> None:
    lines: list[str] = []
    for name in ("cayley3", "cayley30"):
        build._told(lines.append, "cayley3", f"{name}: printing")
    assert lines == ["cayley3 (checks the geometry that all charts share): printing", "cayley30: printing"]


def test_own_function_of_progress_replaces_the_bar(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = on_terminal(monkeypatch, 0.0)
    seen: list[tuple[int, int]] = []
    derive.verify("karakilic-2010", "2,3", progress=lambda *parts: seen.append(parts))
    assert seen == [(1, 2), (2, 2)]
    assert terminal.getvalue() == ""


@pytest.mark.parametrize("variable", ["TTY_INTERACTIVE=0", "TERM=dumb"])
def test_bar_can_be_switched_off(variable: str, monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = on_terminal(monkeypatch, 0.1)
    monkeypatch.setenv(*variable.split("="))
    long_work()
    assert terminal.getvalue() == ""


def test_pipe_has_no_bar(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(shown, "BAR_AFTER", 0.1)
    long_work()
    assert capsys.readouterr().err == ""


CELL = """
from derive.codegen import build
from derive.output import shown
import threading
shown.BAR_AFTER = 0.1
with shown.bar(3) as step:
    step("first")
    for thread in threading.enumerate():
        if isinstance(thread, threading.Timer):
            thread.join()
print("done")
"""


@pytest.mark.thorough
def test_notebook_shows_a_bar_in_its_cell(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TTY_INTERACTIVE", "1")
    import nbformat  # these take as long as the other tests of this file
    from nbclient import NotebookClient

    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(CELL)])
    NotebookClient(notebook, timeout=None, kernel_name="python3").execute()
    said = {output.name: output.text for output in notebook.cells[0].outputs}
    assert said["stdout"] == "done\n"
    assert "first" in said["stderr"]


# --- tables -----------------------------------------------------------------------------------------------------------

COUNTS = Grid("counts", [Column("module"), Column("calls made", number=True)], [("cayley1.py", "12"), ("b", "3456")])
WORDS = Grid("words", [Column("name"), Column("a statement")], [("first\nof all", "word " * 60)], least=50, ruled=True)


@pytest.mark.parametrize("width", [10, 20, 49, 50, 80, WIDTH])
@pytest.mark.parametrize("grid", [COUNTS, WORDS], ids=lambda grid: grid.title)
def test_no_line_is_wider_than_the_screen(grid: Grid, width: int) -> None:
    assert max(map(len, grid.text(width).splitlines())) <= width


def test_table_that_does_not_fit_becomes_lines_with_all_cells() -> None:
    assert COUNTS.text(20) == "counts\ncayley1.py\n  calls made: 12\nb\n  calls made: 3456\n"
    assert WORDS.text(49).startswith("words\nfirst of all\n  a statement: word word")


def test_cells_of_remarks_have_no_headings() -> None:
    rows = [("a", "1"), ("why", "it is so")]
    text = Grid("counts", [Column("module"), Column("calls")], rows, least=50, remarks=("why",)).text(20)
    assert text == "counts\na\n  calls: 1\nwhy\n  it is so\n"


def test_markup_in_cells_is_printed_literally() -> None:
    cells = "[bold]R[1:2][/bold]", ":rocket:"
    text = Grid("[red]title[/red]", [Column("a"), Column("b")], [cells]).text(80)
    assert all(cell in text for cell in (*cells, "[red]title[/red]"))


def test_table_is_ruled_from_its_least_width_on() -> None:
    ruled = {width for width in range(10, 60) if "━" in WORDS.text(width)}
    assert ruled == set(range(50, 60))
    ruled = {width for width in range(10, 60) if "━" in COUNTS.text(width)}
    assert ruled == set(range(min(ruled), 60))
    assert "3456 │" in COUNTS.text(min(ruled))


def test_width_matches_the_screen_up_to_a_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    for given, expected in (("40", 40), ("500", WIDTH)):
        monkeypatch.setenv("COLUMNS", given)
        assert columns() == expected
