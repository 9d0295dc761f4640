"""Cases of a chart, grouped by function and branch, and the comparison of results with expected values."""

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
from . import decimals, formulas, samples
from .formulas import Expectation


class ValidationFailed(Exception):
    """Error of an emitted kernel that differs from its formula or breaks its interface."""


@dataclass(frozen=True, slots=True)
class Batch:
    """Cases of one function and branch: exact on ring elements, or within a tolerance on 50-digit numbers."""

    row: Function
    branch: tuple[int, ...]
    cases: tuple[Expectation, ...]
    tolerance: Any = None

    @property
    def function(self) -> str:
        return self.row.name

    @property
    def exact(self) -> bool:
        """True if results are elements of a ring."""
        return self.tolerance is None

    @property
    def agree(self) -> Callable[[Any, Any], bool]:
        """Comparison of a result with the expected one."""
        return same if self.exact else partial(decimals.close, tolerance=self.tolerance)


@lru_cache(maxsize=4)
def batches(chart: Chart, table: Table = POSES) -> Sequence[Batch]:
    """Return the cases of every public function of a table.

    Raises
    ------
    ValueError
        If a function has no case, or lacks the exact case that its row requires in an algebraic chart.
    """
    algebraic = is_algebraic(chart)
    with mpmath.workdps(decimals.DIGITS):
        exactly = [_batch((case,), table) for case in formulas.expectations(chart, table)] if algebraic else []
        close = [*samples.by_function(chart, table), *(() if algebraic else samples.algebraic(chart, table))]
        closely = [_batch(tuple(map(_decimal, batch)), table, chart) for batch in close]
    _require("an expectation", table.public, exactly + closely)
    if algebraic:
        _require("an exact expectation", (name for name, row in table.public.items() if row.exact), exactly)
    return (*exactly, *closely)


def same(got: Any, expected: Any) -> bool:
    """Tell whether two numbers are equal; NaN equals only NaN."""
    return bool(got == expected or (got != got and expected != expected))


def compare(where: str, found: Any, expected: Sequence[Any], agree: Callable[[Any, Any], bool]) -> None:
    """Raise `ValidationFailed` at the first component that differs from the expected one."""
    if len(found) != len(expected):
        raise ValidationFailed(f"{where}: {len(found)} components, expected {len(expected)}")
    for index, (got, wanted) in enumerate(zip(found, expected, strict=True)):
        try:
            right = agree(got, wanted)
        except TypeError as error:
            raise ValidationFailed(f"{where}, component {index}: {error}") from error
        if not right:
            raise ValidationFailed(f"{where}, component {index}: {got} is not {wanted}")


def _require(kind: str, names: Iterable[str], found: Iterable[Batch]) -> None:
    missing = sorted(set(names) - {batch.function for batch in found})
    if missing:
        raise ValueError(f"functions without {kind} cannot be generated: {', '.join(missing)}")


def _batch(cases: tuple[Expectation, ...], table: Table, chart: Chart | None = None) -> Batch:
    """Return a batch of exact cases or, if a chart is given, of 50-digit cases."""
    function, *branch = cases[0].function.split()
    row = table.functions[function]
    tolerance = decimals.tolerance(chart, row.remainder) if chart else None
    return Batch(row, tuple(map(int, branch)), cases, tolerance)


def _decimal(case: Expectation) -> Expectation:
    arguments = tuple(tuple(map(decimals.Decimal, argument)) for argument in case.arguments)
    return Expectation(case.function, arguments, lambda: tuple(map(decimals.Decimal, case.result)))
