"""Replay of a package on floats: single poses, blocks, ``out`` and layouts, which exact numbers do not pass through.

Public functions are called on seeded cases, one by one and in arrays, and compared with the formula to a share of the
digits; where a case is ill-conditioned, within its scale. Calls that are the same for every chart are made once for a
package. Kernels of any Python target are replayed, in the arrays of any library.
"""

from __future__ import annotations

import importlib
import itertools
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from types import ModuleType
from typing import Any, TypeAlias

import mpmath
import numpy as np
from numpy.typing import NDArray

from ...maps.chart import Chart
from ..rows import Array as Kind
from ..rows import Function, Table
from ..signatures import CHECK, POSES, QUATERNION, SCALAR_FIRST
from .decimals import DIGITS
from .errors import ValidationFailed
from .float_cases import Case, cases
from .loading import loaded, module_of
from .run import own_functions

Array: TypeAlias = NDArray[Any]

FEW = 20
"""Size of small batches, where a target has none of its own."""

BLOCK = 7
"""Block size of a replay, so that small batches have several blocks and a shorter last one."""

TOLERANCE = 1 / 2
"""Share of the digits of a type in which well-conditioned results agree."""

GATE = 16
"""Largest error of any result, in units of the machine epsilon and of its scale."""

CASES_MAX = 4
"""Cases of a function and branch that are replayed; one takes each row of a rotation matrix."""

SCALAR_LAST = [1, 2, 3, 0, 5, 6, 7, 4]
"""Components of a dual quaternion in the order of ``scalar_first=False``."""

STRETCH = 1.01
"""Factor that makes a unit array one that is refused."""


@dataclass(frozen=True, slots=True)
class Library:
    """Arrays as a target takes them: how they are made of those of NumPy, and the types replayed in them."""

    name: str
    make: Callable[[Array], Any]
    dtypes: tuple[np.dtype[Any], ...]


NUMPY = Library("numpy", np.asarray, tuple(map(np.dtype, (np.float64, np.float32, np.longdouble))))


@dataclass(frozen=True, slots=True, kw_only=True)
class Machinery:
    """Run-time parts of a target around its kernels.

    Parameters
    ----------
    out : bool
        Whether functions take ``out``.
    silent : bool
        Whether IEEE results at singular points come without a warning.
    few, block : str
        Places, ``module.NAME``, of the largest batch that runs pose by pose, and of the largest block.
    """

    out: bool = True
    silent: bool = True
    few: str = ""
    block: str = ""


def replay(
    folder: Path,
    chart: Chart,
    machinery: Machinery,
    libraries: Sequence[Library] = (NUMPY,),
    tables: Sequence[Table] = (POSES,),
    *,
    geometry: bool,
) -> int:
    """Call the functions of the modules of a chart on floats; return how many calls agree with its formulas.

    Parameters
    ----------
    folder : Path
        The package.
    chart : Chart
    machinery : Machinery
    libraries : sequence of Library
        Array libraries that arguments are made in.
    tables : sequence of Table
        One module for each.
    geometry : bool
        Whether to call all functions, in all ways that are the same for every chart. Otherwise functions are called
        that read the chart's own scalars.

    Raises
    ------
    ValidationFailed
        Naming the function, how it was called, and the first component that is off.
    """
    if not libraries:
        return 0
    with loaded(folder) as package:
        return replay_package(package, chart, machinery, libraries, tables, geometry=geometry)


def replay_package(
    package: str,
    chart: Chart,
    machinery: Machinery,
    libraries: Sequence[Library],
    tables: Sequence[Table] = (POSES,),
    *,
    geometry: bool,
) -> int:
    """Replay a package that can be imported."""
    count = 0
    with warnings.catch_warnings(), np.errstate(all="warn"):
        warnings.simplefilter("error" if machinery.silent else "ignore", RuntimeWarning)
        for table, library in itertools.product(tables, libraries):
            module = module_of(package, chart, table)
            few = _value(package, machinery.few) if machinery.few else FEW
            with _small_blocks(package, machinery.block) if machinery.block else nullcontext():
                caller = Caller(module, library, machinery.out, few)
                # run-time parts do for a further library what they do for the first
                caller.replay(_groups(chart, table, geometry), chart, geometry and library is libraries[0])
                count += caller.count
    return count


