"""Seeded cases in floating-point numbers, for languages whose kernels take no exact elements.

Arguments are numbers that a float holds (inverse maps: what rounds to one), results are computed from the formula to 50
digits. Every part of a result (real, dual) comes with the scale its error is measured by: its norm, or, where larger,
how far it moves when arguments move by their own size, the terms added up. Of the forward maps only dual arguments are
moved: their dual part is linear in them, so this is the sum of the norms of its terms; and in turn all arguments but
the first as a whole, so this is the sum over what each of them contributes. Of the inverse maps all are: this is their
condition. Where a program comes to a vector by its angle, that is moved in turn, too: near an edge a rounding of it
takes v far.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import mpmath

from ...algebra import Vector
from ...maps.chart import Chart
from ...maps.inverse import polar
from ..lowered import geometry
from ..rows import Function, Table
from ..signatures import POSES
from .decimals import DIGITS
from .exact import ALGEBRAIC, Flat
from .maps_at import flat, seeded_arguments
from .point import value
from .vectors import Vectors, vectors_of

SEED = 88
POINTS = 5
STEP = mpmath.mpf(2) ** -80
WIDE = 3
"""Largest component of v, by φ′(0)."""

GRID = 2**18


@dataclass(frozen=True, slots=True)
class Case:
    """A call: its arguments and branch, the result, and the scale of the error of each part of the result."""

    function: str
    branch: int | None
    arguments: tuple[tuple[float, ...], ...]
    result: tuple[float, ...]
    scales: tuple[float, ...]


@lru_cache(maxsize=4)
def cases(chart: Chart, table: Table = POSES) -> Sequence[Case]:
    """Cases of every function of the module of a chart, by default that of poses, in the order of their signatures."""
    draw = random.Random(SEED)
    with mpmath.workdps(DIGITS):
        vectors = vectors_of(chart)
        found = [case for _ in range(POINTS) for case in _algebraic(vectors, table, draw)]
        for source, branch, arguments in seeded_arguments(vectors, draw, nearby):
            if row := table.sources.get(source):
                found.append(_case(vectors, row, branch, row.restricted(arguments)))
    names = list(table.functions)
    return tuple(sorted(found, key=lambda case: names.index(case.function)))


def nearby(value: Any) -> Any:
    """A number nearby that a float holds."""
    return mpmath.mpf(int(mpmath.nint(value * GRID))) / GRID


def _algebraic(chart: Vectors, table: Table, draw: random.Random) -> Iterator[Case]:
    """Every algebraic function at one point, Re|v| well below the first pole of the inverse operator."""
    size = chart.component(WIDE * chart.slope(0), chart.first_pole)
    drawn = [tuple(nearby(draw.uniform(-most, most)) for _ in range(6)) for most in (size, 2, 2)]
    for row in (table.sources[name] for name in ALGEBRAIC if name in table.sources):
        yield _case(chart, row, None, [given[: array.size] for given, array in zip(drawn, row.arguments)])


def _case(chart: Vectors, row: Function, branch: int | None, arguments: Sequence[Flat]) -> Case:
    """A call with its result and scales: of an algebraic function dual parts of dual arguments move, else all."""
    result = value(chart, row, branch, arguments)

    def moved(place: int, components: Sequence[int]) -> Flat:
        """How far the result goes when these components of an argument move by their own size."""
        stepped = [c * (1 + STEP) if j in components else c for j, c in enumerate(arguments[place])]
        there = value(chart, row, branch, [*arguments[:place], tuple(stepped), *arguments[place + 1 :]])
        return tuple((b - a) / STEP for a, b in zip(result, there, strict=True))

    places = [(i, j) for i, array in enumerate(row.arguments) for j in range(array.size)]
    single = [moved(i, [j]) for i, j in places if row.arguments[i].part_of[j] or not row.exact]
    whole = [moved(i, range(array.size)) for i, array in enumerate(row.arguments) if i and row.exact]
    ways = ([result], single, whole, _by_angle(chart, row, result))
    scales = (float(max(sum(_norm(at(step)) for step in steps) for steps in ways)) for at in _parts(row))
    return Case(row.name, branch, tuple(map(_doubles, arguments)), _doubles(result), tuple(scales))


def _by_angle(chart: Vectors, row: Function, result: Flat) -> list[Flat]:
    """How far a vector goes when its angle does by its own size, for programs that come to it by the angle."""
    pose = row.pose or row
    if "coefficient" not in {call.function for call in geometry()[pose.kernel].calls} or pose.shape != (6,):
        return []
    extent, axis = polar(Vector.dual(result[:3], result[3:] or (mpmath.mpf(0),) * 3))
    there = row.part(flat(axis * chart.size(chart.angle(extent) * (1 + STEP))))
    return [tuple((b - a) / STEP for a, b in zip(result, there, strict=True))]


def _parts(row: Function) -> Iterator[Callable[[Flat], Flat]]:
    """What takes a part out of a result, part by part of its arrays."""
    owners = [(place, part) for place, array in enumerate(row.results) for part in array.part_of]
    for owner in dict.fromkeys(owners):
        where = [index for index, other in enumerate(owners) if other == owner]
        yield lambda values, where=where: tuple(values[index] for index in where)  # type: ignore[misc]


def _norm(values: Sequence[Any]) -> Any:
    return mpmath.sqrt(sum(value * value for value in values))


def _doubles(values: Sequence[Any]) -> tuple[float, ...]:
    return tuple(float(value) for value in values)
