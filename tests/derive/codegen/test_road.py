"""Generation from proof to files: false text is never written, and every run writes the same text."""

from __future__ import annotations

import dataclasses
import gc
import re
from contextlib import nullcontext
from pathlib import Path

import pytest

import derive
from derive import about
from derive.codegen import ValidationFailed, check_charts, signatures
from derive.codegen import build as road
from derive.codegen.package import notices, shared_texts
from derive.codegen.rows import Function
from derive.codegen.signatures import POSES, PUBLIC, ROTATIONS, geometry
from derive.codegen.targets import TARGETS, python
from derive.codegen.validation import float_cases, samples, validate
from derive.codegen.validation.batches import batches
from derive.codegen.validation.calls import Kind, kind_of, restricted
from derive.codegen.validation.expected_values import ALGEBRAIC
from derive.codegen.validation.inverse_maps import MAPS
from derive.maps import Cayley
from derive.output import files
from derive.proof import ProofFailed
from tests.support.packages import unvalidated

NUMPY = TARGETS["numpy"]


@pytest.fixture(scope="module")
def package():
    charts = Cayley(3), Cayley(4)
    return road.indexed(road.build(charts, unvalidated(NUMPY)), NUMPY, charts)


GEOMETRY = "_geometry.py"


@pytest.mark.parametrize(("before", "meanwhile"), [(700, road.GC_THRESHOLD), (10**6, 10**6), (0, 0)])
def test_gc_threshold_is_raised_while_charts_are_built(before, meanwhile):
    usual = gc.get_threshold()
    gc.set_threshold(before, 5, 7)
    try:
        with road.relaxed_gc():
            assert gc.get_threshold() == (meanwhile, 5, 7)
        assert gc.get_threshold() == (before, 5, 7)
    finally:
        gc.set_threshold(*usual)


def flipped(text: str, function: str, pattern: str, replacement: str) -> str:
    """Return a text with one change inside a program."""
    head, rest = text.split(f"def {function}(", 1)
    changed, count = re.subn(pattern, replacement, rest, count=1)
    assert count == 1
    return f"{head}def {function}({changed}"


@pytest.mark.parametrize(
    ("file", "function", "pattern", "replacement"),
    [
        ("cayley3.py", "_quaternion_scalars", r"p = 1 - 3 \* x", "p = 1 + 3 * x"),
        ("cayley4.py", "_ray", r"return p, q, root", "return p, q, 1"),
        ("cayley3.py", "_natural", r"2 \* m\.atan2", "m.atan2"),
        (GEOMETRY, "principal", r"m\.where\(beyond, u1 \* rk, v1\)", "0.25"),
        (GEOMETRY, "transition", r"dual_product\(back, start\)", "dual_product(start, back)"),
    ],
)
def test_wrong_sign_or_factor_fails_validation(package, tmp_path: Path, file, function, pattern, replacement):
    order = int(file.removeprefix("cayley").removesuffix(".py")) if file != GEOMETRY else 3
    texts = dict(package.texts)
    texts[file] = flipped(texts[file], function, pattern, replacement)
    files.write(tmp_path, texts)
    with pytest.raises(ValidationFailed, match=rf"cayley{order}\.\w+.*component"):
        validate(tmp_path, Cayley(order), geometry=True)


def test_right_kernels_pass_with_every_case_compared(package, tmp_path: Path):
    files.write(tmp_path, package.texts)
    compared = sum(1 + len(batch.cases) for batch in batches(Cayley(3), POSES))
    assert validate(tmp_path, Cayley(3), geometry=True, tables=(POSES,)) == compared


