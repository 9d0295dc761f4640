"""Printed formulas as trees that are typeset, evaluated and mutated.

A `Term` is a SymPy node in printed order: construction does not sort, combine or evaluate it. Python's operators
build terms, so an entry reads like the formula. Module :mod:`derive.claims.language.operator_table` lists operators;
:mod:`derive.claims.numbers.kinds` lists quantities of symbols.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from enum import Flag, auto
from functools import cached_property, lru_cache
from itertools import chain
from typing import Any, Self
from weakref import WeakValueDictionary

from sympy import Basic, Integer
from sympy.core.symbol import Str

from ..numbers.kinds import QUANTITIES, Quantity

ATOM, POWER, PRODUCT, SUM, RELATION, LIST = 5, 4, 3, 2, 1, 0  # binding strength of a term


class Trait(Flag):
    """Properties of an operator in addition to its value."""

    NONE = 0
    DELICATE = auto()  # an identity at generic values may fail at special values
    APART = auto()  # takes the real or the dual part
    RATE = auto()  # derivative in time
    TRANSCENDENTAL = auto()  # not composed of powers, roots and quotients
    LENGTH = auto()  # magnitude: the root of a square; its square needs no root
    JOINS = auto()  # joins statements, each of which is asserted
    OVER_COSINE = auto()  # divides by the cosine of its argument
    OVER_SINE = auto()  # divides by the sine of its argument


@dataclass(frozen=True)
class OperatorRow:
    """Row of the notation table; a call with arguments makes a term."""

    name: str
    latex: str  # template with ``{0}``, ``{1}`` …; for a list of any length, only the separator
    text: str  # template of plain characters
    level: int  # binding strength of the result
    slots: tuple[int, ...]  # least level of each argument without brackets; the last slot serves all further arguments
    value: Callable[..., Any]  # function ``value(env, *arguments)`` of values, or of terms if `lazy`
    lazy: bool = False
    traits: Trait = Trait.NONE

    def __call__(self, *arguments: Any) -> Apply:
        return Apply(self.name, *arguments)


OPERATORS: dict[str, OperatorRow] = {}
LEAF = OperatorRow("", "", "", ATOM, (), lambda env: None)
"""OperatorRow of a term without parts, so that every term has an operator."""

Build = Callable[["Term", Any], "Term"]


def _infix(name: str) -> tuple[Build, Build]:
    """Return two methods of an infix operator: one for the term on the left, one for the term on the right."""
    return (lambda self, other: Apply(name, self, other)), (lambda self, other: Apply(name, other, self))


named = lru_cache(None)(Str)
KEPT: WeakValueDictionary[tuple[Any, ...], Any] = WeakValueDictionary()
"""Terms in use, by class and parts."""


class Term(Basic):  # type: ignore[misc]  # SymPy is untyped
    """Formula or part of a formula. Python's operators build larger terms and accept integers.

    Equal terms are one object, so that a comparison or a look-up takes no time.
    """

    def __new__(cls, *parts: Basic) -> Self:
        found: Self | None = KEPT.get((cls, *parts))
        if found is None:
            found = KEPT[cls, *parts] = super().__new__(cls, *parts)
        return found

    @property
    def operator(self) -> OperatorRow:
        return LEAF

    @property
    def arguments(self) -> tuple[Term, ...]:
        return ()

    def _latex(self, printer: object) -> str:
        return latex(self)

    def __neg__(self) -> Term:
        return Apply("negative", self)

    __add__, __radd__ = _infix("plus")
    __sub__, __rsub__ = _infix("minus")
    __mul__, __rmul__ = _infix("times")
    __truediv__, __rtruediv__ = _infix("over")
    __pow__, _ = _infix("power")


class Number(Term):
    """Printed integer."""

    def __new__(cls, value: int) -> Self:
        node: Self = super().__new__(cls, Integer(value))
        return node

    @property
    def value(self) -> int:
        return int(self.args[0])


class Symbol(Term):
    """Printed symbol with its LaTeX and its characters in the extracted text.

    Its name is unique within a statement; its quantity is a row of the table in `derive.claims.numbers.kinds`.
    """

    def __new__(cls, name: str, quantity: str, latex: str | None = None, text: str | None = None) -> Self:
        # SymPy rebuilds a node from its own arguments
        name, quantity, latex, text = (str(part) for part in (name, quantity, latex or name, text or name))
        if quantity not in QUANTITIES:
            raise ValueError(f"no quantity {quantity!r}: expected {', '.join(QUANTITIES)}")
        node: Self = super().__new__(cls, *map(named, (name, quantity, latex, text)))
        return node

    @property
    def name(self) -> str:
        return str(self.args[0])

    @property
    def quantity(self) -> Quantity:
        return QUANTITIES[self.args[1].name]


class Apply(Term):
    """OperatorRow applied to arguments."""

    def __new__(cls, operator: str | Str, *arguments: Any) -> Self:
        name = str(operator)  # SymPy rebuilds a node from its own arguments
        if name not in OPERATORS:
            raise ValueError(f"no operator {name!r}")
        node: Self = super().__new__(cls, named(name), *map(term, arguments))
        return node

    @property
    def operator(self) -> OperatorRow:
        return OPERATORS[self.args[0].name]

    @cached_property
    def arguments(self) -> tuple[Term, ...]:  # kept: evaluation asks for it at every point
        return tuple(a for a in self.args[1:] if isinstance(a, Term))


def macro(latex: str, first: int = 0) -> str:
    """Return the template of a LaTeX text with arguments ``#1``, ``#2`` …, of which the first has this place."""
    escaped = latex.replace("{", "{{").replace("}", "}}")
    return re.sub(r"#(\d)", lambda found: f"{{{int(found[1]) - 1 + first}}}", escaped)


