"""Replay of a package on floats: single poses, blocks, ``out`` and layouts, which exact numbers do not exercise.

Results agree with the formula to half of the digits, or within the error scale of an ill-conditioned case. Kernels of
any Python target are replayed, in the arrays of any library.
"""

from __future__ import annotations

import itertools
import warnings
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from pkgutil import resolve_name
from types import ModuleType
from typing import Any, TypeAlias

import mpmath
import numpy as np
from numpy.typing import NDArray

from ...maps.chart import Chart
from ..rows import Function, Table
from ..signatures import POSES
from .batches import ValidationFailed
from .calls import grouped
from .decimals import EXACT_DIGITS
from .float_cases import FloatCase, cases
from .loading import loaded, module_of, replaced
from .run import own_functions

Array: TypeAlias = NDArray[Any]

FEW = 20  # size of the largest batch that runs pose by pose; default for targets without this limit
BLOCK = 7  # block size of a replay: small, so that test batches fill several blocks and end with a shorter one
CASES_MAX = 4  # largest number of cases of a function and branch: one for each row of 4 q qᵀ
TOLERANCE = 1 / 2
"""Share of the digits of a type that must be right in well-conditioned results: a replay tests wiring, not rounding."""

GATE = 16  # largest error of an ill-conditioned result, in units of the machine epsilon times the scale of the case
TOLERANCE_SAME = 1e-6  # largest relative difference between two calls on the same numbers: some eps of float32


@dataclass(frozen=True, slots=True)
class Library:
    """Array library of a target: conversion from NumPy arrays by ``make``, and the types that are replayed."""

    name: str
    make: Callable[[Array], Any]
    dtypes: tuple[np.dtype[Any], ...]


NUMPY = Library("numpy", np.asarray, tuple(map(np.dtype, (np.float64, np.float32, np.longdouble))))


@dataclass(frozen=True, slots=True, kw_only=True)
class Machinery:
    """Features of the run-time parts of a target."""

    out: bool = True  # True if functions take an argument ``out``
    silent: bool = True  # True if singular points give IEEE results without a warning
    few: str = ""  # constant (``module.NAME``) with the size of the largest batch that runs pose by pose
    block: str = ""  # constant with the size of the largest block


def replay(
    source: Path | str,
    chart: Chart,
    machinery: Machinery,
    libraries: Sequence[Library] = (NUMPY,),
    tables: Sequence[Table] = (POSES,),
    *,
    geometry: bool,
) -> int:
    """Call the functions of a package on floats; return the number of calls that agree with the formulas of a chart.

    ``source`` is a folder or the name of a package that can be imported. With ``geometry`` all functions are called,
    and one of each kind also in all array layouts; otherwise only `own_functions`.
    `ValidationFailed` names the first wrong component.
    """
    if not libraries:
        return 0
    with (
        loaded(source) if isinstance(source, Path) else nullcontext(source) as package,
        _block(f"{package}.{machinery.block}") if machinery.block else nullcontext(),
        warnings.catch_warnings(),
        np.errstate(all="warn"),
    ):
        warnings.simplefilter("error" if machinery.silent else "ignore", RuntimeWarning)
        few = int(resolve_name(f"{package}.{machinery.few}")) if machinery.few else FEW
        count = 0
        for table, library in itertools.product(tables, libraries):
            caller = Caller(module_of(package, chart, table), library, machinery.out, few)
            # run-time parts treat all libraries alike: one library covers their layouts
            caller.replay(_groups(chart, table, geometry), chart, geometry and library is libraries[0])
            count += caller.count
        return count


def _block(constant: str) -> AbstractContextManager[None]:
    """Set the constant of a package to the block size of a replay, for a while."""
    module, _, name = constant.rpartition(".")
    return replaced(vars(resolve_name(module)), name, BLOCK)


