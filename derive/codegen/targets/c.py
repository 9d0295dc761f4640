"""C: headers for C99 and C++, straight-line code that compilers make vector code of.

``geometry.h`` holds what all charts share and is read once for each: a chart defines its scalars, says in macros what
geometry cannot know, and includes it. Macros are the chart's name in every name (``DUALCAY_NAME``), its branches, what
its functions call of ``math.h``, and the functions that are its own.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from ...maps.cayley import EQUATIONS
from ...maps.chart import Chart
from .. import differential
from ..facts import Facts, comment, numbers, theorem_lines
from ..lowered import Lowered, geometry
from ..lowering.scalars import SCALARS, table_names
from ..programs.program import Program
from ..rows import Array, Function
from ..signatures import POSES, PUBLIC
from ..validation import Choose, c_text, compiled, everything
from . import c99
from .target import Data, require_functions

GEOMETRY = "geometry.h"
LEVELS = {"abs": 1, "sqrt": 1, "tan": 2, "atan2": 2}
"""What an operation needs of ``math.h``: nothing is 0, what becomes vector code 1, what does not 2."""

NAMES = {"R": "tensor", "T": "pose"}
"""Names of arrays here: capital letters are where other people's macros are."""

IDLE: Mapping[str, Program] = {
    name: Program(name, tuple((a, (a,)) for a in SCALARS[name].arguments if a != "table"), (), outputs)
    for name, outputs in (("beyond", (0, 1, 0)), ("direction", (1,)), ("turned", (0, 0)), ("rate", (1, 0)))
}
"""What stands for scalars that geometry names and a chart never comes to."""


@dataclass(frozen=True, slots=True)
class Form:
    """A form of a public function: its parameters, and what it passes to the core."""

    parameters: str
    passed: str


@dataclass(frozen=True, slots=True)
class Interface:
    """A public function: its name, that of its core, and its two forms."""

    name: str
    kernel: str
    plain: Form
    rows: Form


def interface(row: Function) -> Interface:
    """The forms of a row of the table."""
    given, made = ([_named(array) for array in arrays] for arrays in (row.arguments, row.results))
    branch = ["int branch"] if row.branch else []
    table = [*map(_number, row.constants)] or _components(geometry()[row.kernel], c99.TABLE)
    plain = [f"const {c99.REAL} {a.name}[{a.size}]" for a in given], [f"{c99.REAL} {a.name}[{a.size}]" for a in made]
    rows = (
        [f"const {c99.REAL} *{a.name}, size_t {a.name}_stride" for a in given],
        [f"{c99.REAL} *{a.name}, size_t {a.name}_stride" for a in made],
    )
    ones, strides = (
        c99.filled([*(form.format(a.name) for a in given), *table, *(form.format(a.name) for a in made)])
        for form in ("{0}, 1", "{0} + j, {0}_stride")
    )
    return Interface(
        row.name,
        row.kernel,
        Form(", ".join([*plain[0], *branch, *plain[1]]), ones),
        Form(c99.filled(["size_t n", *rows[0], *branch, *rows[1]]), strides),
    )


def _named(array: Array) -> Array:
    return array.called(NAMES.get(array.name, array.name))


def _number(decimal: str) -> str:
    return f"DUALCAY_NUMBER({decimal})" if "." in decimal else c99.real(decimal)


def _components(program: Program, argument: str) -> tuple[str, ...]:
    return next((names for found, names in program.inputs if found == argument), ())


def level(program: Program) -> int:
    """What a program needs of ``math.h``, calls not looked into."""
    return max((LEVELS.get(op, 0) for op in program.operations), default=0)


def levels(lowered: Lowered) -> dict[str, int]:
    """What every kernel function of a chart needs of ``math.h``, with the scalars that it calls."""
    found = {}
    for name, shared in geometry().items():
        program = lowered.own.get(name, shared)
        called = [lowered.scalars[call.function] for call in program.calls if call.function in lowered.scalars]
        found[name] = max(map(level, [program, *called]))
    return found


class C:
    """The target of headers."""

    name = "c"
    extension = "h"
    entry = "dualcay.h"
    comment = "//"
    tables = (POSES,)
    unproved = "rounding errors; the compiler, which is tested; code for other compilers or types behind #if"

    def shared(self) -> Mapping[str, Data]:
        return {
            "dualcay.h": {},
            GEOMETRY: {
                "theorems": comment(theorem_lines(), self.comment),
                "equations": {name: numbers(found) for name, found in EQUATIONS.items()},
                "cores": {name: c99.core(program, {}) for name, program in geometry().items()},
                "functions": {name: interface(row) for name, row in PUBLIC.items()},
            },
            "differential.h": {},
            "CMakeLists.txt": {},
        }

    def module(self, facts: Facts) -> Data:
        chart, lowered = facts.chart, facts.lowered
        table = dict(zip(table_names(chart), itertools.chain(*facts.returns), strict=True))
        shared = (program for name, program in geometry().items() if name not in lowered.own)
        named = {call.function for program in shared for call in program.calls}
        scalars = [*lowered.scalars.values(), *(IDLE[name] for name in sorted(named - lowered.scalars.keys()))]
        return {
            "name": chart.name,
            "macro": f"DUALCAY_{chart.name.upper()}",
            "order": chart.order,
            "branches": chart.branches,
            "domain": facts.domain,
            "singular": facts.singular,
            "singular_angles": facts.singular_angles,
            "aliases": POSES.aliases(chart),
            "levels": levels(lowered),
            "scalars": [(level(program), c99.scalar(program, table)) for program in scalars],
            "own": [(level(program), c99.core(program, table)) for program in lowered.own.values()],
            "turns": facts.turns,
        }

    def companions(self, facts: Facts) -> Mapping[str, tuple[str, Data]]:
        chart = facts.chart
        data = {"name": chart.name, "gate": differential.GATE, "functions": list(differential.tables(chart))}
        return {f"test_{chart.name}.c": ("test_chart.c", data)}

    def require_complete(self, texts: Mapping[str, str]) -> None:
        """Both forms of every public function stand in the geometry, and no other."""
        found = re.findall(r"^DUALCAY_FUNCTION void DUALCAY_NAME\((\w+)\)\(", texts[GEOMETRY], re.MULTILINE)
        plain, rows = ([name for name in found if name.endswith("_rows") == is_rows] for is_rows in (False, True))
        require_functions(GEOMETRY, plain, POSES)
        require_functions(f"{GEOMETRY}, rows", [name.removesuffix("_rows") for name in rows], POSES)

    def validate(self, folder: Path, chart: Chart, choose: Choose = everything) -> int:
        """All of it: a header is read anew for each chart, geometry included."""
        return c_text.validate(folder, chart)

    def replay(self, folder: Path, chart: Chart, all_ways: bool) -> int:
        """Floats are left to the compiled test."""
        return 0

    def test(self, folder: Path, chart: Chart) -> int | None:
        return compiled.test(folder, chart)
