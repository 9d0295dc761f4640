"""Printer of a program's steps as expressions, with a dialect for each language that has infix operators.

A dialect gives the notation and the binding strength of operators, which determine the brackets. An operand has
brackets wherever their absence would change the meaning or the rounding, or cause a warning.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from ..programs.program import BESIDE, FUNCTIONS, Assignment, Call, Operand, Program, Statement

WIDTH = 120
ATOM = 9
NEGATION = 6
SELECTION = 1
RECIPROCAL = "reciprocal"
BINARY = r"(?:[-+*/&|<?:]|==)"  # pattern of infix operators, before which lines break
Text = tuple[str, int]  # source text and the binding strength of its outermost operator
Texts = list[str | list[str]]
"""Right-hand side alone, or the arguments of a call: numbers, names of lists, and lists of numbers."""


@dataclass(frozen=True, slots=True)
class Operator:
    """Infix operator: its strength, and the strength that each operand needs to stand without brackets."""

    symbol: str
    strength: int
    left: int
    right: int


ARITHMETIC = {
    "add": Operator("+", 4, 4, 5),
    BESIDE: Operator("+", 4, 4, 5),
    "sub": Operator("-", 4, 4, 5),
    "mul": Operator("*", 5, 5, 6),
    "div": Operator("/", 5, 5, 6),
}
"""Operators of every dialect; a right operand of equal strength has brackets, since a * (b * c) rounds differently."""


@dataclass(frozen=True, slots=True)
class Dialect:
    """Notation of a language, with an infix operator or a function for each operation."""

    operators: Mapping[str, Operator]
    calls: Mapping[str, str]  # without ``where``, a selection is a conditional expression
    largest: float = float("inf")  # magnitude of constants
    literal: Callable[[int], str] = str  # text of a constant
    passed: Callable[[str], str] = str  # form of an argument or a selected value
    reciprocal: Callable[[int], Text] | None = None  # reciprocal of an integer, where no function makes it
    together: bool = False  # reciprocals of integers are made in one call

    def expression(self, step: Assignment, inlined: Mapping[str, Text]) -> Text:
        """Return the right-hand side of a step, with inlined operands written out."""
        if step.op == RECIPROCAL:  # of an integer of any size
            like, integer = step.args
            if self.reciprocal:
                return self.reciprocal(int(integer))
            literal = self.literal(int(integer))
            return (f"over_{literal}" if self.together else f"{self.calls[RECIPROCAL]}({like}, {literal})"), ATOM
        args = [self.operand(arg, inlined) for arg in step.args]
        if step.op in self.calls:
            return f"{self.calls[step.op]}({', '.join(self.passed(text) for text, _ in args)})", ATOM
        if step.op == "where":
            condition, first, second = (bracket(text, SELECTION + 1) for text in args)
            return f"{condition} ? {self.passed(first)} : {self.passed(second)}", SELECTION
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

        reciprocals = [step for step in program.steps if self.together and step.op == RECIPROCAL]
        for statement in program.statements:
            if isinstance(statement, Call):
                assignments.append((statement, list(map(passed, statement.groups))))
                continue
            if reciprocals and statement is reciprocals[0]:
                names = ", ".join(self.expression(step, {})[0] for step in reciprocals)
                integers = ", ".join(str(step.args[1]) for step in reciprocals)
                call = f"{self.calls[RECIPROCAL]}s({statement.args[0]}, {integers})"
                assignments.append((replace(statement, name=names), [call]))
            found = self.expression(statement, inlined)
            if statement.inline:
                inlined[statement.name] = found
            else:
                assignments.append((statement, [found[0]]))
        outputs = (f"*{lists.whole[group]}" if isinstance(group, tuple) else text(group) for group in lists.outputs)
        return assignments, list(outputs)


class Lists:
    """Lists of components in a program, from arguments or geometry programs, passed on or returned as a whole.

    ``whole`` gives the names of lists used as a whole, by their components; each is one tuple among the ``outputs``.
    ``read`` are the components that are used one by one. ``returned`` is the last call, if its results are the outputs.
    """

    def __init__(self, program: Program) -> None:
        made: dict[tuple[Operand, ...], str] = {call.names: call.result for call in program.calls if call.result}
        named = {**made}
        named.update((names, argument) for argument, names in program.inputs if names != (argument,))
        self.outputs = list(_with_lists(program.outputs, made))
        used = [*(group for call in program.calls for group in call.groups), *self.outputs]
        self.whole = {group: named[group] for group in used if isinstance(group, tuple) and group in named}
        self.read: set[Operand] = {arg for step in program.steps for arg in step.args}
        for group in used:
            if group not in self.whole:
                self.read.update(group if isinstance(group, tuple) else (group,))
        last = program.statements[-1] if program.statements else None
        self.returned = last if isinstance(last, Call) and last.result and last.names == program.outputs else None

    def unpacked(self, names: Sequence[str], argument: str) -> Iterator[str]:
        """Yield the line that unpacks a list into the names that are read; nothing if none is."""
        if self.read.intersection(names):
            shown = [name if name in self.read else "_" for name in names]
            yield unpacked(shown, argument)


def unpacked(names: Sequence[str], value: str) -> str:
    return f"{', '.join(names)}{',' * (len(names) == 1)} = {value}"


def _with_lists(
    outputs: Sequence[Operand], named: Collection[tuple[Operand, ...]]
) -> Iterator[Operand | tuple[Operand, ...]]:
    """Yield outputs; consecutive ones that form a named list are one tuple."""
    lengths = sorted({len(names) for names in named}, reverse=True)
    place = 0
    while place < len(outputs):
        found = next((n for n in lengths if n > 1 and tuple(outputs[place : place + n]) in named), 0)
        yield tuple(outputs[place : place + found]) if found else outputs[place]
        place += found or 1


def bracket(text: Text, strength: int) -> str:
    """Return the text, in brackets if it binds more weakly than ``strength``."""
    return text[0] if text[1] >= strength else f"({text[0]})"


def wrapped(words: Iterable[str], indent: str) -> list[str]:
    text = " ".join(word.replace(" ", "\0") for word in words)
    lines = textwrap.wrap(
        text, WIDTH, initial_indent=indent, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False
    )
    return [line.replace("\0", " ") for line in lines]


def items(texts: Iterable[str], indent: str) -> str:
    """Return a comma-separated list as indented lines, with a comma at the end."""
    return "\n".join(wrapped((f"{text}," for text in texts), indent))


def fill(text: str, indent: str) -> list[str]:
    """Return lines of a long expression, broken before operators."""
    return wrapped(re.findall(rf"(?:{BINARY} )?\S+", text), indent)


INDENT = "    "

Ask = Callable[[Call, str], str]  # function that returns the text of a call, given the text of its arguments
OPERATORS = {
    **ARITHMETIC,
    "and": Operator("&", 3, 3, 4),
    "or": Operator("|", 2, 2, 3),
    "lt": Operator("<", 1, 4, 4),
    "eq": Operator("==", 1, 4, 4),
}


def python(prefix: str, *further: str, literal: Callable[[int], str] = str, together: bool = False) -> Dialect:
    """Return the dialect of Python with this prefix of functions and this notation of constants."""
    calls = {name: prefix + name for name in (*FUNCTIONS, "where", *further)}
    return Dialect(OPERATORS, calls, literal=literal, together=together)


PLAIN = python("m.", BESIDE, together=True)  # dialect with functions of the number type in ``m``, constants unchanged


def ask_namespace(call: Call, arguments: str) -> str:
    """Return the call of a scalar program from the namespace ``c``, or of another geometry program."""
    if call.result:
        return f"{call.function}({', '.join(filter(None, (call.context, arguments)))})"
    return f"c.{call.function}(m, {arguments}{f', *{call.rest}' if call.rest else ''})"


def body(
    program: Program, dialect: Dialect = PLAIN, alone: bool = False, ask: Ask = ask_namespace, first: Iterable[str] = ()
) -> str:
    """Return source lines of the program: its contract, unpacked arguments, assignments, and the returned tuple.

    Components of a program ``alone`` are parameters. ``ask`` prints calls; ``first`` are lines before the statements.
    """
    end = "\n" if "\n" in program.contract else ""
    contract = [textwrap.indent(f'"""{program.contract}{end}"""', INDENT)] if program.contract else []
    lines = [line for statement in _statements(program, dialect, not alone, ask) for line in _wrap(statement)]
    return "\n".join([*contract, *first, *lines])


def _statements(program: Program, dialect: Dialect, unpack: bool, ask: Ask) -> Iterator[str | list[str]]:
    """Yield assignments, then the list of outputs or the call that returns them."""
    lists = Lists(program)
    for argument, names in program.inputs if unpack else ():
        if names != (argument,):
            yield from lists.unpacked(names, argument)
    statements = dialect.statements(program, lists)
    for statement, texts in statements[0]:
        text = ", ".join(t if isinstance(t, str) else f"({', '.join(t)}{',' * (len(t) == 1)})" for t in texts)
        if not isinstance(statement, Call):
            yield f"{statement.name} = {text}"
        elif statement is lists.returned:
            yield f"return {ask(statement, text)}"
            return
        elif statement.result and statement.names in lists.whole:
            yield f"{statement.result} = {ask(statement, text)}"
            yield from lists.unpacked(statement.names, statement.result)
        else:
            yield unpacked(statement.names, ask(statement, text))
    yield statements[1]


def _wrap(statement: str | list[str]) -> Iterator[str]:
    """Yield the lines of a statement; a long one gets brackets and breaks before operators or after commas."""
    inner = 2 * INDENT
    listed = not isinstance(statement, str)
    line = f"return {', '.join(statement)}{',' * (len(statement) == 1)}" if listed else str(statement)
    head, equals, value = line.partition(" = ")
    if len(INDENT + line) <= WIDTH:
        yield INDENT + line
        return
    if listed:
        head, lines = "return", [part for row in items(statement, inner).split("\n") for part in fill(row, inner)]
    elif not equals:
        head, lines = "return", fill(line.removeprefix("return "), inner)
    else:
        lines = fill(value, inner)
        if len(head) > WIDTH // 2 and "," in head:
            yield from (f"{INDENT}(", *fill(f"{head},", inner))
            head = ")"
        if len(f"{INDENT}{head} = {value}") <= WIDTH:
            yield f"{INDENT}{head} = {value}"
            return
    yield from (f"{INDENT}{head}{equals or ' '}(", *lines, f"{INDENT})")
