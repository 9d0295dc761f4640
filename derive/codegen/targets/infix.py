"""Printer of programs as plain infix Python, which runs on any number type."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Iterable, Iterator

from ..programs.program import BESIDE, FUNCTIONS, Call, Program
from .expression import ARITHMETIC, WIDTH, Dialect, Lists, Operator, fill, items, unpacked

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
