"""Seeded cases in floating-point numbers, for languages whose kernels take no exact elements.

Arguments are numbers that a float holds (inverse maps: what rounds to one), results are computed from the formula to 50
digits. Every part of a result (real, dual) comes with the scale its error is measured by: its norm, or, where larger,
how far it moves when arguments move by their own size, the terms added up. Of the forward maps only dual arguments are
moved: their dual part is linear in them, so this is the sum of the norms of its terms. Of the inverse maps all are:
this is their condition.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath

from ...maps.chart import Chart
from ..signatures import FUNCTIONS
from . import exact
from .digits import DIGITS
from .maps_at import MAPS, Flat, seeded_arguments
from .point import Point
from .vectors import Vectors

SEED = 88
POINTS = 5
STEP = mpmath.mpf(2) ** -80
WIDE = 3
"""Largest component of v, by φ′(0)."""

GRID = 2**18
DUAL_SYMBOLS = ("v4", "v5", "v6", "w4", "w5", "w6")


@dataclass(frozen=True, slots=True)
class Case:
    """A call: its arguments and branch, the result, and the scale of the error of each part of the result."""

    function: str
    branch: int | None
    arguments: tuple[tuple[float, ...], ...]
    result: tuple[float, ...]
    scales: tuple[float, ...]


def cases(chart: Chart) -> list[Case]:
    """Cases of every function of the module of a chart, in the order of their signatures."""
    draw = random.Random(SEED)
    with mpmath.workdps(DIGITS):
        vectors = Vectors(chart)
        found = [case for _ in range(POINTS) for case in _algebraic(vectors, draw)]
        found += [_inverse(vectors, *given) for given in seeded_arguments(vectors, draw, nearby)]
    names = list(FUNCTIONS)
    return sorted(found, key=lambda case: names.index(case.function))


def nearby(value: Any) -> Any:
    """A number nearby that a float holds."""
    return mpmath.mpf(int(mpmath.nint(value * GRID))) / GRID


def _algebraic(chart: Vectors, draw: random.Random) -> Iterator[Case]:
    """Every algebraic function at one point, Re|v| well below the first pole of the inverse operator."""
    size = chart.component(WIDE * chart.slope(0), chart.first_pole)
    values = {f"v{i}": nearby(draw.uniform(-size, size)) for i in range(1, 7)}
    values |= {f"w{i}": nearby(draw.uniform(-2, 2)) for i in range(1, 7)}

    def results(at: Mapping[str, Any]) -> list[exact.Expectation]:
        found = exact.expectations(chart.chart, lambda **symbols: Point(at, chart))
        return [case for case in found if case.function not in MAPS]

    moved = [results(values | {name: values[name] * (1 + STEP)}) for name in DUAL_SYMBOLS]
    for index, case in enumerate(results(values)):
        yield _case(case.function, None, case.arguments, case.result, [step[index].result for step in moved])


def _inverse(chart: Vectors, function: str, branch: int | None, arguments: Sequence[Flat]) -> Case:
    evaluate = MAPS[function]
    moved = []
    for i, argument in enumerate(arguments):
        for j, component in enumerate(argument):
            stepped = (*argument[:j], component * (1 + STEP), *argument[j + 1 :])
            moved.append(evaluate(chart, branch or 0, *arguments[:i], stepped, *arguments[i + 1 :]))
    return _case(function, branch, arguments, evaluate(chart, branch or 0, *arguments), moved)


def _case(
    function: str, branch: int | None, arguments: Sequence[Flat], result: Flat, moved: Sequence[Flat]
) -> Case:
    steps = [[(b - a) / STEP for a, b in zip(result, other, strict=True)] for other in moved]
    scales = []
    start = 0
    for size in (size for array in FUNCTIONS[function].results for size in array.parts):
        part = slice(start, start + size)
        condition = sum(_norm(step[part]) for step in steps)
        scales.append(float(max(_norm(result[part]), condition)))
        start += size
    return Case(function, branch, tuple(map(_doubles, arguments)), _doubles(result), tuple(scales))


def _norm(values: Sequence[Any]) -> Any:
    return mpmath.sqrt(sum(value * value for value in values))


def _doubles(values: Sequence[Any]) -> tuple[float, ...]:
    return tuple(float(value) for value in values)


