"""C target under nvcc: every function becomes code for the device, without a warning."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest

from derive.codegen.build import print_package
from derive.codegen.catalogue import committed
from derive.codegen.rows import Function, Table
from derive.codegen.signatures import ROTATIONS
from derive.codegen.targets import TARGETS
from derive.codegen.validation.c_text import prefix
from derive.maps import Cayley
from derive.maps.chart import Chart
from derive.output import files
from tests.support.scalars import TABLES, functions, includes

pytestmark = [
    pytest.mark.compiler,
    pytest.mark.skipif(not shutil.which("nvcc"), reason="nvcc, the compiler of CUDA, is not installed"),
]

STRICT = ("-ptx", "-arch=sm_90", "-Werror", "all-warnings")
"""Flags that refuse a call of a host function in device code, which nvcc else compiles to nothing."""

WAYS = ("-DDUALCAY_REAL=double", "-DDUALCAY_REAL=float", "-DDUALCAY_TEMPLATES")


def kernels(chart: Chart, tables: Sequence[Table]) -> str:
    """Return a program with a kernel for every function of a chart in some tables."""
    lines = [includes([chart]), "#ifdef DUALCAY_TEMPLATES", "using namespace dualcay;"]
    lines += ["typedef double dualcay_real;", "#endif"]
    for table in tables:
        lines += [kernel(f"{prefix(chart, table)}_{row.name}", row) for row in functions(table).values()]
    return "\n".join(lines) + "\n"


def kernel(name: str, row: Function) -> str:
    arrays = [f"const dualcay_real *{array.name}" for array in row.arguments]
    arrays += [f"dualcay_real *{array.name}" for array in row.results]
    given = [f"*{array.name}" if array.size == 1 else array.name for array in row.arguments]
    passed = ", ".join([*given, *["branch"] * row.branch, *(array.name for array in row.results)])
    return f'extern "C" __global__ void run_{name}({", ".join(["int branch", *arrays])}) {{ {name}({passed}); }}'


def compiled(chart: Chart, headers: Path, tmp_path: Path, way: str, tables: Sequence[Table] = TABLES) -> str:
    """Return what nvcc says of all kernels of a chart."""
    source = tmp_path / "all.cu"
    source.write_text(kernels(chart, tables), encoding="utf-8")
    command = ["nvcc", *STRICT, way, f"-I{headers}", str(source), "-o", str(tmp_path / "all.ptx")]
    done = subprocess.run(command, capture_output=True, text=True)
    return done.stdout + done.stderr


def test_every_function_of_rotations_becomes_device_code(tmp_path):
    files.write(tmp_path, print_package([Cayley(3)], TARGETS["c"], tested=False).texts)
    assert compiled(Cayley(3), tmp_path, tmp_path, WAYS[0], [ROTATIONS]) == ""


@pytest.mark.thorough
def test_every_function_of_every_chart_becomes_device_code(tmp_path):
    files.write(tmp_path, print_package(committed(), TARGETS["c"], tested=False).texts)
    for place, chart in enumerate(committed()):
        assert compiled(chart, tmp_path, tmp_path, WAYS[place % len(WAYS)]) == "", chart.name


@pytest.mark.thorough
def test_a_literal_of_another_type_is_refused(tmp_path):
    files.write(tmp_path, print_package([Cayley(3)], TARGETS["c"], tested=False).texts)
    header = tmp_path / "cayley3.h"
    text = header.read_text(encoding="utf-8")
    assert "dualcay_atan2(r, (dualcay_real)1)" in text
    header.write_text(text.replace("dualcay_atan2(r, (dualcay_real)1)", "dualcay_atan2(r, 1)"), encoding="utf-8")
    assert "host" in compiled(Cayley(3), tmp_path, tmp_path, WAYS[0], [ROTATIONS])
