"""Inverse maps, composition, and shadows.

Each inverse map computes only Re v: with T = Re dcay at Re v, the dual part is v° = T⁻¹ ρ. Signs follow the principal
quaternion: its scalar part is >= 0; if the scalar part is 0, the given vector part is kept.
"""

from __future__ import annotations

import itertools

from ...algebra import Dual, Quaternion, Tensor, Vector
from ..programs.program import Program
from ..programs.value import Number
from .calculus import entries6
from .forward import rotated, rows_of, translation
from .kinematics import opposite
from .point import TABLE, Geometry, Point

Axis = tuple[Number, Vector, Number, Vector]
"""Magnitude and direction of a dual vector, followed by the dual parts of both."""

DISPLACEMENT = ("e0", "e1", "e2", "e3", "size", "f°", "g°", "rho1°", "rho2°", "rho3°")
"""Results of `displacement`."""


def dual_part(trace: Geometry, fi: Number, hi: Number, v: Vector, rho: Vector) -> Vector:
    """Return the dual part v° = T⁻¹ ρ = (fi ρ − v × ρ + hi (v·ρ) v)/2."""
    along = trace.name("along", hi * v.dot(rho))
    du: Vector = (fi * rho - v.cross(rho) + along * v) / 2
    return du


# --- programs that others call --------------------------------------------------------------------------------


def vector_of(trace: Geometry) -> Program:
    """Vector v = gain vec e of a quaternion e.

    The dual part is v° = T⁻¹ ρ.
    """
    (gain,) = trace.numbers("gain")
    e0, *vector = trace.components("e", "e", 4)
    rho = trace.real_vector("rho", dual="°")
    v = trace.vector("v", gain * Vector(*vector))
    fi, hi = trace.ask("inverse_scalars", (Point(trace, (*v, 0, 0, 0)).x, trace.name("fe", gain * e0)))
    return trace.program("vector_of", (*v, *dual_part(trace, fi, hi, v, rho)))


def quaternion_of(trace: Geometry) -> Program:
    """Positive multiple of the quaternion of a rotation Q, with scalar part >= 0.

    The result is the row of 4 q qᵀ with the largest diagonal entry, which loses no digits.
    """
    (q11, q12, q13), (q21, q22, q23), (q31, q32, q33) = rows_of(trace.components("Q", "Q", 9))
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
    return trace.program("quaternion_of", _positive(trace, entries))


def _positive(trace: Geometry, entries: tuple[Number, ...]) -> tuple[Number, ...]:
    """Return a quaternion or its opposite, so that the first component that is not 0 is positive."""
    negative: Number = trace.less(entries[3], 0)
    for entry in (entries[2], entries[1], entries[0]):
        negative = trace.either(trace.less(entry, 0), trace.both(trace.equal(entry, 0), negative))
    sign = trace.name("sign", trace.where(negative, -1, 1))
    return tuple(sign * entry for entry in entries)


def displacement(trace: Geometry) -> Program:
    """Positive multiple e of the quaternion of v, its size, and the scalars f and g.

    The translation is ρ = Re(T) v°.
    """
    point = trace.point()
    a, b, size, f, g, h = point.scalars("ray")
    rho = translation(point, f, g, h)
    return trace.program("displacement", (a, *(b * point.re), size, f, g, *rho), DISPLACEMENT)


def composed(trace: Geometry) -> Program:
    """Product e = e2 e1, a positive multiple of the quaternion of R(v2) R(v1).

    The translation is ρ = ρ2 + Q2 ρ1, with Q2 of f and g at v2.
    """
    e2 = Quaternion.from_components(trace.inputs("e2", [f"p{i}" for i in range(4)]))
    f, g = (trace.inputs(name, [name + "°"])[0] for name in ("f", "g"))
    v2 = trace.inputs("v2", [f"b{i}{mark}" for mark in ("°", "o") for i in (1, 2, 3)])
    rho2 = trace.real_vector("rho2", "s", "°")
    e1 = Quaternion.from_components(trace.inputs("e1", [f"q{i}" for i in range(4)]))
    rho1 = trace.real_vector("rho1", "r", "°")
    moved = rotated(trace, Vector(*v2[:3]), f, g, rho1)
    names = ("e0", "e1", "e2", "e3", "rho1°", "rho2°", "rho3°")
    return trace.program("composed", (*(e2 * e1), *(rho2 + moved)), names)


def product(
    trace: Geometry, second: tuple[Number, ...], first: tuple[Number, ...]
) -> tuple[tuple[Number, ...], tuple[Number, ...], tuple[Number, ...]]:
    """Return e and ρ of the composition of two displacements, and the sizes of both quaternions."""
    *e2, size2, f, g, r1, r2, r3 = trace.apply(displacement, "{}_2", second)
    *e1, size1, _, _, s1, s2, s3 = trace.apply(displacement, "{}_1", first)
    found = trace.apply(composed, "{}", e2, f, g, second, (r1, r2, r3), e1, (s1, s2, s3))
    return found[:4], found[4:], (size2, size1)


# --- functions ------------------------------------------------------------------------------------------------


