"""Truth of a statement at seeded points: generic, real, with one or two special symbols, and at poles.

A point where the statement is false gives a counterexample.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, pairwise
from typing import Any

import mpmath

from ..algebra import Dual, Structure
from ..maps.pose import Pose
from .equation import Entry
from .language import operator_table
from .language.environment import Env
from .language.printed import Symbol, Term, Trait, latex, symbols, text, walk
from .language.values import Either, coefficients, equal
from .numbers.draw import Draw
from .numbers.fields import FIELD_DIGITS, Decimal60, innermost
from .numbers.quantities import BRANCH, ORDER
from .result import Counterexample

GENERIC_POINTS = 2
SHOWN_DIGITS = 30
"""Digits shown for a value of a counterexample."""
SCALES = tuple(mpmath.mpf(k) / 8 for k in range(1, 41))
"""Scale factors for a symbol; sign changes of a denominator are searched between neighbouring factors."""
SCALED = ("dual vector", "dual number", "argument")
"""Quantities of the symbols that are scaled to reach a pole."""

Values = dict[Symbol, Any]
SeededPoint = tuple[str, Values, bool]
"""Label of a point, values of all free symbols there, and whether two symbols have special values."""


@dataclass(frozen=True)
class Trial:
    """Truth of a statement at one point; None where it is undefined.

    `inside` tells whether the point satisfies the entry's condition, `pair` whether two symbols have special values.
    """

    point: str
    inside: bool
    truth: bool | None
    env: Env
    pair: bool

    @property
    def place(self) -> str:
        """Point and truth in words."""
        return f"{self.point}: {'no value' if self.truth is None else str(self.truth).lower()}"


def explore(entry: Entry, statement: Term, orders: Sequence[int], digits: int = 30) -> Iterator[Trial]:
    """Yield the truth of a statement at each point inside the entry's claimed domain."""
    with mpmath.workdps(FIELD_DIGITS):
        for label, values, pair in points(entry, statement, orders, digits):
            env = Env(Decimal60(), values, entry.definitions, moving=entry.moving)
            if entry.claimed is None or _truth(env, entry.claimed):
                inside = entry.condition is None or bool(_truth(env, entry.condition))
                yield Trial(label, inside, _truth(env, statement), env, pair)


def points(entry: Entry, statement: Term, orders: Sequence[int], digits: int = 30) -> Iterator[SeededPoint]:
    """Yield seeded points for all orders and branches."""
    free = entry.free(statement)
    order = [symbol for symbol in free if symbol.quantity is ORDER]
    branches = [symbol for symbol in free if symbol.quantity is BRANCH]
    for n in orders if order else (0,):
        for branch in range((entry.branches or n) if branches else 1):
            fixed = {**dict.fromkeys(order, n), **dict.fromkeys(branches, branch)}
            draws = [Draw(f"{entry.number} {n} {branch}{end}", entry.moving, digits) for end in ("", " real")]
            for label, values, pair in _points(entry, statement, fixed, *draws):
                yield f"n = {n}, {label}" if order else label, {**fixed, **values}, pair


def _points(entry: Entry, statement: Term, fixed: Values, draw: Draw, real: Draw) -> Iterator[SeededPoint]:
    """Yield points at one order and branch: generic, one special symbol, the entry's, real, poles, two special."""
    free = [symbol for symbol in entry.free(statement) if symbol.quantity not in (ORDER, BRANCH)]
    special = [(symbol, label, make) for symbol in free for label, make in symbol.quantity.special.items()]

    def generic(source: Draw = draw) -> Values:
        return {symbol: symbol.quantity.generic(source) for symbol in free}

    for i in range(GENERIC_POINTS):
        yield f"generic point {i + 1}", generic(), False
    for symbol, label, make in special:
        yield f"{symbol.name}: {label}", {**generic(), symbol: make(draw)}, False
    for label, point in (entry.also(draw) if entry.also else {}).items():
        yield label, {**generic(), **point}, False
    start, values = generic(), generic(real)
    if any(isinstance(value, Dual | Structure) for value in values.values()):
        yield "all symbols real", {symbol: _real(value) for symbol, value in values.items()}, False
    at_start = Env(Decimal60(), {**fixed, **start}, entry.definitions, moving=entry.moving)
    for label, moved in poles(statement, at_start):
        yield label, {**start, **moved}, False
    for (first, label, make), (second, other, other_make) in combinations(special, 2):
        if first != second:
            values = {**generic(), first: make(draw), second: other_make(draw)}
            yield f"{first.name}: {label}, {second.name}: {other}", values, True


