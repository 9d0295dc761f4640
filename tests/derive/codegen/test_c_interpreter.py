"""Interpreter of C: exact results, and refusal of code with rounding or undefined behaviour."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from derive.codegen.validation.c_interpreter import UNSET, CError, Pointer, load


def run(text: str, *arguments: Any) -> Any:
    """Return the value of the C function f for these arguments."""
    return load(text).call("f", *arguments)


def expression(text: str, a: Any = Fraction(3), b: Any = Fraction(-7, 2)) -> Any:
    return run(f"double f(double a, double b) {{ return {text}; }}", a, b)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("a + 2 * b", Fraction(-4)),
        ("a - b - 1", Fraction(11, 2)),
        ("a / b / 2", Fraction(-3, 7)),
        ("-a * -b", Fraction(-21, 2)),
        ("0.1 * a", Fraction(3, 10)),
        ("1e-2 + 1", Fraction(101, 100)),
        ("(double)1 / 3", Fraction(1, 3)),
        ("(a < b ? 1 : 2.0) / 4", Fraction(1, 2)),
        ("(b < 0) & (a == 3) ? -1 : (double)1", Fraction(-1)),
        ("(b < -9) | (a == 3) ? a : b", Fraction(3)),
    ],
)
def test_expressions_are_exact(text: str, value: Fraction) -> None:
    found = expression(text)
    assert found == value
    assert isinstance(found, Fraction)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("1 / 2 * a", "integer division"),
        ("(a < b ? 1 : 2) / 4 * a", "integer division"),
        ("a < 0 ? a : 1 / 2", "integer division"),
        ("(float)a", "reads no type float"),
        ("(int)a", "real where int is expected"),
        ("0.5f * a", "the interpreter of C reads no Constant"),
        ("a % b", "the interpreter of C reads no real % real"),
        ("a & 1", "the interpreter of C reads no real & int"),
        ("a > b ? a : b", "the interpreter of C reads no real > real"),
        ("a < b && b < a ? a : b", "the interpreter of C reads no int && int"),
        ("!(a < b) ? a : b", "the interpreter of C reads no !"),
        ("c + a", "c is not declared"),
        ("sqrt(a)", "sqrt is not a function defined before"),
        ("f(a, b)", "f is not a function defined before"),
        ("a / (b + 3.5)", "Fraction"),
        ("*a", "a pointer is expected"),
        ("a ? b : a", "real where int is expected"),
    ],
)
def test_rounding_undefined_or_unread_expressions_are_refused(text: str, message: str) -> None:
    with pytest.raises(CError, match=message):
        expression(text)


def test_unexecuted_integer_division_is_refused() -> None:
    with pytest.raises(CError, match=r"unit\.c:3: an integer division"):
        load("double f(double a) {\n    if (a < a) {\n        return 1 / 2;\n    }\n    return a;\n}")


def test_remainders_match_c() -> None:
    text = "int f(int a, int b) { const int r = a % b; return r < 0 ? r + b : r; }"
    assert [run(text, a, 3) for a in (-4, -3, -1, 0, 5)] == [2, 0, 2, 0, 2]
    assert run("int f(int a, int b) { return a % b; }", -7, 3) == -1


STEP = """static inline void step(const double *a_at, int by, double out[2])
{
    out[0] = a_at[by];
    out[1] = a_at[2 * by];
}
"""


def test_arrays_pointers_loops_and_calls() -> None:
    text = STEP + """
    static void change(double *x) { *x = *x * 10; }
    void f(const double *a, double *out) {
        static const double table[2][2] = {{1, 2.5}, {3, 0}};
        double local[2], sum;
        sum = 0;
        step(a + 1, 2, local);
        change(&local[1]);
        change(&sum);
        for (int i = 0; i < 2; ++i) {
            const double w = table[i][1];
            sum = sum + w * local[i];
        }
        out[0] = sum;
        *(out + 1) = table[1][0] - local[1];
    }"""
    out = Pointer.to([UNSET] * 2)
    run(text, Pointer.to([Fraction(i) for i in range(6)]), out)
    assert out.cells == [Fraction(15, 2), -47]


@pytest.mark.parametrize(
    ("body", "message"),
    [
        ("out[0] = a[3];", "access to cell 3 of 3"),
        ("out[0] = *(a + -1);", "a pointer moves to cell -1 of 3"),
        ("out[2] = a[0];", "access to cell 2 of 2"),
        ("out[0] = out[1];", "cell 1 of 2 is read before it is written"),
        ("double x; out[0] = x;", "read before it is written"),
        ("step(a, 1, out + 1);", "an array of 1 is given where 2 are promised"),
        ("step(a, 2, out);", "access to cell 4 of 3"),
        ("const double x = 1; x = 2;", "x cannot be assigned"),
        ("double x; double x;", "x is declared twice"),
        ("while (1) { out[0] = 1; }", "the interpreter of C reads no While"),
        ("for (int i = 2; 0 < i; ++i) { out[0] = 1; }", "the one loop that the interpreter"),
        ("out[0] += 1;", "the interpreter of C reads no Assignment"),
        ("step(a, 1);", "step takes 3 arguments, not 2"),
        ("static const double x[2] = {1}; out[0] = x[0];", "a list of 2 values is expected"),
    ],
)
def test_leaving_its_memory_or_the_subset_is_refused(body: str, message: str) -> None:
    text = f"{STEP}\nvoid f(const double *a, double *out) {{ {body} }}"
    with pytest.raises(CError, match=message):
        run(text, Pointer.to([Fraction(i) for i in range(3)]), Pointer.to([UNSET] * 2))


def test_function_that_ends_without_its_value_is_refused() -> None:
    text = "double f(double a) { if (a < 0) { return 1; } }"
    assert run(text, Fraction(-1)) == 1
    with pytest.raises(CError, match="f ends without a value"):
        run(text, Fraction(1))


def test_library_functions_match_the_number_type() -> None:
    class Number(Fraction):
        def sqrt(self) -> str:
            return "root"

    text = "#include <math.h>\n#define ROOT sqrt\ndouble f(double a) { return ROOT(a); }"
    assert run(text, Number(-1)) == "root"
    with pytest.raises(CError, match=r"unit\.c:3: 'complex' object has no attribute 'sqrt'"):
        run(text, 1j)


def test_library_functions_take_the_constant_of_a_selection() -> None:
    text = "#include <math.h>\ndouble f(double a) { return sqrt(a < 0 ? 0.25 : a); }"
    assert run(text, Fraction(-1)) == Fraction(1, 2)


GEOMETRY = """
#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
static inline double JOIN(CHART, _twice)(double x)
{
    double s;
    JOIN(CHART, _scalar)(x, &s);
    return 2 * s;
}
#undef JOIN
#undef JOIN_
"""
CHARTS = """
static inline void a_scalar(double x, double *s) { *s = 1 - x; }
#define CHART a
#include "geometry.h"
#undef CHART
static inline void b_scalar(double x, double *s) { *s = x * x; }
#define CHART b
#include "geometry.h"
"""


def test_functions_pasted_by_macros_and_a_header_included_twice(tmp_path: Path) -> None:
    (tmp_path / "geometry.h").write_text(GEOMETRY)
    (tmp_path / "charts.h").write_text(CHARTS)
    unit = load('#include "charts.h"\n', tmp_path)
    assert unit.idle == ["a_twice", "b_twice"]
    assert [unit.call(f"{chart}_twice", Fraction(5)) for chart in "ab"] == [-8, 50]
    assert unit.idle == []
    with pytest.raises(CError, match="there is no function g"):
        unit.call("g", Fraction(1))
    (tmp_path / "geometry.h").write_text("double g(double x) {\n    return x *;\n}\n")
    with pytest.raises(CError, match=r"^geometry\.h:"):
        load('#include "charts.h"\n', tmp_path)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('#include "other.h"', "other.h is neither in the folder nor one of stddef.h, math.h"),
        ('#include "/etc/hostname"', "neither in the folder"),
        ("#include <stdio.h>", "neither in the folder"),
        ("#error no real type", "#error  ?no real type"),
        ("double f(double a) { return a }", "before"),
        ("struct s { double a; };", "the interpreter of C reads no"),
        ("extern double a;", "the interpreter of C reads no"),
        ("float f(float a) { return a; }", "reads no type float"),
    ],
)
def test_missing_files_and_unread_declarations_are_refused(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(CError, match=message):
        load(text + "\n", tmp_path)
