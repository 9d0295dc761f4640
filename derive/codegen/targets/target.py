"""Protocol of a target: a language, its files and texts, and how printed text is executed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol

from ...maps.chart import Chart
from ..facts import Facts
from ..rows import Table

Data = Mapping[str, Any]
"""Values for the holes of a template by name, without ``header``."""


class Target(Protocol):
    """A language in which kernels are printed; `name` is also its template folder."""

    @property
    def name(self) -> str: ...

    @property
    def extension(self) -> str:
        """Extension of a module's file, whose template is ``<name>/chart.<extension>.j2``."""

    @property
    def entry(self) -> str:
        """Shared file that is read before any other."""

    @property
    def comment(self) -> str:
        """Mark that begins a comment line."""

    @property
    def unproved(self) -> str:
        """Parts of the text that validation does not execute."""

    @property
    def tables(self) -> Sequence[Table]:
        """Tables whose functions are printed, poses first; every chart has a module for each."""

    def shared(self) -> Mapping[str, Data]:
        """Return data of the files that every package holds, by file name; each has a template of that name."""

    def module(self, facts: Facts) -> Data:
        """Return data of the module of a chart."""

    def companions(self, facts: Facts) -> Mapping[str, tuple[str, Data]]:
        """Return template and data of further files of a chart, by file name."""

    def require_complete(self, texts: Mapping[str, str]) -> None:
        """Compare the functions in the shared texts with the table; `ValueError` if they differ."""

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