def _real(value: Any) -> Any:
    if isinstance(value, Structure):
        return value.map(_real)
    return Dual(value.re, 0 * value.du) if isinstance(value, Dual) else value


def _truth(env: Env, statement: Term) -> bool | None:
    try:
        return bool(env.value(statement))
    except ArithmeticError:  # pole, zero divisor or root of a negative number
        return None


def poles(statement: Term, env: Env) -> Iterator[tuple[str, Mapping[Symbol, Any]]]:
    """Yield the first multiple of a symbol at which a denominator has real part 0, for each denominator and symbol."""
    for below in dict.fromkeys(denominators(statement)):
        for symbol in symbols(below):
            if symbol.quantity.name in SCALED and symbol not in env.definitions:
                scale = _root(below, symbol, env)
                if scale is not None:
                    yield f"{text(below)} has the real part 0", {symbol: env.values[symbol] * scale}


def denominators(statement: Term) -> Iterator[Term]:
    """Yield the denominators that contain symbols."""
    for node in walk(statement):
        if node.operator.name == "over" and symbols(node.arguments[1]):
            yield node.arguments[1]


def _root(below: Term, symbol: Symbol, env: Env) -> Any | None:
    """Return the first positive scale of a symbol at which a denominator has real part 0, or None."""
    values = {a: value for a, value in env.values.items() if a not in env.definitions}

    def real_part(scale: Any) -> Any:
        return innermost(replace(env, values={**values, symbol: values[symbol] * scale}).value(below))

    try:
        for low, high in pairwise(SCALES):
            if real_part(low) * real_part(high) < 0:
                return mpmath.findroot(real_part, (low, high), solver="anderson")
    except (ArithmeticError, TypeError, ValueError):
        pass
    return None


def counterexample(trial: Trial, entry: Entry, statement: Term) -> Counterexample:
    """Return the values of a statement's free symbols at a point, and the sides that differ there."""
    with mpmath.workdps(FIELD_DIGITS):
        numbers = {latex(symbol): shown(trial.env.value(symbol)) for symbol in entry.free(statement)}
        letters = {name: parts for name, parts in numbers.items() if parts}
        return Counterexample(trial.point, letters, sides(trial.env, statement, shown))


def sides(env: Env, statement: Term, shown: Callable[[Any], list[str]]) -> tuple[list[str], ...]:
    """Return the first two neighbouring sides of an equation that are unequal, each as `shown`."""
    if Trait.JOINS in statement.operator.traits:
        return next((found for part in statement.arguments if (found := sides(env, part, shown))), ())
    if statement.operator is operator_table.equal:
        for pair in pairwise(statement.arguments):
            try:
                a, b = (env.now(env.value(side)) for side in pair)
            except ArithmeticError:
                return ()
            if not equal(env.field, a, b):
                return shown(a), shown(b)
    return ()


def shown(value: Any) -> list[str]:
    """Return the numbers of a value as decimals; an empty list if the value does not consist of numbers."""
    first = value.first if isinstance(value, Either) else value
    if isinstance(first, bool) or not isinstance(first, Structure | Pose | Dual | mpmath.mpf | int):
        return []
    return [mpmath.nstr(mpmath.mpf(part), SHOWN_DIGITS) for part in coefficients(first)]
