"""Forward maps: dual quaternion, orthogonal dual tensor, pose, moved points and lines. No branch, no singular point."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...algebra import Vector
from ..programs.program import Program
from ..programs.value import Number
from .inputs import dual_vector, flat, vector
from .point import Geometry, Point

Rows = tuple[Vector, Vector, Vector]


def rotate(point: Point, f: Number, g: Number, r: Vector, letter: str) -> Vector:
    """Q r = r + f v × r + v × (g v × r); the products are named after the letter of r."""
    turned = named(point.trace, f"v_{letter}", point.re.cross(r))
    twice = named(point.trace, f"gv_{letter}", g * turned)
    moved: Vector = r + (f * turned + point.re.cross(twice))
    return moved


def translation(point: Point, f: Number, g: Number, h: Number) -> Vector:
    """rho = Re(T) v°: the dual part of R is rho × Q."""
    v, vo = point.re, point.du
    gv = named(point.trace, "gv" + point.mark, g * v)
    along = point.name("along", h * point.y)
    rho: Vector = f * vo + gv.cross(vo) + along * v
    return rho


def rotation_rows(point: Point, f: Number, g: Number) -> Rows:
    """Q = I + f skew(v) + g skew(v)², whose diagonal is 1 - g (x - v_i²)."""
    first, second, third = point.squares
    name, mark = point.name, point.mark
    across = (name("x23", second + third), name("x13", first + third), name("x12", first + second))
    _, v2, v3 = point.re
    f1, f2, f3 = named(point.trace, "fv" + mark, f * point.re)
    g1, g2, _ = named(point.trace, "gv" + mark, g * point.re)
    g12, g13, g23 = named(point.trace, "gvv" + mark, Vector(g1 * v2, g1 * v3, g2 * v3))
    return (
        Vector(1 - g * across[0], g12 - f3, g13 + f2),
        Vector(g12 + f3, 1 - g * across[1], g23 - f1),
        Vector(g13 - f2, g23 + f1, 1 - g * across[2]),
    )


def named(trace: Geometry, letter: str, value: Vector) -> Vector:
    """Name the three components of a vector."""
    return Vector(*(trace.name(f"{letter}{i}", component) for i, component in enumerate(value, 1)))


def named_rows(trace: Geometry, letter: str, rows: Rows) -> Rows:
    first, second, third = (named(trace, f"{letter}{i}", row) for i, row in enumerate(rows, 1))
    return first, second, third


def quaternion(trace: Geometry) -> Program:
    point = start(trace)
    s, w, sy, wy = point.scalars("quaternion")
    turned = point.name("wo", wy * point.y)
    return trace.program("quaternion", (s, *(w * point.re), sy * point.y, *(w * point.du + turned * point.re)))


def tensor(trace: Geometry) -> Program:
    point = start(trace)
    f, g, h = point.scalars("pose")
    rows = named_rows(point.trace, "Q", rotation_rows(point, f, g))
    rho = named(point.trace, "rho", translation(point, f, g, h))
    return trace.program("tensor", (*flat(rows), *flat(cross_rows(rho, rows))))


def cross_rows(rho: Vector, rows: Rows) -> Rows:
    """skew(rho) Q by rows."""
    first, second, third = rows
    r1, r2, r3 = rho
    return r2 * third - r3 * second, r3 * first - r1 * third, r1 * second - r2 * first


def pose(trace: Geometry) -> Program:
    point = start(trace)
    f, g, h = point.scalars("pose")
    last: Iterable[Number] = (0, 0, 0, 1)
    rows, rho = rotation_rows(point, f, g), translation(point, f, g, h)
    return trace.program("pose", (*_beside(rows, rho), *last))


def _beside(rows: Rows, column: Vector) -> Iterator[Number]:
    for row, entry in zip(rows, column, strict=True):
        yield from (*row, entry)


def transform_point(trace: Geometry) -> Program:
    point = start(trace)
    r = vector(trace, "r", "r")
    f, g, h = point.scalars("pose")
    return trace.program("transform_point", rotate(point, f, g, r, "r") + translation(point, f, g, h))


def transform_line(trace: Geometry) -> Program:
    """R l = Q l + eps (Q m + rho × Q l) for a line of direction l and moment m."""
    point = start(trace)
    parts = trace.inputs("line", ("l1", "l2", "l3", "m1", "m2", "m3"))
    f, g, h = point.scalars("pose")
    direction = named(trace, "Ql", rotate(point, f, g, Vector(*parts[:3]), "l"))
    moment = rotate(point, f, g, Vector(*parts[3:]), "m")
    rho = named(trace, "rho", translation(point, f, g, h))
    return trace.program("transform_line", (*direction, *(moment + rho.cross(direction))))


def inverse(trace: Geometry) -> Program:
    """R(−v) = R(v)ᵀ."""
    point = start(trace)
    return trace.program("inverse", [-component for component in (*point.re, *point.du)])


def start(trace: Geometry) -> Point:
    """The vector v that is the first argument."""
    return Point(trace, dual_vector(trace, "v", "v"))
