"""Copies of Cayley maps, each with one error."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from types import SimpleNamespace
from typing import Any

import pytest
import sympy

from derive.maps import Cayley, x


class StatedCayley:
    """Cayley map with replaced values of some attributes."""

    def __init__(self, order: int, **changes: Any) -> None:
        self.right, self.cayley = Cayley(order), self
        self.__dict__.update(changes)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.right, name)

    def with_map(self, name: str, coefficients: tuple[sympy.Expr, ...]) -> StatedCayley:
        return StatedCayley(self.order, **{name: SimpleNamespace(coefficients=coefficients)})


@pytest.fixture
def stated() -> Callable[..., StatedCayley]:
    """Provide a function that returns the Cayley map of an order with replaced formulas."""
    return StatedCayley


@pytest.fixture
def mutations() -> Callable[[int], Iterator[tuple[str, str, StatedCayley]]]:
    """Provide a function that yields all changes of a single coefficient in the three tensors of an order."""
    return _mutations


def _mutations(n: int) -> Iterator[tuple[str, str, StatedCayley]]:
    """Yield (map, description, copy) with each coefficient of each numerator of the three tensors increased by one."""
    right = StatedCayley(n)
    for name in ("tensor", "tangent", "tangent_inv"):
        coefficients = getattr(right, name).coefficients
        for i, coefficient in enumerate(coefficients):
            numerator, denominator = sympy.fraction(sympy.together(coefficient))
            for power in range(len(sympy.Poly(numerator, x).all_coeffs())):
                wrong = (numerator + x**power) / denominator
                changed = (*coefficients[:i], wrong, *coefficients[i + 1 :])
                yield name, f"{name}[{i}], x^{power}", right.with_map(name, changed)
