"""Cases for a replay on floats: arguments in floats' range, every combination of them, and results to 50 digits.

Where seeded cases compare one call at a time, these are for calls on arrays of any batch shapes: the results at all
combinations of rows of the arguments are known.
"""

from __future__ import annotations

import itertools
import random
from collections.abc import Container, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath

from ...algebra import Vector
from ...maps.chart import Chart
from ..signatures import FUNCTIONS
from . import digits, exact
from .exact import ALGEBRAIC
from .maps_at import Flat, seeded_arguments
from .point import value
from .screws import half_turns
from .seeded import WIDE, nearby
from .vectors import Vectors

SEED = 131
SIDE = 3
"""Rows of each of two arguments: so many squared are their combinations. A third one has one row."""


@dataclass(frozen=True, slots=True)
class Samples:
    """A function and branch: rows of each argument, and the results at all their combinations, in C order."""

    function: str
    branch: tuple[int, ...]
    arguments: tuple[tuple[Flat, ...], ...]
    results: tuple[Flat, ...]


def samples(chart: Chart, chosen: Container[str] = FUNCTIONS) -> list[Samples]:
    """Samples of every chosen public function of the module of a chart, on all branches; exact ties among them."""
    draw = random.Random(SEED)
    with mpmath.workdps(digits.DIGITS):
        at = Vectors(chart)
        vectors, others = list(_vectors(at, draw)), [_drawn(draw, 2, 6) for _ in range(SIDE)]
        return [*_algebraic(at, chosen, vectors, others, others[-1:]), *_inverse(at, chosen, draw)]


def far(chart: Chart, size: Any, chosen: Container[str] = FUNCTIONS) -> list[Samples]:
    """The functions of a vector v, where Re|v| is that large; a second argument is as usual.

    None where the chart ends before.
    """
    draw = random.Random(SEED)
    # the slope of a turn is a difference of terms that are Re|v|² as large
    with mpmath.workdps(digits.DIGITS + 2 * int(mpmath.log10(size))):
        v = (*(mpmath.mpf(size) * c for c in _drawn(draw, 1, 3)), *_drawn(draw, 1, 3))
        at = Vectors(chart)
        if not at.reaches(Vector(*v[:3]).magnitude()):
            return []
        near = _drawn(draw, float(at.slope(0)), 6)
        given = {"to_screw": ((v,),), "principal": ((v,),), "compose": ((v,), (near,))}
        inverse = [_at(at, name, (), rows) for name, rows in given.items() if name in chosen]
        turned = at.tried[1:2] if "shadow" in chosen else ()
        inverse += [_at(at, "shadow", (branch,), ((v,),)) for branch in turned]
        return [*_algebraic(at, chosen, [v], *([_drawn(draw, 2, 6)] for _ in range(2))), *inverse]


def _vectors(chart: Vectors, draw: random.Random) -> Iterator[Flat]:
    """Re|v| below the first pole of the inverse operator, beyond it, and no rotation at all."""
    yield _drawn(draw, chart.component(WIDE * chart.slope(0), chart.first_pole), 6)
    yield _drawn(draw, chart.component(2 * WIDE * chart.slope(0), chart.edge), 6)
    yield (mpmath.mpf(0),) * 3 + _drawn(draw, 2, 3)


def _drawn(draw: random.Random, size: float, count: int) -> Flat:
    return tuple(nearby(draw.uniform(-size, size)) for _ in range(count))


def _algebraic(chart: Vectors, chosen: Container[str], *groups: Sequence[Flat]) -> Iterator[Samples]:
    """Every chosen algebraic function at all combinations of rows; of a point only the first components of its row."""
    for name in filter(chosen.__contains__, ALGEBRAIC):
        given = [tuple(row[: kind.size] for row in group) for kind, group in zip(FUNCTIONS[name].arguments, groups)]
        yield _at(chart, name, (), tuple(given))


def _inverse(chart: Vectors, chosen: Container[str], draw: random.Random) -> Iterator[Samples]:
    """Inverse maps, screws, shadows and composition at seeded screws, and where sides are exactly tied."""
    given: dict[tuple[str, tuple[int, ...]], list[tuple[Flat, ...]]] = {}
    for name, branch, arguments in seeded_arguments(chart, draw, nearby):
        given.setdefault((name, () if branch is None else (branch,)), []).append(arguments)
    tied: dict[tuple[str, tuple[int, ...]], list[exact.Expectation]] = {}
    for case in _ties(chart, draw):
        function, *at = case.function.split()
        tied.setdefault((function, tuple(map(int, at))), []).append(case)
    if unknown := tied.keys() - given.keys():
        raise ValueError(f"ties of functions without seeded arguments: {sorted(unknown)}")
    for (name, where), calls in given.items():
        if name not in chosen:
            continue
        columns = tuple(zip(*calls, strict=True))
        if len(columns) > 1:
            yield _at(chart, name, where, tuple(column[:SIDE] for column in columns))
        else:
            yield _joined(_at(chart, name, where, columns), tied.get((name, where), ()))


def _at(chart: Vectors, name: str, branch: tuple[int, ...], arguments: tuple[tuple[Flat, ...], ...]) -> Samples:
    results = (value(chart, name, branch[0] if branch else None, row) for row in itertools.product(*arguments))
    return Samples(name, branch, arguments, tuple(results))


def _joined(found: Samples, ties: Iterable[exact.Expectation]) -> Samples:
    rows = (*found.arguments[0], *(case.arguments[0] for case in ties))
    return Samples(found.function, found.branch, (rows,), (*found.results, *(case.result for case in ties)))


def _ties(chart: Vectors, draw: random.Random) -> Iterator[exact.Expectation]:
    halves = list(half_turns(draw))
    for branch in chart.tried:
        yield from digits.at_half_turns(chart, halves, branch)
    yield from digits.undecided(chart)
