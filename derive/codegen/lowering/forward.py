"""Forward maps: dual quaternion, orthogonal dual tensor, pose, moved points and lines. No branch, no singular point."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...algebra import Vector
from ..programs.program import Program
from ..programs.value import Number
from .point import Geometry


def flat(rows: Iterable[Iterable[Number]]) -> Iterator[Number]:
    """Return the entries of a matrix in C order."""
    for row in rows:
        yield from row


def rows_of(entries: tuple[Number, ...]) -> tuple[Vector, Vector, Vector]:
    """Return the rows of a matrix of nine entries."""
    return Vector(*entries[:3]), Vector(*entries[3:6]), Vector(*entries[6:9])


# --- programs that others call --------------------------------------------------------------------------------


def rotation_at(trace: Geometry) -> Program:
    """Q = I + f skew(v) + g skew(v)², CP23 (57), at the real part of v; its diagonal is 1 − g (x − v_i²)."""
    f, g = trace.numbers("f", "g")
    point = trace.point()
    first, second, third = point.squares
    across = (trace.name("x23", second + third), trace.name("x13", first + third), trace.name("x12", first + second))
    _, v2, v3 = point.re
    f1, f2, f3 = trace.vector("fv", f * point.re)
    g1, g2, _ = trace.vector("gv", g * point.re)
    g12, g13, g23 = trace.vector("gvv", Vector(g1 * v2, g1 * v3, g2 * v3))
    entries = (
        *(1 - g * across[0], g12 - f3, g13 + f2),
        *(g12 + f3, 1 - g * across[1], g23 - f1),
        *(g13 - f2, g23 + f1, 1 - g * across[2]),
    )
    return trace.program("rotation_at", entries)


def translation_at(trace: Geometry) -> Program:
    """ρ = Re(T) v° = f v° + g v × v° + h (v·v°) v: the dual part of R is skew(ρ) Q."""
    f, g, h = trace.numbers("f", "g", "h")
    point = trace.point()
    v, vo = point.re, point.du
    gv = trace.vector("gv", g * v)
    along = trace.name("along", h * point.y)
    return trace.program("translation_at", f * vo + gv.cross(vo) + along * v)


def rotate_at(trace: Geometry) -> Program:
    """Q r = r + f v × r + v × (g v × r), at the real part of v."""
    f, g = trace.numbers("f", "g")
    v, r = trace.point().re, trace.real_vector("r")
    turned = trace.vector("vr", v.cross(r))
    twice = trace.vector("gvr", g * turned)
    return trace.program("rotate_at", r + (f * turned + v.cross(twice)))


def skew_product(trace: Geometry) -> Program:
    """skew(a) B."""
    a1, a2, a3 = trace.real_vector("a")
    first, second, third = rows_of(trace.components("B", "B", 9))
    rows = (a2 * third - a3 * second, a3 * first - a1 * third, a1 * second - a2 * first)
    return trace.program("skew_product", flat(rows))


def tensor_at(trace: Geometry) -> Program:
    """R = Q of f and g, CP23 (57).

    Its dual part is skew(ρ) Q, ρ of f, g and h.
    """
    f, g, h = trace.numbers("f", "g", "h")
    v = trace.point().components
    Q = trace.apply(rotation_at, "Q{}", f, g, v)
    rho = trace.apply(translation_at, "rho{}", f, g, h, v)
    return trace.program("tensor_at", (*Q, *trace.apply(skew_product, "D{}", rho, Q)))


# --- functions ------------------------------------------------------------------------------------------------


def quaternion(trace: Geometry) -> Program:
    """q̂ = s + w v, CP23 (50)."""
    point = trace.point()
    s, w, sy, wy = point.scalars("quaternion")
    turned = trace.name("wo", wy * point.y)
    return trace.program("quaternion", (s, *(w * point.re), sy * point.y, *(w * point.du + turned * point.re)))


def tensor(trace: Geometry) -> Program:
    """R = I + f skew(v) + g skew(v)², CP23 (57)."""
    point = trace.point()
    return trace.program("tensor", trace.apply(tensor_at, "R{}", *point.scalars("pose"), point.components))


def pose(trace: Geometry) -> Program:
    """[[Q, ρ], [0, 1]] of R = Q + ε skew(ρ) Q, CP23 (16), (57)."""
    point = trace.point()
    f, g, h = point.scalars("pose")
    rows = rows_of(trace.apply(rotation_at, "Q{}", f, g, point.components))
    rho = trace.apply(translation_at, "rho{}", f, g, h, point.components)
    beside = (entry for row, last in zip(rows, rho, strict=True) for entry in (*row, last))
    return trace.program("pose", (*beside, 0, 0, 0, 1))


def transform_point(trace: Geometry) -> Program:
    """Q r of a point r.

    It moves by ρ besides.
    """
    point, r = trace.point(), trace.real_vector("r")
    f, g, h = point.scalars("pose")
    moved = trace.apply(rotate_at, "Qr{}", f, g, point.components, r)
    rho = trace.apply(translation_at, "rho{}", f, g, h, point.components)
    return trace.program("transform_point", Vector(*moved) + Vector(*rho))


def transform_line(trace: Geometry) -> Program:
    """R l = Q l + ε (Q m + ρ × Q l) of a line with direction l and moment m, CP23 (66)."""
    point, parts = trace.point(), trace.inputs("line", ("l1", "l2", "l3", "m1", "m2", "m3"))
    f, g, h = point.scalars("pose")
    direction = Vector(*trace.apply(rotate_at, "Ql{}", f, g, point.components, parts[:3]))
    moment = Vector(*trace.apply(rotate_at, "Qm{}", f, g, point.components, parts[3:]))
    rho = Vector(*trace.apply(translation_at, "rho{}", f, g, h, point.components))
    return trace.program("transform_line", (*direction, *(moment + rho.cross(direction))))


def inverse(trace: Geometry) -> Program:
    """−v: R(−v) = R(v)ᵀ."""
    return trace.program("inverse", [-component for component in trace.point().components])
