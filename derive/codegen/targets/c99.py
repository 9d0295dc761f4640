"""Printer of programs as C functions: straight-line code, valid as C99 and as C++.

Component i of ``v`` is ``v_at[i * v_by]``: a kernel function works on components that lie a stride apart. Its program
calls functions of the chart (``DUALCAY_CHART``), which take numbers and write results through pointers.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from ..lowering.scalar_programs import SCALARS
from ..programs.program import FUNCTIONS, Assignment, Call, Program
from ..programs.renaming import lower_case
from ..rows import Array
from ..signatures import TABLE
from .expression import ARITHMETIC, WIDTH, Dialect, Lists, Operator, Texts, fill, items

REAL = "dualcay_real"
_INDENT = "    "
_CONDITIONS = ("lt", "eq", "and", "or")
_SLOW = ("tan", "atan2", "expm1", "log1p")  # functions that are called only where a result depends on them
_EXACT_IN_FLOAT = 2.0**24

OPERATORS = {
    **ARITHMETIC,
    "and": Operator("&", 3, 4, 4),  # compilers warn where & and | are mixed without brackets
    "or": Operator("|", 3, 4, 4),
    "lt": Operator("<", 2, 4, 4),
    "eq": Operator("==", 2, 4, 4),
}


@dataclass(frozen=True, slots=True)
class CFunction:
    """C function for its template; all loads come first in its text, so that results may overlap arguments."""

    name: str
    parameters: str
    text: str


def real(text: str) -> str:
    """Return a text; an integer, which nothing else would make real, is cast to the real type."""
    return f"({REAL}){text}" if text.lstrip("-").isdigit() else text


C99 = Dialect(OPERATORS, {name: f"dualcay_{name}" for name in FUNCTIONS}, _EXACT_IN_FLOAT, passed=real)
"""C dialect: an integer constant beside a real operand converts exactly to the real type."""


def core(program: Program, made: Sequence[Array], table: Mapping[str, str]) -> CFunction:
    """Return the core of a geometry program, which stores its results in the arrays ``made``.

    Its parameters are the arguments, the numbers of the chart's table without decimals in ``table``, and the arrays.
    """
    program = lower_case(program)
    lists, given, read, loads = Lists(program), list[str](), list[str](), list[str]()
    numbers = [name for argument, names in program.inputs if argument == TABLE for name in names if name not in table]
    for argument, names in program.inputs:
        if names == (argument,):
            given.append(f"{REAL} {argument}")
            read.append(argument)
        elif argument != TABLE:
            given.append(f"const {REAL} *{argument}_at, size_t {argument}_by")
            read += [f"{argument}_at", f"{argument}_by"]
            places = ((name, _component(argument, index)) for index, name in enumerate(names))
            loads += _declared((name, place) for name, place in places if name in lists.read)
    given += [*(f"{REAL} {name}" for name in numbers), *(f"{REAL} *{a.name}_at, size_t {a.name}_by" for a in made)]
    read += [*(f"{array.name}_by" for array in made), *numbers]
    stored = [_component(array.name, index) for array in made for index in range(array.size)]
    lines = [*loads, *_constants(program, table), *_statements(program, stored, (), made)]
    return _printed(program, given, read, lines)


def scalar(program: Program, table: Mapping[str, str]) -> CFunction:
    """Return a scalar program as a function; its parameters are numbers, then pointers to results."""
    program, row = lower_case(program), SCALARS[program.name]
    numbers = [name for _, names in program.inputs for name in names if name not in table]
    pointers = [f"{'int' if name in row.truths else REAL} *{name}_at" for name in row.results]
    places, truths = ([f"*{name}_at" for name in names] for names in (row.results, row.truths))
    lines = [*_constants(program, table), *_statements(program, places, truths, ())]
    return _printed(program, [*(f"{REAL} {name}" for name in numbers), *pointers], numbers, lines)


def _printed(program: Program, given: Sequence[str], read: Sequence[str], lines: Sequence[str]) -> CFunction:
    """Return a function; cast unread parameters to void, because compilers would warn."""
    text = "\n".join(lines)
    unused = [f"{_INDENT}(void){name};" for name in read if not re.search(rf"\b{name}\b", text)]
    return CFunction(program.name, filled(given), "\n".join([*unused, text]))


def _declared(values: Iterable[tuple[str, str]]) -> Iterator[str]:
    texts = [f"{name} = {value}" for name, value in values]
    if texts:
        yield f"{_INDENT}{filled([f'const {REAL} {texts[0]}', *texts[1:]], 2 * _INDENT)};"


def _constants(program: Program, table: Mapping[str, str]) -> Iterator[str]:
    for name in (name for _, names in program.inputs for name in names):
        if name in table and name in program.operands:
            yield f"{_INDENT}const {REAL} {name} = DUALCAY_NUMBER({table[name]});"


def _component(array: str, index: int) -> str:
    offset = {0: "0", 1: f"{array}_by"}.get(index, f"{index} * {array}_by")
    return f"{array}_at[{offset}]"


def _statements(
    program: Program, places: Sequence[str], truths: Collection[str], made: Sequence[Array]
) -> Iterator[str]:
    """Yield the statements of a program; the last ones store results, unless a called program does."""
    lists = Lists(program)
    given = (argument for argument, names in program.inputs if names != (argument,))
    arrays = {argument: f"{argument}_at, {argument}_by" for argument in given}
    arrays |= {call.result: f"{call.result}, 1" for call in program.calls if call.result}
    statements, outputs = C99.statements(program, lists)
    conditions, known = program.conditions, set[str]()
    for statement, texts in statements:
        if isinstance(statement, Assignment):
            kind, text = "int" if statement.op in _CONDITIONS else REAL, str(texts[0])
            needed = sorted((c, side) for c, side in conditions[statement.name] if c in known)
            if statement.op in _SLOW and needed:
                (condition, side), none = needed[0], real("0")
                text = f"{condition} ? {text} : {none}" if side else f"{condition} ? {none} : {text}"
            known.add(statement.name)
            yield from _wrap(f"const {kind} {statement.name}", text)
        elif not statement.result:
            yield from _call_scalar(statement, ", ".join(map(str, texts)))
        elif statement is lists.returned:
            yield from _call_program(statement, texts, arrays, [f"{array.name}_at, {array.name}_by" for array in made])
        else:
            yield f"{_INDENT}{REAL} {statement.result}[{len(statement.names)}];"
            yield from _call_program(statement, texts, arrays, [f"{statement.result}, 1"])
            names = enumerate(statement.names)
            yield from _declared((name, f"{statement.result}[{index}]") for index, name in names if name in lists.read)
    stores = []
    for group, text in zip(lists.outputs, outputs, strict=True):
        stores += [f"{text[1:]}[{i}]" for i in range(len(group))] if isinstance(group, tuple) else [text]
    for place, text in zip(places, stores, strict=True) if lists.returned is None else ():
        yield from _wrap(place, text if place in truths else real(text))


def _call_program(call: Call, texts: Texts, arrays: Mapping[str, str], made: Sequence[str]) -> Iterator[str]:
    passed = []
    for index, text in enumerate(texts, 1):
        if isinstance(text, list):
            yield from _wrap(f"const {REAL} {call.result}_{index}[{len(text)}]", f"{{{', '.join(text)}}}")
            passed.append(f"{call.result}_{index}, 1")
        else:
            passed.append(arrays.get(text, text))
    yield f"{_INDENT}DUALCAY_NAME({call.function}_core)({filled([*passed, *made])});"


def _call_scalar(call: Call, arguments: str) -> Iterator[str]:
    """Yield declarations of all results, read or not, and the call."""
    first = next(name for name in call.names if name != "_")
    names = [f"{first}_{i}" if name == "_" else name for i, name in enumerate(call.names)]
    truths = [name for name in names if name in call.truths]
    for kind, places in (("int", truths), (REAL, [name for name in names if name not in truths])):
        if places:
            yield f"{_INDENT}{kind} {', '.join(places)};"
    passed = ", ".join([arguments, *(f"&{name}" for name in names)])
    yield f"{_INDENT}DUALCAY_CHART({call.function})({passed});"


def _wrap(target: str, text: str) -> Iterator[str]:
    line = f"{_INDENT}{target} = {text};"
    if len(line) <= WIDTH:
        yield line
    else:
        yield f"{_INDENT}{target} ="
        yield from fill(f"{text};", 2 * _INDENT)


def filled(texts: Iterable[str], indent: str = _INDENT) -> str:
    """Return a comma-separated list, wrapped into lines that are indented except the first."""
    return items(texts, indent).lstrip()[:-1]
