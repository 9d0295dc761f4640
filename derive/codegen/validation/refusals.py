"""Calls with something wrong, which a package must refuse with the exception it documents, naming what is wrong."""

from __future__ import annotations

import inspect
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from types import ModuleType
from typing import Any

import numpy as np

from ..rows import Array, Function, Table
from ..signatures import CHECK, POSES
from .errors import ValidationFailed


@dataclass(frozen=True)
class Wrong:
    """A call that must be refused: its arguments, the exception, and words in the message."""

    arguments: Sequence[Any]
    error: type[Exception]
    words: str
    options: Mapping[str, Any] = field(default_factory=dict)


def refuse(module: ModuleType, table: Table = POSES) -> int:
    """Call every public function of a module with wrong arguments; return how many calls were refused as documented.

    Raises
    ------
    ValidationFailed
        Naming the function, and what was taken for right.
    """
    count = 0
    for row in table.public.values():
        function = getattr(module, row.name)
        for wrong in _wrong(row, "out" in inspect.signature(function).parameters):
            try:
                function(*wrong.arguments, **wrong.options)
            except wrong.error as error:
                if wrong.words not in str(error):
                    raise ValidationFailed(f"{row.name}: {wrong.words!r} is not in {str(error)!r}") from error
            else:
                raise ValidationFailed(f"{row.name} takes what it has to refuse: {wrong.words}")
            count += 1
    return count


def _wrong(row: Function, out: bool) -> Iterator[Wrong]:
    """With the right shapes and types but for one thing."""
    right = [np.zeros(kind.shape) for kind in row.arguments]
    yield Wrong(right, ValueError, "axis must be", {"axis": 1})
    for place, kind in enumerate(row.arguments):
        shapes = ((-1, (*kind.shape[:-1], 1)), (0, (1, *kind.shape[1:])), (0, ()))
        for axis, shape in shapes if kind.shape else ():  # a number is of any shape
            arguments = _with(right, place, np.zeros(shape))
            yield Wrong(arguments, ValueError, f"{kind.name} must have shape", {"axis": axis})
        if row.real:
            yield Wrong(_with(right, place, right[place] * 1j), TypeError, f"{kind.name} must be real")
    if len(right) > 1:
        batches = [np.zeros((length, *kind.shape)) for length, kind in enumerate(row.arguments, 2)]
        yield Wrong(batches, ValueError, "broadcast together")
    if CHECK in row.keywords:
        zeros = [np.zeros((3, *kind.shape)) for kind in row.arguments]
        yield Wrong(zeros, ValueError, "[0] is no ", {"check": True})
    if row.branch:
        yield Wrong(right, TypeError, "branch must be an integer", {"branch": 0.5})
    if out and len(row.results) == 1:
        yield from _outs(right, row.results[0])


def _outs(right: Sequence[Any], result: Array) -> Iterator[Wrong]:
    shape = result.shape
    yield Wrong(right, TypeError, "out must be an array", {"out": np.zeros(shape).tolist()})
    yield Wrong(right, ValueError, "out must have shape", {"out": np.zeros((2, *shape))})
    yield Wrong(right, TypeError, "out must be able to hold", {"out": np.zeros(shape, int)})


def _with(right: Sequence[Any], place: int, array: Any) -> list[Any]:
    return [*right[:place], array, *right[place + 1 :]]
