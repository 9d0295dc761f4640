"""Inverse maps, shadows and composition.

Each needs only its real part: with T = Re dcay at Re v, the dual part of v is v° = T⁻¹ rho. Signs follow the principal
quaternion: scalar part >= 0, and where it is 0 the given vector part stands.
"""

from __future__ import annotations

from ...algebra import Dual, Quaternion, Tensor, Vector
from ..programs.program import Program
from ..programs.value import Number
from .calculus import matrix6
from .forward import named, rotate, start, translation
from .inputs import dual_vector
from .point import Geometry, Point

Axis = tuple[Number, Vector, Number, Vector]
"""Magnitude and direction of a dual vector, and the dual parts of both."""


def from_quaternion(trace: Geometry) -> Program:
    parts = trace.inputs("e", [f"e{i}{mark}" for mark in ("", "o") for i in range(4)])
    e, eo = Quaternion(parts[0], Vector(*parts[1:4])), Quaternion(parts[4], Vector(*parts[5:]))
    return _finish(trace, "from_quaternion", e, "gain_unit", named(trace, "rho", _translation(e, eo)))


def _translation(e: Quaternion, eo: Quaternion) -> Vector:
    """rho = 2 vect(e° e*), e* the conjugate; CP23 Theorem 5."""
    rho: Vector = 2 * (e.scalar * eo.vector - eo.scalar * e.vector + e.vector.cross(eo.vector))
    return rho


def from_tensor(trace: Geometry) -> Program:
    entries = trace.inputs("R", [f"{part}{i}{j}" for part in "QD" for i in (1, 2, 3) for j in (1, 2, 3)])
    rotation, dual = _rows(entries[:9]), _rows(entries[9:])
    # rho = vect(Du Qᵀ) of skew(rho) Q
    product = [[d.dot(q) for q in rotation] for d in dual]
    rho = Vector(product[2][1] - product[1][2], product[0][2] - product[2][0], product[1][0] - product[0][1]) / 2
    return _from_rotation(trace, "from_tensor", rotation, named(trace, "rho", rho))


def from_pose(trace: Geometry) -> Program:
    entries = trace.inputs("T", [f"{'Q' if j < 4 else 'T'}{i}{j}" for i in (1, 2, 3, 4) for j in (1, 2, 3, 4)])
    rotation = tuple(Vector(*entries[4 * i : 4 * i + 3]) for i in range(3))
    return _from_rotation(trace, "from_pose", rotation, Vector(entries[3], entries[7], entries[11]))


def _rows(entries: tuple[Number, ...]) -> tuple[Vector, ...]:
    return tuple(Vector(*entries[3 * i : 3 * i + 3]) for i in range(3))


def _from_rotation(trace: Geometry, name: str, rotation: tuple[Vector, ...], rho: Vector) -> Program:
    return _finish(trace, name, _quaternion_of(trace, rotation), "gain_positive", rho)


def _quaternion_of(trace: Geometry, rotation: tuple[Vector, ...]) -> Quaternion:
    """A multiple of the rotation's quaternion: the row of 4 q qᵀ with the largest diagonal entry loses no digits."""
    (q11, q12, q13), (q21, q22, q23), (q31, q32, q33) = rotation
    a, b, c = (trace.name(f"a{i}", d) for i, d in enumerate((q32 - q23, q13 - q31, q21 - q12), 1))
    s12, s13, s23 = (trace.name(n, s) for n, s in (("s12", q12 + q21), ("s13", q13 + q31), ("s23", q23 + q32)))
    up, down = trace.name("up", 1 + q11), trace.name("down", 1 - q11)
    total, difference = trace.name("total", q22 + q33), trace.name("difference", q22 - q33)
    sizes = (up + total, up - total, down + difference, down - difference)
    t0, t1, t2, t3 = (trace.name(f"t{i}", size) for i, size in enumerate(sizes))
    candidates = [(t0, (t0, a, b, c)), (t1, (a, t1, s12, s13)), (t2, (b, s12, t2, s23)), (t3, (c, s13, s23, t3))]
    best, entries = candidates[0]
    for step, (size, row) in enumerate(candidates[1:], 1):
        larger = trace.name(f"larger{step}", trace.less(best, size))
        best = trace.name(f"best{step}", trace.where(larger, size, best))
        pairs = zip(row, entries, strict=True)
        entries = tuple(trace.name(f"z{step}{i}", trace.where(larger, new, old)) for i, (new, old) in enumerate(pairs))
    return _positive(trace, entries)


def _positive(trace: Geometry, entries: tuple[Number, ...]) -> Quaternion:
    """Scalar part >= 0; where it is 0, the first component of the vector part which is not 0 is positive."""
    negative: Number = trace.less(entries[3], 0)
    for entry in (entries[2], entries[1], entries[0]):
        negative = trace.either(trace.less(entry, 0), trace.both(trace.equal(entry, 0), negative))
    sign = trace.name("sign", trace.where(negative, -1, 1))
    z0, z1, z2, z3 = (trace.name(f"e{i}", sign * entry) for i, entry in enumerate(entries))
    return Quaternion(z0, Vector(z1, z2, z3))


