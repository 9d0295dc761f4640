"""Switch to the principal branch with the rate and the covariance of v, for targets that compose nothing."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

from ..programs.value import Number
from .groups import dual_product
from .kinematics import tangent, tangent_inv
from .point import LAYOUTS, TABLE, Geometry, Point, Results, dual_tensor
from .shadows import none_of, returned


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
