"""What each algebraic kernel function must return, from the formula alone: on ring elements exactly, or at numbers.

Formulas in x are lifted into the ring. Where they are functions of α, which no ring holds, there are numbers only.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import sympy

from ...algebra import Dual, Isotropic, Quaternion, Vector
from ...maps import Formula, x
from ...maps.chart import Chart
from ...maps.pose import pose_from_tensor
from ...proof import Ring, is_algebraic, root_of
from ..lowering.scalars import scalar_program

ROOTS = 2
"""Up to so many square roots in a row the way back, if it takes half angles only, is decided exactly (above, only the
cost forbids it)."""


@dataclass(frozen=True, slots=True)
class Expectation:
    """Arguments of a kernel function and its exact result, both as flat components."""

    function: str
    arguments: tuple[tuple[Any, ...], ...]
    result: tuple[Any, ...]


def expectations(chart: Chart, ring: Callable[..., Any] = Ring) -> Iterator[Expectation]:
    """Every algebraic function of the module of a chart, on six symbols (and six more for a rate, twist or line).

    ``ring`` makes what stands for the symbols: the exact ring, or numbers in their place.
    """
    yield from _quaternion(chart, ring)
    yield from _tensors(chart, ring)


def _symbols(ring: Any, letter: str) -> tuple[Any, ...]:
    return tuple(ring.symbol(f"{letter}{i}") for i in range(1, 7))


def _dual(components: Sequence[Any]) -> Vector:
    return Vector.dual(components[:3], components[3:])


def _lifted(ring: Any, expression: sympy.Expr, square: Dual) -> Dual:
    """f(x) + eps x° f'(x) of a formula."""
    value, slope = ring.value_and_slope(expression, x, square.re)
    return Dual(value, square.du * slope)


def _isotropic(ring: Any, formula: Formula, v: Vector) -> Isotropic:
    square = v.dot(v)
    a, b, c = (_lifted(ring, coefficient, square) for coefficient in formula.coefficients)
    return Isotropic(a, b, c, square)


def _quaternion(chart: Chart, make: Callable[..., Any]) -> Iterator[Expectation]:
    """s + w v; and back, where no trigonometry is needed."""
    ring = make(extra=("v4", "v5", "v6"), root=_root(chart, chart.quaternion.coefficients))
    components = _symbols(ring, "v")
    v = _dual(components)
    s, w = (_lifted(ring, coefficient, v.dot(v)) for coefficient in chart.quaternion.coefficients)
    quaternion = Quaternion(s, v * w)
    flat = (*quaternion.re, *quaternion.du)
    yield Expectation("quaternion", (components,), flat)
    if _goes_back_by_roots(chart):
        yield Expectation("from_quaternion", (flat,), components)


def _root(chart: Chart, coefficients: Iterable[sympy.Expr]) -> int:
    return root_of(coefficients) if is_algebraic(chart) else 0


def _goes_back_by_roots(chart: Chart) -> bool:
    """Whether the way back takes a few square roots and no trigonometry."""
    operations = scalar_program("gain_unit", chart).operations
    return not operations.keys() & {"tan", "atan2"} and operations["sqrt"] <= ROOTS


def _tensors(chart: Chart, make: Callable[..., Any]) -> Iterator[Expectation]:
    maps = (chart.tensor, chart.tangent, chart.tangent_inv)
    root = _root(chart, (coefficient for formula in maps for coefficient in formula.coefficients))
    ring = make(extra=("v4", "v5", "v6", *(f"w{i}" for i in range(1, 7))), root=root)
    components, others = _symbols(ring, "v"), _symbols(ring, "w")
    v, w = _dual(components), _dual(others)
    R, T, T_inv = (_isotropic(ring, f, v) for f in maps)
    tensors = {
        "tensor": R,
        "tangent": T,
        "tangent_inv": T_inv,
        "body_tangent": T.transpose,
        "body_tangent_inv": T_inv.transpose,
    }
    for name, operator in tensors.items():
        tensor = operator.tensor(v)
        yield Expectation(name, (components,), (*tensor.re, *tensor.du))
    applied = {
        "transform_line": R,
        "twist": T,
        "rate": T_inv,
        "body_twist": T.transpose,
        "body_rate": T_inv.transpose,
    }
    for name, operator in applied.items():
        image = operator.apply(v, w)
        yield Expectation(name, (components, others), (*image.re, *image.du))
    pose = pose_from_tensor(R.tensor(v))
    Q, rho = pose.rotation, tuple(pose.displacement)
    rows = [entry for i in range(3) for entry in (Q[i, 0], Q[i, 1], Q[i, 2], rho[i])]
    yield Expectation("pose", (components,), (*rows, 0, 0, 0, 1))
    yield Expectation("transform_point", (components, others[:3]), tuple(pose.apply(w.re)))
    yield Expectation("inverse", (components,), tuple(-c for c in components))
