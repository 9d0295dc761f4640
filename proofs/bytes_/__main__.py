"""``python -m proofs.bytes``: prove that machine code computes what the text of C headers says, bit by bit.

Each public function of a chart is compiled, its machine code is executed on symbols, and its results are compared with
those of the emitted text: equal trees of rounded operations give equal bits for all arguments. Integers are not
symbols: arrays lie apart, a batch has the numbers of rows in `ROWS`, and more until each instruction but jumps was
executed; a branch has the values in `BRANCHES`. The text of a batch is read for one row. Functions of math.h are any
functions.

The exit code is 1 if a function differs, and 3 if a compiler or objdump is missing.
"""

from __future__ import annotations

import argparse
import os
import re
import shlex
import shutil
import sys
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from derive.output import files
from derive.workers import SlowError, run, scratch

from .assembly import Listing, read
from .functions import Signature, Source, charts, given
from .machine import Different, Machine
from .rounded import TYPES, Declined, Tree, Trees
from .statements import MachineError

SECONDS = 600  # of processor time for a compiler
FLAGS = "-std=c99 -O2 -ffp-contract=off"
ROWS, MORE_ROWS = (0, 1, 2, 3), (4, 8, 9, 17, 35, 67)
BRANCHES, ROW_BRANCHES = range(-9, 10), (0, 1, -1)
DUMP = ("objdump", "-d", "-s", "-w", "--no-show-raw-insn")
EQUAL, DIFFERENT, DECLINED = "equal", "different", "declined"


@dataclass(frozen=True)
class Verdict:
    """Function, whether its machine code equals its text, and the reason if not."""

    name: str
    verdict: str
    reason: str = ""


def compiled(folder: Path, source: Source, real: str, command: Sequence[str], build: Path) -> str:
    """Compile the public functions of a chart and return the text of objdump."""
    file, made = build / "functions.c", build / "functions.o"
    files.write(build, {file.name: source.text})
    _run([*command, f"-I{folder}", f"-DDUALCAY_REAL={real}", "-DDUALCAY_FUNCTION=", "-c", "-o", str(made), str(file)])
    return disassembled(made, command[0], build)


def disassembled(path: Path, compiler: str, build: Path) -> str:
    """Return the text of objdump: the file itself, or that of a program; an object is linked first."""
    start = path.read_bytes()[:18]
    if start[:4] != b"\x7fELF":
        return path.read_text(encoding="utf-8")
    if start[16] == 1:
        program, rest = build / "functions", build / "main.c"
        files.write(build, {rest.name: "int main(void) { return 0; }\n"})
        _run([compiler, "-o", str(program), str(path), str(rest), "-lm"])
        path = program
    return _run([*DUMP, str(path)])


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


