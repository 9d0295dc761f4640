"""Calls on symbols, and seeded calls on numbers of 50 digits that cover all sides of every selection."""

from __future__ import annotations

import itertools
import random
from collections.abc import Collection, Iterator, Sequence
from functools import lru_cache, partial

from ...algebra import Dual, Tensor, Vector
from ...algebra.pose import Pose, Screw, is_zero, tensor_from_pose, tensor_from_screw
from ...maps import Formula
from ...maps.chart import Chart
from ...proof import Ring, root_of
from ..lowering.scalar_programs import scalar_program
from ..rows import Function, Table
from ..signatures import POSES
from .calls import Case, Drawn, Kind, algebraic, at_screw, of_tensor, restricted, selecting
from .expected_values import ALGEBRAIC, BY_QUATERNION, Formulas, evaluated
from .inverse_maps import MAPS, reached
from .reals import INFINITE, Real, nearest
from .screws import covering, half_turns, steep, translation
from .vectors import Flat, Vectors, flat, is_whole, vectors_of

SEED = 2011
ROOTS_MAX = 2  # largest number of square roots in an inverse map that is compared exactly; more would take too long
LETTERS = ("v", "w", "z")  # letters of the symbols of each argument; the first is the vector v of the ring
SMALL = 1e-21 / 7
"""Size of the small quaternion components: their rows of 4 q qᵀ keep 28 digits. With 1/7 no sum is exact."""

SMALL_AT_EDGE = 1e-10 / 7  # size in charts with edge π: a smaller scalar part would be too near the edge
EDGE_MARGIN = 1e-12  # least margin to the edge (`Vectors.finite`): nearer vectors are too ill-conditioned
JACOBIAN_MARGIN = 0.1  # least margin to the edge for Jacobians, whose conditioning is worse by one power
NEAR_TIE = Real(10) ** -30  # angle between a vector and the limit of its branch, in the nearest cases
LATTICE = ((1, 0, 0), (0, -1, 0), (1, 1, 1), (-1, 1, -1), (1, -1, 0))
"""Directions of vectors whose v·v needs no rounding: scalars of a chart vanish exactly at some of them."""

SIZES = ("1e-25", "1e-9", "0.003", "0.3", "0.7", "0.97")
"""Angles of seeded vectors, divided by the first singular angle: some in the range of the series, some beyond it."""

SMALL_STEP = tuple(Real(c) / 64 for c in (1, -2, 2, 1, 0, 3))  # step that stays on the branch of its vector
STEPS = tuple(tuple(Real(size * c) for c in (1, -2, 2, 1, 0, 3)) for size in (0.25, 0.8125, 2, 3))
"""Steps in the range of the series of the exponential, where its last terms weigh most, and steps beyond it."""

POLE_DISTANCE = Real(1) / 64
"""Distance in angle from the edge, small enough for `SMALL_STEP` to cross the edge in one direction."""


# --- on symbols ---------------------------------------------------------------------------------------------------


def on_symbols(chart: Chart, table: Table, names: Collection[str]) -> Iterator[Case]:
    """Yield a call of each named algebraic function, and of `from_quaternion` if it needs few roots."""
    for name in (name for name in ALGEBRAIC if name in table.sources and table.sources[name].name in names):
        maps = [chart.quaternion] if name in BY_QUATERNION else [chart.tensor, chart.tangent, chart.tangent_inv]
        yield (case := _on_symbols(chart, table.sources[name], *maps))
        if name in BY_QUATERNION and _goes_back_by_roots(chart):
            yield Case(table.functions[f"from_{name}"], None, (case.result,), partial(tuple, case.arguments[0]))


def _on_symbols(chart: Chart, row: Function, *formulas: Formula) -> Case:
    root = root_of(coefficient for formula in formulas for coefficient in formula.coefficients)
    pairs = list(zip(LETTERS, row.arguments))
    names = [[f"{letter}{i + 1}" for i in range(array.size)] for letter, array in pairs]
    further = (name for group, (_, array) in zip(names, pairs) for name in group[3 * array.vector :])
    ring = Ring(further, root, vectors="".join(letter for letter, array in pairs if array.vector))
    arguments = tuple(tuple(map(ring.symbol, group)) for group in names)
    zero = 0 * arguments[0][0]
    return Case(row, None, arguments, lambda: evaluated(row, Formulas(chart, ring), arguments, zero))


def _goes_back_by_roots(chart: Chart) -> bool:
    """Tell whether the inverse map takes at most `ROOTS_MAX` square roots and no trigonometry."""
    operations = scalar_program("gain", chart).operations
    return not operations.keys() & {"tan", "atan2"} and operations["sqrt"] <= ROOTS_MAX


# --- at numbers ---------------------------------------------------------------------------------------------------


