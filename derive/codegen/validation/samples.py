"""Seeded cases of a chart with expected values to 50 digits, which cover all sides of every selection."""

from __future__ import annotations

import itertools
import random
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import lru_cache, partial
from typing import Any

import mpmath

from ...algebra import Dual, Tensor, Vector
from ...maps.chart import Chart
from ...maps.pose import (
    Pose,
    Screw,
    orientation,
    pose_from_tensor,
    quaternion_from_screw,
    tensor_from_pose,
    tensor_from_screw,
)
from ..rows import Function, Table
from ..signatures import POSES
from .decimals import DIGITS
from .formulas import ALGEBRAIC, Expectation, arguments_of, rows_of_pose
from .inverse_maps import MAPS, reached, value
from .screws import covering, half_turns, steep, translation
from .vectors import Flat, Vectors, flat, is_whole, vectors_of

SEED = 2011

SMALL = 1e-21 / 7
"""Size of the small quaternion components: their rows of 4 q qᵀ keep 28 digits.

The factor 1/7 prevents sums from being exact."""

SMALL_AT_EDGE = 1e-10 / 7
"""Size of the small components in charts with edge π: a smaller scalar part would be too near the edge."""

EDGE_MARGIN = 1e-12
"""Least margin to the edge, as defined by `Vectors.finite`: nearer vectors are too ill-conditioned to compare."""

JACOBIAN_MARGIN = 0.1
"""Least margin to the edge for Jacobians, whose conditioning is worse by one power of the margin."""

NEAR_TIE = mpmath.mpf(10) ** -30
"""Angle between a vector and the limit of its branch, in the cases nearest to the limit."""

LATTICE = ((1, 0, 0), (0, -1, 0), (1, 1, 1), (-1, 1, -1), (1, -1, 0))
"""Directions of vectors whose v·v needs no rounding: scalars of a chart vanish exactly at some of them."""

SIZES = ("1e-25", "1e-9", "0.003", "0.3", "0.7", "0.97")
"""Angles of seeded vectors, divided by the first singular angle: some in the range of the series, some beyond it."""

SMALL_STEP = tuple(mpmath.mpf(c) / 64 for c in (1, -2, 2, 1, 0, 3))
"""Step that stays on the branch of its vector."""
STEPS = tuple(tuple(mpmath.mpf(size * c) for c in (1, -2, 2, 1, 0, 3)) for size in (0.25, 0.8125, 2, 3))
"""Steps in the range of the series of the exponential, where its last terms weigh most, and steps beyond it."""

POLE_DISTANCE = mpmath.mpf(1) / 64
"""Distance in angle from the edge, small enough for `SMALL_STEP` to cross the edge in one direction."""

STEP_NAMES, STEP_JACOBIANS = ("retract", "body_retract"), ("retract_jacobians", "body_retract_jacobians")


def _computed(function: Callable[..., Flat], *arguments: Any) -> Flat:
    """Return the value of a function, computed with 50 digits."""
    with mpmath.workdps(DIGITS):
        return function(*arguments)


def _by(chart: Vectors, name: str, *arguments: Flat) -> Expectation:
    """Return the case of a map at given arguments; ``name`` is the map, followed by a space and the branch if any."""
    function, branch = (*name.split(), "0")[:2]
    return Expectation(name, arguments, partial(_computed, MAPS[function], chart, int(branch), *arguments))


def margin(chart: Vectors) -> float:
    """Return the least margin to the edge; wider if φ′ = 0 there, since scalars then grow like (1/margin)³."""
    return float(EDGE_MARGIN ** (1 / 3)) if chart.is_folded else EDGE_MARGIN


def by_function(chart: Chart, table: Table) -> Iterator[tuple[Expectation, ...]]:
    """Yield the cases of all inverse maps, screws, shadows and group functions, one tuple for each branch."""
    found: dict[str, list[Expectation]] = {}
    at = vectors_of(chart)
    for case in _restricted((*_seeded(at), *_undecided(at, table)), table):
        found.setdefault(case.function, []).append(case)
    yield from map(tuple, found.values())


