"""Seeded cases of 50 digits, for the maps that no ring holds, and at what decides between branches."""

from __future__ import annotations

import itertools
import random
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache

import mpmath

from ...algebra import Dual, Tensor, Vector
from ...maps.chart import Chart
from ...maps.pose import (
    Pose,
    Screw,
    pose_from_tensor,
    quaternion_from_screw,
    tensor_from_pose,
    tensor_from_screw,
)
from ...maps.sign_tests import orientation
from ..rows import Function, Table
from ..signatures import POSES
from .decimals import later
from .exact import ALGEBRAIC, Expectation
from .maps_at import MAPS, Flat, flat, reached
from .point import value
from .screws import covering, half_turns, steep, translation
from .steps import SMALL_STEP, by, far_steps, steps_to_pole
from .vectors import Vectors, is_whole, vectors_of

SEED = 2011

SMALL = 1e-21 / 7
"""Small components of a quaternion: a row of the rotation's matrix that belongs to one is good to 28 digits only. They
are no short fraction in any base: of those, sums may be exact."""

SMALL_AT_EDGE = 1e-10 / 7
"""Likewise where no v is left at half a turn: the scalar part may not be smaller, and a wrong row loses it twice."""

NEAR_EDGE = 1e-12
"""What `Vectors.finite` asks of a branch here: nearer to the edge, its condition takes digits that are compared."""

INSIDE = 0.1
"""The same of vectors that Jacobians are taken at, whose condition is greater by one more power."""

NEAR_TIE = mpmath.mpf(10) ** -30
"""Angle between a vector and the limit of its branch."""

LATTICE = ((1, 0, 0), (0, -1, 0), (1, 1, 1), (-1, 1, -1), (1, -1, 0))
"""Directions which have, times a power of two, a v·v without rounding: at some of them a chart's scalars vanish."""

SIZES = ("1e-25", "1e-9", "0.003", "0.3", "0.7", "0.97")
"""Angles of seeded vectors, by the first at which something is singular: where scalars are series, and where not."""


def near_edge(chart: Vectors) -> float:
    """What is asked of a branch in this chart: where φ′ is 0 at the edge, scalars go with the cube of its inverse."""
    return float(NEAR_EDGE ** (1 / 3)) if chart.is_folded else NEAR_EDGE


def expectations(chart: Chart, table: Table = POSES) -> Iterator[tuple[Expectation, ...]]:
    """Inverse maps, screws, shadows (at most eight branches) and composition: a batch for each function and branch."""
    batches: dict[str, list[Expectation]] = {}
    at = vectors_of(chart)
    for case in restricted((*_seeded(at), *undecided(at, table)), table):
        batches.setdefault(case.function, []).append(case)
    yield from map(tuple, batches.values())


