"""Execute a C header as text: every function on exact elements and at 50 digits, in all the ways it may be called."""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import mpmath

from ...maps.chart import Chart
from ..cases import Batch, batches, decimals
from ..cases.batches import Agree, same
from ..cases.decimals import Decimal
from ..rows import Table, inside
from ..signatures import POSES
from .c_calls import Flat, Kernel
from .c_interpreter import UNSET, CError, Pointer, Unit, load
from .errors import ValidationFailed

SEED = 1863


def validate(folder: Path, chart: Chart, tables: Sequence[Table] = (POSES,)) -> int:
    """Interpret the headers of a chart, one for each table; return how many calls equal the formula.

    Both forms are called: the rational functions on symbols, the others on numbers of 50 digits. On such numbers
    results are then laid over arguments, at every distance and row by row, and must not change by a bit.

    Raises
    ------
    ValidationFailed
        Naming the function, or the line that is no C, divides integers, leaves an array, reads what was not written.
    """
    headers = [inside(table, f"{chart.name}.h") for table in tables]
    try:
        unit = load("".join(f'#include "{header}"\n' for header in headers), folder)
        _constants(unit, chart)
        for table in tables:
            _aliases(unit, chart, table)
        calls = sum(check(unit, chart, batches(chart, table), table) for table in tables)
        if unit.idle:
            raise ValidationFailed(f"nothing calls {', '.join(unit.idle)}, so nothing says what they compute")
    except (CError, ValidationFailed) as error:
        raise ValidationFailed(f"{', '.join(headers)}: {error}") from error
    return calls


def check(unit: Unit, chart: Chart, given: Sequence[Batch], table: Table = POSES) -> int:
    """Compare all forms of the functions with what they must return; how many calls that takes."""

    def kernel(batch: Batch) -> Kernel:
        """The function of a batch, with its branch; branch 0 where none is given."""
        default = (0,) if batch.row.branch else ()
        return Kernel(unit, prefix(chart, table), batch.row, batch.branch or default)

    with mpmath.workdps(decimals.DIGITS):
        return sum(_values(kernel(batch), batch) for batch in given) + sum(
            _layouts(kernel(batch), chart, rows) for batch, rows in _samples(given)
        )


def prefix(chart: Chart, table: Table) -> str:
    """What the names of functions begin with, before a further underscore."""
    return "_".join(filter(None, ("dualcay", table.name, chart.name)))


def _values(kernel: Kernel, batch: Batch) -> int:
    """Compare both forms of a function with what it must return."""
    for case in batch.cases:
        _compare(kernel.name, kernel.plain(case.arguments), case.result, batch.agree)
    for row, case in zip(kernel.rows([case.arguments for case in batch.cases]), batch.cases, strict=True):
        _compare(f"{kernel.name}, rows", row, case.result, batch.agree)
    return len(batch.cases) + 1


def _layouts(kernel: Kernel, chart: Chart, rows: Sequence[tuple[Flat, ...]]) -> int:
    """Lay results over arguments, and choose branches by other integers: not a bit of the plain result may change."""
    expected = [kernel.plain(arguments) for arguments in rows]
    room = sum(array.size for array in (*kernel.row.arguments, *kernel.row.results))
    for start in range(room):
        _compare(f"{kernel.name}, overlapping", kernel.shared(rows[-1], start), expected[-1], same)
    ways = (None, *range(len(rows[0])))
    for over in ways:
        for row, result in zip(kernel.rows(rows, over), expected, strict=True):
            _compare(f"{kernel.name}, rows over argument {over}", row, result, same)
    turned = [branch + turns * chart.branches for branch in kernel.branch for turns in (-1, 2)]
    for branch in turned:
        other = replace(kernel, branch=(branch,))
        for row, result in zip((other.plain(rows[0]), *other.rows(rows)), (expected[0], *expected), strict=True):
            _compare(f"{kernel.name}, branch {branch}", row, result, same)
    return room + len(ways) + 2 * len(turned)


def _samples(given: Sequence[Batch]) -> Iterator[tuple[Batch, list[tuple[Flat, ...]]]]:
    """Three arguments of 50 digits for every function: seeded ones of two branches, any for a rational function.

    The first and the last of `principal` lie on either side of its selection; the last is laid over results.
    """
    closely = [batch for batch in given if not batch.exact]
    for batch in closely:
        if batch.branch in ((), (0,), (1,)):
            cases = batch.cases
            yield batch, [case.arguments for case in (cases[0], cases[len(cases) // 2], cases[-1])]
    seen = {(batch.function, batch.branch) for batch in closely}
    draw = random.Random(SEED)
    for batch in given:
        if batch.exact and (batch.function, batch.branch) not in seen:
            sizes = [array.size for array in batch.row.arguments]
            yield batch, [tuple(_drawn(draw, size) for size in sizes) for _ in range(3)]


def _drawn(draw: random.Random, size: int) -> Flat:
    return tuple(Decimal(mpmath.mpf(draw.uniform(-0.5, 0.5))) for _ in range(size))


def _aliases(unit: Unit, chart: Chart, table: Table) -> None:
    """Further names of functions."""
    begin, named = prefix(chart, table), table.aliases(chart).items()
    _macros(unit, {f"{begin}_{a}{form}": f"{begin}_{b}{form}" for a, b in named for form in ("", "_rows")})


def _macros(unit: Unit, expected: Mapping[str, str]) -> None:
    for name, text in expected.items():
        if unit.source.expand(name) != text:
            raise ValidationFailed(f"{name} is {unit.source.expand(name)}, not {text}")


def _constants(unit: Unit, chart: Chart) -> None:
    """What the macros of a chart stand for, and its singular angles."""
    begin, count = prefix(chart, POSES), len(chart.singular_angles)
    _macros(unit, {f"{begin.upper()}_ORDER": str(chart.order), f"{begin.upper()}_SINGULAR_ANGLES": str(count)})
    angles = [UNSET] * count
    if unit.call(f"{begin}_singular_angles", Pointer.to(angles)) != count:
        raise ValidationFailed(f"singular_angles does not return {count}")
    with mpmath.workdps(decimals.DIGITS):
        wanted = [mpmath.mpf(angle.evalf(decimals.DIGITS + 5)) for angle in chart.singular_angles]
        _compare("singular_angles", angles, wanted, partial(decimals.close, tolerance=decimals.tolerance(chart)))


def _compare(where: str, found: Sequence[Any], expected: Sequence[Any], agree: Agree) -> None:
    for index, (got, wanted) in enumerate(zip(found, expected, strict=True)):
        if not agree(got, wanted):
            raise ValidationFailed(f"{where}, component {index}: {got} is not {wanted}")
