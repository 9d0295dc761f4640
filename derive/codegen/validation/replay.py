"""Replay of a package on floats: the wiring of a chart in single poses, batches, and batches with components first.

Results agree with the formula to half of the digits, or within the error scale of an ill-conditioned case. Kernels of
any Python target are replayed, in the arrays of any library. Layouts and number types are those of copied files.
"""

from __future__ import annotations

import itertools
import sys
import warnings
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from types import ModuleType
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ...maps.chart import Chart
from ..rows import Function, Table
from ..signatures import POSES
from .batches import ValidationFailed
from .calls import grouped, require
from .float_cases import FloatCase, drawn
from .loading import loaded, module_of
from .run import own_functions

Array: TypeAlias = NDArray[Any]

FEW, MANY = 10, 27  # sizes of batches that NumPy runs pose by pose, and by a recorded program
CASES_MAX = 4  # largest number of cases of a function and branch: one for each row of 4 q qᵀ
TOLERANCE = 1 / 2
"""Share of the digits of a type that must be right in well-conditioned results: a replay tests wiring, not rounding."""

EPS = sys.float_info.epsilon
GATE = 16  # largest error of an ill-conditioned result, in units of the machine epsilon times the scale of the case


@dataclass(frozen=True, slots=True)
class Library:
    """Array library of a target, with the conversion from NumPy arrays by ``make``."""

    name: str
    make: Callable[[Array], Any]
    silent: bool = True  # True if singular points give IEEE results without a warning


NUMPY = Library("numpy", np.asarray)


def replay(
    source: Path | str,
    chart: Chart,
    libraries: Sequence[Library] = (NUMPY,),
    tables: Sequence[Table] = (POSES,),
    *,
    geometry: bool,
) -> int:
    """Call the functions of a package on floats; return the number of calls that agree with the formulas of a chart.

    ``source`` is a folder or the name of a package that can be imported. With ``geometry`` all functions are called,
    otherwise only `own_functions`. `ValidationFailed` names the first wrong component.
    """
    if not libraries:
        return 0
    with loaded(source) if isinstance(source, Path) else nullcontext(source) as package:
        count = 0
        for table, library in itertools.product(tables, libraries):
            caller = Caller(module_of(package, chart, table), library)
            with warnings.catch_warnings(), np.errstate(all="warn"):
                warnings.simplefilter("error" if library.silent else "ignore", RuntimeWarning)
                caller.replay(_groups(chart, table, geometry), chart)
            count += caller.count
        return count


@dataclass(frozen=True)
class Group:
    """Cases of one function and branch, with arguments and results as arrays of floats."""

    row: Function
    branch: tuple[int, ...]
    cases: tuple[FloatCase, ...]

    @cached_property
    def arguments(self) -> list[Array]:
        columns = zip(*(case.arguments for case in self.cases), strict=True)
        kinds = self.row.arguments
        return [_floats(rows).reshape(-1, *kind.shape) for rows, kind in zip(columns, kinds, strict=True)]

    @cached_property
    def results(self) -> Array:
        return _floats([case.result for case in self.cases])

    def given(self, index: Array, axis: int) -> list[Array]:
        """Return the arguments of the indexed cases, with components on the last axes or, for ``axis=0``, the first."""
        return [_turned(array[index], index.ndim, axis) for array in self.arguments]


def _groups(chart: Chart, table: Table, geometry: bool) -> list[Group]:
    """Return the cases of all functions and branches; without ``geometry``, `own_functions` on branches 0 and 1."""
    names = frozenset(table.public if geometry else own_functions(chart, table))
    called = grouped(case for case in drawn(chart, table, names) if geometry or case.branch in (None, 0, 1))
    finite = ((branch, (case for case in group if case.finite)) for branch, group in called)
    chosen = ((branch, tuple(itertools.islice(group, CASES_MAX))) for branch, group in finite)
    found = [Group(group[0].row, branch, group) for branch, group in chosen if group]
    require("a call in floats", names, (group.row.name for group in found))
    return found


@dataclass
class Caller:
    """Caller of the functions of a module, which compares their results and counts the calls."""

    module: ModuleType
    library: Library
    count: int = 0

    def replay(self, groups: Sequence[Group], chart: Chart) -> None:
        """Call every function on single poses, on a few and on more."""
        for group in groups:
            count = len(group.cases)
            few, many = (np.arange(size) % count for size in (FEW, MANY))
            for index in (*map(np.array, range(count)), few, many):
                self.check(group, index)
            self.check(group, many, axis=0)
            for name in group.row.aliases_in(chart):
                self.check(group, np.array(0), name=name)
            for turns in (-1, 2) if group.branch else ():
                self.check(group, np.array(0), branch=(group.branch[0] + turns * chart.branches,))

    def check(self, group: Group, index: Array, axis: int = -1, **named: Any) -> None:
        """Call a function on the indexed cases, and compare the results with the formula."""
        results = self._run(group, group.given(index, axis), axis, **named)
        kinds = [kind.shape for kind in group.row.results]
        shapes = [kind + index.shape if axis == 0 else index.shape + kind for kind in kinds]
        if [got.shape for got in results] != shapes or any(got.dtype != np.float64 for got in results):
            raise self._failure(group, f"results of float64 are {[(got.dtype, got.shape) for got in results]}")
        parts = [_turned(got, got.ndim - index.ndim, axis).reshape(*index.shape, -1) for got in results]
        found, wanted = np.concatenate(parts, axis=-1), group.results[index]
        with np.errstate(all="ignore"):
            size = np.max(abs(wanted), axis=-1, keepdims=True)
            off = ~(abs(found - wanted) <= EPS**TOLERANCE * np.maximum(size, 1))
        for place in map(tuple, np.argwhere(off & ~(np.isnan(wanted) & np.isnan(found)))):
            scale = max(group.cases[index[place[:-1]]].scales)
            if not abs(found[place] - wanted[place]) <= GATE * EPS * scale:
                raise self._failure(group, f"component {place[-1]} is {found[place]}, not {wanted[place]}")

    def _run(self, group: Group, given: Sequence[Array], axis: int, name: str = "", branch: Any = ()) -> list[Array]:
        """Return the results of a call; turn an exception or a warning into `ValidationFailed`."""
        function = getattr(self.module, name or group.row.name)
        try:
            found = function(*map(self.library.make, given), *(branch or group.branch), axis=axis)
        except (ArithmeticError, TypeError, ValueError, Warning) as error:
            raise self._failure(group, repr(error)) from error
        self.count += 1
        return list(map(np.asarray, found if isinstance(found, tuple) else (found,)))

    def _failure(self, group: Group, what: str) -> ValidationFailed:
        name = f"{self.module.__name__.rpartition('.')[2]}.{group.row.name}"
        branch = "".join(f", branch {k}" for k in group.branch)
        return ValidationFailed(f"{name}{branch}, in {self.library.name}: {what}")


def _floats(rows: Sequence[Sequence[Any]]) -> Array:
    """Return numbers of 50 digits as an array of floats."""
    return np.array([[float(number) for number in row] for row in rows])


def _turned(array: Array, leading: int, axis: int) -> Array:
    """Return the array with its leading axes moved behind the others for ``axis=0``, or unchanged for −1."""
    if axis == -1:
        return array
    return np.ascontiguousarray(np.moveaxis(array, range(leading), range(array.ndim - leading, array.ndim)))
