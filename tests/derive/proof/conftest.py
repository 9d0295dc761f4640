"""Copies of Cayley maps with one error each."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import pytest
import sympy

from derive.maps import Cayley, x


@dataclass(frozen=True)
class Stated:
    """Map with given coefficients."""

    coefficients: tuple[sympy.Expr, ...]


@dataclass(frozen=True)
class StatedCayley:
    """Formulas of an order, each replaceable."""

    order: int
    p: sympy.Expr
    q: sympy.Expr
    c: sympy.Expr
    d: sympy.Expr
    quaternion: Stated
    tensor: Stated
    tangent: Stated
    tangent_inv: Stated

    @classmethod
    def of(cls, n: int) -> StatedCayley:
        cayley = Cayley(n)
        names = ("quaternion", "tensor", "tangent", "tangent_inv")
        maps = {name: Stated(tuple(getattr(cayley, name).coefficients)) for name in names}
        return cls(n, cayley.p, cayley.q, cayley.c, cayley.d, **maps)

    @property
    def cayley(self) -> StatedCayley:
        return self

    def __getattr__(self, name: str) -> Any:
        """Return an unchanged attribute of the chart."""
        return getattr(Cayley(self.order), name)

    def with_map(self, name: str, coefficients: tuple[sympy.Expr, ...]) -> StatedCayley:
        changed: dict[str, Any] = {name: Stated(coefficients)}
        return replace(self, **changed)


@pytest.fixture
def stated() -> Callable[[int], StatedCayley]:
    """Provide the correct formulas of an order, each replaceable."""
    return StatedCayley.of


@pytest.fixture
def mutations() -> Callable[[int], Iterator[tuple[str, str, StatedCayley]]]:
    """Provide all changes of a single coefficient in the three tensors of an order."""
    return _mutations


def _mutations(n: int) -> Iterator[tuple[str, str, StatedCayley]]:
    """Yield (map, description, copy) with each coefficient of each numerator of the three tensors increased by one."""
    right = StatedCayley.of(n)
    for name in ("tensor", "tangent", "tangent_inv"):
        coefficients = getattr(right, name).coefficients
        for i, coefficient in enumerate(coefficients):
            numerator, denominator = sympy.fraction(sympy.together(coefficient))
            for power in range(len(sympy.Poly(numerator, x).all_coeffs())):
                wrong = (numerator + x**power) / denominator
                changed = (*coefficients[:i], wrong, *coefficients[i + 1 :])
                yield name, f"{name}[{i}], x^{power}", right.with_map(name, changed)