@dataclass(frozen=True)
class Group:
    """Cases of one function and branch, with arguments and results as ``longdouble`` arrays."""

    row: Function
    branch: tuple[int, ...]
    cases: tuple[FloatCase, ...]

    @cached_property
    def arguments(self) -> list[Array]:
        columns = zip(*(case.arguments for case in self.cases), strict=True)
        kinds = self.row.arguments
        return [_long(rows).reshape(-1, *kind.shape) for rows, kind in zip(columns, kinds, strict=True)]

    @cached_property
    def results(self) -> Array:
        return _long([case.result for case in self.cases])

    def given(self, index: Array, dtype: np.dtype[Any], axis: int) -> list[Array]:
        """Return the arguments of the indexed cases, with components on the last axes or, for ``axis=0``, the first."""
        return [_turned(array[index].astype(dtype), index.ndim, axis) for array in self.arguments]


def _groups(chart: Chart, table: Table, geometry: bool) -> list[Group]:
    """Return the cases of all functions and branches; without ``geometry``, `own_functions` on branches 0 and 1."""
    found = cases(chart, table, None if geometry else frozenset(own_functions(chart, table)))
    called = (case for case in found if geometry or case.branch in (None, 0, 1))
    return [Group(found[0].row, branch, found[:CASES_MAX]) for branch, found in grouped(called)]


