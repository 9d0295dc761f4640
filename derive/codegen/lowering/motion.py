"""Screw-linear motion from one vector to another, on the continuously followed branch.

The quaternion of the motion, ``exp(t δ/2) q̂(v1)``, equals ``cos(α/2) + sin(α/2) u`` at every t. Between two whole
turns ``sin(α/2)`` keeps its sign from v1, and α stays within the turn. Only a motion about the axis of v1 passes
through whole turns.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...algebra import Quaternion, Vector
from ...maps.noise import at_turn
from ...maps.real_constants import SMALL
from ..programs.value import Number
from .forward import translation
from .inverse import composed, displacement, dual_part_at
from .point import LAYOUTS, Geometry, Point, Results
from .retraction import exponential_scalars, local, shifted

HALF_TURN = 3
"""Bound of α at v1, in rad. A motion that begins below it and ends before a whole turn passes through no whole turn."""

OWN_AXIS = 64
"""Limit of δ × v in units of |v| eps/2. Smaller values count as 0: the rounding of two quaternions and their product
stays below this limit."""


def interpolate(trace: Geometry) -> Results:
    """Vector v of exp(t δ) R(v1) with exp(δ) = R(v2) R(v1)⁻¹, on the branch followed from v1."""
    v1, v2 = trace.components("v1", "a", 6), trace.components("v2", "b", 6)
    (t,) = trace.inputs("time", ("t",))
    delta = trace.apply(local, "d{}", v2, v1)
    step = [trace.name(f"td{place}", t * c) for place, c in zip(LAYOUTS[6], delta, strict=True)]
    s, w, f, g, h, *_ = trace.apply(exponential_scalars, "{}", step[:3])
    *first, _, _, _, r1, r2, r3 = trace.apply(displacement, "{}_1", v1)
    small = (s, *trace.vector("wd", w * Vector(*step[:3])))
    rho = translation(Point(trace, step, "t"), f, g, h)
    found = trace.apply(composed, "{}", small, f, g, step, rho, first, (r1, r2, r3))
    before = Point(trace, v1, "a")
    followed = _Followed(trace, before, Quaternion.from_components(first), Vector(*delta[:3]), Vector(*step[:3]))
    return followed.vector(Quaternion.from_components(found[:4]), Vector(*found[4:]), (*v1[3:], *step[3:]))


class _Followed:
    """Branch of v that is followed from v1 while the quaternion turns about the axis of δ."""

    def __init__(self, trace: Geometry, start: Point, first: Quaternion, delta: Vector, gone: Vector) -> None:
        self.trace = trace
        name, where = trace.name, trace.where
        resting = name("resting", trace.equal(start.x, 0))
        r = name("r", trace.sqrt(where(resting, 1 + start.x, start.x)))
        (own,) = trace.ask("unfolded", (start.x, r))
        self.own = name("alpha", where(resting, start.x, own))
        along = trace.vector("along", start.re / r)
        # normalize again: if the square of v is subnormal, its root has few digits
        unit = name("unit", trace.sqrt(where(resting, r, along.dot(along))))
        self.axis = trace.vector("axis", along / unit)
        self.gone = name("gone", gone.dot(self.axis))
        end = name("end", trace.abs(self.own + self.gone))
        inside = trace.both(trace.less(self.own, HALF_TURN), trace.either(resting, trace.less(25 * end, 157)))
        across = sum(map(trace.abs, delta.cross(start.re)), start=0)
        self.apart = name("apart", trace.either(inside, trace.less(r, trace.beside(r, across / OWN_AXIS))))
        self.side = name("side", where(trace.less(first.vector.dot(start.re), 0), -1, 1))
        _, self.begun = self._half(first, "1")

    def _half(self, q: Quaternion, mark: str) -> tuple[Number, Number]:
        """Return the signed ``sin(α/2)`` along the followed axis, and α/2 up to whole turns."""
        trace, name = self.trace, self.trace.name
        ss = name("ss" + mark, q.vector.dot(q.vector))
        still = name("still" + mark, trace.equal(ss, 0))
        # never take the root of 0: its infinite slope times 0 would spoil the gradient
        root = name("root" + mark, trace.sqrt(trace.where(still, 1 + ss, ss)))
        length = trace.where(still, ss, self.side * root)
        sine = name("sine" + mark, trace.where(self.apart, length, q.vector.dot(self.axis)))
        sign = name("sign" + mark, trace.where(self.apart, self.side, 1))
        return sine, name("half" + mark, trace.atan2(sign * sine, sign * q.scalar))

    def vector(self, z: Quaternion, rho: Vector, terms: Sequence[Number]) -> tuple[Number, ...]:
        """Return v of the quaternion z and the translation rho, which is computed from the terms."""
        trace, name, where = self.trace, self.trace.name, self.trace.where
        sine, half = self._half(z, "t")
        turns = name("turns", self.own + where(self.apart, -2 * self.begun, self.gone - 2 * half))
        near = name("first", trace.less(trace.abs(turns), 1))
        whole = where(near, 0, turns)  # a multiple of 2π, up to rounding
        principal = name("principal", trace.either(self.apart, near))
        still = name("still", trace.both(trace.equal(sine, 0), principal))
        angle = name("angle", where(still, sine, whole + 2 * half))
        size, slope, known = trace.ask("coefficient_of", (angle, sine, z.scalar), "n")
        cosine, length = name("cosine", trace.abs(z.scalar)), name("length", trace.abs(sine))
        lost = name("lost", where(principal, 0, at_turn(sine, cosine, size, trace)))
        # use the vector part even if its square underflows to 0
        below = where(still, z.scalar, where(name("sharp", trace.equal(lost, 0)), sine, cosine / SMALL))
        factor = name("factor", where(still, 2 * slope, size) / name("below", below))
        # near whole turns take the axis of v1; elsewhere the axis of z is as accurate and has the slope of the motion
        clear = name("clear", trace.either(self.apart, trace.less(cosine, length)))
        pairs = zip(factor * z.vector, size * self.axis, strict=True)
        re = trace.vector("v_", trace.inside(Vector(*(where(clear, one, other) for one, other in pairs))))
        shift = trace.vector("shift", rho / 2)
        fi = shifted(trace, name("fe", factor * z.scalar), lost, re, shift, terms)
        hi, ai = trace.ask("inverse_at", (Point(trace, (*re, 0, 0, 0), "w").x, fi, known))
        return (*re, *dual_part_at(trace, fi, hi, ai, re, shift))
