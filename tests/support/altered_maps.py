"""Copies of Cayley maps, each with one error."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest
import sympy

from derive.maps import Cayley


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
