"""Rows of the table of kernel functions: arrays, recipes, names, and their real parts for rotations alone."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from ..maps.chart import Chart
from .lowering.point import Recipe, traced, traced_kernel
from .programs.program import Program


@dataclass(frozen=True, slots=True)
class Array:
    """Named array of components."""

    name: str
    shape: tuple[int, ...]
    part_of: tuple[int, ...]  # part (real, dual and so on) of each component
    real: tuple[int, ...] | None = None  # first components that rotations keep along each axis; None for no such array
    real_name: str = ""  # name in rotations alone, if another
    vector: bool = False  # True for a vector v of the chart, which ends at its edge

    @property
    def size(self) -> int:
        return len(self.part_of)

    @property
    def parts(self) -> tuple[int, ...]:
        return tuple(self.part_of.count(part) for part in range(max(self.part_of) + 1))

    def called(self, name: str) -> Array:
        return replace(self, name=name)

    @property
    def places(self) -> tuple[int, ...]:
        """Return the places of the components that rotations alone have; raise ValueError if there are none."""
        if self.real is None:
            raise ValueError(f"rotations alone have no array {self.name}")
        lengths = (1,) * (len(self.shape) - len(self.real)) + self.real
        indices = enumerate(itertools.product(*map(range, self.shape)))
        return tuple(place for place, index in indices if all(i < length for i, length in zip(index, lengths)))

    @property
    def of_rotation(self) -> Array:
        parts = tuple(0 for _ in self.places)
        return Array(self.real_name or self.name, self.real or (), parts, self.real, vector=self.vector)


RULE, BY_TEXT = "rule", "by text, because "
"""Decisions on derivatives under JAX and PyTorch: by a rule of the target array-api, or by text, with a reason."""


@dataclass(frozen=True, slots=True)
class Function:
    """Function of a kernel module."""

    name: str
    arguments: tuple[Array, ...]
    results: tuple[Array, ...]
    recipe: Recipe | None  # function that traces its program; None if it ``shares`` the program of another function
    derivatives: str = ""  # decision on derivatives, ``RULE`` or ``BY_TEXT`` with its reason; with ``shares``, empty
    exact: bool = True  # True for an exact expected result on ring elements, False for one of 50 digits
    constants: tuple[str, ...] = ()  # components of its program's argument ``table``, if equal for all charts
    branch: bool = False  # True if a branch is the last argument
    real: bool = False  # True for a selection of branches or angles, hence no complex numbers
    public: bool = True  # True for a function that users call
    at_rest: str = ""  # function where nothing turns: for zero branches, or for a chart of one; empty for v itself
    aliases: tuple[str, ...] = ()  # further names in modules of Cayley maps and, with dexp for dcay, of the exponential
    keywords: tuple[str, ...] = ()  # further keyword parameters
    shares: str = ""
    remainder: float = 0.0  # truncation error of its own series, independent of the number of digits
    rotation: str | None = ""  # name in rotations alone; empty for the same name, None if there is no such function
    pose: Function | None = None  # function of poses whose real part, at dual parts 0, is this function of rotations

    @property
    def shape(self) -> tuple[int, ...]:
        """Return the shape of its program's result; several results are flattened and joined."""
        return self.results[0].shape if len(self.results) == 1 else (sum(array.size for array in self.results),)

    def traced(self) -> Program:
        """Return the program of the function; raise ValueError if it has no recipe."""
        if self.recipe is None:
            raise ValueError(f"{self.name} has no recipe: it shares the program of {self.shares!r}")
        return traced(self.recipe) if self.pose is None else traced_kernel(self.recipe, self.name, self.pose.kept)

    @property
    def kernel(self) -> str:
        return self.shares or self.name

    def aliases_in(self, chart: Chart) -> list[str]:
        """Return its further names in the module of a chart: dcay for Cayley maps, dexp for the exponential."""
        return [alias.replace("dcay", chart.operator) for alias in self.aliases] if chart.operator else []

    @property
    def source(self) -> str:
        return self.pose.name if self.pose else self.name

    @property
    def kept(self) -> tuple[int, ...]:
        """Return the places, among all joined results, of the components that rotations alone have."""
        starts = itertools.accumulate((array.size for array in self.results), initial=0)
        return tuple(start + place for array, start in zip(self.results, starts) for place in array.places)

    @property
    def of_rotation(self) -> Function:
        """Return the function of rotations alone that is the real part of this function."""
        arguments, results = (tuple(a.of_rotation for a in group) for group in (self.arguments, self.results))
        return replace(self, name=self.rotation or self.name, arguments=arguments, results=results, pose=self)

    def embedded(self, arguments: Sequence[Sequence[Any]], zero: Any) -> list[tuple[Any, ...]]:
        """Return flat arguments for the function of poses, with dual parts 0."""
        if self.pose is None:
            return list(map(tuple, arguments))
        pairs = zip(self.pose.arguments, arguments)
        found = [(array.size, dict(zip(array.places, given, strict=True))) for array, given in pairs]
        return [tuple(components.get(place, zero) for place in range(size)) for size, components in found]

    def restricted(self, arguments: Sequence[Sequence[Any]]) -> tuple[tuple[Any, ...], ...]:
        """Select this function's arguments from the flat arguments of the function of poses."""
        if self.pose is None:
            return tuple(map(tuple, arguments))
        pairs = zip(self.pose.arguments, arguments)
        return tuple(tuple(given[place] for place in array.places) for array, given in pairs)

    def part(self, result: Sequence[Any]) -> tuple[Any, ...]:
        """Select this function's result from the flat result of the function of poses."""
        return tuple(result) if self.pose is None else tuple(result[place] for place in self.pose.kept)


@dataclass(frozen=True, slots=True, eq=False)
class Table:
    """Functions of one kind of kernel module by name."""

    name: str  # folder of the modules
    functions: Mapping[str, Function]
    kernels: Mapping[str, Function]  # functions with a ``recipe``
    public: Mapping[str, Function]  # functions that users call
    sources: Mapping[str, Function]  # all functions by `Function.source`, the name of the function of poses
    composed: Mapping[str, Function]  # functions that Python composes at run time; in C they have programs

    @classmethod
    def of(cls, name: str, rows: Iterable[Function], composed: Iterable[Function]) -> Table:
        functions = {row.name: row for row in rows}
        kernels = {name: row for name, row in functions.items() if row.recipe}
        public = {name: row for name, row in functions.items() if row.public}
        sources = {row.source: row for row in functions.values()}
        return cls(name, functions, kernels, public, sources, {row.name: row for row in composed})

    @property
    def all_public(self) -> dict[str, Function]:
        """Functions that users call, with those that Python composes."""
        return {**self.public, **self.composed}

    def require_complete(self, where: str, found: Iterable[str], further: Collection[str] = ()) -> None:
        """Raise ValueError unless the functions found are the public ones; the message names the differences."""
        names, wanted = set(found), {*self.public, *further}
        if names != wanted:
            missing, extra = (", ".join(sorted(some)) or "none" for some in (wanted - names, names - wanted))
            raise ValueError(f"{where}: functions of the table that are missing: {missing}; not in it: {extra}")

    def aliases(self, chart: Chart) -> dict[str, str]:
        return {alias: name for name, row in self.public.items() for alias in row.aliases_in(chart)}


def inside(table: Table, name: str) -> str:
    return f"{table.name}/{name}" if table.name else name
