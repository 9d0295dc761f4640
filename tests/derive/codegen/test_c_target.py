"""The C target: what the printer writes, what validation catches, what the command says."""

from __future__ import annotations

import re
import subprocess

import pytest
from click.testing import CliRunner
from derive.codegen.trace import Trace
from derive.codegen.validation.cases import cases

from derive.cli.commands import cli
from derive.codegen import ValidationFailed, build, c99, check, generate
from derive.codegen.lowering import lower
from derive.codegen.module import notices
from derive.codegen.signatures import SIGNATURES
from derive.codegen.targets import TARGETS
from derive.codegen.validation import compiled
from derive.maps import Cayley
from derive.output import files

C = TARGETS["c"]


@pytest.fixture(scope="module")
def package():
    assert compiled.compiler(), "these tests need a C compiler: install gcc, or name one in CC"
    return build([3, 4], C)


# --- printer ------------------------------------------------------------------------------------------------------


def printed(record, names=("a", "b")):
    """The assignment and store of a program that records one value from two inputs."""
    trace = Trace()
    values = trace.inputs("v", names)
    return c99.function(trace.program("pose", [record(trace, *values)] + [0] * 15)).text


def test_components_are_loaded_before_any_result_is_stored():
    lines = c99.function(lower(3)["compose"]).text.splitlines()
    loads = [i for i, line in enumerate(lines) if re.search(r"= \w+_at\[", line)]
    stores = [i for i, line in enumerate(lines) if re.match(r"\s+\w+_at\[.*\] =", line)]
    assert len(loads) == 12
    assert len(stores) == 6
    assert max(loads) < min(stores)


def test_a_choice_of_integers_is_a_real_number():
    text = printed(lambda t, a, b: t.where(t.less(a, 0), -1, 1) / b)
    assert "(a < 0 ? -1 : (dualcay_real)1) / b" in text


def test_choices_are_ternaries_and_conditions_are_bracketed():
    text = printed(lambda t, a, b: t.where(t.either(t.less(a, b), t.both(t.equal(a, 0), t.less(b, 0))), a, -b))
    assert "(a < b) | ((a == 0) & (b < 0)) ? a : -b" in text


def test_named_conditions_are_int():
    text = printed(lambda t, a, b: t.where(t.name("small", t.less(a, b)), a, b) + t.where(t.less(a, b), b, a))
    assert "const int small = a < b;" in text


def test_names_are_lower_case_and_stay_apart():
    text = printed(lambda t, a, b: t.name("N", a * b) + t.name("n", a + b) * t.name("M", a - b), names=("T1", "t1"))
    assert "const dualcay_real t1_ = " in text
    assert "const dualcay_real n_ = t1_ * t1;" in text
    assert "const dualcay_real n = t1_ + t1;" in text
    assert "const dualcay_real m = t1_ - t1;" in text


def test_constants_which_a_float_would_round_are_refused():
    assert str(2**24) in printed(lambda t, a, b: 2**24 * a)
    with pytest.raises(ValueError, match="beyond 16777216"):
        printed(lambda t, a, b: (2**24 + 1) * a)


@pytest.mark.parametrize("order", [1, 2, 3, 8, 64])
def test_every_program_prints_with_the_arrays_of_its_signature(order):
    for name, program in lower(order).items():
        function = c99.function(program)
        components = sum(len(parts) for _, parts in program.inputs)
        if name in SIGNATURES and name not in ("shadow", "principal"):
            assert components == sum(array.size for array in SIGNATURES[name].arguments), name
            assert len(program.outputs) == sum(array.size for array in SIGNATURES[name].results), name
        assert function.math <= {"sqrt", "tan", "atan2"}


def test_rational_maps_need_no_mathematical_functions():
    functions = {name: c99.function(program) for name, program in lower(4).items()}
    for name in ("quaternion", "tensor", "pose", "transform_point", "transform_line", "tangent", "rate", "twist"):
        assert not functions[name].math, name


# --- the package --------------------------------------------------------------------------------------------------


def test_the_package_holds_headers_their_tests_and_a_cmake_project(package):
    assert set(package.texts) == {
        "CMakeLists.txt", "dualcay.h", "differential.h", "cayley3.h", "cayley4.h", "test_cayley3.c", "test_cayley4.c",
    }  # fmt: skip
    for name, text in package.texts.items():
        assert files.MARK.match(text), name
        assert not re.search(r"\s\n", text.replace("\n\n", "\n").replace("\n\n", "\n")), name


def test_the_same_text_comes_out_twice(package):
    assert build([4, 3], C).texts == package.texts


def test_every_function_has_a_plain_form_and_one_for_rows(package):
    text = package.texts["cayley3.h"]
    for name in SIGNATURES:
        assert f"DUALCAY_FUNCTION void dualcay_cayley3_{name}(" in text
        assert f"DUALCAY_FUNCTION void dualcay_cayley3_{name}_rows(" in text
    for alias in ("dcay", "dcay_rows", "dcay_inv", "dcay_inv_rows"):
        assert f"#define dualcay_cayley3_{alias} " in text


