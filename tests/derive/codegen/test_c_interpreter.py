"""The interpreter of C: what it computes, and what it refuses because C would round it or leave it undefined."""

from __future__ import annotations

from fractions import Fraction

import pytest

from derive.codegen.validation.c_interpreter import UNSET, CError, Pointer, load
from derive.proof import Ring


def run(text, *arguments):
    """The value of f."""
    return load(text).call("f", *arguments)


def expression(text, a=Fraction(3), b=Fraction(-7, 2)):
    return run(f"double f(double a, double b) {{ return {text}; }}", a, b)


# --- numbers ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("a + 2 * b", Fraction(-4)),
        ("a - b - 1", Fraction(11, 2)),
        ("a / b / 2", Fraction(-3, 7)),
        ("-a * -b", Fraction(-21, 2)),
        ("(a + 1) / 3", Fraction(4, 3)),
        ("0.1 * a", Fraction(3, 10)),
        ("2.0", Fraction(2)),
        ("1e-2 + 1", Fraction(101, 100)),
        ("(double)1 / 3", Fraction(1, 3)),
        ("1 / (double)3", Fraction(1, 3)),
        ("a < b ? 1 : 2.0", Fraction(2)),
        ("(a < b ? 1 : 2.0) / 4", Fraction(1, 2)),
        ("(b < 0) & (a > 0) ? -1 : (double)1", Fraction(-1)),
        ("(b > 0) | (a == 3) ? a : b", Fraction(3)),
        ("a >= 3 && b <= -3.5 && a != b ? a : b", Fraction(3)),
        ("!(a < b) || a / 0 < 1 ? 5 : b", Fraction(5)),
    ],
)
def test_expressions_are_exact(text, value):
    found = expression(text)
    assert found == value
    assert isinstance(found, Fraction)


def test_numbers_may_be_elements_of_a_ring():
    ring = Ring(extra=("a",))
    v = ring.vector("v")
    text = "#include <math.h>\ndouble f(const double v[3], double a) { return sqrt(v[0] * v[0]) * a / 2; }"
    with pytest.raises(CError, match="must depend on the squares"):
        run(text, Pointer.to(list(v)), ring.symbol("a"))
    text = """
    double f(const double v[3], double a) {
        const double x = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        return x > 0 ? a * x / (1 + x) : 0;
    }"""
    x = ring.square("v")
    assert run(text, Pointer.to(list(v)), ring.symbol("a")) == ring.symbol("a") * x / (1 + x)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("1 / 2 * a", "integer division"),
        ("a * (3 / (1 + 1))", "integer division"),
        ("(a < b ? 1 : 2) / 4 * a", "integer division"),
        ("a < 0 ? a : 1 / 2", "integer division"),
        ("(a < b) / 2 + a", "integer division"),
        ("(float)a", "the type float is not read here"),
        ("(int)a", "real where int is expected"),
        ("0.5f * a", "a constant of type float"),
        ("a % b", "real % real is not read here"),
        ("a & 1", "real & int is not read here"),
        ("c + a", "c is not declared"),
        ("sqrt(a)", "sqrt is not a function defined before"),
        ("f(a, b)", "f is not a function defined before"),
        ("2147483647 + 1", "overflows int"),
        ("a / (b + 3.5)", "Fraction"),
        ("&a == &b ? a : b", "numbers are expected"),
        ("*a", "a pointer is expected"),
        ("a[0]", "is not read here"),
        ("(void)a", "void"),
        ("((void)a, b)", None),
        ("(a = 1, b)", None),
    ],
)
def test_what_c_would_round_or_leave_undefined_is_an_error(text, message):
    if message is None:
        assert expression(text) == Fraction(-7, 2)
        return
    with pytest.raises(CError, match=message):
        expression(text)


def test_an_integer_division_is_found_where_it_is_not_executed():
    with pytest.raises(CError, match=r"unit\.c:3: an integer division"):
        load("double f(double a) {\n    if (a < a) {\n        return 1 / 2;\n    }\n    return a;\n}")


def test_integers_are_those_of_c():
    text = "int f(int a, int b) { const int r = a % b; return r < 0 ? r + b : r; }"
    assert [run(text, a, 3) for a in (-4, -3, -1, 0, 5)] == [2, 0, 2, 0, 2]
    assert run("int f(int a, int b) { return a % b; }", -7, 3) == -1
    with pytest.raises(CError, match="overflows size"):
        run("int f(const double *a, unsigned long n) { return a[n - 1] < 0; }", Pointer.to([1]), 0)


# --- memory -------------------------------------------------------------------------------------------------------

STEP = """static inline void step(const double *a_at, int by, double out[2])
{
    out[0] = a_at[by];
    out[1] = a_at[2 * by];
}
"""


def test_arrays_pointers_and_calls():
    text = STEP + """
    static void change(double *x) { *x = *x * 10; x += 1; }
    void f(const double *a, double *out) {
        static const double table[2][2] = {{1, 2.5}, {3}};
        double local[2], sum = 0;
        step(a + 1, 2, local);
        change(&local[1]);
        change(&sum);
        for (int i = 0, j = 1; i < 2; ++i, j -= 1) {
            double w = table[i][j];
            sum += w * local[i];
        }
        int k = 1;
        const double former = table[0][k--];
        sum += former - 2.5 + k;
        out[0] = sum;
        *(out + 1) = table[1][1] - local[1];
    }"""
    out = Pointer.to([UNSET] * 2)
    run(text, Pointer.to([Fraction(i) for i in range(6)]), out)
    assert out.cells == [Fraction(5, 2) * 3 + 3 * 50, -50]


