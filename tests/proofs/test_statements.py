"""Theorems in Coq files: read, refused, named on docs/theorems.md, and run; idle controls and altered texts fail."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from derive.proof.identity import ALL_ORDERS
from docs.pages import proving as proofs
from docs.pages.coq import BY_COQ, in_coq
from proofs import __main__ as command
from proofs.bridge import main, prove, table
from proofs.checker import compiled, find
from proofs.coq_controls import FILE, controls, refused
from proofs.emitted import printed
from proofs.goals import goals
from proofs.statements import FOLDER, LIST, MachineError, statements, without_comments


@pytest.fixture
def copied(tmp_path: Path) -> Path:
    return Path(shutil.copytree(FOLDER, tmp_path / "proofs", ignore=shutil.ignore_patterns("*.vo*", "*.glob")))


def replace(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


def test_theorem_is_read_with_its_proof() -> None:
    norm = next(found for found in statements() if found.name == "norm")
    assert (norm.file, norm.kind) == ("Polynomials.v", "Theorem")
    assert norm.proposition == " x n  : Prop :=  p x n * p x n + x * (q x n * q x n) = pow (1 + x) n"
    assert "induction n" in norm.proof


def test_every_theorem_is_found() -> None:
    words = [word for path in FOLDER.glob("*.v") for word in without_comments(path.read_text(encoding="utf-8")).split()]
    assert len(statements()) == words.count("Theorem") + words.count("Lemma") > 100


def test_comments_nest_and_lines_stay() -> None:
    assert without_comments("a (* b (* c\n *) d *) e *)").split() == ["a", "e"]
    assert without_comments("a (* \n *) e").count("\n") == 1


@pytest.mark.parametrize("gap", ["Admitted.", "Axiom free : False.", "Parameter free : nat.", "Unset Guard Checking."])
def test_gap_is_named_with_its_line(copied: Path, gap: str) -> None:
    with (copied / "Series.v").open("a", encoding="utf-8") as file:
        file.write(f"(* Admitted *)\n{gap}\n")
    line = (copied / "Series.v").read_text(encoding="utf-8").count("\n")
    with pytest.raises(MachineError, match=rf"Series\.v:{line}: '.*' leaves a gap") as caught:
        statements(copied)
    assert caught.value.code == 1


def test_missing_file_is_named(copied: Path) -> None:
    (copied / "Sums.v").unlink()
    with pytest.raises(MachineError, match=r"Sums\.v is missing, although _CoqProject lists it"):
        statements(copied)
    (copied / LIST).unlink()
    with pytest.raises(MachineError, match="_CoqProject cannot be read") as caught:
        statements(copied)
    assert caught.value.code == 3


def test_repeated_name_is_refused(copied: Path) -> None:
    replace(copied / "Series.v", "exponential_of_skew", "norm")
    with pytest.raises(MachineError, match=r"theorem norm stands in Polynomials\.v and in Series\.v"):
        statements(copied)


def test_every_theorem_has_a_control() -> None:
    assert {found.name for found in statements() if found.kind == "Theorem"} <= {c.theorem.name for c in controls()}
    assert all(control.altered.claim != " ".join(control.theorem.claim.split()) for control in controls())


def test_missing_and_wrong_controls_are_named(copied: Path) -> None:
    replace(copied / FILE, "norm: p x n * p x n + x", "norm: p x n - p x n")
    with pytest.raises(MachineError, match=rf"{FILE}:20: not a line .* of a theorem: norm"):
        controls(copied)
    replace(copied / FILE, "norm: p x n - p x n ==> p x n * p x n - x\n", "")
    with pytest.raises(MachineError, match="no control for theorem norm"):
        controls(copied)


def test_missing_coq_is_a_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COQBIN", str(tmp_path))
    assert command.main(["--build", str(tmp_path / "build")]) == 3
    assert "Coq 8.16 to 8.20 is needed, and no coqc is in" in (error := capsys.readouterr().err)
    assert "apt-get install coq" in error
    assert not (tmp_path / "build").exists()


def test_other_version_is_a_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    program = tmp_path / "coqc"
    program.write_text("#!/bin/sh\necho 9.1.0 5.2\n", encoding="utf-8")
    program.chmod(0o755)
    monkeypatch.setenv("COQBIN", str(tmp_path))
    assert command.main(["--build", str(tmp_path / "build")]) == 3
    assert f"{program} is version 9.1.0" in capsys.readouterr().err


def test_table_of_theorems_agrees_with_the_coq_files() -> None:
    named = {name for entry in BY_COQ.values() for name in entry.theorems}
    assert named <= {found.name for found in statements() if found.kind == "Theorem"}
    assert all(entry.theorems or entry.left_out for entry in BY_COQ.values())


def test_every_theorem_of_the_toolkit_has_an_entry() -> None:
    claimed = {theorem.name for theorem in proofs.CLAIMS}
    again = proofs.at_order(proofs.SHOWN)
    assert claimed <= set(BY_COQ) <= claimed | {proof.name for proof in again}
    assert all(proof.scope != ALL_ORDERS and (in_coq(proof).theorems or in_coq(proof).left_out) for proof in again)


# --- runs of Coq ------------------------------------------------------------------------------------------------------


@pytest.fixture
def small(tmp_path: Path) -> Path:
    """Copy the two smallest files with their controls."""
    folder = tmp_path / "proofs"
    folder.mkdir()
    for name in ("Rings.v", "Derivatives.v"):
        shutil.copyfile(FOLDER / name, folder / name)
    (folder / LIST).write_text("-Q . dualcay\nRings.v\nDerivatives.v\n", encoding="utf-8")
    lines = (FOLDER / FILE).read_text(encoding="utf-8").splitlines(keepends=True)
    (folder / FILE).write_text("".join(lines[:13]), encoding="utf-8")
    return folder


def run(folder: Path) -> int:
    return command.main(["--proofs", str(folder), "--build", str(folder.parent / "build")])


@pytest.mark.coq
def test_false_theorem_is_refused_with_its_line(small: Path, capsys: pytest.CaptureFixture[str]) -> None:
    replace(small / "Rings.v", "of_nat (m + n) = of_nat m + of_nat n", "of_nat (m + n) = of_nat m - of_nat n")
    replace(small / FILE, "of_nat m + of_nat n ==> of_nat m - of_nat n", "of_nat m - of_nat n ==> of_nat m + of_nat n")
    assert run(small) == 1
    assert "Rings.v:" in (error := capsys.readouterr().err)
    assert "Coq refuses" in error


@pytest.mark.coq
def test_assumption_is_refused(small: Path, capsys: pytest.CaptureFixture[str]) -> None:
    replace(small / "Derivatives.v", "Section Derivatives.", "Variable free : False.\nSection Derivatives.")
    proof = next(found.proof for found in statements(small) if found.name == "real_part_is_value")
    replace(small / "Derivatives.v", proof, " case free. ")
    assert run(small) == 1
    assert "rests on an assumption: Axioms: Derivatives.free : False" in capsys.readouterr().err.replace("dualcay.", "")


@pytest.mark.coq
@pytest.mark.parametrize(
    ("new", "reason"),
    [
        ("of_nat n + of_nat m", "the altered statement passes"),
        ("of_nat m + )", "the altered statement is not well formed"),
    ],
)
def test_bad_control_is_refused(small: Path, new: str, reason: str) -> None:
    coq = find(small.parent / "build")
    assert [name for name, _ in compiled(coq, small)] == ["Rings.v", "Derivatives.v"]
    assert refused(coq, small) == 13
    assert not list(small.glob("*.vo"))
    replace(small / FILE, "==> of_nat m - of_nat n", f"==> {new}")
    with pytest.raises(MachineError, match=rf"{FILE}:1: of_nat_add: {reason}"):
        refused(coq, small)


@pytest.mark.coq
def test_all_theorems_and_controls(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert command.main(["--build", str(tmp_path)]) == 0
    out = capsys.readouterr().out
    assert out.count("Closed under the global context") > 150
    assert "coqchk: no axioms" in out


# --- emitted programs -------------------------------------------------------------------------------------------------

NUMPY = Path(__file__).parents[2] / "generated" / "dualcay"


@pytest.mark.coq
def test_text_is_proved_and_a_flipped_sign_is_refused(tmp_path: Path) -> None:
    printed(tmp_path / "c", [1])
    kernels = shutil.copytree(NUMPY, tmp_path / "numpy")
    coq = find(tmp_path / "proofs")
    list(compiled(coq))

    def pose(target: str, function: str = "pose") -> str:
        goal = next(g for g in goals(kernels, tmp_path / "c", [1]) if (g.target, g.function) == (target, function))
        return table([prove(goal, coq)])

    assert "numpy" in pose("numpy")
    for path, old in ((kernels / "_geometry.py", "gvv1 - fv3"), (tmp_path / "c" / "geometry.h", "gvv1 - fv3")):
        path.write_text(path.read_text().replace(old, old.replace("-", "+")))
    for target, name in (("numpy", "_geometry.py"), ("c", "geometry.h")):
        with pytest.raises(MachineError, match=rf"{name}:\d+: pose \({target}\) differs .*: pose\[1\]"):
            pose(target)


def test_missing_coq_and_headers_are_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COQBIN", str(tmp_path))
    assert main(["--c", str(tmp_path)]) == 3
    with pytest.raises(MachineError, match=r"cayley1.h"):
        list(goals(NUMPY, tmp_path, [1]))
