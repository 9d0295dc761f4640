"""Compiled loops: cores on scalars, of few outputs each, and the loops that run them.

A loop with more than nine stores is no longer vectorised by LLVM, so a larger result is computed in parts. Constants
are made of the type of the arguments: beside a bare integer Numba computes float32 in double precision.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from ...maps.chart import Chart
from ...output import RefusedError
from ..lowered import geometry
from ..package import Data, Facts
from ..programs.program import Call, Operand, Program, Statement, results, summary
from ..rows import Table
from ..signatures import POSES, ROTATIONS
from ..validation import Library
from . import infix, python
from .expression import WIDTH

MOST_OUTPUTS = 9
"""Stores in a loop which LLVM still vectorises."""

TABLE = "table"
"""The argument of constants, the same for every pose, of a length that for some functions only the chart knows."""

DIALECT = infix.python(prefix="", literal=lambda value: f"_m{-value}" if value < 0 else f"_{value}")


@dataclass(frozen=True, slots=True)
class Part:
    """A core of few outputs, and the texts of the loops around it."""

    name: str
    summary: str
    body: str
    row: str
    rows: str


def parts(program: Program, prefix: str = "", table: Table = POSES) -> tuple[Part, ...]:
    """The cores of a program of a geometry, each with the outputs it is for; a prefix stands before their names."""
    sizes = [array.parts[part] for array in table.kernels[program.name].results for part in array.part_of]
    return tuple(_part(program, f"{program.name}{i}", group, prefix) for i, group in enumerate(_groups(sizes), 1))


def _groups(sizes: Sequence[int]) -> list[tuple[int, ...]]:
    """Outputs by loops; those of parts of equal size stay together: of a pose the rows of Q, then those of rho."""
    order = sorted(range(len(sizes)), key=lambda index: sizes.index(sizes[index]))
    return [tuple(order[first : first + MOST_OUTPUTS]) for first in range(0, len(order), MOST_OUTPUTS)]


def _part(program: Program, name: str, group: Sequence[int], prefix: str) -> Part:
    selected = _select(program, group)
    return Part(
        name=name,
        summary=f"operations {summary(selected.operations)}",
        body=body(selected),
        row=_call(prefix + name, program, group, "    ", ""),
        rows=_call(prefix + name, program, group, "        ", ", i"),
    )


def _select(program: Program, group: Sequence[int]) -> Program:
    """The program of some of the outputs only."""
    outputs = tuple(program.outputs[index] for index in group)
    needed: set[Operand] = set(outputs)
    statements: list[Statement] = []
    for statement in reversed(program.statements):
        if needed.intersection(results(statement)):
            needed.update(statement.args)
            statements.append(_needed(statement, needed) if isinstance(statement, Call) else statement)
    return replace(program, statements=tuple(reversed(statements)), outputs=outputs)


def _needed(call: Call, needed: set[Operand]) -> Call:
    return replace(call, names=tuple(name if name in needed else "_" for name in call.names))


def body(program: Program) -> str:
    """Lines of a function whose arguments are tuples of components, numbers, or the table."""
    lines = [*_constants(program), *_unpacked(program)]
    return "\n".join([*lines, infix.body(program, dialect=DIALECT, alone=True, ask=_ask)])


def _ask(call: Call, arguments: str) -> str:
    return f"c_{call.function}({arguments}{f', {call.rest}' if call.rest else ''})"


def _constants(program: Program) -> Iterator[str]:
    argument = program.inputs[0][0]
    for value in program.constants:
        yield f"    {DIALECT.literal(value)} = number({value}, {argument})"


def _unpacked(program: Program) -> Iterator[str]:
    used = program.operands
    for argument, names in program.inputs:
        if argument == TABLE:
            yield from (f"    {name} = {argument}[{i}]" for i, name in enumerate(names) if name in used)
        elif names != (argument,):
            yield "    " + infix.unpacked([name if name in used else "_" for name in names], argument)


def _call(name: str, program: Program, group: Sequence[int], indent: str, suffix: str) -> str:
    """``(out[0], out[1], …) = pose1((v[0], …), …)``, over several lines."""
    stored = ", ".join(f"out[{index}{suffix}]" for index in group) + "," * (len(group) == 1)
    lines = [f"{indent}(", *_wrapped(stored, indent), f"{indent}) = {name}("]
    for argument, names in program.inputs:
        loaded = ", ".join(f"{argument}[{index}{suffix}]" for index in range(len(names)))
        components = f"({loaded},)," if len(names) == 1 else f"({loaded}),"
        lines += _wrapped(f"{argument}," if argument == TABLE else components, indent)
    return "\n".join([*lines, f"{indent})"])


def _wrapped(text: str, indent: str) -> list[str]:
    # an index and its comma stay together
    joined = text.replace(", i]", ",\0i]")
    lines = textwrap.wrap(joined, WIDTH - len(indent) - 4, break_long_words=False)
    return [f"{indent}    {line}".replace("\0", " ") for line in lines]


def _called(texts: Iterable[str]) -> list[str]:
    """The functions of ``_compiled`` in some texts."""
    text = "".join(texts)
    names = ("atan2", "expm1", "log1p", "number", "sqrt", "tan", "where")
    return [name for name in names if re.search(rf"\b{name}\(", text)]


def _cores(printed: Iterable[python.Printed]) -> list[str]:
    return [part.body for program in printed for part in program.forms]


def _shared(table: Table) -> dict[str, tuple[str, tuple[str, ...]]]:
    """Functions that run a kernel with constants of their own, and these."""
    return {name: (row.kernel, row.constants) for name, row in sorted(table.public.items()) if row.constants}


WORDS = python.Words(
    options="*, axis: int = -1, out: Array | None = None, parallel: bool = False",
    passed="axis, out, parallel",
    passed_alone="axis, None, False",
    placed="axis, out",
    makes=True,
)


class Numba(python.PythonTarget):
    """The target that Numba compiles, on NumPy arrays."""

    name = "numba"
    words = WORDS
    tables = (POSES, ROTATIONS)
    unproved = "what Numba and LLVM make of the source, with typed constants and selections; rounding errors"

    def shared(self) -> Mapping[str, Data]:
        return {
            **self.package(),
            **self.per_table(),
            "_branches.py": {},
            "_chart.py": {},
            "_checks.py": {},
            "_compiled.py": {},
            "_inside.py": {"shared": {name: found for table in self.tables for name, found in _shared(table).items()}},
            "_runtime.py": {},
            "_tools.py": {},
        }

    def geometry(self, table: Table) -> Data:
        programs = [python.printed(program, parts(program, table=table)) for program in geometry(table).values()]
        calls = sorted(["prange", *_called(_cores(programs))])
        return {"programs": programs, "rows": table.kernels, "calls": calls}

    def programs(self, facts: Facts) -> Data:
        scalars = [python.printed(program, body(program)) for program in facts.lowered.scalars.values()]
        return {"scalars": scalars, "calls": _called([program.forms for program in scalars])}

    def validate(self, folder: Path, chart: Chart, geometry: bool) -> int:
        """Run the source of a package which wants its compiler even so."""
        try:
            return super().validate(folder, chart, geometry)
        except ImportError as error:
            raise RefusedError(f"cannot validate what was printed: {error}") from error

    def libraries(self) -> Sequence[Library]:
        """None while a package is made: to compile every loop takes a minute for a chart."""
        return ()