def compose(trace: Geometry) -> Program:
    """R(v2) R(v1)."""
    second = Point(trace, dual_vector(trace, "b", "b"), "b")
    first = Point(trace, dual_vector(trace, "a", "a"), "a")
    return trace.program("compose", product(trace, second, first))


def product(trace: Geometry, second: Point, first: Point) -> tuple[Number, ...]:
    """The principal vector of one displacement after the other; rho = rho2 + Q2 rho1.

    Through the product of rays (a2 + b2 v2)(a1 + b1 v1), quaternions times a size.
    """
    ray2, size2, (f, g, h) = ray(trace, second)
    ray1, size1, coefficients = ray(trace, first)
    z = Quaternion.from_components(trace.name(f"z{i}", c) for i, c in enumerate(ray2 * ray1))
    moved = rotate(second, f, g, named(trace, "rhoa", translation(first, *coefficients)), "rho")
    rho = named(trace, "rho", moved + translation(second, f, g, h))
    return _vector(trace, z, "gain_product", rho, size2, size1)


def ray(trace: Geometry, point: Point) -> tuple[Quaternion, Number, tuple[Number, ...]]:
    """A positive multiple of the quaternion, how large, and f, g, h."""
    a, b, size, *coefficients = point.scalars("ray")
    return Quaternion(a, named(trace, "bv" + point.mark, b * point.re)), size, tuple(coefficients)


def _finish(trace: Geometry, name: str, e: Quaternion, gain: str, rho: Vector) -> Program:
    return trace.program(name, _vector(trace, e, gain, rho))


def _vector(trace: Geometry, e: Quaternion, gain: str, rho: Vector, *sizes: Number) -> tuple[Number, ...]:
    """v = gain · e and v° = Re(T)⁻¹ rho, T⁻¹ = (fi I − skew(v) + hi v⊗v)/2, by one of the chart's gains."""
    (factor,) = trace.ask(gain, (e.scalar, *e.vector, *sizes))
    re = named(trace, "v", factor * e.vector)
    point = Point(trace, (*re, 0, 0, 0))
    fi, hi = trace.ask("inverse", (point.x, trace.name("fe", factor * e.scalar)))
    along = trace.name("hvr", hi * re.dot(rho))
    return (*re, *((fi * rho - re.cross(rho) + along * re) / 2))


# --- shadows --------------------------------------------------------------------------------------------------


def turn(trace: Geometry) -> Program:
    """Go on along the axis of v itself by a turn of the chart."""
    point = start(trace)
    return trace.program("turn", _turned(trace, point, _axis(trace, point), *_turn(trace)))


def shadow(trace: Geometry) -> Program:
    """Go on along the axis of the principal angle by a turn of the chart."""
    point = start(trace)
    cosine, sine = _turn(trace)
    axis = _axis(trace, point)
    # of the axis' length, not of x: its gradient is finite at Re v = 0
    (sign,) = trace.ask("direction", (point.x, point.y, axis[0]))
    return trace.program("shadow", _turned(trace, point, axis, cosine, point.name("sn", sign * sine)))


def principal(trace: Geometry) -> Program:
    """Go back by the turn that the table has for x; where v is principal already, it stands."""
    point = start(trace)
    trace.declare_returns()
    beyond, cosine, sine = trace.ask("beyond", (point.x,))
    turned = _turned(trace, point, _axis_where(trace, point, beyond), cosine, sine)
    stays = (*point.re, *point.du)
    outputs = [trace.where(beyond, back, stay) for back, stay in zip(turned, stays, strict=True)]
    return trace.program("principal", outputs)


def shadow_jacobian(trace: Geometry) -> Program:
    """``T(v_k)⁻¹ T(v)``: that is ``(r_k/r) (I − u⊗u) + dr_k/dr u⊗u``, where ``v = r u`` and ``v_k = r_k u``.

    Where both T have no inverse, at whole turns, this has no singular point.
    """
    point = start(trace)
    cosine, sine = _turn(trace)
    size, u, size_du, moment = _axis(trace, point)
    (sign,) = trace.ask("direction", (point.x, point.y, size))
    length, slope = trace.ask("turned", (size, cosine, point.name("sn", sign * sine)))
    length_du = point.name("rko", size_du * slope)
    across = trace.dual("across", Dual(length, length_du) / Dual(size, size_du))
    # dr_k/dr is 1/φ′ of v by that of v_k: slopes of both make its dual part
    (before, beforey), (after, aftery) = (
        trace.ask("rate", (square,), mark) for square, mark in ((point.x, ""), (point.name("xk", length * length), "k"))
    )
    growth = point.y * (beforey / before) - point.name("yk", length * length_du) * (aftery / after)
    spread = trace.dual("spread", Dual(slope, slope * growth) - across)
    axis = Vector.dual(u, moment)
    along = trace.dual_vector("su", spread * axis)
    diagonal = Tensor(((across, 0, 0), (0, across, 0), (0, 0, across)))
    return trace.program("shadow_jacobian", matrix6(trace, Tensor.dyad(along, axis) + diagonal))


