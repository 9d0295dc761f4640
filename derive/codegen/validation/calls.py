"""Calls of kernel functions with their expected results: the one list from which every execution draws.

The table of functions states the arguments of each function, hence their kind. Arguments are drawn by kind, in several
regimes, and every function that takes the kind is called on them: on exact numbers, on floats and in compiled code.
Algebraic functions take seeded vectors instead, as their results select nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property, partial
from random import Random
from typing import Any, NamedTuple, TypeVar

from ...algebra import Tensor
from ...algebra.pose import Screw, is_zero, pose_from_tensor, quaternion_from_screw, tensor_from_screw
from ..rows import BY_TEXT, RULE, Function, Table
from ..signatures import JACOBIAN, POSES
from . import reals
from .decimals import EXACT_DIGITS
from .expected_values import ALGEBRAIC, arguments_of, rows_of_pose
from .inverse_maps import MAPS, value
from .reals import Real
from .vectors import Flat, Vectors, flat


class Kind(StrEnum):
    """Arguments that are drawn together, by their names in the table of functions."""

    QUATERNION, TENSOR, POSE = "q branch", "R branch", "T branch"
    SCREW, LOGARITHM = "angle line", "w"
    VECTOR, TURN = "v", "v branch"
    PAIR, STEP, WAY = "v2 v1", "v delta", "v1 v2 t"


class Drawn(NamedTuple):
    """Arguments of a kind. Jacobians are called on ``regular`` ones, functions ``without`` a definite value are not."""

    kind: Kind
    arguments: tuple[Flat, ...]
    branch: int | None = None
    regular: bool = False
    without: Collection[str] = ()


@dataclass(frozen=True)
class Case:
    """Call of a kernel function: flat arguments, a branch or None, and the expected result, computed once."""

    row: Function
    branch: int | None
    arguments: tuple[Flat, ...]
    compute: Callable[[], Flat]

    @property
    def function(self) -> str:
        return self.row.name

    @cached_property
    def result(self) -> Flat:
        with reals.digits(EXACT_DIGITS):
            return self.compute()


def kind_of(row: Function) -> str:
    """Return the names of the arguments that the function of poses takes, and ``branch`` if it takes one."""
    return " ".join([array.name for array in (row.pose or row).arguments] + ["branch"] * row.branch)


def require_calls(table: Table) -> None:
    """Raise ValueError for a function without expected value, arguments that are drawn, or decision on derivatives."""
    rows, known, kinds = table.public.items(), {*ALGEBRAIC, *MAPS}, set(Kind)
    require("an expected value", table.public, (name for name, row in rows if row.source in known))
    drawn = (name for name, row in rows if row.source in ALGEBRAIC or kind_of(row) in kinds)
    require("arguments that are drawn", table.public, drawn)
    decided = (name for name, row in table.kernels.items() if row.derivatives.startswith((RULE, BY_TEXT)))
    require("a decision on derivatives", table.kernels, decided)


def require(what: str, names: Iterable[str], found: Iterable[str]) -> None:
    """Raise ValueError with the names of the functions that are not found."""
    if missing := sorted(set(names) - set(found)):
        raise ValueError(f"functions without {what} cannot be generated: {', '.join(missing)}")


C = TypeVar("C", bound="Case")


def grouped(cases: Iterable[C]) -> list[tuple[tuple[int, ...], tuple[C, ...]]]:
    """Return the cases of each function and branch, with the branch, empty for a call without."""
    found: dict[tuple[str, int | None], list[C]] = {}
    for case in cases:
        found.setdefault((case.function, case.branch), []).append(case)
    return [(() if k is None else (k,), tuple(group)) for (_, k), group in found.items()]


def selecting(chart: Vectors, drawn: Iterable[Drawn]) -> Iterator[Case]:
    """Yield the calls of all functions of poses that select a branch or an angle on drawn arguments."""
    rows = [row for row in POSES.public.values() if row.name in MAPS]
    for kind, given, branch, regular, without in drawn:
        arguments = tuple(map(reals.exact, given))
        for row in rows:
            derivative = row.results[0].shape == JACOBIAN.shape
            if kind_of(row) == kind and row.name not in without and (regular or not derivative):
                yield Case(row, branch, arguments, partial(value, chart, row, branch, arguments))


def algebraic(chart: Vectors, points: Sequence[Sequence[Flat]]) -> Iterator[Case]:
    """Yield the calls of all algebraic functions of poses; each point has the components of three arguments."""
    for row in (row for row in POSES.public.values() if row.name in ALGEBRAIC):
        for given in (tuple(map(reals.exact, arguments_of(row, point))) for point in points):
            yield Case(row, None, given, partial(value, chart, row, None, given))


def restricted(cases: Iterable[Case], table: Table) -> Iterator[Case]:
    """Yield calls of functions of poses as calls of a table, each once: functions of rotations map the real parts."""
    seen = set()
    for case in cases:
        row = table.sources.get(case.function)
        given = row.restricted(case.arguments) if row else ()
        if row and (key := (row.name, case.branch, reals.key(given))) not in seen:
            seen.add(key)
            yield Case(row, case.branch, given, partial(lambda row, case: row.part(case.result), row, case))


def at_screw(
    chart: Vectors, screw: Screw, branch: int, short: Callable[[Iterable[Any]], Flat] = tuple, regular: bool = True
) -> Iterator[Drawn]:
    """Yield the quaternions, matrices and ``short`` vectors of a pose, with v on a branch and the way back."""
    q, v, there = flat(quaternion_from_screw(screw)), *(short(flat(chart.at(screw, k))) for k in (0, branch))
    yield Drawn(Kind.QUATERNION, (q,), branch)
    yield Drawn(Kind.QUATERNION, (tuple(-c for c in q),), branch or None)  # None is the default of the interface
    yield from of_tensor(tensor_from_screw(screw), branch)
    yield Drawn(Kind.TURN, (v,), branch, regular)
    decided = not branch or not is_zero(screw.angle.re)  # else w = 0 up to rounding, and the axis has either sign
    yield Drawn(Kind.VECTOR, (there,), without=() if decided else ("to_screw",))
    yield from [Drawn(Kind.TURN, (there,), chart.back(branch))] * decided
    if not branch:
        yield Drawn(Kind.SCREW, (short((screw.angle.re, screw.angle.du)), short(flat(screw.axis))))
        yield Drawn(Kind.LOGARITHM, (short(flat(screw.axis * screw.angle)),))


def of_tensor(R: Tensor, branch: int) -> Iterator[Drawn]:
    """Yield the orthogonal dual tensor of a pose and its homogeneous matrix."""
    yield Drawn(Kind.TENSOR, (flat(R),), branch)
    yield Drawn(Kind.POSE, (rows_of_pose(pose_from_tensor(R)),), branch)


def of_composed(
    chart: Vectors, table: Table, draw: Random, screws: Sequence[Screw], least: float, short: Callable[..., Flat]
) -> Iterator[Case]:
    """Yield calls of the functions that Python composes: on all branches and at 0, with symmetric matrices."""
    there = ((chart.tried[i % len(chart.tried)], screw) for i, screw in enumerate(screws))
    vectors = [short(flat(chart.at(screw, k))) for k, screw in there if chart.finite(screw, k, least)]
    for v in (*vectors, short(6 * [Real(0)])):
        v_dot, entries = (short([Real(draw.uniform(-1, 1)) for _ in range(size)]) for size in (6, 36))
        spread = tuple(entries[6 * min(i, j) + max(i, j)] for i in range(6) for j in range(6))
        for row in table.composed.values():
            arguments = row.restricted(tuple(map(reals.exact, (v, v_dot, spread))))
            yield Case(row, None, arguments, partial(value, chart, row, None, arguments))
