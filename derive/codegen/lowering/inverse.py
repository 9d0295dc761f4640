"""Inverse maps, shadows and composition.

Each needs only its real part: with T = Re dcay at Re v, the dual part of v is v° = T⁻¹ rho. Signs follow the principal
quaternion: scalar part >= 0, and where it is 0 the given vector part stands.
"""

from __future__ import annotations

from ...algebra import Quaternion, Vector
from ..program import Program
from ..trace import Number, Trace
from .chart import CayleyChart
from .forward import named, rotate, translation
from .inputs import dual_vector

Axis = tuple[Number, Vector, Number, Vector]
"""Magnitude and direction of a dual vector, and the dual parts of both."""


def from_quaternion(order: int) -> Program:
    trace = Trace()
    parts = trace.inputs("e", [f"e{i}{mark}" for mark in ("", "o") for i in range(4)])
    e, eo = Quaternion(parts[0], Vector(*parts[1:4])), Quaternion(parts[4], Vector(*parts[5:]))
    return _finish(trace, "from_quaternion", order, e, 1, named(trace, "rho", _translation(e, eo)))


def _translation(e: Quaternion, eo: Quaternion) -> Vector:
    """rho = 2 vect(e° e*), e* the conjugate; CP23 Theorem 5."""
    rho: Vector = 2 * (e.scalar * eo.vector - eo.scalar * e.vector + e.vector.cross(eo.vector))
    return rho


def from_tensor(order: int) -> Program:
    trace = Trace()
    entries = trace.inputs("R", [f"{part}{i}{j}" for part in "QD" for i in (1, 2, 3) for j in (1, 2, 3)])
    rotation, dual = _rows(entries[:9]), _rows(entries[9:])
    # rho = vect(Du Qᵀ) of skew(rho) Q
    product = [[d.dot(q) for q in rotation] for d in dual]
    rho = Vector(product[2][1] - product[1][2], product[0][2] - product[2][0], product[1][0] - product[0][1]) / 2
    return _from_rotation(trace, "from_tensor", order, rotation, named(trace, "rho", rho))


def from_pose(order: int) -> Program:
    trace = Trace()
    entries = trace.inputs("T", [f"{'Q' if j < 4 else 'T'}{i}{j}" for i in (1, 2, 3, 4) for j in (1, 2, 3, 4)])
    rotation = tuple(Vector(*entries[4 * i : 4 * i + 3]) for i in range(3))
    return _from_rotation(trace, "from_pose", order, rotation, Vector(entries[3], entries[7], entries[11]))


def _rows(entries: tuple[Number, ...]) -> tuple[Vector, ...]:
    return tuple(Vector(*entries[3 * i : 3 * i + 3]) for i in range(3))


def _from_rotation(trace: Trace, name: str, order: int, rotation: tuple[Vector, ...], rho: Vector) -> Program:
    e = _quaternion_of(trace, rotation)
    size = 1 if order == 1 else trace.name("size", trace.sqrt(e.norm2()))
    return _finish(trace, name, order, e, size, rho, positive=True)


def _quaternion_of(trace: Trace, rotation: tuple[Vector, ...]) -> Quaternion:
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
        entries = tuple(
            trace.name(f"z{step}{i}", trace.where(larger, new, old)) for i, (new, old) in enumerate(pairs)
        )
    return _positive(trace, entries)


def _positive(trace: Trace, entries: tuple[Number, ...]) -> Quaternion:
    """Scalar part >= 0; where it is 0, the first component of the vector part which is not 0 is positive."""
    negative: Number = trace.less(entries[3], 0)
    for entry in (entries[2], entries[1], entries[0]):
        negative = trace.either(trace.less(entry, 0), trace.both(trace.equal(entry, 0), negative))
    sign = trace.name("sign", trace.where(negative, -1, 1))
    z0, z1, z2, z3 = (trace.name(f"e{i}", sign * entry) for i, entry in enumerate(entries))
    return Quaternion(z0, Vector(z1, z2, z3))


def compose(order: int) -> Program:
    """Through the quaternion product (p2 + q2 v2)(p1 + q1 v1), unnormalised, and rho = rho2 + Q2 rho1."""
    trace = Trace()
    second = CayleyChart(trace, order, dual_vector(trace, "b", "b"), "b")
    first = CayleyChart(trace, order, dual_vector(trace, "a", "a"), "a")
    product = _quaternion(second) * _quaternion(first)
    z = Quaternion.from_components(trace.name(f"z{i}", c) for i, c in enumerate(product))
    size = trace.name("size", second.root * first.root) if _has_ladder(order) and order > 1 else 1
    moved = rotate(second, named(trace, "rhoa", translation(first)), "rho")
    return _finish(trace, "compose", order, z, size, named(trace, "rho", moved + translation(second)))