def test_a_folder_is_checked_as_a_whole(tmp_path, package):
    generate([3, 4], "c", tmp_path)
    assert check(tmp_path, [3], "c") == []
    (tmp_path / "test_cayley4.c").write_text(package.texts["test_cayley4.c"].replace("0x1", "0x2", 1))
    (tmp_path / "differential.h").unlink()
    assert {(found.path.name, found.kind) for found in check(tmp_path, [3], "c")} == {
        ("test_cayley4.c", "stale"), ("differential.h", "missing"),
    }  # fmt: skip


def test_half_written_headers_do_not_compile_and_say_how_to_finish_them(staged):
    (staged / "dualcay.h").write_text(notices([3, 4], C)["dualcay.h"])
    test = str(staged / "test_cayley3.c")
    done = subprocess.run([*compiled.compiler(), "-fsyntax-only", test], capture_output=True, text=True, check=False)
    assert done.returncode
    assert "half-written kernels: finish them with  python -m derive generate -n 3,4 --target c " in done.stderr
    assert [(d.path.name, d.kind) for d in check(staged, [3], "c")] == [("dualcay.h", "stale")]


# --- validation ---------------------------------------------------------------------------------------------------


@pytest.fixture
def staged(tmp_path, package):
    files.write(tmp_path, package.texts)
    return tmp_path


@pytest.mark.parametrize(
    ("order", "function", "pattern", "replacement"),
    [
        (3, "quaternion", r"3 \* x", "2 * x"),
        (3, "tensor", r"gvv1 - fv3", "gvv1 + fv3"),
        (3, "pose", r"h = 16 \* s", "h = 8 * s"),
        (3, "transform_line", r"q = 3 - x", "q = 3 + x"),
        (3, "tangent", r"xo = 2 \* y", "xo = y"),
        (3, "tangent_inv", r"d = 11 - x", "d = 11 + x"),
        (3, "twist", r"w1o \* f", "w2o * f"),
        (3, "rate", r"v1 / -2", "v1 / 2"),
        (3, "body_rate", r"v1 / -2", "v1 / 2"),
        (3, "from_pose", r"q32 - q23", "q23 - q32"),
        (3, "from_tensor", r"/ 2\b", "/ 3"),
        (3, "from_quaternion", r"/ 3\b", "/ 4"),
        (3, "compose", r"p = 1 - ", "p = 1 + "),
        (3, "shadow", r"r \* cos \+ sn", "r * cos - sn"),
        (3, "turn", r"iden \* iden", "iden"),
        (3, "to_screw", r"2 \* dualcay_atan2", "dualcay_atan2"),
        (3, "from_screw", r"/ 6", "/ 3"),
        (3, "principal", r"k \+= ", "k -= "),
        (4, "from_quaternion", r"\(1 \+ ", "(1 - "),
    ],
)
def test_a_changed_kernel_fails_validation(staged, order, function, pattern, replacement):
    header = staged / f"cayley{order}.h"
    head, name, rest = header.read_text(encoding="utf-8").partition(f"_{function}_core(\n")
    changed, count = re.subn(pattern, replacement, rest, count=1)
    assert count == 1
    header.write_text(head + name + changed, encoding="utf-8")
    with pytest.raises(ValidationFailed, match=f"test_cayley{order}.c"):
        compiled.test(staged, Cayley(order))


def test_a_result_that_is_nan_fails_validation(staged):
    header = staged / "cayley3.h"
    text = header.read_text(encoding="utf-8")
    header.write_text(text.replace("pose_at[0] = ", "pose_at[0] = (v1 - v1) / (v1 - v1) + ", 1), encoding="utf-8")
    with pytest.raises(ValidationFailed, match=r"pose .*FAILED"):
        compiled.test(staged, Cayley(3))


def test_what_does_not_compile_fails_validation(staged):
    header = staged / "cayley3.h"
    header.write_text(header.read_text(encoding="utf-8").replace("const dualcay_real x = ", "x = ", 1))
    with pytest.raises(ValidationFailed, match="does not compile"):
        compiled.test(staged, Cayley(3))


def test_every_function_and_branch_has_cases():
    found = cases(Cayley(3))
    assert {case.function for case in found} == set(SIGNATURES)
    for name, signature in SIGNATURES.items():
        branches = {case.branch for case in found if case.function == name}
        assert branches == ({0, 1, 2} if signature.branch else {None})


def test_without_a_compiler_nothing_is_claimed_of_compiled_code(monkeypatch, tmp_path):
    monkeypatch.setenv("CC", "no-such-compiler")
    result = CliRunner().invoke(cli, ["generate", "-n", "2", "--target", "c", "-o", str(tmp_path)])
    assert result.exit_code == 0
    assert re.search(r"cayley2\.h\W+\d+\W+\d+\W+\d{3}\W+-\s", result.stdout)
    assert "no C compiler found (set CC), so validated as text only" in result.stderr
    assert "cayley2.h" in result.stderr


def test_the_command_wants_a_folder():
    result = CliRunner().invoke(cli, ["generate", "-n", "2", "--target", "c"])
    assert result.exit_code == 2
    assert "-o" in result.stderr
