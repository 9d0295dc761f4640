"""Run the functions of a C header on exact numbers, in both call forms and all array layouts."""

from __future__ import annotations

import itertools
import random
import sys
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import mpmath

from ...maps.chart import Chart
from ..rows import Function, Table, inside
from ..signatures import POSES
from . import decimals, reals
from .batches import Batch, ValidationFailed, compare, composed, same
from .c_interpreter import UNSET, CError, Pointer, Unit, load
from .decimals import Decimal
from .run import chosen
from .vectors import Flat

SEED = 1863


def validate(folder: Path, chart: Chart, geometry: bool, tables: Sequence[Table] = (POSES,)) -> int:
    """Run the headers of a chart, one for each table; return the number of calls that equal the formula.

    Algebraic functions run on symbols, others on numbers of 50 digits. With ``geometry`` all functions are called, in
    all array layouts; otherwise only `own_functions`. `ValidationFailed` names the function, or the line that divides
    integers, leaves the bounds of an array or reads an unset cell.
    """
    headers = [inside(table, f"{chart.name}.h") for table in tables]
    try:
        unit = load("".join(f'#include "{header}"\n' for header in headers), folder)
        _require_macros(unit, chart, tables)
        given = {table: [*chosen(chart, table, geometry), *composed(chart, table)] for table in tables}
        calls = sum(check(unit, chart, found, table, geometry) for table, found in given.items())
        if geometry and unit.idle:
            raise ValidationFailed(f"nothing calls {', '.join(unit.idle)}, so their results are unknown")
    except (CError, ValidationFailed) as error:
        raise ValidationFailed(f"{', '.join(headers)}: {error}") from error
    return calls


def check(unit: Unit, chart: Chart, given: Sequence[Batch], table: Table = POSES, layouts: bool = True) -> int:
    """Compare functions in both call forms with the formulas, optionally in all layouts; return the number of calls."""
    count = 0
    with reals.digits(decimals.EXACT_DIGITS):
        for batch in given:
            branch = batch.branch or ((0,) if batch.row.branch else ())
            kernel = Kernel(unit, f"{prefix(chart, table)}_{batch.function}", batch.row, branch)
            cases = [case.arguments for case in batch.cases]
            for case, row in zip(batch.cases, kernel.rows(cases), strict=True):
                for found in (kernel.plain(case.arguments), row):
                    compare(kernel.name, found, case.result, batch.agree)
            count += 1 + len(cases) + (_layouts(kernel, chart, _samples(batch)) if layouts else 0)
    return count


def prefix(chart: Chart, table: Table) -> str:
    """Return the prefix of function names, without the underscore that follows."""
    return "_".join(filter(None, ("dualcay", table.name, chart.name)))


class OneMemory(list[Any]):
    """Cells of results, then of arguments; a read of an argument after a result is written raises `CError`."""

    def __init__(self, results: int, arguments: Sequence[Any]) -> None:
        super().__init__([*(UNSET,) * results, *arguments])
        self.results, self.written = results, False

    def __getitem__(self, index: Any) -> Any:
        if self.written and index >= self.results:
            raise CError("an argument is read after a result is written, so the two may not overlap")
        return super().__getitem__(index)

    def __setitem__(self, index: Any, value: Any) -> None:
        self.written = self.written or index < self.results
        super().__setitem__(index, value)


