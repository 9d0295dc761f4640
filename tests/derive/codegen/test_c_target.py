"""C target: printed text, errors caught by validation, and messages of the command."""

from __future__ import annotations

import re
import subprocess

import pytest
from click.testing import CliRunner

from derive.cli.commands import cli
from derive.codegen import ValidationFailed, check_charts, generate
from derive.codegen.package import notices
from derive.codegen.programs.trace import Trace
from derive.codegen.signatures import KERNELS, POSES, ROTATIONS, lower_chart
from derive.codegen.targets import TARGETS, c, c99
from derive.codegen.validation import compiled
from derive.codegen.validation.float_cases import cases
from derive.maps import Cayley
from derive.output import files
from tests.support import packages
from tests.support.packages import Otherwise, unvalidated

pytestmark = pytest.mark.thorough

C = TARGETS["c"]


@pytest.fixture(scope="module")
def texts(shared):
    folder = shared("c_of_orders_3_and_4", lambda place: packages.write([3, 4], "c", place))
    return {str(path.relative_to(folder)): path.read_text("utf-8") for path in folder.rglob("*") if path.is_file()}


# --- printer ------------------------------------------------------------------------------------------------------


def printed(record, names=("a", "b")):
    """Return the printed assignment and store of a program that records one value from two inputs."""
    trace = Trace()
    values = trace.inputs("v", names)
    return c99.core(trace.program("pose", [record(trace, *values)] + [0] * 15), KERNELS["pose"].results, {}).text


def test_slow_functions_run_only_where_a_result_depends_on_them():
    def record(t, a, b):
        near = t.name("near", t.less(a, 1))
        one, both, other = (t.name(name, t.tan(a + k)) for k, name in enumerate(("one", "both", "other")))
        return t.where(near, one * one, other * other * both) + both

    text = printed(record)
    assert "one = near ? dualcay_tan(a) : (dualcay_real)0;" in text
    assert "both = dualcay_tan(a + 1);" in text
    assert "other = near ? (dualcay_real)0 : dualcay_tan(a + 2);" in text


def test_names_are_lower_case_and_distinct():
    text = printed(lambda t, a, b: t.name("N", a * b) + t.name("n", a + b) * t.name("M", a - b), names=("T1", "t1"))
    assert "const dualcay_real t1_ = " in text
    assert "const dualcay_real n_ = t1_ * t1;" in text
    assert "const dualcay_real n = t1_ + t1;" in text
    assert "const dualcay_real m = t1_ - t1;" in text


def test_names_differing_only_in_case_stay_distinct():
    text = printed(lambda t, a, b: t.name("C4S", a * b) + t.name("c4S", a + b) * t.name("c4s_", a - b))
    assert {"c4s = a * b", "c4s__ = a + b", "c4s_ = a - b"} <= set(re.findall(r"dualcay_real (\w+ = .*);", text))


def test_constants_which_a_float_would_round_are_refused():
    assert str(2**24) in printed(lambda t, a, b: 2**24 * a)
    with pytest.raises(ValueError, match="beyond 16777216"):
        printed(lambda t, a, b: (2**24 + 1) * a)


def test_library_level_of_a_function_includes_its_scalars():
    levels = c.levels(lower_chart(Cayley(4)))
    for name in ("quaternion", "tensor", "pose", "transform_point", "transform_line", "tangent", "rate", "twist"):
        assert levels[name] == 0, name
    assert levels["from_pose"] == levels["compose"] == 1
    assert levels["from_screw"] == levels["to_screw"] == 2
    odd = c.levels(lower_chart(Cayley(3)))
    assert (odd["quaternion"], odd["pose"], odd["from_pose"], odd["turn"]) == (1, 0, 2, 1)


# --- the package --------------------------------------------------------------------------------------------------


def test_the_package_holds_headers_their_tests_and_a_cmake_project(texts):
    assert set(texts) == {
        "CMakeLists.txt", "dualcay.h", "geometry.h", "differential.h", "cayley3.h", "cayley4.h", "test_cayley3.c",
        "test_cayley4.c", "rotation/geometry.h", "rotation/cayley3.h", "rotation/cayley4.h",
    }  # fmt: skip
    for name, text in texts.items():
        assert files.MARK.match(text), name
        assert not re.search(r"\s\n", text.replace("\n\n", "\n").replace("\n\n", "\n")), name
        assert text.isascii(), name
    for text in (text for name, text in texts.items() if name.endswith(("geometry.h", "cayley3.h"))):
        assert not re.search(r"^[^/]*\b[A-Z]\b", text, re.MULTILINE), "where other people's macros are"


def test_rotation_headers_reuse_scalars_of_poses(texts):
    """Expect no new scalar programs: rotations call the scalar programs in the headers of poses."""
    text = texts["rotation/geometry.h"]
    called = set(re.findall(r"DUALCAY_CHART\((\w+)\)\(", text))
    assert len(called) > 10
    assert all(f" dualcay_cayley3_{name}(" in texts["cayley3.h"] for name in called)
    assert "DUALCAY_CORE" not in texts["rotation/cayley3.h"]