@pytest.mark.parametrize(
    ("body", "message"),
    [
        ("out[0] = a[3];", "access to cell 3 of 3"),
        ("out[0] = a[-1];", "a pointer moves to cell -1 of 3"),
        ("out[2] = a[0];", "access to cell 2 of 2"),
        ("out[0] = out[1];", "cell 1 of 2 is read before it is written"),
        ("double x; out[0] = x;", "read before it is written"),
        ("double x[2] = {1}; out[0] = x[2];", "access to cell 2 of 2"),
        ("for (int i = 0; i < 2; ++i) { double x; if (i < 1) { x = 1; } out[i] = x; }", "read before it is written"),
        ("double x[2][2] = {{1, 2}, {3, 4}}; out[0] = x[0][2];", "access to cell 2 of 2"),
        ("step(a, 1, out + 1);", "an array of 1 is given where 2 are promised"),
        ("step(a, 2, out);", "a pointer moves to cell 4 of 3"),
        ("a[0] = 1;", "const real cannot be assigned"),
        ("const double x = 1; x = 2;", "const real cannot be assigned"),
        ("step(out, 1, a);", "pointer to const real where pointer to real is expected"),
        ("double x = 1; double x = 2;", "x is declared twice"),
        ("static const double x = a[0]; out[0] = x;", "static, and its first value no constant"),
        ("double *restrict p = out; p[0] = 1;", "restrict is not read here"),
        ("while (1) { out[0] = 1; }", "While is not read here"),
        ("step(a, 1);", "step takes 3 arguments, not 2"),
        ("double x[2] = {1, 2, 3}; out[0] = x[0];", "at most 2 values"),
    ],
)
def test_what_leaves_its_memory_is_an_error(body, message):
    text = f"{STEP}\nvoid f(const double *a, double *out) {{ {body} }}"
    with pytest.raises(CError, match=message):
        run(text, Pointer.to([Fraction(i) for i in range(3)]), Pointer.to([UNSET] * 2))


def test_a_function_that_ends_without_its_value_is_an_error():
    text = "double f(double a) { if (a < 0) { return 1; } }"
    assert run(text, Fraction(-1)) == 1
    with pytest.raises(CError, match="f ends without a value"):
        run(text, Fraction(1))


def test_the_library_is_called_through_the_number_type():
    class Number(Fraction):
        def sqrt(self):
            return "root"

        def arctan2(self, other):
            return ("angle", other)

    text = "#include <math.h>\n#define ROOT sqrt\ndouble f(double a) { return a < 0 ? ROOT(a) : atan2(a, 2); }"
    assert run(text, Number(-1)) == "root"
    assert run(text, Number(1)) == ("angle", 2)
    with pytest.raises(CError, match="'Fraction' object has no attribute 'sqrt'"):
        run(text, Fraction(-1))


# --- preprocessor -------------------------------------------------------------------------------------------------


GEOMETRY = """
#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#ifndef REAL
#define REAL double
#endif
static inline REAL JOIN(CHART, _twice)(REAL x)
{
    REAL s;
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


def test_functions_pasted_by_macros_and_a_header_included_twice(tmp_path):
    (tmp_path / "geometry.h").write_text(GEOMETRY)
    (tmp_path / "charts.h").write_text(CHARTS)
    unit = load('#include "charts.h"\n', tmp_path)
    assert [unit.call(f"{chart}_twice", Fraction(5)) for chart in "ab"] == [-8, 50]
    (tmp_path / "geometry.h").write_text("double g(double x) {\n    return x *;\n}\n")
    with pytest.raises(CError, match=r"^geometry\.h:"):
        load('#include "charts.h"\n', tmp_path)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('#include "other.h"', "other.h is neither in the folder nor one of stddef.h, math.h"),
        ('#include "../other.h"', "neither in the folder"),
        ('#include "/etc/hostname"', "neither in the folder"),
        ("#include <stdio.h>", "neither in the folder"),
        ("#error no real type", "#error  ?no real type"),
        ("#if (\n#endif", "unit.c:1: "),
        ("double f(double a) { return a }", "before"),
        ("struct s { double a; };", "is not read here"),
        ("extern double a;", "extern is not read here"),
        ("float f(float a) { return a; }", "the type float is not read here"),
    ],
)
def test_what_is_not_in_the_folder_or_not_read_is_an_error(tmp_path, text, message):
    (tmp_path.parent / "other.h").write_text("double x;\n")
    with pytest.raises(CError, match=message):
        load(text + "\n", tmp_path)


# --- records ------------------------------------------------------------------------------------------------------


def test_it_records_what_was_called_and_which_values_conditions_took():
    unit = load(
        "double g(double a) { return a < 1 ? 2 : a; }\n"
        "double h(double a) { return a; }\n"
        "double f(double a) { return g(a); }"
    )
    assert unit.idle == ["h", "f"]
    unit.call("f", Fraction(0))
    assert unit.idle == ["h"]
    assert [str(condition) for condition in unit.one_sided] == ["unit.c:1: a < 1"]
    unit.call("f", Fraction(2))
    assert unit.one_sided == []


def test_calls_are_checked():
    unit = load("double f(double a) { return a; }")
    with pytest.raises(CError, match="there is no function g"):
        unit.call("g", Fraction(1))
    with pytest.raises(CError, match="f takes 1 arguments, not 2"):
        unit.call("f", 1, 2)
