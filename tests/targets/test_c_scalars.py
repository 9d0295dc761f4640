"""C target as C++ templates: on jets and complex numbers, and in prime fields against the formulas.

A C++ compiler runs the headers in fields of 61 bits, independently of the interpreter of C. Two different rational
functions agree at a random point with probability at most degree/prime (Schwartz and Zippel). Bounds of the degrees
come from running programs and formulas on degrees.
"""

from __future__ import annotations

import importlib
import itertools
import random
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy

from derive.codegen.build import print_package
from derive.codegen.catalogue import committed
from derive.codegen.rows import Function, Table
from derive.codegen.signatures import lower_chart
from derive.codegen.targets import TARGETS
from derive.codegen.targets.c import levels
from derive.codegen.validation.c_text import prefix
from derive.codegen.validation.expected_values import ALGEBRAIC, Formulas, evaluated
from derive.maps import Cayley, family
from derive.maps.chart import Chart
from derive.output import files
from tests.support import jets
from tests.support.residues import Degree, Lifting, Residue, degree_of
from tests.support.scalars import COMPILERS, STRICT, answers, built, cases, functions, includes

HERE = Path(__file__).parent
C = TARGETS["c"]
pytestmark = pytest.mark.compiler

CHARTS = (Cayley(2), Cayley(3))
OTHERS = (family("exponential"), family("lambert"))
FORMS = ("", "_rows")
COMPLEX = "std::complex<double>"
STANDARDS = ("c++11", "c++17", "c++2b")
COMPILER = pytest.mark.parametrize(
    "compiler", [COMPILERS[0], *(pytest.param(name, marks=pytest.mark.thorough) for name in COMPILERS[1:])]
)
PRIMES = (2**61 - 1, *(sympy.nextprime(random.Random(k).randrange(2**60, 2**61 - 2**20)) for k in range(2)))
POINTS = 2
JACOBIAN_ROUNDING = 2e-11
"""Tolerance for jets beside the largest entry of the Jacobian: the same at the edges, where conditions grow to 10⁴."""


def alone(chart: Chart, tmp_path: Path, scalar: str) -> Path:
    """Write a program that compiles the functions of a chart for ``TYPE``; complex numbers have no order."""
    every = ((table, name) for table in C.tables for name in functions(table))
    unordered = ((table, row.name) for table, row in rational(chart))
    named = itertools.product(unordered if scalar == COMPLEX else every, FORMS)
    names = (f"{prefix(chart, table)}_{name}{form}" for (table, name), form in named)
    calls = "".join(f"reinterpret_cast<const void *>(&dualcay::{name}<TYPE >),\n" for name in names)
    path = tmp_path / f"{chart.name}.cpp"
    array = f"extern const void *const all[];\nconst void *const all[] = {{\n{calls}}};\n"
    path.write_text(f'#include "scalars.h"\n{includes([chart])}{array}', encoding="utf-8")
    return path


def compile_alone(headers: Path, chart: Chart, tmp_path: Path, compiler: str, standard: str, scalar: str) -> str:
    flags = (compiler, *STRICT[1:], f"-std={standard}", f"-DTYPE={scalar}", "-Wfloat-equal", "-Wold-style-cast")
    quiet = ("-fsyntax-only", f"-I{headers}", f"-isystem{HERE}")
    command = [*flags, *quiet, str(alone(chart, tmp_path, scalar))]
    return subprocess.run(command, capture_output=True, text=True).stderr


@pytest.mark.parametrize(
    ("chart", "scalar"),
    [(OTHERS[1], "Jet<6>"), (CHARTS[1], COMPLEX), *(pytest.param(*one, marks=pytest.mark.thorough) for one in (
        (Cayley(3), "Mixed"), (OTHERS[0], "Lazy"), (OTHERS[1], "Jet<3, Jet<2> >"),
    ))],
)  # fmt: skip
def test_every_function_compiles_alone(chart, scalar, tmp_path, headers):
    assert compile_alone(headers, chart, tmp_path, COMPILERS[0], "c++11", scalar) == ""


# --- derivatives by jets ----------------------------------------------------------------------------------------


def by_jets(headers: Path, chart: Chart, tmp_path: Path, compiler: str, standard: str) -> dict[str, float]:
    """Return the functions of a chart whose derivatives by jets are not their Jacobians, with the largest error."""
    source = tmp_path / f"{chart.name}.cpp"
    source.write_text(jets.program(chart), encoding="utf-8")
    program = built(compiler, source, headers, tmp_path / chart.name, f"-std={standard}")
    said = subprocess.run([str(program)], capture_output=True, text=True, check=True).stdout
    return jets.wrong(chart, said, JACOBIAN_ROUNDING)


def test_derivatives_by_jets_are_the_jacobians(headers, tmp_path):
    assert by_jets(headers, OTHERS[0], tmp_path, COMPILERS[0], "c++11") == {}


