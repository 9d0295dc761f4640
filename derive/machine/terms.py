"""Straight-line programs as terms of Coq, read back from emitted text by `python_text` and `c_text`.

Assignments become nested ``let``. Calls of other geometry programs are inlined; calls of scalar programs named as
opaque stay calls of a function that Coq knows nothing about. Text outside this subset raises `ReadError`.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

Scalars = Mapping[str, Sequence[str]]
"""Names of the results of opaque scalar programs, by program."""

SYMBOLS: Mapping[type[ast.operator], str] = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}
_WORDS = "as at cofix else end exists fix for forall fun if in let match mod return then using where with Prop Set Type"
RESERVED = frozenset([*_WORDS.split(), "sqrt"])
"""Words of Coq that are no names, and the one function that terms may call."""


class ReadError(ValueError):
    """Error in emitted text that is missing or is not a straight-line program; the message names file and line."""


def number(value: Fraction | int) -> str:
    """Return a rational number as a term of ones.

    Examples
    --------
    >>> number(6), number(Fraction(-1, 2))
    ('(2 * (1 + 2 * 1))', '(- ((1 / 2)))')
    """
    value = Fraction(value)
    if value < 0:
        return f"(- ({number(-value)}))"
    if value.denominator != 1:
        return f"({number(value.numerator)} / {number(value.denominator)})"
    half, odd = divmod(int(value), 2)
    if half == 0 or (half, odd) == (1, 0):
        return str(value)
    return f"(1 + 2 * {number(half)})" if odd else f"(2 * {number(half)})"


@dataclass(slots=True)
class Program:
    """Straight-line program: its parameters, its steps of names and a term, its results, and its file and line."""

    parameters: tuple[str, ...]
    place: str = ""
    steps: list[tuple[Sequence[str], str]] = field(default_factory=list)
    results: tuple[str, ...] = ()
    used: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        self.used |= {*self.parameters, *RESERVED}

    def bind(self, names: Sequence[str], term: str) -> tuple[str, ...]:
        """Add the step that gives names to a term, or to its parts; return the names, changed where they are taken."""
        if len(names) == 1 and term.isidentifier():
            return (term,)
        made = tuple(map(self._free, names))
        self.steps.append((made, term))
        return made

    def _free(self, name: str) -> str:
        free = next(each for each in _numbered(name) if each not in self.used)
        self.used.add(free)
        return free

    def call(self, scalars: Scalars, name: str, arguments: Sequence[str]) -> tuple[str, ...]:
        """Add the call of an opaque scalar program and return the names of its results."""
        return self.bind(scalars[name], f"{name} {' '.join(arguments)}")

    def definition(self, name: str) -> str:
        """Return the program as a definition of Coq, a function to tuples of numbers of K."""
        lines = [f"Definition {name} ({' '.join(self.parameters)} : K) : {product(len(self.results))} :="]
        for names, term in self.steps:
            lines.append(f"  let {names[0] if len(names) == 1 else _tuple(names, mark=chr(39))} := {term} in")
        return "\n".join([*lines, f"  {_tuple(self.results)}."])


def product(count: int) -> str:
    """Return the type of tuples of numbers."""
    return f"({' * '.join(['K'] * count)})%type"


def _tuple(terms: Sequence[str], mark: str = "") -> str:
    return f"{mark}({', '.join(terms)})"


def _numbered(name: str) -> Iterator[str]:
    yield name
    count = 2
    while True:
        yield f"{name}_{count}"
        count += 1
