"""Compiled loops: geometry programs on scalars, and the loops that run them.

LLVM does not vectorize a loop with more than nine stores, so a larger result is computed in parts. Each loop stores
some results, and the compiler drops the operations of the others. Constants get the type of the arguments: beside a
bare integer, Numba computes float32 in double precision.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from ...maps.chart import Chart
from ...output import RefusedError
from ..package import Data, Facts
from ..programs.program import Call, Program
from ..rows import Function, Table
from ..signatures import geometry, printed_geometry, shared_with_poses
from . import expression
from .expression import WIDTH, Lists, items
from .python import PythonFunction, PythonTarget, formula_of

if TYPE_CHECKING:
    from ..validation.replay import Library

MOST_OUTPUTS = 9  # largest number of stores in a loop that LLVM still vectorizes
TABLE = "table"  # argument of constants, equal for all poses; for some functions only the chart knows its length
DIALECT = expression.python(prefix="", literal=lambda value: f"_m{-value}" if value < 0 else f"_{value}")


@dataclass(frozen=True, slots=True)
class Loops:
    """Texts of the loops around a function: one per part over columns of arrays, and one for a single pose."""

    row: Function
    parameters: tuple[str, ...]
    rows: tuple[str, ...]
    alone: str


def loops(row: Function, program: Program) -> Loops:
    """Return the loops of a kernel function; parts of equal size are adjacent, e.g. all rows of Q, then rho."""
    sizes = [array.parts[part] for array in row.results for part in array.part_of]
    order = sorted(range(len(sizes)), key=lambda index: sizes.index(sizes[index]))
    groups = (order[first : first + MOST_OUTPUTS] for first in range(0, len(order), MOST_OUTPUTS))
    rows = tuple(_call(program, group, "        ", ", i") for group in groups)
    parameters = tuple(argument for argument, _ in program.inputs)
    return Loops(row, parameters, rows, _call(program, range(len(sizes)), "    ", ""))


def _printed(program: Program, formula: str = "") -> PythonFunction:
    """Return a function whose arguments are tuples of components, numbers, or the table."""
    body = expression.body(program, dialect=DIALECT, alone=True, ask=_ask, first=_first(program))
    return PythonFunction(program.name, tuple(argument for argument, _ in program.inputs), body, formula)


def _ask(call: Call, arguments: str) -> str:
    if call.result:
        return f"{call.function}({arguments})"
    return f"c_{call.function}({arguments}{f', {call.rest}' if call.rest else ''})"


def _first(program: Program) -> Iterator[str]:
    """Yield the first lines of a function: typed constants and unpacked arguments."""
    for value in program.constants:
        yield f"    {DIALECT.literal(value)} = number({value}, {program.inputs[0][0]})"
    lists = Lists(program)
    for argument, names in program.inputs:
        if argument == TABLE:
            yield from (f"    {name} = {argument}[{i}]" for i, name in enumerate(names) if name in lists.read)
        elif names != (argument,):
            yield from (f"    {line}" for line in lists.unpacked(names, argument))


def _call(program: Program, group: Sequence[int], indent: str, suffix: str) -> str:
    """Return the call ``found = pose((v[0], …), …)`` over several lines, and the stores of some of its results."""
    lines = [f"{indent}found = {program.name}("]
    for argument, names in program.inputs:
        loaded = ", ".join(f"{argument}[{index}{suffix}]" for index in range(len(names)))
        components = f"({loaded},)," if len(names) == 1 else f"({loaded}),"
        text = f"{argument}," if argument == TABLE else components.replace(", i]", ",\0i]")  # never broken
        wrapped = textwrap.wrap(text, WIDTH - len(indent) - 4, break_long_words=False)
        lines += [f"{indent}    {line}".replace("\0", " ") for line in wrapped]
    stores = (f"{indent}out[{index}{suffix}] = found[{index}]" for index in group)
    return "\n".join([*lines, f"{indent})", *stores])


def _called(programs: Sequence[PythonFunction]) -> list[str]:
    text = "".join(program.forms for program in programs)
    names = ("atan2", "expm1", "log1p", "number", "reciprocal", "sqrt", "tan", "where")
    return [name for name in names if re.search(rf"\b{name}\(", text)]


class Numba(PythonTarget):
    """Target that Numba compiles, on NumPy arrays."""

    name = "numba"
    options = "axis: Axis = -1, out: Array | None = None, parallel: bool = False"
    files = (*PythonTarget.files, "_compiled.py")

    def shared(self) -> dict[str, Callable[[], Data]]:
        rows = [row for table in self.tables for _, row in sorted(table.public.items()) if row.constants]
        return super().shared() | {
            "_inside.py": partial(dict, shared={row.name: (row.kernel, row.constants) for row in rows})
        }

    def geometry(self, table: Table) -> Data:
        same = shared_with_poses(table)
        programs = [_printed(program) for name, program in printed_geometry(table).items() if name not in same]
        return {
            "programs": programs,
            "kernels": [loops(row, geometry(table)[name]) for name, row in table.kernels.items()],
            "calls": sorted(["prange", *_called(programs)]),
            "names": items([*(program.name for program in programs), *sorted(same)], " " * 8),
            "same": sorted(same),
        }

    def programs(self, facts: Facts) -> Data:
        programs = facts.lowered.poses.scalars.items()
        scalars = [_printed(program, formula_of(name, facts.chart)) for name, program in programs]
        return {"scalars": scalars, "calls": _called(scalars)}

    def validate(self, folder: Path, chart: Chart, geometry: bool) -> int:
        """Validate the printed source; raise RefusedError if an import such as the compiler's fails."""
        try:
            return super().validate(folder, chart, geometry)
        except ImportError as error:
            raise RefusedError(f"cannot validate what was printed: {error}") from error

    def libraries(self) -> Sequence[Library]:
        """Return no libraries, and so no replay: compiling all loops of a chart takes a minute."""
        return ()
