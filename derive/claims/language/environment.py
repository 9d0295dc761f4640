"""Evaluation of a term from the values of its symbols."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import Any

from ...algebra import Dual, Structure
from ..numbers.fields import Field, innermost
from . import values
from .printed import Number, Symbol, Term, letters


@dataclass
class Env:
    """Environment: values of symbols over a field of numbers.

    `values` contains the letters; values of constants are added on first use. Coefficients are dual numbers if `dual`,
    and their parts carry time derivatives up to the order `moving`.
    """

    field: Field
    values: dict[Symbol, Any]
    dual: bool = True
    moving: int = 0
    powers: dict[int, tuple[Any, int, Any]] = dataclasses.field(default_factory=dict, repr=False)  # last of each base
    known: dict[Term, Any] = dataclasses.field(default_factory=dict, init=False, repr=False)  # values of parts

    def value(self, statement: Term) -> Any:
        """Return the value of a term: a number, vector, tensor, quaternion, function or truth value."""
        found = self.known.get(statement)
        if found is not None:
            return found
        if isinstance(statement, Number):
            return statement.value
        if isinstance(statement, Symbol):
            if statement not in self.values:
                self.values[statement] = self._meaning(statement)
            return self.values[statement]
        operator = statement.operator
        parts = statement.arguments if operator.lazy else map(self.value, statement.arguments)
        found = self.known[statement] = operator.value(self, *parts)
        return found

    @property
    def certain(self) -> Env:
        """The environment in which relations decide against a claim: for premises and negations."""
        return dataclasses.replace(self, field=self.field.certain)

    def bound(self, index: Symbol | Term, value: Any) -> Env:
        """Return a copy of the environment in which one more symbol, such as a summation index, has a value."""
        if not isinstance(index, Symbol):
            raise TypeError(f"only a symbol can be bound, not {index!r}")
        found = dataclasses.replace(self, values={**self.values, index: value})
        found.known.update((part, value) for part, value in self.known.items() if index not in letters(part))
        return found

    def equal(self, a: Any, b: Any) -> bool:
        """Return whether two values are equal where the form of a value depends on it, in no claim."""
        return values.equal(self.field.usual, a, b)

    def rate(self, a: Any) -> Any:
        if isinstance(a, Structure):
            return a.map(self.rate)
        if self.dual:
            return Dual(_slope(a.re), _slope(a.du)) if isinstance(a, Dual) else 0
        return _slope(a)

    def number(self, part: Any) -> Any:
        """Return the real or dual part of a value as a value: of moving dual numbers, a number with dual part 0."""
        if isinstance(part, Structure):
            return part.map(self.number)
        return Dual(part, 0 * part) if self.moving and self.dual and not isinstance(part, int) else part

    def now(self, a: Any) -> Any:
        """Return the current value, without its time derivative."""
        if not self.moving or callable(a):
            return a
        if hasattr(a, "map"):
            return a.map(self.now)
        if not isinstance(a, Dual):
            return a
        return Dual(innermost(a.re), innermost(a.du)) if self.dual else innermost(a)

    def _meaning(self, symbol: Symbol) -> Any:
        if symbol.quantity.value is not None:
            return symbol.quantity.value(self.field)
        raise KeyError(f"symbol {symbol.name!r} has no value")


def _slope(a: Any) -> Any:
    """Return the derivative of a coefficient; the last one of a nested dual number counts as constant."""
    return Dual(a.du, _slope(a.du) if isinstance(a.du, Dual) else 0 * a.du) if isinstance(a, Dual) else 0
