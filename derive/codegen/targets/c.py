"""C: headers for C99 and C++, with straight-line code that compilers can vectorize.

``geometry.h`` holds the shared functions and is included once per chart, after the chart's scalars and macros. Macros
put the chart's name into names of functions (``DUALCAY_NAME``) and scalars (``DUALCAY_CHART``). Other macros give its
branches and the functions of ``math.h`` that it needs. Rotations have a geometry in a folder of their own; a chart's
header there uses the scalars of the chart's header for poses.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from ... import about
from ...maps.chart import Chart
from ..descriptions import sections
from ..lowering.scalar_programs import SCALARS, table_names
from ..package import Data, Facts, Target
from ..programs.program import Program
from ..rows import Array, Function, Table, inside
from ..signatures import POSES, ROTATIONS, TABLE, ChartPrograms, geometry, printed_geometry, way
from ..validation import c_text, compiled
from ..validation.calls import require_calls
from ..validation.float_cases import FloatCase, cases, composed
from . import c99

GEOMETRY = "geometry.h"
LEVELS = {"abs": 1, "sqrt": 1, "tan": 2, "atan2": 2, "expm1": 2, "log1p": 2}
"""Level of ``math.h`` that an operation needs: 0 no function, 1 functions that compilers vectorize, 2 all others."""

NAMES = {"R": "tensor", "T": "pose"}
"""Replacements of array names in capital letters, which may collide with macros of other libraries."""

GATE = 8  # largest error in a differential test, in machine epsilons times the scale of the result


def interface(row: Function, table: Table) -> Data:
    """Return the parameters of both forms of a function, and the arguments that they pass to its core."""
    given, made = ([a.called(NAMES.get(a.name, a.name)) for a in arrays] for arrays in (row.arguments, row.results))
    numbers = next((names for argument, names in programs(table)[row.kernel].inputs if argument == TABLE), ())
    constants = [f"DUALCAY_NUMBER({c if '.' in c else f'{c}.0'})" for c in row.constants] or numbers
    branch = ["int branch"] if row.branch else []
    runs = way(row, table)

    def form(parameters: str, place: Callable[[Array], str]) -> Data:
        read, stored = (
            {array.name: f"DUALCAY_{way}({array.size}, {place(array)})" for array in (*given, *made)}
            for way in ("GIVEN", "MADE")
        )
        passed = [*(read[a.name] for a in given), *constants, *(stored[a.name] for a in made)]
        return {"parameters": parameters, "passed": c99.filled(passed), "given": read, "made": stored}

    plain = [f"{c99.REAL} {a.name}" if a.size == 1 else f"const {c99.REAL} {a.name}[{a.size}]" for a in given]
    plain += [*branch, *(f"{c99.REAL} {a.name}[{a.size}]" for a in made)]
    rows = [f"const {c99.REAL} *{a.name}, size_t {a.name}_stride" for a in given]
    rows += [*branch, *(f"{c99.REAL} *{a.name}, size_t {a.name}_stride" for a in made)]
    return {
        "name": row.name,
        "kernel": row.kernel,
        "way": runs,
        "result": made[0].name,
        "plain": form(", ".join(plain), lambda a: f"{'&' if a.size == 1 and a in given else ''}{a.name}, 1"),
        "rows": form(c99.filled(["size_t n", *rows]), lambda a: f"{a.name} + j, {a.name}_stride"),
    }


def programs(table: Table) -> Mapping[str, Program]:
    """Return the geometry programs of a table in print order; functions that Python composes follow."""
    return {**printed_geometry(table), **{name: row.traced() for name, row in table.composed.items()}}


def copy_of(table: Table) -> Program:
    """Return the program that returns v itself."""
    (v,) = table.sources["shadow"].arguments
    names = tuple(f"{v.name}{place}" for place in range(1, v.size + 1))
    return Program("copy", ((v.name, names),), (), names)


def level(program: Program) -> int:
    """Return a program's level of ``math.h``, its scalar programs left out."""
    own = (LEVELS.get(op, 0) for op in program.operations)
    return max((*own, *map(level, program.called)), default=0)


def levels(chart: ChartPrograms) -> dict[str, int]:
    """Return the level of ``math.h`` that every geometry program of a chart needs, including its scalars."""
    found: dict[str, int] = {}
    for name, program in programs(chart.table).items():
        scalars = (chart.scalars[call.function] for call in program.calls if call.function in chart.scalars)
        called = (found[other.name] for other in program.called)
        found[name] = max((level(program), *map(level, scalars), *called))
    for name in ("shadow", "principal"):  # of no turn
        found[name] = max(found[name], found["stay"])
    return found


def scalars(chart: ChartPrograms) -> Mapping[str, Program]:
    named = {call.function for program in geometry(chart.table).values() for call in program.calls}
    return {**chart.scalars, **{name: SCALARS[name].placeholder(name) for name in sorted(named - chart.scalars.keys())}}


