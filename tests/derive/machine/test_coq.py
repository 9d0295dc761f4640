"""Coq run on proofs/ and on emitted programs: wrong proofs, assumptions, altered texts, idle controls are refused."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from derive.machine import __main__ as command
from derive.machine.bridge import main, prove, table
from derive.machine.checker import compiled, find
from derive.machine.coq_controls import FILE, refused
from derive.machine.emitted import printed
from derive.machine.goals import goals
from derive.machine.statements import FOLDER, LIST, MachineError, statements


@pytest.fixture
def copied(tmp_path: Path) -> Path:
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


def edit(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


@pytest.mark.coq
def test_false_theorem_is_refused_with_its_line(copied: Path, capsys: pytest.CaptureFixture[str]) -> None:
    edit(copied / "Rings.v", "of_nat (m + n) = of_nat m + of_nat n", "of_nat (m + n) = of_nat m - of_nat n")
    edit(copied / FILE, "of_nat m + of_nat n ==> of_nat m - of_nat n", "of_nat m - of_nat n ==> of_nat m + of_nat n")
    assert run(copied) == 1
    assert "Rings.v:" in (error := capsys.readouterr().err)
    assert "Coq refuses" in error


@pytest.mark.coq
def test_assumption_is_refused(copied: Path, capsys: pytest.CaptureFixture[str]) -> None:
    edit(copied / "Derivatives.v", "Section Derivatives.", "Variable free : False.\nSection Derivatives.")
    proof = next(found.proof for found in statements(copied) if found.name == "real_part_is_value")
    edit(copied / "Derivatives.v", proof, " case free. ")
    assert run(copied) == 1
    assert "rests on an assumption: Axioms: Derivatives.free : False" in capsys.readouterr().err.replace("dualcay.", "")


@pytest.mark.coq
@pytest.mark.parametrize(
    ("new", "reason"),
    [
        ("of_nat n + of_nat m", "the altered statement passes"),
        ("of_nat m + )", "the altered statement is not well formed"),
    ],
)
def test_bad_control_is_refused(copied: Path, new: str, reason: str) -> None:
    coq = find(copied.parent / "build")
    assert [name for name, _ in compiled(coq, copied)] == ["Rings.v", "Derivatives.v"]
    assert refused(coq, copied) == 13
    assert not list(copied.glob("*.vo"))
    edit(copied / FILE, "==> of_nat m - of_nat n", f"==> {new}")
    with pytest.raises(MachineError, match=rf"{FILE}:1: of_nat_add: {reason}"):
        refused(coq, copied)


@pytest.mark.coq
def test_all_theorems_and_controls(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert command.main(["--build", str(tmp_path)]) == 0
    out = capsys.readouterr().out
    assert out.count("Closed under the global context") > 150
    assert "coqchk: no axioms" in out


# --- emitted programs -------------------------------------------------------------------------------------------------

NUMPY = Path(__file__).parents[3] / "generated" / "dualcay"


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
