"""Inverse maps and composition.

Each inverse map computes Re v; the dual part follows as v° = T⁻¹ ρ, with T = Re dcay at Re v. Signs follow the
principal quaternion, which has a scalar part >= 0. Within rounding of half a turn, where the scalar part is 0 up to
rounding, the given vector part stands. Every component of v is NaN if a component of the argument is not finite.
"""

from __future__ import annotations

from ...algebra import Quaternion, Vector
from ...maps.real_constants import NOISE_GIVEN, near_turn
from ..programs.program import Number
from .calculus import opposite
from .forward import rotated, rows_of, translation
from .point import Geometry, Numbers, Point, Results


def dual_part(trace: Geometry, fi: Number, hi: Number, v: Vector, half: Vector) -> Vector:
    """Return the dual part v° = T⁻¹ ρ = fi r − v × r + hi (v·r) v, for half the translation, r = ρ/2."""
    half = trace.vector("shift", half)
    along = trace.name("along", hi * v.dot(half))
    du: Vector = fi * half - v.cross(half) + along * v
    return du


def dual_part_at(
    trace: Geometry, fi: Number, hi: Number, ai: Number, v: Vector, half: Vector
) -> Vector:
    """Return the dual part v° = fi r − v × r + hi (v·r) v, which is ai r − v × r + v × (hi v × r) next to a whole turn.

    There fi and hi are large, with ai = fi + x hi: their errors reach only the part of v° across v, not that along v,
    which moves the pose.
    """
    near = near_turn(fi, ai, trace)
    turned, bend = trace.vector("vr", v.cross(half)), trace.name("hn", trace.where(near, hi, 0))
    along = trace.name("along", (hi - bend) * v.dot(half))
    across = trace.vector("hvr", bend * turned)
    du: Vector = trace.name("an", trace.where(near, ai, fi)) * half - turned + v.cross(across) + along * v
    return du


def vector_of(trace: Geometry) -> Results:
    """Vector v = gain vec e of a quaternion e of a size; NaN if `whole` is not finite.

    The dual part is v° = T⁻¹ ρ, with ρ = 2 r; v is NaN if r is not finite.
    """
    e0, *vector = trace.components("e", "e", 4)
    size, whole = trace.numbers("size", "whole")
    half = trace.real_vector("r", dual="°")
    (gain,) = trace.ask("gain", (e0, *vector, size))
    every = trace.name("every", sum(half, start=whole))
    factor = trace.name("factor", gain + (every - every))
    v = trace.vector("v", factor * Vector(*vector))
    fi, hi = trace.ask("inverse_scalars", (Point(trace, (*v, 0, 0, 0)).x, trace.name("fe", factor * e0)))
    return *v, *dual_part(trace, fi, hi, v, half)


