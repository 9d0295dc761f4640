"""Protocol of a target: a language, its files and texts, and the execution of printed text."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Protocol

from ...maps.chart import Chart
from ..package import Printer
from ..rows import Table


class Target(Printer, Protocol):
    """Language in which kernels are printed."""

    @property
    def unproved(self) -> str:
        """Parts of the text that validation does not execute."""

    @property
    def tables(self) -> Sequence[Table]:
        """Tables whose functions are printed, poses first; every chart has a module for each table."""

    @property
    def imports_bases(self) -> bool:
        """True if the module of a multiple imports the module of its base chart."""

    def validate(self, folder: Path, chart: Chart, geometry: bool) -> int:
        """Execute the text of a module in a folder; return the number of calls that equal the formula.

        With ``geometry``, execute all functions and so the shared text; otherwise only the chart's own functions.
        """

    def replay(self, folder: Path, chart: Chart, geometry: bool) -> int:
        """Call the functions of a module on floats; return the number of calls that agree with the formula.

        With ``geometry``, call all functions in all ways; otherwise only the chart's own functions.
        """

    def test(self, folder: Path, chart: Chart) -> int | None:
        """Compile and run the tests of the companions; return the number of agreeing calls, None without a compiler."""


def require_functions(where: str, found: Iterable[str], table: Table) -> None:
    """Compare the functions of a text with the public ones of a table.

    Raises
    ------
    ValueError
        If functions are missing or not in the table; the message names them.
    """
    missing, extra = (sorted(names) for names in (table.public.keys() - set(found), set(found) - table.public.keys()))
    if missing or extra:
        named = (", ".join(names) or "none" for names in (missing, extra))
        raise ValueError(f"{where}: functions of the table that are missing: {next(named)}; not in it: {next(named)}")