@dataclass(frozen=True)
class Group:
    """Cases of one function and branch, with their numbers as the widest floats."""

    row: Function
    branch: tuple[int, ...]
    cases: tuple[Case, ...]

    @cached_property
    def arguments(self) -> list[Array]:
        columns = zip(*(case.arguments for case in self.cases), strict=True)
        kinds = self.row.arguments
        return [_long(rows).reshape(-1, *kind.shape) for rows, kind in zip(columns, kinds, strict=True)]

    @cached_property
    def results(self) -> Array:
        return _long([case.result for case in self.cases])

    def given(self, index: Array, dtype: np.dtype[Any], axis: int) -> list[Array]:
        """Return the arguments of the cases at an index, components last or first."""
        arrays = (array[index].astype(dtype) for array in self.arguments)
        return [_laid(array, index.ndim, axis) for array in arrays]


def _groups(chart: Chart, table: Table, geometry: bool) -> list[Group]:
    """Return the cases of all functions on all branches, or of a chart's own ones on the first two."""
    names = table.public if geometry else own_functions(chart, table)
    found: dict[tuple[str, int | None], list[Case]] = {}
    for case in cases(chart, table):
        if case.function in names and (geometry or case.branch in (None, 0, 1)):
            found.setdefault((case.function, case.branch), []).append(case)
    return [Group(g[0].row, () if k is None else (k,), tuple(g[:CASES_MAX])) for (_, k), g in found.items()]


