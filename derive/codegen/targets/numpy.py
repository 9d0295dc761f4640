"""NumPy: the committed kernels, in two forms.

The plain form of a program runs on any number type. The other one is NumPy calls which write where the register
allocation says, so that no temporary is ever made: a statement keeps its name, ``x = add(add(v11, v22, k1), v33, k1)``,
since a call returns where it wrote. Scratch registers are ``k1, k2, ...``, mask registers ``mask1, ...``, outputs
``o1, ...``, and ``n2`` is 2. A call of a scalar program is lent places for its results and the registers that are free.
"""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Iterator, Mapping, Set
from dataclasses import dataclass
from itertools import chain

from ..lowered import Lowered, geometry
from ..package import Data, Facts, fingerprint
from ..programs.program import Call, Operand, Program, Step
from ..programs.registers import Placement, all_results, place, place_returned, results
from ..rows import Table
from ..signatures import POSES, ROTATIONS
from ..validation import Machinery
from . import infix, python
from .expression import WIDTH, fill

_FUNCTIONS = {
    "add": "add", "sub": "sub", "mul": "mul", "div": "div", "neg": "neg", "abs": "absolute", "sqrt": "sqrt",
    "tan": "tan", "atan2": "atan2", "expm1": "expm1", "log1p": "log1p", "lt": "m.less", "eq": "m.equal",
    "and": "m.both", "or": "m.either", "where": "m.where",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class TwoForms:
    """What the template shows of a program: its infix form, its in-place form, and what that needs.

    ``lent`` are the functions it calls, with how many registers of numbers and of masks it lends them.
    """

    plain: str
    blocks: str
    registers: int
    masks: int
    numbers: tuple[int, ...]
    lent: tuple[tuple[str, int, int], ...]


def two_scalar_forms(program: Program) -> TwoForms:
    """Print both forms of a scalar program: its parameters are components, its results are returned where they stand.

    A result that stands in an argument, or twice, is copied: the caller will use these places again. Constants may
    stand where they are.
    """
    placement = place_returned(program)
    printer = _Calls(program, placement)
    tables = {name for argument, names in program.inputs if argument == "table" for name in names}
    copied = {index for source, index in placement.copies if isinstance(source, str) and source not in tables}
    places = [f"o{i}" if i in copied else printer.place(output) for i, output in enumerate(program.outputs, 1)]
    copies = [f"copy({printer.place(source)}, o{i})" for source, i in placement.copies if i in copied]
    result = f"return {', '.join(places)}{',' * (len(places) == 1)}"
    return _forms(program, placement, infix.body(program, alone=True), (), (*copies, result), lent=True)


def two_forms(program: Program) -> TwoForms:
    """Print both forms of a program of a geometry, which calls scalar programs of a chart ``c``."""
    placement = place(program)
    copies = [f"copy({_Calls(program, placement).place(source)}, o{i})" for source, i in placement.copies]
    return _forms(program, placement, infix.body(program), _arguments(program), copies, lent=False)


def _forms(
    program: Program, placement: Placement, plain: str, before: Iterable[str], after: Iterable[str], lent: bool
) -> TwoForms:
    body = (*_calls(program, placement), *after)
    lines = (*before, *_registers(program, placement, lent, set(re.findall(r"\w+", " ".join(body)))), *body)
    blocks = "\n".join(line for text in lines for line in _wrap(text, "    "))
    loans = tuple((call.function, *_counts(placement, call)) for call in program.calls)
    return TwoForms(plain, blocks, placement.registers, placement.masks, program.constants, loans)


def _counts(placement: Placement, call: Call) -> tuple[int, int]:
    kinds = [kind for kind, _ in placement.free[results(call)[0]]]
    return kinds.count("k"), kinds.count("mask")


def _arguments(program: Program) -> Iterator[str]:
    used = program.operands
    for argument, names in program.inputs:
        if names:
            yield infix.unpacked([name if name in used else "_" for name in names], argument)


def _registers(program: Program, placement: Placement, lent: bool, used: Set[str]) -> Iterator[str]:
    """Names of outputs, registers and constants. What is lent may be more; what is not used here is spare for calls."""
    fixed = {
        "out": [f"o{i}" for i in range(1, len(program.outputs) + 1)],
        "scratch": [f"k{i}" for i in range(1, placement.registers + 1)],
        "masks": [f"mask{i}" for i in range(1, placement.masks + 1)],
        "numbers": [_number(value) for value in program.constants],
    }
    if taken := program.operands.intersection(chain(*fixed.values())):
        raise ValueError(f"program {program.name!r} uses names of registers: {', '.join(map(str, taken))}")
    for argument, rest in (("scratch", "*spare"), ("masks", "*spare_masks")):
        if program.calls:
            fixed[argument].append(rest)
        elif lent and fixed[argument]:
            fixed[argument].append("*_")
    for argument, names in fixed.items():
        shown = [name if name in used or name.startswith("*") else "_" for name in names]
        if any(name != "_" for name in shown) and shown != ["*_"]:
            yield infix.unpacked(shown, argument)


def _calls(program: Program, placement: Placement) -> Iterator[str]:
    printer = _Calls(program, placement)
    read = {arg for statement in program.statements for arg in statement.args}
    for statement in placement.statements:
        if isinstance(statement, Call):
            names = [name if name in read else "_" for name in statement.names]
            yield infix.unpacked(names, printer.lend(statement))
        else:
            named = statement.name in read and not statement.inline
            yield (f"{statement.name} = " if named else "") + printer.call(statement)


def _number(value: int) -> str:
    return f"n{value}" if value >= 0 else f"n_minus_{-value}"


class _Calls:
    """Texts of the NumPy calls of a program; inline operands are calls inside the call that reads them."""

    def __init__(self, program: Program, placement: Placement) -> None:
        self.steps = {step.name: step for step in program.steps}
        self.places = placement.places
        self.free = placement.free

    def call(self, step: Step) -> str:
        return f"{_FUNCTIONS[step.op]}({', '.join(map(self.operand, step.args))}, {self.place(step.name)})"

    def lend(self, call: Call) -> str:
        """The call of a scalar program, which gets places for its results and the registers that are free."""
        free = [f"{kind}{index}" for kind, index in self.free[results(call)[0]]]
        scratch = [name for name in free if name.startswith("k")] + ["*spare"]
        masks = [name for name in free if name.startswith("mask")] + ["*spare_masks"]
        groups = [_tuple([self.place(name) for name in all_results(call)]), _tuple(scratch), _tuple(masks)]
        rest = [f"*{call.rest}"] if call.rest else []
        return f"c.{call.function}({', '.join([*groups, *map(self.operand, call.args), *rest])})"

    def place(self, operand: Operand) -> str:
        """Where a value stands, for an output that is written a second time."""
        if isinstance(operand, str) and operand in self.places:
            kind, index = self.places[operand]
            return f"{kind}{index}"
        return self.operand(operand)

    def operand(self, operand: Operand) -> str:
        if not isinstance(operand, str):
            return _number(int(operand))
        step = self.steps.get(operand)
        if step is None or not step.inline:
            return operand
        return self.call(step)


def _tuple(items: list[str]) -> str:
    return f"({', '.join(items)}{',' * (len(items) == 1)})"


def _wrap(statement: str, indent: str) -> Iterator[str]:
    """Lines of a statement; a long call breaks inside its brackets, a long list of names goes into brackets."""
    if len(indent + statement) <= WIDTH:
        yield indent + statement
    elif statement.endswith(")"):
        head, _, inner = statement[:-1].partition("(")
        yield f"{indent}{head}("
        yield from fill(inner, indent + "    ")
        yield f"{indent})"
    else:
        names, argument = statement.split(" = ")
        yield f"{indent}("
        yield from fill(f"{names},", indent + "    ")
        yield f"{indent}) = {argument}"


def _called(printed: Iterable[python.Printed]) -> list[str]:
    """The functions of ``_kernel`` that in-place forms call."""
    texts = "".join(program.forms.blocks for program in printed)
    names = ("copy", *(name for name in _FUNCTIONS.values() if "." not in name))
    return sorted(name for name in names if re.search(rf"\b{name}\(", texts))


WORDS = python.Words(
    value="ArrayLike",
    array_like="array_like",
    array="ndarray",
    kept="float32, float64 and longdouble",
    options="*, axis: int = -1, out: Array | None = None",
    passed="axis, out",
    passed_alone="axis, None",
    placed="axis, out",
    makes=True,
)


class Numpy(python.PythonTarget):
    """The target of the committed kernels."""

    name = "numpy"
    words = WORDS
    tables = (POSES, ROTATIONS)
    uncompiled = WORDS.plain
    machinery = Machinery(few="_runtime.FEW", block="_kernel.BLOCK")
    unproved = "rounding errors, which are measured; NumPy itself"

    def shared(self) -> Mapping[str, Data]:
        return {
            **self.package(),
            **self.per_table(),
            "_branches.py": {},
            "_chart.py": {},
            "_checks.py": {"words": WORDS},
            "_kernel.py": {},
            "_native.py": {},
            "_runtime.py": {},
            "_selection.py": {},
            "_tools.py": {},
        }

    def geometry(self, table: Table) -> Data:
        programs = [python.printed(program, two_forms(program)) for program in geometry(table).values()]
        return {"programs": programs, "rows": table.kernels, "calls": _called(programs)}

    def programs(self, facts: Facts, lowered: Lowered, known: Container[str] = ()) -> Data:
        scalars = [
            python.printed(program, two_scalar_forms(program), python.components(program))
            for name, program in lowered.scalars.items()
            if name not in known
        ]
        own = [python.printed(program, two_forms(program)) for program in lowered.own.values()]
        return {
            "calls": _called((*scalars, *own)),
            "scalars": scalars,
            "own": own,
            "rows": lowered.table.kernels,
            "programs": fingerprint(facts, lowered),
        }