def _restricted(cases: Iterable[Expectation], table: Table) -> Iterator[Expectation]:
    """Yield cases of poses in the form that the functions of a table take.

    Functions of rotations take the real parts. Only the first of several cases with equal real parts is kept.
    """
    seen = set()
    for case in cases:
        source, *branch = case.function.split()
        if table is POSES:
            yield case
        elif row := table.sources.get(source):
            function, arguments = " ".join((row.name, *branch)), row.restricted(case.arguments)
            if (function, arguments) not in seen:
                seen.add((function, arguments))
                yield Expectation(function, arguments, partial(_part, row, case))


def _part(row: Function, case: Expectation) -> Flat:
    return row.part(case.result)


@lru_cache(maxsize=1)  # the table of rotations reuses the cases of poses
def _seeded(chart: Vectors) -> tuple[Expectation, ...]:
    return tuple(_cases(chart, random.Random(SEED)))


def _cases(chart: Vectors, draw: random.Random) -> Iterator[Expectation]:
    """Yield cases at all screws and exact half turns on the principal branch, and at some of them on other branches."""
    yield from _identity(chart)
    small = SMALL if chart.edge > mpmath.pi else SMALL_AT_EDGE
    screws, halves = list(covering(draw, small)), list(half_turns(draw))
    still, other_still = translation(draw), translation(draw)
    given = [screw for screw in (*screws, still, other_still) if chart.finite(screw, 0, margin(chart))]
    for screw, other in zip(given, [*given[1:], given[0]]):
        yield from _principal(chart, screw, other)
    for branch in chart.tried:
        some = [screws[3 * branch % 8]] if branch else [*screws, still]
        # on another branch a translation has w = 0 up to rounding, so the sign of its axis is undefined
        for screw in (*some, still) if branch else some:
            if chart.finite(screw, branch, margin(chart)):
                yield from _branch(chart, screw, branch)
                yield from _back(chart, screw, branch) if screw in some else ()
        yield from _half_turns(chart, halves, branch)
    for screw in steep(draw, small, 1 / 3):
        if chart.finite(screw, 0, margin(chart)):
            yield from _from_rotation(tensor_from_screw(screw), 0, flat(chart.at(screw)))
    yield from _far_steps(chart, screws[0], still)
    yield from _steps_to_pole(chart, screws[0])
    yield from _near_ties(chart, screws[0])


def _principal(chart: Vectors, screw: Screw, other: Screw) -> Iterator[Expectation]:
    """Yield cases of maps of one or two vectors that take no branch argument."""
    principal = chart.at(screw)
    yield Expectation("from_screw", ((screw.angle.re, screw.angle.du), flat(screw.axis)), flat(principal))
    q = quaternion_from_screw(screw)
    yield Expectation("from_quaternion", (tuple(-c for c in flat(q)),), flat(principal))
    product = quaternion_from_screw(other) * q
    vectors = (flat(chart.at(other)), flat(principal))
    yield from _coordinates(chart, screw)
    yield Expectation("compose", vectors, flat(chart.of_quaternion(product)))
    for name in ("between", "local", "body_local", *STEP_NAMES):  # any dual vector is a step
        yield _by(chart, name, *vectors)
    further = Screw(screw.angle / 3, screw.axis)  # on the same axis: interpolation through whole turns
    for end, t in ((other, "0.3"), (screw, "0.7"), (further, "0.8"), (further, "-4.3")):
        yield _by(chart, "interpolate", flat(principal), flat(chart.at(end)), (mpmath.mpf(t),))
    if all(chart.finite(s, 0, JACOBIAN_MARGIN) for s in (screw, other)):
        for name in ("compose_jacobians", "between_jacobians", *STEP_JACOBIANS):
            yield _by(chart, name, *vectors)


def _coordinates(chart: Vectors, screw: Screw) -> Iterator[Expectation]:
    """Yield cases of ``to_exponential``, and of ``from_exponential`` with whole turns added to the angle."""
    yield _by(chart, "to_exponential", flat(chart.at(screw)))
    beyond = 3 if mpmath.isinf(chart.edge) else int(chart.edge / (2 * mpmath.pi)) + 1
    for turns in (0, 1, beyond):
        angle = screw.angle + 2 * mpmath.pi * turns
        if chart.finite(Screw(reached(chart, angle), screw.axis), 0, JACOBIAN_MARGIN):
            yield _by(chart, "from_exponential", flat(screw.axis * angle))


