"""What recipes of geometry are traced with: a trace that asks a chart for scalars, and vectors v in it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

from ...algebra import Dual, Vector
from ..programs.trace import Trace
from ..programs.value import Number
from .scalars import SCALARS, SQUARES


class Geometry(Trace):
    """A trace of geometry, which all charts share: scalars of a chart are calls."""

    def ask(self, function: str, arguments: Sequence[Number], mark: str = "") -> tuple[Number, ...]:
        """Return the results of a scalar program, under their own names and a mark."""
        row = SCALARS[function]
        names, truths = ([name + mark for name in group] for group in (row.results, row.truths))
        return self.call(function, arguments, names, truths, "table" if "table" in row.arguments else "")

    def dual(self, name: str, value: Number) -> Number:
        """A dual number with its parts named, that of the dual part ending in o."""
        return Dual(self.name(name, value.re), self.name(name + "o", value.du))

    def dual_vector(self, letter: str, value: Vector) -> Vector:
        """A dual vector with its components named."""
        return Vector(*(self.dual(f"{letter}{i}", component) for i, component in enumerate(value, 1)))

    def declare_returns(self) -> None:
        """Declare the argument that holds the chart's table of returns, of a length that only the chart knows."""
        self.inputs("table", ())


class Scope:
    """The same trace, with a mark on every name and another where a name is taken."""

    def __init__(self, trace: Trace, mark: str) -> None:
        self._trace = trace
        self._mark = mark

    def name(self, name: str, value: Number) -> Number:
        return self._trace.name(self._trace.free_name(name + self._mark), value)

    def __getattr__(self, operation: str) -> Any:
        return getattr(self._trace, operation)


class Point:
    """Traced components of v; ``mark`` tells two vectors of one program apart."""

    def __init__(self, trace: Geometry, components: Sequence[Number], mark: str = "") -> None:
        self.trace = trace
        self.mark = mark
        self.re = Vector(*components[:3])
        self.du = Vector(*components[3:6])

    def name(self, letter: str, value: Number) -> Number:
        return self.trace.name(letter + self.mark, value)

    @property
    def is_real(self) -> bool:
        """Whether the dual part is the constant 0, as that of rotations is."""
        return tuple(self.du) == (0, 0, 0)

    @cached_property
    def squares(self) -> tuple[Number, Number, Number]:
        """v1², v2², v3²."""
        names = ("v11", "v22", "v33")
        first, second, third = (self.name(name, c * c) for name, c in zip(names, self.re, strict=True))
        return first, second, third

    @cached_property
    def x(self) -> Number:
        first, second, third = self.squares
        return self.name("x", first + second + third)

    @cached_property
    def y(self) -> Number:
        """v·v°, half the dual part of x."""
        return self.name("y", self.re.dot(self.du))

    @cached_property
    def v(self) -> Vector:
        """The dual vector."""
        return Vector.dual(self.re, self.du)

    def lifted(self, function: str, letters: Sequence[str]) -> tuple[Number, ...]:
        """Some results of a scalar program at the dual x: the dual part of f is its slope fy times y."""
        found = dict(zip(SCALARS[function].results, self.scalars(function), strict=True))
        return tuple(Dual(found[name], self.name(name + "o", found[name + "y"] * self.y)) for name in letters)

    def scalars(self, function: str) -> tuple[Number, ...]:
        """The results of a scalar program at x."""
        of_squares = SCALARS[function].arguments == SQUARES
        return self.trace.ask(function, self.squares if of_squares else (self.x,), self.mark)
