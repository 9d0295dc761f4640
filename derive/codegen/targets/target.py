"""Protocol of a target: a language, its files and texts, and how printed text is executed."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Protocol

from ...maps.chart import Chart
from ..package import Printer
from ..rows import Table


class Target(Printer, Protocol):
    """A language in which kernels are printed."""

    @property
    def unproved(self) -> str:
        """Parts of the text that validation does not execute."""

    @property
    def tables(self) -> Sequence[Table]:
        """Tables whose functions are printed, poses first; every chart has a module for each."""

    @property
    def imports_bases(self) -> bool:
        """True if the module of a multiple imports the module of its base chart."""

    def validate(self, folder: Path, chart: Chart, geometry: bool) -> int:
        """Execute the text of a module in a folder; return how many calls equal the formula.

        With ``geometry`` all functions are executed, and so the text that charts share; else the chart's own ones.
        """

    def replay(self, folder: Path, chart: Chart, geometry: bool) -> int:
        """Call the functions of a module on floats; return how many calls agree with the formula.

        With ``geometry`` all functions are called, in all ways; else the chart's own ones.
        """

    def test(self, folder: Path, chart: Chart) -> int | None:
        """Compile and run the tests among its companions; return how many calls agree, None without a compiler."""


def require_functions(where: str, found: Iterable[str], table: Table) -> None:
    """Compare the functions of a text with the public ones of a table.

    Raises
    ------
    ValueError
        Naming what is missing and what is not in the table.
    """
    missing, extra = (sorted(names) for names in (table.public.keys() - set(found), set(found) - table.public.keys()))
    if missing or extra:
        named = (", ".join(names) or "none" for names in (missing, extra))
        raise ValueError(f"{where}: functions of the table that are missing: {next(named)}; not in it: {next(named)}")
