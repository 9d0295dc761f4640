"""Printer of programs as plain infix Python, which runs on any number type."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from ..programs.program import FUNCTIONS, Call, Program
from .expression import ARITHMETIC, ATOM, WIDTH, Dialect, Lists, Operator, Text, fill, left_associative


def python(prefix: str, literal: Callable[[int], str] = str) -> Dialect:
    """Return the dialect of Python with this prefix of functions and this notation of constants."""

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
"""Dialect with functions of the number type in ``m`` and unchanged constants."""


def ask_namespace(call: Call, arguments: str) -> str:
    """Return the call of a scalar program from the namespace ``c``, or of another geometry program."""
    if call.result:
        return f"{call.function}({', '.join(filter(None, (call.context, arguments)))})"
    return f"c.{call.function}(m, {arguments}{f', *{call.rest}' if call.rest else ''})"


def body(
    program: Program,
    indent: str = "    ",
    dialect: Dialect = PLAIN,
    alone: bool = False,
    ask: Callable[[Call, str], str] = ask_namespace,
    first: Iterable[str] = (),
) -> str:
    """Return source lines of the program: its contract, unpacked arguments, assignments, and the returned tuple.

    Components of a program that stands `alone` are its parameters: nothing is unpacked. `ask` makes the text of a call
    from the text of its arguments. ``first`` are lines of text before the statements.
    """
    lines = [line for statement in _statements(program, dialect, not alone, ask) for line in _wrap(statement, indent)]
    return "\n".join([*_docstring(program.contract, indent), *first, *lines])


def _docstring(contract: str, indent: str) -> list[str]:
    if not contract:
        return []
    first, *further = contract.split("\n")
    if not further:
        return [f'{indent}"""{first}"""']
    return [f'{indent}"""{first}', *(f"{indent}{line}" for line in further), f'{indent}"""']


def unpacked(names: Sequence[str], argument: str) -> str:
    """Return an assignment that unpacks an argument into names."""
    return f"{', '.join(names)}{',' * (len(names) == 1)} = {argument}"


def _statements(
    program: Program, dialect: Dialect, unpack: bool, ask: Callable[[Call, str], str]
) -> Iterator[str | list[str]]:
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
        elif not statement.result:
            yield unpacked(statement.names, ask(statement, text))
        elif statement is lists.returned:
            yield f"return {ask(statement, text)}"
            return
        elif statement.names in lists.whole:
            yield f"{statement.result} = {ask(statement, text)}"
            yield from lists.unpacked(statement.names, statement.result)
        else:
            yield unpacked(statement.names, ask(statement, text))
    yield statements[1]


def _wrap(statement: str | list[str], indent: str) -> Iterator[str]:
    """Yield the lines of a statement; a long one gets brackets and breaks before operators or after commas."""
    if isinstance(statement, list):
        yield from _wrap_result(statement, indent)
    elif len(indent + statement) <= WIDTH:
        yield indent + statement
    else:
        names, _, value = statement.partition("return " if statement.startswith("return ") else " = ")
        if not names:
            yield f"{indent}return ("
            yield from fill(value, indent + "    ")
            yield f"{indent})"
            return
        if len(names) > WIDTH // 2 and "," in names:
            yield f"{indent}("
            yield from fill(f"{names},", indent + "    ")
            names = f"{indent})"
        else:
            names = indent + names
        if len(f"{names} = {value}") <= WIDTH:
            yield f"{names} = {value}"
            return
        yield f"{names} = ("
        yield from fill(value, indent + "    ")
        yield f"{indent})"


def _wrap_result(outputs: list[str], indent: str) -> Iterator[str]:
    line = f"{indent}return {', '.join(outputs)}{',' * (len(outputs) == 1)}"
    if len(line) <= WIDTH:
        yield line
        return
    yield f"{indent}return ("
    line = ""
    for output in (f"{output}," for output in outputs):
        if line and len(f"{indent}    {line} {output}") > WIDTH:
            yield from fill(line, indent + "    ")
            line = ""
        line = f"{line} {output}" if line else output
    yield from fill(line, indent + "    ")
    yield f"{indent})"
