"""All cases of a chart on which the text of a kernel is executed, none of its functions left out."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

import mpmath

from ...maps.chart import Chart
from ...proof import is_algebraic
from ..rows import Function, Table
from ..signatures import POSES
from . import decimals, digits, exact
from .exact import Expectation

Agree = Callable[[Any, Any], bool]


@dataclass(frozen=True, slots=True)
class Batch:
    """Cases of one function and branch, on elements of an exact ring or on numbers of 50 digits, within a tolerance."""

    row: Function
    branch: tuple[int, ...]
    cases: tuple[Expectation, ...]
    tolerance: Any = None

    @property
    def function(self) -> str:
        return self.row.name

    @property
    def exact(self) -> bool:
        """Whether results are elements of a ring."""
        return self.tolerance is None

    @property
    def agree(self) -> Agree:
        """What a result has to be to the expected one."""
        return same if self.exact else partial(decimals.close, tolerance=self.tolerance)


@lru_cache(maxsize=4)
def batches(chart: Chart, table: Table = POSES) -> Sequence[Batch]:
    """What every function of the module of a chart must return, by default that of poses.

    Raises
    ------
    ValueError
        If a function of the table has no case, or in an algebraic chart no exact one where its row says so.
    """
    algebraic = is_algebraic(chart)
    with mpmath.workdps(decimals.DIGITS):
        exactly = [_batch((case,), table) for case in exact.expectations(chart, table)] if algebraic else []
        close = [*digits.expectations(chart, table), *(() if algebraic else digits.algebraic(chart, table))]
        closely = [_batch(tuple(map(_decimal, batch)), table, chart) for batch in close]
    _require("an expectation", table.public, exactly + closely)
    if algebraic:
        _require("an exact expectation", (name for name, row in table.public.items() if row.exact), exactly)
    return (*exactly, *closely)


def same(got: Any, expected: Any) -> bool:
    """Whether two numbers are equal; NaN is only itself."""
    return bool(got == expected or (got != got and expected != expected))


def _require(what: str, names: Iterable[str], found: Iterable[Batch]) -> None:
    missing = sorted(set(names) - {batch.function for batch in found})
    if missing:
        raise ValueError(f"functions without {what} cannot be generated: {', '.join(missing)}")


def _batch(cases: tuple[Expectation, ...], table: Table, chart: Chart | None = None) -> Batch:
    """Of exact cases, or of decimal ones of a chart."""
    function, *branch = cases[0].function.split()
    row = table.functions[function]
    tolerance = decimals.tolerance(chart, row.remainder) if chart else None
    return Batch(row, tuple(map(int, branch)), cases, tolerance)


def _decimal(case: Expectation) -> Expectation:
    arguments = tuple(tuple(map(decimals.Decimal, argument)) for argument in case.arguments)
    return Expectation(case.function, arguments, lambda: tuple(map(decimals.Decimal, case.result)))
