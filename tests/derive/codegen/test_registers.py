"""Register allocation: every value is still in its place when it is read, and few places do."""

from __future__ import annotations

import pytest

from derive.codegen.inplace import two_forms
from derive.codegen.lowering import RECIPES
from derive.codegen.program import Program, Step
from derive.codegen.registers import MASK_OPS, place

ORDERS = (1, 2, 3, 5, 8, 16)


def programs():
    return [pytest.param(recipe(n), id=f"{name}-{n}") for n in ORDERS for name, recipe in RECIPES.items()]


class Machine:
    """Executes a placement on names: what stands in each place."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self.placement = place(program)
        self.steps = {step.name: step for step in program.steps}
        self.standing: dict[tuple[str, int], str] = {}

    def run(self) -> None:
        done = set()
        for statement in self.placement.statements:
            self.evaluate(statement, done)
        assert done == set(self.steps)

    def evaluate(self, step: Step, done: set[str]) -> None:
        operands = [arg for arg in step.args if isinstance(arg, str) and arg in self.steps]
        for arg in operands:
            if self.steps[arg].inline and arg not in done:
                self.evaluate(self.steps[arg], done)
        for arg in operands:
            assert self.standing[self.placement.places[arg]] == arg, f"{arg} is gone when {step.name} reads it"
        here = self.placement.places[step.name]
        if step.op == "where" and isinstance(step.args[2], str):
            assert self.placement.places.get(step.args[2]) != here
        assert here[0] != "o" or here not in self.standing
        self.standing[here] = step.name
        done.add(step.name)


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
    for step in program.steps:
        kind, index = placement.places[step.name]
        assert kind == ("mask" if step.op in MASK_OPS else kind)
        assert index <= {"k": placement.registers, "mask": placement.masks, "o": len(program.outputs)}[kind]


@pytest.mark.parametrize(("name", "most"), [("quaternion", 5), ("pose", 8), ("tangent", 11), ("rate", 13)])
def test_few_registers_do(name: str, most: int):
    assert place(RECIPES[name](3)).registers <= most


def test_the_text_of_a_short_program():
    lines = two_forms(RECIPES["from_screw"](3)).blocks.splitlines()
    assert lines[0].strip() == "alpha, d = angle"
    assert "    r = tan(div(alpha, n6, k1), k1)" in lines
    assert lines[-1].strip().endswith(", o6)")
