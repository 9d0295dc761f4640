"""Recipes of poses traced with real vectors: dual parts are the constant 0, and of the results the real part is kept.

What reads a dual part folds away or is read by no result, so a recipe serves rotations alone as it stands.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from ..programs.program import Call, Program, Statement
from ..programs.value import Number
from .point import Geometry
from .scalars import SCALARS, SQUARES

TABLE = "table"
"""The argument that holds constants: it has no dual part."""


class RealGeometry(Geometry):
    """A trace of a function of rotations.

    Parameters
    ----------
    function : str
        What it is called.
    arguments : sequence
        By argument, the places of the components which are not 0.
    results : sequence of int
        The places of the results that are kept.
    """

    def __init__(self, function: str, arguments: Iterable[Sequence[int]], results: Sequence[int]) -> None:
        super().__init__()
        self.function = function
        self._arguments = iter(arguments)
        self._kept = results

    def inputs(self, argument: str, names: Sequence[str]) -> tuple[Number, ...]:
        """Declare the components that are not 0."""
        if argument == TABLE:
            return super().inputs(argument, names)
        places = next(self._arguments)
        declared = dict(zip(places, super().inputs(argument, [names[place] for place in places]), strict=True))
        return tuple(declared.get(place, 0) for place in range(len(names)))

    def program(self, name: str, outputs: Iterable[Number]) -> Program:
        """Freeze what the outputs that are kept need."""
        given = tuple(outputs)
        found = super().program(self.function, [given[place] for place in self._kept])
        return replace(found, statements=tuple(map(narrowed, found.statements)))


def narrowed(statement: Statement) -> Statement:
    """A call as that of the scalar program with the fewest results that has all which are read."""
    if not isinstance(statement, Call):
        return statement
    row = SCALARS[statement.function]
    read = {result: name for result, name in zip(row.results, statement.names, strict=True) if name != "_"}
    fitting = (
        name
        for name, other in SCALARS.items()
        if other.arguments == row.arguments in (("x",), SQUARES) and read.keys() <= set(other.results)
    )
    function = min(fitting, key=lambda name: len(SCALARS[name].results), default=statement.function)
    names = tuple(read.get(result, "_") for result in SCALARS[function].results)
    return replace(statement, function=function, names=names)
