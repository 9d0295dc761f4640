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
    flow = _Flow(program, fixed)
    return min((_Allocator(flow, *way).run() for way in ways), key=lambda found: found.registers)


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


class _Flow:
    """What the statements of a program read of one another, in whatever order they stand; each by its first result."""

    def __init__(self, program: Program, fixed: Mapping[str, Place]) -> None:
        self.program = program
        self.fixed = fixed
        self.makers = {name: statement for statement in program.statements for name in results(statement)}
        self._leaves: dict[str, tuple[str, ...]] = {}
        self._needs: dict[str, int] = {}

    def first(self, name: str) -> str:
        """The first result of the statement that makes a value."""
        return results(self.makers[name])[0]

    def leaves(self, name: str) -> tuple[str, ...]:
        """Values that a statement reads, in the order of the text."""
        if name not in self._leaves:
            self._leaves[name] = tuple(self._read(self.makers[name]))
        return self._leaves[name]

    def _read(self, statement: Statement) -> Iterator[str]:
        for arg in statement.args:
            if isinstance(arg, str) and (maker := self.makers.get(arg)):
                if isinstance(maker, Step) and maker.inline and arg not in self.fixed:
                    yield from self.leaves(arg)
                else:
                    yield arg

    def need(self, name: str) -> int:
        """Registers a statement takes when nothing it reads stands yet (Sethi and Ullman's number, of a tree)."""
        if name not in self._needs:
            needs = sorted(map(self.need, self.leaves(name)), reverse=True)
            least = len(results(self.makers[name]))
            self._needs[name] = max([least, *(held + need for held, need in enumerate(needs))])
        return self._needs[name]

    def depth_first(self, asked: Sequence[Operand]) -> Sequence[str]:
        """Statements after what they read; the operand that needs most registers first."""
        order: dict[str, None] = {}

        def visit(name: str) -> None:
            if (first := self.first(name)) not in order:
                for leaf in sorted(self.leaves(first), key=self.need, reverse=True):
                    visit(leaf)
                order[first] = None

        for output in asked:
            if output in self.makers:
                visit(str(output))
        return tuple(order)

    @cached_property
    def counts(self) -> Mapping[str, Counter[str]]:
        """How often each statement reads each value."""
        return {name: Counter(self.leaves(name)) for name in self.depth_first(self.program.outputs)}

    @cached_property
    def readers(self) -> Mapping[str, Sequence[str]]:
        """The statements that read each value."""
        found: dict[str, list[str]] = {}
        for name, leaves in self.counts.items():
            for leaf in leaves:
                found.setdefault(leaf, []).append(name)
        return found

    @cached_property
    def reads(self) -> Counter[str]:
        """How often each value is read, by statements and as an output."""
        read = (arg for statement in self.program.statements for arg in statement.args)
        return Counter(arg for arg in itertools.chain(read, self.program.outputs) if isinstance(arg, str))


class _Schedule:
    """An order of statements, found step by step: always the one that leaves the fewest values alive.

    Among equals it is the first in depth. What a statement would leave is computed again when that changes only.
    """

    def __init__(self, flow: _Flow, asked: Sequence[Operand], eager: bool) -> None:
        self.flow = flow
        self.eager = eager
        self.waiting = flow.depth_first(asked)
        self.left = Counter(leaf for counted in flow.counts.values() for leaf in counted.elements())
        self.missing = {name: len(leaves) for name, leaves in flow.counts.items()}

    def order(self) -> Iterator[Statement]:
        position = {name: place for place, name in enumerate(self.waiting)}
        growth = {name: self._growth(name) for name in self.waiting if not self.missing[name]}
        while growth:
            name = min(growth, key=lambda name: (growth[name], position[name]))
            del growth[name]
            yield self.flow.makers[name]
            read = self.flow.counts[name]
            self.left.subtract(read)
            changed = {reader for leaf in read for reader in self.flow.readers[leaf] if reader in growth}
            for result in results(self.flow.makers[name]):
                for reader in self.flow.readers.get(result, ()):
                    self.missing[reader] -= 1
                    if not self.missing[reader]:
                        changed.add(reader)
            growth.update((reader, self._growth(reader)) for reader in changed)

    def _growth(self, name: str) -> float:
        """How many values more are alive after a statement."""
        maker, fixed = self.flow.makers[name], self.flow.fixed
        if self.eager and isinstance(maker, Call):
            return -math.inf
        freed = sum(self.left[leaf] == count for leaf, count in self.flow.counts[name].items() if leaf not in fixed)
        return sum(result not in fixed for result in results(maker)) - freed


class _Allocator:
    """Places the values of a program in one order of its statements."""

    def __init__(self, flow: _Flow, asked: Sequence[Operand], eager: bool) -> None:
        self.program = flow.program
        self.makers = flow.makers
        self.schedule = tuple(_Schedule(flow, asked, eager).order())
        self.reads = flow.reads.copy()
        self.places: dict[str, Place] = dict(flow.fixed)
        self.banks = {"k": _Bank(), "mask": _Bank()}
        self.free: dict[str, tuple[Place, ...]] = {}

    def run(self) -> Placement:
        for statement in self.schedule:
            self._evaluate(statement)
        sizes = {kind: bank.size for kind, bank in self.banks.items()}
        copies = _copied(self.program, self.places)
        return Placement(self.schedule, self.places, copies, sizes["k"], sizes["mask"], self.free)

    def _evaluate(self, statement: Statement) -> None:
        """Place the inline steps below a statement, left to right, then what it makes itself."""
        for arg in statement.args:
            if isinstance(arg, str) and arg in self.makers and arg not in self.places:
                self._evaluate(self.makers[arg])
        if isinstance(statement, Call):
            self._place_call(statement)
        else:
            self._place_step(statement)

    def _place_step(self, step: Step) -> None:
        """A value takes the place of an operand that dies if it can."""
        # a selection writes over its second operand at most: its last one is read once more after the first write
        kept = step.args[2] if step.op == "where" else None
        self._release([arg for arg in step.args if arg != kept])
        self._take(step.name, step.op in MASK_OPS)
        if kept is not None:
            self._release([kept])

    def _place_call(self, call: Call) -> None:
        """Results stand apart from the arguments, which are read while they are written; what is free is lent."""
        for name in all_results(call):
            self._take(name, name in call.truths)
        lent = [(kind, index) for kind, bank in self.banks.items() for index in sorted(bank.free)]
        self.free[results(call)[0]] = tuple(lent)
        self._release(list(call.args))
        for name in set(all_results(call)) - set(results(call)):
            kind, index = self.places[name]
            self.banks[kind].free.append(index)

    def _take(self, name: str, truth: bool) -> None:
        if name not in self.places:
            kind = "mask" if truth else "k"
            self.places[name] = (kind, self.banks[kind].take())

    def _release(self, args: list[Operand]) -> None:
        for arg in args:
            if isinstance(arg, str) and arg in self.makers:
                self.reads[arg] -= 1
                kind, index = self.places[arg]
                if not self.reads[arg] and kind != "o":
                    self.banks[kind].free.append(index)
