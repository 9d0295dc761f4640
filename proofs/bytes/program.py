"""Compiled functions as blocks of intermediate code, with the graph of their jumps.

The library cle loads a file and pyvex translates its instructions; both come with ``pip install '.[bytes]'``.
"""

from __future__ import annotations

import logging
import re
from functools import cached_property
from pathlib import Path
from typing import Any

from ..statements import MachineError
from .trees import Declined, Different

IDLE = ("Ist_IMark", "Ist_AbiHint", "Ist_NoOp")  # statements without effect
EXIT = -1  # where a function returns, in its graph
FUSED = ((0xBF20FC00, 0x0E20CC00), (0xAF80B400, 0x0F801000), (0xFF000000, 0x1F000000))
"""Masks and values of AArch64's fused operations, which the translation to intermediate code rounds twice."""
EXTENDED = ((0xAFA0FC00, 0x0E20DC00), (0xAF80F400, 0x2F809000))
"""Masks and values of AArch64's fmulx, which the translation takes for a product; 0 times infinity is 2."""
BYTES = 256  # a block ends before an address that is a multiple of this: blocks from different starts fall together


class Program:
    """File of machine code: an object, a library or a program."""

    def __init__(self, path: Path) -> None:
        try:
            import cle
            import pyvex
        except ImportError as error:
            raise MachineError("python -m proofs.bytes needs cle: pip install '.[bytes]'", 3) from error
        logging.getLogger("cle").setLevel(logging.CRITICAL)
        logging.getLogger("pyvex").setLevel(logging.CRITICAL)
        try:
            self.loader = cle.Loader(str(path), auto_load_libs=False)
        except (cle.CLEError, OSError) as error:
            raise MachineError(f"{path}: no file of machine code: {error}", 2) from error
        self.file: Any = self.loader.main_object
        self.memory: Any = self.loader.memory
        self.lift = pyvex.lift
        self.blocks: dict[int, Any] = {}
        self.instructions: dict[int, frozenset[int]] = {}
        self.orders: dict[int, dict[int, int]] = {}
        self.sections: dict[int, bytes] = {}

    @property
    def architecture(self) -> str:
        return str(self.file.arch.name)

    @cached_property
    def functions(self) -> dict[str, int]:
        """Addresses of the functions that the file defines."""
        return {each.name: each.rebased_addr for each in self.file.symbols
                if each.is_function and not each.is_import and each.size}  # fmt: skip

    def read(self, address: int, size: int) -> bytes:
        """Return bytes of a section, each read once: cle searches all parts of a file."""
        section = self.file.find_section_containing(address)
        if section is None:
            return bytes(self.memory.load(address, size))
        if section.vaddr not in self.sections:
            self.sections[section.vaddr] = bytes(self.memory.load(section.vaddr, section.memsize))
        return self.sections[section.vaddr][address - section.vaddr : address - section.vaddr + size]

    def inside(self, address: int) -> bool:
        """Return whether an address holds code of the file."""
        return self.file.contains_addr(address) and not self.library(address)

    def library(self, address: int) -> str:
        """Return the name of the function of another library at an address, or an empty text."""
        found = None if self.file.contains_addr(address) else self.loader.find_symbol(address)
        return found.name if found else ""

    def constant(self, address: int, width: int) -> int | None:
        """Return the constant at an address, or None if it does not lie in data that no program changes."""
        section = self.file.find_section_containing(address)
        if section is None or (section.is_writable and not section.name.startswith(".got")):
            return None
        found = self.read(address, width)
        return int.from_bytes(found, "little") if len(found) == width else None

    def block(self, address: int) -> Any:
        """Return the block of instructions from an address up to the next jump."""
        if address not in self.blocks:
            if not self.inside(address):
                raise Declined(f"a jump to {address:#x}, outside of the code")
            longest = BYTES - address % BYTES
            made = self._lifted(address, longest)
            if made.jumpkind == "Ijk_NoDecode":  # the last instruction lies across the boundary
                made = self._lifted(address, longest + 16, max(1, made.instructions))
            if made.jumpkind == "Ijk_NoDecode":
                raise Declined(f"no instruction that is known: {self.read(address, 8).hex()}")
            if self.architecture == "AARCH64":
                self._refuse_fused(address, made.size)
            self.blocks[address], self.instructions[address] = made, frozenset(made.instruction_addresses)
        return self.blocks[address]

    def _refuse_fused(self, address: int, size: int) -> None:
        for place in range(address, address + size, 4):
            word = int.from_bytes(self.read(place, 4), "little")
            if any(word & mask == value for mask, value in FUSED):
                raise Different(f"{place:#x}: a fused multiply-add rounds once where the text rounds twice")
            if any(word & mask == value for mask, value in EXTENDED):
                raise Declined(f"{place:#x}: fmulx, whose intermediate code is not exact")

    def _lifted(self, address: int, size: int, count: int | None = None) -> Any:
        code = self.read(address, size)
        return self.lift(code, address, self.file.arch, max_bytes=size, max_inst=count, opt_level=1)

    def follow(self, address: int) -> list[int]:
        """Return the addresses after a block; calls return, and a jump to another library returns."""
        block, targets = self.block(address), self.targets(address)
        if block.jumpkind == "Ijk_Call":
            return [address + block.size]
        after = [each for each in targets if not self.library(each)]
        return after if block.jumpkind == "Ijk_Boring" and targets and len(after) == len(targets) else [*after, EXIT]

    def targets(self, address: int) -> list[int]:
        """Return the known addresses to which a block jumps; faults, as of unaligned memory, have none."""
        found = self.block(address).constant_jump_targets_and_jumpkinds
        return [each for each, kind in found.items() if kind in ("Ijk_Boring", "Ijk_Call")]

    def reached(self, start: int) -> set[int]:
        """Return the instructions that a function may execute, those of functions that it calls too."""
        found, waiting = set[int](), [start]
        while waiting:
            address = waiting.pop()
            if address == EXIT or address in found or self.library(address):
                continue
            found.add(address)
            waiting += [*self.follow(address), *self.targets(address)]
        self._refuse_wide(found)
        return set[int]().union(*(self.instructions[each] for each in found if not self._jumps_alone(each)))

    def _refuse_wide(self, blocks: set[int]) -> None:
        """Raise for fused operations and for AVX, of which pyvex misreads a move between registers."""
        halves = {place for name, (place, _) in self.file.arch.registers.items() if re.fullmatch(r"ymm\d+hx", name)}
        every = [each for address in blocks for each in self.block(address).statements]
        if any(re.match(r"Iop_N?M(Add|Sub)", getattr(part, "op", "")) for each in every for part in each.expressions):
            raise Different("a fused multiply-add rounds once where the text rounds twice")
        if any(each.tag == "Ist_Put" and each.offset in halves for each in every):
            raise Declined("instructions of AVX")

    def _jumps_alone(self, address: int) -> bool:
        """Return whether a block is a jump and nothing else; a compiler may leave one that no way takes."""
        block = self.block(address)
        return block.instructions == 1 and all(each.tag in IDLE for each in block.statements)

    def order(self, start: int) -> dict[int, int]:
        """Return the places of a function's blocks: each comes after those that lead to it, but for loops."""
        if start not in self.orders:
            done, seen, waiting = list[int](), {EXIT}, [(start, False)]
            while waiting:
                each, left = waiting.pop()
                if left:
                    done.append(each)
                elif each not in seen:
                    seen.add(each)
                    waiting += [(each, True), *((after, False) for after in self.follow(each))]
            self.orders[start] = {each: place for place, each in enumerate([*reversed(done), EXIT])}
        return self.orders[start]
