"""Hand-written code of the differential tests in C: errors of results, loads with a stride, and the exit status."""

from __future__ import annotations

import ctypes
import subprocess
from math import inf, nan
from typing import Any

import numpy as np
import pytest

from derive.output import pages
from tests.support.compilers import find

pytestmark = pytest.mark.compiler

CODE = """
#include "differential.h"
double error(const double *expected, const double *scales, const int *part_of, int size, const double *got, int by)
{
    dualcay_real at[64];
    differential_load(got, size, at, (size_t)by);
    return differential_error(expected, scales, part_of, size, at, (size_t)by);
}
int status(const double *errors, int count, double gate)
{
    differential_calls = differential_failures = 0;
    for (int i = 0; i < count; ++i) {
        differential_report("case", 2, errors[i], gate);
    }
    return differential_summary("all", gate) + 10 * differential_calls;
}
"""
EXPECTED, SCALES, PARTS = (1.0, 2.0, 3.0, 0.0), (4.0, 0.5, 0.0), (0, 0, 1, 2)
ERRORS = [
    ((0, 0, 0, 0), 0),
    ((3, 4, 0, 0), 5 / 4),  # the norm of a part, over its scale
    ((0, 0, -2, 0), 4),
    ((3, 4, 2, 0), 4),  # the worst part
    ((0, 0, 0, 1), inf),  # a constant result is exact
    ((3, nan, 0, 0), inf),
]  # fmt: skip
"""Differences from the expected result in units of the machine epsilon, and the error."""


@pytest.fixture(scope="module", params=[np.float64, np.float32])
def made(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Any, float]:
    """Return the compiled functions for a real type, and its machine epsilon."""
    folder, dtype = tmp_path_factory.mktemp("differential"), request.param
    real = np.ctypeslib.as_ctypes_type(dtype).__name__.removeprefix("c_")
    (folder / "dualcay.h").write_text(f"#include <stddef.h>\ntypedef {real} dualcay_real;\n", encoding="utf-8")
    (folder / "differential.h").write_text(pages.generated("c/differential.h", ""), encoding="utf-8")
    (folder / "differential.c").write_text(CODE, encoding="utf-8")
    library = folder / "differential.so"
    command = [find(), "-shared", "-fPIC", "-std=c99", "-o", library, folder / "differential.c", "-lm"]
    subprocess.run(list(map(str, command)), check=True)
    return ctypes.CDLL(str(library)), float(np.finfo(dtype).eps)


def array(values: Any, kind: Any = ctypes.c_double) -> Any:
    return (kind * len(values))(*values)


@pytest.mark.parametrize("by", [1, 3])
def test_errors_are_those_of_the_worst_part(made: tuple[Any, float], by: int) -> None:
    library, eps = made
    library.error.restype = ctypes.c_double
    for differences, wanted in ERRORS:
        got = [value + eps * difference for value, difference in zip(EXPECTED, differences, strict=True)]
        given = array(EXPECTED), array(SCALES), array(PARTS, ctypes.c_int), len(got), array(got), by
        assert library.error(*given) == wanted, differences


def test_the_exit_status_is_1_if_any_error_is_above_the_gate(made: tuple[Any, float]) -> None:
    library, _ = made
    for errors, wanted in (((), 0), ((3, 8), 0), ((9, 0), 1), ((0, nan), 1), ((inf,), 1)):
        assert library.status(array(errors), len(errors), ctypes.c_double(8)) == 20 * len(errors) + wanted, errors
