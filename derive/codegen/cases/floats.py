"""Cases for a replay on floats: arguments in floats' range, every combination of them, and results to 50 digits.

Where seeded cases compare one call at a time, these are for calls on arrays of any batch shapes: the results at all
combinations of rows of the arguments are known.
"""

from __future__ import annotations

import itertools
import random
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath

from ...algebra import Vector
from ...maps.chart import Chart
from ..rows import Function, Table
from ..signatures import POSES
from . import digits, exact
from .decimals import DIGITS
from .exact import ALGEBRAIC
from .maps_at import Flat, seeded_arguments
from .point import value
from .screws import half_turns
from .seeded import WIDE, nearby
from .vectors import Vectors, vectors_of

SEED = 131
SIDE = 3
"""Rows of each of two arguments: so many squared are their combinations. A third one has one row."""


@dataclass(frozen=True, slots=True)
class Samples:
    """A function and branch: rows of each argument, and the results at all their combinations, in C order."""

    row: Function
    branch: tuple[int, ...]
    arguments: tuple[tuple[Flat, ...], ...]
    results: tuple[Flat, ...]

    @property
    def function(self) -> str:
        return self.row.name


def samples(chart: Chart, table: Table = POSES, chosen: Container[str] | None = None) -> list[Samples]:
    """Samples of every chosen public function of the module of a chart, on all branches; exact ties among them."""
    rows = _chosen(table, chosen)
    draw = random.Random(SEED)
    with mpmath.workdps(DIGITS):
        at = vectors_of(chart)
        vectors, others = list(_vectors(at, draw)), [_drawn(draw, 2, 6) for _ in range(SIDE)]
        return [*_algebraic(at, rows, vectors, others, others[-1:]), *_inverse(at, table, rows, draw)]


def _chosen(table: Table, chosen: Container[str] | None) -> Mapping[str, Function]:
    """Rows by the function of poses that they are, or are the real part of."""
    return {source: row for source, row in table.sources.items() if chosen is None or row.name in chosen}


def far(chart: Chart, size: Any, table: Table = POSES, chosen: Container[str] | None = None) -> list[Samples]:
    """The functions of a vector v, where Re|v| is that large; a second argument is as usual.

    None where the chart ends before.
    """
    draw, rows = random.Random(SEED), _chosen(table, chosen)
    # the slope of a turn is a difference of terms that are Re|v|² as large
    with mpmath.workdps(DIGITS + 2 * int(mpmath.log10(size))):
        v = (*(mpmath.mpf(size) * c for c in _drawn(draw, 1, 3)), *_drawn(draw, 1, 3))
        at = vectors_of(chart)
        if not at.reaches(Vector(*v[:3]).magnitude()):
            return []
        near = _drawn(draw, float(at.slope(0)), 6)
        given = {"to_screw": (v,), "principal": (v,), "compose": (v, near)}
        inverse = [_at(at, row, (), _columns(row, [given[name]])) for name, row in rows.items() if name in given]
        turned = at.tried[1:2] if "shadow" in rows else ()
        inverse += [_at(at, rows["shadow"], (branch,), _columns(rows["shadow"], [(v,)])) for branch in turned]
        return [*_algebraic(at, rows, [v], *([_drawn(draw, 2, 6)] for _ in range(2))), *inverse]


def _vectors(chart: Vectors, draw: random.Random) -> Iterator[Flat]:
    """Re|v| below the first pole of the inverse operator, beyond it, and no rotation at all."""
    yield _drawn(draw, chart.component(WIDE * chart.slope(0), chart.first_pole), 6)
    yield _drawn(draw, chart.component(2 * WIDE * chart.slope(0), chart.edge), 6)
    yield (mpmath.mpf(0),) * 3 + _drawn(draw, 2, 3)


def _drawn(draw: random.Random, size: float, count: int) -> Flat:
    return tuple(nearby(draw.uniform(-size, size)) for _ in range(count))


def _algebraic(chart: Vectors, rows: Mapping[str, Function], *groups: Sequence[Flat]) -> Iterator[Samples]:
    """Every chosen algebraic function at all combinations of rows; of a point only the first components of its row."""
    for row in (rows[name] for name in ALGEBRAIC if name in rows):
        given = [tuple(values[: kind.size] for values in group) for kind, group in zip(row.arguments, groups)]
        yield _at(chart, row, (), tuple(given))


def _columns(row: Function, calls: Sequence[tuple[Flat, ...]]) -> tuple[tuple[Flat, ...], ...]:
    """The arguments of calls of a function of poses, argument by argument, as another takes them."""
    return tuple(zip(*map(row.restricted, calls), strict=True))


def _inverse(chart: Vectors, table: Table, rows: Mapping[str, Function], draw: random.Random) -> Iterator[Samples]:
    """Inverse maps, screws, shadows and composition at seeded screws, and where sides are exactly tied."""
    given: dict[tuple[str, tuple[int, ...]], list[tuple[Flat, ...]]] = {}
    for name, branch, arguments in seeded_arguments(chart, draw, nearby):
        given.setdefault((name, () if branch is None else (branch,)), []).append(arguments)
    tied: dict[tuple[str, tuple[int, ...]], list[exact.Expectation]] = {}
    for case in digits.restricted(_ties(chart, draw, table), table):
        function, *at = case.function.split()
        tied.setdefault((table.functions[function].source, tuple(map(int, at))), []).append(case)
    # a branch that begins just below half a turn has nothing but ties, which rounding takes across: not replayed
    if unknown := {name for name, _ in tied} - {name for name, _ in given}:
        raise ValueError(f"ties of functions without seeded arguments: {sorted(unknown)}")
    for (name, where), calls in given.items():
        if name not in rows:
            continue
        columns = _columns(rows[name], calls)
        if len(columns) > 1:
            yield _at(chart, rows[name], where, tuple(column[:SIDE] for column in columns))
        else:
            yield _joined(_at(chart, rows[name], where, columns), tied.get((name, where), ()))


def _at(chart: Vectors, row: Function, branch: tuple[int, ...], arguments: tuple[tuple[Flat, ...], ...]) -> Samples:
    calls = itertools.product(*arguments)
    results = tuple(value(chart, row, branch[0] if branch else None, call) for call in calls)
    return Samples(row, branch, arguments, results)


def _joined(found: Samples, ties: Iterable[exact.Expectation]) -> Samples:
    rows = (*found.arguments[0], *(case.arguments[0] for case in ties))
    return Samples(found.row, found.branch, (rows,), (*found.results, *(case.result for case in ties)))


def _ties(chart: Vectors, draw: random.Random, table: Table) -> Iterator[exact.Expectation]:
    halves = list(half_turns(draw))
    for branch in chart.tried:
        yield from digits.at_half_turns(chart, halves, branch)
    yield from digits.undecided(chart, table)
