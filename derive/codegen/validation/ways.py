"""Ways to call a kernel function that are the same for all of them: the work of the run-time parts of a package."""

from __future__ import annotations

import itertools
import sys
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from types import FrameType
from typing import Any

import numpy as np

from ..rows import Array as Kind
from ..signatures import CHECK, QUATERNION, SCALAR_FIRST
from .calls import Call, Caller, several
from .known import Known
from .rounding import Array

SCALAR_LAST = [1, 2, 3, 0, 5, 6, 7, 4]
"""The components of a dual quaternion in the order of ``scalar_first=False``."""

SCALAR_BACK = [SCALAR_LAST.index(i) for i in range(len(SCALAR_LAST))]

OFFSETS = ((0, 0), (0, 5), (3, 0))
"""Where an argument and a result begin in the memory they share."""

STRETCHED = 1.01
"""What is right, times this, is refused."""

BEFORE = np.nan
"""What stands where results are to be written."""


def kinds(found: Sequence[Known]) -> list[Known]:
    """One function of every kind, by what the run-time parts see of it; on another branch where one is chosen."""
    kinds: dict[tuple[Any, ...], Known] = {}
    for known in found:
        row = known.row
        seen = len(row.arguments), len(row.results), bool(row.constants), row.branch, row.real, row.keywords
        kind = (*seen, known.stands)
        if kind not in kinds or (any(known.branch) and not any(kinds[kind].branch)):
            kinds[kind] = known
    return list(kinds.values())


