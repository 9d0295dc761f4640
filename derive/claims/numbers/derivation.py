"""Derivative of a number of independent generators by one of their names, and its value where this name is 0."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from ...algebra.element import NotExactError
from .generators import Generators


class Along:
    """Course of numbers of a field along one of its names, through all generators that depend on it."""

    def __init__(self, field: Generators, name: str) -> None:
        self.field, self.name = field, name
        self._slopes: dict[str, Any] = {}
        self._starts: dict[str, Any] = {}

    def slope(self, a: Any) -> Any:
        """Return the derivative of a number."""
        a = self.field.element(a)
        return a.derivative({self.field.ring.index(name): self._slope_of(name) for name in self.field.used(a)})

    def _slope_of(self, generator: str) -> Any:
        if generator not in self._slopes:
            self._slopes[generator] = self._new_slope(generator)
        return self._slopes[generator]

    def _new_slope(self, generator: str) -> Any:
        if generator not in self.field.meaning:
            return self.field.element(int(generator == self.name))
        what, known = self.field.meaning[generator]
        t = self.field.symbol(generator)
        if what == "angle":
            y, x = known
            return (x * self.slope(y) - y * self.slope(x)) / (x * x + y * y)
        if what == "power":
            factor, twice = known
            if self.slope(twice):
                raise NotExactError("the derivative by an integer")
            return t * twice * self.slope(factor) / (2 * factor)
        rates: Mapping[str, Callable[[], Any]] = {
            "tangent": lambda: (1 + t * t) / (2 * self.field.steps), "exponential": lambda: t,
            "root": lambda: 1 / (2 * t), "logarithm": lambda: 1 / known,
        }  # fmt: skip
        return self.slope(known) * rates[what]()

    def start(self, a: Any) -> Any:
        """Return a number where the name is 0; raise NotExactError or ZeroDivisionError if the field has none."""
        ring, a = self.field.ring, self.field.element(a)
        used = self.field.used(a)
        at = [(self._start_of(name) if name in used else ring.symbol(name)).numerator for name in ring.names]
        above, below = (part.compose(*at) for part in (a.numerator, a.denominator))
        return ring.fraction(above, ring.library.one) / ring.fraction(below, ring.library.one)

    def _start_of(self, generator: str) -> Any:
        if generator not in self._starts:
            self._starts[generator] = self._new_start(generator)
        return self._starts[generator]

    def _new_start(self, generator: str) -> Any:
        field = self.field
        if generator == self.name:
            return field.element(0)
        if generator not in self.field.meaning or not self._slope_of(generator):
            return field.symbol(generator)
        what, known = self.field.meaning[generator]
        value = self.start(known[0] if what in ("angle", "power") else known)
        if what == "root" and (root := field.root(value)) is not None:
            return field.chosen(root)
        first = {"tangent": (0, 0), "exponential": (0, 1), "logarithm": (1, 0), "angle": (0, 0)}.get(what)
        if first is None or value != first[0] or (what == "angle" and not field.is_positive(self.start(known[1]))):
            raise NotExactError(f"no value of {what} there")
        return field.element(first[1])
