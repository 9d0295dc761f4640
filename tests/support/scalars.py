"""Programs in C++ that call the templates on numbers of a class, function by function."""

from __future__ import annotations

import itertools
import shutil
import subprocess
from collections.abc import Iterable, Sequence
from pathlib import Path

from derive.codegen.rows import Function, Table, inside
from derive.codegen.targets import TARGETS
from derive.codegen.validation.c_text import prefix
from derive.maps.chart import Chart

SOURCES = Path(__file__).parents[1] / "targets"
TABLES = TARGETS["c"].tables
COMPILERS = [name for name in ("g++", "clang++") if shutil.which(name)] or ["g++"]
STRICT = ("-std=c++11", "-O0", "-Wall", "-Wextra", "-Wshadow", "-pedantic", "-Werror", "-DDUALCAY_TEMPLATES")

Called = tuple[Chart, Table, Function]


def includes(charts: Iterable[Chart]) -> str:
    """Return the lines that include both headers of each chart."""
    return "".join(f'#include "{inside(table, f"{chart.name}.h")}"\n' for chart in charts for table in TABLES)


def functions(table: Table) -> dict[str, Function]:
    """Return the functions of a table in C, by name."""
    return table.all_public


def cases(called: Sequence[Called]) -> str:
    """Return the cases of a switch: each reads the arguments of a function, calls it, and shows the results."""
    return "\n".join(f"case {index}: {_case(*each)} break;" for index, each in enumerate(called))


def _case(chart: Chart, table: Table, row: Function) -> str:
    ends = [list(itertools.accumulate((a.size for a in arrays), initial=0)) for arrays in (row.arguments, row.results)]
    given = [f"given[{at}]" if a.size == 1 else f"given + {at}" for a, at in zip(row.arguments, ends[0])]
    passed = ", ".join([*given, *["branch"] * row.branch, *(f"made + {at}" for at in ends[1][:-1])])
    return f"read(given, {ends[0][-1]}); {prefix(chart, table)}_{row.name}({passed}); show(made, {ends[1][-1]});"


def built(compiler: str, source: Path, headers: Path, program: Path, *flags: str) -> Path:
    """Compile a program without a warning."""
    command = [compiler, *STRICT, f"-I{headers}", f"-I{SOURCES}", str(source), "-o", str(program), *flags]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return program


def answers(program: Path, lines: Iterable[str]) -> list[list[str]]:
    """Return what a program answers to each line."""
    given = "".join(f"{line}\n" for line in lines)
    said = subprocess.run([str(program)], input=given, capture_output=True, text=True, check=True).stdout
    return [line.split() for line in said.splitlines()]
