"""Theorems read from Coq files, refused files, and the agreement of docs/theorems.md with them."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from derive.machine import __main__ as command
from derive.machine.coq_controls import FILE, controls
from derive.machine.statements import FOLDER, LIST, MachineError, statements, without_comments
from derive.pages.coq import BY_COQ, in_coq
from derive.proof import __main__ as proofs
from derive.proof.identity import ALL_ORDERS


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