@dataclass
class Caller:
    """Caller of the functions of a module, which compares their results and counts the calls."""

    module: ModuleType
    library: Library
    out: bool
    few: int
    count: int = 0

    def replay(self, groups: Sequence[Group], chart: Chart, in_all_ways: bool) -> None:
        """Call every function; with ``in_all_ways`` call one function of each kind in all array layouts and types."""
        kinds: dict[tuple[Any, ...], Group] = {}
        for group in groups:
            row, count = group.row, len(group.cases)
            kinds[len(row.arguments), len(row.results), bool(row.constants), row.branch, row.real] = group
            many = np.arange(self.few + BLOCK) % count
            for index in (*map(np.array, range(count)), np.arange(self.few // 2) % count, many):
                self.check(group, index)
            self.check(group, many, axis=0)
            for name in row.aliases_in(chart):
                self.check(group, np.array(0), name=name)
            for turns in (-1, 2) if group.branch else ():
                self.check(group, np.array(0), branch=(group.branch[0] + turns * chart.branches,))
        for group in kinds.values() if in_all_ways else ():
            for count, axis in ((3, -1), (self.few + BLOCK, 0)):
                for dtype in self.library.dtypes:
                    self.check(group, np.arange(count) % len(group.cases), dtype, axis)
                self._ways(group, np.arange(count) % len(group.cases), axis)

    def check(
        self, group: Group, index: Array, dtype: np.dtype[Any] | None = None, axis: int = -1, **named: Any
    ) -> list[Array]:
        """Call a function on the indexed cases, compare the results with the formula, and return them."""
        dtype = dtype or self.library.dtypes[0]
        results = self._run(group, group.given(index, dtype, axis), axis, **named)
        kinds = [kind.shape for kind in group.row.results]
        shapes = [kind + index.shape if axis == 0 else index.shape + kind for kind in kinds]
        if [(got.shape, got.dtype) for got in results] != [(shape, dtype) for shape in shapes]:
            raise self._failure(group, f"results of {dtype} are {[(got.dtype, got.shape) for got in results]}")
        parts = [_turned(got, got.ndim - index.ndim, axis).reshape(*index.shape, -1) for got in results]
        found, wanted = np.concatenate(parts, axis=-1), group.results[index]
        with np.errstate(all="ignore"):
            size = np.max(abs(wanted), axis=-1, keepdims=True)
            off = ~(abs(found - wanted) <= np.finfo(dtype).eps ** TOLERANCE * np.maximum(size, 1))
        for place in map(tuple, np.argwhere(off & ~(np.isnan(wanted) & np.isnan(found)))):
            scale = max(group.cases[index[place[:-1]]].scales)
            if not abs(found[place] - wanted[place]) <= GATE * np.finfo(dtype).eps * scale:
                raise self._failure(group, f"component {place[-1]} is {found[place]}, not {wanted[place]}, of {dtype}")
        return results

    def _run(
        self, group: Group, given: Sequence[Array], axis: int, name: str = "", branch: Any = (), **options: Any
    ) -> list[Array]:
        """Return the results of a call; turn an exception or a warning into `ValidationFailed`."""
        function = getattr(self.module, name or group.row.name)
        try:
            found = function(*map(self.library.make, given), *(branch or group.branch), axis=axis, **options)
        except (ArithmeticError, TypeError, ValueError, Warning) as error:
            raise self._failure(group, repr(error)) from error
        self.count += 1
        return list(map(np.asarray, found if isinstance(found, tuple) else (found,)))

    def _ways(self, group: Group, index: Array, axis: int) -> None:
        """Check strided, broadcast and overlapping arrays, and axes of length 1, against the plain call."""
        given, plain = group.given(index, self.library.dtypes[0], axis), self.check(group, index, axis=axis)

        def same(how: str, arrays: Sequence[Array], wanted: Sequence[Array] = plain, **options: Any) -> list[Array]:
            found = self._run(group, arrays, axis, **options)
            near = (np.allclose(a, b, rtol=TOLERANCE_SAME, equal_nan=True) for a, b in zip(found, wanted, strict=True))
            if [a.shape for a in found] != [b.shape for b in wanted] or not all(near):
                raise self._failure(group, f"with {how} arrays, axis {axis}, it differs from the plain call")
            return found

        same("strided", [_strided(array) for array in given])
        alone: Any = np.s_[:, np.newaxis] if axis == -1 else np.s_[..., np.newaxis]  # such an axis has the stride 0
        same("single-row", [array[alone] for array in given], [part[alone] for part in plain])
        for place, array in enumerate(given):
            before, after = given[:place], given[place + 1 :]
            if len(given) > 1:
                single = array[(..., slice(1)) if axis == 0 else (slice(1), ...)]
                copies = np.repeat(single, len(index), axis=-1 if axis == 0 else 0)
                same("broadcast", [*before, single, *after], self._run(group, [*before, copies, *after], axis))
            if self.out and len(plain) == 1:
                memory = np.full(max(array.size, plain[0].size), np.nan, array.dtype)
                moved, target = (memory[: part.size].reshape(part.shape) for part in (array, plain[0]))
                moved[...] = array
                if same("overlapping", [*before, moved, *after], out=target)[0] is not target:
                    raise self._failure(group, "the array returned is not out")

    def _failure(self, group: Group, what: str) -> ValidationFailed:
        name = f"{self.module.__name__.rpartition('.')[2]}.{group.row.name}"
        branch = "".join(f", branch {k}" for k in group.branch)
        return ValidationFailed(f"{name}{branch}, in {self.library.name}: {what}")


def _long(rows: Sequence[Sequence[Any]]) -> Array:
    """Return numbers of 50 digits as a ``longdouble`` array."""
    with mpmath.workdps(EXACT_DIGITS):
        numbers = [[mpmath.mpf(number) for number in row] for row in rows]
        heads = np.array([[float(number) for number in row] for row in numbers], np.longdouble)
        tails = [[float(n - float(n)) if mpmath.isfinite(n) else 0.0 for n in row] for row in numbers]
    return heads + np.array(tails, np.longdouble)


def _turned(array: Array, leading: int, axis: int) -> Array:
    """Return the array with its leading axes moved behind the others for ``axis=0``, or unchanged for −1."""
    if axis == -1:
        return array
    return np.ascontiguousarray(np.moveaxis(array, range(leading), range(array.ndim - leading, array.ndim)))


def _strided(array: Array) -> Array:
    wide = np.zeros((*array.shape[:-1], 2 * array.shape[-1]), array.dtype)
    wide[..., ::2] = array
    wide.flags.writeable = False
    return wide[..., ::2]
