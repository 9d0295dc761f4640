"""Machine code of x86-64 executed on symbols: integers and addresses are known, floats are trees of rounded operations.

Where a jump depends on floats, both sides are executed up to the address where they meet, and their values become
choices. Nothing is assumed of an instruction that is not in the tables here: the function is then declined.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any

from .assembly import EXIT, REGISTERS, Instruction, Listing, Operand
from .rounded import PATTERNS, RELATIONS, Declined, Tree, Trees, same
from .statements import MachineError

STACK, STACK_SIZE = 0x7FFF_FFFF_0008, 1 << 20
STEPS = 3_000_000
SAVED = ("rbx", "rbp", "r12", "r13", "r14", "r15")
VECTORS = tuple(f"xmm{number}" for number in range(16))
WIDTHS = {"b": 1, "w": 2, "l": 4, "q": 8}
LIBRARY = {"tan": 1, "atan2": 2, "expm1": 1, "log1p": 1, "sqrt": 1, "fabs": 1}
"""Functions of math.h with the number of their arguments; of these, only sqrt and fabs are known."""
COMPARED = {
    "eq": {"equal"}, "lt": {"less"}, "le": {"less", "equal"}, "unord": {"unordered"},
    "neq": {"less", "greater", "unordered"}, "nlt": {"equal", "greater", "unordered"},
    "nle": {"greater", "unordered"}, "ord": {"less", "equal", "greater"},
}  # fmt: skip
"""Relations for which a comparison of vectors is true."""
FLAGS = {
    "a": {"greater"}, "ae": {"greater", "equal"}, "b": {"less", "unordered"}, "be": {"less", "equal", "unordered"},
    "e": {"equal", "unordered"}, "ne": {"less", "greater"}, "p": {"unordered"}, "np": {"less", "equal", "greater"},
}  # fmt: skip
"""Relations for which a condition is true after a comparison of floats."""
CONDITIONS: Mapping[str, Callable[[int, int], bool]] = {
    "e": operator.eq, "ne": operator.ne, "l": operator.lt, "ge": operator.ge, "le": operator.le, "g": operator.gt,
    "b": operator.lt, "ae": operator.ge, "be": operator.le, "a": operator.gt, "s": operator.lt, "ns": operator.ge,
}  # fmt: skip
"""Conditions after a comparison of integers; b, ae, be and a are of unsigned ones, s and ns of their difference."""
SAME = {"c": "b", "nc": "ae", "nae": "b", "nb": "ae", "z": "e", "nz": "ne", "na": "be", "nbe": "a", "nge": "l",
        "nl": "ge", "ng": "le", "nle": "g", "pe": "p", "po": "np"}  # fmt: skip
INTEGERS: Mapping[str, Callable[..., int]] = {
    "add": operator.add, "sub": operator.sub, "and": operator.and_, "or": operator.or_, "xor": operator.xor,
    "imul": operator.mul, "inc": lambda a: a + 1, "dec": lambda a: a - 1, "neg": operator.neg, "not": operator.invert,
    "shl": lambda a, n: a << n, "sal": lambda a, n: a << n,
}  # fmt: skip


class Different(MachineError):
    """Difference between machine code and text."""


@dataclass
class State:
    """Registers, vectors of numbers, memory by address as width and value, and the operands of the last comparison."""

    registers: dict[str, Any]
    vectors: dict[str, list[Any]]
    memory: dict[int, tuple[int, Any]]
    flags: tuple[Any, ...] = ("unset",)

    def copy(self) -> State:
        return State(dict(self.registers), dict(self.vectors), dict(self.memory), self.flags)


def signed(value: int, width: int) -> int:
    value &= (1 << 8 * width) - 1
    return value - (1 << 8 * width) if value >> (8 * width - 1) else value


@dataclass
class Machine:
    """Machine that executes a listing; it may write its stack and the cells of results alone."""

    listing: Listing
    trees: Trees
    writable: Collection[int] = ()
    executed: set[int] = field(default_factory=set)
    steps: int = 0

    def __post_init__(self) -> None:
        self.unit, self.lanes = self.trees.unit, 16 // self.trees.unit
        self.unset = self.trees.unset
        self.letter = "d" if self.unit == 8 else "s"

    def call(self, name: str, integers: Sequence[int], floats: Sequence[Tree], memory: Mapping[int, Tree],
             writable: Collection[int]) -> State:  # fmt: skip
        """Call a function as the System V ABI says; return the state after it."""
        self.writable, self.steps = writable, 0
        registers: dict[str, Any] = {name: self.unset for name, width in REGISTERS.values()}
        registers |= {each: self.trees.make("saved", each) for each in SAVED}
        registers |= dict(zip(("rdi", "rsi", "rdx", "rcx", "r8", "r9"), integers, strict=False)) | {"rsp": STACK}
        vectors = {each: [self.unset] * self.lanes for each in VECTORS}
        for each, number in zip(VECTORS, floats, strict=False):
            vectors[each] = [number, *[self.unset] * (self.lanes - 1)]
        back = self.trees.make("saved", "return address")
        state = State(registers, vectors, {address: (self.unit, value) for address, value in memory.items()})
        state.memory |= {STACK + 8 * place: (8, value) for place, value in enumerate([back, *integers[6:]])}
        state = self._function(state, self.listing.functions[name], back)
        if state.registers["rsp"] != STACK + 8 or any(state.registers[r] is not registers[r] for r in SAVED):
            raise Different("a register that belongs to the caller is not restored")
        return state

    def _function(self, state: State, start: int, back: Any) -> State:
        """Execute a function whose return address lies on the stack."""
        before = state.registers["rsp"]
        state = self._run(state, start, EXIT)
        if state.registers["rsp"] != before or not same(self.load(state, before, 8), back):
            raise Different("the return address is lost")
        state.registers["rsp"] += 8
        return state

    def _run(self, state: State, address: int, stop: int) -> State:
        """Execute instructions up to an address, or until the function returns."""
        while address != stop:
            each = self.listing.code[address]
            self.executed.add(address)
            self.steps += 1
            if self.steps > STEPS:
                raise Declined(f"more than {STEPS} steps")
            name = each.name
            if name == "ret":
                return state
            if name == "jmp" and each.target is not None:
                if library := self.listing.library(each.target):
                    self._library(state, library)
                    return state
                address = each.target
            elif name == "call" and each.target is not None:
                state = self._call(state, each)
                address = each.next
            elif name.startswith("j"):
                truth = self._condition(state, name[1:], each)
                if isinstance(truth, Tree):
                    address, state = self.listing.join(address), self._both(state, each, truth)
                    if address == EXIT:
                        return state
                else:
                    address = each.target if truth else each.next  # type: ignore[assignment]
            else:
                self._execute(state, each)
                address = each.next
        return state

    def _call(self, state: State, each: Instruction) -> State:
        assert each.target is not None
        if library := self.listing.library(each.target):
            if (state.registers["rsp"] & 15) != 0:
                raise Different(f"{each.text}: the stack is not aligned")
            self._library(state, library)
            return state
        state.registers["rsp"] -= 8
        self.store(state, state.registers["rsp"], 8, each.next)
        return self._function(state, each.target, each.next)

    def _library(self, state: State, name: str) -> None:
        """Call a function of math.h, which may change every register that is not saved."""
        own = name.removesuffix("f") if self.unit == 4 and name != "f" else name
        if own not in LIBRARY or (self.unit == 4 and not name.endswith("f")):
            raise Declined(f"a call of {name}")
        given = [self.trees.number(state.vectors[VECTORS[place]][0]) for place in range(LIBRARY[own])]
        known = {"sqrt": self.trees.sqrt, "fabs": self.trees.absolute}
        made = known[own](*given) if own in known else self.trees.call(own, *given)
        for each in state.registers.keys() - {*SAVED, "rsp"}:
            state.registers[each] = self.unset
        for each in VECTORS:
            state.vectors[each] = [self.unset] * self.lanes
        state.vectors["xmm0"] = [made, *[self.unset] * (self.lanes - 1)]
        state.flags = ("unset",)
        below = range(state.registers["rsp"] - STACK_SIZE, state.registers["rsp"])
        state.memory = {address: cell for address, cell in state.memory.items() if address not in below}

    def _both(self, state: State, each: Instruction, truth: Tree) -> State:
        """Execute both sides of a jump until they meet."""
        stop, other = self.listing.join(each.address), state.copy()
        one = self._run(state, each.target, stop) if each.target != stop else state  # type: ignore[arg-type]
        two = self._run(other, each.next, stop) if each.next != stop else other

        def choose(a: Any, b: Any) -> Any:
            if a is b or same(a, b):
                return a
            if any(isinstance(value, Tree) and value.kind not in PATTERNS for value in (a, b)):
                a, b = self.trees.number(a), self.trees.number(b)
            return self.trees.lift(lambda t: a if t else b, truth)

        for name in one.registers:
            one.registers[name] = choose(one.registers[name], two.registers[name])
        for name in VECTORS:
            one.vectors[name] = list(map(choose, one.vectors[name], two.vectors[name]))
        if isinstance(one.registers["rsp"], Tree):
            raise Declined(f"{each.text}: the sides leave the stack at different depths")
        for address in one.memory.keys() | two.memory.keys():
            a, b = one.memory.get(address), two.memory.get(address)
            if a is None or b is None or a[0] != b[0]:
                one.memory[address] = ((a or b)[0], self.unset)  # type: ignore[index]
            elif a[1] is not b[1]:
                one.memory[address] = (a[0], choose(a[1], b[1]))
        one.flags = one.flags if one.flags == two.flags else ("unset",)
        return one

    # --- memory and operands ------------------------------------------------------------------------------------------

    def load(self, state: State, address: Any, width: int) -> Any:
        """Return the value at an address: of one cell, of its half, or of two."""
        if isinstance(address, Tree):
            return self.trees.lift(lambda each: self.load(state, self._known(each), width), address)
        cell = state.memory.get(address)
        if cell is not None and cell[0] == width:
            return cell[1]
        if cell is not None and cell[0] > width:
            return self._half(cell[1], 0, width)
        if cell is None:
            for before in (4, 1, 2, 3, 5, 6, 7):
                found = state.memory.get(address - before)
                if found and found[0] > before:
                    return self._half(found[1], before, width)
            if all(address + place in self.listing.data for place in range(width)):
                return int.from_bytes(bytes(self.listing.data[address + place] for place in range(width)), "little")
            if STACK - STACK_SIZE <= address < STACK and width == self.unit:
                return self.unset
        if width > 4 and cell is not None:
            return self._joined(*(self.load(state, address + start, width // 2) for start in (0, width // 2)))
        if STACK - STACK_SIZE <= address < STACK:
            return self.unset
        raise Different(f"an access to memory at {address:#x}, outside of arguments and results")

    def _half(self, value: Any, start: int, width: int) -> Any:
        def leaf(each: Any) -> Any:
            if isinstance(each, int):
                return each >> 8 * start & (1 << 8 * width) - 1
            if each.kind == "joined" and width == 4 and start in (0, 4):
                return each.parts[start // 4]
            whole = each is self.unset or (width == self.unit and not start)
            return each if whole else self.trees.unknown("half", each, start)

        return self.trees.lift(leaf, value)

    def _joined(self, low: Any, high: Any) -> Any:
        def leaf(a: Any, b: Any) -> Any:
            if isinstance(a, int) and isinstance(b, int):
                return a | b << 32
            return self.trees.make("joined", a, b) if self.unit == 4 else self.trees.unknown("joined", a, b)

        return self.trees.lift(leaf, low, high)

    def store(self, state: State, address: Any, width: int, value: Any) -> None:
        address = self._known(address)
        stack = STACK - STACK_SIZE <= address < STACK + 8
        if not stack and not all(a in self.writable for a in range(address, address + width, self.unit)):
            raise Different(f"a store outside of the results, at {address:#x}")
        cell = state.memory.get(address)
        if cell is None or cell[0] != width:
            for place in range(address - 7, address + width):
                found = state.memory.get(place)
                if found and place + found[0] > address:
                    self._cut(state, place, found, address, width)
            if not stack and width > self.unit:  # cells of results have the width of a number
                state.memory[address + 4] = (4, self._half(value, 4, 4))
                width, value = 4, self._half(value, 0, 4)
        state.memory[address] = (width, value)

    def _cut(self, state: State, place: int, cell: tuple[int, Any], address: int, width: int) -> None:
        """Keep the half of a cell that a store leaves; a cell of other parts is lost."""
        del state.memory[place]
        if cell[0] == 8 and width == 4 and address in (place, place + 4):
            other = place + 4 if address == place else place
            state.memory[other] = (4, self._half(cell[1], other - place, 4))

    def _known(self, value: Any) -> int:
        if not isinstance(value, int):
            raise Declined("an address depends on numbers or is unset")
        return value

    def address(self, state: State, each: Instruction, operand: Operand) -> Any:
        memory = operand.memory
        if memory is None:
            raise Declined(f"no operand in memory: {each.text}")
        value: Any = memory.displacement + (each.next if memory.base == "rip" else 0)
        for name, scale in ((memory.base, 1), (memory.other, memory.scale)):
            if name and name != "rip":
                value = self.trees.lift(lambda a, b, s=scale: self._known(a) + s * self._known(b), value,
                                        state.registers[name])  # fmt: skip
        return value & (1 << 64) - 1 if isinstance(value, int) else value

    def width(self, each: Instruction, operands: Sequence[Operand]) -> int:
        """Return the width of an integer operation: of its last register, or that of the suffix."""
        for operand in reversed(operands):
            if operand.register:
                return REGISTERS[operand.register][1]
        return WIDTHS.get(each.name[-1], 8)

    def get(self, state: State, each: Instruction, operand: Operand, width: int) -> Any:
        """Return an integer operand."""
        if operand.immediate is not None:
            return operand.immediate & (1 << 8 * width) - 1
        if operand.memory is not None:
            return self.load(state, self.address(state, each, operand), width)
        value = state.registers[REGISTERS[operand.register][0]]
        return value if width == 8 else self._half(value, 0, width)

    def put(self, state: State, each: Instruction, operand: Operand, width: int, value: Any) -> None:
        if operand.memory is not None:
            self.store(state, self.address(state, each, operand), width, value)
            return
        name = REGISTERS[operand.register][0]
        if width < 4:
            mask = (1 << 8 * width) - 1
            value = self.trees.lift(lambda a, b: self._known(a) & ~mask | self._known(b) & mask if isinstance(a, int)
                                    else b, state.registers[name], value)  # fmt: skip
        state.registers[name] = value

    def vector(self, state: State, each: Instruction, operand: Operand, count: int) -> list[Any]:
        """Return the first numbers of an operand, of a register or in memory."""
        if operand.memory is None:
            if operand.vector not in state.vectors:
                raise Declined(each.text)
            return state.vectors[operand.vector][:count]
        address = self.address(state, each, operand)
        if count > 1 and "u" not in each.name and not each.name.startswith(("movl", "movh", "movq", "movsd")) and (
            isinstance(address, Tree) or address & 15
        ) and count * self.unit == 16:  # fmt: skip
            raise Different(f"{each.text}: memory is not aligned")
        places = [self.trees.lift(lambda a, s=place: a + s * self.unit, address) for place in range(count)]
        return [self.load(state, place, self.unit) for place in places]

    def _condition(self, state: State, name: str, each: Instruction) -> Any:
        """Return the truth of a condition after the last comparison."""
        name, (kind, *given) = SAME.get(name, name), state.flags
        if kind == "floats" and name in FLAGS:
            return self.trees.test(given[0], given[1], frozenset(FLAGS[name]))
        if kind == "integers" and name in CONDITIONS:
            width, a, b, compared = given
            if not compared and name not in ("e", "ne", "s", "ns"):
                raise Declined(f"{each.text}: a carry of an operation")

            def leaf(x: Any, y: Any) -> bool:
                x, y = self._known(x), self._known(y)
                if name in ("s", "ns"):
                    x, y = signed(x - y, width), 0
                elif name not in ("b", "ae", "be", "a"):
                    x, y = signed(x, width), signed(y, width)
                return CONDITIONS[name](x, y)

            return self.trees.lift(leaf, a, b)
        raise Declined(f"{each.text}: a condition after no comparison")

    # --- instructions -------------------------------------------------------------------------------------------------

    def _execute(self, state: State, each: Instruction) -> None:
        name = each.name
        if any(operand.vector for operand in each.operands):
            self._execute_vector(state, each)
        elif not self._integer(state, each, name) and not (
            name[-1:] in WIDTHS and self._integer(state, each, name[:-1])
        ):
            raise Declined(f"no instruction that is known: {each.text}")

    def _integer(self, state: State, each: Instruction, name: str) -> bool:
        """Execute an instruction on integers; return whether it is known."""
        operands, registers, lift = each.operands, state.registers, self.trees.lift
        width = self.width(each, operands)
        get, put = partial(self.get, state, each), partial(self.put, state, each)
        if name in ("nop", "endbr64") or (name == "xchg" and operands[0] == operands[1]):
            return True
        if name in ("mov", "movabs"):
            put(operands[1], width, get(operands[0], width))
        elif name == "lea":
            value = self.address(state, each, operands[0])
            put(operands[1], width, lift(lambda v: v & (1 << 8 * width) - 1, value))
        elif found := re.fullmatch(r"mov([sz])([bwl])([wlq])", each.name) or re.fullmatch(r"mov([sz])(l|b|w)x?", name):
            narrow = WIDTHS[found[2]]
            view = (lambda v: signed(self._known(v), narrow) & (1 << 8 * width) - 1) if found[1] == "s" else self._known
            put(operands[1], width, lift(view, get(operands[0], narrow)))
        elif name in ("cltq", "cwtl", "cltd", "cqto"):
            narrow = 8 if name == "cqto" else 4
            value = registers["rax"]
            if name == "cltq":
                registers["rax"] = lift(lambda v: signed(self._known(v), 4) & (1 << 64) - 1, value)
            else:
                ones = (1 << 8 * narrow) - 1
                registers["rdx"] = lift(lambda v: ones if signed(self._known(v), narrow) < 0 else 0, value)
        elif name == "push":
            registers["rsp"] -= 8
            self.store(state, registers["rsp"], 8, self.get(state, each, operands[0], 8))
        elif name == "pop":
            value, registers["rsp"] = self.load(state, registers["rsp"], 8), registers["rsp"] + 8
            put(operands[0], 8, value)
        elif name == "leave":
            value = self.load(state, registers["rbp"], 8)
            registers["rsp"], registers["rbp"] = registers["rbp"] + 8, value
        elif name in ("cmp", "test"):
            a, b = get(operands[1], width), get(operands[0], width)
            zero = name == "test"
            state.flags = ("integers", width, *((self._bits("and", a, b), 0) if zero else (a, b)), True)
        elif name.startswith("set") and name[3:] in {*CONDITIONS, *FLAGS, *SAME}:
            put(operands[0], 1, lift(int, self._condition(state, name[3:], each)))
        elif name.startswith("cmov"):
            ending = next((e for e in (name[4:], name[4:-1]) if e in {*CONDITIONS, *FLAGS, *SAME}), "")
            sides = get(operands[0], width), get(operands[1], width)
            put(operands[1], width, lift(lambda t, a, b: a if t else b, self._condition(state, ending, each), *sides))
        elif name in ("imul", "mul") and len(operands) == 1:
            view = (lambda v: signed(v, width)) if name == "imul" else (lambda v: v)
            mask = (1 << 8 * width) - 1
            product = view(self._known(get(operands[0], width))) * view(self._known(registers["rax"]) & mask)
            registers["rax"], registers["rdx"] = product & mask, product >> 8 * width & mask
        elif name in ("idiv", "div"):
            self._divide(state, name, width, self._known(get(operands[0], width)))
        elif name in ("shr", "sar"):
            count = self._known(get(operands[0], 1)) & (63 if width == 8 else 31) if len(operands) > 1 else 1
            view = partial(signed, width=width) if name == "sar" else int
            value = get(operands[-1], width)
            if (name, count, width, self.unit) == ("shr", 32, 8, 4):
                value = self._half(value, 4, 4)
            else:
                value = lift(lambda v: (view(self._known(v)) >> count) & (1 << 8 * width) - 1, value)
            state.flags = ("integers", width, value, 0, False)
            put(operands[-1], width, value)
        elif name in INTEGERS:
            self._arithmetic(state, each, name, width)
        else:
            return False
        return True

    def _arithmetic(self, state: State, each: Instruction, name: str, width: int) -> None:
        *sources, target = each.operands
        given = [self.get(state, each, operand, width) for operand in sources]
        if name in ("shl", "sal"):
            given = [self._known(self.get(state, each, sources[0], 1)) & (63 if width == 8 else 31)] if sources else [1]
        if len(sources) < 2:
            given.insert(0, self.get(state, each, target, width))
        mask = (1 << 8 * width) - 1
        if name in ("and", "or", "xor"):
            value = self._bits(name, *given)
        else:
            value = self.trees.lift(lambda *v: INTEGERS[name](*map(self._known, v)) & mask, *given)
        compared = name in ("and", "or", "xor", "sub")
        state.flags = ("integers", width, *(given if name == "sub" else (value, 0)), compared)
        self.put(state, each, target, width, value)

    def _divide(self, state: State, name: str, width: int, divisor: int) -> None:
        mask = (1 << 8 * width) - 1
        low, high = (self._known(state.registers[each]) & mask for each in ("rax", "rdx"))
        dividend = high << 8 * width | low
        if name == "idiv":
            dividend, divisor = signed(dividend, 2 * width), signed(divisor, width)
        if not divisor:
            raise Different("a division of an integer by zero")
        quotient = abs(dividend) // abs(divisor) * (1 if (dividend < 0) == (divisor < 0) else -1)
        state.registers["rax"], state.registers["rdx"] = quotient & mask, (dividend - quotient * divisor) & mask

    def _bits(self, name: str, a: Any, b: Any) -> Any:
        return self.trees.lift(partial(self._bits_of, name), a, b)

    def _bits_of(self, name: str, a: Any, b: Any) -> Any:
        """Return a bitwise operation on patterns, or on a number and a mask of its sign."""
        ones, sign = self.trees.ones, self.trees.sign
        if isinstance(a, int) and isinstance(b, int):
            return INTEGERS[name](a, b)
        if a is b:
            return 0 if name == "xor" else a
        number, mask = (b, a) if isinstance(a, int) else (a, b)
        if isinstance(mask, Tree):
            if self.unset in (a, b):
                return self.unset
            return self.trees.unknown(name, a, b)
        if number.kind == "joined" and self.unit == 4:
            halves = [self._bits_of(name, part, mask >> 32 * place & ones) for place, part in enumerate(number.parts)]
            return self._joined(*halves)
        flip, size = self.trees.negated, self.trees.absolute
        known: dict[tuple[str, int], Callable[[], Any]] = {
            ("and", 0): lambda: 0, ("and", ones): lambda: number, ("and", ones ^ sign): lambda: size(number),
            ("or", 0): lambda: number, ("or", ones): lambda: ones, ("or", sign): lambda: flip(size(number)),
            ("xor", 0): lambda: number, ("xor", sign): lambda: flip(number),
        }  # fmt: skip
        if number.kind == "const" or (number.kind == "neg" and number.parts[0].kind == "const"):
            pattern = number.parts[0] if number.kind == "const" else number.parts[0].parts[0] | sign
            return INTEGERS[name](pattern, mask)
        if (name, mask) not in known:
            return self.trees.unknown(name, a, b)
        return known[name, mask]() if number is not self.unset or name == "and" else self.unset

    # --- vectors ------------------------------------------------------------------------------------------------------

    def _execute_vector(self, state: State, each: Instruction) -> None:
        """Execute an instruction on vectors."""
        for pattern, execute in VECTOR_TABLE:
            if found := re.fullmatch(pattern, each.name):
                if found.groupdict().get("real", self.letter) != self.letter:
                    raise Declined(f"{each.text}: an operation of another precision")
                getattr(self, execute)(state, each, *found.groups())
                return
        raise Declined(f"no instruction that is known: {each.text}")

    def _set(self, state: State, operand: Operand, values: Sequence[Any]) -> None:
        """Set the first numbers of a register; the others stay."""
        state.vectors[operand.vector] = [*values, *state.vectors[operand.vector][len(values) :]]

    def _operation(self, state: State, each: Instruction, name: str, form: str, _: str) -> None:
        source, target = each.operands
        count = 1 if form == "s" else self.lanes
        given = [self.trees.number(v) for v in self.vector(state, each, source, count)]
        kept = [self.trees.number(v) for v in state.vectors[target.vector][:count]]
        if name in ("min", "max"):
            relations = frozenset({"less" if name == "min" else "greater"})
            made = [self.trees.lift(lambda t, x, y: x if t else y, self.trees.test(a, b, relations), a, b)
                    for a, b in zip(kept, given, strict=True)]  # fmt: skip
        elif name == "sqrt":
            made = list(map(self.trees.sqrt, given))
        else:
            made = list(map(getattr(self.trees, name), kept, given))
        self._set(state, target, made)

    def _bitwise(self, state: State, each: Instruction, name: str) -> None:
        source, target = each.operands
        kept = state.vectors[target.vector]
        if name == "andn":
            kept = [self.trees.lift(self._inverted, value) for value in kept]
        given = self.vector(state, each, source, self.lanes)
        self._set(state, target, [self._bits(name.removesuffix("n"), a, b) for a, b in zip(kept, given, strict=True)])

    def _inverted(self, value: Any) -> Any:
        return value ^ self.trees.ones if isinstance(value, int) else self.trees.unknown("not", value)

    def _compare(self, state: State, each: Instruction, relation: str, form: str, _: str) -> None:
        source, target = each.operands
        count = 1 if form == "s" else self.lanes
        given = [self.trees.number(v) for v in self.vector(state, each, source, count)]
        kept = [self.trees.number(v) for v in state.vectors[target.vector][:count]]
        ones = {name: self.trees.ones if name in COMPARED[relation] else 0 for name in RELATIONS}
        self._set(state, target, [self.trees.choose(a, b, ones) for a, b in zip(kept, given, strict=True)])

    def _compare_one(self, state: State, each: Instruction, _: str) -> None:
        source, target = each.operands
        given = self.trees.number(self.vector(state, each, source, 1)[0])
        state.flags = ("floats", self.trees.number(state.vectors[target.vector][0]), given)

    def _move(self, state: State, each: Instruction) -> None:
        """Move a whole vector."""
        source, target = each.operands
        self._store(state, each, target, self.vector(state, each, source, self.lanes))

    def _store(self, state: State, each: Instruction, target: Operand, values: Sequence[Any]) -> None:
        if target.memory is None:
            self._set(state, target, values)
            return
        address = self.address(state, each, target)
        if len(values) * self.unit == 16 and "u" not in each.name and self._known(address) & 15:
            raise Different(f"{each.text}: memory is not aligned")
        for place, value in enumerate(values):
            self.store(state, address + place * self.unit, self.unit, value)

    def _move_part(self, state: State, each: Instruction, bytes_: int, start: int) -> None:
        """Move the low or the high part of a vector; the other part of the target stays."""
        source, target = each.operands
        count = bytes_ // self.unit
        if count == 0:
            raise Declined(f"{each.text}: half of a number")
        if target.memory is not None:
            self._store(state, each, target, state.vectors[source.vector][start : start + count])
            return
        values, kept = self.vector(state, each, source, count), state.vectors[target.vector]
        state.vectors[target.vector] = [*kept[:start], *values, *kept[start + count :]]

    def _move_scalar(self, state: State, each: Instruction, letter: str) -> None:
        source, target = each.operands
        self._move_part(state, each, 8 if letter == "d" else 4, 0)
        if source.memory is not None:  # a load clears the rest
            count = max(1, (8 if letter == "d" else 4) // self.unit)
            state.vectors[target.vector][count:] = [0] * (self.lanes - count)

    def _move_half(self, state: State, each: Instruction, letter: str) -> None:
        self._move_part(state, each, 8, self.lanes // 2 if letter == "h" else 0)

    def _move_across(self, state: State, each: Instruction, letters: str) -> None:
        source, target = each.operands
        half = self.lanes // 2
        low, high = state.vectors[target.vector][:half], state.vectors[target.vector][half:]
        other = state.vectors[source.vector]
        state.vectors[target.vector] = [*other[half:], *high] if letters == "hl" else [*low, *other[:half]]

    def _move_integer(self, state: State, each: Instruction, letter: str) -> None:
        """Move between a vector and an integer register or memory; the rest of a vector is cleared."""
        source, target = each.operands
        width = 8 if letter == "q" else 4
        if source.vector and target.register:
            values = state.vectors[source.vector][: max(1, width // self.unit)]
            value = self._joined(*values) if len(values) == 2 else values[0]
            value = value if width >= self.unit else self._half(value, 0, width)
            state.registers[REGISTERS[target.register][0]] = value
        elif target.memory is not None:
            self._move_part(state, each, width, 0)
        else:
            if source.register:
                value = self.get(state, each, source, width)
                values = [self._half(value, place, 4) for place in (0, 4)] if width == 8 and self.unit == 4 else [value]
            else:
                values = self.vector(state, each, source, max(1, width // self.unit))
            state.vectors[target.vector] = [*values, *[0] * (self.lanes - len(values))]

    def _shuffle(self, state: State, each: Instruction) -> None:
        """Permute numbers of two vectors, in steps of four bytes."""
        *first, source, target = each.operands
        pattern = first[0].immediate or 0 if first else 0
        name, four = each.name, range(4)
        if name in ("shufps", "pshufd"):
            places = [(pattern >> 2 * i & 3) + 4 * (name == "shufps" and i > 1) for i in four]
            places = [4 + place for place in places] if name == "pshufd" else places
        elif name == "shufpd":
            places = [2 * (pattern & 1), 2 * (pattern & 1) + 1, 4 + 2 * (pattern >> 1 & 1), 5 + 2 * (pattern >> 1 & 1)]
        elif name in ("unpcklps", "punpckldq"):
            places = [0, 4, 1, 5]
        elif name in ("unpckhps", "punpckhdq"):
            places = [2, 6, 3, 7]
        else:
            places = {"unpcklpd": [0, 1, 4, 5], "punpcklqdq": [0, 1, 4, 5], "unpckhpd": [2, 3, 6, 7],
                      "punpckhqdq": [2, 3, 6, 7], "movddup": [4, 5, 4, 5]}[name]  # fmt: skip
        count = self.lanes // 2 if name == "movddup" else self.lanes
        given = self.vector(state, each, source, count)
        both = [*state.vectors[target.vector], *given, *[self.unset] * (self.lanes - count)]
        if self.unit == 8:
            pairs = list(zip(places[::2], places[1::2], strict=True))
            made = [both[a // 2] if not a % 2 and b == a + 1 else
                    self._joined(*(self._half(both[place // 2], place % 2 * 4, 4) for place in (a, b)))
                    for a, b in pairs]  # fmt: skip
            state.vectors[target.vector] = made
        else:
            state.vectors[target.vector] = [both[place] for place in places]

    def _convert(self, state: State, each: Instruction, _: str) -> None:
        """Convert a known integer to a number."""
        source, target = each.operands
        width = REGISTERS[source.register][1] if source.register else WIDTHS.get(each.name[-1], 4)
        made = self.trees.lift(lambda v: self.trees.constant(signed(self._known(v), width)),
                               self.get(state, each, source, width))  # fmt: skip
        self._set(state, target, [made])

    def _shift(self, state: State, each: Instruction, direction: str) -> None:
        """Shift a vector by whole numbers."""
        amount, target = each.operands
        count, rest = divmod(amount.immediate or 0, self.unit)
        if rest:
            raise Declined(f"{each.text}: it tears numbers apart")
        kept = state.vectors[target.vector]
        kept = [*kept[count:], *[0] * count] if direction == "r" else [*[0] * count, *kept[: self.lanes - count]]
        state.vectors[target.vector] = kept

    def _shift_bits(self, state: State, each: Instruction, direction: str, kind: str, letter: str) -> None:
        """Shift the bits of patterns, such as those of comparisons."""
        amount, target = each.operands
        width, count = WIDTHS.get(letter, 4), amount.immediate
        if count is None or width > self.unit:
            raise Declined(f"no instruction that is known: {each.text}")
        ones = (1 << 8 * width) - 1

        def leaf(value: Any) -> Any:
            if not isinstance(value, int):
                return self.trees.unknown(each.name, value)
            made = 0
            for start in range(0, 8 * self.unit, 8 * width):
                part = value >> start & ones
                part = signed(part, width) if kind == "a" else part
                made |= (part >> count if direction == "r" else part << count & ones) % (ones + 1) << start
            return made

        state.vectors[target.vector] = [self.trees.lift(leaf, value) for value in state.vectors[target.vector]]


VECTOR_TABLE = (
    (r"(add|sub|mul|div|min|max|sqrt)([sp])(?P<real>[sd])", "_operation"),
    (r"(and|andn|or|xor)p[sd]", "_bitwise"),
    (r"p(and|andn|or|xor)", "_bitwise"),
    (r"cmp(eq|lt|le|unord|neq|nlt|nle|ord)([sp])(?P<real>[sd])", "_compare"),
    (r"u?comis(?P<real>[sd])", "_compare_one"),
    (r"mov(?:a|u)p[sd]|movdq[au]", "_move"),
    (r"movs([sd])", "_move_scalar"),
    (r"mov([lh])p[sd]", "_move_half"),
    (r"mov(hl|lh)ps", "_move_across"),
    (r"mov([dq])", "_move_integer"),
    (r"shufp[sd]|unpck[lh]p[sd]|pshufd|punpck[lh](?:qdq|dq)|movddup", "_shuffle"),
    (r"cvtsi2s(?P<real>[sd])[lq]?", "_convert"),
    (r"ps([lr])ldq", "_shift"),
    (r"ps([lr])([la])([qd])", "_shift_bits"),
)
"""Patterns of instructions on vectors, and the methods that execute them on what their groups name."""
