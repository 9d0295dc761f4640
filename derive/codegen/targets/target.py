"""What a target is: a language, its files, its texts, and how what was printed is executed again."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Protocol

from ...maps.chart import Chart
from ..package import Printer
from ..rows import Table


class Target(Printer, Protocol):
    """A language kernels are printed in."""

    @property
    def unproved(self) -> str:
        """What of its text is not executed when it is validated."""

    @property
    def tables(self) -> Sequence[Table]:
        """Whose functions it prints, a module of every chart for each, that of poses first."""

    @property
    def imports_bases(self) -> bool:
        """True if the module of a multiple imports the module of its base chart."""

    def validate(self, folder: Path, chart: Chart, geometry: bool) -> int:
        """Execute the text of a module in a folder; return how many calls equal the formula.

        ``geometry`` asks for all functions, which shows the text that charts share; else for those that are its own.
        """

    def replay(self, folder: Path, chart: Chart, geometry: bool) -> int:
        """Call the functions of a module on floats; return how many calls agree with the formula.

        ``geometry`` asks for all functions, in all ways; else for those that are the chart's own.
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