@dataclass(frozen=True, slots=True)
class Kernel:
    """Function of a header with its row of a table and its branch; arguments and results are flat."""

    unit: Unit
    name: str
    row: Function
    branch: tuple[int, ...] = ()

    @property
    def sizes(self) -> list[int]:
        return [array.size for array in self.row.results]

    def plain(self, arguments: Sequence[Flat]) -> Flat:
        """Call the form for one value, with every array in separate memory."""
        return self._one([Pointer.to(list(argument)) for argument in arguments], list(map(_unset, self.sizes)))

    def loading_first(self, arguments: Sequence[Flat]) -> Flat:
        """Call the form for one value; raise `CError` for results that may not overlap arguments in every way."""
        cells = OneMemory(sum(self.sizes), [c for argument in arguments for c in argument])
        given = _consecutive(cells, cells.results, [len(argument) for argument in arguments])
        return self._one(given, _consecutive(cells, 0, self.sizes))

    def rows(self, batch: Sequence[Sequence[Flat]]) -> list[Flat]:
        """Call the form for several values, with another stride for each array; a row alone may have any."""
        sizes = [*map(len, batch[0]), *self.sizes]
        strides = range(len(batch) + 1, len(batch) + 1 + len(sizes))
        arrays = [_unset(size * stride) for size, stride in zip(sizes, strides, strict=True)]
        for j, arguments in enumerate(batch):
            for pointer, stride, argument in zip(arrays, strides, arguments):
                pointer.cells[j::stride] = argument
        told = (stride if size > 1 else sys.maxsize for stride, size in zip(strides, sizes, strict=True))
        passed = [item for pair in zip(arrays, told, strict=True) for item in pair]
        split = 2 * len(batch[0])
        self.unit.call(f"{self.name}_rows", len(batch), *passed[:split], *self.branch, *passed[split:])
        made = [*zip(arrays, strides, sizes, strict=True)][len(batch[0]) :]
        if any(value is not UNSET for p, stride, _ in made for value in p.cells[len(batch) :: stride]):
            raise CError(f"{self.name}_rows writes beyond {len(batch)} values")
        return [tuple(p[i * stride + j] for p, stride, n in made for i in range(n)) for j in range(len(batch))]

    def _one(self, given: Sequence[Pointer], results: Sequence[Pointer]) -> Flat:
        sizes = [array.size for array in self.row.arguments]
        passed = [pointer[0] if size == 1 else pointer for pointer, size in zip(given, sizes, strict=True)]
        self.unit.call(self.name, *passed, *self.branch, *results)
        return tuple(pointer[i] for pointer, size in zip(results, self.sizes, strict=True) for i in range(size))


def _unset(size: int) -> Pointer:
    return Pointer.to([UNSET] * size)


def _consecutive(cells: list[Any], start: int, sizes: Sequence[int]) -> list[Pointer]:
    starts = itertools.accumulate(sizes[:-1], initial=start)
    return [Pointer(cells, start, 0, len(cells)) for start in starts]


def _layouts(kernel: Kernel, chart: Chart, samples: Sequence[Sequence[Flat]]) -> int:
    """Require bit-identical results in rows, one memory and equivalent branches; return the number of calls."""
    expected = [kernel.plain(arguments) for arguments in samples]
    compare(f"{kernel.name}, in one memory", kernel.loading_first(samples[-1]), expected[-1], same)
    turned = ((k + turns * chart.branches,) for k in kernel.branch for turns in (-1, 2))
    branches = [kernel.branch, *turned]
    for branch in branches:
        other = replace(kernel, branch=branch)
        for row, result in zip((other.plain(samples[0]), *other.rows(samples)), (expected[0], *expected), strict=True):
            compare(f"{kernel.name}, branch {branch}", row, result, same)
    return 1 + 2 * len(branches)


def _samples(batch: Batch) -> Sequence[Sequence[Flat]]:
    """Return three argument lists of 50 digits for layouts: taken from the cases, or drawn if the cases are exact."""
    if not batch.exact:
        return [batch.cases[place].arguments for place in (0, len(batch.cases) // 2, -1)]
    draw = random.Random(SEED)

    def drawn(size: int) -> Flat:
        return tuple(Decimal(mpmath.mpf(draw.uniform(-0.5, 0.5))) for _ in range(size))

    return [[drawn(array.size) for array in batch.row.arguments] for _ in range(3)]


def _require_macros(unit: Unit, chart: Chart, tables: Sequence[Table]) -> None:
    """Compare the macros of a chart, including function aliases, and its singular angles with the expected ones."""
    begin, angles = prefix(chart, POSES), [UNSET] * len(chart.singular_angles)
    expected = {f"{begin.upper()}_ORDER": str(chart.order), f"{begin.upper()}_SINGULAR_ANGLES": str(len(angles))}
    for table, form in itertools.product(tables, ("", "_rows")):
        name = prefix(chart, table)
        expected |= {f"{name}_{a}{form}": f"{name}_{b}{form}" for a, b in table.aliases(chart).items()}
    for macro, text in expected.items():
        if unit.source.expand(macro) != text:
            raise ValidationFailed(f"{macro} is {unit.source.expand(macro)}, not {text}")
    if unit.call(f"{begin}_singular_angles", Pointer.to(angles)) != len(angles):
        raise ValidationFailed(f"singular_angles does not return {len(angles)}")
    with reals.digits(decimals.EXACT_DIGITS):
        wanted = [mpmath.mpf(angle.evalf(decimals.EXACT_DIGITS + 5)) for angle in chart.singular_angles]
        compare("singular_angles", angles, wanted, partial(decimals.close, tolerance=decimals.tolerance(chart)))
