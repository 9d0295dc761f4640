"""C headers under Frama-C's Eva: no run-time error for any finite numbers, any branch, and 0 to 3 rows.

Eva follows each function on sets of values. Numbers that overflow or become NaN count as results, not as errors.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest

from derive.codegen.rows import Function
from derive.codegen.signatures import POSES, lower_chart
from derive.codegen.targets.c import levels
from derive.codegen.validation.c_interpreter.source import SYSTEM
from derive.codegen.validation.c_text import prefix
from derive.maps import Cayley, family
from derive.maps.chart import Chart
from tests.support.scalars import TABLES, Called, functions, includes

pytestmark = [pytest.mark.frama, pytest.mark.thorough]

MOST = 3
"""Most rows of an array."""
EVA = (
    "-eva", "-eva-auto-loop-unroll", "16", "-eva-no-results", "-warn-special-float", "none", "-warn-invalid-pointer",
    "-warn-unsigned-overflow", "-warn-signed-downcast", "-warn-unsigned-downcast", "-no-frama-c-stdlib",
    "-kernel-warn-key", "typing:implicit-function-declaration=error",
)  # fmt: skip
SMALL = ("-machdep", "x86_32", "-cpp-extra-args=-DDUALCAY_FREESTANDING -DDUALCAY_REAL=float")
"""Flags for a processor with pointers of 32 bits and no math.h."""


def driver(chart: Chart, called: Sequence[Called]) -> str:
    """Return a program that calls both forms of functions, and `singular_angles`."""
    uses = {f"{prefix(chart, table)}_{row.name}": row for _, table, row in called}
    angles = f"dualcay_real angles[{len(chart.singular_angles)}]; dualcay_{chart.name}_singular_angles(angles);"
    calls = "".join(f"use_{name}();\n" for name in uses)
    defined = "".join(use(name, row) for name, row in uses.items())
    return f"{includes([chart])}extern int branch;\n{defined}int main(void)\n{{\n{angles}\n{calls}}}\n"


def use(name: str, row: Function) -> str:
    """Return a function that calls both forms of a function, and asserts that all components are written.

    External arrays hold any finite numbers. Each array of rows has another stride, and ends at its last component.
    """
    given = [(f"{name}_{place}", array.size, 4 + place) for place, array in enumerate(row.arguments)]
    made = [(f"made_{place}", array.size, 14 + place) for place, array in enumerate(row.results)]

    def declared(arrays: Sequence[tuple[str, int, int]], external: str = "") -> str:
        each = (f"{at}[{size}], {at}_rows[{(size - 1) * by + MOST}]" for at, size, by in arrays)
        return "".join(f"{external}dualcay_real {two};\n" for two in each)

    branch = ["branch"] * row.branch
    one = [*(f"*{at}" if size == 1 else at for at, size, _ in given), *branch, *(at for at, _, _ in made)]
    rows = ["n", *(f"{at}_rows, {by}" for at, _, by in given), *branch, *(f"{at}_rows, {by}" for at, _, by in made)]
    written = [f"{at} + (0 .. {size - 1})" for at, size, _ in made]
    written += [f"{at}_rows + ({by * i} .. {by * i + MOST - 1})" for at, size, by in made for i in range(size)]
    calls = f"{name}({', '.join(one)});\nfor (size_t n = 0; n <= {MOST}; ++n) {{ {name}_rows({', '.join(rows)}); }}\n"
    asserted = "".join(f"//@ assert \\initialized({cells});\n" for cells in written)
    return f"{declared(given, 'extern ')}void use_{name}(void)\n{{\n{declared(made)}{calls}{asserted}}}\n"


def analysed(
    chart: Chart, called: Sequence[Called], headers: Path, folder: Path, *flags: str
) -> tuple[list[str], list[int]]:
    """Return Eva's alarms, and how many functions and statements it does not reach."""
    for name, text in {**SYSTEM, "driver.c": driver(chart, called)}.items():
        (folder / name).write_text(text, encoding="utf-8")
    include = f"-cpp-extra-args=-nostdinc -I{headers} -I{folder}"
    command = ["frama-c", *EVA, include, *flags, str(folder / "driver.c")]
    said = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    alarms = re.findall(r"^\[eva:alarm\] \S+: Warning:\s+(.*)", said, re.MULTILINE)
    counts = re.findall(r"(\d+) (?:functions analyzed|statements reached) \(out of (\d+)\)", said)
    return alarms, [int(every) - int(some) for some, every in counts]


@pytest.mark.parametrize(
    ("chart", "most", "flags"),
    [(Cayley(2), 2, ()), (Cayley(2), 1, SMALL), (Cayley(3), 2, ()), (family("exponential"), 2, ())],
)
def test_no_function_has_a_run_time_error(headers, tmp_path, chart, most, flags):
    """Expect Eva to reach all statements, and with math.h all functions but `stay_core`, for charts with an end."""
    called = []
    for table in TABLES:
        needed = levels(lower_chart(chart, table))
        called += [(chart, table, row) for row in functions(table).values() if needed[row.kernel] <= most]
    alarms, (missed, statements) = analysed(chart, called, headers, tmp_path, *flags)
    assert (alarms, statements) == ([], 0)
    assert flags or missed == len(TABLES)


@pytest.mark.parametrize(
    ("file", "name", "text", "altered", "message"),
    [
        ("geometry.h", "pose", "pose_at[15 * pose_by]", "pose_at[16 * pose_by]", "out of bounds write"),
        ("geometry.h", "pose", "v_at[5 * v_by]", "v_at[6 * v_by]", "out of bounds read"),
        ("geometry.h", "pose", "j < n", "j <= n", "out of bounds read"),
        ("geometry.h", "pose", "v + j, v_stride", "v + j, v_stride + 1", "invalid pointer creation"),
        ("geometry.h", "pose", "pose_at[12 * pose_by] = (dualcay_real)0;", "", "assertion got status"),
        ("cayley2.h", "pose", "*h_at = g;", "", "accessing uninitialized left-value"),
        ("dualcay.h", "shadow", "rest + branches", "rest", "accessing out of bounds index"),
        ("dualcay.h", "shadow", "branch % branches", "(branch + 1) % branches", "signed overflow"),
        ("dualcay.h", "shadow", "branch % branches", "branch % (branches - 2)", "division by zero"),
        ("dualcay.h", "shadow", "branch % branches", "branch % branches << 32", "invalid RHS operand for shift"),
    ],
)
def test_a_planted_error_is_found(headers, tmp_path, file, name, text, altered, message):
    place = shutil.copytree(headers, tmp_path / "headers") / file
    whole = place.read_text(encoding="utf-8")
    assert text in whole
    place.write_text(whole.replace(text, altered), encoding="utf-8")
    alarms, _ = analysed(Cayley(2), [(Cayley(2), POSES, POSES.public[name])], place.parent, tmp_path)
    assert any(message in found for found in alarms), alarms
