"""Functions of the angle α and the axis u of v = φ(α) u: shadows, screws, exponential coordinates.

A vector k(r) u, r = |v|, has the dual part (k/r) v° + (k' − k/r) (v·v°/v²) v, which is regular at v = 0.
"""

from __future__ import annotations

import itertools

from ...algebra import Dual, Tensor, Vector
from ..programs.program import Number
from .calculus import entries6
from .point import TABLE, Geometry, Point, Results

Axis = tuple[Number, Vector, Number, Vector]
"""Magnitude r and direction u of a dual vector, then their dual parts: ``(r, u, r°, u°)``."""


def turn(trace: Geometry) -> Results:
    """Vector φ(α + 2kπ) u, which is v turned further by k whole turns about its own axis, CP23 (49)."""
    point = trace.point()
    return _inside(trace, _turned(trace, point, _axis(trace, point), *trace.inputs(TABLE, ("cos", "sin"))))


def shadow(trace: Geometry) -> Results:
    """Shadow φ(α + 2kπ) u of v, with the axis u of its principal angle α, CP23 (49)."""
    point = trace.point()
    cosine, sine = trace.inputs(TABLE, ("cos", "sin"))
    axis = _axis(trace, point)
    # take the length from the axis, not from x: only then the gradient is finite at Re v = 0
    (sign,) = trace.ask("direction", (point.x, point.y, axis[0]))
    return _inside(trace, _turned(trace, point, axis, cosine, point.name("sn", sign * sine)))


def principal(trace: Geometry) -> Results:
    """Principal vector of v, turned back as the table of returns says for x; a principal v is returned unchanged."""
    point = trace.point()
    trace.inputs(TABLE, ())  # only the chart knows its length
    return returned(trace, point)[1]


def returned(trace: Geometry, point: Point) -> tuple[Number, tuple[Number, ...]]:
    """Return whether v is beyond the principal branch, and the principal vector."""
    beyond, place, cosine, sine = trace.ask("beyond", (point.x,))
    turned = _turned(trace, point, _axis_at(trace, point, place), cosine, sine)
    return beyond, tuple(trace.where(beyond, back, stay) for back, stay in zip(turned, point.components, strict=True))


def shadow_jacobian(trace: Geometry) -> Results:
    """Derivative T(v_k)⁻¹ T(v) = (r_k/r) (I − u⊗u) + dr_k/dr u⊗u of v_k = r_k u by v = r u; regular at whole turns."""
    point = trace.point()
    cosine, sine = trace.inputs(TABLE, ("cos", "sin"))
    size, u, size_du, moment = _axis(trace, point)
    (sign,) = trace.ask("direction", (point.x, point.y, size))
    length, slope, bend = trace.ask("turned", (size, cosine, point.name("sn", sign * sine)))
    ratio = point.name("ratio", length / size)
    spread = point.name("spread", slope - ratio)
    # divide each entry of I − u⊗u, which may be 0: the dual part of r_k/r overflows for small r
    change, along = point.name("change", spread * size_du), point.name("along", bend * size_du)
    entries = []
    for (i, (ui, mi)), (j, (uj, mj)) in itertools.product(enumerate(zip(u, moment), 1), repeat=2):
        square = point.name(f"uu{i}{j}", ui * uj)
        rest = point.name(f"p{i}{j}", int(i == j) - square)
        du = change * (rest / size) + along * square + spread * (ui * mj + mi * uj)
        entries.append(trace.name(f"J{i}{j}", Dual(ratio * rest + slope * square, du)))
    return entries6(trace, Tensor.from_entries(entries))


def stay(trace: Geometry) -> Results:
    """Vector v itself, the shadow by no turn; NaN where q̂ is not finite."""
    point = trace.point()
    one = point.name("one", 1 + none_of(point))
    return [one * c for c in point.components]


def identity_jacobian(trace: Geometry) -> Results:
    """Identity I, the derivative of a shadow by no turn; NaN where v or q̂ is not finite."""
    point = trace.point()
    none = point.name("none", sum((c - c for c in point.components), none_of(point)))
    one, zero = Dual(point.name("one", 1 + none), none), Dual(none, none)
    identity = Tensor(((one, zero, zero), (zero, one, zero), (zero, zero, one)))
    return entries6(trace, identity)


def none_of(point: Point) -> Number:
    """Return 0; NaN where q̂ is not finite."""
    s, w, _, _ = point.scalars("quaternion_scalars")
    none: Number = (s - s) + (w - w)
    return none


def _axis(trace: Geometry, point: Point) -> Axis:
    """Return r = |v|, u = v/r, r° and u°."""
    r, *found = trace.apply(axis_of, "{}", point.components)
    return r, Vector(*found[:3]), found[3], Vector(*found[4:])


def axis_of(trace: Geometry) -> Results:
    """Length r = |v| and axis u = v/|v|; u is NaN at v = 0.

    The dual parts are r° and u°. At Re v = 0 the axis passes through the origin in the direction of v°.
    """
    # scale vectors by their sums before squaring: a length underflows or overflows only where unavoidable
    point = trace.point()
    v, vo = point.re, point.du
    total = point.name("total", sum([*map(trace.abs, v)]))
    still = point.name("still", trace.equal(total, 0))
    # without a dual part, v itself is the only choice at Re v = 0
    where = v if trace.real else Vector(*(trace.where(still, b, a) for a, b in zip(v, vo, strict=True)))
    along = trace.vector("a", where)
    extent = point.name("extent", sum([*map(trace.abs, along)]))
    scale = point.name("scale", trace.where(trace.equal(extent, 0), 1, extent))
    scaled = trace.vector("s", along / scale)
    # one root, of 0 only at the identity: the gradient is finite wherever the axis is defined
    root = point.name("root", trace.sqrt(scaled.dot(scaled)))
    u = trace.vector("u", scaled / root)
    size_du = point.name("ro", trace.where(still, scale * root, u.dot(vo)))
    inverse = point.name("ir", trace.where(still, 0, 1) / root)
    across = u.cross(trace.vector("c", vo.cross(u)))  # without errors along u, which moments of longer vectors magnify
    results = (total * root, *u, size_du, *(across / scale * inverse))
    return dict(zip(("r", "u1", "u2", "u3", "ro", "u1o", "u2o", "u3o"), results, strict=True))