def _quaternion(chart: CayleyChart) -> Quaternion:
    """p + q v."""
    return Quaternion(chart.p, named(chart.trace, "qv" + chart.mark, chart.q * chart.re))


# --- v of a quaternion ----------------------------------------------------------------------------------------


def _has_ladder(order: int) -> bool:
    """Powers of two need no trigonometry: the half-angle formula is applied log2(n) times."""
    return order & (order - 1) == 0


def _finish(
    trace: Trace, name: str, order: int, e: Quaternion, size: Number, rho: Vector, positive: bool = False
) -> Program:
    """v = gain · e and v° = Re(dcay)⁻¹ rho, for a quaternion e of norm ``size``; ``positive`` says that e0 >= 0."""
    gain = trace.name("gain", _gain(trace, order, e, size, positive))
    re = named(trace, "v", gain * e.vector)
    chart = CayleyChart(trace, order, (*re, 0, 0, 0))
    f, h = chart.inverse
    along = trace.name("hvr", h * re.dot(rho))
    half = named(trace, "hv", re / 2)
    return trace.program(name, (*re, *(f * rho - half.cross(rho) + along * re)))


def _gain(trace: Trace, order: int, e: Quaternion, size: Number, positive: bool) -> Number:
    """tan(alpha/2n) / |vector part|, with the sign of the scalar part."""
    if order == 1:
        return 1 / e.scalar
    negative = False if positive else trace.name("negative", trace.less(e.scalar, 0))
    cosine = trace.name("cos", trace.where(negative, -e.scalar, e.scalar))
    sign = trace.where(negative, -1, 1)
    if _has_ladder(order):
        return sign / _ladder(trace, order, cosine, size)
    square = trace.name("ss", e.vector.dot(e.vector))
    still = trace.name("still", trace.equal(square, 0))
    # the root is not taken of 0: its slope there is infinite, and 0 times that is no gradient
    sine = trace.name("sin", trace.sqrt(trace.where(still, cosine, square)))
    tangent = trace.tan(trace.atan2(sine, cosine) / order)
    return sign * (trace.where(still, 1, tangent) / trace.where(still, order * cosine, sine))


def _ladder(trace: Trace, order: int, cosine: Number, size: Number) -> Number:
    """sin(alpha/2)/tan(alpha/2n) · size for n = 2^m, from cos(alpha/2) · size by half angles."""
    divisor: Number = 1
    c = cosine if order == 2 else trace.name("cos1", cosine / size)
    unit = size if order == 2 else 1
    step = 1
    while order > 2:
        order //= 2
        step += 1
        c = trace.name(f"cos{step}", trace.sqrt((1 + c) / 2))
        divisor = divisor * (2 * c)
    total = divisor * (unit + c)
    return total if unit is size else total * size


# --- shadows --------------------------------------------------------------------------------------------------


def turn(order: int) -> Program:
    """Add a multiple of pi/n to theta along the axis of v itself, given its cosine and sine."""
    trace = Trace()
    chart = CayleyChart(trace, order, dual_vector(trace, "v", "v"))
    cosine, sine = trace.inputs("cs", ("cos", "sin"))
    return trace.program("turn", _turned(chart, _axis(chart), cosine, sine))


def shadow(order: int) -> Program:
    """Add k pi/n to theta along the axis of the principal angle, u = sign(p q) v/|v|."""
    trace = Trace()
    chart = CayleyChart(trace, order, dual_vector(trace, "v", "v"))
    cosine, sine = trace.inputs("cs", ("cos", "sin"))
    sign = trace.name("sign", _axis_sign(chart))
    return trace.program("shadow", _turned(chart, _axis(chart), cosine, sign * sine))