def restricted(cases: Iterable[Expectation], table: Table) -> Iterator[Expectation]:
    """Cases as the functions of a table have them.

    Of rotations these are the real parts: no dual part decides in them, but for the axis where nothing turns. There the
    first case stands, that of the identity, or of a translation along v.
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
                yield Expectation(function, arguments, later(_part, row, case))


def _part(row: Function, case: Expectation) -> Flat:
    return row.part(case.result)


@lru_cache(maxsize=1)
def _seeded(chart: Vectors) -> tuple[Expectation, ...]:
    """Those of poses, of which rotations take the real parts a moment later."""
    return tuple(_cases(chart, random.Random(SEED)))


def _cases(chart: Vectors, draw: random.Random) -> Iterator[Expectation]:
    """The principal branch takes all screws and exact half turns, every other one some of them."""
    yield from _identity(chart)
    small = SMALL if chart.edge > mpmath.pi else SMALL_AT_EDGE
    screws, halves = list(covering(draw, small)), list(half_turns(draw))
    still, other_still = translation(draw), translation(draw)
    given = [screw for screw in (*screws, still, other_still) if chart.finite(screw, 0, near_edge(chart))]
    for screw, other in zip(given, [*given[1:], given[0]], strict=True):
        yield from _principal(chart, screw, other)
    for branch in chart.tried:
        some = [screws[3 * branch % 8]] if branch else [*screws, still]
        # a translation on another branch has w = 0 but for rounding: there nothing decides about its axis
        for screw in (*some, still) if branch else some:
            if chart.finite(screw, branch, near_edge(chart)):
                yield from _branch(chart, screw, branch)
                yield from _back(chart, screw, branch) if screw in some else ()
        yield from at_half_turns(chart, halves, branch)
    for screw in steep(draw, small, 1 / 3):
        if chart.finite(screw, 0, near_edge(chart)):
            yield from _from_rotation(tensor_from_screw(screw), 0, flat(chart.at(screw)))
    yield from far_steps(chart, screws[0], still)
    yield from steps_to_pole(chart, screws[0])
    yield from _near_ties(chart, screws[0])


def _principal(chart: Vectors, screw: Screw, other: Screw) -> Iterator[Expectation]:
    principal = chart.at(screw)
    yield Expectation("from_screw", ((screw.angle.re, screw.angle.du), flat(screw.axis)), flat(principal))
    q = quaternion_from_screw(screw)
    yield Expectation("from_quaternion", (tuple(-c for c in (*q.re, *q.du)),), flat(principal))
    product = quaternion_from_screw(other) * q
    vectors = (flat(chart.at(other)), flat(principal))
    yield from _coordinates(chart, screw)
    yield Expectation("compose", vectors, flat(chart.of_quaternion(product)))
    for name in ("between", "local", "body_local", "retract", "body_retract"):  # any dual vector is a δ
        yield by(chart, name, *vectors)
    yield from _between(chart, screw, other)
    if all(chart.finite(s, 0, INSIDE) for s in (screw, other)):
        for name in ("compose_jacobians", "between_jacobians", "retract_jacobians", "body_retract_jacobians"):
            yield by(chart, name, *vectors)


def _coordinates(chart: Vectors, screw: Screw) -> Iterator[Expectation]:
    """α u of a vector, and back; of angles some turns further on too."""
    v = flat(chart.at(screw))
    yield by(chart, "to_exponential", v)
    beyond = 3 if mpmath.isinf(chart.edge) else int(chart.edge / (2 * mpmath.pi)) + 1
    for turns in (0, 1, beyond):
        w = screw.axis * (screw.angle + 2 * mpmath.pi * turns)
        if chart.finite(Screw(reached(chart, screw.angle + 2 * mpmath.pi * turns), screw.axis), 0, INSIDE):
            yield by(chart, "from_exponential", flat(w))


def _between(chart: Vectors, screw: Screw, other: Screw) -> Iterator[Expectation]:
    """Some of the way; about the same axis too, and there through whole turns."""
    further = Screw(screw.angle / 3, screw.axis)
    for end, t in ((other, "0.3"), (screw, "0.7"), (further, "0.8"), (further, "-4.3")):
        given = flat(chart.at(screw)), flat(chart.at(end)), (mpmath.mpf(t),)
        yield by(chart, "interpolate", *given)


def _back(chart: Vectors, screw: Screw, branch: int) -> Iterator[Expectation]:
    """From other branches, where the axis may be the opposite of v, to the screw and the principal v."""
    v = flat(chart.at(screw, branch))
    yield Expectation("to_screw", (v,), (screw.angle.re, screw.angle.du, *flat(screw.axis)))
    yield Expectation(f"shadow {chart.back(branch)}", (v,), flat(chart.at(screw)))
    if branch:
        way = v, MAPS["retract"](chart, 0, v, SMALL_STEP), (mpmath.mpf("0.5"),)
        yield by(chart, "interpolate", *way)


def _branch(chart: Vectors, screw: Screw, branch: int) -> Iterator[Expectation]:
    v = flat(chart.at(screw, branch))
    q = quaternion_from_screw(screw)
    yield Expectation(f"from_quaternion {branch}", ((*q.re, *q.du),), v)
    yield from _from_rotation(tensor_from_screw(screw), branch, v)
    principal = flat(chart.at(screw))
    yield Expectation(f"shadow {branch}", (principal,), v)
    yield Expectation("principal", (v,), principal)
    for name in ("angle", "to_exponential"):
        yield by(chart, name, v)
    if screw.angle.re > INSIDE and all(chart.finite(screw, k, INSIDE) for k in (0, branch)):
        yield by(chart, f"shadow_jacobian {branch}", principal)
    for name in ("retract", "body_retract", "retract_jacobians", "body_retract_jacobians") if branch else ():
        yield by(chart, name, v, SMALL_STEP)


def _from_rotation(R: Tensor, branch: int, v: Flat) -> Iterator[Expectation]:
    pose = pose_from_tensor(R)
    Q, rho = pose.rotation, tuple(pose.displacement)
    rows = [entry for i in range(3) for entry in (Q[i, 0], Q[i, 1], Q[i, 2], rho[i])]
    yield Expectation(f"from_tensor {branch}", ((*R.re, *R.du),), v)
    yield Expectation(f"from_pose {branch}", ((*rows, 0, 0, 0, 1),), v)


def at_half_turns(chart: Vectors, screws: Sequence[Screw], branch: int) -> Iterator[Expectation]:
    """At all of these half turns on the principal branch, at one of them on others."""
    for screw in [screws[branch % len(screws)]] if branch else screws:
        if chart.finite(screw, branch, near_edge(chart)):
            yield from _half_turn(chart, screw, branch)


def _half_turn(chart: Vectors, screw: Screw, branch: int) -> Iterator[Expectation]:
    """At exactly half a turn u and -u are one rotation: the vector part stands, or its first component is positive.

    The scalar part is exactly 0, the rotation exactly symmetric.
    """
    u, moment, d = screw.axis.re, screw.axis.du, screw.angle.du
    opposite = Screw(Dual(screw.angle.re, -d), -screw.axis)
    for sign, same in ((1, screw), (-1, opposite)):
        q = tuple(sign * c for c in (0, *u, -d / 2, *moment))
        yield Expectation(f"from_quaternion {branch}", (q,), flat(chart.at(same, branch)))
    R = tensor_from_pose(Pose(Tensor.dyad(u, u) * 2 - Tensor.identity(), d * u + 2 * u.cross(moment)))
    positive = screw if orientation(*u) > 0 else opposite
    yield from _from_rotation(R, branch, flat(chart.at(positive, branch)))


def _near_ties(chart: Vectors, screw: Screw) -> Iterator[Expectation]:
    """Vectors just before and behind the angles (2k − 1)π between branches, to the digits of the printed limits."""
    for halves in chart.odd_half_turns():
        for behind, step in ((-1, -NEAR_TIE), (1, NEAR_TIE)):
            alpha = halves * mpmath.pi + step
            angles = (alpha, alpha - (halves + behind) * mpmath.pi)
            v, principal = (flat(screw.axis * chart.size(Dual(angle, screw.angle.du))) for angle in angles)
            yield Expectation("principal", (v,), principal)


def _identity(chart: Vectors) -> Iterator[Expectation]:
    """The identity turns and moves nothing, about no axis: it has no other branch."""
    identity, nowhere = 6 * (mpmath.mpf(0),), 6 * (mpmath.nan,)
    yield Expectation("to_screw", (identity,), (0, 0, *nowhere))
    for branch in chart.tried:
        if branch:
            yield Expectation(f"shadow {branch}", (identity,), nowhere)
            yield Expectation(f"shadow_jacobian {branch}", (identity,), 3 * (*nowhere[:3], *identity[:3]) + 3 * nowhere)
            yield Expectation(f"from_quaternion {branch}", ((mpmath.mpf(1), *identity, mpmath.mpf(0)),), nowhere)
            yield Expectation(f"from_tensor {branch}", ((*Tensor.identity(), *(0 * Tensor.identity())),), nowhere)


def undecided(chart: Vectors, table: Table) -> Iterator[Expectation]:
    """Vectors with s = 0 or w = 0 exactly, half a turn or none: v itself or its dual part decides about the axis.

    Where there is none, of rotations, v stands as if it moved along itself.
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
            # at odd multiples of half a turn beyond the first either side is a principal v
            if halves % 2 == 0 or halves == 1:
                yield Expectation("principal", (flat(v),), flat(chart.at(screw)))
            for branch in chart.tried[1:]:
                if chart.finite(screw, own + branch, near_edge(chart)):
                    yield Expectation(f"shadow {branch}", (flat(v),), flat(chart.at(screw, own + branch)))


