"""C target as C++ templates: every function compiles for numbers of a class, and jets give the Jacobians."""

from __future__ import annotations

import itertools
import subprocess
from pathlib import Path

import pytest

from derive.codegen.build import print_package
from derive.codegen.catalogue import committed
from derive.codegen.signatures import lower_chart
from derive.codegen.targets import TARGETS
from derive.codegen.targets.c import levels
from derive.codegen.validation.c_text import prefix
from derive.maps import Cayley, family
from derive.maps.chart import Chart
from derive.output import files
from tests.support import jets
from tests.support.scalars import COMPILERS, STRICT, built, functions, includes

HERE = Path(__file__).parent
C = TARGETS["c"]
pytestmark = pytest.mark.compiler

EXPONENTIAL, LAMBERT = family("exponential"), family("lambert")
FORMS = ("", "_rows")
COMPLEX = "std::complex<double>"
STANDARDS = ("c++11", "c++17", "c++2b")
JACOBIAN_ROUNDING = 2e-11
"""Tolerance for jets beside the largest entry of the Jacobian: the same at the edges, where conditions grow to 10⁴."""


def alone(chart: Chart, tmp_path: Path, scalar: str) -> Path:
    """Write a program that compiles the functions of a chart for ``TYPE``; complex numbers have no order."""
    needed = {table.name: levels(lower_chart(chart, table)) for table in C.tables}
    every = ((table, name) for table in C.tables for name, row in functions(table).items()
             if scalar != COMPLEX or needed[table.name].get(row.kernel) == 0)  # fmt: skip
    named = itertools.product(every, FORMS)
    names = (f"{prefix(chart, table)}_{name}{form}" for (table, name), form in named)
    calls = "".join(f"reinterpret_cast<const void *>(&dualcay::{name}<TYPE >),\n" for name in names)
    path = tmp_path / f"{chart.name}.cpp"
    array = f"extern const void *const all[];\nconst void *const all[] = {{\n{calls}}};\n"
    path.write_text(f'#include "scalars.h"\n{includes([chart])}{array}', encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("chart", "scalar"),
    [(LAMBERT, "Jet<6>"), (Cayley(3), COMPLEX), *(pytest.param(*one, marks=pytest.mark.thorough) for one in (
        (Cayley(3), "Mixed"), (EXPONENTIAL, "Lazy"), (LAMBERT, "Jet<3, Jet<2> >"),
    ))],
)  # fmt: skip
def test_every_function_compiles_alone(chart, scalar, tmp_path, headers):
    flags = (COMPILERS[0], *STRICT[1:], "-std=c++11", f"-DTYPE={scalar}", "-Wfloat-equal", "-Wold-style-cast")
    command = [*flags, "-fsyntax-only", f"-I{headers}", f"-isystem{HERE}", str(alone(chart, tmp_path, scalar))]
    assert subprocess.run(command, capture_output=True, text=True).stderr == ""


# --- derivatives by jets ----------------------------------------------------------------------------------------


def by_jets(headers: Path, chart: Chart, tmp_path: Path, compiler: str, standard: str) -> dict[str, float]:
    """Return the functions of a chart whose derivatives by jets are not their Jacobians, with the largest error."""
    source = tmp_path / f"{chart.name}.cpp"
    source.write_text(jets.program(chart), encoding="utf-8")
    program = built(compiler, source, headers, tmp_path / chart.name, f"-std={standard}")
    said = subprocess.run([str(program)], capture_output=True, text=True, check=True).stdout
    return jets.wrong(chart, said, JACOBIAN_ROUNDING)


def test_derivatives_by_jets_are_the_jacobians(headers, tmp_path):
    assert by_jets(headers, EXPONENTIAL, tmp_path, COMPILERS[0], "c++11") == {}


@pytest.mark.thorough
def test_derivatives_by_jets_are_the_jacobians_in_every_chart(tmp_path):
    files.write(tmp_path / "all", print_package(committed(), C, tested=False).texts)
    for chart, compiler, standard in zip(committed(), itertools.cycle(COMPILERS), itertools.cycle(STANDARDS)):
        assert by_jets(tmp_path / "all", chart, tmp_path, compiler, standard) == {}, chart.name
