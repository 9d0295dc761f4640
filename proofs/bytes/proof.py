"""Proof that the machine code of a function computes what its text says, bit by bit."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from .equality import difference
from .functions import Signature, Source, given
from .machine import Machine
from .program import Program
from .trees import Declined, Different, Tree
from .words import known, signed

ROWS, MORE_ROWS = (0, 1, 2, 3), (4, 8, 9, 17, 35, 67)
APART = 1 << 42  # bytes from an array to the next one, also where strides exceed 32 bits
UPPER = 0x5A5A_5A5A << 32  # half of a register that a branch does not define
BRANCHES, ROW_BRANCHES = range(-9, 10), (0, 1, -1)
EQUAL, DIFFERENT, DECLINED = "equal", "different", "declined"


@dataclass(frozen=True)
class Verdict:
    """Function, whether its machine code equals its text, and the reason if not."""

    name: str
    verdict: str
    reason: str = ""


@dataclass
class Proof:
    """Comparison of the machine code of a chart with its text."""

    source: Source
    program: Program

    def __post_init__(self) -> None:
        self.equality = self.source.equality
        self.machine = Machine(self.program, self.source.trees)

    def verdicts(self, chosen: str = "") -> Iterator[Verdict]:
        """Yield the verdict on each public function whose name contains a text."""
        names = {each.name: each for each in self.source.functions}
        for name, function in names.items():
            rows = name.endswith("_rows") and name.removesuffix("_rows") in names
            if chosen in name:
                yield self.verdict(name, names[name.removesuffix("_rows")] if rows else function, rows)

    def verdict(self, name: str, function: Signature, rows: bool) -> Verdict:
        """Return the verdict on a function, or on its form for rows."""
        self.equality.rebuilt = 0
        try:
            if name not in self.program.functions:
                raise Declined("it is not in the machine code")
            self._prove(name, function, rows)
        except Declined as error:
            return Verdict(name, DECLINED, str(error))
        except Different as error:
            return Verdict(name, DIFFERENT, str(error))
        return Verdict(name, EQUAL)

    def _prove(self, name: str, function: Signature, rows: bool) -> None:
        """Raise `Different` or `Declined` unless all results are equal and each instruction was executed."""
        machine, trees = self.machine, self.source.trees
        machine.executed.clear()
        branches: Iterable[int] = (ROW_BRANCHES if rows else BRANCHES) if function.branched else (0,)
        texts = {branch: self.source.results(function, rows, branch) for branch in branches}
        reached, done = self.program.reached(self.program.functions[name]), dict[tuple[Tree, int], Any]()
        for count in (*ROWS, *MORE_ROWS) if rows else (1,):
            if count > max(ROWS) and reached <= machine.executed:
                break
            for branch, text in texts.items():
                for row, made in enumerate(self._execute(name, function, rows, count, branch)):
                    where = f" of row {row} of {count}" * rows + f", branch {branch}" * (branch != 0)
                    self._compare(function, text, [trees.as_row(each, row, done) for each in made], where)
        if left := reached - machine.executed:
            raise Declined(f"{len(left)} instructions are never executed, such as the one at {min(left):#x}")

    def _execute(self, name: str, function: Signature, rows: bool, count: int, branch: int) -> list[list[Tree]]:
        """Return the results of each row."""
        trees, unit = self.source.trees, self.source.trees.unit
        integers, floats, memory = [count] * rows, list[Tree](), dict[int, Tree]()
        results, base = [list[int]() for _ in range(count)], APART
        for place, each in enumerate(function.parameters):
            stride = (count + 1) * (place + 2) + (count % 2 << 32) if rows else 1
            if not each.size:
                integers.append(branch & 0xFFFF_FFFF | UPPER)
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
                base += APART
        state = self.machine.call(name, integers, floats, memory, {cell for row in results for cell in row})
        made = [[trees.number(state.memory[cell]) for cell in row] for row in results]
        if function.returns:
            word = self.machine.words.part(self.machine.get(state, self.machine.convention.result), 0, 4)
            made[0].append(trees.constant(signed(known(word), 4)))
        return made

    def _compare(self, function: Signature, text: Sequence[Tree], made: Sequence[Tree], where: str) -> None:
        places = [f"{each.name}[{place}]" for each in function.made for place in range(each.size)]
        places += ["the returned integer"] * function.returns
        for place, wanted, found in zip(places, text, made, strict=True):
            if found is self.source.trees.unset:
                raise Different(f"{place}{where} is not stored")
            if not self.equality.equal(wanted, found):
                if part := unknown(found):
                    raise Declined(f"{place}{where}: {part.text()}")
                one, other = (each.text(4) for each in difference(wanted, found))
                reason = f"{place}{where}: {one} in the text, {other} in machine code"
                if wanted.pairs | found.pairs and self.equality.alike_at_samples(wanted, found):
                    raise Declined(f"equal at samples, not proved: {reason}")
                raise Different(reason)


def unknown(tree: Tree) -> Tree | None:
    """Return a part of a tree of which nothing is known."""
    seen, waiting = {tree}, [tree]
    while waiting:
        each = waiting.pop()
        if each.kind in ("unknown", "joined", "part"):
            return each
        new = {part for part in each.parts if isinstance(part, Tree)} - seen
        seen |= new
        waiting += new
    return None
