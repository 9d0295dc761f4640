"""Translation of blocks of intermediate code to functions of a state, each made once."""

from __future__ import annotations

import struct
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

from .conditions import CONDITIONS
from .program import IDLE
from .trees import TYPES, Declined, Different, Tree
from .words import known

if TYPE_CHECKING:
    from .machine import Machine, State

REALS = {"Ity_F32": "float", "Ity_F64": "double"}
Part = Callable[["State", list[Any]], Any]
"""Statement or expression: a function of the state and of the values that its block has computed."""


class Translation:
    """Translation of the blocks that a machine executes."""

    def __init__(self, machine: Machine) -> None:
        self.machine = machine

    def statement(self, each: Any, block: Any) -> Part | None:
        """Return a statement as a function; that of a jump returns its address, or the other side."""
        tag, types = each.tag, block.tyenv
        if tag in IDLE:
            return None
        if tag == "Ist_Exit" and each.jk == "Ijk_SigSEGV":
            return self._alignment(each, block)
        if tag == "Ist_Exit":
            return self._exit(each, self.expression(each.guard, types))
        if tag not in ("Ist_WrTmp", "Ist_Put", "Ist_Store"):
            raise Declined(f"no statement that is known: {each}")
        value = self.expression(each.data, types)
        if tag == "Ist_WrTmp":
            place = each.tmp
            return lambda state, values: values.__setitem__(place, value(state, values))
        width = each.data.result_size(types) // 8
        if tag == "Ist_Put":
            offset = each.offset
            if offset in self.machine.modes:
                raise Declined("an instruction sets a mode of the machine, as that of rounding")
            return lambda state, values: state.registers.put(offset, value(state, values), width)
        address = self.expression(each.addr, types)
        return lambda state, values: self.machine.store(state, address(state, values), value(state, values), width)

    def _exit(self, each: Any, guard: Part) -> Part:
        target, jumps = each.dst.value, each.jk == "Ijk_Boring"

        def leave(state: State, values: list[Any]) -> Any:
            truth = guard(state, values)
            if isinstance(truth, Tree) and jumps:
                return truth, state.copy(), target
            if known(truth) and not jumps:
                raise Different(f"a fault of the kind {each.jk}")
            return target if truth else None

        return leave

    def _alignment(self, each: Any, block: Any) -> Part:
        """Return the test of an address that must be a multiple of 16 or 32; of arrays, no address need be."""
        made = {other.tmp: other.data for other in block.statements if other.tag == "Ist_WrTmp"}
        masked = made[made[each.guard.tmp].args[0].tmp]  # address & mask != 0
        guard, place = (self.expression(other, block.tyenv) for other in (each.guard, masked.args[0]))

        def test(state: State, values: list[Any]) -> None:
            address = known(place(state, values))
            if known(guard(state, values)) or not self.machine.fixed(address):
                raise Different(f"an access to memory at {address:#x}, which need not be aligned")

        return test

    def expression(self, each: Any, types: Any) -> Part:
        """Return an expression as a function of the state and of values that the block has computed."""
        words, tag = self.machine.words, each.tag
        if tag == "Iex_RdTmp":
            place = each.tmp
            return lambda state, values: values[place]
        if tag == "Iex_Const":
            constant = self._constant(each.con)
            return lambda state, values: constant
        width = 0 if tag == "Iex_CCall" else each.result_size(types) // 8
        if tag == "Iex_Get":
            offset = each.offset
            return lambda state, values: state.registers.take(offset, width)
        if tag == "Iex_Load":
            address = self.expression(each.addr, types)
            return lambda state, values: self.machine.load(state, address(state, values), width)
        if tag == "Iex_ITE":
            given = [self.expression(other, types) for other in (each.cond, each.iftrue, each.iffalse)]
            function: Callable[..., Any] = partial(self.machine.trees.lift, self.machine.trees.select)
        elif tag in ("Iex_Unop", "Iex_Binop", "Iex_Triop", "Iex_Qop"):
            if each.op.startswith(self.machine.convention.misread):
                raise Declined(f"an instruction whose intermediate code is not exact: {each.op}")
            given = [self.expression(other, types) for other in each.args]
            function = words.operation(each.op)
        elif tag == "Iex_CCall" and each.cee.name in CONDITIONS:
            given = [self.expression(other, types) for other in each.args]
            function = partial(self.machine.trees.lift, CONDITIONS[each.cee.name])
        else:
            raise Declined(f"no expression that is known: {each}")
        return lambda state, values: function(*[other(state, values) for other in given])

    def _constant(self, constant: Any) -> Any:
        value, type_ = constant.value, constant.type
        if type_ in REALS and not isinstance(value, int):
            _, code, pattern = TYPES[REALS[type_]]
            return struct.unpack(pattern, struct.pack(code, value))[0]
        return value