def shared_geometry(table: Table) -> Data:
    """Return the data for the template of a table's geometry."""
    (v,) = table.sources["shadow"].arguments
    return {
        "copy": c99.core(copy_of(table), [v.called("to")], {}),
        "cores": [c99.core(program, _made(program, table), {}) for program in programs(table).values()],
        "functions": {name: interface(row, table) for name, row in table.all_public.items()},
        "sections": sections(table),
    }


def _made(program: Program, table: Table) -> tuple[Array, ...]:
    """Return the arrays of a geometry program's results: one for each result of a function, or one list."""
    count = len(program.outputs)
    made = (Array("made", (count,), (0,) * count),)
    row = {**table.kernels, **table.composed}.get(program.name)
    return row.results if row else made


def own_geometry(facts: Facts, programs: ChartPrograms, known: Mapping[str, Program]) -> Data:
    """Return the data for the template of a chart's header, without scalars that are already ``known``."""
    chart = facts.chart
    prefix = c_text.prefix(chart, programs.table)
    decimals = dict(zip(table_names(chart), itertools.chain(*facts.returns), strict=True))
    new = [program for name, program in scalars(programs).items() if name not in known]
    return {
        "name": chart.name,
        "prefix": prefix,
        "macro": prefix.upper(),
        "branches": chart.branches,
        "ends": chart.ends,
        "singular": facts.singular,
        "aliases": programs.table.aliases(chart),
        "levels": levels(programs),
        "scalars": [(level(program), c99.scalar(program, decimals)) for program in new],
    }


class C(Target):
    """Target of C and C++ headers."""

    name = "c"
    extension = "h"
    entry = "dualcay.h"
    comment = "//"

    def shared(self) -> Mapping[str, Callable[[], Data]]:
        return {
            "dualcay.h": dict,
            **{inside(table, GEOMETRY): partial(shared_geometry, table) for table in self.tables},
            "differential.h": dict,
            "CMakeLists.txt": partial(dict, version=about.__version__, folders=[t.name or "." for t in self.tables]),
        }

    def module(self, facts: Facts) -> Data:
        found = {name: getattr(facts, name) for name in ("domain", "singular_angles", "turns")}
        return {**own_geometry(facts, facts.lowered.poses, {}), **found, "order": facts.chart.order}

    def companions(self, facts: Facts) -> dict[str, tuple[str, Data]]:
        data = own_geometry(facts, facts.lowered.rotations, scalars(facts.lowered.poses))
        return {inside(ROTATIONS, f"{facts.chart.name}.h"): (inside(ROTATIONS, "chart.h"), data)}

    def tests(self, facts: Facts) -> dict[str, tuple[str, Data]]:
        chart = facts.chart
        tested = [(c_text.prefix(chart, table), [*differential_tables(chart, table)]) for table in self.tables]
        headers = [inside(table, f"{chart.name}.h") for table in self.tables]
        test = {"name": chart.name, "gate": GATE, "headers": headers, "tested": tested}
        return {f"test_{chart.name}.c": ("test_chart.c", test)}

    def require_complete(self, texts: Mapping[str, str]) -> None:
        """Require calls and, in the geometry of its table, both forms of every public function, and no other."""
        for table in self.tables:
            require_calls(table)
            where = inside(table, GEOMETRY)
            found = re.findall(r"^DUALCAY_FUNCTION void DUALCAY_NAME\((\w+?)(_rows)?\)\(", texts[where], re.MULTILINE)
            table.require_complete(where, [name for name, rows in found if not rows], table.composed)
            table.require_complete(f"{where}, rows", [name for name, rows in found if rows], table.composed)

    def validate(self, folder: Path, chart: Chart, geometry: bool) -> int:
        return c_text.validate(folder, chart, geometry, self.tables)

    def test(self, folder: Path, chart: Chart) -> int | None:
        return compiled.test(folder, chart)


class Values(NamedTuple):
    """Values of an array for each case in C notation; for a result, the scales of its parts too."""

    array: Array
    values: list[tuple[str, ...]]
    scales: list[tuple[str, ...]]


def differential_tables(chart: Chart, table: Table = POSES) -> Iterator[Data]:
    """Yield the seeded cases of each function of a table, with their branches, if any, and exact results."""
    for name, group in itertools.groupby((*cases(chart, table), *composed(chart, table)), lambda case: case.function):
        found = list(group)
        row = found[0].row
        given = enumerate(row.arguments)
        yield {
            "name": name,
            "count": len(found),
            "arguments": [Values(array, [_hexadecimal(case.arguments[i]) for case in found], []) for i, array in given],
            "branches": [case.branch or 0 for case in found] if row.branch else [],
            "results": list(_results(row.results, found)),
        }


def _results(arrays: Sequence[Array], found: Sequence[FloatCase]) -> Iterator[Values]:
    start = scale = 0
    for array in arrays:
        end, last = start + array.size, scale + len(array.parts)
        values = [_hexadecimal(case.result[start:end]) for case in found]
        yield Values(array, values, [_hexadecimal(case.scales[scale:last]) for case in found])
        start, scale = end, last


def _hexadecimal(values: Sequence[Any]) -> tuple[str, ...]:
    return tuple(re.sub(r"\.?0*p", "p", float(value).hex()) for value in values)
