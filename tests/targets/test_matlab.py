"""MATLAB packages under Octave: sizes, columns, numbers that are not finite, help texts, and their own tests."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from derive.codegen import catalogue
from derive.codegen.build import check_charts, print_package
from derive.codegen.package import notices
from derive.codegen.targets import TARGETS
from derive.codegen.targets.matlab import WIDTH
from derive.maps import Cayley
from derive.output import files
from tests.support import matlab, pages

CHARTS = [Cayley(1), Cayley(2)]
HELP = re.compile(r"(?:function .*\n)?% ?(\w+)  (\S.*)\n(?:%.*\n)*\n% python -m derive generate")
OUTSIDE = re.compile(r"[{}@]|\b(?:cellfun|arrayfun|eval|feval|global|persistent|struct)\b")
"""Constructs that code for MATLAB Coder may not have: cell arrays, function handles, names looked up as it runs."""


@pytest.fixture(scope="module")
def folder(shared: Callable[[str, Callable[[Path], object]], Path]) -> Path:
    package = print_package(CHARTS, TARGETS["matlab"])
    return shared("generated_matlab", lambda place: files.write(place, package.texts))


def texts(folder: Path) -> dict[str, str]:
    return {path.relative_to(folder).as_posix(): path.read_text("utf-8") for path in sorted(folder.rglob("*.m"))}


def code(text: str) -> str:
    """Return a text without comments and strings."""
    return re.sub(r"%.*|(?<![\w\])])'[^'\n]*'", "", text)


def test_each_file_begins_with_its_help(folder: Path) -> None:
    for name, text in texts(folder).items():
        found, place = HELP.match(text), Path(name)
        assert found, name
        known = {place.stem, place.parent.name.removeprefix("+"), "dualcay"}
        assert found[1].lower() in known, name
        assert text.startswith("function ") != (place.stem == "Contents"), name


def test_functions_keep_to_what_becomes_c(folder: Path) -> None:
    for name, text in texts(folder).items():
        if text.startswith("function ") and Path(name).stem not in ("test", "compare"):
            assert "\n%#codegen\n" in text, name
            assert not OUTSIDE.search(code(text)), name
            assert max(map(len, code(text).splitlines())) <= WIDTH + len(" ..."), name


@pytest.mark.parametrize(
    ("broken", "named"),
    [
        ("function f()\n    x = {1};", "{"),
        ("    x = arrayfun(@(y) y, v);", "arrayfun"),
        ("    x = feval('tan', v);  % {", "feval"),
    ],
)
def test_code_that_does_not_become_c_is_found(broken: str, named: str) -> None:
    found = OUTSIDE.search(code(broken))
    assert found
    assert found[0] == named


@pytest.mark.octave
def test_each_chart_passes_its_own_test(folder: Path) -> None:
    packages = [f"dualcay.{table}{chart.name}" for table in ("", "rotation.") for chart in CHARTS]
    said = matlab.octave(folder, "\n".join(f"{package}.test;" for package in packages))
    assert re.findall(r"^(\S+): \d+ calls agree \(gate 8 eps\)$", said, re.MULTILINE) == packages, said
    assert len(re.findall(r"^dualcay\.cayley2\.\w+ .* eps$", said, re.MULTILINE)) > 50


CONTROLS = {
    "changed sign": ("+cayley2/pose.m", r"(\w+ = \w+ \.\* \w+) \+ ", r"\1 - "),
    "column of another branch": ("+cayley2/from_pose.m", r"k \+ 1", "1"),
    "another number of a side": ("+rotation/+cayley2/body_rate.m", r"-0\.5\)", "0.5)"),
}


@pytest.mark.octave
@pytest.mark.parametrize("control", CONTROLS)
def test_altered_text_fails_its_test(folder: Path, tmp_path: Path, control: str) -> None:
    name, pattern, altered = CONTROLS[control]
    found = texts(folder)
    found[f"+dualcay/{name}"], count = re.subn(pattern, altered, found[f"+dualcay/{name}"], count=1)
    files.write(tmp_path, found)
    said = matlab.octave(tmp_path, f"dualcay.{'rotation.' * ('rotation' in name)}cayley2.test;")
    assert count == 1
    assert "FAILED (gate 8 eps)" in said


ERRORS = {
    "dualcay.cayley2.pose(zeros(5, 3))": "argument v: expected 6 x N, given 5 x 3",
    "dualcay.cayley2.pose(zeros(6, 2, 2))": "argument v: expected 6 x N, given 6 x 4",
    "dualcay.cayley2.pose(int32(zeros(6, 2)))": "argument v: expected real numbers of floating point",
    "dualcay.cayley2.pose(zeros(6, 1) + 1i)": "argument v: expected real numbers of floating point",
    "dualcay.cayley2.rate(zeros(6, 2), zeros(3, 2))": "argument omega: expected 6 x N, given 3 x 2",
    "dualcay.cayley2.rate(zeros(6, 2), zeros(6, 3))": "argument omega: expected 6 x 2 or 6 x 1",
    "dualcay.cayley2.interpolate(zeros(6, 2), zeros(6, 1), [0 1 2])": "argument t: expected 1 x 2 or 1 x 1",
    "dualcay.rotation.cayley1.tensor(zeros(6, 1))": "argument v: expected 3 x N, given 6 x 1",
    "dualcay.cayley2.shadow(zeros(6, 1), 0.5)": "argument branch: expected an integer",
    "dualcay.cayley2.shadow(zeros(6, 1), [0 1])": "argument branch: expected an integer",
    "dualcay.cayley2.shadow(zeros(6, 1), NaN)": "argument branch: expected an integer",
}


@pytest.mark.octave
def test_errors_name_the_argument(folder: Path) -> None:
    calls = "\n".join(f"try, {call}; disp('none'), catch e, disp(e.message), end" for call in ERRORS)
    lines = matlab.octave(folder, calls).splitlines()
    for (call, message), line in zip(ERRORS.items(), lines, strict=False):
        assert line.startswith(message), call
    assert len(lines) >= len(ERRORS)


EQUAL = {
    "a column goes with several": ("c.rate(v, w(:, 1))", "c.rate(v, w(:, [1 1 1]))"),
    "several go with a column": ("c.rate(v(:, 1), w)", "c.rate(v(:, [1 1 1]), w)"),
    "columns are independent": ("at(c.compose(v, w), 2)", "c.compose(v(:, 2), w(:, 2))"),
    "one number goes with columns": ("c.interpolate(v, w, 0.25)", "c.interpolate(v, w, [0.25 0.25 0.25])"),
    "branch 0 is understood": ("c.shadow(v)", "v"),
    "branches repeat": ("c.shadow(v, -5)", "c.shadow(v, 1)"),
    "branch of any type": ("c.shadow(v, int8(3))", "c.shadow(v, 1)"),
    "no columns": ("size(c.pose(v(:, [])))", "[16 0]"),
    "no columns with one": ("size(c.rate(v(:, []), w(:, 1)))", "[6 0]"),
    "no columns of two": ("size(c.from_screw(v(1:2, []), w(:, [])))", "[6 0]"),
    "floats stay floats": ("class(c.from_pose(single(c.pose(v))))", "'single'"),
    "one single argument suffices": ("class(c.rate(v, single(w)))", "class(c.rate(single(v), w))"),
    "NaN in, NaN out": ("isnan(c.tangent(v * NaN))", "true(18, 3)"),
    "NaN stays in its column": ("at(c.pose([v(:, 1:2), v(:, 3) * NaN]), 1:2)", "c.pose(v(:, 1:2))"),
    "a selection keeps NaN of its other side out": ("dualcay.internal.select([1 0] == 1, 2, [NaN 3])", "[2 3]"),
    "a selection takes inf of its side": ("dualcay.internal.select(true, [inf 1], NaN)", "[inf 1]"),
    "roots below 0 are NaN": ("isnan(dualcay.internal.root([-1 4 NaN]))", "[true false true]"),
    "logarithms below 0 are NaN": ("isnan(dualcay.internal.logarithm([-2 0]))", "[true false]"),
    "an alias is its function": ("c.dcay(v)", "c.tangent(v)"),
    "angles of singularities": ("c.singular_angles", "2 * pi"),
}


@pytest.mark.octave
def test_columns_branches_and_numbers_that_are_not_finite(folder: Path) -> None:
    start = "v = reshape(1:18, 6, 3) / 20; w = v([2 1 3 6 4 5], :); at = @(a, k) a(:, k);\n"
    checks = "\n".join(f"disp(isequaln({one}, {other}));" for one, other in EQUAL.values())
    said = matlab.octave(folder, start + re.sub(r"\bc\.", "dualcay.cayley2.", checks))
    assert said.split()[: len(EQUAL)] == ["1"] * len(EQUAL), said


@pytest.mark.octave
def test_program_of_the_guide_prints_what_it_shows(folder: Path) -> None:
    text = (pages.ROOT / "docs" / "howto" / "matlab.md").read_text("utf-8")
    [program], [output] = pages.blocks(text, "matlab"), pages.blocks(text, "text")
    path, _, rest = program.partition("\n")
    assert path == "addpath('kernels')"
    assert matlab.octave(folder, rest).startswith(output)


@pytest.mark.octave
def test_half_written_package_names_the_command_that_finishes_it(folder: Path, tmp_path: Path) -> None:
    own = catalogue.charts(phi="2*tan(alpha/4)", name="mine")
    files.write(tmp_path, texts(folder) | notices(own, TARGETS["matlab"]))
    said = matlab.octave(tmp_path, "dualcay.cayley2.pose(zeros(6, 1))")
    command = "python -m derive generate --phi '2*tan(alpha/4)' --name mine --target matlab"
    assert said.startswith(f"error: half-written kernels: finish them with  {command}")


# --- the folder as others -----------------------------------------------------------------------------------------


def test_folder_is_checked_as_those_of_other_targets(folder: Path, tmp_path: Path) -> None:
    files.write(tmp_path, texts(folder))
    changed, added, odd = (tmp_path / "+dualcay" / name for name in ("+cayley2/pose.m", "+cayley1/mine.m", "+mine/f.m"))

    def found() -> set[tuple[Path, str]]:
        return {(d.path, d.kind) for d in check_charts(tmp_path, CHARTS[:1], "matlab")}

    assert found() == set()  # cayley2 is printed again by the command in its list
    changed.write_text(changed.read_text("utf-8") + "% more\n", "utf-8")
    added.write_text("function f()\n%F  Mine\n", "utf-8")
    odd.parent.mkdir()
    odd.write_text("", "utf-8")
    assert found() == {(changed, "stale"), (added, "foreign"), (odd.parent, "foreign")}
    reasons = {d.path.name: d.reason for d in check_charts(tmp_path, CHARTS[:1], "matlab", cap=1)}
    assert reasons["+cayley2"].startswith("order 2 is above the cap 1")


def test_foreign_files_and_other_targets_are_refused(folder: Path, tmp_path: Path) -> None:
    found = texts(folder)
    files.write(tmp_path, found)
    with pytest.raises(files.RefusedError, match="holds kernels of the target matlab"):
        files.write(tmp_path, {"cayley2.py": "# python -m derive generate -n 2 --target numpy\n"})
    (tmp_path / "+dualcay/+cayley2/pose.m").write_text("function T = pose(v)\n%POSE  Mine\n", "utf-8")
    with pytest.raises(files.RefusedError, match=r"not a generated file, so not overwritten: .*pose\.m"):
        files.write(tmp_path, found)