def _back(chart: Vectors, screw: Screw, branch: int) -> Iterator[Expectation]:
    """Yield cases that lead from v on a branch, perhaps opposite to the axis, to its screw and its principal v."""
    v = flat(chart.at(screw, branch))
    yield Expectation("to_screw", (v,), (screw.angle.re, screw.angle.du, *flat(screw.axis)))
    yield Expectation(f"shadow {chart.back(branch)}", (v,), flat(chart.at(screw)))
    if branch:
        yield _by(chart, "interpolate", v, MAPS["retract"](chart, 0, v, SMALL_STEP), (mpmath.mpf("0.5"),))


def _branch(chart: Vectors, screw: Screw, branch: int) -> Iterator[Expectation]:
    v, principal = flat(chart.at(screw, branch)), flat(chart.at(screw))
    yield Expectation(f"from_quaternion {branch}", (flat(quaternion_from_screw(screw)),), v)
    yield from _from_rotation(tensor_from_screw(screw), branch, v)
    yield Expectation(f"shadow {branch}", (principal,), v)
    yield Expectation("principal", (v,), principal)
    for name in ("angle", "to_exponential"):
        yield _by(chart, name, v)
    if screw.angle.re > JACOBIAN_MARGIN and all(chart.finite(screw, k, JACOBIAN_MARGIN) for k in (0, branch)):
        yield _by(chart, f"shadow_jacobian {branch}", principal)
    for name in (*STEP_NAMES, *STEP_JACOBIANS) if branch else ():
        yield _by(chart, name, v, SMALL_STEP)


def _from_rotation(R: Tensor, branch: int, v: Flat) -> Iterator[Expectation]:
    yield Expectation(f"from_tensor {branch}", (flat(R),), v)
    yield Expectation(f"from_pose {branch}", (rows_of_pose(pose_from_tensor(R)),), v)


def _half_turns(chart: Vectors, screws: Sequence[Screw], branch: int) -> Iterator[Expectation]:
    """Yield cases at exact half turns: all half turns on the principal branch, one on each other branch.

    Axes u and −u then give one rotation, the scalar part is exactly 0, and the rotation matrix is symmetric. Maps from
    quaternions keep the sign of the vector part; maps from matrices make its first non-zero component positive.
    """
    for screw in [screws[branch % len(screws)]] if branch else screws:
        if not chart.finite(screw, branch, margin(chart)):
            continue
        u, moment, d = screw.axis.re, screw.axis.du, screw.angle.du
        opposite = Screw(Dual(screw.angle.re, -d), -screw.axis)
        for sign, equal in ((1, screw), (-1, opposite)):
            q = tuple(sign * c for c in (0, *u, -d / 2, *moment))
            yield Expectation(f"from_quaternion {branch}", (q,), flat(chart.at(equal, branch)))
        R = tensor_from_pose(Pose(Tensor.dyad(u, u) * 2 - Tensor.identity(), d * u + 2 * u.cross(moment)))
        positive = screw if orientation(*u) > 0 else opposite
        yield from _from_rotation(R, branch, flat(chart.at(positive, branch)))


def _near_ties(chart: Vectors, screw: Screw) -> Iterator[Expectation]:
    """Yield vectors just before and just beyond the angles (2k − 1)π between branches, at a distance of `NEAR_TIE`."""
    for halves in chart.odd_half_turns():
        for behind, step in ((-1, -NEAR_TIE), (1, NEAR_TIE)):
            alpha = halves * mpmath.pi + step
            angles = (alpha, alpha - (halves + behind) * mpmath.pi)
            v, principal = (flat(screw.axis * chart.size(Dual(angle, screw.angle.du))) for angle in angles)
            yield Expectation("principal", (v,), principal)


def _identity(chart: Vectors) -> Iterator[Expectation]:
    """Yield cases at the identity, which has no axis: the axis and v on other branches are NaN."""
    identity, nowhere = 6 * (mpmath.mpf(0),), 6 * (mpmath.nan,)
    yield Expectation("to_screw", (identity,), (0, 0, *nowhere))
    for branch in chart.tried[1:]:
        yield Expectation(f"shadow {branch}", (identity,), nowhere)
        yield Expectation(f"shadow_jacobian {branch}", (identity,), 3 * (*nowhere[:3], *identity[:3]) + 3 * nowhere)
        yield Expectation(f"from_quaternion {branch}", ((mpmath.mpf(1), *identity, mpmath.mpf(0)),), nowhere)
        yield Expectation(f"from_tensor {branch}", ((*Tensor.identity(), *(0 * Tensor.identity())),), nowhere)


