"""All cases of a chart on which the text of a kernel is executed, none of its functions left out."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import mpmath

from ...maps.chart import Chart
from ..signatures import PUBLIC
from . import digits, exact
from .exact import Expectation

Agree = Callable[[Any, Any], bool]


@dataclass(frozen=True, slots=True)
class Batch:
    """Cases of one function and branch, on elements of an exact ring or on numbers of 50 digits."""

    function: str
    branch: tuple[int, ...]
    cases: tuple[Expectation, ...]
    exact: bool

    @property
    def agree(self) -> Agree:
        """What a result has to be to the expected one."""
        return same if self.exact else digits.close


def batches(chart: Chart) -> list[Batch]:
    """What every function of the module of a chart must return.

    Raises
    ------
    ValueError
        If a function of the table has no case, or no exact one where its row says so.
    """
    with mpmath.workdps(digits.DIGITS):
        exactly = [_batch((case,), True) for case in exact.expectations(chart)]
        closely = [_batch(tuple(map(_decimal, batch)), False) for batch in digits.expectations(chart)]
    _require("an expectation", PUBLIC, exactly + closely)
    _require("an exact expectation", (name for name, row in PUBLIC.items() if row.exact), exactly)
    return exactly + closely


def same(got: Any, expected: Any) -> bool:
    """Whether two elements are equal."""
    return bool(got == expected)


def _require(what: str, names: Iterable[str], found: Iterable[Batch]) -> None:
    missing = sorted(set(names) - {batch.function for batch in found})
    if missing:
        raise ValueError(f"functions without {what} cannot be generated: {', '.join(missing)}")


def _batch(cases: tuple[Expectation, ...], exactly: bool) -> Batch:
    function, *branch = cases[0].function.split()
    return Batch(function, tuple(map(int, branch)), cases, exactly)


def _decimal(case: Expectation) -> Expectation:
    arguments = tuple(tuple(map(digits.Decimal, argument)) for argument in case.arguments)
    return Expectation(case.function, arguments, case.result)
