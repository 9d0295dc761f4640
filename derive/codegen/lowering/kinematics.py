"""Tangent operator and its inverse: as dual tensors, and applied to rates and twists in either frame.

Both are ``a I + skew(s) + c v⊗v`` with s a multiple of v; dual parts of the scalars are slopes times y = v·v°. The body
forms are the transposes, which differ by the sign of s alone: a constant, the side, says which is meant.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from ...algebra import Vector
from ..programs.program import Program
from ..programs.value import Number
from .forward import Rows, named, start
from .inputs import dual_vector, flat
from .point import Geometry, Point


@dataclass(frozen=True, slots=True)
class Operator:
    """``a I + skew(s) + c v⊗v`` at a point, real and dual parts (marked o); of opposite hand ``a I − skew(s) + …``."""

    point: Point
    a: Number
    ao: Number
    s: Vector
    so: Vector
    c: Number
    co: Number
    opposite: bool = False

    def entries(self, transposed: bool = False) -> Iterator[Number]:
        """Real part, then dual part, in C order; or those of the transpose."""
        point = self.point
        v, vo = tuple(point.re), tuple(point.du)
        cv = tuple(named(point.trace, "cv" + point.mark, self.c * point.re))
        dv = tuple(named(point.trace, "cvo" + point.mark, self.c * point.du + self.co * point.re))
        re = _assemble(point, "", self.a, self.s, lambda i, j: cv[i] * v[j])
        du = _assemble(point, "o", self.ao, self.so, lambda i, j: cv[i] * vo[j] + dv[i] * v[j])
        for rows in (re, du):
            yield from flat(tuple(map(Vector, *rows)) if transposed else rows)

    def _turn(self, s: Vector, w: Vector) -> Vector:
        return w.cross(s) if self.opposite else s.cross(w)

    def apply(self, w: Vector, wo: Vector) -> tuple[Vector, Vector]:
        """The image of a dual vector w + eps w°."""
        point = self.point
        v, vo, name = point.re, point.du, point.trace.name
        along = name("vw", v.dot(w))
        along_du = vo.dot(w) + v.dot(wo)
        scale = name("cvw", self.c * along)
        scale_du = name("cvwo", self.c * along_du + self.co * along)
        real = self.a * w + self._turn(self.s, w) + scale * v
        direct = self.a * wo + self.ao * w + self._turn(self.s, wo) + self._turn(self.so, w)
        return real, direct + (scale * vo + scale_du * v)


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
    return operator_of(point, point.scalars("tangent"), side)


def operator_of(point: Point, scalars: Sequence[Number], side: Number = 1) -> Operator:
    """The same of f, g, h and their slopes."""
    f, g, h, fy, gy, hy = scalars
    fo, go, ho = (point.name(letter, slope * point.y) for letter, slope in (("fo", fy), ("go", gy), ("ho", hy)))
    turn, turn_du = point.name("gs", g * side), point.name("gso", go * side)
    s = named(point.trace, "gv" + point.mark, turn * point.re)
    so = named(point.trace, "gvo" + point.mark, turn * point.du + turn_du * point.re)
    return Operator(point, f, fo, s, so, h, ho)


def tangent(trace: Geometry) -> Program:
    return trace.program("tangent", tangent_operator(start(trace)).entries())


def body_tangent(trace: Geometry) -> Program:
    """Tᵀ, the entries of T in another order."""
    return trace.program("body_tangent", tangent_operator(start(trace)).entries(transposed=True))


def twist(trace: Geometry) -> Program:
    """T v̇, or with the side -1 its transpose."""
    point = start(trace)
    w = _dual_argument(trace, "v_dot")
    (side,) = trace.inputs("table", ("side",))
    real, dual = tangent_operator(point, side).apply(*w)
    return trace.program("twist", (*real, *dual))


def tangent_inv(trace: Geometry) -> Program:
    return trace.program("tangent_inv", _inverse_operator(start(trace)).entries())


def body_tangent_inv(trace: Geometry) -> Program:
    """T⁻ᵀ, the entries of T⁻¹ in another order."""
    return trace.program("body_tangent_inv", _inverse_operator(start(trace)).entries(transposed=True))


def _inverse_operator(point: Point) -> Operator:
    """T⁻¹ = fi/2 I - skew(v)/2 + hi/2 v⊗v."""
    fi, hi, fiy, hiy = point.scalars("tangent_inv")
    half = point.name("yh", point.y / 2)
    s, so = (named(point.trace, letter + point.mark, part / -2) for letter, part in (("s", point.re), ("so", point.du)))
    a, ao = point.name("fih", point.trace.div(fi, 2)), point.name("fio", fiy * half)
    c, co = point.name("hih", point.trace.div(hi, 2)), point.name("hio", hiy * half)
    return Operator(point, a, ao, s, so, c, co)


def rate(trace: Geometry) -> Program:
    """T⁻¹ ω = (fi ω - v × ω + hi (v·ω) v)/2, or with the side -1 its transpose, which has + v × ω.

    A side σ stands in σ/2 (σ fi ω - v × ω + σ hi (v·ω) v): so it multiplies scalars, and half of it the whole.
    """
    point = start(trace)
    w = _dual_argument(trace, "omega")
    side, half = trace.inputs("table", ("side", "half"))
    fi, hi, fiy, hiy = point.scalars("tangent_inv")
    y = point.name("ys", point.y * side)
    a, ao = point.name("fis", fi * side), point.name("fio", fiy * y)
    c, co = point.name("his", hi * side), point.name("hio", hiy * y)
    real, dual = Operator(point, a, ao, point.re, point.du, c, co, opposite=True).apply(*w)
    return trace.program("rate", (*(half * real), *(half * dual)))


def _dual_argument(trace: Geometry, argument: str) -> tuple[Vector, Vector]:
    w = dual_vector(trace, argument, "w")
    return Vector(*w[:3]), Vector(*w[3:])
