"""Seeded cases in floating-point numbers, for replays on floats and for differential tests of compiled code.

Arguments are exact floats or numbers that round to floats. Expected results come from the formula to 50 digits. Each
real or dual part of a result has an error scale: its norm or, if larger, a sum of norms of derivative times value.
Inverse maps have one term for each component. Forward maps are linear in dual components, and have one sum over these
and one over all further arguments, each as a whole. A vector computed from an angle also has a term for the angle.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial
from typing import Any

from ...algebra import Vector
from ...algebra.pose import polar
from ...maps.chart import Chart
from ..rows import Table
from ..signatures import POSES, geometry
from . import reals
from .calls import Case, Drawn, Kind, algebraic, at_screw, of_composed, require, restricted, selecting
from .decimals import EXACT_DIGITS
from .inverse_maps import value
from .reals import Real, nearest
from .screws import covering
from .vectors import Flat, Vectors, flat, vectors_of

SEED = 88
POINTS = 3
STEP = Real(2) ** -80
COMPONENT_MAX = 3  # largest component of v, divided by φ′(0)
GRID = 2**18  # grid steps of arguments per unit: few enough for float32 to hold arguments exactly
SMALL = 2.0**-8  # size of the small quaternion components: their rows of 4 q qᵀ lose 16 bits
ORDINARY = 2  # number of screws for derivatives: the first ones from `covering`, which are far from every selection
SHORTER = 2  # divisor of steps whose Jacobians are tested: near the edge, Jacobians amplify the rounding of α
EDGE_MARGIN = 0.1  # least margin to the edge (`Vectors.finite`): its inverse amplifies the rounding of v


@dataclass(frozen=True)
class FloatCase(Case):
    """Call in floats, with the error scales of its result in a chart."""

    chart: Vectors

    @property
    def finite(self) -> bool:
        """Tell whether the result is finite; a vector beyond an early edge is not."""
        return all(Real(c).is_finite() for c in self.result)

    @cached_property
    def scales(self) -> tuple[float, ...]:
        """Error scale of each part of the result."""
        row = self.row
        places = [(i, j) for i, array in enumerate(row.arguments) for j in range(array.size)]
        with reals.digits(EXACT_DIGITS):
            single = [self._moved(i, [j]) for i, j in places if row.arguments[i].part_of[j] or not row.exact]
            whole = [self._moved(i, range(array.size)) for i, array in enumerate(row.arguments) if i and row.exact]
            ways = ([self.result], single, whole, self._by_angle())
            owners = [(place, part) for place, array in enumerate(row.results) for part in array.part_of]

            def norm(values: Flat, owner: tuple[int, int]) -> Any:
                squares = sum(c * c for c, other in zip(values, owners, strict=True) if other == owner)
                return Real(squares).mid().sqrt()  # of a ball that touches 0, flint has no root

            sums = ([sum(norm(step, owner) for step in steps) for steps in ways] for owner in dict.fromkeys(owners))
            return tuple(float(max(found)) for found in sums)

    def _moved(self, place: int, components: Sequence[int]) -> Flat:
        """Return ``Σ c · ∂result/∂c`` over some components c of an argument."""
        given = self.arguments
        stepped = tuple(c * (1 + STEP) if j in components else c for j, c in enumerate(given[place]))
        there = value(self.chart, self.row, self.branch, [*given[:place], stepped, *given[place + 1 :]])
        return tuple((b - a) / STEP for a, b in zip(self.result, there, strict=True))

    def _by_angle(self) -> list[Flat]:
        """Return the derivative of a vector by its angle, times the angle; empty if no angle is computed."""
        pose, result = self.row.pose or self.row, self.result
        if pose.shape != (6,) or "coefficient" not in {call.function for call in geometry()[pose.kernel].calls}:
            return []
        extent, axis = polar(Vector.dual(result[:3], result[3:] or (Real(0),) * 3))
        there = self.row.part(flat(axis * self.chart.size(self.chart.angle(extent) * (1 + STEP))))
        return [tuple((b - a) / STEP for a, b in zip(result, there, strict=True))]


def cases(chart: Chart, table: Table = POSES) -> Sequence[FloatCase]:
    """Return calls of every public function with finite results; raise ValueError if a function has none."""
    found = tuple(case for case in drawn(chart, table) if case.finite)
    require("a call in floats", table.public, (case.function for case in found))
    return found


@lru_cache(maxsize=8)
def drawn(chart: Chart, table: Table = POSES, names: frozenset[str] | None = None) -> Sequence[FloatCase]:
    """Return calls of every public function, or of the named ones, in the order of rows; no result is computed."""
    order, wanted = list(table.functions), table.public.keys() if names is None else names
    with reals.digits(EXACT_DIGITS):
        at = vectors_of(chart)
        chosen = (case for case in restricted(_seeded(at), table) if case.function in wanted)
        computed = ((c, partial(value, at, c.row, c.branch, c.arguments)) for c in chosen)  # a rotated point, not moved
        found = [FloatCase(c.row, c.branch, c.arguments, compute, at) for c, compute in computed]
    return tuple(sorted(found, key=lambda case: order.index(case.function)))


def composed(chart: Chart, table: Table = POSES) -> Sequence[FloatCase]:
    """Return calls of the functions that Python composes, which C has as programs."""
    with reals.digits(EXACT_DIGITS):
        at, draw = vectors_of(chart), random.Random(SEED)
        found = of_composed(at, table, draw, list(covering(draw, SMALL))[:ORDINARY], EDGE_MARGIN, _short)
        return [FloatCase(c.row, c.branch, c.arguments, c.compute, at) for c in found]


@lru_cache(maxsize=1)  # the table of rotations reuses the calls of poses
def _seeded(chart: Vectors) -> tuple[Case, ...]:
    draw = random.Random(SEED)
    size = chart.component(COMPONENT_MAX * chart.slope(0), chart.first_pole)
    points = [[_short(draw.uniform(-most, most) for _ in range(6)) for most in (size, 2, 2)] for _ in range(POINTS)]
    for angle in chart.chart.steep[:1]:
        points.append([_short(c * chart.size(Real(angle)) / 3 for c in (1, -2, 2)) + points[0][0][3:], *points[0][1:]])
    return (*algebraic(chart, points), *selecting(chart, _drawn(chart, draw)))


def _short(values: Iterable[Any]) -> Flat:
    """Return the nearest numbers on the grid of floats, the multiples of 1/`GRID`."""
    return tuple(Real(nearest(value * GRID)) / GRID for value in values)


def _drawn(chart: Vectors, draw: random.Random) -> Iterator[Drawn]:
    """Yield arguments at seeded screws on the principal branch, and at one of them on each other branch."""
    screws = list(covering(draw, SMALL))
    for place, (screw, other) in enumerate(zip(screws, [*screws[1:], screws[0]], strict=True)):
        regular, (v, v2) = place < ORDINARY, (_short(flat(chart.at(s))) for s in (screw, other))
        delta = _short(draw.uniform(-1, 1) for _ in range(6))
        yield from at_screw(chart, screw, 0, _short)
        yield Drawn(Kind.PAIR, (v2, v), regular=regular)
        yield Drawn(Kind.STEP, (v, delta))
        yield from [Drawn(Kind.STEP, (v, _short(c / SHORTER for c in delta)), regular=True)] * regular
        yield Drawn(Kind.WAY, (v, v2, _short([draw.uniform(0, 1)])))
    for branch in chart.tried[1:]:
        turned = screws[branch % len(screws) :] + screws
        for screw in [s for s in turned if chart.finite(s, branch, EDGE_MARGIN)][:1]:  # perhaps none
            yield from at_screw(chart, screw, branch, _short)