def principal(order: int) -> Program:
    """Go back by as many steps of pi/n as bring theta to within pi/2n of zero; where it is there already, v stands.

    The table holds, for each step, the |v|² beyond which it is taken, then cosine and sine of the way back.
    """
    trace = Trace()
    v = dual_vector(trace, "v", "v")
    if order == 1:
        return trace.program("principal", v)
    chart = CayleyChart(trace, order, v)
    table = trace.inputs("table", [f"{name}{j}" for j in range(1, order // 2 + 1) for name in ("limit", "cos", "sin")])
    beyond = [trace.name(f"beyond{j}", trace.less(limit, chart.x)) for j, limit in enumerate(table[::3], 1)]
    cosine, sine = table[1:3]
    for j, (further, *values) in enumerate(zip(beyond[1:], table[4::3], table[5::3], strict=True), 2):
        cosine = trace.name(f"cosine{j}", trace.where(further, values[0], cosine))
        sine = trace.name(f"sine{j}", trace.where(further, values[1], sine))
    turned = zip(_turned(chart, _axis_where(chart, beyond[0]), cosine, sine), v, strict=True)
    return trace.program("principal", [trace.where(beyond[0], back, stays) for back, stays in turned])


def _axis_sign(chart: CayleyChart) -> Number:
    """sign(p q); where p = 0 the vector part of the quaternion decides, where q = 0 the translation along v."""
    trace = chart.trace
    negative = chart.name("pneg", trace.less(chart.p, 0))
    flipped = chart.name("qp", trace.where(negative, chart.name("mq", -chart.q), chart.q))
    backwards = trace.both(trace.equal(chart.q, 0), trace.less(chart.y, 0))
    return _in_range(chart) * trace.where(trace.either(trace.less(flipped, 0), backwards), -1, 1)


def _in_range(chart: CayleyChart) -> Number:
    """1, or NaN where p has overflowed and its sign says nothing."""
    return 1 if chart.order < 3 else chart.name("one", chart.p - chart.p + 1)


def _axis(chart: CayleyChart) -> Axis:
    """|v| and v/|v| as dual quantities; at Re v = 0 the axis is that of v°, through the origin."""
    trace = chart.trace
    v, vo = chart.re, chart.du
    still = chart.name("still", trace.equal(chart.x, 0))
    # one root, never of 0 but at the identity: so the gradient is finite wherever the axis is defined
    length = chart.name("length", trace.sqrt(trace.where(still, vo.dot(vo), chart.x)))
    size = chart.name("r", trace.where(still, chart.x, length))  # 0 of the type of x
    u = named(trace, "u", Vector(*(trace.where(still, b, a) / length for a, b in zip(v, vo, strict=True))))
    size_du = chart.name("ro", trace.where(still, length, u.dot(vo)))
    across = vo - size_du * u
    moment = named(trace, "uo", Vector(*(trace.where(still, 0, c) / length for c in across)))
    return size, u, size_du, moment


def _axis_where(chart: CayleyChart, selected: Number) -> Axis:
    """The same where it is needed, Re v ≠ 0; elsewhere numbers which are not used and spoil no gradient."""
    trace = chart.trace
    size = chart.name("r", trace.sqrt(trace.where(selected, chart.x, 1 + chart.x)))
    u = named(trace, "u", chart.re / size)
    size_du = chart.name("ro", u.dot(chart.du))
    moment = named(trace, "uo", (chart.du - size_du * u) / size)
    return size, u, size_du, moment


def _turned(chart: CayleyChart, axis: Axis, cosine: Number, sine: Number) -> tuple[Number, ...]:
    """r -> (r cos + sin)/(cos - r sin) along u; its derivative is 1/(cos - r sin)²."""
    sine = chart.name("sn", sine)
    size, u, size_du, moment = axis
    inverse = chart.name("iden", 1 / (cosine - size * sine))
    length = chart.name("rk", (size * cosine + sine) * inverse)
    length_du = chart.name("rko", size_du * (inverse * inverse))
    return (*(length * u), *(length * moment + length_du * u))


def to_screw(order: int) -> Program:
    """Dual angle and axis, CP23 Theorem 3: alpha in [0, pi], d = 2n r°/(1 + x) along the axis of that angle."""
    trace = Trace()
    chart = CayleyChart(trace, order, dual_vector(trace, "v", "v"))
    sign = trace.name("sign", _axis_sign(chart))
    size, u, size_du, moment = _axis(chart)
    positive_p = trace.where(chart.name("pneg", trace.less(chart.p, 0)), -chart.p, chart.p)
    positive_q = trace.where(trace.less(chart.q, 0), chart.name("mq", -chart.q), chart.q)
    angle = 2 * trace.atan2(size * positive_q, positive_p) * _in_range(chart)
    distance = sign * (2 * order * size_du / chart.k)
    return trace.program("to_screw", (angle, distance, *(sign * u), *(sign * moment)))


def from_screw(order: int) -> Program:
    """v = tan(alpha/2n) u over dual numbers."""
    trace = Trace()
    angle, distance = trace.inputs("angle", ("alpha", "d"))
    parts = dual_vector(trace, "axis", "u")
    u, moment = Vector(*parts[:3]), Vector(*parts[3:])
    size = trace.name("r", trace.tan(angle / (2 * order)))
    size_du = trace.name("ro", distance * (1 + size * size) / (2 * order))
    return trace.program("from_screw", (*(size * u), *(size * moment + size_du * u)))
