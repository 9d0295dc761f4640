"""Rows of the table of kernel functions: arrays, recipes, names, and their real parts for rotations alone."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from ..maps.chart import Chart
from .lowering.point import Recipe, traced, traced_kernel
from .programs.program import Program


@dataclass(frozen=True, slots=True)
class Array:
    """A named array of components; ``part_of`` says which part (real, dual and so on) each belongs to.

    Rotations alone have its first ``real`` components along every axis, under ``real_name`` if that is given.
    ``real`` is None where they have no such array.
    """

    name: str
    shape: tuple[int, ...]
    part_of: tuple[int, ...]
    real: tuple[int, ...] | None = None
    real_name: str = ""

    def __post_init__(self) -> None:
        if len(self.part_of) != math.prod(self.shape):
            raise ValueError(f"the parts {self.part_of} of {self.name} do not make its shape {self.shape}")

    @property
    def size(self) -> int:
        """Return how many components it has."""
        return len(self.part_of)

    @property
    def parts(self) -> tuple[int, ...]:
        """Return the size of each part."""
        return tuple(self.part_of.count(part) for part in range(max(self.part_of) + 1))

    def called(self, name: str) -> Array:
        """Return the array under another name."""
        return replace(self, name=name)

    @property
    def places(self) -> tuple[int, ...]:
        """Return the places of the components that rotations alone have.

        Raises
        ------
        ValueError
            If there are none.
        """
        if self.real is None:
            raise ValueError(f"rotations alone have no array {self.name}")
        lengths = (1,) * (len(self.shape) - len(self.real)) + self.real
        indices = enumerate(itertools.product(*map(range, self.shape)))
        return tuple(place for place, index in indices if all(i < length for i, length in zip(index, lengths)))

    @property
    def of_rotation(self) -> Array:
        """Return the array of rotations alone."""
        return Array(self.real_name or self.name, self.real or (), tuple(0 for _ in self.places), self.real)


@dataclass(frozen=True, slots=True)
class Function:
    """A function of a kernel module.

    Parameters
    ----------
    name : str
    arguments, results : tuple of Array
    recipe : callable, optional
        Traces its program; None for a function that shares the program of another, `kernel`.
    exact : bool
        Whether its expectation is exact, on elements of a ring, or at 50 digits.
    constants : tuple of str
        Components of the argument ``table`` of its program, where they are the same for all charts.
    branch : bool
        Whether a branch is chosen.
    real : bool
        Whether it selects branches or angles, and so takes no complex numbers.
    public : bool
        Whether users call it.
    at_rest : str
        The function whose program it runs for a turn by no branch, where it runs its own for others; empty where the
        argument stands.
    aliases : tuple of str
        Further names in the modules of Cayley maps; with dexp for dcay, in that of the exponential.
    keywords : tuple of str
        Keyword parameters besides those of every function, in languages that have them: they choose what is done to
        arguments and results, and change no program.
    remainder : float
        What its own series leave off, however many digits numbers have.
    rotation : str, optional
        Its name among the functions of rotations alone; None where they have no such function.
    pose : Function, optional
        Of a function of rotations, that of poses whose real part it is, at dual parts 0.
    """

    name: str
    arguments: tuple[Array, ...]
    results: tuple[Array, ...]
    recipe: Recipe | None
    exact: bool = True
    constants: tuple[str, ...] = ()
    branch: bool = False
    real: bool = False
    public: bool = True
    at_rest: str = ""
    aliases: tuple[str, ...] = ()
    keywords: tuple[str, ...] = ()
    shares: str = ""
    remainder: float = 0.0
    rotation: str | None = ""
    pose: Function | None = None

    @property
    def shape(self) -> tuple[int, ...]:
        """Return the shape of its program's result: several results stand side by side."""
        return self.results[0].shape if len(self.results) == 1 else (sum(array.size for array in self.results),)

    def traced(self) -> Program:
        """Return its program.

        Raises
        ------
        ValueError
            If it has no recipe.
        """
        if self.recipe is None:
            raise ValueError(f"{self.name} has no recipe: it shares the program of {self.shares!r}")
        return traced(self.recipe) if self.pose is None else traced_kernel(self.recipe, self.name, self.pose.kept)

    @property
    def kernel(self) -> str:
        """Return the name of the function whose program it runs."""
        return self.shares or self.name

    def aliases_in(self, chart: Chart) -> list[str]:
        """Return its further names in the module of a chart: dcay for Cayley maps, dexp for the exponential."""
        stem = "dcay" if chart.cayley else "dexp" if chart.name == "exponential" else None
        return [alias.replace("dcay", stem) for alias in self.aliases] if stem else []

    # --- rotations alone ----------------------------------------------------------------------------------------

    @property
    def source(self) -> str:
        """Return the name of the function of poses that it is, or whose real part it is."""
        return self.pose.name if self.pose else self.name

    @property
    def kept(self) -> tuple[int, ...]:
        """Return the places of the results that rotations alone have, results side by side."""
        starts = itertools.accumulate((array.size for array in self.results), initial=0)
        return tuple(start + place for array, start in zip(self.results, starts) for place in array.places)

    @property
    def of_rotation(self) -> Function:
        """Return the function of rotations alone that is its real part."""
        arguments, results = (tuple(a.of_rotation for a in group) for group in (self.arguments, self.results))
        return replace(self, name=self.rotation or self.name, arguments=arguments, results=results, pose=self)

    def embedded(self, arguments: Sequence[Sequence[Any]], zero: Any) -> list[tuple[Any, ...]]:
        """Return flat arguments as the function of poses takes them, with dual parts 0."""
        return [tuple(a) for a in arguments] if self.pose is None else self._with_zeros(self.pose, arguments, zero)

    @staticmethod
    def _with_zeros(pose: Function, arguments: Sequence[Sequence[Any]], zero: Any) -> list[tuple[Any, ...]]:
        made = []
        for array, given in zip(pose.arguments, arguments):
            found = dict(zip(array.places, given, strict=True))
            made.append(tuple(found.get(place, zero) for place in range(array.size)))
        return made

    def restricted(self, arguments: Sequence[Sequence[Any]]) -> tuple[tuple[Any, ...], ...]:
        """Select its own flat arguments from those of the function of poses."""
        if self.pose is None:
            return tuple(map(tuple, arguments))
        pairs = zip(self.pose.arguments, arguments)
        return tuple(tuple(given[place] for place in array.places) for array, given in pairs)

    def part(self, result: Sequence[Any]) -> tuple[Any, ...]:
        """Return its own flat result, of that of the function of poses."""
        return tuple(result) if self.pose is None else tuple(result[place] for place in self.pose.kept)


@dataclass(frozen=True, slots=True, eq=False)
class Table:
    """The functions of one kind of kernel module, which lies in the folder of that name.

    By name, ``functions`` are all, ``kernels`` have a ``recipe``, and ``public`` ones are called by users. ``sources``
    are all by `Function.source`, the name of the function of poses.
    """

    name: str
    functions: Mapping[str, Function]
    kernels: Mapping[str, Function]
    public: Mapping[str, Function]
    sources: Mapping[str, Function]

    @classmethod
    def of(cls, name: str, rows: Iterable[Function]) -> Table:
        """Return the table of some rows."""
        functions = {row.name: row for row in rows}
        kernels = {name: row for name, row in functions.items() if row.recipe}
        public = {name: row for name, row in functions.items() if row.public}
        return cls(name, functions, kernels, public, {row.source: row for row in functions.values()})

    def aliases(self, chart: Chart) -> dict[str, str]:
        """Return further names in the module of a chart, and the functions they name."""
        return {alias: name for name, row in self.public.items() for alias in row.aliases_in(chart)}


def inside(table: Table, name: str) -> str:
    """Return the path of a file in the folder of a table."""
    return f"{table.name}/{name}" if table.name else name
