"""Run the functions of a C header on exact numbers, in all the ways its functions may be called."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import mpmath

from ...maps.chart import Chart
from ..rows import Function, Table, inside
from ..signatures import POSES
from . import decimals
from .c_interpreter import UNSET, CError, Pointer, Unit, load
from .decimals import Decimal
from .errors import ValidationFailed
from .run import chosen
from .samples import Batch, same
from .vectors import Flat

SEED = 1863


def validate(folder: Path, chart: Chart, geometry: bool, tables: Sequence[Table] = (POSES,)) -> int:
    """Interpret the headers of a chart, one for each table; return how many calls equal the formula.

    Rational functions run on symbols, the others on numbers of 50 digits. With ``geometry`` all functions are called,
    and on such numbers results are laid over arguments, which must not change a bit. Otherwise functions are called
    that together read every result of the chart's own scalars.

    Raises
    ------
    ValidationFailed
        Naming the function, or the line that is no C, divides integers, leaves an array, reads an unset cell.
    """
    headers = [inside(table, f"{chart.name}.h") for table in tables]
    try:
        unit = load("".join(f'#include "{header}"\n' for header in headers), folder)
        _require_constants(unit, chart)
        for table in tables:
            _require_aliases(unit, chart, table)
        calls = sum(check(unit, chart, chosen(chart, table, geometry), table, geometry) for table in tables)
        if geometry and unit.idle:
            raise ValidationFailed(f"nothing calls {', '.join(unit.idle)}, so their results are unknown")
    except (CError, ValidationFailed) as error:
        raise ValidationFailed(f"{', '.join(headers)}: {error}") from error
    return calls


def check(unit: Unit, chart: Chart, given: Sequence[Batch], table: Table = POSES, layouts: bool = True) -> int:
    """Compare both forms of functions with their expected values, perhaps in all layouts; return the call count."""
    count, seen = 0, set()
    with mpmath.workdps(decimals.DIGITS):
        for batch in given:
            branch = batch.branch or ((0,) if batch.row.branch else ())
            kernel = Kernel(unit, prefix(chart, table), batch.row, branch)
            count += _values(kernel, batch)
            if layouts and (batch.function, branch) not in seen:
                seen.add((batch.function, branch))
                count += _layouts(kernel, chart, _arguments(batch))
    return count


def prefix(chart: Chart, table: Table) -> str:
    """Return the beginning of function names, before a further underscore."""
    return "_".join(filter(None, ("dualcay", table.name, chart.name)))


@dataclass(frozen=True, slots=True)
class Placed:
    """An array of ``size`` components for ``count`` values in memory: component i of value j at ``i * stride + j``."""

    pointer: Pointer
    size: int
    count: int = 1
    stride: int = 1

    @classmethod
    def new(cls, rows: Sequence[Flat], stride: int = 1) -> Placed:
        """Return an array with these values, in cells of its own; cells between its rows are not set."""
        cells = [UNSET] * ((len(rows[0]) - 1) * stride + len(rows))
        for j, row in enumerate(rows):
            cells[j : (len(row) - 1) * stride + j + 1 : stride] = row
        return cls(Pointer.to(cells), len(rows[0]), len(rows), stride)

    @property
    def rows(self) -> list[Flat]:
        """The values; reading an unset component is an error, and so is a cell written between rows."""
        for i, value in enumerate(self.pointer.cells if self.stride > 1 else ()):
            if i % self.stride >= self.count and value is not UNSET:
                raise CError(f"cell {i} was written: that is beyond {self.count} values, stride {self.stride}")
        return [tuple(self.pointer[i * self.stride + j] for i in range(self.size)) for j in range(self.count)]


@dataclass(frozen=True, slots=True)
class Kernel:
    """A function of a header, with its row of a table and perhaps a branch: flat arguments in, the flat result out."""

    unit: Unit
    prefix: str
    row: Function
    branch: tuple[int, ...] = ()

    @property
    def name(self) -> str:
        """The name in C."""
        return f"{self.prefix}_{self.row.name}"

    def plain(self, arguments: Sequence[Flat]) -> Flat:
        """Call the form for one value, every array in its own memory."""
        return self._one([Placed.new([argument]) for argument in arguments], [_unset(a.size) for a in self.row.results])

    def overlapping(self, arguments: Sequence[Flat], start: int) -> Flat:
        """Call the form for one value, with all arrays in one memory and results from cell ``start`` on."""
        sizes = [array.size for array in self.row.results]
        cells = [UNSET] * sum(sizes) + [c for argument in arguments for c in argument] + [UNSET] * sum(sizes)
        given = _consecutive(cells, sum(sizes), [len(argument) for argument in arguments])
        return self._one(given, _consecutive(cells, start, sizes))

    def rows(self, batch: Sequence[Sequence[Flat]]) -> list[Flat]:
        """Call the form for several values, every array with a stride of its own."""
        count, columns = len(batch), list(zip(*batch, strict=True))
        given = [Placed.new(column, count + i) for i, column in enumerate(columns, 1)]
        made = [_unset(array.size, count, count + i) for i, array in enumerate(self.row.results, len(given) + 1)]
        taken, left = ([item for a in arrays for item in (a.pointer, a.stride)] for arrays in (given, made))
        self.unit.call(f"{self.name}_rows", count, *taken, *self.branch, *left)
        return [tuple(c for part in parts for c in part) for parts in zip(*(a.rows for a in made), strict=True)]

    def _one(self, given: Sequence[Placed], results: Sequence[Placed]) -> Flat:
        pointers = [array.pointer for array in given]
        self.unit.call(self.name, *pointers, *self.branch, *(array.pointer for array in results))
        return tuple(c for array in results for c in array.rows[0])


def _unset(size: int, count: int = 1, stride: int = 1) -> Placed:
    return Placed.new([(UNSET,) * size] * count, stride)


def _consecutive(cells: list[Any], start: int, sizes: Sequence[int]) -> list[Placed]:
    placed = []
    for size in sizes:
        placed.append(Placed(Pointer(cells, start, 0, len(cells)), size))
        start += size
    return placed


def _values(kernel: Kernel, batch: Batch) -> int:
    """Compare both forms of a function with its expected values."""
    for case in batch.cases:
        _compare(kernel.name, kernel.plain(case.arguments), case.result, batch.agree)
    for row, case in zip(kernel.rows([case.arguments for case in batch.cases]), batch.cases, strict=True):
        _compare(f"{kernel.name}, rows", row, case.result, batch.agree)
    return len(batch.cases) + 1


def _layouts(kernel: Kernel, chart: Chart, arguments: Sequence[Flat]) -> int:
    """Lay results over arguments, and choose branches by other integers: not a bit of the plain result may change."""
    expected = kernel.plain(arguments)
    room = sum(array.size for array in (*kernel.row.arguments, *kernel.row.results))
    for start in range(room):
        _compare(f"{kernel.name}, overlapping", kernel.overlapping(arguments, start), expected, same)
    turned = [branch + turns * chart.branches for branch in kernel.branch for turns in (-1, 2)]
    for branch in turned:
        other = Kernel(kernel.unit, kernel.prefix, kernel.row, (branch,))
        for row in (other.plain(arguments), *other.rows([arguments])):
            _compare(f"{kernel.name}, branch {branch}", row, expected, same)
    return room + 2 * len(turned)


def _arguments(batch: Batch) -> Sequence[Flat]:
    """Return arguments of 50 digits for the layouts of a function: the last of its cases, or seeded ones."""
    if not batch.exact:
        return batch.cases[-1].arguments
    draw = random.Random(SEED)
    sizes = [array.size for array in batch.row.arguments]
    return [tuple(Decimal(mpmath.mpf(draw.uniform(-0.5, 0.5))) for _ in range(size)) for size in sizes]


def _require_aliases(unit: Unit, chart: Chart, table: Table) -> None:
    """Compare further names of functions."""
    begin, named = prefix(chart, table), table.aliases(chart).items()
    _require_macros(unit, {f"{begin}_{a}{form}": f"{begin}_{b}{form}" for a, b in named for form in ("", "_rows")})


def _require_macros(unit: Unit, expected: Mapping[str, str]) -> None:
    for name, text in expected.items():
        if unit.source.expand(name) != text:
            raise ValidationFailed(f"{name} is {unit.source.expand(name)}, not {text}")


def _require_constants(unit: Unit, chart: Chart) -> None:
    """Compare the macros of a chart and its singular angles."""
    begin, count = prefix(chart, POSES), len(chart.singular_angles)
    _require_macros(unit, {f"{begin.upper()}_ORDER": str(chart.order), f"{begin.upper()}_SINGULAR_ANGLES": str(count)})
    angles = [UNSET] * count
    if unit.call(f"{begin}_singular_angles", Pointer.to(angles)) != count:
        raise ValidationFailed(f"singular_angles does not return {count}")
    with mpmath.workdps(decimals.DIGITS):
        wanted = [mpmath.mpf(angle.evalf(decimals.DIGITS + 5)) for angle in chart.singular_angles]
        _compare("singular_angles", angles, wanted, partial(decimals.close, tolerance=decimals.tolerance(chart)))


def _compare(where: str, found: Sequence[Any], expected: Sequence[Any], agree: Any) -> None:
    for index, (got, wanted) in enumerate(zip(found, expected, strict=True)):
        if not agree(got, wanted):
            raise ValidationFailed(f"{where}, component {index}: {got} is not {wanted}")
