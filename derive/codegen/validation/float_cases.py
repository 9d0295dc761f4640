"""Seeded cases in floating-point numbers, for replays on floats and for differential tests of compiled code.

Arguments are exact floats or numbers that round to floats. Expected results come from the formula to 50 digits. Each
real or dual part of a result has an error scale: its norm or, if larger, a sum of norms of derivative times value.
Inverse maps have one term for each component. Forward maps are linear in dual components, and have one sum over these
and one over all further arguments, each as a whole. A vector computed from an angle also has a term for the angle.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import mpmath

from ...algebra import Vector
from ...maps.chart import Chart
from ...maps.pose import Screw, polar, pose_from_tensor, quaternion_from_screw, tensor_from_screw
from ..lowered import geometry
from ..rows import Function, Table
from ..signatures import POSES
from .decimals import DIGITS
from .formulas import ALGEBRAIC, arguments_of, rows_of_pose
from .inverse_maps import value
from .screws import covering
from .vectors import Flat, Vectors, flat, vectors_of

SEED = 88
POINTS = 3
STEP = mpmath.mpf(2) ** -80

COMPONENT_MAX = 3
"""Largest component of v, divided by φ′(0)."""

GRID = 2**18
"""Grid steps of arguments per unit: few enough for float32 to hold arguments exactly."""

SMALL = 2.0**-8
"""Size of the small quaternion components: their rows of 4 q qᵀ lose 16 bits."""

ORDINARY = 4
"""Number of screws for derivatives: the first ones from `covering`, which are far from every selection."""

JACOBIANS = ("compose_jacobians", "between_jacobians", "retract_jacobians", "body_retract_jacobians")

SHORTER = 2
"""Divisor of steps whose Jacobians are tested: near the edge, Jacobians amplify the rounding of α."""

EDGE_MARGIN = 0.1
"""Least margin to the edge, as defined by `Vectors.finite`: its inverse amplifies the rounding of the principal v."""


@dataclass(frozen=True)
class Case:
    """Function call with its arguments and branch, and the result by the formula."""

    chart: Vectors
    row: Function
    branch: int | None
    arguments: tuple[Flat, ...]

    @property
    def function(self) -> str:
        return self.row.name

    @cached_property
    def result(self) -> Flat:
        with mpmath.workdps(DIGITS):
            return value(self.chart, self.row, self.branch, self.arguments)

    @cached_property
    def scales(self) -> tuple[float, ...]:
        """Error scale of each part of the result."""
        row = self.row
        places = [(i, j) for i, array in enumerate(row.arguments) for j in range(array.size)]
        with mpmath.workdps(DIGITS):
            single = [self._moved(i, [j]) for i, j in places if row.arguments[i].part_of[j] or not row.exact]
            whole = [self._moved(i, range(array.size)) for i, array in enumerate(row.arguments) if i and row.exact]
            ways = ([self.result], single, whole, self._by_angle())
            owners = [(place, part) for place, array in enumerate(row.results) for part in array.part_of]

            def norm(values: Flat, owner: tuple[int, int]) -> Any:
                return mpmath.sqrt(sum(c * c for c, other in zip(values, owners, strict=True) if other == owner))

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
        if "coefficient" not in {call.function for call in geometry()[pose.kernel].calls} or pose.shape != (6,):
            return []
        extent, axis = polar(Vector.dual(result[:3], result[3:] or (mpmath.mpf(0),) * 3))
        there = self.row.part(flat(axis * self.chart.size(self.chart.angle(extent) * (1 + STEP))))
        return [tuple((b - a) / STEP for a, b in zip(result, there, strict=True))]


Call = tuple[str, int | None, tuple[Flat, ...]]
"""Name of a pose function, branch and arguments."""


@lru_cache(maxsize=8)
def cases(chart: Chart, table: Table = POSES) -> Sequence[Case]:
    """Return cases of every function of a table, in the order of its rows."""
    with mpmath.workdps(DIGITS):
        at = vectors_of(chart)
        calls = ((table.sources.get(name), branch, given) for name, branch, given in _calls(at, random.Random(SEED)))
        found = [Case(at, row, branch, row.restricted(given)) for row, branch, given in calls if row]
        found = [case for case in found if all(map(mpmath.isfinite, case.result))]  # no v beyond an early edge
    names = list(table.functions)
    return tuple(sorted(found, key=lambda case: names.index(case.function)))


def nearby(value: Any) -> Any:
    """Return the nearest number on the grid of floats, a multiple of 1/`GRID`."""
    return mpmath.mpf(int(mpmath.nint(value * GRID))) / GRID


def _short(values: Flat) -> Flat:
    return tuple(map(nearby, values))


def _calls(chart: Vectors, draw: random.Random) -> Iterator[Call]:
    """Yield calls at seeded vectors, with Re|v| well below the first singular point, and at seeded screws."""
    size = chart.component(COMPONENT_MAX * chart.slope(0), chart.first_pole)
    for _ in range(POINTS):
        drawn = [tuple(nearby(draw.uniform(-most, most)) for _ in range(6)) for most in (size, 2, 2)]
        for name in ALGEBRAIC:
            yield name, None, arguments_of(POSES.functions[name], drawn)
    screws = list(covering(draw, SMALL))
    for screw, other in zip(screws, [*screws[1:], screws[0]], strict=True):
        v, v2 = (_short(flat(chart.at(s))) for s in (screw, other))
        delta = tuple(nearby(draw.uniform(-1, 1)) for _ in range(6))
        yield "from_screw", None, (_short((screw.angle.re, screw.angle.du)), _short(flat(screw.axis)))
        for name in ("to_screw", "angle", "to_exponential", "principal"):
            yield name, None, (v,)
        yield "from_exponential", None, (_short(flat(screw.axis * screw.angle)),)
        yield "interpolate", None, (v, v2, (nearby(draw.uniform(0, 1)),))
        derivatives = screw in screws[:ORDINARY]
        for name in ("compose", "between", "local", "body_local", *JACOBIANS[:2] * derivatives):
            yield name, None, (v2, v)
        for name in ("retract", "body_retract"):
            yield name, None, (v, delta)
        for name in JACOBIANS[2:] * derivatives:
            yield name, None, (v, tuple(nearby(c / SHORTER) for c in delta))
        yield from _on_branch(screw, 0, v)
    for branch in chart.tried[1:]:
        turned = screws[branch % len(screws) :] + screws
        for screw in [s for s in turned if chart.finite(s, branch, EDGE_MARGIN)][:1]:  # perhaps none
            v, v_k = (_short(flat(chart.at(screw, k))) for k in (0, branch))
            yield from _on_branch(screw, branch, v)
            for name in ("principal", "to_screw", "angle", "to_exponential"):
                yield name, None, (v_k,)
            yield "shadow", chart.back(branch), (v_k,)


def _on_branch(screw: Screw, k: int, v: Flat) -> Iterator[Call]:
    q, R = flat(quaternion_from_screw(screw)), tensor_from_screw(screw)
    yield "from_quaternion", k, (q,)
    yield "from_quaternion", k, (tuple(-c for c in q),)
    yield "from_tensor", k, (flat(R),)
    yield "from_pose", k, (rows_of_pose(pose_from_tensor(R)),)
    for name in ("shadow", "shadow_jacobian"):
        yield name, k, (v,)