@pytest.mark.thorough
def test_derivatives_by_jets_are_the_jacobians_in_every_chart(tmp_path):
    files.write(tmp_path / "all", print_package(committed(), C, tested=False).texts)
    for chart, compiler, standard in zip(committed(), itertools.cycle(COMPILERS), itertools.cycle(STANDARDS)):
        assert by_jets(tmp_path / "all", chart, tmp_path, compiler, standard) == {}, chart.name


# --- prime fields -----------------------------------------------------------------------------------------------


def rational(chart: Cayley) -> list[tuple[Table, Function]]:
    """Return the rational functions of the headers, without root, selection or angle, with their tables."""
    needed = {table.name: levels(lower_chart(chart, table)) for table in C.tables}
    rows = ((table, table.sources[name]) for table in C.tables for name in ALGEBRAIC if name in table.sources)
    return [(table, row) for table, row in rows if not needed[table.name][row.kernel]]


def expected(chart: Cayley, row: Function, arguments: Sequence[Sequence[Any]]) -> tuple[Any, ...]:
    return evaluated(row, Formulas(chart, Lifting()), [*map(tuple, arguments)], 0 * arguments[0][0])


def dispatcher(folder: Path) -> Path:
    """Write a program that reads a prime, a function number and arguments; it prints results modulo the prime."""
    called = [(chart, table, row) for chart in CHARTS for table, row in rational(chart)]
    path = folder / "fields.cpp"
    path.write_text(
        f"""#include "scalars.h"
{includes(CHARTS)}
using namespace dualcay;
static void read(Residue *to, int n)
{{
    unsigned long long value;
    for (int i = 0; i < n && std::scanf("%llu", &value) == 1; ++i) to[i].value = value;
}}
static void show(const Residue *from, int n)
{{ for (int i = 0; i < n; ++i) std::printf("%llu ", (unsigned long long)from[i].value); std::puts(""); }}
int main()
{{
    unsigned long long prime;
    int function;
    Residue given[64], made[128];
    while (std::scanf("%llu %d", &prime, &function) == 2) {{
        Residue::prime = prime;
        switch (function) {{
            {cases(called)}
        }}
    }}
}}
""",
        encoding="utf-8",
    )
    return path


@dataclass(frozen=True)
class Query:
    """Question to the program: a chart's function, and a point in a prime field."""

    chart: Cayley
    index: int
    table: Table
    row: Function
    arguments: tuple[tuple[Residue, ...], ...]

    @property
    def line(self) -> str:
        numbers = [element for argument in self.arguments for element in argument]
        return " ".join([str(numbers[0].prime), str(self.index), *(str(element.value) for element in numbers)])


def queries(seed: int) -> list[Query]:
    draw = random.Random(seed)
    named = [(chart, table, row) for chart in CHARTS for table, row in rational(chart)]
    return [
        Query(chart, index, table, row, tuple(
            tuple(Residue(draw.randrange(prime), prime) for _ in range(array.size)) for array in row.arguments
        ))
        for prime in PRIMES
        for index, (chart, table, row) in enumerate(named)
        for _ in range(POINTS)
    ]  # fmt: skip


def differing(program: Path, asked: Sequence[Query]) -> set[str]:
    """Return the names of functions with a result that differs from the formula."""
    said = answers(program, (query.line for query in asked))
    found = zip(asked, (list(map(int, numbers)) for numbers in said), strict=True)
    return {
        f"{prefix(query.chart, query.table)}_{query.row.name}"
        for query, got in found
        if got != [(0 * query.arguments[0][0] + e).value for e in expected(query.chart, query.row, query.arguments)]
    }


def degree(chart: Cayley, table: Table, row: Function) -> int:
    """Return a bound of the degree of the numerator, in the difference of a printed function and its formula."""
    arguments = [[Degree() for _ in range(array.size)] for array in row.arguments]
    module = importlib.import_module(".".join(filter(None, ("dualcay", table.name, chart.name))))
    arrays = [np.array(given, object).reshape(array.shape) for given, array in zip(arguments, row.arguments)]
    found = getattr(module, row.name)(*arrays)
    printed = [degree_of(d) for part in (found if isinstance(found, tuple) else (found,)) for d in part.ravel()]
    formulas = map(degree_of, expected(chart, row, arguments))
    return max(max(a.above + b.below, b.above + a.below) for a, b in zip(printed, formulas, strict=True))


@COMPILER
def test_rational_functions_are_their_formulas_in_prime_fields(compiler, headers, tmp_path):
    program = built(compiler, dispatcher(tmp_path), headers, tmp_path / "fields")
    asked = queries(seed=61)
    assert differing(program, asked) == set()
    most = max(degree(chart, table, row) for chart in CHARTS for table, row in rational(chart))
    bound = (most / min(PRIMES)) ** (POINTS * len(PRIMES))
    assert bound < 1e-60
