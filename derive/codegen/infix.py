"""Print a program as plain infix Python: the form which runs on any number type."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction

from .program import Operand, Program, Step

WIDTH = 120
_SYMBOLS = {"add": ("+", 4), "sub": ("-", 4), "mul": ("*", 5), "div": ("/", 5), "and": ("&", 3), "or": ("|", 2)}
_COMPARISONS = {"lt": "<", "eq": "=="}
_CALLS = frozenset({"sqrt", "tan", "atan2", "where"})
_COMPARISON, _NEGATION, _ATOM = 1, 6, 9

Text = tuple[str, int]
"""Source text and the binding strength of its outermost operator."""


@dataclass(frozen=True, slots=True)
class Dialect:
    """How functions are called and constants written."""

    prefix: str = "m."
    literal: Callable[[int], str] = str


PLAIN = Dialect()


def body(program: Program, indent: str = "    ", dialect: Dialect = PLAIN) -> str:
    """Source lines of the program: unpacked arguments, assignments, and the returned tuple."""
    return "\n".join(line for statement in _statements(program, dialect) for line in _wrap(statement, indent))


def _statements(program: Program, dialect: Dialect) -> Iterator[str | list[str]]:
    """Assignments, then the list of outputs."""
    for argument, names in program.inputs:
        used = _used_names(program)
        yield f"{', '.join(name if name in used else '_' for name in names)}{',' * (len(names) == 1)} = {argument}"
    texts: dict[str, Text] = {}
    for step in program.steps:
        text = _expression(step, texts, dialect)
        if step.inline:
            texts[step.name] = text
        else:
            yield f"{step.name} = {text[0]}"
    yield [_operand(output, texts, dialect)[0] for output in program.outputs]


def _used_names(program: Program) -> set[Operand]:
    return {arg for step in program.steps for arg in step.args} | set(program.outputs)


def _expression(step: Step, texts: dict[str, Text], dialect: Dialect) -> Text:
    args = [_operand(arg, texts, dialect) for arg in step.args]
    if step.op in _CALLS:
        return f"{dialect.prefix}{step.op}({', '.join(text for text, _ in args)})", _ATOM
    if step.op == "neg":
        return f"-{_bracket(args[0], _NEGATION)}", _NEGATION
    if step.op in _COMPARISONS:
        left, right = (_bracket(arg, 4) for arg in args)
        return f"{left} {_COMPARISONS[step.op]} {right}", _COMPARISON
    symbol, strength = _SYMBOLS[step.op]
    # the right operand keeps its brackets at equal strength: a * (b * c) rounds differently from a * b * c
    return f"{_bracket(args[0], strength)} {symbol} {_bracket(args[1], strength + 1)}", strength


def _bracket(text: Text, strength: int) -> str:
    return text[0] if text[1] >= strength else f"({text[0]})"


def _operand(operand: Operand, texts: dict[str, Text], dialect: Dialect) -> Text:
    if isinstance(operand, str):
        return texts.get(operand, (operand, _ATOM))
    if isinstance(operand, Fraction) and operand.denominator != 1:
        raise ValueError(f"constant {operand} is not an integer: divide instead, so that exact types stay exact")
    text = dialect.literal(int(operand))
    return text, _NEGATION if text.startswith("-") else _ATOM


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
    line = f"{indent}return ({', '.join(outputs)})"
    if len(line) <= WIDTH:
        yield line
        return
    yield f"{indent}return ("
    for output in outputs:
        yield from fill(f"{output},", indent + "    ")
    yield f"{indent})"


def fill(text: str, indent: str) -> Iterator[str]:
    """Lines of a text broken at spaces, before operators rather than after them."""
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
    """Keep an operator with its right operand: lines break before operators."""
    operator = ""
    for word in words:
        if not operator and word in {"+", "-", "*", "/", "&", "|", "<", "=="}:
            operator = word
            continue
        yield (operator, word) if operator else (word, "")
        operator = ""
