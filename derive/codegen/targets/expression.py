"""Printer of a program's steps as expressions, with a dialect for each language that has infix operators.

A dialect gives the notation and the binding strength of operators, which determine the brackets. An operand keeps its
brackets if the language would read, round or warn otherwise without them.
"""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from ..programs.program import Call, Operand, Program, Statement, Step

WIDTH = 120
ATOM = 9
NEGATION = 6
_BREAKS = {"+", "-", "*", "/", "&", "|", "<", "==", "?", ":"}

Text = tuple[str, int]
"""Source text and the binding strength of its outermost operator."""

Texts = list[str | list[str]]
"""Right-hand side alone, or the arguments of a call: numbers, names of lists, and lists of numbers."""


@dataclass(frozen=True, slots=True)
class Operator:
    """Infix operator: its strength, and the strength that each operand needs to stand without brackets."""

    symbol: str
    strength: int
    left: int
    right: int


def left_associative(symbol: str, strength: int) -> Operator:
    """Return an operator that brackets a right operand of equal strength: a * (b * c) rounds unlike a * b * c."""
    return Operator(symbol, strength, strength, strength + 1)


ARITHMETIC: dict[str, Operator] = {
    "add": left_associative("+", 4),
    "sub": left_associative("-", 4),
    "mul": left_associative("*", 5),
    "div": left_associative("/", 5),
}
"""Arithmetic operators, shared by all languages here."""


@dataclass(frozen=True, slots=True)
class Dialect:
    """Notation of a language for expressions.

    Parameters
    ----------
    operators : mapping
        Infix operators by operation.
    calls : mapping
        Functions by operation; an operation is either an operator or a function.
    select : callable
        Function that returns a selection, given the texts of the condition and two values.
    largest : int
        Largest magnitude of a constant.
    literal : callable
        Function that returns the text of a constant.
    passed : callable
        Function that returns the passed form of an argument's text.
    """

    operators: Mapping[str, Operator]
    calls: Mapping[str, str]
    select: Callable[[Text, Text, Text], Text]
    largest: float = float("inf")
    literal: Callable[[int], str] = str
    passed: Callable[[str], str] = str

    def expression(self, step: Step, inlined: Mapping[str, Text]) -> Text:
        """Return the right-hand side of a step, with inlined operands written out."""
        args = [self.operand(arg, inlined) for arg in step.args]
        if step.op in self.calls:
            return f"{self.calls[step.op]}({', '.join(text for text, _ in args)})", ATOM
        if step.op == "where":
            condition, first, second = args
            return self.select(condition, first, second)
        if step.op == "neg":
            return f"-{bracket(args[0], NEGATION)}", NEGATION
        operator = self.operators[step.op]
        left, right = bracket(args[0], operator.left), bracket(args[1], operator.right)
        return f"{left} {operator.symbol} {right}", operator.strength

    def operand(self, operand: Operand, inlined: Mapping[str, Text]) -> Text:
        """Return the text of a name, of an inlined expression, or of an integer."""
        if isinstance(operand, str):
            return inlined.get(operand, (operand, ATOM))
        if isinstance(operand, Fraction) and operand.denominator != 1:
            raise ValueError(f"constant {operand} is not an integer: divide instead, so that exact types stay exact")
        if not -self.largest <= operand <= self.largest:
            raise ValueError(f"constant {operand} is beyond {self.largest:.0f}: some number type would round it")
        text = self.literal(int(operand))
        return text, NEGATION if text.startswith("-") else ATOM

    def statements(self, program: Program, lists: Lists) -> tuple[list[tuple[Statement, Texts]], list[str]]:
        """Return named steps with right-hand sides, calls with arguments, and the texts of the outputs.

        A list that is used as a whole is given by its name; among outputs a star precedes the name.
        """
        inlined: dict[str, Text] = {}
        assignments: list[tuple[Statement, Texts]] = []

        def text(operand: Operand) -> str:
            return self.operand(operand, inlined)[0]

        def passed(group: Operand | tuple[Operand, ...]) -> str | list[str]:
            if not isinstance(group, tuple):
                return self.passed(text(group))
            return lists.whole.get(group) or [self.passed(text(operand)) for operand in group]

        for statement in program.statements:
            if isinstance(statement, Call):
                assignments.append((statement, list(map(passed, statement.groups))))
                continue
            found = self.expression(statement, inlined)
            if statement.inline:
                inlined[statement.name] = found
            else:
                assignments.append((statement, [found[0]]))
        outputs = (f"*{lists.whole[group]}" if isinstance(group, tuple) else text(group) for group in lists.outputs)
        return assignments, list(outputs)


