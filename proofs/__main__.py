"""``python -m proofs``: check the theorems of proofs/ with Coq, and see that altered statements are refused.

The exit code is 1 if Coq refuses a proof or accepts a control, and 3 if Coq is missing or of another version.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from .checker import CLOSED, assumed, compiled, find, rechecked
from .coq_controls import controls, refused
from .statements import FOLDER, MachineError, statements

BUILD = FOLDER.parent / "build" / "machine"  # folder of compiled files


def main(arguments: Sequence[str] | None = None) -> int:
    """Check all theorems and controls; print seconds per file and the assumptions of every theorem."""
    parser = argparse.ArgumentParser(prog="python -m proofs", description="Check proofs/ with Coq.")
    parser.add_argument("--proofs", type=Path, default=FOLDER, help="folder of Coq files")
    parser.add_argument("--build", type=Path, default=BUILD, help="folder of compiled files")
    options = parser.parse_args(arguments)
    try:
        check(options.proofs, options.build)
    except MachineError as error:
        print(error, file=sys.stderr)
        return error.code
    return 0


def check(folder: Path, build: Path) -> None:
    """Check texts, then proofs, assumptions and compiled files, then controls."""
    begin = time.perf_counter()
    found = statements(folder)
    controls(folder)
    coq = find(build)
    print(f"Coq {coq.version}, {len(found)} theorems and lemmas")
    for name, seconds in compiled(coq, folder):
        lines = (folder / name).read_text(encoding="utf-8").count("\n")
        print(f"{name:18} {lines:4} lines {seconds:6.1f} s", flush=True)
    for name in assumed(coq, found):
        print(f"{name}: {CLOSED}")
    rechecked(coq, folder)
    print("coqchk: no axioms", flush=True)
    print(f"{refused(coq, folder)} controls refused; {time.perf_counter() - begin:.0f} s in all")


if __name__ == "__main__":
    sys.exit(main())
