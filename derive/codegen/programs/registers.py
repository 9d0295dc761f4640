"""Schedule a program and place every value: few registers, each used again as soon as its value is dead.

A statement is a call, or a named step together with the inline steps below it, evaluated left to right; an output that
has no name is a statement of its own.
"""

from __future__ import annotations

import itertools
import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from .program import Call, Operand, Program, Statement, Step

MASK_OPS = frozenset({"lt", "eq", "and", "or"})
"""Operations whose value is a truth mask."""

Place = tuple[str, int]


@dataclass(frozen=True, slots=True)
class Placement:
    """Statements in their order, the place of every value, and outputs which are copies of what stands elsewhere.

    Places are ``("k", i)`` number registers, ``("mask", i)`` mask registers and ``("o", i)`` outputs, from 1 on.
    ``free`` are the registers that a call, known by its first result, finds unused.
    """

    statements: tuple[Statement, ...]
    places: Mapping[str, Place]
    copies: tuple[tuple[Operand, int], ...]
    registers: int
    masks: int
    free: Mapping[str, tuple[Place, ...]]


def place(program: Program) -> Placement:
    """Schedule a program and allocate its registers."""
    return _best(program, _outputs(program))


def place_returned(program: Program) -> Placement:
    """The same for a program that may use the places of its results as registers before it writes them."""
    found = _best(program, {})
    steps = {output for output in program.outputs if output in found.places}
    ends = {found.places[str(output)]: ("o", program.outputs.index(output) + 1) for output in steps}
    others = {index for kind, index in found.places.values() if kind == "k" and ("k", index) not in ends}
    moved = {("k", index): ("k", new) for new, index in enumerate(sorted(others), 1)} | ends
    places = {name: moved.get(place, place) for name, place in found.places.items()}
    return replace(found, places=places, registers=len(others), copies=_copied(program, places))


def _best(program: Program, fixed: Mapping[str, Place]) -> Placement:
    """The way that needs fewest registers: outputs asked for in either order, calls made early or late."""
    ways = itertools.product((program.outputs, program.outputs[::-1]), (True, False) if program.calls else (True,))
    return min((_Allocator(program, fixed, *way).run() for way in ways), key=lambda found: found.registers)


def _outputs(program: Program) -> dict[str, Place]:
    """The places of what a program computes for its results, each at its first."""
    made = {name for statement in program.statements for name in results(statement)}
    indices = {str(o): index for index, o in reversed(list(enumerate(program.outputs, 1))) if o in made}
    return {name: ("o", index) for name, index in indices.items()}


def _copied(program: Program, places: Mapping[str, Place]) -> tuple[tuple[Operand, int], ...]:
    """Outputs that stand elsewhere than in their own place."""
    numbered = enumerate(program.outputs, 1)
    return tuple((output, index) for index, output in numbered if places.get(str(output)) != ("o", index))


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


def results(statement: Statement) -> tuple[str, ...]:
    """The names a statement gives values to."""
    return (statement.name,) if isinstance(statement, Step) else tuple(n for n in statement.names if n != "_")


def all_results(call: Call) -> tuple[str, ...]:
    """A name for every result of a call, those which are not read too: they need a place as well."""
    first = results(call)[0]
    return tuple(f"{first}_{i}" if name == "_" else name for i, name in enumerate(call.names))


