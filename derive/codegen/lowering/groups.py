"""Displacements as a group: the adjoint, Jacobians of moved points and lines and of compositions, change of branch.

The twist is ``T v̇``: a moved line ``R l`` changes by ``T v̇ × R l``, and ``R(v) = R(v2) R(v1)`` gives
``T(v) v̇ = T(v2) v̇2 + R(v2) T(v1) v̇1``.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence

from ...algebra import Tensor, Vector
from ..programs.program import Number
from .calculus import matrix6, opposite, tangent, tangent_at, tangent_inv
from .forward import crossed, flat, rotated, rotation, rows_of, tensor, tensor_at, translation
from .inverse import compose
from .point import LAYOUTS, TABLE, Geometry, Numbers, Point, Results, dual_tensor
from .shadows import none_of, returned


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
