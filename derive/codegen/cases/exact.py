"""Exact expectations: what each rational kernel function must return on ring elements, from the formula alone."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import sympy

from ...algebra import Dual, Isotropic, Quaternion, Vector
from ...maps import Cayley, Formula, x
from ...maps.pose import pose_from_tensor
from ...proof import Ring

ROUND_TRIPS = (1, 2, 4, 8)
"""Orders whose inverse map takes half angles only, so that it is decided exactly (above, only the cost forbids it)."""


@dataclass(frozen=True, slots=True)
class Expectation:
    """Arguments of a kernel function and its exact result, both as flat components."""

    function: str
    arguments: tuple[tuple[Any, ...], ...]
    result: tuple[Any, ...]


def expectations(cayley: Cayley, ring: Callable[..., Any] = Ring) -> Iterator[Expectation]:
    """Every rational function of the module of an order, on six symbols (and six more for a rate, twist or line).

    ``ring`` makes what stands for the symbols: the exact ring, or numbers in their place.
    """
    yield from _quaternion(cayley, ring)
    yield from _tensors(cayley, ring)


def _symbols(ring: Any, letter: str) -> tuple[Any, ...]:
    return tuple(ring.symbol(f"{letter}{i}") for i in range(1, 7))


def _dual(components: Sequence[Any]) -> Vector:
    return Vector.dual(components[:3], components[3:])


def _lifted(ring: Any, expression: sympy.Expr, square: Dual) -> Dual:
    """f(x) + eps x° f'(x) of a rational expression."""
    value, slope = (ring.lift(e, {x: square.re}) for e in (expression, expression.diff(x)))
    return Dual(value, square.du * slope)


def _isotropic(ring: Any, formula: Formula, v: Vector) -> Isotropic:
    square = v.dot(v)
    a, b, c = (_lifted(ring, coefficient, square) for coefficient in formula.coefficients)
    return Isotropic(a, b, c, square)


def _quaternion(cayley: Cayley, make: Callable[..., Any]) -> Iterator[Expectation]:
    """(p + q v)/sⁿ with s² = 1 + x, in the ring that has s; and back, where no trigonometry is needed."""
    ring = make(extra=("v4", "v5", "v6"), root=True)
    components = _symbols(ring, "v")
    v = _dual(components)
    square = v.dot(v)
    s = ring.square_root()
    norm = Dual(s, square.du / (2 * s)) ** cayley.order
    p, q = (_lifted(ring, e, square) for e in (cayley.p, cayley.q))
    scalar, factor = p / norm, q / norm
    quaternion = Quaternion(scalar, v * factor)
    flat = (*quaternion.re, *quaternion.du)
    yield Expectation("quaternion", (components,), flat)
    if cayley.order in ROUND_TRIPS:
        yield Expectation("from_quaternion", (flat,), components)


def _tensors(cayley: Cayley, make: Callable[..., Any]) -> Iterator[Expectation]:
    ring = make(extra=("v4", "v5", "v6", *(f"w{i}" for i in range(1, 7))))
    components, others = _symbols(ring, "v"), _symbols(ring, "w")
    v, w = _dual(components), _dual(others)
    R, T, T_inv = (_isotropic(ring, f, v) for f in (cayley.tensor, cayley.tangent, cayley.tangent_inv))
    for name, operator in (("tensor", R), ("tangent", T), ("tangent_inv", T_inv)):
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
