"""Displacements as a group: the adjoint, and Jacobians of what is moved and of what is composed.

With ``T v̇`` the twist, a moved line ``R l`` changes by ``T v̇ × R l``, and ``R(v) = R(v2) R(v1)`` gives
``T(v) v̇ = T(v2) v̇2 + R(v2) T(v1) v̇1``.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...algebra import Tensor, Vector
from ..programs.program import Program
from ..programs.value import Number
from .calculus import HALF, matrix6
from .forward import cross_rows, named, named_rows, rotate, rotation_rows, start, translation
from .inputs import dual_vector, flat, vector
from .inverse import product
from .kinematics import Operator, tangent_operator
from .point import Geometry, Point


def adjoint(trace: Geometry) -> Program:
    point = start(trace)
    return trace.program("adjoint", matrix6(trace, dual_tensor(point, *point.scalars("pose"))))


def dual_tensor(point: Point, f: Number, g: Number, h: Number) -> Tensor:
    """R = Q + eps rho × Q."""
    trace = point.trace
    rows = named_rows(trace, "Q" + point.mark, rotation_rows(point, f, g))
    rho = named(trace, "rho" + point.mark, translation(point, f, g, h))
    return Tensor.dual(Tensor.from_entries(flat(rows)), Tensor.from_entries(flat(cross_rows(rho, rows))))


def operator_tensor(operator: Operator, letter: str) -> Tensor:
    """An operator as a dual tensor with named entries."""
    entries = tuple(operator.entries())
    parts = (Tensor.from_entries(entries[:9]), Tensor.from_entries(entries[9:]))
    return named_tensor(operator.point.trace, letter, Tensor.dual(*parts))


def named_tensor(trace: Geometry, letter: str, tensor: Tensor) -> Tensor:
    places = (f"{letter}{i}{j}" for i in (1, 2, 3) for j in (1, 2, 3))
    return Tensor.from_entries(trace.dual(place, entry) for place, entry in zip(places, tensor, strict=True))


def transform_point_jacobians(trace: Geometry) -> Program:
    """``(Du T − moved × Re T, Re T)`` beside each other, and Q."""
    point = start(trace)
    r = vector(trace, "r", "r")
    f, g, h, *_ = point.scalars("tangent")
    rho = translation(point, f, g, h)
    moved = named(trace, "moved", rotate(point, f, g, r, "r") + rho)
    T = operator_tensor(tangent_operator(point), "T")
    turned = T.du - Tensor.skew(moved) @ T.re
    beside = (entry for pair in zip(turned.rows, T.re.rows, strict=True) for row in pair for entry in row)
    return trace.program("transform_point_jacobians", (*beside, *flat(rotation_rows(point, f, g))))


def transform_line_jacobians(trace: Geometry) -> Program:
    """``−skew(R l) T`` and R."""
    point = start(trace)
    parts = trace.inputs("line", ("l1", "l2", "l3", "m1", "m2", "m3"))
    R = named_tensor(trace, "R", dual_tensor(point, *point.scalars("tangent")[:3]))
    moved = trace.dual_vector("moved", R @ Vector.dual(parts[:3], parts[3:]))
    by_v = Tensor.skew(-moved) @ operator_tensor(tangent_operator(point), "T")
    return trace.program("transform_line_jacobians", (*matrix6(trace, by_v, "V"), *matrix6(trace, R, "R")))


def compose_jacobians(trace: Geometry) -> Program:
    """``(T(v)⁻¹ T(v2), T(v)⁻¹ R(v2) T(v1))``."""
    second, first = (dual_vector(trace, letter, letter) for letter in ("b", "a"))
    by_second, by_first = _by_factors(trace, second, first)
    return trace.program("compose_jacobians", (*matrix6(trace, by_second, "B"), *matrix6(trace, by_first, "A")))


def between_jacobians(trace: Geometry) -> Program:
    """The same of −v1 after v2, by v1 with a minus."""
    first, second = (dual_vector(trace, letter, letter) for letter in ("a", "b"))
    by_second, by_first = _by_factors(trace, opposite(trace, "b", second), first)
    return trace.program("between_jacobians", (*matrix6(trace, by_first, "A"), *matrix6(trace, -by_second, "B")))


def _by_factors(trace: Geometry, second: Sequence[Number], first: Sequence[Number]) -> tuple[Tensor, Tensor]:
    """Derivatives of a product by its factors."""
    after, before = Point(trace, second, "b"), Point(trace, first, "a")
    found = [trace.name(f"w{i}", c) for i, c in enumerate(product(trace, after, before), 1)]
    at = Point(trace, found, "w")
    back = operator_tensor(twice_inverse(at, at.scalars("tangent_inv")), "I")
    T2, T1 = (tangent_at(trace, v, mark) for v, mark in ((second, "S"), (first, "F")))
    R = named_tensor(trace, "R", dual_tensor(after, *after.scalars("ray")[3:]))
    return (back @ T2) * HALF, (back @ named_tensor(trace, "RT", R @ T1)) * HALF


def tangent_at(trace: Geometry, v: Sequence[Number], mark: str) -> Tensor:
    """T of a vector, which has a mark of its own."""
    return operator_tensor(tangent_operator(Point(trace, v, mark)), mark)


def twice_inverse(point: Point, scalars: Sequence[Number]) -> Operator:
    """2 T⁻¹ of f_i, h_i and their slopes; what it is multiplied with is halved in the end."""
    fi, hi, fiy, hiy = scalars
    fio, hio = (point.name(letter, slope * point.y) for letter, slope in (("fio", fiy), ("hio", hiy)))
    s, so = (named(point.trace, letter + point.mark, -part) for letter, part in (("s", point.re), ("so", point.du)))
    return Operator(point, fi, fio, s, so, hi, hio)


def opposite(trace: Geometry, letter: str, v: Sequence[Number]) -> list[Number]:
    """−v."""
    return [trace.name(f"minus_{letter}{i}", -c) for i, c in enumerate(v, 1)]


def between(trace: Geometry) -> Program:
    """R(v1)⁻¹ R(v2), R(v1)⁻¹ = R(−v1)."""
    first, second = (dual_vector(trace, letter, letter) for letter in ("a", "b"))
    back = opposite(trace, "b", second)
    return trace.program("between", product(trace, Point(trace, back, "b"), Point(trace, first, "a")))
