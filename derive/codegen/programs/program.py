"""Straight-line programs, lowered from formulas (see ``trace``) and turned into source by printers."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from fractions import Fraction

Constant = int | Fraction
Operand = str | int | Fraction  # name of an input or step, or an exact constant
BESIDE = "beside"  # sum in the precision of the data; a plain sum in most languages
FUNCTIONS = ("reciprocal", "abs", "sqrt", "tan", "atan2", "expm1", "log1p")


@dataclass(frozen=True, slots=True)
class Assignment:
    """Assignment ``name = op(*args)``; an ``inline`` step is used once and printed inside its only reader."""

    name: str
    op: str
    args: tuple[Operand, ...]
    inline: bool


@dataclass(frozen=True, slots=True)
class Call:
    """Call of another program, which gives several values at once: ``f, g, h = pose(x)``."""

    names: tuple[str, ...]  # unread values have the name ``_``
    function: str
    args: tuple[Operand, ...]
    rest: str = ""  # argument of the caller whose components, of any number, follow ``args``
    truths: frozenset[str] = frozenset()  # names of the truth values
    lists: tuple[int, ...] = ()  # of a geometry program: lengths of list arguments in ``args``, 0 for a number
    result: str = ""  # of a geometry program: name of the list of all values
    context: str = ""  # of a geometry program: leading arguments among ``m`` and ``c``

    @property
    def groups(self) -> tuple[Operand | tuple[Operand, ...], ...]:
        """Return the arguments: numbers, and lists of numbers."""
        if not self.result:
            return self.args
        left, found = list(self.args), []
        for length in self.lists:
            found.append(tuple(left[:length]) if length else left[0])
            del left[: length or 1]
        return tuple(found)


Statement = Assignment | Call


@dataclass(frozen=True, slots=True)
class Program:
    """Assignments in order, from named inputs (grouped by argument) to outputs in C order."""

    name: str
    inputs: tuple[tuple[str, tuple[str, ...]], ...]
    statements: tuple[Statement, ...]
    outputs: tuple[Operand, ...]
    corrected: frozenset[str] = frozenset()  # values that are corrected afterwards, so that their rounding is harmless
    called: tuple[Program, ...] = ()  # geometry programs
    results: tuple[str, ...] = ()  # names of the outputs, for a program that others call
    contract: str = ""  # description of the outputs

    @property
    def context(self) -> str:
        """Leading arguments: ``m`` (functions of numbers) and ``c`` (the chart's scalars), ``m`` alone, or none."""
        if any(not call.result or "c" in call.context for call in self.calls):
            return "m, c"
        functions = {*FUNCTIONS, "where", BESIDE}.intersection(self.operations)
        return "m" if functions or any(call.context for call in self.calls) else ""

    @property
    def steps(self) -> tuple[Assignment, ...]:
        return tuple(statement for statement in self.statements if isinstance(statement, Assignment))

    @property
    def calls(self) -> tuple[Call, ...]:
        return tuple(statement for statement in self.statements if isinstance(statement, Call))

    @property
    def conditions(self) -> dict[Operand, frozenset[tuple[Operand, bool]]]:
        """Return for each operand the conditions, with a truth value, outside which no result depends on it."""
        found: dict[Operand, frozenset[tuple[Operand, bool]]] = dict.fromkeys(self.outputs, frozenset())
        for statement in reversed(self.statements):
            of = found.get(statement.name, frozenset()) if isinstance(statement, Assignment) else frozenset()
            chosen = isinstance(statement, Assignment) and statement.op == "where"
            for place, arg in enumerate(statement.args):
                needed = of | {(statement.args[0], place == 1)} if chosen and place else of
                found[arg] = found.get(arg, needed) & needed
        return found

    @property
    def operations(self) -> Counter[str]:
        """Count each operation, without operations inside calls."""
        return Counter(step.op for step in self.steps)

    @property
    def constants(self) -> tuple[int, ...]:
        """Return the integers that are operands or results."""
        return tuple(sorted({int(operand) for operand in self.operands if not isinstance(operand, str)}))

    @property
    def operands(self) -> set[Operand]:
        """Return all operands of statements, and the outputs."""
        read = {arg for statement in self.statements for arg in statement.args}
        return read | set(self.outputs)
