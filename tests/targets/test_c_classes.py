"""C target as C++ templates: classes of doubles give the doubles' results, and wider classes give all their digits."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import mpmath
import pytest

from derive.codegen.targets.c import GATE
from derive.codegen.validation import reals
from derive.codegen.validation.decimals import EXACT_DIGITS
from derive.codegen.validation.float_cases import FloatCase, cases, composed
from derive.maps import Cayley, family
from derive.maps.chart import Chart
from tests.support import scalars
from tests.support.scalars import COMPILERS, TABLES, built, functions

pytestmark = [pytest.mark.compiler, pytest.mark.thorough]

CHARTS = (Cayley(3), family("exponential"))
LIBRARIES = {
    "boost": ("boost/multiprecision/cpp_bin_float.hpp", "typedef boost::multiprecision::cpp_bin_float_50 Digits50;"),
    "ceres": ("ceres/jet.h", "typedef ceres::Jet<double, 2> Ceres; inline double shown(const Ceres &x) {return x.a;}"),
}
"""Headers of libraries of Debian, and what a program takes from them."""

PROGRAM = """#include "scalars.h"
#include <iomanip>
#include <iostream>
{includes}
template <class T> const T &shown(const T &x) {{ return x; }}
inline double shown(const Mixed &x) {{ return x.a; }}
inline double shown(const Lazy &x) {{ return x.a; }}
JET double shown(const Jet<N, T> &x) {{ return shown(x.a); }}
JET std::istream &operator>>(std::istream &in, Jet<N, T> &x) {{ return in >> x.a; }}
{library}
using namespace dualcay;
static void read(TYPE *to, int n)
{{
    THROUGH number;
    for (int i = 0; i < n && std::cin >> number; ++i) to[i] = static_cast<TYPE>(number);
}}
static void show(const TYPE *from, int n)
{{ for (int i = 0; i < n; ++i) std::cout << std::setprecision(60) << shown(from[i]) << " "; }}
int main()
{{
    int function, branch;
    while (std::cin >> function >> branch) {{
        TYPE given[64], made[128];
        switch (function) {{
{cases}
        }}
        std::cout << std::endl;
    }}
}}
"""


def calls(chart: Chart) -> list[FloatCase]:
    """Return the first seeded cases of each function of both tables, one for each branch."""
    every = [case for table in TABLES for case in (*cases(chart, table), *composed(chart, table))]
    return list({(id(case.row), case.branch): case for case in every}.values())


def results(
    chart: Chart, asked: Sequence[FloatCase], headers: Path, tmp_path: Path, scalar: str, through: str,
    library: str = "",
) -> list[list[str]]:
    """Return what a chart's functions give for cases, on a class that is made of another type."""
    header, text = LIBRARIES.get(library, ("", ""))
    if header and not (Path("/usr/include") / header).exists():
        pytest.skip(f"the headers of {library} are not installed")
    called = [(chart, table, row) for table in TABLES for row in functions(table).values()]
    places = {id(row): place for place, (_, _, row) in enumerate(called)}
    includes = (f"#include <{header}>\n" if header else "") + scalars.includes([chart])
    source = tmp_path / "classes.cpp"
    source.write_text(PROGRAM.format(includes=includes, library=text, cases=scalars.cases(called)), encoding="utf-8")
    flags = ("-std=c++17", f"-DTYPE={scalar}", f"-DTHROUGH={through}", "-isystem/usr/include/eigen3")
    program = built(COMPILERS[0], source, headers, tmp_path / "classes", *flags)
    return scalars.answers(program, (line(places[id(case.row)], case) for case in asked))


def line(place: int, case: FloatCase) -> str:
    with reals.digits(EXACT_DIGITS + 10):
        numbers = [mpmath.nstr(mpmath.mpf(number), mpmath.mp.dps) for given in case.arguments for number in given]
    return " ".join([str(place), str(case.branch or 0), *numbers])


@pytest.mark.parametrize(
    ("scalar", "through"),
    [
        ("Jet<2,Jet<1>>", "Jet<2,Jet<1>>"),
        *(pytest.param(name, "double", marks=pytest.mark.thorough) for name in ("Mixed", "Lazy")),
    ],
)
def test_classes_of_doubles_give_the_results_of_doubles(scalar, through, headers, tmp_path):
    asked = calls(CHARTS[0])
    expected = results(CHARTS[0], asked, headers, tmp_path, "double", "double")
    assert results(CHARTS[0], asked, headers, tmp_path, scalar, through) == expected


def wrong(asked: Sequence[FloatCase], found: Sequence[Sequence[str]], bits: int) -> Iterator[str]:
    """Yield the functions with an error beyond the gate, in units of the scale; series end with a stated remainder."""
    for case, texts in zip(asked, found, strict=True):
        with reals.digits(EXACT_DIGITS + 25):
            rest = case.row.remainder + case.chart.chart.remainder
            off = [mpmath.mpf(text) - value for text, value in zip(texts, case.compute(), strict=True)]
            parts = [(place, part) for place, array in enumerate(case.row.results) for part in array.part_of]
            for scale, owner in zip(case.scales, dict.fromkeys(parts), strict=True):
                error = mpmath.norm([o for o, other in zip(off, parts, strict=True) if other == owner])
                if not error <= GATE * scale * (mpmath.mpf(2) ** (1 - bits) + rest):
                    yield f"{case.function} branch {case.branch}: {mpmath.nstr(error / scale * 2 ** (bits - 1), 3)} eps"


@pytest.mark.parametrize(
    ("chart", "scalar", "through", "bits", "library"),
    [
        pytest.param(chart, *one, marks=[pytest.mark.thorough] * ("long double" not in one or chart is CHARTS[0]))
        for chart in CHARTS
        for one in (
            ("long double", "long double", 64, ""), ("Digits50", "Digits50", 168, "boost"),
            ("Ceres", "double", 53, "ceres"),
        )
    ],
)
def test_results_have_all_digits_of_the_class(chart, scalar, through, bits, library, headers, tmp_path):
    asked = calls(chart)
    found = results(chart, asked, headers, tmp_path, scalar, through, library)
    assert sorted(set(wrong(asked, found, bits))) == []
