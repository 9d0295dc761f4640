"""Inverse maps and composition; displacements as a group: the adjoint, Jacobians, change of branch.

Each inverse map computes Re v; the dual part follows as v° = T⁻¹ ρ, with T = Re dcay at Re v. Signs follow the
principal quaternion, which has a scalar part >= 0. Within rounding of half a turn, where the scalar part is 0 up to
rounding, the given vector part stands. Every component of v is NaN if a component of the argument is not finite.

The twist is ``T v̇``: a moved line ``R l`` changes by ``T v̇ × R l``, and ``R(v) = R(v2) R(v1)`` gives
``T(v) v̇ = T(v2) v̇2 + R(v2) T(v1) v̇1``.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence

from ...algebra import Quaternion, Tensor, Vector
from ...maps.real_constants import NOISE_GIVEN, near_turn
from ..programs.program import Number
from .calculus import matrix6, opposite, tangent, tangent_at, tangent_inv
from .forward import crossed, flat, rotated, rotation, rows_of, tensor, tensor_at, translation
from .point import LAYOUTS, TABLE, Geometry, Numbers, Point, Results, dual_tensor
from .shadows import none_of, returned


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


def dual_product(trace: Geometry) -> Results:
    """Product A B of two tensors.

    The tensors are dual: the dual part is A° B + A B°.
    """
    A, B = dual_tensor(trace.components("A", "A", 18)), dual_tensor(trace.components("B", "B", 18))
    found = A @ B
    return *found.re, *found.du


def adjoint(trace: Geometry) -> Results:
    """Adjoint of R as a real matrix, [[Q, 0], [skew(ρ) Q, Q]]."""
    point = trace.point()
    R = trace.apply(tensor_at, "R{}", *point.scalars("pose_scalars"), point.components)
    return trace.apply(matrix6, "J{}", R)


def transform_point_jacobians(trace: Geometry) -> Results:
    """Derivatives −skew(Q r) T and Q of a moved point by v and by r.

    The derivative by v is (T° − skew(Q r + ρ) T, T): three columns by Re v, then three columns by v°.
    """
    point, r = trace.point(), trace.real_vector("r")
    f, g, h, *slopes = point.scalars("tangent_scalars")
    v = point.components
    Q = flat(rotation(point, f, g))
    T = trace.apply(tangent_at, "T{}", f, g, h, *slopes, v)
    moved = trace.vector("moved", rotated(trace, point.re, f, g, r) + translation(point, f, g, h))
    by_v = [slope - entry for slope, entry in zip(T[9:], crossed(moved, rows_of(T[:9])), strict=True)]
    beside = (entry for i in (0, 3, 6) for entry in (*by_v[i : i + 3], *T[i : i + 3]))
    return *beside, *Q


def transform_line_jacobians(trace: Geometry) -> Results:
    """Derivatives −skew(R l) T and R of a moved line by v and by the line."""
    point, parts = trace.point(), trace.inputs("line", ("l1", "l2", "l3", "m1", "m2", "m3"))
    f, g, h, *slopes = point.scalars("tangent_scalars")
    R = trace.apply(tensor_at, "R{}", f, g, h, point.components)
    T = trace.apply(tangent_at, "T{}", f, g, h, *slopes, point.components)
    moved = dual_tensor(R) @ Vector.dual(parts[:3], parts[3:])
    turned = Tensor.skew(trace.vector("back", -moved)) @ dual_tensor(T)
    by_line = trace.apply(matrix6, "by_line{}", R)
    return *trace.apply(matrix6, "by_v{}", (*turned.re, *turned.du)), *by_line


def transition(trace: Geometry) -> Results:
    """Derivative T(v)⁻¹ T(v0) of v by its initial v0 for a given body twist; side −1 transposes T for a space twist."""
    v, v0 = trace.components("v", "v", 6), trace.components("v0", "a", 6)
    (side,) = trace.inputs(TABLE, ("side",))
    back = trace.apply(tangent_inv, "back{}", [side * c for c in v])
    start = trace.apply(tangent, "start{}", [side * c for c in v0])
    return trace.apply(matrix6, "J{}", trace.apply(dual_product, "D{}", back, start))


def compose_jacobians(trace: Geometry) -> Results:
    """Derivatives T(v)⁻¹ T(v2) and T(v)⁻¹ R(v2) T(v1) of v = compose(v2, v1), by v2 and by v1."""
    v2, v1 = trace.components("v2", "b", 6), trace.components("v1", "a", 6)
    by_second, by_first = _by_factors(trace, v2, v1)
    return *trace.apply(matrix6, "by_v2{}", by_second), *trace.apply(matrix6, "by_v1{}", by_first)


def between_jacobians(trace: Geometry) -> Results:
    """Derivatives T(v)⁻¹ R(−v1) T(v2) and −T(v)⁻¹ T(−v1) of v = compose(−v1, v2), by v2 and by v1."""
    v2, v1 = trace.components("v2", "b", 6), trace.components("v1", "a", 6)
    by_second, by_first = _by_factors(trace, opposite(v1), v2)
    return *trace.apply(matrix6, "by_v2{}", by_first), *trace.apply(matrix6, "by_v1{}", opposite(by_second))


def _by_factors(trace: Geometry, second: Numbers, first: Numbers) -> tuple[Numbers, Numbers]:
    v = trace.apply(compose, "v{}", second, first)
    back = trace.apply(tangent_inv, "back{}", v)
    T2, T1 = trace.apply(tangent, "T2{}", second), trace.apply(tangent, "T1{}", first)
    turned = trace.apply(dual_product, "R2T1{}", trace.apply(tensor, "R2{}", second), T1)
    return trace.apply(dual_product, "D2{}", back, T2), trace.apply(dual_product, "D1{}", back, turned)


def switch(trace: Geometry) -> Results:
    """Principal vector w with the rate J v̇ and the covariance J P Jᵀ, J = T(w)⁻¹ T(v); all as given if v is principal.

    P and the result are symmetric: entries below the diagonal of P are read if v is principal only.
    """
    point, rate = trace.point(), trace.point("v_dot", "d").v
    places = list(itertools.product(range(6), repeat=2))
    P = trace.inputs("covariance", [f"P{i + 1}{j + 1}{'o' * (max(i, j) > 2)}" for i, j in places])
    trace.inputs(TABLE, ())  # only the chart knows its length
    beyond, found = returned(trace, point)
    moved = tuple(trace.name(f"w{place}", c) for place, c in zip(LAYOUTS[6], found, strict=True))
    one = point.name("one", sum((c - c for c in point.components), 1 + none_of(Point(trace, moved, "w"))))
    J = _derivative(trace, point, moved)
    fixed = [[P[6 * min(i, j) + max(i, j)] for j in range(6)] for i in range(6)]
    half = [[trace.name(f"M{i}{j}", _dot(J[i], fixed[j])) for j in range(6)] for i in range(6)]
    spread = {(i, j): trace.name(f"S{i}{j}", _dot(half[i], J[j])) for i, j in places if i <= j}
    change = [_dot(row, (*rate.re, *rate.du)) for row in J]
    kept = zip((*change, *(spread[min(at), max(at)] for at in places)), (*rate.re, *rate.du, *P), strict=True)
    return *(one * c for c in moved), *(one * trace.where(beyond, new, old) for new, old in kept)


def _derivative(trace: Geometry, point: Point, moved: tuple[Number, ...]) -> list[list[Number]]:
    """Return the rows of T(w)⁻¹ T(v) as a real matrix, [[Re, 0], [Du, Re]]."""
    back, T = trace.apply(tangent_inv, "back{}", moved), trace.apply(tangent, "T{}", point.components)
    D = dual_tensor(trace.apply(dual_product, "D{}", back, T))
    upper = [[*row, 0, 0, 0] for row in D.re.rows]
    return upper + [[*du, *re] for re, du in zip(D.re.rows, D.du.rows, strict=True)]


def _dot(a: Sequence[Number], b: Sequence[Number]) -> Number:
    return sum((p * q for p, q in zip(a, b, strict=True)), start=0)