def from_quaternion(trace: Geometry) -> Program:
    """Vector v = gain vec q̂ of a unit dual quaternion q̂, CP23 (47).

    The dual part is v° = T⁻¹ ρ with ρ = 2 vect(q̂° q̂*), CP23 Theorem 5.
    """
    parts = trace.inputs("e", [f"e{i}{mark}" for mark in ("", "o") for i in range(4)])
    e, eo = Quaternion.from_components(parts[:4]), Quaternion.from_components(parts[4:])
    rho = 2 * (e.scalar * eo.vector - eo.scalar * e.vector + e.vector.cross(eo.vector))
    (gain,) = trace.ask("gain_unit", tuple(e))
    return trace.program("from_quaternion", trace.apply(vector_of, "v{}", gain, e, rho))


def from_tensor(trace: Geometry) -> Program:
    """Vector v of a rotation Q, computed from its quaternion.

    The dual part is v° = T⁻¹ ρ with ρ = vect(R° Qᵀ), R° = skew(ρ) Q.
    """
    entries = trace.inputs("R", [f"R{i}{j}{mark}" for mark in ("", "o") for i in (1, 2, 3) for j in (1, 2, 3)])
    rotation, dual = rows_of(entries[:9]), rows_of(entries[9:])
    product = [[d.dot(q) for q in rotation] for d in dual]
    rho = Vector(product[2][1] - product[1][2], product[0][2] - product[2][0], product[1][0] - product[0][1]) / 2
    return trace.program("from_tensor", _from_rotation(trace, entries[:9], rho))


def from_pose(trace: Geometry) -> Program:
    """Vector v of a homogeneous matrix [[Q, ρ], [0, 1]], with the dual part v° = T⁻¹ ρ."""
    entries = trace.inputs("T", [f"{'Q' if j < 4 else 'T'}{i}{j}" for i in (1, 2, 3, 4) for j in (1, 2, 3, 4)])
    rotation = (*entries[:3], *entries[4:7], *entries[8:11])
    return trace.program("from_pose", _from_rotation(trace, rotation, (entries[3], entries[7], entries[11])))


def _from_rotation(trace: Geometry, Q: tuple[Number, ...], rho: Vector | tuple[Number, ...]) -> tuple[Number, ...]:
    e = trace.apply(quaternion_of, "e{}", Q)
    (gain,) = trace.ask("gain_positive", e)
    return trace.apply(vector_of, "v{}", gain, e, rho)


def compose(trace: Geometry) -> Program:
    """Principal vector v of R(v2) R(v1), CP23 (58)."""
    v2, v1 = trace.components("v2", "b", 6), trace.components("v1", "a", 6)
    e, rho, sizes = product(trace, v2, v1)
    (gain,) = trace.ask("gain_product", (*e, *sizes))
    return trace.program("compose", trace.apply(vector_of, "v{}", gain, e, rho))


def between(trace: Geometry) -> Program:
    """Principal vector v of R(v1)⁻¹ R(v2), where R(v1)⁻¹ = R(−v1)."""
    v2, v1 = trace.components("v2", "b", 6), trace.components("v1", "a", 6)
    return trace.program("between", trace.apply(compose, "v{}", opposite(v1), v2))


# --- shadows --------------------------------------------------------------------------------------------------


def turn(trace: Geometry) -> Program:
    """Vector φ(α + 2kπ) u, which is v turned further by k whole turns about its own axis, CP23 (49)."""
    point = trace.point()
    return trace.program("turn", _turned(trace, point, _axis(trace, point), *_turn(trace)))


def shadow(trace: Geometry) -> Program:
    """Shadow φ(α + 2kπ) u of v, with the axis u of its principal angle α, CP23 (49)."""
    point = trace.point()
    cosine, sine = _turn(trace)
    axis = _axis(trace, point)
    # take the length from the axis, not from x: its gradient is finite at Re v = 0
    (sign,) = trace.ask("direction", (point.x, point.y, axis[0]))
    return trace.program("shadow", _turned(trace, point, axis, cosine, point.name("sn", sign * sine)))


def principal(trace: Geometry) -> Program:
    """Principal vector of v, turned back as the table of returns says for x; a principal v is returned unchanged."""
    point = trace.point()
    trace.inputs(TABLE, ())  # only the chart knows its length
    beyond, cosine, sine = trace.ask("beyond", (point.x,))
    turned = _turned(trace, point, _axis_where(trace, point, beyond), cosine, sine)
    stays = (*point.re, *point.du)
    outputs = [trace.where(beyond, back, stay) for back, stay in zip(turned, stays, strict=True)]
    return trace.program("principal", outputs)


def shadow_jacobian(trace: Geometry) -> Program:
    """Derivative T(v_k)⁻¹ T(v) = (r_k/r) (I − u⊗u) + dr_k/dr u⊗u of v_k = r_k u by v = r u; regular at whole turns."""
    point = trace.point()
    cosine, sine = _turn(trace)
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
        entries.append(trace.dual(f"J{i}{j}", Dual(ratio * rest + slope * square, du)))
    return trace.program("shadow_jacobian", entries6(trace, Tensor.from_entries(entries)))