def _half_turns_of(chart: Vectors, re: Vector) -> int:
    """How many half turns the rotation of a vector takes, where that is a whole number; else 0."""
    if not chart.reaches(re.magnitude()):
        return 0
    halves = chart.angle(re.magnitude()) / mpmath.pi
    inside = halves * mpmath.pi < (1 - NEAR_EDGE) * chart.edge
    return int(mpmath.nint(halves)) if inside and is_whole(halves) else 0


def algebraic(chart: Chart, table: Table = POSES) -> Iterator[tuple[Expectation, ...]]:
    """Every algebraic function of a chart whose formulas no ring holds, at seeded vectors; no rotation among them."""
    draw, at = random.Random(SEED), vectors_of(chart)
    points = []
    for size in (mpmath.mpf(0), *(at.size(mpmath.mpf(share) * at.first_pole) for share in SIZES)):
        u = Vector(*(mpmath.mpf(draw.uniform(-1, 1)) for _ in range(3)))
        re = u * (size / u.magnitude())
        rest = [tuple(mpmath.mpf(draw.uniform(-2, 2)) for _ in range(count)) for count in (3, 6, 6)]
        points.append(((*re, *rest[0]), *rest[1:]))
    for row in (table.sources[name] for name in ALGEBRAIC if name in table.sources):
        sizes = [array.size for array in row.arguments]
        given = [tuple(components[:size] for components, size in zip(rows, sizes)) for rows in points]
        yield tuple(Expectation(row.name, each, later(value, at, row, None, each)) for each in given)
