"""C headers among foreign macros, with strict warnings, without a library, and in CMake projects of C++ alone."""

from __future__ import annotations

import ctypes
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest

import derive
from derive.codegen.rows import inside
from derive.codegen.signatures import POSES, lower_chart
from derive.codegen.targets import c99
from derive.codegen.targets.c import shared_geometry
from derive.codegen.validation.c_text import prefix
from derive.maps import Cayley, family
from dualcay import cayley3, rotation
from tests.support import thorough
from tests.support.compilers import FOREIGN, FOREIGN_FUNCTIONS, WARNINGS
from tests.support.scalars import TABLES, includes

pytestmark = pytest.mark.compiler

OWN = ("alpha/(1 + alpha**2/40)", "cbrt(3*(alpha - sin(alpha))/4)", "tan(alpha/4)/cos(alpha/4)")
"""Functions φ with a fold, with a quotient at 0, and inverted by halvings: no package of these tests has one."""
CALLS = ("tensor(v, T)", "principal(v, T)", "shadow(v, 1, T)", "from_quaternion(v, 0, T)", "switch(v, v, v, T, T, T)")
"""Calls of functions without an angle."""


def checked(text: str, headers: Path, tmp_path: Path, *flags: str) -> str:
    """Return what a C compiler says of a text."""
    source = tmp_path / "some.c"
    source.write_text(text, encoding="utf-8")
    command = ["gcc", "-std=c99", *WARNINGS, *flags, "-fsyntax-only", f"-I{headers}", str(source)]
    return subprocess.run(command, capture_output=True, text=True).stderr


def words(function: c99.CFunction) -> set[str]:
    """Return the names in a function, without macros of these headers."""
    found = re.findall(r"\b[A-Za-z]\w*", function.parameters + function.text)
    return {word for word in found if not word.startswith("DUALCAY_")}


@pytest.mark.parametrize("phi", thorough.sampled(("", *OWN), ("", OWN[0])))
def test_scalars_have_no_names_of_foreign_macros(phi):
    for chart in (derive.Parameterization(phi, "own"),) if phi else (Cayley(3), family("breusing")):
        for name, program in lower_chart(chart).scalars.items():
            assert not words(c99.scalar(program, {})) & {*FOREIGN, *FOREIGN_FUNCTIONS}, (chart.phi, name)


def test_geometry_has_lower_case_names():
    """Expect no capital letters: short names in capitals are macros of many libraries."""
    for table in TABLES:
        for core in shared_geometry(table)["cores"]:
            assert words(core) == {word.lower() for word in words(core)}, core.name


def test_headers_compile_among_foreign_macros(headers, tmp_path):
    text = "#include <math.h>\n#include <stddef.h>\n" + "".join(f"#define {name} ?\n" for name in FOREIGN)
    text += "".join(f"#define {name}(x) ?\n" for name in FOREIGN_FUNCTIONS)
    text += includes([Cayley(3), family("exponential")])
    assert checked(text, headers, tmp_path, "-DDUALCAY_REAL=float") == ""


def test_even_orders_need_no_library(headers, tmp_path):
    chart = Cayley(2)
    calls = " ".join(f"{prefix(chart, table)}_{call};" for table in TABLES for call in CALLS)
    text = f"{includes([chart])}void f(const double *v, double *T);\nvoid f(const double *v, double *T) {{ {calls} }}\n"
    assert checked(text, headers, tmp_path, "-ffreestanding", "-DDUALCAY_FREESTANDING") == ""


def library(headers: Path, tmp_path: Path, text: str, *flags: str) -> ctypes.CDLL:
    """Compile a text that includes headers."""
    source, made = tmp_path / "some.c", tmp_path / "some.so"
    source.write_text(text, encoding="utf-8")
    command = ["gcc", "-std=c99", *flags, "-shared", "-fPIC", f"-I{headers}", source, "-lm", "-o", made]
    subprocess.run(command, check=True)
    return ctypes.CDLL(str(made))


def test_a_result_may_take_the_place_of_an_argument(headers, tmp_path):
    """Compare to the bit; a single result may also overlap an argument in part. Branches count modulo their number."""
    names, text = ("shadow", "principal", "compose", "twist", "transform_line"), [includes([Cayley(3)])]
    for row in (POSES.public[name] for name in names):
        few, branch = len(row.arguments), ["1"] * row.branch
        one = ", ".join([*"ab"[:few], *branch, "to"])
        rows = ", ".join(["n", *(f"{letter}, n" for letter in "ab"[:few]), *branch, "to, n"])
        parameters, begin = "const double *a, const double *b, double *to", f"{prefix(Cayley(3), POSES)}_{row.name}"
        text.append(f"void one_{row.name}({parameters}) {{ {begin}({one}); (void)b; }}")
        text.append(f"void rows_{row.name}(size_t n, {parameters}) {{ {begin}_rows({rows}); (void)b; }}")
    text.append("int branch_of(int k, int n) { return dualcay_branch(k, n); }")
    made, (v, w) = library(headers, tmp_path, "\n".join(text), "-O2"), np.random.default_rng(3).normal(size=(2, 6, 8))

    def called(name, a, b, to, *count):
        pointers = (ctypes.c_void_p(array.ctypes.data) for array in (a, b, to))
        getattr(made, name)(*map(ctypes.c_size_t, count), *pointers)
        return to

    assert [made.branch_of(k, 3) for k in range(-4, 5)] == [k % 3 for k in range(-4, 5)]
    for name in names:
        wanted = called(f"rows_{name}", v, w, np.empty_like(v), 8)
        for a, b in ((v.copy(), w), (v, w.copy())):
            np.testing.assert_array_equal(called(f"rows_{name}", a, b, a if a is not v else b, 8), wanted)
        single = called(f"one_{name}", *(np.ascontiguousarray(array[:, 0]) for array in (v, w)), np.empty(6))
        for shift in range(6):
            memory = np.concatenate([v[:, 0], np.zeros(shift)])
            called(f"one_{name}", memory, np.ascontiguousarray(w[:, 0]), memory[shift:])
            np.testing.assert_array_equal(memory[shift:], single)


@pytest.mark.parametrize("table", TABLES, ids=["poses", "rotations"])
def test_a_switch_is_that_of_the_numpy_kernels(headers, table, tmp_path):
    """Compare vector, rate and covariance beyond half a turn, where all of them change."""
    chart, n = Cayley(3), 6 if table is POSES else 3
    parameters = ", ".join(f"double *{letter}" for letter in "abcdef")
    call = f"void run({parameters}) {{ {prefix(chart, table)}_switch(a, b, c, d, e, f); }}\n"
    made = library(headers, tmp_path, f'#include "{inside(table, "cayley3.h")}"\n{call}', "-O0")
    module = cayley3 if table is POSES else rotation.cayley3
    v = module.from_exponential(np.array([2.0, -3.0, 1.5, 0.4, 0.7, -0.3])[:n])
    root = np.arange(1.0, n * n + 1).reshape(n, n) % 7 - 3
    given = (v, np.linspace(-1, 2, n), root @ root.T)
    found = [np.empty_like(array) for array in given]
    made.run(*(np.ctypeslib.as_ctypes(array.reshape(-1)) for array in (*given, *found)))
    for one, other in zip(found, module.switch(*given), strict=True):
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-13 * abs(other).max())
