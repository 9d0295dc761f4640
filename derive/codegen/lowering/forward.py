"""Forward maps: dual quaternion, orthogonal dual tensor, pose, moved points and lines. No branch, no singular point."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...algebra import Vector
from ..program import Program
from ..trace import Number, Trace
from .chart import CayleyChart
from .inputs import dual_vector, flat, vector

Rows = tuple[Vector, Vector, Vector]


def rotate(chart: CayleyChart, r: Vector, letter: str) -> Vector:
    """Q r = r + f v × r + v × (g v × r); the products are named after the letter of r."""
    turned = named(chart.trace, f"v_{letter}", chart.re.cross(r))
    twice = named(chart.trace, f"gv_{letter}", chart.g * turned)
    moved: Vector = r + (chart.f * turned + chart.re.cross(twice))
    return moved


def translation(chart: CayleyChart) -> Vector:
    """rho = Re(dcay) v°: the dual part of R is rho × Q."""
    v, vo = chart.re, chart.du
    gv = named(chart.trace, "gv" + chart.mark, chart.g * v)
    along = chart.name("hy", chart.h * chart.y)
    rho: Vector = chart.f * vo + gv.cross(vo) + along * v
    return rho


def rotation_rows(chart: CayleyChart) -> Rows:
    """Q = I + f skew(v) + g skew(v)², whose diagonal is 1 - g (x - v_i²)."""
    first, second, third = chart.squares
    name = chart.trace.name
    across = (name("x23", second + third), name("x13", first + third), name("x12", first + second))
    _, v2, v3 = chart.re
    f1, f2, f3 = named(chart.trace, "fv", chart.f * chart.re)
    g1, g2, _ = named(chart.trace, "gv", chart.g * chart.re)
    g12, g13, g23 = named(chart.trace, "gvv", Vector(g1 * v2, g1 * v3, g2 * v3))
    return (
        Vector(1 - chart.g * across[0], g12 - f3, g13 + f2),
        Vector(g12 + f3, 1 - chart.g * across[1], g23 - f1),
        Vector(g13 - f2, g23 + f1, 1 - chart.g * across[2]),
    )


def named(trace: Trace, letter: str, value: Vector) -> Vector:
    """Name the three components of a vector."""
    return Vector(*(trace.name(f"{letter}{i}", component) for i, component in enumerate(value, 1)))


def _named_rows(trace: Trace, letter: str, rows: Rows) -> Rows:
    first, second, third = (named(trace, f"{letter}{i}", row) for i, row in enumerate(rows, 1))
    return first, second, third


def quaternion(order: int) -> Program:
    trace, chart = _start(order)
    scalar, factor, scalar_du, factor_du = chart.quaternion
    dual = factor * chart.du + factor_du * chart.re
    return trace.program("quaternion", (scalar, *(factor * chart.re), scalar_du, *dual))


def tensor(order: int) -> Program:
    trace, chart = _start(order)
    rows = _named_rows(trace, "Q", rotation_rows(chart))
    rho = named(trace, "rho", translation(chart))
    return trace.program("tensor", (*flat(rows), *flat(cross_rows(rho, rows))))


def cross_rows(rho: Vector, rows: Rows) -> Rows:
    """skew(rho) Q by rows."""
    first, second, third = rows
    r1, r2, r3 = rho
    return r2 * third - r3 * second, r3 * first - r1 * third, r1 * second - r2 * first


def pose(order: int) -> Program:
    trace, chart = _start(order)
    last: Iterable[Number] = (0, 0, 0, 1)
    rows = rotation_rows(chart)
    rho = translation(chart)
    return trace.program("pose", (*_beside(rows, rho), *last))


def _beside(rows: Rows, column: Vector) -> Iterator[Number]:
    for row, entry in zip(rows, column, strict=True):
        yield from (*row, entry)


def transform_point(order: int) -> Program:
    trace, chart = _start(order)
    r = vector(trace, "r", "r")
    return trace.program("transform_point", rotate(chart, r, "r") + translation(chart))


def transform_line(order: int) -> Program:
    """R l = Q l + eps (Q m + rho × Q l) for a line of direction l and moment m."""
    trace, chart = _start(order)
    names = ("l1", "l2", "l3", "m1", "m2", "m3")
    parts = trace.inputs("line", names)
    direction = named(trace, "Ql", rotate(chart, Vector(*parts[:3]), "l"))
    moment = rotate(chart, Vector(*parts[3:]), "m")
    rho = named(trace, "rho", translation(chart))
    return trace.program("transform_line", (*direction, *(moment + rho.cross(direction))))


def _start(order: int) -> tuple[Trace, CayleyChart]:
    trace = Trace()
    return trace, CayleyChart(trace, order, dual_vector(trace, "v", "v"))
