"""What a target is: a language, its files, its texts, and how what was printed is executed again."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Protocol

from ...maps.chart import Chart
from ..package import Printer
from ..rows import Table
from ..validation import Choose, everything


class Target(Printer, Protocol):
    """A language kernels are printed in."""

    @property
    def unproved(self) -> str:
        """What of its text is not executed when it is validated."""

    @property
    def tables(self) -> Sequence[Table]:
        """Whose functions it prints, a module of every chart for each, that of poses first."""

    def validate(self, folder: Path, chart: Chart, choose: Choose = everything) -> int:
        """Execute the text of a module in a folder; how many calls equal the formula.

        ``choose`` leaves out what other charts of the package have shown of its shared text.
        """

    def replay(self, folder: Path, chart: Chart, all_ways: bool) -> int:
        """Call the functions of a module on floats; how many calls agree with the formula, 0 where nothing is called.

        ``all_ways`` asks for those too that do not depend on the chart.
        """

    def test(self, folder: Path, chart: Chart) -> int | None:
        """Compile and run the tests among its companions: how many calls agree, None where nothing compiles them."""


def require_functions(where: str, found: Iterable[str], table: Table) -> None:
    """Compare the functions that a text defines with the public ones of a table.

    Raises
    ------
    ValueError
        Naming what is missing and what is not in the table.
    """
    missing, extra = (sorted(names) for names in (table.public.keys() - set(found), set(found) - table.public.keys()))
    if missing or extra:
        named = (", ".join(names) or "none" for names in (missing, extra))
        raise ValueError(f"{where}: functions of the table that are missing: {next(named)}; not in it: {next(named)}")