@dataclass
class Proof:
    """Comparison of the machine code of a chart with its text."""

    source: Source
    listing: Listing

    def verdicts(self, chosen: str = "") -> Iterator[Verdict]:
        """Yield the verdict on each public function whose name contains a text."""
        names = {each.name: each for each in self.source.functions}
        for name, function in names.items():
            rows = name.endswith("_rows") and name.removesuffix("_rows") in names
            if chosen in name:
                yield self.verdict(name, names[name.removesuffix("_rows")] if rows else function, rows)

    def verdict(self, name: str, function: Signature, rows: bool) -> Verdict:
        self.source.trees.forget()
        try:
            if name not in self.listing.functions:
                raise Declined("it is not in the machine code")
            self._prove(name, function, rows)
        except Declined as error:
            return Verdict(name, DECLINED, str(error))
        except Different as error:
            return Verdict(name, DIFFERENT, str(error))
        return Verdict(name, EQUAL)

    def _prove(self, name: str, function: Signature, rows: bool) -> None:
        trees = self.source.trees
        machine = Machine(self.listing, trees)
        branches: Iterable[int] = (ROW_BRANCHES if rows else BRANCHES) if function.branched else (0,)
        texts = {branch: self.source.run(function, rows, branch) for branch in branches}
        reached = self.listing.reached(self.listing.functions[name])
        for address in sorted(reached):
            if re.match(r"vfn?m(add|sub)", self.listing.code[address].name):
                fused = self.listing.code[address].text
                raise Different(f"{fused}: a fused multiply-add rounds once where the text rounds twice")
        for count in (*ROWS, *MORE_ROWS) if rows else (1,):
            if count > max(ROWS) and reached <= machine.executed:
                break
            for branch, text in texts.items():
                for row, made in enumerate(self._execute(machine, name, function, rows, count, branch)):
                    where = f" of row {row} of {count}" * rows + f", branch {branch}" * (branch != 0)
                    self._compare(function, text, made, where)
        if left := {each for each in reached - machine.executed if self.listing.code[each].name != "jmp"}:
            raise Declined(f"{len(left)} instructions are never executed, such as {self.listing.code[min(left)].text}")

    def _execute(
        self, machine: Machine, name: str, function: Signature, rows: bool, count: int, branch: int
    ) -> list[list[Tree]]:
        """Return the results of each row, named as those of one row are."""
        trees, unit = self.source.trees, self.source.trees.unit
        integers, floats, memory, names = [count] * rows, list[Tree](), dict[int, Tree](), dict[Tree, Tree]()
        results, base = [list[int]() for _ in range(count)], 0x10_0000
        for place, each in enumerate(function.parameters):
            stride = count + place + 1 if rows else 1
            if not each.size:
                integers.append(branch & 0xFFFF_FFFF)
            elif each.single and not rows:
                floats.append(given(trees, each, 0))
            else:
                integers += [base, *[stride] * rows]
                for row in range(count):
                    cells = [base + (i * stride + row) * unit for i in range(each.size)]
                    if each.made:
                        results[row] += cells
                    else:
                        memory |= {cell: given(trees, each, i, row) for i, cell in enumerate(cells)}
                        names |= {given(trees, each, i, row): given(trees, each, i) for i in range(each.size)}
                base += 0x10_0000
        state = machine.call(name, integers, floats, memory, {cell for row in results for cell in row})
        made = []
        for row, cells in enumerate(results):
            own = {old: new for old, new in names.items() if old.parts[2] == row and row}
            done: dict[Tree, Tree] = {}
            values = (state.memory.get(cell, (0, trees.unset))[1] for cell in cells)
            made.append([trees.renamed(trees.number(value), own, done) for value in values])
        return made

    def _compare(self, function: Signature, text: Sequence[Tree], made: Sequence[Tree], where: str) -> None:
        trees = self.source.trees
        places = (f"{each.name}[{place}]" for each in function.made for place in range(each.size))
        for place, wanted, found in zip(places, text, made, strict=True):
            if found is trees.unset:
                raise Different(f"{place}{where} is not stored")
            if not trees.equal(wanted, found):
                if part := unknown(found):
                    raise Declined(f"{place}{where}: {part.text()}")
                one, other = (each.text() for each in trees.difference(wanted, found))
                reason = f"{place}{where}: {one} in the text, {other} in machine code"
                if wanted.pairs | found.pairs and trees.sample(wanted).tobytes() == trees.sample(found).tobytes():
                    raise Declined(f"equal at samples, not proved: {reason}")
                raise Different(reason)


def unknown(tree: Tree) -> Tree | None:
    """Return a part of a tree of which nothing is known."""
    seen, waiting = {tree}, [tree]
    while waiting:
        each = waiting.pop()
        if each.kind == "unknown":
            return each
        new = {part for part in each.parts if isinstance(part, Tree)} - seen
        seen |= new
        waiting += new
    return None


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
    parser.add_argument("--disassembly", type=Path, help="object, program or text of objdump to prove instead")
    chosen = parser.parse_args(arguments)
    sys.setrecursionlimit(100_000)
    found: dict[tuple[str, ...], list[Verdict]] = {}
    try:
        for chart in chosen.chart or charts(chosen.folder):
            for real in chosen.real or TYPES:
                source = Source(chosen.folder, chart, Trees(real))
                with scratch() as build:
                    command = [*shlex.split(chosen.cc), *shlex.split(chosen.flags)]
                    text = (disassembled(chosen.disassembly, command[0], build) if chosen.disassembly
                            else compiled(chosen.folder, source, real, command, build))  # fmt: skip
                found[chart, real] = list(Proof(source, read(text)).verdicts(chosen.function))
    except MachineError as error:
        print(f"error: {error}", file=sys.stderr)
        return error.code
    print(table(found))
    return any(each.verdict == DIFFERENT for verdicts in found.values() for each in verdicts)


if __name__ == "__main__":
    sys.exit(main())
