"""Tangent operator and its inverse: as dual tensors, and applied to rates and twists in either frame.

Both are ``a I + skew(s) + c v⊗v`` with s a multiple of v; dual parts of the scalars are slopes times y = v·v°. The body
forms are the transposes, which differ by the sign of s alone: a constant, the side, says which is meant.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from ...algebra import Vector
from ..program import Program
from ..trace import Number
from .forward import Rows, named, start
from .inputs import dual_vector, flat
from .point import Geometry, Point


@dataclass(frozen=True, slots=True)
class Operator:
    """``a I + skew(s) + c v⊗v`` at a chart point, real and dual parts (marked o)."""

    point: Point
    a: Number
    ao: Number
    s: Vector
    so: Vector
    c: Number
    co: Number

    def entries(self) -> Iterator[Number]:
        """Real part, then dual part, in C order."""
        point = self.point
        v, vo = tuple(point.re), tuple(point.du)
        cv = tuple(named(point.trace, "cv", self.c * point.re))
        dv = tuple(named(point.trace, "cvo", self.c * point.du + self.co * point.re))
        yield from flat(_assemble(point, "", self.a, self.s, lambda i, j: cv[i] * v[j]))
        yield from flat(_assemble(point, "o", self.ao, self.so, lambda i, j: cv[i] * vo[j] + dv[i] * v[j]))

    def apply(self, w: Vector, wo: Vector) -> Iterator[Number]:
        """The image of a dual vector w + eps w°."""
        point = self.point
        v, vo, name = point.re, point.du, point.trace.name
        along = name("vw", v.dot(w))
        along_du = vo.dot(w) + v.dot(wo)
        scale = name("cvw", self.c * along)
        yield from self.a * w + self.s.cross(w) + scale * v
        scale_du = name("cvwo", self.c * along_du + self.co * along)
        direct = self.a * wo + self.ao * w + self.s.cross(wo) + self.so.cross(w)
        yield from direct + (scale * vo + scale_du * v)


def _assemble(point: Point, mark: str, a: Number, s: Vector, dyad: Callable[[int, int], Number]) -> Rows:
    """a I + skew(s) + a symmetric dyad given by its entries on and above the diagonal."""
    s1, s2, s3 = s
    off = [(0, 1), (0, 2), (1, 2)]
    d12, d13, d23 = (point.name(f"d{i + 1}{j + 1}{mark}", dyad(i, j)) for i, j in off)
    return (
        Vector(a + dyad(0, 0), d12 - s3, d13 + s2),
        Vector(d12 + s3, a + dyad(1, 1), d23 - s1),
        Vector(d13 - s2, d23 + s1, a + dyad(2, 2)),
    )


def tangent_operator(point: Point, side: Number = 1) -> Operator:
    """T = f I + g skew(v) + h v⊗v, side 1; its transpose, side -1."""
    f, g, h, fy, gy, hy = point.scalars("tangent")
    fo, go, ho = (point.name(letter, slope * point.y) for letter, slope in (("fo", fy), ("go", gy), ("ho", hy)))
    turn, turn_du = point.name("gs", g * side), point.name("gso", go * side)
    s = named(point.trace, "gv", turn * point.re)
    so = named(point.trace, "gvo", turn * point.du + turn_du * point.re)
    return Operator(point, f, fo, s, so, h, ho)


def inverse_operator(point: Point, side: Number = -2) -> Operator:
    """T⁻¹ = fi I - skew(v)/2 + hi v⊗v, side -2; its transpose, side 2."""
    fi, hi, fiy, hiy = point.scalars("tangent_inv")
    fio, hio = point.name("fio", fiy * point.y), point.name("hio", hiy * point.y)
    s, so = named(point.trace, "s", point.re / side), named(point.trace, "so", point.du / side)
    return Operator(point, fi, fio, s, so, hi, hio)


def tangent(trace: Geometry) -> Program:
    return _entries(trace, "tangent", tangent_operator)


def tangent_inv(trace: Geometry) -> Program:
    return _entries(trace, "tangent_inv", inverse_operator)


def twist(trace: Geometry) -> Program:
    return _applied(trace, "twist", tangent_operator, "v_dot")


def rate(trace: Geometry) -> Program:
    return _applied(trace, "rate", inverse_operator, "omega")


def _entries(trace: Geometry, name: str, operator: Callable[[Point], Operator]) -> Program:
    return trace.program(name, operator(start(trace)).entries())


def _applied(trace: Geometry, name: str, operator: Callable[[Point, Number], Operator], argument: str) -> Program:
    point = start(trace)
    w = dual_vector(trace, argument, "w")
    return trace.program(name, operator(point, _side(point)).apply(Vector(*w[:3]), Vector(*w[3:])))


def _side(point: Point) -> Number:
    (side,) = point.trace.inputs("table", ("side",))
    return side
