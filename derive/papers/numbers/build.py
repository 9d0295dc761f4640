"""Builders of values from plain numbers: points of the sphere, numbers with rates, and smooth functions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any

from ...algebra import Dual, Vector


def sphere(s: Any, t: Any) -> Vector:
    """Return ``(2s, 2t, 1 − s² − t²)/(1 + s² + t²)``: any unit vector except (0, 0, −1)."""
    square = s * s + t * t
    return Vector(2 * s / (1 + square), 2 * t / (1 + square), (1 - square) / (1 + square))


def jet(value: Any, rates: Sequence[Any]) -> Any:
    """Return a number with its rates: of first order as one dual number, of second order as nested dual numbers."""
    return Dual(jet(value, rates[:-1]), jet(rates[0], rates[1:])) if rates else value


@dataclass(frozen=True)
class Smooth:
    """Differentiable function of plain or dual numbers, with its derivative at plain numbers."""

    value: Callable[[Any], Any]
    derivative: Callable[[Any], Any]

    def __call__(self, a: Any) -> Any:
        return self.value(a)


def polynomial(coefficients: Sequence[Any]) -> Smooth:
    """Return the polynomial with coefficients in ascending order."""

    def horner(numbers: Sequence[Any], a: Any) -> Any:
        return reduce(lambda total, c: total * a + c, reversed(numbers), 0)

    slopes = [k * c for k, c in enumerate(coefficients)][1:]
    return Smooth(lambda a: horner(coefficients, a), lambda a: horner(slopes, a))
