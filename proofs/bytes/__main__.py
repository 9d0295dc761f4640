"""``python -m proofs.bytes``: prove that machine code computes what the text of C headers says, bit by bit.

Each public function of a chart is compiled, its machine code is executed on symbols, and its results are compared with
those of the emitted text: equal trees of rounded operations give equal bits for all arguments. Integers are not
symbols: arrays lie apart; a batch has 0 to 3 rows, and more until each block of instructions was executed; a branch
has the values -9 to 9, in a batch -1 to 1. The text of a batch is read for one row. Functions of math.h are any
functions. Machine code of x86-64, with AVX too, and of AArch64 is translated by pyvex, whose translation is trusted.

The exit code is 1 if a function differs, and 3 if a compiler or the library cle is missing.
"""

from __future__ import annotations

import argparse
import os
import shlex
import shutil
import sys
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from derive.output import files
from derive.workers import SlowError, run, scratch

from ..statements import MachineError
from .functions import Source, charts
from .program import Program
from .proof import DECLINED, DIFFERENT, EQUAL, Proof, Verdict
from .trees import TYPES, Trees

SECONDS = 600  # of processor time for a compiler
FLAGS = "-std=c99 -O2 -ffp-contract=off"


def compiled(folder: Path, source: Source, real: str, command: Sequence[str], build: Path) -> Path:
    """Compile the public functions of a chart; return the path of the object."""
    file, made = build / "functions.c", build / "functions.o"
    files.write(build, {file.name: source.text})
    _run([*command, f"-I{folder}", f"-DDUALCAY_REAL={real}", "-DDUALCAY_FUNCTION=", "-c", "-o", str(made), str(file)])
    return made


def _run(command: Sequence[str]) -> str:
    if shutil.which(command[0]) is None:
        raise MachineError(f"{command[0]} is missing", 3)
    try:
        done = run(list(command), SECONDS)
    except SlowError as error:
        raise MachineError(f"{command[0]}: {error}") from None
    if done.returncode:
        raise MachineError(f"{' '.join(command)}: {done.stderr.strip()}", 3)
    return done.stdout


def table(found: dict[tuple[str, ...], list[Verdict]]) -> str:
    """Return the counts for each chart and the functions that are not proved, as lines of text."""
    lines = [f"{'chart':14} {'type':7} {EQUAL:>6} {DIFFERENT:>10} {DECLINED:>9}"]
    for (chart, real), verdicts in found.items():
        counts = Counter(each.verdict for each in verdicts)
        lines.append(f"{chart:14} {real:7} {counts[EQUAL]:6} {counts[DIFFERENT]:10} {counts[DECLINED]:9}")
    for verdicts in found.values():
        lines += [f"{each.name}: {each.verdict}: {each.reason}" for each in verdicts if each.reason]
    return "\n".join(lines)


def main(arguments: Sequence[str] | None = None) -> int:
    """Prove the functions of all charts in a folder, and print a table of counts."""
    parser = argparse.ArgumentParser(prog="python -m proofs.bytes", description=(__doc__ or "").partition("\n\n")[0])
    parser.add_argument("folder", type=Path, help="folder of headers, of dualcay generate --target c")
    parser.add_argument("--cc", default=os.environ.get("CC", "gcc"), help="compiler, gcc or clang")
    parser.add_argument("--flags", default=FLAGS, help=f"flags of the compiler, by default {FLAGS!r}")
    parser.add_argument("--real", choices=TYPES, action="append", help="real types, by default double and float")
    parser.add_argument("--chart", action="append", help="charts, by default all in the folder")
    parser.add_argument("--function", default="", help="functions whose names contain this text")
    parser.add_argument("--disassembly", type=Path, help="object, library or program to prove instead")
    chosen = parser.parse_args(arguments)
    sys.setrecursionlimit(100_000)
    found: dict[tuple[str, ...], list[Verdict]] = {}
    try:
        for chart in chosen.chart or charts(chosen.folder):
            for real in chosen.real or TYPES:
                source = Source(chosen.folder, chart, Trees(real))
                with scratch() as build:
                    command = [*shlex.split(chosen.cc), *shlex.split(chosen.flags)]
                    file = chosen.disassembly or compiled(chosen.folder, source, real, command, build)
                    found[chart, real] = list(Proof(source, Program(file)).verdicts(chosen.function))
    except MachineError as error:
        print(f"error: {error}", file=sys.stderr)
        return error.code
    print(table(found))
    return any(each.verdict == DIFFERENT for verdicts in found.values() for each in verdicts)


if __name__ == "__main__":
    sys.exit(main())
