"""Schedule a program and place every value: few registers, each used again as soon as its value is dead.

A statement is a named step together with the inline steps below it, evaluated left to right; an output that has no
name is a statement of its own.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property

from .program import Operand, Program, Step

MASK_OPS = frozenset({"lt", "eq", "and", "or"})
"""Operations whose value is a truth mask."""


@dataclass(frozen=True, slots=True)
class Placement:
    """Statements in their order, the place of every value, and outputs which are copies of what stands elsewhere.

    Places are ``("k", i)`` number registers, ``("mask", i)`` mask registers and ``("o", i)`` outputs, from 1 on.
    """

    statements: tuple[Step, ...]
    places: Mapping[str, tuple[str, int]]
    copies: tuple[tuple[Operand, int], ...]
    registers: int
    masks: int


def place(program: Program) -> Placement:
    """Schedule a program and allocate its registers."""
    return _Allocator(program).run()


@dataclass(slots=True)
class _Bank:
    """Registers of one kind; the lowest free one is taken first."""

    size: int = 0
    free: list[int] = field(default_factory=list)

    def take(self) -> int:
        if self.free:
            self.free.sort()
            return self.free.pop(0)
        self.size += 1
        return self.size


class _Allocator:
    def __init__(self, program: Program) -> None:
        self.program = program
        self.steps = {step.name: step for step in program.steps}
        self.places: dict[str, tuple[str, int]] = {}
        self.banks = {"k": _Bank(), "mask": _Bank()}
        self.copies: list[tuple[Operand, int]] = []
        for index, output in enumerate(program.outputs, 1):
            if output in self.steps and output not in self.places:
                self.places[str(output)] = ("o", index)
            else:
                self.copies.append((output, index))

    def run(self) -> Placement:
        reads = Counter(arg for step in self.program.steps for arg in step.args if isinstance(arg, str))
        for statement in self.schedule:
            self._evaluate(statement, reads)
        sizes = {kind: bank.size for kind, bank in self.banks.items()}
        return Placement(self.schedule, self.places, tuple(self.copies), sizes["k"], sizes["mask"])

    @cached_property
    def schedule(self) -> tuple[Step, ...]:
        """Statements in order: always the one that leaves the fewest values alive, the first in depth among equals."""
        waiting = list(self._depth_first())
        leaves = {name: Counter(self._leaves(name)) for name in waiting}
        reads = sum(leaves.values(), Counter[str]())

        def growth(name: str) -> int:
            freed = sum(reads[leaf] == count for leaf, count in leaves[name].items() if leaf not in self.places)
            return (name not in self.places) - freed

        order: dict[str, Step] = {}
        while waiting:
            name = min((name for name in waiting if order.keys() >= leaves[name].keys()), key=growth)
            waiting.remove(name)
            reads.subtract(leaves[name])
            order[name] = self.steps[name]
        return tuple(order.values())

    def _depth_first(self) -> Iterator[str]:
        """Statements after what they read, from output to output; the operand that needs most registers first."""
        seen: set[str] = set()

        def visit(name: str) -> Iterator[str]:
            if name not in seen:
                seen.add(name)
                for leaf in sorted(self._leaves(name), key=self._need, reverse=True):
                    yield from visit(leaf)
                yield name

        for output in self.program.outputs:
            if output in self.steps:
                yield from visit(str(output))

    def _leaves(self, name: str) -> Iterator[str]:
        """Statements that a statement reads, in the order of the text."""
        for arg in self.steps[name].args:
            if isinstance(arg, str) and arg in self.steps:
                if self.steps[arg].inline and arg not in self.places:
                    yield from self._leaves(arg)
                else:
                    yield arg

    def _need(self, name: str) -> int:
        """Registers a statement takes when nothing it reads stands yet (Sethi and Ullman's number, of a tree)."""
        if name not in self._needs:
            needs = sorted(map(self._need, self._leaves(name)), reverse=True)
            self._needs[name] = max([1, *(held + need for held, need in enumerate(needs))])
        return self._needs[name]

    @cached_property
    def _needs(self) -> dict[str, int]:
        return {}

    def _evaluate(self, step: Step, reads: Counter[str]) -> None:
        """Place the inline steps below a step, left to right, then its own value where an operand died if it can."""
        for arg in step.args:
            if isinstance(arg, str) and arg in self.steps and arg not in self.places:
                self._evaluate(self.steps[arg], reads)
        # a selection writes over its second operand at most: its last one is read once more after the first write
        kept = step.args[2] if step.op == "where" else None
        self._release([arg for arg in step.args if arg != kept], reads)
        if step.name not in self.places:
            kind = "mask" if step.op in MASK_OPS else "k"
            self.places[step.name] = (kind, self.banks[kind].take())
        if kept is not None:
            self._release([kept], reads)

    def _release(self, args: list[Operand], reads: Counter[str]) -> None:
        for arg in args:
            if isinstance(arg, str) and arg in self.steps:
                reads[arg] -= 1
                kind, index = self.places[arg]
                if not reads[arg] and kind != "o":
                    self.banks[kind].free.append(index)
