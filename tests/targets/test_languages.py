"""Law of every language: each function gives the bits of the C headers, compiled without fused operations."""

from __future__ import annotations

import ctypes
import subprocess
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from derive.codegen.targets import TARGETS
from derive.codegen.validation.batches import ValidationFailed
from tests.support import js, languages, listing, matlab, pages, rust
from tests.support.languages import chart, differing, expected, write

pytestmark = pytest.mark.compiler

FIRST = ("cayley2",)
CHARTS = ("cayley1", "cayley3", "cayley4", "cayley5", "cayley8", "exponential", "lambert")
RUN = {"json": listing.run, "rust": rust.run, "js": js.run, "matlab": matlab.run}
LANGUAGES = [
    "json", pytest.param("rust", marks=pytest.mark.rust), pytest.param("js", marks=pytest.mark.node),
    pytest.param("matlab", marks=pytest.mark.octave),
]  # fmt: skip
ALTERED = {
    "json": [
        ("cayley2.json", '["x13", "add", "v11", "v33"]', '["x13", "subtract", "v11", "v33"]'),
        ("cayley2.json", '"results": ["f", "g", "g"', '"results": ["g", "f", "g"'),
    ],
    "matlab": [
        ("+dualcay/+cayley2/pose.m", "pose_scalars(v11, v22, v33)", "pose_scalars(v11, v22, v22)"),
        ("+dualcay/+cayley2/from_pose.m", "best1 = dualcay.internal.select(larger1, t1, t0);", "best1 = t0;"),
    ],
    "rust": [
        ("geometry.rs", "[b1, b2, b3, b1o, b2o, b3o], [rho1_2", "[b2, b1, b3, b1o, b2o, b3o], [rho1_2"),
        ("cayley2.rs", "let within = select(left < T::of(0), last, alpha);", "let within = alpha;"),
    ],
    "js": [
        ("geometry.js", "const fv1 = v1 * f;", "const fv1 = -v1 * f;"),
        ("cayley2.js", "out[0] = s;", "out[1] = s;"),
    ],
}
"""Alterations of printed programs, each kind in two languages: sign, argument, selection, order of results."""

FUNCTIONS = {
    "rust": ("geometry.rs", "geometry::rate::<$chart, T>(*v, *omega,", "geometry::rate::<$chart, T>(*omega, *v,"),
    "js": ("geometry.js", "omega[4], omega[5], 1, 0.5,", "omega[5], omega[4], 1, 0.5,"),
    "matlab": ("+dualcay/+cayley2/rate.m", "omega(5, :), omega(6, :), 1.0", "omega(6, :), omega(5, :), 1.0"),
}
"""Alterations of the functions around the programs: swapped arguments of rate."""


@pytest.fixture(scope="module")
def headers(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., ctypes.CDLL]:
    """Provide a function that compiles the C headers of charts in a real type."""
    return cache(lambda names, real="double": languages.reference(tmp_path_factory.mktemp("c"), names, real))


def wrong(language: str, names: tuple[str, ...], library: ctypes.CDLL, folder: Path, dtype=np.float64) -> list[str]:
    """Return the functions whose results have other bits than those in C."""
    cases = [case for name in names for case in languages.cases(name)]
    given = {} if dtype == np.float64 else {"dtype": dtype}
    found = RUN[language](folder / "kernels", cases, folder / "run", **given)
    pairs = ((case, zip(made, expected(case, library, dtype), strict=True)) for case, made in zip(cases, found))
    return [str(case) for case, results in pairs if any(differing(a, b).any() for a, b in results)]


@pytest.mark.parametrize("names", [FIRST, pytest.param(CHARTS, marks=pytest.mark.thorough)], ids=["cayley2", "others"])
@pytest.mark.parametrize("language", LANGUAGES)
def test_functions_give_the_bits_of_c(language, names, headers, tmp_path) -> None:
    write(language, names, tmp_path / "kernels")
    assert wrong(language, names, headers(names), tmp_path) == []


@pytest.mark.rust
@pytest.mark.thorough
def test_numbers_of_32_bits_are_those_of_c(headers, tmp_path) -> None:
    names = (*FIRST, *CHARTS)
    write("rust", names, tmp_path / "kernels")
    assert wrong("rust", names, headers(names, "float"), tmp_path, np.float32) == []


@pytest.mark.fortran
@pytest.mark.parametrize("function", ["pose", "compose", "retract_jacobians"])
@pytest.mark.parametrize("name", ["cayley2", pytest.param("exponential", marks=pytest.mark.thorough)])
def test_printer_of_the_guide_gives_the_bits_of_c_in_fortran(name, function, headers, tmp_path) -> None:
    [script] = pages.blocks((pages.ROOT / "docs" / "howto" / "own_target.md").read_text(encoding="utf-8"), "python")
    (tmp_path / "fortran.py").write_text(script, encoding="utf-8")
    data = write("json", [name], tmp_path / "kernels") / f"{name}.json"
    command = [sys.executable, "fortran.py", str(data), function]
    text = subprocess.run(command, cwd=tmp_path, capture_output=True, check=True).stdout
    (tmp_path / "program.f90").write_bytes(text)
    flags = ("-O2", "-Wall", "-Werror", "-Wno-unused-dummy-argument", "-ffp-contract=off", "-ffree-line-length-none")
    build = ["gfortran", *flags, "-shared", "-fPIC", "program.f90", "-o", "program.so"]
    subprocess.run(build, cwd=tmp_path, check=True)
    program = getattr(ctypes.CDLL(str(tmp_path / "program.so")), f"__dualcay_MOD_{function}")
    [case] = [case for case in languages.cases(name) if (case.table, case.function) == ("", function)]
    made = np.empty((len(case.given()), case.size))
    for given, row in zip(case.given(), made, strict=True):
        numbers = (number for array in (given, row) for number in np.split(array, array.size))
        program(*(number.ctypes.data_as(ctypes.c_void_p) for number in numbers))
    for one, other in zip(languages.parted(case, made), expected(case, headers((name,))), strict=True):
        assert not differing(one, other).any()


def alter(folder: Path, name: str, old: str, new: str) -> None:
    text = (folder / name).read_text(encoding="utf-8")
    assert old in text
    (folder / name).write_text(text.replace(old, new, 1), encoding="utf-8")


@pytest.mark.thorough
@pytest.mark.parametrize("language", LANGUAGES[1:])
def test_an_altered_function_has_other_bits(language, headers, tmp_path) -> None:
    alter(write(language, FIRST, tmp_path / "kernels"), *FUNCTIONS[language])
    assert wrong(language, FIRST, headers(FIRST), tmp_path) == ["cayley2 rate branch 0"]


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("place", range(2))
def test_an_altered_program_is_refused(language, place, tmp_path) -> None:
    write(language, FIRST, tmp_path)
    alter(tmp_path, *ALTERED[language][place])
    with pytest.raises(ValidationFailed, match=r"cayley2"):
        TARGETS[language].validate(tmp_path, chart("cayley2"), geometry=True)