def margin(chart: Vectors) -> float:
    """Return the least margin to the edge; wider if φ′ = 0 there, since scalars then grow like (1/margin)³."""
    return float(EDGE_MARGIN ** (1 / 3)) if chart.is_folded else EDGE_MARGIN


def at_numbers(chart: Chart, table: Table) -> Iterator[Case]:
    """Yield calls of all functions that select a branch or an angle and, without exact calls, of algebraic ones."""
    at = vectors_of(chart)
    yield from restricted((*_seeded(at), *selecting(at, _undecided(at, table))), table)


@lru_cache(maxsize=1)  # the table of rotations reuses the calls of poses
def _seeded(chart: Vectors) -> Sequence[Case]:
    found = list(selecting(chart, _regimes(chart, random.Random(SEED))))
    return found if chart.chart.algebraic else [*found, *algebraic(chart, list(_points(chart)))]


def _points(chart: Vectors) -> Iterator[Sequence[Flat]]:
    """Yield the identity, seeded vectors and vectors near the least φ′, each with two further arguments."""
    draw = random.Random(SEED)
    seeded = (Real(share) * chart.first_pole for share in SIZES)
    for size in (Real(0), *map(chart.size, (*seeded, *map(Real, chart.chart.steep)))):
        u = Vector(*(Real(draw.uniform(-1, 1)) for _ in range(3)))
        rest = [tuple(Real(draw.uniform(-2, 2)) for _ in range(count)) for count in (3, 6, 6)]
        yield (*(u * (size / u.magnitude())), *rest[0]), *rest[1:]


def _regimes(chart: Vectors, draw: random.Random) -> Iterator[Drawn]:
    """Yield arguments at all screws and exact half turns on the principal branch, and at some on other branches."""
    yield from _identity(chart)
    small = SMALL if chart.edge > Real.pi() else SMALL_AT_EDGE
    screws, halves = list(covering(draw, small)), list(half_turns(draw))
    still, other_still = translation(draw), translation(draw)
    given = [screw for screw in (*screws, still, other_still) if chart.finite(screw, 0, margin(chart))]
    for screw, other in zip(given, [*given[1:], given[0]]):
        yield from at_screw(chart, screw, 0)
        yield from _pair(chart, screw, other)
    for branch in chart.tried:
        for screw in (screws[3 * branch % 8], still) if branch else ():
            if chart.finite(screw, branch, margin(chart)):
                yield from _further(chart, screw, branch)
        yield from _half_turns(chart, halves, branch)
    for screw in steep(draw, small, 1 / 3):
        if chart.finite(screw, 0, margin(chart)):
            yield from of_tensor(tensor_from_screw(screw), 0)
    yield from _far_steps(chart, screws[0], still)
    yield from _steps_to_pole(chart, screws[0])
    yield from _near_ties(chart, screws[0])
    for angle in chart.chart.steep:
        yield Drawn(Kind.VECTOR, (flat(screws[0].axis * chart.size(Dual(Real(angle), screws[0].angle.du))),))


def _pair(chart: Vectors, screw: Screw, other: Screw) -> Iterator[Drawn]:
    """Yield two vectors, also as a vector and a step, as any dual vector is; ways between them; angles beyond π."""
    regular = all(chart.finite(s, 0, JACOBIAN_MARGIN) for s in (screw, other))
    principal, v2 = flat(chart.at(screw)), flat(chart.at(other))
    yield Drawn(Kind.PAIR, (v2, principal), regular=regular)
    yield Drawn(Kind.STEP, (v2, principal), regular=regular)
    further = Screw(screw.angle / 3, screw.axis)  # on the same axis: interpolation through whole turns
    for end, t in ((other, "0.3"), (screw, "0.7"), (further, "0.8"), (further, "-4.3")):
        yield Drawn(Kind.WAY, (principal, flat(chart.at(end)), (Real(t),)))
    beyond = int(float(chart.edge / (2 * Real.pi()))) + 1 if chart.edge.is_finite() else 3
    for turns in (1, beyond):
        angle = screw.angle + 2 * Real.pi() * turns
        if chart.finite(Screw(reached(chart, angle), screw.axis), 0, JACOBIAN_MARGIN):
            yield Drawn(Kind.LOGARITHM, (flat(screw.axis * angle),))


def _further(chart: Vectors, screw: Screw, branch: int) -> Iterator[Drawn]:
    """Yield arguments on another branch, with a step that stays on it."""
    clear = screw.angle.re > JACOBIAN_MARGIN and all(chart.finite(screw, k, JACOBIAN_MARGIN) for k in (0, branch))
    yield from at_screw(chart, screw, branch, regular=clear)
    v = flat(chart.at(screw, branch))
    yield Drawn(Kind.STEP, (v, SMALL_STEP), regular=True)
    if not is_zero(screw.angle.re):
        yield Drawn(Kind.WAY, (v, MAPS["retract"](chart, 0, v, SMALL_STEP), (Real("0.5"),)))


