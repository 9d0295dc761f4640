"""All cases of a chart on which the text of a kernel is executed, none of its functions left out."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from typing import Any

import mpmath

from ...maps.chart import Chart
from ...proof import is_algebraic
from ..signatures import FUNCTIONS, PUBLIC
from . import digits, exact
from .exact import Expectation

Agree = Callable[[Any, Any], bool]


@dataclass(frozen=True, slots=True)
class Batch:
    """Cases of one function and branch, on elements of an exact ring or on numbers of 50 digits, within a tolerance."""

    function: str
    branch: tuple[int, ...]
    cases: tuple[Expectation, ...]
    tolerance: Any = None

    @property
    def exact(self) -> bool:
        """Whether results are elements of a ring."""
        return self.tolerance is None

    @property
    def agree(self) -> Agree:
        """What a result has to be to the expected one."""
        return same if self.exact else partial(digits.close, tolerance=self.tolerance)


def batches(chart: Chart) -> list[Batch]:
    """What every function of the module of a chart must return.

    Raises
    ------
    ValueError
        If a function of the table has no case, or in an algebraic chart no exact one where its row says so.
    """
    algebraic = is_algebraic(chart)
    with mpmath.workdps(digits.DIGITS):
        exactly = [_batch((case,)) for case in exact.expectations(chart)] if algebraic else []
        close = [*digits.expectations(chart), *(() if algebraic else digits.algebraic(chart))]
        closely = [_batch(tuple(map(_decimal, batch)), chart) for batch in close]
    _require("an expectation", PUBLIC, exactly + closely)
    if algebraic:
        _require("an exact expectation", (name for name, row in PUBLIC.items() if row.exact), exactly)
    return exactly + closely


def same(got: Any, expected: Any) -> bool:
    """Whether two numbers are equal; NaN is only itself."""
    return bool(got == expected or (got != got and expected != expected))


def _require(what: str, names: Iterable[str], found: Iterable[Batch]) -> None:
    missing = sorted(set(names) - {batch.function for batch in found})
    if missing:
        raise ValueError(f"functions without {what} cannot be generated: {', '.join(missing)}")


def _batch(cases: tuple[Expectation, ...], chart: Chart | None = None) -> Batch:
    """Of exact cases, or of decimal ones of a chart."""
    function, *branch = cases[0].function.split()
    tolerance = digits.tolerance(chart, FUNCTIONS[function].remainder) if chart else None
    return Batch(function, tuple(map(int, branch)), cases, tolerance)


def _decimal(case: Expectation) -> Expectation:
    arguments = tuple(tuple(map(digits.Decimal, argument)) for argument in case.arguments)
    return Expectation(case.function, arguments, case.result)
