"""Cases for every function of a chart in all languages, and the results of the C headers, to the bit."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from derive.codegen.build import print_package
from derive.codegen.catalogue import charts as catalogue
from derive.codegen.rows import Function, inside
from derive.codegen.signatures import POSES, ROTATIONS, Table
from derive.codegen.targets import TARGETS
from derive.codegen.validation.c_text import prefix
from derive.codegen.validation.float_cases import cases as seeded
from derive.codegen.validation.float_cases import composed
from derive.maps.chart import Chart
from derive.output import files
from tests.support import compilers

TABLES = {table.name: table for table in (POSES, ROTATIONS)}
SCALES = (1.0, 1e-9, 30.0, 1e-160, 1e160, 0.0)
"""Factors of the seeded arguments: 1, small and large ones, those with squares that are 0 or infinite, and 0."""
SPECIAL = (np.nan, np.inf)
"""Numbers of further rows, in their first component."""


@dataclass(frozen=True)
class Case:
    """Function with rows of arguments and a branch; arrays have a row for each call."""

    table: str
    chart: str
    function: str
    arguments: tuple[np.ndarray, ...]
    branch: int

    @property
    def row(self) -> Function:
        return functions(TABLES[self.table])[self.function]

    @property
    def size(self) -> int:
        """Number of components of all results."""
        return sum(array.size for array in self.row.results)

    def given(self, dtype: Any = np.float64) -> np.ndarray:
        """Return the arguments side by side; large numbers may be infinite in a narrower type."""
        with np.errstate(over="ignore"):
            return np.concatenate(self.arguments, axis=1).astype(dtype)

    def __str__(self) -> str:
        return " ".join(filter(None, (self.table, self.chart, self.function, f"branch {self.branch}")))


def functions(table: Table) -> dict[str, Function]:
    return table.all_public


def chart(name: str) -> Chart:
    order = name.removeprefix("cayley")
    (found,) = catalogue([int(order)], (), None, None) if order != name else catalogue((), [name], None, None)
    return found


def write(target: str, names: Sequence[str], folder: Path) -> Path:
    """Write the kernels of charts without their own tests."""
    files.write(folder, print_package(list(map(chart, names)), TARGETS[target], tested=False).texts)
    return folder


@cache
def cases(name: str) -> tuple[Case, ...]:
    """Return cases of all functions of a chart: seeded arguments of each branch, and multiples of them."""
    return tuple(case for table in TABLES.values() for case in _of_table(chart(name), table))


def _of_table(chart: Chart, table: Table) -> Iterator[Case]:
    given: dict[tuple[str, int], list[Any]] = {}
    for case in (*seeded(chart, table), *composed(chart, table)):
        given.setdefault((case.function, case.branch or 0), []).append(case.arguments)
    for (function, branch), rows in given.items():
        arrays = [np.array([[float(c) for c in row[i]] for row in rows]) for i in range(len(rows[0]))]
        marked = [np.full_like(array[:1], number) if not i else array[:1]
                  for number in SPECIAL for i, array in enumerate(arrays)]  # fmt: skip
        scaled = ([scale * array for scale in SCALES] for array in arrays)
        columns = (np.concatenate(parts + marked[i :: len(arrays)]) for i, parts in enumerate(scaled))
        yield Case(table.name, chart.name, function, tuple(columns), branch)


def expected(case: Case, library: ctypes.CDLL, dtype: Any = np.float64) -> list[np.ndarray]:
    """Return the results of the C header for each row."""
    given = case.given(dtype)
    made = np.empty((len(given), case.size), dtype)
    function = getattr(library, f"{prefix(chart(case.chart), TABLES[case.table])}_{case.function}_all")
    function(len(given), *(array.ctypes.data_as(ctypes.c_void_p) for array in (given, made)), case.branch)
    return parted(case, made)


def parted(case: Case, made: np.ndarray) -> list[np.ndarray]:
    """Return the results one by one."""
    ends = np.cumsum([array.size for array in case.row.results])
    return np.split(made, ends[:-1], axis=1)


def reference(folder: Path, names: Sequence[str], real: str = "double") -> ctypes.CDLL:
    """Compile the C headers of charts, without fused operations, to a library with a function for rows of numbers."""
    write("c", names, folder)
    lines = [f"#define DUALCAY_REAL {real}", "#define ROW(made, given) (given), (made)"]
    for name in names:
        for table in TABLES.values():
            lines.append(f'#include "{inside(table, f"{name}.h")}"')
            lines += [_wrapper(prefix(chart(name), table), row, real) for row in functions(table).values()]
    source, library = folder / "all.c", folder / f"{real}.so"
    source.write_text("\n".join(lines), encoding="utf-8")
    command = [str(compilers.find()), "-std=c99", "-O0", "-ffp-contract=off", "-shared", "-fPIC", f"-I{folder}",
               str(source), "-o", str(library), "-lm"]  # fmt: skip
    subprocess.run(command, check=True)
    return ctypes.CDLL(str(library))


def _wrapper(prefix: str, row: Function, real: str) -> str:
    def places(arrays: Sequence[Any], source: str) -> list[str]:
        starts = np.cumsum([0, *(array.size for array in arrays)])
        return [f"{source}[{at}]" if a.size == 1 and source == "a" else f"{source} + {at}"
                for a, at in zip(arrays, starts)]  # fmt: skip

    passed = ", ".join([*places(row.arguments, "a"), *["k"] * row.branch, *places(row.results, "r")])
    given, made = (sum(array.size for array in arrays) for arrays in (row.arguments, row.results))
    return (
        f"void {prefix}_{row.name}_all(int n, const {real} *a, {real} *r, int k) "
        f"{{ (void)k; for (int i = 0; i < n; ++i, a += {given}, r += {made}) {prefix}_{row.name}({passed}); }}"
    )


def differing(found: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Return whether numbers have other bits; all numbers that are NaN count as equal."""
    kind = np.uint64 if wanted.dtype == np.float64 else np.uint32
    return (found.view(kind) != wanted.view(kind)) & ~(np.isnan(found) & np.isnan(wanted))