SHOWN = " as "
"""Mark between the name of an operator and its LaTeX, if it is printed otherwise than usual."""


def shown_as(statement: Term, printed: Mapping[str, str]) -> Term:
    """Return a statement with the LaTeX of some operators by name; each becomes an operator of its own."""
    if not isinstance(statement, Apply):
        return statement
    row, arguments = statement.operator, [shown_as(argument, printed) for argument in statement.arguments]
    if row.name not in printed:
        return Apply(row.name, *arguments)
    name = f"{row.name}{SHOWN}{printed[row.name]}"
    OPERATORS.setdefault(name, replace(row, name=name, latex=macro(printed[row.name])))
    return Apply(name, *arguments)


def as_usual(statement: Term) -> Term:
    """Return a statement with the operators that `shown_as` replaced."""
    if not isinstance(statement, Apply):
        return statement
    name, marked, _ = statement.operator.name.partition(SHOWN)
    plain = name if marked and name in OPERATORS else statement.operator.name
    return Apply(plain, *map(as_usual, statement.arguments))


def term(value: Any) -> Term:
    """Return a term unchanged, or an integer as a term."""
    if isinstance(value, Term):
        return value
    if isinstance(value, int):
        return Number(value)
    raise TypeError(f"a formula is made of terms and integers, not {type(value).__name__}")


def symbols(statement: Term) -> tuple[Symbol, ...]:
    """Return the distinct symbols of a statement in printed order."""
    return tuple(node for node in distinct(statement) if isinstance(node, Symbol))


@lru_cache(2**16)
def letters(statement: Term) -> frozenset[Symbol]:
    """Return the symbols of a statement as a set, which is kept."""
    return frozenset(symbols(statement))


def walk(statement: Term) -> Iterator[Term]:
    """Yield the statement and all its parts in printed order."""
    yield statement
    for argument in statement.arguments:
        yield from walk(argument)


@lru_cache(2**16)
def distinct(statement: Term) -> tuple[Term, ...]:
    """Return the distinct parts of a statement, itself first, in printed order; they are kept."""
    return tuple(dict.fromkeys(chain((statement,), *map(distinct, statement.arguments))))


def with_trait(trait: Trait, *statements: Term) -> tuple[Term, ...]:
    """Return the distinct parts of each statement whose operator has a trait."""
    return tuple(node for statement in statements for node in distinct(statement) if trait in node.operator.traits)


def rate_depth(node: Term) -> int:
    """Return how deep time derivatives are nested in a term."""
    return max(map(rate_depth, node.arguments), default=0) + (Trait.RATE in node.operator.traits)


def takes_apart(*statements: Term) -> bool:
    """Return whether statements separate real and dual parts by ε, Re, Du, a real symbol or a claim in words."""
    apart = any(symbol.quantity.apart for statement in statements for symbol in symbols(statement))
    return apart or bool(with_trait(Trait.APART, *statements))


def latex(statement: Term) -> str:
    """Return the statement as LaTeX, without delimiters."""
    return _typeset(statement, "latex", r"\left({}\right)")


def text(statement: Term) -> str:
    """Return the statement as plain characters in printed order, with brackets and operators."""
    return _typeset(statement, "text", "({})")


def _typeset(node: Term, style: str, brackets: str) -> str:
    if isinstance(node, Number):
        return str(node.value)
    if isinstance(node, Symbol):
        return str(node.args[2 if style == "latex" else 3])
    row = node.operator
    parts = []
    for i, argument in enumerate(node.arguments):
        part = _typeset(argument, style, brackets)
        needed = row.slots[min(i, len(row.slots) - 1)]
        parts.append(brackets.format(part) if argument.operator.level < needed else part)
    template: str = getattr(row, style)
    if style == "latex" and template.startswith("{0}^") and "^" in parts[0]:
        parts[0] = f"{{{parts[0]}}}"  # avoid a double superscript
    return template.format(*parts) if re.search(r"\{\d\}", template) else template.join(parts)
