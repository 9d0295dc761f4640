"""Forward maps, regular and without branch: dual quaternion, orthogonal dual tensor, pose, moved points and lines."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Sequence

from ...algebra import Quaternion, Vector
from ...maps import Cayley
from ..programs.program import Number
from .point import Geometry, Point, Results

Rows = tuple[Vector, Vector, Vector]


def flat(rows: Iterable[Iterable[Number]]) -> Iterator[Number]:
    """Yield the entries of a matrix in C order."""
    return itertools.chain.from_iterable(rows)


def rows_of(entries: Sequence[Number]) -> Rows:
    return Vector(*entries[:3]), Vector(*entries[3:6]), Vector(*entries[6:])


def rotation(point: Point, f: Number, g: Number) -> Rows:
    """Return the rows of Q = I + f skew(v) + g skew(v)², with the diagonal 1 − g (x − v_i²)."""
    trace = point.trace
    first, second, third = point.squares
    squares = (("x23", second + third), ("x13", first + third), ("x12", first + second))
    x23, x13, x12 = (trace.name(name, value) for name, value in squares)
    _, v2, v3 = point.re
    f1, f2, f3 = trace.vector("fv", f * point.re)
    g1, g2, _ = trace.vector("gv", g * point.re)
    g12, g13, g23 = trace.vector("gvv", Vector(g1 * v2, g1 * v3, g2 * v3))
    return (
        Vector(1 - g * x23, g12 - f3, g13 + f2),
        Vector(g12 + f3, 1 - g * x13, g23 - f1),
        Vector(g13 - f2, g23 + f1, 1 - g * x12),
    )


def translation(point: Point, f: Number, g: Number, h: Number) -> Vector:
    """Return the translation ρ = Re(T) v° = f v° + g v × v° + h (v·v°) v; the dual part of R is skew(ρ) Q."""
    v, vo = point.re, point.du
    gv = point.trace.vector("gv" + point.mark, g * v)
    along = point.name("along", h * point.y)
    rho: Vector = f * vo + gv.cross(vo) + along * v
    return rho


def rotated(trace: Geometry, v: Vector, f: Number, g: Number, r: Vector) -> Vector:
    """Return the rotated vector Q r = r + f v × r + v × (g v × r)."""
    turned = trace.vector("vr", v.cross(r))
    twice = trace.vector("gvr", g * turned)
    moved: Vector = r + (f * turned + v.cross(twice))
    return moved


def crossed(a: Vector, rows: Rows) -> Iterator[Number]:
    """Return the entries of skew(a) B, given the rows of B."""
    a1, a2, a3 = a
    first, second, third = rows
    return flat((a2 * third - a3 * second, a3 * first - a1 * third, a1 * second - a2 * first))


def rotate_at(trace: Geometry) -> Results:
    """Rotated vector Q r = r + f v × r + v × (g v × r), at the real part of v."""
    f, g = trace.numbers("f", "g")
    return rotated(trace, trace.point().re, f, g, trace.real_vector("r"))


def tensor_at(trace: Geometry) -> Results:
    """Tensor R = Q of the scalars f and g, CP23 (57).

    The dual part is skew(ρ) Q, with ρ of f, g and h.
    """
    f, g, h = trace.numbers("f", "g", "h")
    point = trace.point()
    first, second, third = rotation(point, f, g)
    Q = trace.vector("Q1", first), trace.vector("Q2", second), trace.vector("Q3", third)
    rho = trace.vector("rho", translation(point, f, g, h))
    return *flat(Q), *crossed(rho, Q)


def quaternion(trace: Geometry) -> Results:
    """Unit quaternion q̂ = s + w v, CP23 (50)."""
    point = trace.point()
    s, w, sy, wy = point.scalars("quaternion_scalars")
    turned = trace.name("wo", wy * point.y)
    return s, *(w * point.re), sy * point.y, *(w * point.du + turned * point.re)


def tensor(trace: Geometry) -> Results:
    """Orthogonal tensor R = I + f skew(v) + g skew(v)², CP23 (57)."""
    point = trace.point()
    return trace.apply(tensor_at, "R{}", *point.scalars("pose_scalars"), point.components)


def pose(trace: Geometry) -> Results:
    """Homogeneous matrix [[Q, ρ], [0, 1]] of R = Q + ε skew(ρ) Q, CP23 (16), (57)."""
    point = trace.point()
    f, g, h = point.scalars("pose_scalars")
    pairs = zip(rotation(point, f, g), translation(point, f, g, h), strict=True)
    beside = (entry for row, last in pairs for entry in (*row, last))
    return *beside, 0, 0, 0, 1


def transform_point(trace: Geometry) -> Results:
    """Image Q r of a point r.

    The translation ρ is added: Q r + ρ.
    """
    point, r = trace.point(), trace.real_vector("r")
    f, g, h = point.scalars("pose_scalars")
    return rotated(trace, point.re, f, g, r) + translation(point, f, g, h)


def transform_line(trace: Geometry) -> Results:
    """Image R l = Q l + ε (Q m + ρ × Q l) of a line with direction l and moment m, CP23 (66)."""
    point, parts = trace.point(), trace.inputs("line", ("l1", "l2", "l3", "m1", "m2", "m3"))
    f, g, h = point.scalars("pose_scalars")
    direction = Vector(*trace.apply(rotate_at, "Ql{}", f, g, point.components, parts[:3]))
    moment = Vector(*trace.apply(rotate_at, "Qm{}", f, g, point.components, parts[3:]))
    rho = trace.vector("rho", translation(point, f, g, h))
    return *direction, *(moment + rho.cross(direction))


def inverse(trace: Geometry) -> Results:
    """Vector −v of the inverse: R(−v) = R(v)ᵀ."""
    return [-component for component in trace.point().components]


LOCAL = Cayley(2)  # chart of the displacement within a step: the lowest order that is regular up to a whole turn


def product(trace: Geometry) -> Results:
    """Product a b of two dual quaternions.

    The dual part is a b° + a° b.
    """
    (a, ao), (b, bo) = _parts(_given(trace, "a")), _parts(_given(trace, "b"))
    return *(a * b), *(a * bo + ao * b)


def normalized(trace: Geometry) -> Results:
    """Unit dual quaternion q/√(q q*) of a dual quaternion q."""
    q, qo = _parts(_given(trace, "q"))
    square = trace.name("square", q.norm2())
    along = trace.name("along", (q.scalar * qo.scalar + q.vector.dot(qo.vector)) / square)
    size = trace.name("size", trace.sqrt(square))
    return *(q / size), *((qo - q * along) / size)


def pose_of(trace: Geometry) -> Results:
    """Rows [Q, ρ] of the pose of a unit dual quaternion."""
    q, qo = _parts(_given(trace, "q"))
    Q = rotation(Point(trace, (*q.vector, 0, 0, 0)), trace.name("f", 2 * q.scalar), 2)
    rho = 2 * (q.scalar * qo.vector - qo.scalar * q.vector + q.vector.cross(qo.vector))
    return flat((*row, last) for row, last in zip(Q, rho, strict=True))


def tensor_of(trace: Geometry) -> Results:
    """Orthogonal dual tensor Q of a unit dual quaternion.

    The dual part is skew(ρ) Q.
    """
    rows = trace.apply(pose_of, "P{}", _given(trace, "q"))
    Q = (*rows[0:3], *rows[4:7], *rows[8:11])
    return *Q, *crossed(Vector(*rows[3::4]), rows_of(Q))


PROGRAMS = product, normalized, pose_of, tensor_of  # recipes; each follows the ones that it calls


def _given(trace: Geometry, argument: str) -> tuple[Number, ...]:
    return trace.inputs(argument, [f"{argument}{i}{mark}" for mark in ("", "o") for i in range(4)])


def _parts(components: tuple[Number, ...]) -> tuple[Quaternion, Quaternion]:
    return Quaternion.from_components(components[:4]), Quaternion.from_components(components[4:])
