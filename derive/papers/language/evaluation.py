"""Executing a term: letters have values, the notation table says what to do with them."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from derive.algebra import Dual, Structure

from ..numbers.fields import Field
from .terms import Apply, Letter, Number, Term

Function = Callable[..., Any]


@dataclass(frozen=True)
class Definition:
    """What a letter stands for when it is not free: ``function(env, *values of the arguments)``.

    This is what a printed formula is checked against: the functions come from :mod:`derive.maps`.
    """

    letter: Letter
    function: Function
    arguments: tuple[Letter, ...]


def let(letter: Letter, function: Function, *arguments: Letter) -> Definition:
    """``letter := function(env, *arguments)``."""
    return Definition(letter, function, arguments)


@dataclass
class Env:
    """Values of letters over a field of numbers.

    Attributes
    ----------
    field : Field
    values : dict
        The free letters' values; defined letters join them as they are needed.
    definitions : mapping of Letter to Definition
    dual, moving : bool
        Whether coefficients are dual numbers, and whether (inside that) they carry a time derivative.
    """

    field: Field
    values: dict[Letter, Any]
    definitions: Mapping[Letter, Definition] = dataclasses.field(default_factory=dict)
    dual: bool = True
    moving: bool = False

    def value(self, statement: Term) -> Any:
        """The value of a term: a number, vector, tensor, quaternion, function or truth."""
        if isinstance(statement, Number):
            return statement.value
        if isinstance(statement, Letter):
            return self._letter(statement)
        if not isinstance(statement, Apply):
            raise TypeError(f"not a formula: {statement!r}")
        mark = statement.mark
        if mark.lazy:
            return mark.value(self, *statement.arguments)
        return mark.value(self, *(self.value(argument) for argument in statement.arguments))

    def bound(self, index: Letter | Term, value: Any) -> Env:
        """The same with one more letter bound, as the index of a sum."""
        if not isinstance(index, Letter):
            raise TypeError(f"only a letter can be bound, not {index!r}")
        return Env(self.field, {**self.values, index: value}, self.definitions, self.dual, self.moving)

    def power(self, base: Any, exponent: Any) -> Any:
        """``base`` to a power, as the field has it."""
        return self.field.power(base, exponent)

    def rate(self, a: Any) -> Any:
        """Time derivative of a value."""
        if isinstance(a, Structure):
            return a.map(self.rate)  # type: ignore[attr-defined]
        if not self.dual:
            return _slope(a)
        return Dual(_slope(a.re), _slope(a.du)) if isinstance(a, Dual) else 0

    def now(self, a: Any) -> Any:
        """A value without its time derivative."""
        if not self.moving or callable(a):
            return a
        if hasattr(a, "map"):
            return a.map(self.now)
        if not isinstance(a, Dual):
            return a
        return Dual(_value(a.re), _value(a.du)) if self.dual else a.re

    def _letter(self, letter: Letter) -> Any:
        if letter not in self.values:
            self.values[letter] = self._meaning(letter)
        return self.values[letter]

    def _meaning(self, letter: Letter) -> Any:
        if letter in self.definitions:
            definition = self.definitions[letter]
            return definition.function(self, *(self.value(a) for a in definition.arguments))
        if letter.kind.value is not None:
            return letter.kind.value(self.field)
        raise KeyError(f"letter {letter.name!r} has no value")


def _slope(a: Any) -> Any:
    return Dual(a.du, 0 * a.du) if isinstance(a, Dual) else 0


def _value(a: Any) -> Any:
    return a.re if isinstance(a, Dual) else a
