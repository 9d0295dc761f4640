"""Theorems of the Coq files: statements, proof scripts and places, and words that would leave a gap."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).parent  # Coq files of a checkout
LIST = "_CoqProject"  # file that lists the Coq files in the order in which they are compiled
_GAP = re.compile(r"\b(Admitted|admit|Axioms?|Parameters?|Conjecture|give_up|bypass_check)\b|\bUnset\s+\w+ Checking\b")
_THEOREM = re.compile(r"\b(Theorem|Lemma)\s+([\w']+)(.*?)\.\s+Proof\.(.*?)\bQed\.", re.DOTALL)


class MachineError(Exception):
    """Error of a check by Coq or Gappa, with its exit code: 1 if a proof is refused, 3 if the checker cannot run."""

    def __init__(self, message: str, code: int = 1) -> None:
        super().__init__(message)
        self.code = code


@dataclass(frozen=True, slots=True)
class CoqTheorem:
    """Theorem or lemma of a Coq file: its binders and claim, its proof script, and where it begins."""

    file: str
    kind: str
    name: str
    claim: str
    proof: str
    start: int

    @property
    def proposition(self) -> str:
        """Binders, then the claim as a definition's value."""
        depth = 0
        for at, letter in enumerate(self.claim):
            depth += (letter in "({[") - (letter in ")}]")
            if letter == ":" and not depth:
                return f"{self.claim[:at]} : Prop := {self.claim[at + 1 :]}"
        raise MachineError(f"{self.file}: theorem {self.name} has no colon before its claim")


def listed(folder: Path = FOLDER) -> tuple[str, ...]:
    """Return the names of the Coq files in the order of compilation."""
    try:
        lines = (folder / LIST).read_text(encoding="utf-8").splitlines()
    except OSError as error:
        raise MachineError(f"no Coq files: {folder / LIST} cannot be read ({error.strerror})", 3) from None
    names = tuple(line for line in lines if line.endswith(".v"))
    missing = [name for name in names if not (folder / name).is_file()]
    if missing:
        raise MachineError(f"{folder / missing[0]} is missing, although {LIST} lists it")
    return names


def statements(folder: Path = FOLDER) -> tuple[CoqTheorem, ...]:
    """Return all theorems and lemmas; their names must differ, and no file may leave a gap."""
    found = tuple(found for name in listed(folder) for found in _in_file(folder / name))
    places: dict[str, str] = {}
    for statement in found:
        if statement.name in places:
            raise MachineError(f"theorem {statement.name} stands in {places[statement.name]} and in {statement.file}")
        places[statement.name] = statement.file
    return found


def without_comments(text: str) -> str:
    """Return Coq text with comments, which nest, replaced by blanks; lines keep their numbers."""
    kept, depth = [], 0
    for part in re.split(r"(\(\*|\*\))", text):
        depth -= part == "*)" and depth > 0
        kept.append(re.sub(r"[^\n]", " ", part) if depth or part == "*)" else part)
        if part == "(*":
            depth += 1
            kept[-1] = "  "
    return "".join(kept)


def _in_file(path: Path) -> Iterator[CoqTheorem]:
    text = without_comments(path.read_text(encoding="utf-8"))
    if gap := _GAP.search(text):
        line = text.count("\n", 0, gap.start()) + 1
        raise MachineError(f"{path}:{line}: '{gap[0]}' leaves a gap in a proof; prove the statement instead")
    for match in _THEOREM.finditer(text):
        kind, name, claim, proof = match.groups()
        yield CoqTheorem(path.name, kind, name, claim, proof, match.start())