@dataclass
class Caller:
    """Calls functions of a module, compares their results, and counts."""

    module: ModuleType
    library: Library
    out: bool
    few: int
    count: int = 0

    def replay(self, groups: Sequence[Group], chart: Chart, in_all_ways: bool) -> None:
        """Call every function, and perhaps one of every kind in all ways, as run-time parts tell kinds apart."""
        kinds: dict[tuple[Any, ...], Group] = {}
        for group in groups:
            self._function(group, chart)
            row = group.row
            kind = (len(row.arguments), len(row.results), bool(row.constants), row.branch, row.real, row.keywords)
            kinds[kind] = group
        for group in kinds.values() if in_all_ways else ():
            for count, axis in ((3, -1), (self.few + BLOCK, 0)):
                self._ways(group, np.arange(count) % len(group.cases), self.library.dtypes[0], axis)

    def _function(self, group: Group, chart: Chart) -> None:
        """Call a function on every case alone, on few and on many in several blocks, under every name and branch."""
        double = np.dtype(float)
        for place in range(len(group.cases)):
            self.check(group, np.array(place), double, -1)
        for dtype, axis in itertools.product(self.library.dtypes, (-1, 0)):
            self.check(group, np.arange(self.few + BLOCK) % len(group.cases), dtype, axis)
        self.check(group, np.arange(max(self.few // 2, 1)) % len(group.cases), double, -1)
        for name in group.row.aliases_in(chart):
            self.check(group, np.array(0), double, -1, name=name)
        for turns in (-1, 2) if group.branch else ():
            self.check(group, np.array(0), double, -1, branch=(group.branch[0] + turns * chart.branches,))

    def check(
        self,
        group: Group,
        index: Array,
        dtype: np.dtype[Any],
        axis: int,
        how: str = "",
        *,
        name: str = "",
        branch: tuple[int, ...] = (),
    ) -> list[Array]:
        """Call a function on the cases at an index and compare the results with the formula; return them."""
        results = self._run(group, group.given(index, dtype, axis), axis, how, name=name, branch=branch)
        flat = []
        for got, kind in zip(results, group.row.results, strict=True):
            shape = kind.shape + index.shape if axis == 0 else index.shape + kind.shape
            if (got.shape, got.dtype) != (shape, dtype):
                raise self._failure(group, how, f"{kind.name} is an array {got.dtype} {got.shape}, not {dtype} {shape}")
            flat.append(_last(got, index.ndim, axis))
        found, wanted = np.concatenate(flat, axis=-1), group.results[index]
        with np.errstate(all="ignore"):
            size = np.max(abs(wanted), axis=-1, keepdims=True)
            off = ~(abs(found - wanted) <= np.finfo(dtype).eps ** TOLERANCE * np.maximum(size, 1))
        for place in np.argwhere(off):
            self._within_scale(group, int(index[tuple(place[:-1])]), int(place[-1]), found[tuple(place)], dtype, how)
        return results

    def _within_scale(self, group: Group, case: int, at: int, got: Any, dtype: np.dtype[Any], how: str) -> None:
        """Raise unless a component is within rounding of the formula, by the scale of its case."""
        wanted = group.results[case, at]
        if np.isnan(wanted) and np.isnan(got):
            return
        if not abs(got - wanted) <= GATE * np.finfo(dtype).eps * max(group.cases[case].scales):
            raise self._failure(group, how or str(dtype), f"component {at} is {got}, not {wanted}")

    def _run(
        self,
        group: Group,
        given: Sequence[Array],
        axis: int,
        how: str = "",
        *,
        name: str = "",
        branch: tuple[int, ...] = (),
        **options: Any,
    ) -> list[Array]:
        """Return the results of a call; an exception or a warning is a failure."""
        function = getattr(self.module, name or group.row.name)
        try:
            found = function(*map(self.library.make, given), *(branch or group.branch), axis=axis, **options)
        except (ArithmeticError, TypeError, ValueError, Warning) as error:
            raise self._failure(group, how, repr(error)) from error
        self.count += 1
        results = list(map(np.asarray, found if isinstance(found, tuple) else (found,)))
        if len(results) != len(group.row.results):
            raise self._failure(group, how, f"{len(results)} results")
        return results

    # --- ways to call that are the same for every function ----------------------------------------------------------

    def _ways(self, group: Group, index: Array, dtype: np.dtype[Any], axis: int) -> None:
        """Compare calls on arrays of any layout, shape and place with the plain call on the same numbers."""
        given, plain = group.given(index, dtype, axis), self.check(group, index, dtype, axis)

        def same(how: str, arrays: Sequence[Array], wanted: Sequence[Array] = plain, **options: Any) -> list[Array]:
            found = self._run(group, arrays, axis, how, **options)
            if not all(map(_near, found, wanted)):
                raise self._failure(group, f"{how}, axis {axis}", "differs from the plain call")
            return found

        for how, lay in (("Fortran order", np.asfortranarray), ("strided", _strided), ("backwards", _backwards)):
            laid = [lay(array) for array in given]
            for array in laid:
                array.flags.writeable = False
            same(how, laid)
        for place, array in enumerate(given):
            self._broadcast(group, given, place, len(index), axis)
            spoilt = [part.copy() for part in given]
            where = (..., 1) if axis == 0 else (1, ...)
            spoilt[place][where] = np.nan
            if not any(np.isnan(part[where]).any() for part in self._run(group, spoilt, axis, "NaN")):
                raise self._failure(group, "NaN", "a NaN makes no NaN")
            if self.out and len(plain) == 1:
                memory = np.full(max(array.size, plain[0].size), np.nan, dtype)
                moved, target = (memory[: part.size].reshape(part.shape) for part in (array, plain[0]))
                moved[...] = array
                arrays = [*given[:place], moved, *given[place + 1 :]]
                if same("out over an argument", arrays, out=target)[0] is not target:
                    raise self._failure(group, "out", "the array returned is another")
        self._keywords(group, given, plain, axis, same)

    def _broadcast(self, group: Group, given: Sequence[Array], place: int, count: int, axis: int) -> None:
        """Compare a call with one argument of a single pose with the call on as many copies of it."""
        single = given[place][(..., slice(1)) if axis == 0 else (slice(1), ...)]
        copies = np.repeat(single, count, axis=-1 if axis == 0 else 0)
        results = [
            self._run(group, [*given[:place], array, *given[place + 1 :]], axis, "broadcast")
            for array in (single, copies)
        ]
        for found, wanted in zip(*results, strict=True):
            if len(given) > 1 and not _near(found, wanted):
                raise self._failure(group, "broadcast", f"differs from the call on copies of argument {place + 1}")

    def _keywords(self, group: Group, given: Sequence[Array], plain: Any, axis: int, same: Callable[..., Any]) -> None:
        """Call with each keyword of a row: right arguments pass their check, quaternions come in another order."""
        row = group.row
        if CHECK in row.keywords and row.branch:
            same("checked", given, check=True)
            wrong = [array * STRETCH for array in given]
            try:
                self._run(group, wrong, axis, check=True)
            except ValidationFailed as error:
                if "is no " not in str(error):
                    raise
            else:
                raise self._failure(group, "check", "a wrong argument is not refused")
        if SCALAR_FIRST in row.keywords:
            arrays, wanted = _scalar_last(given, row.arguments, axis), _scalar_last(plain, row.results, axis)
            same("scalar last", arrays, wanted, scalar_first=False)

    def _failure(self, group: Group, how: str, what: str) -> ValidationFailed:
        name = f"{self.module.__name__.rpartition('.')[2]}.{group.row.name}"
        parts = [name, *(f"branch {k}" for k in group.branch), *filter(None, (how,)), f"in {self.library.name}"]
        return ValidationFailed(f"{', '.join(parts)}: {what}")


def _near(found: Array, wanted: Array) -> bool:
    """Return whether arrays are equal up to rounding; NaN equals NaN."""
    if (found.shape, found.dtype) != (wanted.shape, wanted.dtype):
        return False
    finite = wanted[np.isfinite(wanted)]
    size = np.max(abs(finite), initial=1)
    return bool(np.allclose(found, wanted, rtol=0, atol=np.finfo(wanted.dtype).eps ** TOLERANCE * size, equal_nan=True))


def _scalar_last(arrays: Sequence[Array], kinds: Sequence[Kind], axis: int) -> list[Array]:
    """Return arrays with the scalar of quaternions last."""
    pairs = zip(arrays, kinds, strict=True)
    return [a.take(SCALAR_LAST[: k.size], axis) if k.name == QUATERNION.name else a for a, k in pairs]


def _long(rows: Sequence[Sequence[Any]]) -> Array:
    """Return numbers of many digits as the widest floats."""
    with mpmath.workdps(DIGITS):
        numbers = [[mpmath.mpf(number) for number in row] for row in rows]
        heads = np.array([[float(number) for number in row] for row in numbers], np.longdouble)
        tails = [[float(n - float(n)) if mpmath.isfinite(n) else 0.0 for n in row] for row in numbers]
    return heads + np.array(tails, np.longdouble)


def _laid(array: Array, batch: int, axis: int) -> Array:
    """Return an array of ``batch`` leading axes with its components where ``axis`` says."""
    moved = np.moveaxis(array, range(batch), range(array.ndim - batch, array.ndim)) if axis == 0 else array
    return np.ascontiguousarray(moved) if array.ndim else array


def _last(array: Array, batch: int, axis: int) -> Array:
    """Return a result with its components as one last axis."""
    moved = np.moveaxis(array, range(array.ndim - batch, array.ndim), range(batch)) if axis == 0 else array
    return moved.reshape(*moved.shape[:batch], -1)


def _strided(array: Array) -> Array:
    wide = np.zeros((*array.shape[:-1], 2 * array.shape[-1]), array.dtype)
    wide[..., ::2] = array
    return wide[..., ::2]


def _backwards(array: Array) -> Array:
    turned = (slice(None, None, -1),) * array.ndim
    return np.ascontiguousarray(array[turned])[turned]


def _value(package: str, place: str) -> int:
    name, _, attribute = place.rpartition(".")
    return int(getattr(importlib.import_module(f"{package}.{name}"), attribute))


@contextmanager
def _small_blocks(package: str, place: str) -> Iterator[None]:
    """Run kernels in blocks of few poses."""
    name, _, attribute = place.rpartition(".")
    module = importlib.import_module(f"{package}.{name}")
    size = getattr(module, attribute)
    setattr(module, attribute, BLOCK)
    try:
        yield
    finally:
        setattr(module, attribute, size)