class Lists:
    """Lists of components in a program, from arguments or geometry programs, passed on or returned as a whole.

    Attributes
    ----------
    whole : dict
        Names of the lists that are used as a whole, by their components.
    outputs : list
        Outputs of the program; consecutive components of a list form one tuple.
    read : set
        Components that are used one by one.
    returned : Call or None
        Last statement, if it is a call whose results are the program's outputs; otherwise None.
    """

    def __init__(self, program: Program) -> None:
        named: dict[tuple[Operand, ...], str]
        named = {names: argument for argument, names in program.inputs if names != (argument,)}
        made: dict[tuple[Operand, ...], str]
        made = {call.names: call.result for call in program.calls if call.result}
        named |= made
        groups = [group for call in program.calls for group in call.groups]
        self.outputs = list(_with_lists(program.outputs, made))
        used = [*groups, *self.outputs]
        self.whole = {group: named[group] for group in used if isinstance(group, tuple) and group in named}
        self.read: set[Operand] = {arg for step in program.steps for arg in step.args}
        for group in used:
            if group not in self.whole:
                self.read.update(group if isinstance(group, tuple) else (group,))

        *_, last = (None, *program.statements)
        ends = isinstance(last, Call) and last.result and last.names == program.outputs
        self.returned = last if ends else None

    def unpacked(self, names: Sequence[str], argument: str) -> Iterator[str]:
        """Yield an assignment to the names that are read, if there are any."""
        if self.read.intersection(names):
            shown = [name if name in self.read else "_" for name in names]
            yield f"{', '.join(shown)}{',' * (len(shown) == 1)} = {argument}"


def _with_lists(
    outputs: Sequence[Operand], named: Collection[tuple[Operand, ...]]
) -> Iterator[Operand | tuple[Operand, ...]]:
    """Yield outputs; consecutive components that make a whole list are one tuple."""
    lengths = sorted({len(names) for names in named}, reverse=True)
    place = 0
    while place < len(outputs):
        found = next((n for n in lengths if n > 1 and tuple(outputs[place : place + n]) in named), 0)
        yield tuple(outputs[place : place + found]) if found else outputs[place]
        place += found or 1


def bracket(text: Text, strength: int) -> str:
    """Return the text, in brackets if it binds more weakly than ``strength``."""
    return text[0] if text[1] >= strength else f"({text[0]})"


def renamed(program: Program, names: Mapping[str, str]) -> Program:
    """Return the program with some of its names replaced."""

    def new(operand: Operand) -> Operand:
        return names.get(operand, operand) if isinstance(operand, str) else operand

    def statement(old: Statement) -> Statement:
        args = tuple(map(new, old.args))
        if isinstance(old, Call):
            truths = frozenset(names.get(name, name) for name in old.truths)
            results = tuple(names.get(name, name) for name in old.names)
            return replace(old, names=results, args=args, truths=truths, result=names.get(old.result, old.result))
        return replace(old, name=names.get(old.name, old.name), args=args)

    return replace(
        program,
        inputs=tuple((argument, tuple(names.get(c, c) for c in parts)) for argument, parts in program.inputs),
        statements=tuple(map(statement, program.statements)),
        outputs=tuple(map(new, program.outputs)),
    )


def tuple_lines(names: Iterable[str]) -> str:
    """Return names as lines of a tuple."""
    return textwrap.fill(", ".join(names) + ",", WIDTH, initial_indent=" " * 8, subsequent_indent=" " * 8)


def fill(text: str, indent: str) -> Iterator[str]:
    """Yield lines of a long expression, broken before operators."""
    words = text.split(" ")
    line = words[0]
    for operator, operand in _pairs(words[1:]):
        chunk = f"{operator} {operand}" if operand else operator
        if len(indent) + len(line) + 1 + len(chunk) > WIDTH:
            yield indent + line
            line = chunk
        else:
            line += " " + chunk
    yield indent + line


def _pairs(words: list[str]) -> Iterator[tuple[str, str]]:
    """Yield each operator with its right operand, because lines break before operators."""
    operator = ""
    for word in words:
        if not operator and word in _BREAKS:
            operator = word
            continue
        yield (operator, word) if operator else (word, "")
        operator = ""
