"""``python -m proofs.bytes``: prove that machine code computes what the text of C headers says, bit by bit.

Each public function of a chart is compiled, its machine code is executed on symbols, and its results are compared with
those of the emitted text: equal trees of rounded operations give equal bits for all arguments. Integers are not
symbols: arrays lie apart; a batch has 0 to 3 rows, and more until each instruction was executed; a branch
has the values -9 to 9, in a batch -1 to 1. The text of a batch is read for one row. Functions of math.h are any
functions. Machine code of x86-64 and AArch64 is translated by pyvex, whose translation is trusted.

The exit code is 1 if a function differs, 2 if a file is no machine code or no function is found, 3 if a compiler or the
library cle is missing.
"""

from __future__ import annotations

import argparse
import os
import shlex
import shutil
import sys
from collections import Counter
from collections.abc import Sequence
from itertools import product
from pathlib import Path

from derive.codegen.build import relaxed_gc
from derive.output import files
from derive.workers import SlowError, run, scratch

from ..statements import MachineError
from .functions import Source, charts
from .program import Program
from .proof import DECLINED, DIFFERENT, EQUAL, Proof, Verdict
from .trees import TYPES, Trees

SECONDS = 600  # of processor time for a compiler
FLAGS = "-std=c99 -O2 -ffp-contract=off"
HEAD = ("chart", "type", "compiler", "functions", EQUAL, DIFFERENT, DECLINED)
MARK = "<!-- bytes -->"


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


def row(*cells: object) -> str:
    """Return the cells as a row of a table in Markdown."""
    return f"| {' | '.join(map(str, cells))} |"


def counts(verdicts: Sequence[Verdict]) -> list[int]:
    found = Counter(each.verdict for each in verdicts)
    return [len(verdicts), found[EQUAL], found[DIFFERENT], found[DECLINED]]


def put(page: Path, lines: Sequence[str]) -> None:
    """Put lines between the marks of a page."""
    before, start, rest = page.read_text(encoding="utf-8").partition(f"{MARK}\n")
    _, end, after = rest.partition(f"\n{MARK}")
    if not start or not end:
        raise MachineError(f"{page}: expected two lines {MARK}", 2)
    files.write(page.parent, {page.name: "\n".join([before + start, *lines, end + after])}, force=True)


def main(arguments: Sequence[str] | None = None) -> int:
    """Prove the functions of all charts in a folder, and print a table of counts."""
    parser = argparse.ArgumentParser(prog="python -m proofs.bytes", description=(__doc__ or "").partition("\n\n")[0])
    parser.add_argument("folder", type=Path, help="folder of headers, of dualcay generate --target c")
    parser.add_argument("--cc", action="append", help="compilers such as gcc and clang, by default $CC or gcc")
    parser.add_argument("--flags", default=FLAGS, help=f"flags of the compiler, by default {FLAGS!r}")
    parser.add_argument("--real", choices=TYPES, action="append", help="real types, by default double and float")
    parser.add_argument("--chart", action="append", help="charts, by default all in the folder")
    parser.add_argument("--function", default="", help="functions whose names contain this text")
    parser.add_argument("--disassembly", type=Path, help="object, library or program to prove instead")
    parser.add_argument("-o", "--output", type=Path, help=f"page that takes the table between two lines {MARK}")
    chosen = parser.parse_args(arguments)
    sys.setrecursionlimit(100_000)  # trees are deep
    lines, reasons, total = [row(*HEAD), row(*["---"] * len(HEAD))], list[str](), list[Verdict]()
    print(*lines, sep="\n")
    try:
        with relaxed_gc():
            for chart, real in product(chosen.chart or charts(chosen.folder), chosen.real or TYPES):
                source = Source(chosen.folder, chart, Trees(real))
                for compiler in chosen.cc or [os.environ.get("CC", "gcc")]:
                    found = _proved(chosen, source, compiler, real)
                    total += found
                    lines.append(row(chart, real, compiler, *counts(found)))
                    print(lines[-1], flush=True)
                    where = f"{compiler}, {real}"
                    reasons += [f"{where}, {each.name}: {each.verdict}: {each.reason}" for each in found if each.reason]
        if not total:
            raise MachineError(f"{chosen.folder}: no header with a function whose name contains {chosen.function!r}", 2)
        lines.append(row("all", "", "", *counts(total)))
        print(lines[-1], *reasons, sep="\n")
        if chosen.output:
            put(chosen.output, lines)
    except MachineError as error:
        print(f"error: {error}", file=sys.stderr)
        return error.code
    return any(each.verdict == DIFFERENT for each in total)


def _proved(chosen: argparse.Namespace, source: Source, compiler: str, real: str) -> list[Verdict]:
    with scratch() as build:
        command = [*shlex.split(compiler), *shlex.split(chosen.flags)]
        file = chosen.disassembly or compiled(chosen.folder, source, real, command, build)
        return list(Proof(source, Program(file)).verdicts(chosen.function))


if __name__ == "__main__":
    sys.exit(main())
