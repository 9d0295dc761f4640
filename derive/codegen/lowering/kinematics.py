"""Tangent operator and its inverse: as dual tensors, and applied to rates and twists in either frame.

Both are ``a I + skew(s) + c v⊗v`` with s a multiple of v; dual parts of the scalars are x-derivatives times
x° = 2 v·v°. The body forms are the transposes: s changes its sign.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

from ...algebra import Vector
from ..program import Program
from ..trace import Number, Trace
from .chart import CayleyChart
from .forward import Rows, named
from .inputs import dual_vector, flat


@dataclass(frozen=True, slots=True)
class Operator:
    """``a I + skew(s) + c v⊗v`` at a chart point, real and dual parts (marked o)."""

    chart: CayleyChart
    a: Number
    ao: Number
    s: Vector
    so: Vector
    c: Number
    co: Number
    transposed: bool = False

    def transpose(self) -> Operator:
        return replace(self, transposed=not self.transposed)

    def _turn(self, s: Vector, w: Vector) -> Vector:
        return w.cross(s) if self.transposed else s.cross(w)

    def entries(self) -> Iterator[Number]:
        """Real part, then dual part, in C order."""
        chart = self.chart
        v, vo = tuple(chart.re), tuple(chart.du)
        cv = tuple(named(chart.trace, "cv", self.c * chart.re))
        dv = tuple(named(chart.trace, "cvo", self.c * chart.du + self.co * chart.re))
        yield from flat(_assemble(chart, "", self.a, self.s, lambda i, j: cv[i] * v[j]))
        yield from flat(_assemble(chart, "o", self.ao, self.so, lambda i, j: cv[i] * vo[j] + dv[i] * v[j]))

    def apply(self, w: Vector, wo: Vector) -> Iterator[Number]:
        """The image of a dual vector w + eps w°."""
        chart = self.chart
        v, vo, name = chart.re, chart.du, chart.trace.name
        along = name("vw", v.dot(w))
        along_du = vo.dot(w) + v.dot(wo)
        scale = name("cvw", self.c * along)
        yield from self.a * w + self._turn(self.s, w) + scale * v
        scale_du = name("cvwo", self.c * along_du + self.co * along)
        direct = self.a * wo + self.ao * w + self._turn(self.s, wo) + self._turn(self.so, w)
        yield from direct + (scale * vo + scale_du * v)


def _assemble(chart: CayleyChart, mark: str, a: Number, s: Vector, dyad: Callable[[int, int], Number]) -> Rows:
    """a I + skew(s) + a symmetric dyad given by its entries on and above the diagonal."""
    s1, s2, s3 = s
    off = [(0, 1), (0, 2), (1, 2)]
    d12, d13, d23 = (chart.name(f"d{i + 1}{j + 1}{mark}", dyad(i, j)) for i, j in off)
    return (
        Vector(a + dyad(0, 0), d12 - s3, d13 + s2),
        Vector(d12 + s3, a + dyad(1, 1), d23 - s1),
        Vector(d13 - s2, d23 + s1, a + dyad(2, 2)),
    )


def tangent_operator(chart: CayleyChart) -> Operator:
    """dcay = f I + g skew(v) + h v⊗v."""
    trace = chart.trace
    xo = chart.name("xo", 2 * chart.y)
    fo, go, ho = (
        chart.name(letter + "o", slope * xo)
        for letter, slope in (("f", chart.df), ("g", chart.dg), ("h", chart.dh))
    )
    s = named(trace, "gv", chart.g * chart.re)
    so = named(trace, "gvo", chart.g * chart.du + go * chart.re)
    return Operator(chart, chart.f, fo, s, so, chart.h, ho)


def inverse_operator(chart: CayleyChart) -> Operator:
    """dcay⁻¹ = fi I - skew(v)/2 + hi v⊗v."""
    trace = chart.trace
    xo = chart.name("xo", 2 * chart.y)
    (fi, hi), (slope_f, slope_h) = chart.inverse, chart.inverse_derivatives
    s, so = named(trace, "s", chart.re / -2), named(trace, "so", chart.du / -2)
    return Operator(chart, fi, chart.name("fio", slope_f * xo), s, so, hi, chart.name("hio", slope_h * xo))


def tangent(order: int) -> Program:
    chart = _start(order)
    return chart.trace.program("tangent", tangent_operator(chart).entries())


def tangent_inv(order: int) -> Program:
    chart = _start(order)
    return chart.trace.program("tangent_inv", inverse_operator(chart).entries())


def twist(order: int) -> Program:
    return _applied("twist", order, tangent_operator, "v_dot")


def rate(order: int) -> Program:
    return _applied("rate", order, inverse_operator, "omega")


def body_twist(order: int) -> Program:
    return _applied("body_twist", order, lambda chart: tangent_operator(chart).transpose(), "v_dot")


def body_rate(order: int) -> Program:
    return _applied("body_rate", order, lambda chart: inverse_operator(chart).transpose(), "omega")


def _applied(name: str, order: int, operator: Callable[[CayleyChart], Operator], argument: str) -> Program:
    chart = _start(order)
    w = dual_vector(chart.trace, argument, "w")
    return chart.trace.program(name, operator(chart).apply(Vector(*w[:3]), Vector(*w[3:])))


def _start(order: int) -> CayleyChart:
    trace = Trace()
    return CayleyChart(trace, order, dual_vector(trace, "v", "v"))