@pytest.mark.parametrize("target", TARGETS)
@pytest.mark.parametrize("name", ["compose", "shadow"])
def test_function_without_an_expected_value_is_not_generated(name, target, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.delitem(MAPS if name in MAPS else ALGEBRAIC, name)
    with pytest.raises(ValueError, match=rf"functions without an expected value cannot be generated: {name}$"):
        TARGETS[target].require_complete({})
    assert name in PUBLIC


@pytest.mark.parametrize("target", TARGETS)
def test_function_whose_arguments_are_not_drawn_is_not_generated(target, monkeypatch: pytest.MonkeyPatch):
    v2, v1 = PUBLIC["between"].arguments
    monkeypatch.setitem(signatures.PUBLIC, "between", dataclasses.replace(PUBLIC["between"], arguments=(v1, v2)))
    with pytest.raises(ValueError, match=r"functions without arguments that are drawn cannot be generated: between$"):
        TARGETS[target].require_complete({})


def test_function_without_a_decision_on_derivatives_is_not_generated(monkeypatch: pytest.MonkeyPatch):
    texts = shared_texts(TARGETS["array-api"])
    for decision, message in (
        ("by text", "functions without a decision on derivatives cannot be generated: compose$"),
        (signatures.SMOOTH, "_rules.py: its rules and the decisions of the table differ for compose$"),
    ):
        monkeypatch.setitem(POSES.kernels, "compose", dataclasses.replace(PUBLIC["compose"], derivatives=decision))
        with pytest.raises(ValueError, match=message):
            TARGETS["array-api"].require_complete(texts)


@pytest.mark.parametrize("table", [POSES, ROTATIONS], ids=["poses", "rotations"])
def test_functions_without_loss_by_text_have_no_roots_or_choices(table):
    smooth = {name for name, row in table.kernels.items() if row.derivatives == signatures.SMOOTH}
    operations = {step.op for name in smooth for step in geometry(table)[name].steps}
    assert operations == {"add", "sub", "mul", "div", "neg"}


def test_chart_without_a_call_of_a_function_is_not_generated(monkeypatch: pytest.MonkeyPatch):
    kinds = (Kind.WAY, Kind.SCREW, Kind.TURN)

    def without(cases, table):
        return restricted((case for case in cases if kind_of(case.row) not in kinds), table)

    for module in (samples, float_cases):
        monkeypatch.setattr(module, "restricted", without)
    monkeypatch.setattr(float_cases, "drawn", float_cases.drawn.__wrapped__)
    for table, screw in ((POSES, "from_screw"), (ROTATIONS, "from_angle_axis")):
        missing = f"{screw}, interpolate, shadow, shadow_jacobian"
        with pytest.raises(ValueError, match=rf"functions without a call cannot be generated: {missing}$"):
            batches.__wrapped__(Cayley(3), table)
        with pytest.raises(ValueError, match=rf"functions without a call in floats cannot be generated: {missing}$"):
            float_cases.cases(Cayley(3), table)


def test_function_without_an_exact_call_is_not_generated(monkeypatch: pytest.MonkeyPatch):
    original = samples.on_symbols
    monkeypatch.setattr(samples, "on_symbols", lambda *given: (c for c in original(*given) if c.function != "tangent"))
    with pytest.raises(ValueError, match=r"functions without (a|an exact) call cannot be generated: tangent$"):
        batches.__wrapped__(Cayley(3), POSES)


def test_function_needs_a_row_a_recipe_and_a_docstring(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    row = dataclasses.replace(PUBLIC["pose"], name="stance")
    monkeypatch.setitem(ALGEBRAIC, "stance", ALGEBRAIC["pose"])
    for add, remove, message in (
        ({"stance": row}, (), "functions of the table that are missing: stance; not in it: none"),
        ({}, ("pose",), "functions of the table that are missing: none; not in it: pose"),
    ):
        with monkeypatch.context() as patch:
            for name, value in add.items():
                patch.setitem(signatures.PUBLIC, name, value)
            for name in remove:
                patch.delitem(signatures.PUBLIC, name)
            with pytest.raises(ValueError, match=message):
                derive.generate([3], output=tmp_path / "k")
    with pytest.raises(ValueError, match="stance has no recipe"):
        dataclasses.replace(row, recipe=None).traced()
    monkeypatch.setitem(signatures.FUNCTIONS, "twist", dataclasses.replace(PUBLIC["twist"], branch=True))
    with pytest.raises(ValueError, match="twist takes v, v_dot, and v, v_dot, branch in the table"):
        derive.generate([3], output=tmp_path / "k")
    assert not (tmp_path / "k").exists()


def test_function_without_docstring_is_not_generated():
    with pytest.raises(ValueError, match="has no docstring"):
        NUMPY.require_interface({python.INTERFACE: bare_interface(keywords=True)})


def test_keywords_must_match_the_table():
    with pytest.raises(ValueError, match="keywords of quaternion are axis, out, not axis, out, scalar_first"):
        NUMPY.require_interface({python.INTERFACE: bare_interface(keywords=False)})


def bare_interface(keywords: bool) -> str:
    """Return an interface without docstrings; ``keywords`` adds each function's own keyword arguments."""

    def parameters(row: Function) -> str:
        common = NUMPY.keywords if len(row.results) == 1 else ["axis"]
        given = ["self", *(a.name for a in row.arguments), *["branch"] * row.branch]
        return ", ".join([*given, "*", *common, *(row.keywords if keywords else ())])

    bare = "".join(f"    def {name}({parameters(row)}): ...\n" for name, row in PUBLIC.items())
    return f"class PoseKernels:\n{bare}"


def test_failed_proof_writes_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    wrong = Cayley(2).tensor
    monkeypatch.setattr(Cayley, "tangent", wrong)
    with pytest.raises(ProofFailed, match="tangent"):
        derive.generate([2], output=tmp_path / "kernels")
    assert not (tmp_path / "kernels").exists()


@pytest.mark.parametrize("target", TARGETS.values(), ids=lambda target: target.name)
def test_notice_bears_the_header_and_replaces_the_entry(target):
    charts = [Cayley(n) for n in range(1, 400)]
    ((name, text),) = notices(charts, target).items()
    assert name in target.shared()
    command = files.MARK.match(text).group(1)
    assert command.endswith(f"399 --target {target.name} --max-n 399")
    assert text.count(command) == 2


@pytest.mark.smoke
def test_check_regenerates_further_modules_by_their_header(package, tmp_path: Path):
    files.write(tmp_path, package.texts)
    path = tmp_path / "cayley4.py"
    path.write_text(path.read_text() + "# touched\n")
    (tmp_path / "cayley3.py").unlink()
    lines: list[str] = []
    found = check_charts(tmp_path, [Cayley(3)], "numpy", lambda _: nullcontext(lines.append))
    assert lines == [f"cayley{n}: {stage}" for n in (3, 4) for stage in ("proving", "printing")]
    assert [(d.path.name, d.kind) for d in found] == [("cayley3.py", "missing"), ("cayley4.py", "stale")]


def test_module_with_header_of_another_target_is_foreign(package, tmp_path: Path):
    files.write(tmp_path, package.texts)
    path = tmp_path / "cayley4.py"
    text = path.read_text()
    path.write_text(text.replace("-n 4 --target numpy", "-n 4 --target numba"))
    assert path.read_text() != text
    found = check_charts(tmp_path, [Cayley(3)], "numpy")
    assert [d.path.name for d in found if d.kind == "foreign"] == 2 * ["cayley4.py"]


def test_default_folder_exists_only_in_a_checkout(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    with pytest.raises(ValueError, match="only NumPy kernels have a default one, and only in a checkout"):
        derive.generate([2], target="c")
    monkeypatch.setattr(about, "checkout", lambda: None)
    with pytest.raises(ValueError, match="name a folder"):
        derive.generate([2])
    assert not any(tmp_path.iterdir())


def test_bad_orders_and_targets_are_refused(tmp_path: Path):
    with pytest.raises(ValueError, match="order n must be an integer >= 1, got 0"):
        derive.generate([0], output=tmp_path / "k")
    with pytest.raises(TypeError, match=r"order n must be an integer >= 1, got 2\.5"):
        derive.generate([2.5], output=tmp_path / "k")  # type: ignore[list-item]
    with pytest.raises(ValueError, match=r"target must be one of numpy.*got 'fortran'"):
        derive.generate([2], target="fortran", output=tmp_path / "k")
    assert not (tmp_path / "k").exists()
