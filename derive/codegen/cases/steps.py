"""Steps and motions that are far, and steps next to a pole: what numbers of so many digits say of them."""

from __future__ import annotations

from collections.abc import Iterator

import mpmath

from ...algebra import Dual
from ...maps.pose import Screw
from .decimals import later
from .exact import Expectation
from .maps_at import MAPS, Flat, flat
from .vectors import Vectors

SMALL_STEP = tuple(mpmath.mpf(c) / 64 for c in (1, -2, 2, 1, 0, 3))
"""A displacement that leads from a vector to one of its own branch."""

SHORT_OF_POLE = mpmath.mpf(1) / 64
"""What is left of the way to the edge before a step of this kind, which one way leads over it."""


def by(chart: Vectors, name: str, *arguments: Flat) -> Expectation:
    """What one of the maps makes of its arguments; a branch stands behind its name."""
    function, branch = (*name.split(), "0")[:2]
    return Expectation(name, arguments, later(MAPS[function], chart, int(branch), *arguments))


def far_steps(chart: Vectors, screw: Screw, still: Screw) -> Iterator[Expectation]:
    """Steps beyond the series of the exponential and where their last terms weigh most, and from a translation."""
    small, *large = (tuple(mpmath.mpf(size * c) for c in (1, -2, 2, 1, 0, 3)) for size in (0.25, 0.8125, 2, 3))
    resting = flat(chart.at(still))
    for name in ("retract", "body_retract"):
        for given in (*((flat(chart.at(screw)), delta) for delta in large), (resting, small)):
            yield by(chart, name, *given)
    for name in ("retract_jacobians", "body_retract_jacobians"):
        for delta in large:
            given = flat(chart.at(screw)), delta
            yield by(chart, name, *given)
    elsewhere = tuple(reversed(resting))
    v = flat(chart.at(screw))
    for start, end, t in ((resting, (0, 0, 0, *elsewhere[:3]), 0.25), (v, MAPS["retract"](chart, 0, v, small), 4)):
        motion = start, end, (mpmath.mpf(t),)
        yield by(chart, "interpolate", *motion)
    yield by(chart, "angle", resting)
    yield Expectation("angle", ((mpmath.mpf(0),) * 6,), (mpmath.mpf(0),) * 2)


def steps_to_pole(chart: Vectors, screw: Screw) -> Iterator[Expectation]:
    """Steps that end next to the edge, where φ has a pole there: before it, and behind."""
    if mpmath.isinf(chart.edge) or chart.is_folded:
        return
    v = chart.at(Screw(Dual(chart.edge - SHORT_OF_POLE, screw.angle.du), screw.axis))
    for name in ("retract", "body_retract"):
        for given in ((flat(v), SMALL_STEP), (flat(-v), SMALL_STEP)):
            yield by(chart, name, *given)