class _Allocator:
    def __init__(self, program: Program, fixed: Mapping[str, Place], asked: Sequence[Operand], eager: bool) -> None:
        self.program = program
        self.asked = asked
        self.eager = eager
        self.makers = {name: statement for statement in program.statements for name in results(statement)}
        self.places: dict[str, Place] = dict(fixed)
        self.banks = {"k": _Bank(), "mask": _Bank()}
        self.free: dict[str, tuple[Place, ...]] = {}

    def run(self) -> Placement:
        read = Counter(arg for s in self.program.statements for arg in s.args if isinstance(arg, str))
        reads = read + Counter(output for output in self.program.outputs if isinstance(output, str))
        for statement in self.schedule:
            self._evaluate(statement, reads)
        sizes = {kind: bank.size for kind, bank in self.banks.items()}
        copies = _copied(self.program, self.places)
        return Placement(self.schedule, self.places, copies, sizes["k"], sizes["mask"], self.free)

    @cached_property
    def schedule(self) -> tuple[Statement, ...]:
        """Statements in order: always the one that leaves the fewest values alive, the first in depth among equals."""
        waiting = list(self._depth_first())
        leaves = {name: Counter(self._leaves(name)) for name in waiting}
        reads = Counter(itertools.chain.from_iterable(counted.elements() for counted in leaves.values()))

        def growth(name: str) -> float:
            if self.eager and isinstance(self.makers[name], Call):
                return -math.inf
            freed = sum(reads[leaf] == count for leaf, count in leaves[name].items() if leaf not in self.places)
            return sum(result not in self.places for result in results(self.makers[name])) - freed

        done: set[str] = set()
        order: list[Statement] = []
        while waiting:
            name = min((name for name in waiting if done.issuperset(leaves[name])), key=growth)
            waiting.remove(name)
            reads.subtract(leaves[name])
            done.update(results(self.makers[name]))
            order.append(self.makers[name])
        return tuple(order)

    def _depth_first(self) -> Iterator[str]:
        """Statements, by their first result, after what they read; the operand that needs most registers first."""
        seen: set[str] = set()

        def visit(name: str) -> Iterator[str]:
            first = results(self.makers[name])[0]
            if first not in seen:
                seen.add(first)
                for leaf in sorted(self._leaves(first), key=self._need, reverse=True):
                    yield from visit(leaf)
                yield first

        for output in self.asked:
            if output in self.makers:
                yield from visit(str(output))

    def _leaves(self, name: str) -> Iterator[str]:
        """Values that a statement reads, in the order of the text."""
        for arg in self.makers[name].args:
            if isinstance(arg, str) and arg in self.makers:
                if self._inline(arg) and arg not in self.places:
                    yield from self._leaves(arg)
                else:
                    yield arg

    def _inline(self, name: str) -> bool:
        maker = self.makers[name]
        return isinstance(maker, Step) and maker.inline

    def _need(self, name: str) -> int:
        """Registers a statement takes when nothing it reads stands yet (Sethi and Ullman's number, of a tree)."""
        if name not in self._needs:
            needs = sorted(map(self._need, self._leaves(name)), reverse=True)
            least = len(results(self.makers[name]))
            self._needs[name] = max([least, *(held + need for held, need in enumerate(needs))])
        return self._needs[name]

    @cached_property
    def _needs(self) -> dict[str, int]:
        return {}

    def _evaluate(self, statement: Statement, reads: Counter[str]) -> None:
        """Place the inline steps below a statement, left to right, then what it makes itself."""
        for arg in statement.args:
            if isinstance(arg, str) and arg in self.makers and arg not in self.places:
                self._evaluate(self.makers[arg], reads)
        if isinstance(statement, Call):
            self._place_call(statement, reads)
        else:
            self._place_step(statement, reads)

    def _place_step(self, step: Step, reads: Counter[str]) -> None:
        """A value takes the place of an operand that dies if it can."""
        # a selection writes over its second operand at most: its last one is read once more after the first write
        kept = step.args[2] if step.op == "where" else None
        self._release([arg for arg in step.args if arg != kept], reads)
        self._take(step.name, step.op in MASK_OPS)
        if kept is not None:
            self._release([kept], reads)

    def _place_call(self, call: Call, reads: Counter[str]) -> None:
        """Results stand apart from the arguments, which are read while they are written; what is free is lent."""
        for name in all_results(call):
            self._take(name, name in call.truths)
        lent = [(kind, index) for kind, bank in self.banks.items() for index in sorted(bank.free)]
        self.free[results(call)[0]] = tuple(lent)
        self._release(list(call.args), reads)
        for name in set(all_results(call)) - set(results(call)):
            kind, index = self.places[name]
            self.banks[kind].free.append(index)

    def _take(self, name: str, truth: bool) -> None:
        if name not in self.places:
            kind = "mask" if truth else "k"
            self.places[name] = (kind, self.banks[kind].take())

    def _release(self, args: list[Operand], reads: Counter[str]) -> None:
        for arg in args:
            if isinstance(arg, str) and arg in self.makers:
                reads[arg] -= 1
                kind, index = self.places[arg]
                if not reads[arg] and kind != "o":
                    self.banks[kind].free.append(index)
