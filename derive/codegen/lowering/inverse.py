"""Inverse maps and composition.

Each inverse map computes Re v; the dual part follows as v° = T⁻¹ ρ, with T = Re dcay at Re v. Signs follow the
principal quaternion, which has a scalar part >= 0. A scalar part 0 leaves the given vector part unchanged.
"""

from __future__ import annotations

from ...algebra import Quaternion, Vector
from ..programs.value import Number
from .forward import rotated, rows_of, translation
from .kinematics import opposite
from .point import Geometry, Numbers, Point, Results


def dual_part(trace: Geometry, fi: Number, hi: Number, v: Vector, rho: Vector) -> Vector:
    """Return the dual part v° = T⁻¹ ρ = (fi ρ − v × ρ + hi (v·ρ) v)/2."""
    along = trace.name("along", hi * v.dot(rho))
    du: Vector = (fi * rho - v.cross(rho) + along * v) / 2
    return du


def vector_of(trace: Geometry) -> Results:
    """Vector v = gain vec e of a quaternion e.

    The dual part is v° = T⁻¹ ρ.
    """
    (gain,) = trace.numbers("gain")
    e0, *vector = trace.components("e", "e", 4)
    rho = trace.real_vector("rho", dual="°")
    v = trace.vector("v", gain * Vector(*vector))
    fi, hi = trace.ask("inverse_scalars", (Point(trace, (*v, 0, 0, 0)).x, trace.name("fe", gain * e0)))
    return *v, *dual_part(trace, fi, hi, v, rho)


def quaternion_of(trace: Geometry) -> Results:
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
    return _positive(trace, entries)


def _positive(trace: Geometry, entries: tuple[Number, ...]) -> tuple[Number, ...]:
    """Return a quaternion or its opposite, so that the first component that is not 0 is positive."""
    negative: Number = trace.less(entries[3], 0)
    for entry in (entries[2], entries[1], entries[0]):
        negative = trace.either(trace.less(entry, 0), trace.both(trace.equal(entry, 0), negative))
    sign = trace.name("sign", trace.where(negative, -1, 1))
    return tuple(sign * entry for entry in entries)


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


def product(trace: Geometry, second: Numbers, first: Numbers) -> tuple[Numbers, Numbers, Numbers]:
    """Return e and ρ of R(second) R(first), and the sizes of both quaternions."""
    *e2, size2, f, g, r1, r2, r3 = trace.apply(displacement, "{}_2", second)
    *e1, size1, _, _, s1, s2, s3 = trace.apply(displacement, "{}_1", first)
    found = trace.apply(composed, "{}", e2, f, g, second, (r1, r2, r3), e1, (s1, s2, s3))
    return found[:4], found[4:], (size2, size1)


def from_quaternion(trace: Geometry) -> Results:
    """Vector v = gain vec q̂ of a unit dual quaternion q̂, CP23 (47).

    The dual part is v° = T⁻¹ ρ with ρ = 2 vect(q̂° q̂*), CP23 Theorem 5.
    """
    parts = trace.inputs("e", [f"e{i}{mark}" for mark in ("", "o") for i in range(4)])
    e, eo = Quaternion.from_components(parts[:4]), Quaternion.from_components(parts[4:])
    rho = 2 * (e.scalar * eo.vector - eo.scalar * e.vector + e.vector.cross(eo.vector))
    (gain,) = trace.ask("gain_unit", tuple(e))
    return trace.apply(vector_of, "v{}", gain, e, rho)


def from_tensor(trace: Geometry) -> Results:
    """Vector v of a rotation Q, computed from its quaternion.

    The dual part is v° = T⁻¹ ρ with ρ = vect(R° Qᵀ), R° = skew(ρ) Q.
    """
    entries = trace.inputs("R", [f"R{i}{j}{mark}" for mark in ("", "o") for i in (1, 2, 3) for j in (1, 2, 3)])
    rotation, dual = rows_of(entries[:9]), rows_of(entries[9:])
    product = [[d.dot(q) for q in rotation] for d in dual]
    rho = Vector(product[2][1] - product[1][2], product[0][2] - product[2][0], product[1][0] - product[0][1]) / 2
    return _from_rotation(trace, entries[:9], rho)


def from_pose(trace: Geometry) -> Results:
    """Vector v of a homogeneous matrix [[Q, ρ], [0, 1]], with the dual part v° = T⁻¹ ρ."""
    entries = trace.inputs("T", [f"{'Q' if j < 4 else 'T'}{i}{j}" for i in (1, 2, 3, 4) for j in (1, 2, 3, 4)])
    rotation = (*entries[:3], *entries[4:7], *entries[8:11])
    return _from_rotation(trace, rotation, (entries[3], entries[7], entries[11]))


def _from_rotation(trace: Geometry, Q: tuple[Number, ...], rho: Vector | tuple[Number, ...]) -> tuple[Number, ...]:
    e = trace.apply(quaternion_of, "e{}", Q)
    (gain,) = trace.ask("gain_positive", e)
    return trace.apply(vector_of, "v{}", gain, e, rho)


def compose(trace: Geometry) -> Results:
    """Principal vector v of R(v2) R(v1), CP23 (58)."""
    v2, v1 = trace.components("v2", "b", 6), trace.components("v1", "a", 6)
    e, rho, sizes = product(trace, v2, v1)
    (gain,) = trace.ask("gain_product", (*e, *sizes))
    return trace.apply(vector_of, "v{}", gain, e, rho)


def between(trace: Geometry) -> Results:
    """Principal vector v of R(v1)⁻¹ R(v2), where R(v1)⁻¹ = R(−v1)."""
    v2, v1 = trace.components("v2", "b", 6), trace.components("v1", "a", 6)
    return trace.apply(compose, "v{}", opposite(v1), v2)