def _axis_at(trace: Geometry, point: Point, square: Number) -> Axis:
    """Return |v| and v/|v| where ``square`` is v·v, with Re v ≠ 0; elsewhere unused numbers with finite gradients."""
    size = point.name("r", trace.sqrt(square))
    u = trace.vector("u", point.re / size)
    size_du = point.name("ro", u.dot(point.du))
    moment = trace.vector("uo", (point.du - trace.vector("ru", size_du * u)) / size)
    return size, u, size_du, moment


def _turned(trace: Geometry, point: Point, axis: Axis, cosine: Number, sine: Number) -> tuple[Number, ...]:
    """Return the vector on another branch, rk u, from the axis and the turn; its dual part needs drk/dr."""
    size, u, size_du, moment = axis
    length, slope, _ = trace.ask("turned", (size, cosine, sine))
    length_du = point.name("rko", size_du * slope)
    return (*(length * u), *(length * moment + length_du * u))


def _inside(trace: Geometry, found: tuple[Number, ...]) -> tuple[Number, ...]:
    return *trace.inside(Vector(*found[:3])), *found[3:]


def to_screw(trace: Geometry) -> Results:
    """Angle α in [0, π] and axis u of v, CP23 Theorem 3.

    The dual part of α is r° dα/dr, along the axis u.
    """
    point = trace.point()
    size, u, size_du, moment = _axis(trace, point)
    angle, slope, sign = trace.ask("natural", (point.x, point.y, size))
    return angle, sign * (slope * size_du), *(sign * u), *(sign * moment)


def angle(trace: Geometry) -> Results:
    """Angle α of v on its own branch.

    The dual part is r° (f + x h), since dα/dr = f + x h.
    """
    point = trace.point()
    length, _, distance, _ = _axis(trace, point)
    f, _, h = point.scalars("pose_scalars")
    (own,) = trace.ask("unfolded", (point.x, length))
    return own, distance * (f + point.x * h)


def from_screw(trace: Geometry) -> Results:
    """Vector v = φ(α) u, in dual numbers; NaN if u is zero, as an axis of no direction."""
    angle, distance = trace.inputs("angle", ("alpha", "alphao"))
    line = trace.point("line", "u")
    u, moment = line.v.re, line.v.du
    size, slope, _ = trace.ask("coefficient", (angle,))
    inverse = trace.name("inverse", trace.div(1, line.x))
    every = trace.name("every", sum((distance, *line.components, inverse), start=angle))
    size, size_du = trace.name("size", size + (every - every)), trace.name("ro", distance * slope)
    return *trace.inside(size * u), *(size * moment + size_du * u)


def to_exponential(trace: Geometry) -> Results:
    """Exponential coordinates α u of v = φ(α) u, on the branch of v."""
    point = trace.point()
    resting, square, length = _length(trace, point)
    (own,) = trace.ask("unfolded", (point.x, length))
    (rate,) = trace.ask("rate_scalars", (point.x,))
    share = trace.name("share", trace.where(resting, rate, own / length))
    return _rescaled(trace, point, square, share, rate)


def from_exponential(trace: Geometry) -> Results:
    """Vector φ(α) u of exponential coordinates α u; α beyond the edge of the chart is reduced by whole turns."""
    point = trace.point("w")
    resting, square, length = _length(trace, point)
    (angle,) = trace.ask("reached", (trace.name("alpha", trace.where(resting, point.x, length)),))
    size, slope, _ = trace.ask("coefficient", (angle,), "n")
    share = trace.name("share", trace.where(resting, slope, size / length))
    return _inside(trace, _rescaled(trace, point, square, share, slope))


def _length(trace: Geometry, point: Point) -> tuple[Number, Number, Number]:
    """Return whether |v| = 0, then |v|² and |v|: both 1 at |v| = 0, to avoid the root of 0, and NaN for infinity."""
    resting = trace.name("resting", trace.equal(point.x, 0))
    square = trace.name("square", trace.where(resting, 1 + point.x, point.x))
    return resting, square, trace.name("length", trace.sqrt(square) + (square - square))


def _rescaled(trace: Geometry, point: Point, square: Number, share: Number, slope: Number) -> tuple[Number, ...]:
    """Return v times ``share``, the new length over the old; ``slope`` is the derivative of the new by the old.

    The dual part is ``slope`` times its part along v, and ``share`` times the rest. The larger factor multiplies one
    part alone: its errors would spoil the other.
    """
    v, vo, where = point.re, point.du, trace.where
    excess = trace.name("excess", (share - slope) / square)
    steep = trace.name("steep", trace.less(excess, 0))
    bend = trace.name("bend", where(steep, -excess, 0) * point.y)
    across = trace.vector("c", trace.name("rest", where(steep, 0, excess)) * vo.cross(v))
    both = trace.name("both", where(steep, share, slope))
    return *(share * v), *(both * vo + v.cross(across) + bend * v)