@pytest.mark.parametrize(
    ("file", "old", "new", "message"),
    [
        ("geometry.h", "void DUALCAY_NAME(rate)(", "void DUALCAY_NAME(rated)(", "missing: rate; not in it: rated"),
        ("geometry.h", "void DUALCAY_NAME(rate_rows)(", "void DUALCAY_NAME(rows)(", "missing: none; not in it: rows"),
        ("geometry.h", "void DUALCAY_NAME(shadow_rows)(", "int DUALCAY_NAME(shadow_rows)(", "rows: .*missing: shadow"),
        ("rotation/geometry.h", "(rate)(", "(pose)(", "missing: rate; not in it: pose"),
    ],
)
def test_unknown_or_missing_function_is_an_error(texts, file, old, new, message):
    C.require_complete(texts)
    assert old in texts[file]
    with pytest.raises(ValueError, match=rf"^{file}\b.*{message}"):
        C.require_complete({**texts, file: texts[file].replace(old, new, 1)})


def test_a_folder_is_checked_as_a_whole(tmp_path, texts, without_validation):
    generate([3], "c", tmp_path)
    (tmp_path / "test_cayley3.c").write_text(texts["test_cayley3.c"].replace("0x1", "0x2", 1))
    (tmp_path / "differential.h").unlink()
    assert {(found.path.name, found.kind) for found in check_charts(tmp_path, [Cayley(3)], "c")} == {
        ("test_cayley3.c", "stale"), ("differential.h", "missing"),
    }  # fmt: skip


@pytest.mark.compiler
@pytest.mark.parametrize("first", ["cayley3.h", "rotation/geometry.h", "differential.h"])
def test_half_written_headers_fail_to_compile_and_name_the_command(staged, first):
    """Expect an error that names the command, for any header included first, even with other headers missing."""
    (staged / "dualcay.h").write_text(notices([Cayley(3), Cayley(4)], C)["dualcay.h"])
    for name in {"geometry.h", "rotation/geometry.h"} - {first}:
        (staged / name).unlink()
    source = staged / "user.c"
    source.write_text(f'#include "{first}"\n')
    command = [*compiled.compiler(), "-fsyntax-only", str(source)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode
    errors = [line for line in done.stderr.splitlines() if "error:" in line]
    assert "half-written kernels: finish them with  python -m derive generate -n 3,4 --target c " in errors[0]


# --- validation ---------------------------------------------------------------------------------------------------


@pytest.fixture
def staged(tmp_path, texts):
    files.write(tmp_path, texts)
    return tmp_path


@pytest.mark.compiler
def test_printed_package_agrees(staged):
    assert compiled.test(staged, Cayley(3)) > 1000


# test_c_text tries more errors, without a compiler
@pytest.mark.compiler
@pytest.mark.parametrize(
    ("file", "old", "new", "message"),
    [
        ("cayley3.h", "h = 16 * r;", "h = 17 * r;", r"test_cayley3\.c"),
        ("geometry.h", "pose_at[0] = ", "pose_at[0] = (v1 - v1) / (v1 - v1) + ", "pose .*FAILED"),
        ("rotation/geometry.h", "gvv1 - fv3", "gvv1 + fv3", "FAILED"),
        ("geometry.h", "const dualcay_real x = ", "x = ", "does not compile"),
    ],
)
def test_a_changed_kernel_fails_validation(staged, file, old, new, message):
    text = (staged / file).read_text(encoding="utf-8")
    assert old in text
    (staged / file).write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(ValidationFailed, match=message):
        compiled.test(staged, Cayley(3))


@pytest.mark.parametrize("table", [POSES, ROTATIONS], ids=["poses", "rotations"])
def test_every_branch_of_every_function_has_cases(table):
    found = cases(Cayley(3), table)
    for name, signature in table.public.items():
        branches = {case.branch for case in found if case.function == name}
        assert ({(k or 0) % 3 for k in branches} == {0, 1, 2}) if signature.branch else (branches == {None})


def test_without_compiler_no_compiled_calls_are_reported(monkeypatch, tmp_path):
    monkeypatch.setenv("CC", "no-such-compiler")
    monkeypatch.setattr("derive.codegen.build.TARGETS", {"c": Otherwise(unvalidated(C), test=C.test)})
    monkeypatch.setattr("derive.cli.charts.cores", lambda: 1)
    result = CliRunner().invoke(cli, ["generate", "-n", "2", "--target", "c", "-o", str(tmp_path)])
    assert result.exit_code == 0
    heads = re.search(r"module\W+proofs\W+lines\W+cayley2\.h\W+\d+\W+\d+\s", result.stdout)
    assert heads, "a column of what was not measured is left out"
    assert "no C compiler found (set CC), so validated as text only" in result.stderr
    assert "cayley2.h" in result.stderr
