"""Controls: altered statements of all theorems, which Coq must refuse with the proof of the theorem.

Each line of proofs/controls.txt is ``theorem: old text ==> new text``. One interactive run per file repeats the file
and tries each altered statement just before its theorem. An altered statement must be well formed, its proof must fail,
and the theorem after it must pass.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

from .checker import PROCESSES, Coq
from .statements import FOLDER, CoqTheorem, MachineError, statements, without_comments

FILE = "controls.txt"  # controls, one per line
_LINE = re.compile(r"([\w']+): (.+) ==> (.*)")
_KNOWN = re.compile(r"^Constant (?:\w+\.)*([\w']+)", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class CoqControl:
    theorem: CoqTheorem
    altered: CoqTheorem
    line: int


def controls(folder: Path = FOLDER) -> tuple[CoqControl, ...]:
    """Return all controls; every theorem needs one, and each old text must occur in its theorem."""
    found = {statement.name: statement for statement in statements(folder)}
    result = []
    for number, line in enumerate((folder / FILE).read_text(encoding="utf-8").splitlines(), 1):
        match = _LINE.fullmatch(line)
        theorem = found.get(match[1]) if match else None
        if match is None or theorem is None or match[2] not in " ".join(theorem.claim.split()):
            form = "theorem: old text ==> new text"
            raise MachineError(f"{folder / FILE}:{number}: not a line  {form}  of a theorem: {line}")
        claim = " ".join(theorem.claim.split()).replace(match[2], match[3], 1)
        result.append(CoqControl(theorem, replace(theorem, claim=claim), number))
    without = {name for name, theorem in found.items() if theorem.kind == "Theorem"} - {c.theorem.name for c in result}
    if without:
        raise MachineError(f"{folder / FILE}: no control for theorem {min(without)}")
    return tuple(result)


def refused(coq: Coq, folder: Path = FOLDER) -> int:
    """Return the number of controls, after all of them were refused; otherwise name one that was not."""
    found = controls(folder)
    files = sorted({control.theorem.file for control in found})
    with ThreadPoolExecutor(PROCESSES) as pool:
        batches = [[control for control in found if control.theorem.file == file] for file in files]
        list(pool.map(lambda batch: _refuse(coq, folder, batch), batches))
    return len(found)


def _refuse(coq: Coq, folder: Path, batch: Sequence[CoqControl]) -> None:
    text = without_comments((folder / batch[0].theorem.file).read_text(encoding="utf-8"))
    for index, control in sorted(enumerate(batch), key=lambda item: item[1].theorem.start, reverse=True):
        start, altered = control.theorem.start, control.altered
        attempt = (
            f"Definition statement_{index} {altered.proposition}.\n"
            f"Theorem control_{index} {altered.claim}.\nProof. {altered.proof} Qed.\nAbort All.\n"
        )
        text = text[:start] + attempt + text[start:]
    names = [f"{word}_{index}" for index in range(len(batch)) for word in ("statement", "control")]
    names += [control.theorem.name for control in batch]
    text = "Set Silent.\n" + text + "\nUnset Silent." + "".join(f"\nLocate {name}." for name in names) + "\n"
    result = coq.run("coqtop", "-q", "-quiet", text=text)
    if result.returncode:
        raise MachineError(f"coqtop ended with code {result.returncode} on {batch[0].theorem.file}", 3)
    known = set(_KNOWN.findall(result.stdout))
    for index, control in enumerate(batch):
        where = f"{folder / FILE}:{control.line}: {control.theorem.name}"
        if control.theorem.name not in known:
            raise MachineError(f"{where}: the theorem itself fails after its control")
        if f"statement_{index}" not in known:
            raise MachineError(f"{where}: the altered statement is not well formed")
        if f"control_{index}" in known:
            raise MachineError(f"{where}: the altered statement passes")