def _far_steps(chart: Vectors, screw: Screw, still: Screw) -> Iterator[Expectation]:
    """Yield steps within and beyond the series of the exponential, steps from a translation, and extrapolations."""
    small, *large = STEPS
    v, resting = flat(chart.at(screw)), flat(chart.at(still))
    for name in STEP_NAMES:
        for given in (*((v, delta) for delta in large), (resting, small)):
            yield _by(chart, name, *given)
    for name, delta in itertools.product(STEP_JACOBIANS, large):
        yield _by(chart, name, v, delta)
    yield _by(chart, "interpolate", resting, (0, 0, 0, *resting[:2:-1]), (mpmath.mpf(0.25),))
    yield _by(chart, "interpolate", v, MAPS["retract"](chart, 0, v, small), (mpmath.mpf(4),))
    yield _by(chart, "angle", resting)
    yield Expectation("angle", ((mpmath.mpf(0),) * 6,), (mpmath.mpf(0),) * 2)


def _steps_to_pole(chart: Vectors, screw: Screw) -> Iterator[Expectation]:
    """Yield steps that end just before and just beyond the edge, in charts whose φ has a pole there."""
    if mpmath.isinf(chart.edge) or chart.is_folded:
        return
    v = chart.at(Screw(Dual(chart.edge - POLE_DISTANCE, screw.angle.du), screw.axis))
    for name, start in itertools.product(STEP_NAMES, (v, -v)):
        yield _by(chart, name, flat(start), SMALL_STEP)


def _undecided(chart: Vectors, table: Table) -> Iterator[Expectation]:
    """Yield cases at vectors with s = 0 or w = 0 exactly, where v or its dual part determines the axis.

    Rotations have no dual part: the axis is chosen as for a translation along v.
    """
    half = mpmath.mpf(1) / 2
    sides = (half, -half) if table is POSES else (half,)
    for scale, direction in itertools.product((mpmath.mpf(1), half), LATTICE):
        re = scale * Vector(*direction)
        halves = _half_turns_of(chart, re)
        for along in sides if halves else ():
            v = Vector.dual(re, along * re + re.cross(Vector(1, 2, 3)))
            screw, own = chart.screw(v)
            yield Expectation("to_screw", (flat(v),), (screw.angle.re, screw.angle.du, *flat(screw.axis)))
            # at 3π, 5π … both signs of v are valid principal vectors, so there is no case
            if halves % 2 == 0 or halves == 1:
                yield Expectation("principal", (flat(v),), flat(chart.at(screw)))
            for branch in chart.tried[1:]:
                if chart.finite(screw, own + branch, margin(chart)):
                    yield Expectation(f"shadow {branch}", (flat(v),), flat(chart.at(screw, own + branch)))


def _half_turns_of(chart: Vectors, re: Vector) -> int:
    """Return the angle of a vector in half turns if it is a whole number inside the edge, else 0."""
    angle = chart.angle(re.magnitude()) if chart.reaches(re.magnitude()) else mpmath.inf
    inside = angle < (1 - EDGE_MARGIN) * chart.edge
    return int(mpmath.nint(angle / mpmath.pi)) if inside and is_whole(angle / mpmath.pi) else 0


def algebraic(chart: Chart, table: Table) -> Iterator[tuple[Expectation, ...]]:
    """Yield cases of every algebraic function at seeded vectors and the identity, for charts without exact cases."""
    draw, at = random.Random(SEED), vectors_of(chart)
    points = []
    for size in (mpmath.mpf(0), *(at.size(mpmath.mpf(share) * at.first_pole) for share in SIZES)):
        u = Vector(*(mpmath.mpf(draw.uniform(-1, 1)) for _ in range(3)))
        re = u * (size / u.magnitude())
        rest = [tuple(mpmath.mpf(draw.uniform(-2, 2)) for _ in range(count)) for count in (3, 6, 6)]
        points.append(((*re, *rest[0]), *rest[1:]))
    for row in (table.sources[name] for name in ALGEBRAIC if name in table.sources):
        given = [arguments_of(row, rows) for rows in points]
        yield tuple(Expectation(row.name, each, partial(_computed, value, at, row, None, each)) for each in given)
