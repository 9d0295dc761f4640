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

RELAXED = ("--expt-relaxed-constexpr",)
"""Flag with which device code may call host functions that are constexpr; no code may depend on it."""

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


def compiled(chart: Chart, folder: Path, *flags: str, tables: Sequence[Table] = TABLES) -> tuple[str, str]:
    """Return what nvcc says of all kernels of a chart, and their code for the device."""
    source, made = folder / "all.cu", folder / "all.ptx"
    source.write_text(kernels(chart, tables), encoding="utf-8")
    made.unlink(missing_ok=True)
    done = subprocess.run(["nvcc", *STRICT, *flags, f"-I{folder}", source, "-o", made], capture_output=True, text=True)
    return done.stdout + done.stderr, made.read_text(encoding="utf-8") if made.exists() else ""


def test_every_function_of_rotations_becomes_device_code(tmp_path: Path) -> None:
    files.write(tmp_path, print_package([Cayley(3)], TARGETS["c"], tested=False).texts)
    said, code = compiled(Cayley(3), tmp_path, WAYS[0], tables=[ROTATIONS])
    assert (said, code.count(".entry")) == ("", len(functions(ROTATIONS)))


@pytest.mark.thorough
@pytest.mark.parametrize("way", WAYS)
def test_code_for_the_device_does_without_host_functions(way: str, tmp_path: Path) -> None:
    charts = committed()[:: 3 if "TEMPLATES" in way else 1]  # templates take four times as long
    files.write(tmp_path, print_package(charts, TARGETS["c"], tested=False).texts)
    for chart in charts:
        (said, code), other = (compiled(chart, tmp_path, way, *flags) for flags in ((), RELAXED))
        assert said == "", chart.name
        assert other == ("", code), chart.name


@pytest.mark.thorough
def test_a_literal_of_another_type_is_refused(tmp_path: Path) -> None:
    files.write(tmp_path, print_package([Cayley(3)], TARGETS["c"], tested=False).texts)
    header = tmp_path / "cayley3.h"
    text = header.read_text(encoding="utf-8")
    assert "dualcay_atan2(r, (dualcay_real)1)" in text
    header.write_text(text.replace("dualcay_atan2(r, (dualcay_real)1)", "dualcay_atan2(r, 1)"), encoding="utf-8")
    assert "host" in compiled(Cayley(3), tmp_path, WAYS[0], tables=[ROTATIONS])[0]