def _half_turns(chart: Vectors, screws: Sequence[Screw], branch: int) -> Iterator[Drawn]:
    """Yield exact half turns: all of them on the principal branch, one on each other branch.

    Axes u and −u give one rotation. Maps from quaternions keep the sign of the vector part; maps from matrices make its
    first non-zero component positive.
    """
    for screw in [screws[branch % len(screws)]] if branch else screws:
        if chart.finite(screw, branch, margin(chart)):
            u, moment, d = screw.axis.re, screw.axis.du, screw.angle.du
            for sign in (1, -1):
                yield Drawn(Kind.QUATERNION, (tuple(sign * c for c in (0, *u, -d / 2, *moment)),), branch)
            Q = Tensor.dyad(u, u) * 2 - Tensor.identity()
            yield from of_tensor(tensor_from_pose(Pose(Q, d * u + 2 * u.cross(moment))), branch)


def _near_ties(chart: Vectors, screw: Screw) -> Iterator[Drawn]:
    """Yield vectors just before and just beyond the angles (2k − 1)π between branches, at a distance of `NEAR_TIE`."""
    for halves, step in itertools.product(chart.odd_half_turns(), (-NEAR_TIE, NEAR_TIE)):
        angle = Dual(halves * Real.pi() + step, screw.angle.du)
        yield Drawn(Kind.VECTOR, (flat(screw.axis * chart.size(angle)),))


def _identity(chart: Vectors) -> Iterator[Drawn]:
    """Yield the identity, which has no axis: the axis and v on other branches are NaN."""
    zero, one = 6 * (Real(0),), Tensor.identity() * Real(1)
    yield Drawn(Kind.VECTOR, (zero,))
    for branch in chart.tried:
        yield Drawn(Kind.TURN, (zero,), branch, regular=True)
        for sign in (1, -1):
            yield Drawn(Kind.QUATERNION, ((Real(sign), *zero, Real(0)),), branch)
        yield from of_tensor(Tensor.dual(one, 0 * one), branch)


def _far_steps(chart: Vectors, screw: Screw, still: Screw) -> Iterator[Drawn]:
    """Yield steps within and beyond the series of the exponential, steps from a translation, and extrapolations."""
    small, *large = STEPS
    v, resting = flat(chart.at(screw)), flat(chart.at(still))
    for delta in large:
        yield Drawn(Kind.STEP, (v, delta), regular=True)
    yield Drawn(Kind.STEP, (resting, small))
    yield Drawn(Kind.WAY, (resting, (0, 0, 0, *resting[:2:-1]), (Real(0.25),)))
    yield Drawn(Kind.WAY, (v, MAPS["retract"](chart, 0, v, small), (Real(4),)))


def _steps_to_pole(chart: Vectors, screw: Screw) -> Iterator[Drawn]:
    """Yield steps that end just before and just beyond the edge, in charts whose φ has a pole there."""
    if chart.edge.is_finite() and not chart.is_folded:
        v = chart.at(Screw(Dual(chart.edge - POLE_DISTANCE, screw.angle.du), screw.axis))
        yield from (Drawn(Kind.STEP, (flat(start), SMALL_STEP)) for start in (v, -v))


def _undecided(chart: Vectors, table: Table) -> Iterator[Drawn]:
    """Yield cases of poses whose axis has two or more directions: s = 0 or w = 0 exactly, of v or of its dual part.

    Of rotations, v alone is such a case.
    """
    half = Real(1) / 2
    sides = (half, -half) if table is POSES else (half,)
    for scale, direction in itertools.product((Real(1), half), LATTICE):
        re = scale * Vector(*direction)
        halves = _half_turns_of(chart, re)
        for along in sides if halves else ():
            v = Vector.dual(re, along * re + re.cross(Vector(1, 2, 3)))
            screw, own = chart.screw(v)
            # at 3π, 5π … both signs of v are valid principal vectors
            yield Drawn(Kind.VECTOR, (flat(v),), without=("principal",) if halves % 2 and halves > 1 else ())
            for branch in chart.tried[1:]:
                if chart.finite(screw, own + branch, margin(chart)):
                    yield Drawn(Kind.TURN, (flat(v),), branch)


def _half_turns_of(chart: Vectors, re: Vector) -> int:
    """Return the angle of a vector in half turns if it is a whole number inside the edge, else 0."""
    angle = chart.angle(re.magnitude()) if chart.reaches(re.magnitude()) else INFINITE
    inside = angle < (1 - EDGE_MARGIN) * chart.edge
    return nearest(angle / Real.pi()) if inside and is_whole(angle / Real.pi()) else 0
