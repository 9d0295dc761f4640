"""Print a program as plain infix Python: the form which runs on any number type."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from ..programs.program import FUNCTIONS, Call, Program
from .expression import ARITHMETIC, ATOM, WIDTH, Dialect, Operator, Text, fill, left_associative

Ask = Callable[[Call, str], str]


def python(prefix: str, literal: Callable[[int], str] = str) -> Dialect:
    """Return the dialect of Python with functions of a prefix and constants written in a way."""

    def where(condition: Text, first: Text, second: Text) -> Text:
        return f"{prefix}where({condition[0]}, {first[0]}, {second[0]})", ATOM

    return Dialect(
        operators=ARITHMETIC
        | {
            "and": left_associative("&", 3),
            "or": left_associative("|", 2),
            "lt": Operator("<", 1, 4, 4),
            "eq": Operator("==", 1, 4, 4),
        },
        calls={name: prefix + name for name in FUNCTIONS},
        select=where,
        literal=literal,
    )


PLAIN = python("m.")
"""Functions of the number type in ``m``, constants as they are."""


def of_namespace(call: Call, arguments: str) -> str:
    """A call of a scalar program that the namespace ``c`` holds."""
    return f"c.{call.function}(m, {arguments}{f', *{call.rest}' if call.rest else ''})"


def body(
    program: Program, indent: str = "    ", dialect: Dialect = PLAIN, alone: bool = False, ask: Ask = of_namespace
) -> str:
    """Source lines of the program: unpacked arguments, assignments, and the returned tuple.

    A program that stands `alone` has its components for parameters: nothing is unpacked. `ask` is the text of a call,
    from that of its arguments.
    """
    lines = _statements(program, dialect, not alone, ask)
    return "\n".join(line for statement in lines for line in _wrap(statement, indent))


def unpacked(names: Sequence[str], argument: str) -> str:
    """An assignment to each of some names."""
    return f"{', '.join(names)}{',' * (len(names) == 1)} = {argument}"


def _statements(program: Program, dialect: Dialect, unpack: bool, ask: Ask) -> Iterator[str | list[str]]:
    """Assignments, then the list of outputs."""
    used = program.operands
    for argument, names in program.inputs if unpack else ():
        if names:
            yield unpacked([name if name in used else "_" for name in names], argument)
    assignments, outputs = dialect.statements(program)
    for statement, text in assignments:
        if isinstance(statement, Call):
            yield unpacked(statement.names, ask(statement, text))
        else:
            yield f"{statement.name} = {text}"
    yield outputs


def _wrap(statement: str | list[str], indent: str) -> Iterator[str]:
    """Lines of a statement; a long one goes into brackets and breaks before operators, a long result by outputs."""
    if isinstance(statement, list):
        yield from _wrap_result(statement, indent)
    elif len(indent + statement) <= WIDTH:
        yield indent + statement
    else:
        name, value = statement.split(" = ", 1)
        yield f"{indent}{name} = ("
        yield from fill(value, indent + "    ")
        yield f"{indent})"


def _wrap_result(outputs: list[str], indent: str) -> Iterator[str]:
    line = f"{indent}return {', '.join(outputs)}{',' * (len(outputs) == 1)}"
    if len(line) <= WIDTH:
        yield line
        return
    yield f"{indent}return ("
    for output in outputs:
        yield from fill(f"{output},", indent + "    ")
    yield f"{indent})"
