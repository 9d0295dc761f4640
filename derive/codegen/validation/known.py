"""Functions whose results on floats are known: to so many digits, and within what rounding may do."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath
import numpy as np

from ...maps.chart import Chart
from .. import rows
from ..cases import Samples
from ..cases.decimals import DIGITS
from ..lowered import Lowered, geometry
from ..programs.program import Operand, Program
from ..programs.program import results as result_names
from ..rows import Function
from .rounding import Array, Ball, Rounding, long

TABLE = "table"


@dataclass(frozen=True)
class Known:
    """A function and branch: rows of each argument, and at every combination of them the result and its bounds.

    ``results`` has a row per combination, in C order; ``bounds`` one of these for each of ``dtypes``. ``free`` says, by
    argument, which components do not depend on it.
    """

    row: Function
    branch: tuple[int, ...]
    arguments: tuple[Array, ...]
    results: Array
    bounds: Array
    dtypes: tuple[np.dtype[Any], ...]
    free: Array

    @property
    def shape(self) -> tuple[int, ...]:
        """Rows of each argument."""
        return tuple(map(len, self.arguments))

    @property
    def stands(self) -> bool:
        """Whether the result is what is given."""
        (first, *others), results = self.arguments, self.results
        same = not others and first.shape == results.shape
        return same and bool(np.isclose(first, results, rtol=float(np.finfo(first.dtype).eps), atol=0).all())

    @property
    def has_zeros(self) -> bool:
        """Whether a component of an argument is 0 anywhere."""
        return any(bool((rows == 0).any()) for rows in self.arguments)

    def bound(self, dtype: np.dtype[Any]) -> Array:
        """How far a result of a type may be from the exact one, combination by combination."""
        found: Array = self.bounds[self.dtypes.index(dtype)]
        return found


class Analysis:
    """Rounding in the functions of a chart, for some types of numbers."""

    def __init__(self, chart: Chart, lowered: Lowered, dtypes: Sequence[np.dtype[Any]]) -> None:
        self.chart = chart
        self.lowered = lowered
        self.programs = geometry(lowered.table)
        self.rounding = Rounding(tuple(dtypes))

    def known(self, samples: Samples) -> Known:
        """What a function returns at samples of its arguments."""
        row = samples.row
        counted = [np.arange(len(group)) for group in samples.arguments]
        picks = [pick.ravel() for pick in np.meshgrid(*counted, indexing="ij")]
        with np.errstate(all="ignore"), mpmath.workdps(DIGITS):
            columns = [
                [_picked(self.rounding.given(column), pick) for column in zip(*group, strict=True)]
                for group, pick in zip(samples.arguments, picks, strict=True)
            ]
            found = self._results(row, samples.branch, [ball for group in columns for ball in group])
            results = np.stack([long(result) for result in samples.results])
            shape = (len(self.rounding.dtypes), len(results))
            bounds = np.stack([np.broadcast_to(ball.error, shape) for ball in found], axis=-1)
            bounds = bounds + self.rounding.unit[..., np.newaxis] * abs(results)  # that of the exact result itself
            arguments = tuple(np.stack([long(values) for values in group]) for group in samples.arguments)
        free = np.array([_free(self.programs[row.kernel], place) for place in range(len(arguments))])
        return Known(row, samples.branch, arguments, results, bounds, self.rounding.dtypes, free)

    def _results(self, row: Function, branch: tuple[int, ...], given: list[Ball]) -> list[Ball]:
        """A branch is a table of the function's own program, or of the turn that follows it."""
        program = self.programs[row.kernel]
        tabled = TABLE in dict(program.inputs)
        if tabled and not row.constants and not self._table(branch):
            return self._run(row.at_rest, given, ()) if row.at_rest else given  # it goes nowhere
        table = row.constants or (self._table(branch) if tabled else ())
        found = self._run(row.kernel, given, table)
        turns = row.branch and not tabled and any(branch)
        return self._run("turn", found, self._table(branch)) if turns else found

    def _run(self, name: str, given: Sequence[Ball], table: Sequence[Any]) -> list[Ball]:
        numbers = [self.rounding.number(mpmath.mpf(value)) for value in table]
        return self.rounding.run(self.programs[name], self.lowered.scalars, given, numbers)

    def _table(self, branch: tuple[int, ...]) -> tuple[Any, ...]:
        """The numbers of a turn by so many branches, of none for 0; without a branch, the table of returns."""
        if branch:
            return tuple(self.chart.turn(*branch)) if any(branch) else ()
        return tuple(value for row in self.chart.returns() for value in row)


def _free(program: Program, place: int) -> list[bool]:
    """Which outputs of a program do not depend on one of its arguments."""
    reached: set[Operand] = set(program.inputs[place][1])
    for statement in program.statements:
        if reached.intersection(statement.args):
            reached.update(result_names(statement))
    return [output not in reached for output in program.outputs]


def _picked(ball: Ball, pick: Array) -> Ball:
    return Ball(ball.value[..., pick], ball.error[..., pick])


def require_sharp(known: Known) -> None:
    """At some combination the bounds have to leave digits of a result standing, or comparison would say nothing.

    Half of them in float64 and wider types, a quarter in float32: bounds grow with the order, and it has few digits.

    Raises
    ------
    ValueError
        Naming the function and the result.
    """
    shares = [1 / 2 if dtype.itemsize >= 8 else 1 / 4 for dtype in known.dtypes]
    lost = [np.finfo(dtype).eps ** share for dtype, share in zip(known.dtypes, shares, strict=True)]
    coarse = np.array(lost, np.longdouble)[:, np.newaxis, np.newaxis]
    for array, part in parts(known.row):
        size = np.max(abs(known.results[:, part]), axis=-1, keepdims=True)
        if not np.all(np.any(known.bounds[..., part] <= coarse * size, axis=1)):
            raise ValueError(f"{known.row.name}: rounding may change too many digits of {array.name}")


def parts(row: Function) -> Iterator[tuple[rows.Array, slice]]:
    """The results of a function, and where they stand among all its components."""
    start = 0
    for array in row.results:
        yield array, slice(start, start + array.size)
        start += array.size
