"""Register allocation: every value is still in its place when it is read, and few places do."""

from __future__ import annotations

import pytest
from derive.codegen.programs.registers import MASK_OPS, place, results

from derive.codegen.lowered import geometry, lower_chart
from derive.codegen.programs.program import Call, Program, Step
from derive.codegen.targets.numpy import two_scalar_forms
from derive.maps import Cayley

ORDERS = (1, 2, 3, 5, 8, 16)


def programs():
    shared = [pytest.param(program, id=name) for name, program in geometry().items()]
    for n in ORDERS:
        lowered = lower_chart(Cayley(n))
        shared += [pytest.param(program, id=f"scalars-{name}-{n}") for name, program in lowered.scalars.items()]
    return shared


class Machine:
    """Executes a placement on names: what stands in each place."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self.placement = place(program)
        self.makers = {name: statement for statement in program.statements for name in results(statement)}
        self.standing: dict[tuple[str, int], str] = {}

    def run(self) -> None:
        done = set()
        for statement in self.placement.statements:
            self.evaluate(statement, done)
        assert done == set(self.makers)

    def evaluate(self, statement: Step | Call, done: set[str]) -> None:
        operands = [arg for arg in statement.args if isinstance(arg, str) and arg in self.makers]
        for arg in operands:
            if getattr(self.makers[arg], "inline", False) and arg not in done:
                self.evaluate(self.makers[arg], done)
        for arg in operands:
            assert self.standing[self.placement.places[arg]] == arg, f"{arg} is gone when {statement} reads it"
        if isinstance(statement, Call):
            self.check_call(statement, operands)
        elif statement.op == "where" and isinstance(statement.args[2], str):
            assert self.placement.places.get(statement.args[2]) != self.placement.places[statement.name]
        for name in results(statement):
            here = self.placement.places[name]
            assert here[0] != "o" or here not in self.standing
            self.standing[here] = name
            done.add(name)

    def check_call(self, call: Call, operands: list[str]) -> None:
        """A function writes results and borrowed registers while it reads its arguments, and keeps nothing it lent."""
        written = [self.placement.places[name] for name in results(call)]
        lent = self.placement.free[results(call)[0]]
        assert len({*written, *lent}) == len(written) + len(lent)
        assert not {self.placement.places[arg] for arg in operands} & {*written, *lent}
        for place_ in lent:
            self.standing[place_] = "borrowed"


@pytest.mark.parametrize("program", programs())
def test_every_value_stands_where_it_is_read_and_every_output_is_written_once(program: Program):
    machine = Machine(program)
    machine.run()
    copied = {index for _, index in machine.placement.copies}
    for index, output in enumerate(program.outputs, 1):
        if index not in copied:
            assert machine.standing["o", index] == output


@pytest.mark.parametrize("program", programs())
def test_masks_and_numbers_have_registers_of_their_own(program: Program):
    placement = place(program)
    truths = {step.name for step in program.steps if step.op in MASK_OPS}.union(*(c.truths for c in program.calls))
    for name, (kind, index) in placement.places.items():
        assert (kind == "mask") == (name in truths) or kind == "o"
        assert index <= {"k": placement.registers, "mask": placement.masks, "o": len(program.outputs)}[kind]


@pytest.mark.parametrize(("name", "most"), [("quaternion", 5), ("pose", 8), ("tangent", 13), ("rate", 13)])
def test_few_registers_do(name: str, most: int):
    assert place(geometry()[name]).registers <= most


def test_the_text_of_a_short_program():
    lines = two_scalar_forms(lower_chart(Cayley(3)).scalars["coefficient"]).blocks.splitlines()
    assert lines[0].strip() == "o1, o2 = out"
    assert "    r = tan(div(alpha, n6, o1), o1)" in lines  # what will be a result is a register before
    assert lines[-1].strip() == "return o1, o2"


def test_a_result_that_stands_elsewhere_is_copied_unless_it_is_constant():
    """Geometry uses the places of results again: g = h of n = 2 must stand twice, the size 1 of n = 3 nowhere."""
    assert "copy(o2, o3)" in two_scalar_forms(lower_chart(Cayley(2)).scalars["tangent"]).blocks
    assert two_scalar_forms(lower_chart(Cayley(3)).scalars["ray"]).blocks.endswith("return o1, o2, n1, o4, o5, o6")