def broadcasting(caller: Caller, known: Known, dtype: np.dtype[Any], few: int) -> None:
    """Arguments whose batch axes are missing or of length 1, any two of them: few poses, blocks of rows and in rows."""
    length = -(-(few + 1) // 3)
    for width, axis in itertools.product((2, length, 2 * length + 1), (-1, 0)):
        whole = (3, width)
        shapes = (whole, (width,)) if width > length else (whole, (width,), (1, width), (3, 1), ())
        for chosen in itertools.product(shapes, repeat=len(known.shape)):
            if sum(shape != whole for shape in chosen) > 2:
                continue
            picks = (_pick(shape, count) for shape, count in zip(chosen, known.shape, strict=True))
            caller.check(Call(known, tuple(picks), dtype, axis))


def _pick(shape: tuple[int, ...], count: int) -> Array:
    return (np.arange(np.prod(shape, dtype=int)) % count).reshape(shape)


def spoilt(caller: Caller, known: Known, dtype: np.dtype[Any], few: int) -> None:
    """One pose of NaN in each argument: its result is NaN, and no other."""
    for count, (position, kind) in itertools.product((3, few + 1), enumerate(known.row.arguments)):
        call = Call(known, several(known, count), dtype)
        given = call.arguments()
        given[position][1] = np.nan
        how = f"NaN in {kind.name}"
        caller.compare(call, caller.run(call, given, how), how, spoilt=np.arange(count) == 1, position=position)


def layouts(caller: Caller, known: Known, dtype: np.dtype[Any], few: int) -> None:
    """Arguments that lie in memory in all ways, and may not be written."""
    for count, axis in itertools.product((3, few + 1), (-1, 0)):
        call = Call(known, several(known, count), dtype, axis)
        for how, lay in (("Fortran order", np.asfortranarray), ("strided", _strided), ("backwards", _backwards)):
            given = [lay(array) for array in call.arguments()]
            for array in given:
                array.flags.writeable = False
            caller.check(call, given, how)


def _strided(array: Array) -> Array:
    wide = np.zeros((*array.shape[:-1], 2 * array.shape[-1]), array.dtype)
    wide[..., ::2] = array
    return wide[..., ::2]


def _backwards(array: Array) -> Array:
    turned = (slice(None, None, -1),) * array.ndim
    return np.ascontiguousarray(array[turned])[turned]


def keywords(caller: Caller, known: Known, dtype: np.dtype[Any], few: int) -> None:
    """Under each keyword of its row: what is right passes its check, and quaternions come in another order.

    Screws of samples stand on a grid, so their axes are no unit vectors: of no use to a check.
    """
    for count, axis in itertools.product((few // 2, few + 1), (-1, 0)):
        call = Call(known, several(known, count), dtype, axis)
        if CHECK in known.row.keywords and known.row.branch:
            caller.check(call, how="checked", check=True)
            given = call.arguments()
            given[0][(1, ...) if axis else (..., 1)] *= STRETCHED
            caller.refused(call, given, "1] is no ", check=True)
        if SCALAR_FIRST in known.row.keywords:
            given = _ordered(call.arguments(), known.row.arguments, SCALAR_LAST, axis)
            found = caller.run(call, given, "scalar last", scalar_first=False)
            caller.compare(call, _ordered(found, known.row.results, SCALAR_BACK, axis), "scalar last")


def _ordered(arrays: Sequence[Array], kinds: Sequence[Kind], order: Sequence[int], axis: int) -> list[Array]:
    """The arrays, in another order the components of those that are quaternions."""
    return [
        array.take(order[: kind.size], axis) if kind.name == QUATERNION.name else array
        for array, kind in zip(arrays, kinds, strict=True)
    ]


def zeros(caller: Caller, known: Known, dtype: np.dtype[Any], few: int) -> None:
    """Zeros of the other sign, which are the same numbers."""
    for count in (few // 2, few + 1):
        call = Call(known, several(known, count), dtype)
        given = [np.where(array == 0, -np.zeros_like(array), array) for array in call.arguments()]
        caller.check(call, given, "zeros with a sign")


def complex_numbers(caller: Caller, known: Known) -> None:
    """Complex numbers whose imaginary parts are 0: so are those of results, which are complex."""
    call = Call(known, several(known, 3), np.dtype(float))
    given = [array.astype(complex) for array in call.arguments()]
    results = caller.run(call, given, "complex")
    if any(result.dtype != complex for result in results):
        raise caller.failure(call, "complex", f"results are {', '.join(str(result.dtype) for result in results)}")
    caller.compare(call, [result.real for result in results], "complex")


def out(caller: Caller, known: Known, dtype: np.dtype[Any], few: int) -> None:
    """Results in arrays that are given: of other types and layouts, over the memory of arguments, in another order."""
    (array,) = known.row.results
    other = np.dtype(np.float32 if dtype == np.float64 else np.float64)
    for count, axis in itertools.product((3, few + 1), (-1, 0)):
        call = Call(known, several(known, count), dtype, axis)
        shape = call.result_shape(array.shape)
        _into(caller, call, call.arguments(), np.full(shape, BEFORE, dtype), "out")
        _into(caller, call, call.arguments(), _strided(np.full(shape, BEFORE, dtype)), "out with gaps")
        _into(caller, call, call.arguments(), np.full(shape, BEFORE, other), f"out of {other}")
        _into(caller, call, call.arguments(), _strided(np.full(shape, BEFORE, other)), f"out of {other} with gaps")
        if SCALAR_FIRST in known.row.keywords:
            place = np.full(shape, BEFORE, dtype)
            given = _ordered(call.arguments(), known.row.arguments, SCALAR_LAST, axis)
            _into(caller, call, given, place, "out, scalar last", scalar_first=False)
        for position, (start, behind) in itertools.product(range(len(known.shape)), OFFSETS):
            given = call.arguments()
            given[position], place = _together(given[position], shape, start, behind)
            _into(caller, call, given, place, f"out over argument {position + 1}")


def _into(caller: Caller, call: Call, given: Sequence[Array], place: Array, how: str, **options: Any) -> None:
    (found,) = results = caller.run(call, given, how, out=place, **options)
    if found is not place:
        raise caller.failure(call, how, "the array returned is another")
    ordered = _ordered(results, call.row.results, SCALAR_BACK, call.axis) if options else results
    caller.compare(call, ordered, how, dtype=place.dtype)


def _together(array: Array, shape: tuple[int, ...], start: int, behind: int) -> tuple[Array, Array]:
    """The array, and another of some shape, in one memory."""
    size = int(np.prod(shape))
    memory = np.full(max(start + array.size, behind + size), BEFORE, array.dtype)
    moved = memory[start : start + array.size].reshape(array.shape)
    moved[...] = array
    return moved, memory[behind : behind + size].reshape(shape)


def interrupted(caller: Caller, known: Known, dtype: np.dtype[Any], few: int) -> None:
    """Before every line of a call, the same function is called on other poses, in this thread and in another one."""
    count = few + 1
    index = np.roll(np.arange(count), 1) % len(known.results)
    other = tuple(map(np.asarray, np.unravel_index(index, known.shape)))
    call, nested = Call(known, several(known, count), dtype), Call(known, other, dtype)
    given, folder = call.arguments(), str(Path(str(caller.module.__file__)).parent)

    with ThreadPoolExecutor(1) as elsewhere, _before_lines(folder) as tasks:
        tasks += [lambda: caller.check(nested, how="inside another call")]
        tasks += [lambda: elsewhere.submit(caller.check, nested, how="beside another call").result()]
        found = caller.run(call, given, "interrupted")
    caller.compare(call, found, "interrupted")


@contextmanager
def _before_lines(folder: str) -> Iterator[list[Callable[[], None]]]:
    """Do tasks by turns before every line that is run of files in a folder, which Python does not trace meanwhile."""
    tasks: list[Callable[[], None]] = []
    turns = itertools.count()

    def line(frame: FrameType, event: str, argument: Any) -> Any:
        if event == "line":
            tasks[next(turns) % len(tasks)]()
        return line

    def enter(frame: FrameType, event: str, argument: Any) -> Any:
        return line if frame.f_code.co_filename.startswith(folder) else None

    before = sys.gettrace()
    sys.settrace(enter)
    try:
        yield tasks
    finally:
        sys.settrace(before)
