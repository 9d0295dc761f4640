"""Machine code executed on symbols: integers and addresses are known, floats are trees of rounded operations.

Where a jump depends on floats, both sides are executed; states that come to the same block are joined before it, and
their values become choices. The machine may read its arguments, its stack and constants; it may write its stack and its
results.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from .memory import Memory
from .operations import Operations
from .program import EXIT, Program
from .translation import Translation
from .trees import PATTERNS, Declined, Different, Tree, Trees, same
from .words import known

STACK, STACK_SIZE, BACK = 0x7FFF_FFFF_0000, 1 << 20, 0x7FFF_F000_0000
BLOCKS = 10_000  # largest number of blocks that a call executes
GENERAL, LARGEST = re.compile(r"r[a-d]x|r[sd]i|rbp|r\d+|x\d+"), 1 << 47  # registers of integers; addresses are less
RED_ZONE = 128  # bytes below the stack of x86-64 that no signal changes
LIBRARY = {"tan": 1, "atan2": 2, "expm1": 1, "log1p": 1, "sqrt": 1, "fabs": 1}
"""Functions of math.h with the number of their arguments; of these, only sqrt and fabs are known."""


@dataclass(frozen=True)
class Convention:
    """Registers of integers, numbers and results of a call, those that it keeps, and modes that it finds."""

    integers: tuple[str, ...]
    floats: tuple[str, ...]
    result: str
    stack: str
    kept: tuple[str, ...]
    modes: Mapping[str, int]
    link: str = ""  # register of the return address; without one it lies on the stack
    misread: tuple[str, ...] = ()  # operations of intermediate code that are not what the instruction computes


CONVENTIONS = {
    "AMD64": Convention(("rdi", "rsi", "rdx", "rcx", "r8", "r9"), tuple(f"xmm{n}lq" for n in range(8)), "rax", "rsp",
                        ("rbx", "rbp", "r12", "r13", "r14", "r15"), {"sseround": 0, "d": 1}),
    "AARCH64": Convention(tuple(f"x{n}" for n in range(8)), tuple(f"d{n}" for n in range(8)), "x0", "xsp",
                          (*(f"x{n}" for n in range(19, 30)), *(f"d{n}" for n in range(8, 16))), {"fpcr": 0}, "x30",
                          ("Iop_Min", "Iop_Max")),
}  # fmt: skip
"""Conventions of calls: System V for x86-64, and AArch64's."""


@dataclass
class State:
    """Registers by their place and memory, with the truth that the execution comes to this state."""

    registers: Memory
    memory: Memory
    reached: Any = True
    target: Any = None  # address to which a function returns

    def copy(self) -> State:
        return State(self.registers.copy(), self.memory.copy(), self.reached, self.target)


