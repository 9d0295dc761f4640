"""Coq found and run: files compiled, assumptions of all theorems printed, compiled files checked again by coqchk."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from derive import workers

from .statements import FOLDER, CoqTheorem, MachineError, listed

FIRST, LAST = (8, 16), (8, 20)  # versions of Coq that are accepted
SECONDS = 240  # of processor time for one file, forty times that of most of them
PROCESSES = 2  # runs of Coq or Gappa at once
CLOSED = "Closed under the global context"  # Coq's words for a theorem without assumptions
_WANTED = f"Coq {'.'.join(map(str, FIRST))} to {'.'.join(map(str, LAST))}"
_HOW = "install it with  apt-get install coq  or name the folder of coqc in the variable COQBIN"


@dataclass(frozen=True, slots=True)
class Coq:
    """Programs of one installed Coq, and the folder of compiled files."""

    programs: Path
    version: str
    build: Path

    def run(self, program: str, *arguments: str, text: str | None = None) -> subprocess.CompletedProcess[str]:
        """Run a program of Coq in the folder of compiled files, with `text` as its input."""
        command = [str(self.programs / program), *arguments, "-Q", ".", "dualcay"]
        try:
            return workers.run(command, SECONDS, cwd=self.build, input=text)
        except workers.SlowError as error:
            raise MachineError(f"{error}: {' '.join(arguments)}") from None

    def compile(self, name: str) -> str:
        """Compile one file and return what it prints; a refusal names file, line and reason."""
        result = self.run("coqc", "-q", name)
        if result.returncode:
            place = re.search(r'File "\./([^"]+)", line (\d+)[^\n]*\n(.*)', result.stderr, re.DOTALL)
            where, what = (f"{place[1]}:{place[2]}", place[3]) if place else (name, result.stderr)
            raise MachineError(f"{where}: Coq refuses: {' '.join(what.split())}")
        return result.stdout


def find(build: Path) -> Coq:
    """Return the installed Coq, if its version is accepted."""
    folder = os.environ.get("COQBIN")
    program = shutil.which("coqc", path=folder or None)
    if program is None:
        raise MachineError(f"{_WANTED} is needed, and no coqc is {f'in {folder}' if folder else 'found'}: {_HOW}", 3)
    printed = subprocess.run([program, "--print-version"], capture_output=True, text=True, check=False).stdout
    numbers = re.match(r"(\d+)\.(\d+)", printed)
    version = (printed.split() or ["unknown"])[0]
    if numbers is None or not FIRST <= (int(numbers[1]), int(numbers[2])) <= LAST:
        raise MachineError(f"{_WANTED} is needed, and {program} is version {version}: {_HOW}", 3)
    return Coq(Path(program).parent, version, build)


def compiled(coq: Coq, folder: Path = FOLDER) -> Iterator[tuple[str, float]]:
    """Compile copies of all files in the folder for compiled files; yield names and seconds."""
    coq.build.mkdir(parents=True, exist_ok=True)
    for name in listed(folder):
        shutil.copyfile(folder / name, coq.build / name)
        begin = time.perf_counter()
        coq.compile(name)
        yield name, time.perf_counter() - begin


def assumed(coq: Coq, found: Iterable[CoqTheorem]) -> dict[str, str]:
    """Return by theorem what `Print Assumptions` prints; refuse any assumption."""
    names = [f"{statement.file[:-2]}.{statement.name}" for statement in found]
    files = dict.fromkeys(name.split(".")[0] for name in names)
    lines = [f"From dualcay Require {file}." for file in files] + [f"Print Assumptions {name}." for name in names]
    (coq.build / "Assumptions.v").write_text("\n".join([*lines, ""]), encoding="utf-8")
    printed = re.split(rf"^(?={CLOSED}|Axioms:)", coq.compile("Assumptions.v"), flags=re.MULTILINE)[1:]
    result = dict(zip(names, (" ".join(text.split()) for text in printed), strict=True))
    for name, text in result.items():
        if text != CLOSED:
            raise MachineError(f"theorem {name} rests on an assumption: {text}")
    return result


def rechecked(coq: Coq, folder: Path = FOLDER) -> None:
    """Check all compiled files again with coqchk, which shares only the kernel with coqc."""
    result = coq.run("coqchk", "-silent", "-o", *(f"dualcay.{name[:-2]}" for name in listed(folder)))
    text = " ".join((result.stdout + result.stderr).split())
    if result.returncode or "* Axioms: <none>" not in text:
        raise MachineError(f"coqchk refuses: {text}")
