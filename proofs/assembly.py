"""Text of ``objdump`` as instructions by address, with symbols, constants and the graph of jumps."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

from .rounded import Declined

EXIT = -1  # where a function returns, in its graph
FIRST = ("rax", "rcx", "rdx", "rbx", "rsp", "rbp", "rsi", "rdi")
REGISTERS: dict[str, tuple[str, int]] = {"rip": ("rip", 8)}
"""Whole register and width in bytes of each integer register."""
for _name in FIRST:
    _low = f"{_name[1]}l" if _name[2] == "x" else f"{_name[1:]}l"
    REGISTERS |= {_name: (_name, 8), f"e{_name[1:]}": (_name, 4), _name[1:]: (_name, 2), _low: (_name, 1)}
for _number in range(8, 16):
    REGISTERS |= {f"r{_number}{end}": (f"r{_number}", width) for end, width in (("", 8), ("d", 4), ("w", 2), ("b", 1))}
PREFIXES = ("rep", "repz", "bnd", "notrack", "data16", "cs", "lock")


class Memory(NamedTuple):
    """Operand in memory: displacement, base, index and scale."""

    displacement: int
    base: str
    other: str
    scale: int


class Operand(NamedTuple):
    """Operand of an instruction; exactly one of its parts is set."""

    register: str = ""
    vector: str = ""
    immediate: int | None = None
    memory: Memory | None = None


class Instruction(NamedTuple):
    """Instruction with its address, that of the next one, and the address where it jumps."""

    address: int
    next: int
    name: str
    operands: tuple[Operand, ...]
    target: int | None
    text: str


class Code(dict[int, Instruction]):
    """Instructions by address, each read from its line when it is first asked for."""

    def __init__(self) -> None:
        super().__init__()
        self.lines: dict[int, tuple[int, str]] = {}

    def __missing__(self, address: int) -> Instruction:
        if address not in self.lines:
            raise Declined(f"no instruction at {address:#x}")
        self[address] = _instruction(address, *self.lines[address])
        return self[address]


@dataclass
class Listing:
    """Instructions and constants of a program, and the names of its functions."""

    code: Code = field(default_factory=Code)
    functions: dict[str, int] = field(default_factory=dict)
    names: dict[int, str] = field(default_factory=dict)
    data: dict[int, int] = field(default_factory=dict)
    joins: dict[int, int] = field(default_factory=dict)

    def follow(self, address: int) -> list[int]:
        """Return the addresses after an instruction; calls return, and a jump to a library function returns."""
        each = self.code[address]
        if each.name == "ret" or (each.name == "jmp" and (each.target is None or self.library(each.target))):
            return [EXIT]
        if each.name == "jmp":
            return [each.target]  # type: ignore[list-item]
        if each.name.startswith("j"):
            return [each.target, each.next]  # type: ignore[list-item]
        return [each.next]

    def library(self, address: int) -> str:
        """Return the name of the library function at an address, or an empty text."""
        name = self.names.get(address, "")
        return name.partition("@")[0] if "@" in name else ""

    def reached(self, start: int) -> set[int]:
        """Return the addresses of all instructions that a function may execute, other functions that it calls too."""
        found, waiting = set[int](), [start]
        while waiting:
            address = waiting.pop()
            if address == EXIT or address in found or self.library(address):
                continue
            found.add(address)
            waiting += self.follow(address)
            if self.code[address].name == "call" and self.code[address].target is not None:
                waiting.append(self.code[address].target)  # type: ignore[arg-type]
        return found

    def join(self, address: int) -> int:
        """Return the first address that every way from a jump passes."""
        if address not in self.joins:
            self._find_joins(address)
        return self.joins[address]

    def _find_joins(self, start: int) -> None:
        """Find the immediate postdominators of all instructions from an address on (Cooper, Harvey, Kennedy)."""
        before: dict[int, list[int]] = {EXIT: []}
        waiting = [start]
        while waiting:
            address = waiting.pop()
            for after in self.follow(address):
                if after not in before:
                    before[after] = []
                    waiting.append(after)
                before[after].append(address)
        order = list(_postorder(EXIT, before))
        number = {address: place for place, address in enumerate(order)}
        joins = {EXIT: EXIT}
        changed = True
        while changed:
            changed = False
            for address in reversed(order[:-1]):
                made = EXIT
                known = [after for after in self.follow(address) if after in joins]
                for place, after in enumerate(known):
                    made = after if not place else _common(made, after, joins, number)
                changed |= joins.get(address) != made
                joins[address] = made
        self.joins |= joins


def _postorder(start: int, graph: dict[int, list[int]]) -> Iterator[int]:
    seen, stack = {start}, [(start, iter(graph[start]))]
    while stack:
        node, rest = stack[-1]
        for each in rest:
            if each not in seen:
                seen.add(each)
                stack.append((each, iter(graph.get(each, []))))
                break
        else:
            stack.pop()
            yield node


def _common(a: int, b: int, joins: dict[int, int], number: dict[int, int]) -> int:
    while a != b:
        while number[a] < number[b]:
            a = joins[a]
        while number[b] < number[a]:
            b = joins[b]
    return a


def read(text: str) -> Listing:
    """Read what ``objdump -dsw --no-show-raw-insn`` prints."""
    made, lines, section = Listing(), list[tuple[int, str]](), ""
    for line in text.splitlines():
        if found := re.match(r"Contents of section (\S+):", line):
            section = found[1]
        elif line.startswith("Disassembly of section"):
            section = ""
        elif found := re.match(r"([0-9a-f]+) <(.+)>:$", line):
            made.functions.setdefault(found[2], int(found[1], 16))
            made.names[int(found[1], 16)] = found[2]
        elif section:
            if (found := re.match(r" ([0-9a-f]+) ((?:[0-9a-f]{2,8} ){1,4})", line)) and "rodata" in section:
                bytes_ = bytes.fromhex(found[2].replace(" ", ""))
                made.data |= {int(found[1], 16) + place: byte for place, byte in enumerate(bytes_)}
        elif found := re.match(r" *([0-9a-f]+):\s+(\S.*)$", line):
            lines.append((int(found[1], 16), found[2]))
    for place, (address, body) in enumerate(lines):
        after = lines[place + 1][0] if place + 1 < len(lines) else address
        made.code.lines[address] = (after, body)
    return made


def _instruction(address: int, after: int, text: str) -> Instruction:
    text = re.sub(r"\s+#.*$", "", text).strip()
    words = text.split(None, 1)
    while len(words) > 1 and words[0] in PREFIXES:
        words = words[1].split(None, 1)
    name, rest = words[0], words[1] if len(words) > 1 else ""
    target = re.match(r"([0-9a-f]+) <", rest)
    operands = () if target or not rest or name.startswith(("j", "call", "nop")) else tuple(map(_operand, _split(rest)))
    return Instruction(address, after, name, operands, int(target[1], 16) if target else None, text)


def _split(text: str) -> list[str]:
    return [each.strip() for each in re.split(r",(?![^(]*\))", text)]


def _operand(text: str) -> Operand:
    if text.startswith("$"):
        return Operand(immediate=int(text[1:], 0))
    if text.startswith("%"):
        name = text[1:]
        return Operand(register=name) if name in REGISTERS else Operand(vector=name)
    found = re.fullmatch(r"(-?0x[0-9a-f]+|-?\d+)?(?:\((%\w+)?(?:,(%\w+),(\d))?\))?", text)
    if not found:
        return Operand(vector=text)  # no operand that is executed
    base, index = ((each or "")[1:] for each in (found[2], found[3]))
    return Operand(memory=Memory(int(found[1] or "0", 0), base, index, int(found[4] or 1)))