@dataclass
class Machine:
    """Machine that executes the functions of a program."""

    program: Program
    trees: Trees
    executed: set[int] = field(default_factory=set)
    blocks: dict[int, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.program.architecture not in CONVENTIONS:
            raise Declined(f"machine code of {self.program.architecture}")
        self.words, self.convention = Operations(self.trees), CONVENTIONS[self.program.architecture]
        self.places: Mapping[str, tuple[int, int]] = self.program.file.arch.registers
        self.stack = self.places[self.convention.stack][0]
        self.modes = {self.places[each][0] for each in self.convention.modes}
        self.translation = Translation(self)
        self.writable: Collection[int] = ()
        self.steps = 0

    def call(self, name: str, integers: Sequence[int], floats: Sequence[Tree], memory: Mapping[int, Tree],
             writable: Collection[int]) -> State:  # fmt: skip
        """Call a function; return the state after it.

        States that come to a block with other counters or addresses stay apart if joined ones cannot be executed.
        """
        self.apart = False
        try:
            return self._call(name, integers, floats, memory, writable)
        except Declined:
            self.apart = True
            return self._call(name, integers, floats, memory, writable)

    def _call(self, name: str, integers: Sequence[int], floats: Sequence[Tree], memory: Mapping[int, Tree],
              writable: Collection[int]) -> State:  # fmt: skip
        own, words = self.convention, self.words
        self.writable, self.steps = writable, 0
        kept = {each: words.joined(*((self.trees.make("saved", each, place), words.unit)
                                     for place in range(0, 8, words.unit))) for each in own.kept}  # fmt: skip
        state = State(Memory(words), Memory(words))
        given = zip(own.integers, integers, strict=False)
        for each, word in [*kept.items(), *own.modes.items(), *given, (own.stack, STACK if own.link else STACK - 8)]:
            self._set(state, each, word)
        for each, number in zip(own.floats, floats, strict=False):
            state.registers.put(self.places[each][0], number, words.unit)
        for address, number in memory.items():
            state.memory.put(address, number, words.unit)
        for place, word in enumerate(integers[len(own.integers) :]):
            state.memory.put(STACK + 8 * place, word, 8)
        state = self._function(state, self.program.functions[name], BACK, pushed=False)
        for each, word in kept.items():
            if not same(self.get(state, each), word):
                raise Different(f"the register {each}, which belongs to the caller, is not restored")
        return state

    def get(self, state: State, name: str) -> Any:
        return state.registers.take(*self.places[name])

    def _set(self, state: State, name: str, word: Any) -> None:
        state.registers.put(self.places[name][0], word, self.places[name][1])

    def _function(self, state: State, start: int, back: int, pushed: bool) -> State:
        """Execute a function that goes back to an address; a call has pushed it on the stack already."""
        top = known(self.get(state, self.convention.stack))
        if self.convention.link:
            self._set(state, self.convention.link, back)
        elif not pushed:
            state.memory.put(top, back, 8)
        reached, state.reached = state.reached, True
        state = self._run(state, start)
        after = top if self.convention.link else top + 8
        if not same(state.target, back) or self.get(state, self.convention.stack) != after:
            raise Different("the return address or the stack is not restored")
        state.reached, state.target = reached, None
        return state

    def _run(self, state: State, start: int) -> State:
        """Execute the blocks of a function in the order of their graph; return the state at its end."""
        order, end = self.program.order(start), (BLOCKS, EXIT)
        waiting: dict[tuple[Any, ...], State] = {(0, start): state}  # by the number of jumps back and the next block
        while list(waiting) != [end]:
            turns, address, *_ = place = min(waiting, key=lambda each: (each[0], order[each[1]]))
            for state, after in self._after(waiting.pop(place), address):
                place = (turns + (order[after] <= order[address]), after, *self._integers(state))
                place = end if after == EXIT else place
                waiting[place] = self._joined(state, waiting[place]) if place in waiting else state
        return waiting[end]

    def _integers(self, state: State) -> list[tuple[int, int]]:
        """Return counters and addresses with their places, if states with others stay apart."""
        if not self.apart:
            return []
        words = [(place, self.get(state, name)) for name, (place, _) in self.places.items() if GENERAL.fullmatch(name)]
        stack = sorted(each for each in state.memory if STACK - STACK_SIZE <= each < STACK and not each % 8)
        words += [(each, state.memory.take(each, 8)) for each in stack]
        return [(place, word) for place, word in words if isinstance(word, int) and word < LARGEST]

    def _after(self, state: State, address: int) -> list[tuple[State, int]]:
        """Execute a block; return the states after it with the blocks where they go on."""
        self.steps += 1
        if self.steps > BLOCKS:
            raise Declined(f"more than {BLOCKS} blocks")
        block = self.program.block(address)
        self.executed |= self.program.instructions[address]
        side, after = self._block(state, block)
        if side is not None:
            truth, other, target = side
            other.reached = self._either(state.reached, truth, False)
            state.reached = self._either(truth, False, state.reached)
            return [(other, target), (state, known(after))]
        if block.jumpkind == "Ijk_Ret":
            state.target = after
            return [(state, EXIT)]
        target = known(after)
        if library := self.program.library(target):
            self._library(state, library)
            back = self._back(state)
            if block.jumpkind == "Ijk_Call":
                return [(state, known(back))]
            state.target = back
            return [(state, EXIT)]
        if target not in self.program.targets(address):
            raise Declined(f"a jump to an address that is computed, at {address:#x}")
        if block.jumpkind == "Ijk_Call":
            back = address + block.size
            return [(self._function(state, target, back, pushed=True), back)]
        if block.jumpkind != "Ijk_Boring":
            raise Declined(f"a jump of the kind {block.jumpkind}")
        return [(state, target)]

    def _back(self, state: State) -> Any:
        """Return the return address as a function does at its end."""
        if self.convention.link:
            return self.get(state, self.convention.link)
        top = known(self.get(state, self.convention.stack))
        self._set(state, self.convention.stack, top + 8)
        return self.load(state, top, 8)

    def _library(self, state: State, name: str) -> None:
        """Call a function of math.h, which may change every register that it does not keep."""
        own = self.convention
        top = known(self.get(state, own.stack))
        if (top + (0 if own.link else 8)) & 15:
            raise Different(f"the stack is not aligned at a call of {name}")
        plain = name.removesuffix("f") if self.trees.unit == 4 else name
        if plain not in LIBRARY or (self.trees.unit == 4) != (plain != name):
            raise Declined(f"a call of {name}")
        given = [self.trees.number(self.words.part(self.get(state, own.floats[place]), 0, self.trees.unit))
                 for place in range(LIBRARY[plain])]  # fmt: skip
        known_ = {"sqrt": self.trees.sqrt, "fabs": self.trees.absolute}
        made = known_[plain](*given) if plain in known_ else self.trees.call(plain, *given)
        kept = [*own.kept, own.stack, *own.modes, *([own.link] if own.link else ())]
        words = {each: self.get(state, each) for each in kept}
        state.registers.clear()
        for each, word in words.items():
            self._set(state, each, word)
        state.registers.put(self.places[own.floats[0]][0], made, self.trees.unit)
        for address in [each for each in state.memory if top - STACK_SIZE <= each < top]:
            del state.memory[address]

    def _either(self, truth: Any, a: Any, b: Any) -> Any:
        if a is b or same(a, b):
            return a
        if any(isinstance(word, Tree) and word.kind not in PATTERNS for word in (a, b)):
            a, b = self.trees.number(a), self.trees.number(b)
        return self.trees.lift(self.trees.select, truth, a, b)

    def _joined(self, one: State, two: State) -> State:
        """Return the state where one or the other comes to a block."""
        if not same(self.get(one, self.convention.stack), self.get(two, self.convention.stack)):
            raise Declined("the sides of a jump leave the stack at different depths")
        self._merge(one.reached, one.registers, two.registers)
        self._merge(one.reached, one.memory, two.memory)
        one.target = self._either(one.reached, one.target, two.target)
        one.reached = self._either(one.reached, True, two.reached)
        return one

    def _merge(self, truth: Any, one: Memory, two: Memory) -> None:
        changed = {address for address, word in two.items() if one[address] is not word}
        for address in sorted(changed | one.keys() - two.keys()):
            one[address] = self._either(truth, one[address], two[address])

    # --- memory -------------------------------------------------------------------------------------------------------

    def load(self, state: State, address: Any, width: int) -> Any:
        """Return the word at an address."""
        if isinstance(address, Tree):
            return self.trees.lift(lambda each: self.load(state, known(each), width), address)
        if self._on_stack(state, address, width) or all(each in state.memory for each in self._cells(address, width)):
            return state.memory.take(address, width)
        if (found := self.program.constant(address, width)) is None:
            raise Different(f"an access to memory at {address:#x}, outside of arguments and results")
        return found

    def store(self, state: State, address: Any, word: Any, width: int) -> None:
        address = known(address)
        cells = self._cells(address, width)
        if not self._on_stack(state, address, width) and not all(each in self.writable for each in cells):
            raise Different(f"a store outside of the results, at {address:#x}")
        state.memory.put(address, word, width)

    def _cells(self, address: int, width: int) -> range:
        return range(address - address % self.trees.unit, address + width, self.trees.unit)

    def _on_stack(self, state: State, address: int, width: int) -> bool:
        """Return whether bytes are those of the function and its calls: below the caller's, and not below the stack."""
        if not STACK - STACK_SIZE <= address < STACK:
            return False
        lowest = known(state.registers.take(self.stack, 8)) - (0 if self.convention.link else RED_ZONE)
        return lowest <= address and address + width <= STACK

    def fixed(self, address: int) -> bool:
        """Return whether an address is known to a multiple of 16: on the stack, or of a constant."""
        return address >= STACK - STACK_SIZE or bool(self.program.file.contains_addr(address))

    # --- blocks -------------------------------------------------------------------------------------------------------

    def _block(self, state: State, block: Any) -> tuple[tuple[Any, State, int] | None, Any]:
        """Execute a block; return the other side of a jump that depends on numbers, and the address after the block."""
        if block.addr not in self.blocks:
            statements = [self.translation.statement(each, block) for each in block.statements]
            after = self.translation.expression(block.next, block.tyenv)
            self.blocks[block.addr] = [each for each in statements if each is not None], after
        statements, after = self.blocks[block.addr]
        values: list[Any] = [None] * len(block.tyenv.types)
        sides = None
        for each in statements:
            if (made := each(state, values)) is not None:
                if not isinstance(made, tuple):
                    return sides, made
                if sides is not None:
                    raise Declined("two jumps of a block depend on numbers")
                sides = made
        return sides, after(state, values)