def identity_jacobian(trace: Geometry) -> Program:
    """That of no turn: I, but NaN where v is not finite."""
    point = start(trace)
    none = point.name("none", sum(((c - c) for c in (*point.re, *point.du)), start=0))
    one = Dual(point.name("one", 1 + none), none)
    zero = Dual(none, none)
    return trace.program(
        "identity_jacobian", matrix6(trace, Tensor(((one, zero, zero), (zero, one, zero), (zero, zero, one))))
    )


def _turn(trace: Geometry) -> tuple[Number, ...]:
    return trace.inputs("table", ("cos", "sin"))


def _axis(trace: Geometry, point: Point) -> Axis:
    """|v| and v/|v| as dual quantities; at Re v = 0 the axis is that of v°, through the origin; at v = 0 it is NaN.

    Vectors are scaled by their sums before they are squared: no length underflows or overflows but where it must.
    """
    v, vo = point.re, point.du
    total = point.name("total", _sum(trace, v))
    still = point.name("still", trace.equal(total, 0))
    # with no dual part nothing else is left at Re v = 0
    where = v if point.is_real else Vector(*(trace.where(still, b, a) for a, b in zip(v, vo, strict=True)))
    along = named(trace, "a", where)
    extent = point.name("extent", _sum(trace, along))
    scale = point.name("scale", trace.where(trace.equal(extent, 0), 1, extent))
    scaled = named(trace, "s", along / scale)
    # one root, never of 0 but at the identity: so the gradient is finite wherever the axis is defined
    root = point.name("root", trace.sqrt(scaled.dot(scaled)))
    u = named(trace, "u", scaled / root)
    size_du = point.name("ro", trace.where(still, scale * root, u.dot(vo)))
    inverse = point.name("ir", trace.where(still, 0, 1) / root)
    across = vo - named(trace, "ru", size_du * u)
    return point.name("r", total * root), u, size_du, named(trace, "uo", across / scale * inverse)


def _sum(trace: Geometry, v: Vector) -> Number:
    first, second, third = map(trace.abs, v)
    return first + second + third


def _axis_where(trace: Geometry, point: Point, selected: Number) -> Axis:
    """The same where it is needed, Re v ≠ 0; elsewhere numbers which are not used and spoil no gradient."""
    size = point.name("r", trace.sqrt(trace.where(selected, point.x, 1 + point.x)))
    u = named(trace, "u", point.re / size)
    size_du = point.name("ro", u.dot(point.du))
    moment = named(trace, "uo", (point.du - named(trace, "ru", size_du * u)) / size)
    return size, u, size_du, moment


def _turned(trace: Geometry, point: Point, axis: Axis, cosine: Number, sine: Number) -> tuple[Number, ...]:
    """The vector a turn on along u: its coefficient r becomes rk, with the slope of that in the dual part."""
    size, u, size_du, moment = axis
    length, slope = trace.ask("turned", (size, cosine, sine))
    length_du = point.name("rko", size_du * slope)
    return (*(length * u), *(length * moment + length_du * u))


def to_screw(trace: Geometry) -> Program:
    """Dual angle and axis, CP23 Theorem 3: alpha in [0, pi], d = r° dα/dr along the axis of that angle."""
    point = start(trace)
    size, u, size_du, moment = _axis(trace, point)
    angle, slope, sign = trace.ask("natural", (point.x, point.y, size))
    return trace.program("to_screw", (angle, sign * (slope * size_du), *(sign * u), *(sign * moment)))


def angle(trace: Geometry) -> Program:
    """The dual angle of v's own branch; along the axis ``dα/dr`` is ``f + x h``."""
    point = start(trace)
    _, _, distance, _ = _axis(trace, point)
    f, _, h = point.scalars("pose")
    resting = trace.name("resting", trace.equal(point.x, 0))
    length = trace.name("rown", trace.sqrt(trace.where(resting, 1 + point.x, point.x)))
    (own,) = trace.ask("unfolded", (point.x, length))
    return trace.program("angle", (trace.where(resting, point.x, own), distance * (f + point.x * h)))


def from_screw(trace: Geometry) -> Program:
    """v = φ(α) u over dual numbers."""
    angle, distance = trace.inputs("angle", ("alpha", "d"))
    parts = dual_vector(trace, "line", "u")
    u, moment = Vector(*parts[:3]), Vector(*parts[3:])
    size, slope = trace.ask("coefficient", (angle,))
    size_du = trace.name("ro", distance * slope)
    return trace.program("from_screw", (*(size * u), *(size * moment + size_du * u)))
