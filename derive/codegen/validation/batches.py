"""Calls of a chart, grouped by function and branch, and the comparison of results with expected values."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

from ...maps.chart import Chart
from ..rows import Function, Table
from ..signatures import POSES
from . import decimals, reals, samples
from .calls import Case, grouped, of_composed, require
from .screws import covering
from .vectors import vectors_of


class ValidationFailed(Exception):
    """Error of an emitted kernel that differs from its formula or breaks its interface."""


@dataclass(frozen=True, slots=True)
class Batch:
    """Cases of one function and branch: exact on ring elements, or within a tolerance on 50-digit numbers."""

    row: Function
    branch: tuple[int, ...]
    cases: tuple[Case, ...]
    tolerance: Any = None

    @property
    def function(self) -> str:
        return self.row.name

    @property
    def exact(self) -> bool:
        return self.tolerance is None

    @property
    def agree(self) -> Callable[[Any, Any], bool]:
        """Comparison of a result with the expected one."""
        return same if self.exact else partial(decimals.close, tolerance=self.tolerance)


@lru_cache(maxsize=4)
def batches(chart: Chart, table: Table = POSES, names: frozenset[str] | None = None) -> Sequence[Batch]:
    """Return the calls of every public function, or of the named ones.

    Raise ValueError if a call, or a required exact one, is missing.
    """
    wanted = table.public.keys() if names is None else names
    with reals.digits(decimals.EXACT_DIGITS):
        symbolic = samples.on_symbols(chart, table, wanted) if chart.algebraic else ()
        exactly = [Batch(case.row, (), (case,)) for case in symbolic]
        closely = [
            Batch(cases[0].row, branch, tuple(map(_decimal, cases)), decimals.tolerance(chart, cases[0].row.remainder))
            for branch, cases in grouped(c for c in samples.at_numbers(chart, table) if c.function in wanted)
        ]
    require("a call", wanted, (batch.function for batch in exactly + closely))
    if chart.algebraic:
        exact = [name for name in wanted if table.public[name].exact]
        require("an exact call", exact, (batch.function for batch in exactly))
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


def composed(chart: Chart, table: Table = POSES) -> Sequence[Batch]:
    """Return the calls of the functions that Python composes, which compiled targets have as programs."""
    with reals.digits(decimals.EXACT_DIGITS):
        draw = random.Random(samples.SEED)
        screws, at = list(covering(draw, samples.SMALL_AT_EDGE)), vectors_of(chart)
        found = grouped(of_composed(at, table, draw, screws, samples.JACOBIAN_MARGIN, tuple))
        near = decimals.tolerance(chart)
        return [Batch(cases[0].row, k, tuple(map(_decimal, cases)), near) for k, cases in found]


def _decimal(case: Case) -> Case:
    arguments = tuple(tuple(map(decimals.Decimal, argument)) for argument in case.arguments)
    return Case(case.row, case.branch, arguments, lambda: tuple(map(decimals.Decimal, case.result)))