def quaternion_of(trace: Geometry) -> Results:
    """Multiple of the quaternion of a rotation Q, and its size; the first component of its vector part is positive.

    The multiple is the row of 4 q qᵀ with the largest diagonal entry, which loses no digits. A first component that is
    0 up to rounding does not count.
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
    size = trace.name("size", trace.sqrt(Quaternion.from_components(entries).norm2()))
    negative = trace.less(entries[3], 0)
    for i in (2, 1):
        beside = trace.name(f"beside{i}", trace.beside(size, entries[i] / NOISE_GIVEN))
        negative = trace.either(trace.less(beside, size), trace.both(trace.equal(beside, size), negative))
    sign = trace.name("sign", trace.where(negative, -1, 1))
    names = ("0", "1", "2", "3", "size")
    return dict(zip(names, (*(sign * entry for entry in entries), size), strict=True))


def displacement(trace: Geometry) -> Results:
    """Positive multiple e of the quaternion of v, its size, and the scalars f and g.

    The translation is ρ = Re(T) v°.
    """
    point = trace.point()
    a, b, size, f, g, h = point.scalars("ray")
    rho = translation(point, f, g, h)
    names = ("e0", "e1", "e2", "e3", "size", "f°", "g°", "rho1°", "rho2°", "rho3°")
    return dict(zip(names, (a, *(b * point.re), size, f, g, *rho), strict=True))


def composed(trace: Geometry) -> Results:
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
    return dict(zip(names, (*(e2 * e1), *(rho2 + moved)), strict=True))


def product(trace: Geometry, second: Numbers, first: Numbers) -> tuple[Numbers, Numbers, Number]:
    """Return e and ρ of R(second) R(first), and the size of e."""
    *e2, size2, f, g, r1, r2, r3 = trace.apply(displacement, "{}_2", second)
    *e1, size1, _, _, s1, s2, s3 = trace.apply(displacement, "{}_1", first)
    found = trace.apply(composed, "{}", e2, f, g, second, (r1, r2, r3), e1, (s1, s2, s3))
    return found[:4], found[4:], trace.name("size", size2 * size1)


def from_quaternion(trace: Geometry) -> Results:
    """Vector v = gain vec q̂ of a dual quaternion q̂ of any norm, CP23 (47).

    The dual part is v° = T⁻¹ ρ with ρ = 2 vect(q̂° q̂*)/|q|², CP23 Theorem 5.
    """
    parts = trace.inputs("e", [f"e{i}{mark}" for mark in ("", "o") for i in range(4)])
    e, eo = Quaternion.from_components(parts[:4]), Quaternion.from_components(parts[4:])
    square = trace.name("square", e.norm2())
    size, inverse = trace.name("size", trace.sqrt(square)), trace.name("inverse", trace.div(1, square))
    half = inverse * (e.scalar * eo.vector - eo.scalar * e.vector + e.vector.cross(eo.vector))
    return trace.apply(vector_of, "v{}", e, size, trace.name("whole", square + inverse), half)


def from_tensor(trace: Geometry) -> Results:
    """Vector v of a rotation Q, computed from its quaternion.

    The dual part is v° = T⁻¹ ρ with ρ = vect(R° Qᵀ), R° = skew(ρ) Q.
    """
    entries = trace.inputs("R", [f"R{i}{j}{mark}" for mark in ("", "o") for i in (1, 2, 3) for j in (1, 2, 3)])
    rotation, dual = rows_of(entries[:9]), rows_of(entries[9:])
    product = [[d.dot(q) for q in rotation] for d in dual]
    twice = Vector(product[2][1] - product[1][2], product[0][2] - product[2][0], product[1][0] - product[0][1])
    return _from_rotation(trace, entries[:9], twice / 4)


def from_pose(trace: Geometry) -> Results:
    """Vector v of a homogeneous matrix [[Q, ρ], [0, 1]], with the dual part v° = T⁻¹ ρ."""
    entries = trace.inputs("T", [f"{'Q' if j < 4 else 'T'}{i}{j}" for i in (1, 2, 3, 4) for j in (1, 2, 3, 4)])
    rotation = (*entries[:3], *entries[4:7], *entries[8:11])
    return _from_rotation(trace, rotation, Vector(entries[3], entries[7], entries[11]) / 2, entries[12:])


def _from_rotation(trace: Geometry, Q: Numbers, half: Vector, others: Numbers = ()) -> Numbers:
    *e, size = trace.apply(quaternion_of, "e{}", Q)
    return trace.apply(vector_of, "v{}", e, size, trace.name("whole", sum(others, start=size)), half)


def compose(trace: Geometry) -> Results:
    """Principal vector v of R(v2) R(v1), CP23 (58)."""
    v2, v1 = trace.components("v2", "b", 6), trace.components("v1", "a", 6)
    e, rho, size = product(trace, v2, v1)
    return trace.apply(vector_of, "v{}", e, size, size, trace.vector("r", Vector(*rho) / 2))


def between(trace: Geometry) -> Results:
    """Principal vector v of R(v1)⁻¹ R(v2), where R(v1)⁻¹ = R(−v1)."""
    v2, v1 = trace.components("v2", "b", 6), trace.components("v1", "a", 6)
    return trace.apply(compose, "v{}", opposite(v1), v2)