def identity_jacobian(trace: Geometry) -> Program:
    """Identity I, the derivative of a shadow by no turn; NaN where v is not finite."""
    point = trace.point()
    none = point.name("none", sum(((c - c) for c in (*point.re, *point.du)), start=0))
    one = Dual(point.name("one", 1 + none), none)
    zero = Dual(none, none)
    return trace.program(
        "identity_jacobian", entries6(trace, Tensor(((one, zero, zero), (zero, one, zero), (zero, zero, one))))
    )


def _turn(trace: Geometry) -> tuple[Number, ...]:
    return trace.inputs("table", ("cos", "sin"))


def _axis(trace: Geometry, point: Point) -> Axis:
    """Return |v| and v/|v|, then the dual parts of both."""
    r, *found = trace.apply(axis_of, "{}", point.components)
    return r, Vector(*found[:3]), found[3], Vector(*found[4:])


def axis_of(trace: Geometry) -> Program:
    """Length r = |v| and axis u = v/|v|; u is NaN at v = 0.

    The dual parts are r° and u°. At Re v = 0 the axis passes through the origin in the direction of v°.
    """
    # scale vectors by their sums before squaring: a length underflows or overflows only where unavoidable
    point = trace.point()
    v, vo = point.re, point.du
    total = point.name("total", _sum(trace, v))
    still = point.name("still", trace.equal(total, 0))
    # without a dual part, v itself is the only choice at Re v = 0
    where = v if point.is_real else Vector(*(trace.where(still, b, a) for a, b in zip(v, vo, strict=True)))
    along = trace.vector("a", where)
    extent = point.name("extent", _sum(trace, along))
    scale = point.name("scale", trace.where(trace.equal(extent, 0), 1, extent))
    scaled = trace.vector("s", along / scale)
    # one root, of 0 only at the identity: the gradient is finite wherever the axis is defined
    root = point.name("root", trace.sqrt(scaled.dot(scaled)))
    u = trace.vector("u", scaled / root)
    size_du = point.name("ro", trace.where(still, scale * root, u.dot(vo)))
    inverse = point.name("ir", trace.where(still, 0, 1) / root)
    across = vo - trace.vector("ru", size_du * u)
    results = (total * root, *u, size_du, *(across / scale * inverse))
    return trace.program("axis_of", results, ("r", "u1", "u2", "u3", "ro", "u1o", "u2o", "u3o"))


def _sum(trace: Geometry, v: Vector) -> Number:
    first, second, third = map(trace.abs, v)
    return first + second + third


def _axis_where(trace: Geometry, point: Point, selected: Number) -> Axis:
    """Return |v| and v/|v| where ``selected``, for Re v ≠ 0; elsewhere unused numbers that spoil no gradient."""
    size = point.name("r", trace.sqrt(trace.where(selected, point.x, 1 + point.x)))
    u = trace.vector("u", point.re / size)
    size_du = point.name("ro", u.dot(point.du))
    moment = trace.vector("uo", (point.du - trace.vector("ru", size_du * u)) / size)
    return size, u, size_du, moment


def _turned(trace: Geometry, point: Point, axis: Axis, cosine: Number, sine: Number) -> tuple[Number, ...]:
    """Return the vector turned along u: the coefficient r becomes rk, and the dual part contains the slope drk/dr."""
    size, u, size_du, moment = axis
    length, slope, _ = trace.ask("turned", (size, cosine, sine))
    length_du = point.name("rko", size_du * slope)
    return (*(length * u), *(length * moment + length_du * u))


def to_screw(trace: Geometry) -> Program:
    """Angle α in [0, π] and axis u of v, CP23 Theorem 3.

    The dual part of α is r° dα/dr, along the axis u.
    """
    point = trace.point()
    size, u, size_du, moment = _axis(trace, point)
    angle, slope, sign = trace.ask("natural", (point.x, point.y, size))
    return trace.program("to_screw", (angle, sign * (slope * size_du), *(sign * u), *(sign * moment)))


def angle(trace: Geometry) -> Program:
    """Angle α of v on its own branch.

    The dual part is r° (f + x h), since dα/dr = f + x h.
    """
    point = trace.point()
    _, _, distance, _ = _axis(trace, point)
    f, _, h = point.scalars("pose_scalars")
    resting = trace.name("resting", trace.equal(point.x, 0))
    length = trace.name("rown", trace.sqrt(trace.where(resting, 1 + point.x, point.x)))
    (own,) = trace.ask("unfolded", (point.x, length))
    return trace.program("angle", (trace.where(resting, point.x, own), distance * (f + point.x * h)))


def from_screw(trace: Geometry) -> Program:
    """Vector v = φ(α) u, in dual numbers."""
    angle, distance = trace.inputs("angle", ("alpha", "alphao"))
    line = trace.argument("line", "u")
    u, moment = line.re, line.du
    size, slope = trace.ask("coefficient", (angle,))
    size_du = trace.name("ro", distance * slope)
    return trace.program("from_screw", (*(size * u), *(size * moment + size_du * u)))
