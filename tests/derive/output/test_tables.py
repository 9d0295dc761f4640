"""Tables that fit a given width, with rules or as plain lines."""

from __future__ import annotations

import pytest

from derive.output.tables import WIDTH, Column, Grid, columns

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
