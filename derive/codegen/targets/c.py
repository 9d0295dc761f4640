"""Print a program as C: straight-line code on components that lie a stride apart, valid as C99 and as C++."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ..programs.program import Program
from ..signatures import SHADOW, SIGNATURES, Array
from .expression import ARITHMETIC, WIDTH, Dialect, Operator, Text, bracket, fill, renamed, used_names

REAL = "dualcay_real"
_SELECTED = 1
_CONDITIONS = ("lt", "eq", "and", "or")
_EXACT_IN_FLOAT = 2.0**24

# every operand of & and | is bracketed, because compilers warn where they are mixed
_LOGIC = {op: Operator(symbol, 3, 4, 4) for op, symbol in (("and", "&"), ("or", "|"))}
_COMPARISON = {op: Operator(symbol, 2, 4, 4) for op, symbol in (("lt", "<"), ("eq", "=="))}


@dataclass(frozen=True, slots=True)
class Function:
    """What a C template shows of a program.

    Parameters
    ----------
    inputs, outputs : tuple of str
        Names of the arrays; component i of ``v`` is ``v_at[i * v_by]``.
    text : str
        Loads, assignments and stores. All loads come first, so that results may overlap arguments.
    math : frozenset of str
        Functions of ``math.h`` it calls.
    """

    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    text: str
    math: frozenset[str]


def _ternary(condition: Text, first: Text, second: Text) -> Text:
    test, a, b = (bracket(text, _SELECTED + 1) for text in (condition, first, second))
    if all(text[0].lstrip("-").isdigit() for text in (first, second)):
        # two integers would make an int, and a division by one an integer division
        b = f"({REAL}){b}"
    return f"{test} ? {a} : {b}", _SELECTED


C99 = Dialect(
    operators=ARITHMETIC | _LOGIC | _COMPARISON,
    calls={name: f"dualcay_{name}" for name in ("sqrt", "tan", "atan2")},
    select=_ternary,
    largest=_EXACT_IN_FLOAT,
)
"""C, where integer constants become the real type exactly by the usual arithmetic conversions."""


def function(program: Program) -> Function:
    """The program as the body of a C function.

    Raises
    ------
    ValueError
        If a constant is not an integer that a float holds exactly.
    """
    program = _lower_case(program)
    inputs = tuple(argument.lower() for argument, _ in program.inputs)
    results = _results(program.name)
    lines = (*_loads(program), *_assignments(program), *_stores(program, results))
    math = frozenset(step.op for step in program.steps) & C99.calls.keys()
    return Function(inputs, tuple(array.name for array in results), "\n".join(lines), math)


def _results(name: str) -> tuple[Array, ...]:
    return SIGNATURES[name].results if name in SIGNATURES else (SHADOW,)


def _lower_case(program: Program) -> Program:
    """Capital letters are where other people's macros are (N, I, R1); a trailing underscore keeps names apart."""
    names = {name for _, parts in program.inputs for name in parts} | {step.name for step in program.steps}
    new = {name: name.lower() for name in names if name != name.lower()}
    return renamed(program, {name: f"{lower}_" if lower in names else lower for name, lower in new.items()})


def _loads(program: Program) -> Iterator[str]:
    used = used_names(program)
    for argument, names in program.inputs:
        for index, name in enumerate(names):
            if name in used:
                yield f"    const {REAL} {name} = {_component(argument.lower(), index)};"


def _component(array: str, index: int) -> str:
    offset = {0: "0", 1: f"{array}_by"}.get(index, f"{index} * {array}_by")
    return f"{array}_at[{offset}]"


def _assignments(program: Program) -> Iterator[str]:
    for step, text in C99.statements(program)[0]:
        kind = "int" if step.op in _CONDITIONS else REAL
        yield from _wrap(f"const {kind} {step.name}", text)


def _stores(program: Program, results: Sequence[Array]) -> Iterator[str]:
    places = (_component(array.name, index) for array in results for index in range(array.size))
    for place, text in zip(places, C99.statements(program)[1], strict=True):
        yield from _wrap(place, text)


def _wrap(target: str, text: str) -> Iterator[str]:
    line = f"    {target} = {text};"
    if len(line) <= WIDTH:
        yield line
    else:
        yield f"    {target} ="
        yield from fill(f"{text};", " " * 8)
