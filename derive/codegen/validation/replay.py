"""Replay of a package of kernels on floats: what exact validation does not execute.

Exact numbers take neither the path of single floats nor scratch memory, blocks and ``out``; here public functions are
called on floats of several types, in all these ways, and every result array is compared with the formula's results,
within what rounding may do (see ``rounding``). Kernels of any Python target are replayed, in the arrays of any library.
"""

from __future__ import annotations

import importlib
import math
import warnings
from collections.abc import Container, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any

import mpmath
import numpy as np

from ...maps.chart import Chart
from ..cases import far, samples
from ..lowered import lower_chart
from ..rows import Table
from ..signatures import POSES
from . import ways
from .calls import NUMPY, Call, Caller, Library, alone, several
from .helpers import helpers
from .known import Analysis, Known, require_sharp
from .loading import loaded, module_of
from .sample import its_own

FEW = 20
"""Size of small batches, where a target has none of its own."""

BLOCK = 7
"""Of a replay, so that small batches have several blocks, and one of other length."""

BEYOND = 8
"""How far beyond an overflow the vectors are which must not give wrong results."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Machinery:
    """What the run-time parts of a target do around its kernels.

    Parameters
    ----------
    out : bool
        Whether functions take ``out``.
    silent : bool
        Whether IEEE results at singular points come without a warning.
    few, block : str
        Where the numbers stand, ``module.NAME``, of the largest batch that runs pose by pose, and of the largest block.
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
    all_ways: bool = True,
) -> int:
    """Call the functions of the modules of a chart on floats; return how many calls agree with its formulas.

    Parameters
    ----------
    folder : Path
        The package.
    chart : Chart
    machinery : Machinery
    libraries : sequence of Library
        Whose arrays are given.
    tables : sequence of Table
        A module each.
    all_ways : bool
        Whether to try all that is the same for every chart: once for a package is enough. Else functions are called
        which read its scalars or are its own, one of them in all ways.

    Raises
    ------
    ValidationFailed
        Naming the function, how it was called, and the first component that is off.
    """
    if not libraries:
        return 0
    with loaded(folder) as package:
        return replay_package(package, chart, machinery, libraries, tables, all_ways=all_ways)


def replay_package(
    package: str,
    chart: Chart,
    machinery: Machinery,
    libraries: Sequence[Library],
    tables: Sequence[Table] = (POSES,),
    *,
    all_ways: bool,
) -> int:
    """The same for a package that can be imported."""
    return sum(_replay(package, chart, table, machinery, libraries, all_ways) for table in tables)


def _replay(
    package: str, chart: Chart, table: Table, machinery: Machinery, libraries: Sequence[Library], all_ways: bool
) -> int:
    dtypes = tuple(dict.fromkeys(dtype for library in libraries for dtype in library.dtypes))
    analysis, chosen, found = _analysed(chart, table, dtypes, all_ways)
    with warnings.catch_warnings(), np.errstate(all="warn"):
        warnings.simplefilter("error" if machinery.silent else "ignore", RuntimeWarning)
        module = module_of(package, chart, table)
        few = _number(package, machinery.few) if machinery.few else FEW
        callers = [Caller(module, library) for library in libraries]
        with _small_blocks(package, machinery.block) if machinery.block else nullcontext():
            for caller in callers:
                _every_function(caller, found, chart, few)
                _overflow(caller, chart, table, analysis, chosen, few)
                # run-time parts do for a further library what they do for the first
                _ways(caller, found, chart, machinery, few, all_ways and caller is callers[0])
        beside = helpers(importlib.import_module(package), module, table) if all_ways else 0
    return beside + sum(caller.count for caller in callers)


@lru_cache(maxsize=2)
def _analysed(
    chart: Chart, table: Table, dtypes: tuple[np.dtype[Any], ...], every: bool
) -> tuple[Analysis, Container[str], Sequence[Known]]:
    """The functions that are called, and what they return; a package may be replayed again."""
    lowered = lower_chart(chart, table)
    analysis, chosen = Analysis(chart, lowered, dtypes), set(table.functions) if every else its_own(lowered)
    found = [analysis.known(group) for group in samples(chart, table, chosen)]
    for known in found:
        require_sharp(known)
    return analysis, chosen, found


def _every_function(caller: Caller, found: Sequence[Known], chart: Chart, few: int) -> None:
    """Single poses, few, many in several blocks; components last and first; under every name, keyword and branch."""
    for known in found:
        for dtype in caller.library.dtypes:
            plain = dtype == np.float64
            for combination in range(len(known.results) if plain else 1):
                caller.check(Call(known, alone(known, combination), dtype))
            for axis in (-1, 0):
                for count in (few // 2, few + BLOCK):
                    caller.check(Call(known, several(known, count), dtype, axis))
            if known.row.keywords:
                ways.keywords(caller, known, dtype, few)
            if known.has_zeros:
                ways.zeros(caller, known, dtype, few)
        if not known.row.real and caller.library is NUMPY:
            ways.complex_numbers(caller, known)
        first = Call(known, several(known, 1), caller.library.dtypes[0])
        for name in known.row.aliases_in(chart):
            caller.check(replace(first, name=name))
        for turns in (-1, 2) if known.branch else ():
            caller.check(replace(first, branch=(known.branch[0] + turns * chart.branches,)))


def _overflow(caller: Caller, chart: Chart, table: Table, analysis: Analysis, chosen: Container[str], few: int) -> None:
    """Where forward maps overflow, in another type where x does, results are right or not finite.

    The widest type is left out: bounds overflow with it.
    """
    dtypes = (dtype for dtype in caller.library.dtypes if dtype != np.longdouble)
    for dtype, everywhere in zip(dtypes, (False, True), strict=False):
        largest = float(np.finfo(dtype).max)
        size = BEYOND * mpmath.mpf(math.sqrt(largest) if everywhere else chart.overflow(largest)[1])
        for known in map(analysis.known, far(chart, size, table, chosen)):
            for picks in (alone(known, 0), several(known, few + BLOCK)):
                call = Call(known, picks, dtype)
                caller.compare(call, caller.run(call), overflow=True)


def _ways(caller: Caller, found: Sequence[Known], chart: Chart, machinery: Machinery, few: int, all_ways: bool) -> None:
    """What the run-time parts do, on a function of each kind; or on one, which the chart decides, in one type."""
    kinds, dtypes = ways.kinds(found), caller.library.dtypes
    sample = chart.branches % len(kinds)
    for known in kinds if all_ways else [kinds[sample]]:
        for dtype in dtypes if all_ways else [dtypes[sample % len(dtypes)]]:
            ways.broadcasting(caller, known, dtype, few)
            ways.spoilt(caller, known, dtype, few)
            ways.layouts(caller, known, dtype, few)
            if machinery.out and len(known.row.results) == 1:
                ways.out(caller, known, dtype, few)
    if all_ways:
        ways.interrupted(caller, kinds[sample], dtypes[0], few)


def _place(package: str, place: str) -> tuple[Any, str]:
    name, _, attribute = place.rpartition(".")
    return importlib.import_module(f"{package}.{name}"), attribute


def _number(package: str, place: str) -> int:
    return int(getattr(*_place(package, place)))


@contextmanager
def _small_blocks(package: str, place: str) -> Iterator[None]:
    """Blocks of few poses while this lasts."""
    module, attribute = _place(package, place)
    size = getattr(module, attribute)
    setattr(module, attribute, BLOCK)
    try:
        yield
    finally:
        setattr(module, attribute, size)
