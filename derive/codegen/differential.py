"""Tables of a differential test: for every kernel function, seeded arguments and exact results as printed numbers."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from ..maps.chart import Chart
from .rows import Array, Table
from .signatures import POSES
from .validation.float_cases import Case, cases

GATE = 8
"""Largest error, in units of the machine epsilon and of the scale of the result."""

Rows = tuple[tuple[str, ...], ...]


@dataclass(frozen=True, slots=True)
class Values:
    """An array of a function: its values case by case, and for a result the scales of its parts."""

    array: Array
    values: Rows
    scales: Rows = ()


@dataclass(frozen=True, slots=True)
class Differential:
    """A function and its cases; ``branches`` is empty where none is chosen."""

    name: str
    count: int
    arguments: tuple[Values, ...]
    branches: tuple[int, ...]
    results: tuple[Values, ...]


def tables(chart: Chart, table: Table = POSES) -> Iterator[Differential]:
    """One for each function of a table, by default that of poses, in its order."""
    for name, group in itertools.groupby(cases(chart, table), lambda case: case.function):
        found = list(group)
        signature = table.functions[name]
        arguments = tuple(
            Values(array, tuple(_hexadecimal(case.arguments[i]) for case in found))
            for i, array in enumerate(signature.arguments)
        )
        branches = tuple(case.branch for case in found if case.branch is not None)
        yield Differential(name, len(found), arguments, branches, tuple(_results(signature.results, found)))


def _results(arrays: Sequence[Array], found: Sequence[Case]) -> Iterator[Values]:
    start = scale = 0
    for array in arrays:
        end, last = start + array.size, scale + len(array.parts)
        values = tuple(_hexadecimal(case.result[start:end]) for case in found)
        yield Values(array, values, tuple(_hexadecimal(case.scales[scale:last]) for case in found))
        start, scale = end, last


def _hexadecimal(values: Sequence[Any]) -> tuple[str, ...]:
    """Exact numbers in C, without trailing zeros."""
    return tuple(re.sub(r"\.?0*p", "p", float(value).hex()) for value in values)
