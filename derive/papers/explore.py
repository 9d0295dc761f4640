"""Truth of a statement at seeded points: generic, real, with one or two special symbols, and at poles."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import mpmath

from derive.algebra import Dual, Structure

from .equation import Equation
from .language.evaluation import Env
from .language.terms import Symbol, Term
from .numbers.draw import Draw
from .numbers.fields import DIGITS, Decimal60
from .numbers.quantities import BRANCH, ORDER, Make
from .poles import poles

GENERIC_POINTS = 2


@dataclass(frozen=True)
class Outcome:
    """Truth of a statement at one point; None where it is undefined."""

    point: str
    inside: bool
    truth: bool | None
    env: Env
    pair: bool = False
    """True if two symbols have special values."""

    @property
    def place(self) -> str:
        """Point and truth in words."""
        return f"{self.point}: {'no value' if self.truth is None else str(self.truth).lower()}"


def explore(entry: Equation, statement: Term, orders: Sequence[int], digits: int = 30) -> Iterator[Outcome]:
    """Yield the truth of a statement at each point inside the entry's claimed domain."""
    with mpmath.workdps(DIGITS):
        for point in points(entry, statement, orders, digits):
            if entry.claimed is not None and not _truth(point.env, entry.claimed):
                continue
            inside = entry.condition is None or bool(_truth(point.env, entry.condition))
            yield Outcome(point.label, inside, _truth(point.env, statement), point.env, point.pair)


@dataclass(frozen=True)
class Point:
    """Values of all symbols, with a label for the special value."""

    label: str
    env: Env
    pair: bool = False


def points(entry: Equation, statement: Term, orders: Sequence[int], digits: int = 30) -> Iterator[Point]:
    """Yield seeded points: generic, special, from the entry, all real, at poles, and with two special symbols."""
    free = entry.free(statement)
    order = next((symbol for symbol in free if symbol.quantity is ORDER), None)
    others = [symbol for symbol in free if symbol.quantity not in (ORDER, BRANCH)]
    branches = [symbol for symbol in free if symbol.quantity is BRANCH]
    for n in orders if order is not None else (0,):
        prefix = f"n = {n}, " if order is not None else ""
        for branch in range((entry.branches or n) if branches else 1):
            fixed = {**({order: n} if order is not None else {}), **dict.fromkeys(branches, branch)}
            draw = Draw(f"{entry.number} {n} {branch}", entry.moving, digits)
            for label, values in _variations(draw, others, entry):
                yield Point(f"{prefix}{label}", _environment(entry, {**fixed, **values}))
            start = {**fixed, **{symbol: symbol.quantity.generic(draw) for symbol in others}}
            for values in _all_real(Draw(f"{entry.number} {n} {branch} real", entry.moving, digits), others):
                yield Point(f"{prefix}all symbols real", _environment(entry, {**fixed, **values}))
            for label, moved in poles(statement, _environment(entry, start)):
                yield Point(f"{prefix}{label}", _environment(entry, {**start, **moved}))
            for label, values in _pairs(draw, others):
                yield Point(f"{prefix}{label}", _environment(entry, {**fixed, **values}), pair=True)


def _environment(entry: Equation, values: dict[Symbol, object]) -> Env:
    return Env(Decimal60(), values, entry.definitions, moving=entry.moving)


def _variations(draw: Draw, free: Sequence[Symbol], entry: Equation) -> Iterator[tuple[str, dict[Symbol, object]]]:
    def generic() -> dict[Symbol, object]:
        return {symbol: symbol.quantity.generic(draw) for symbol in free}

    for i in range(GENERIC_POINTS):
        yield f"generic point {i + 1}", generic()
    for symbol, label, make in _special(free):
        yield f"{symbol.name}: {label}", {**generic(), symbol: make(draw)}
    for label, point in (entry.also(draw) if entry.also else {}).items():
        yield label, {**generic(), **point}


def _all_real(draw: Draw, free: Sequence[Symbol]) -> Iterator[dict[Symbol, object]]:
    """Yield one point with all dual parts removed, unless all values are plain numbers."""
    values = {symbol: symbol.quantity.generic(draw) for symbol in free}
    if any(isinstance(value, Dual | Structure) for value in values.values()):
        yield {symbol: _real(value) for symbol, value in values.items()}


def _real(value: Any) -> Any:
    """Return a value without its dual part."""
    if isinstance(value, Structure):
        return value.map(_real)
    return Dual(value.re, 0 * value.du) if isinstance(value, Dual) else value


def _pairs(draw: Draw, free: Sequence[Symbol]) -> Iterator[tuple[str, dict[Symbol, object]]]:
    for (first, label, make), (second, other, other_make) in combinations(_special(free), 2):
        if first != second:
            values = {symbol: symbol.quantity.generic(draw) for symbol in free}
            point = {**values, first: make(draw), second: other_make(draw)}
            yield f"{first.name}: {label}, {second.name}: {other}", point


def _special(free: Sequence[Symbol]) -> list[tuple[Symbol, str, Make]]:
    """Return all special values of all symbols: symbol, label and function that draws the value."""
    return [(symbol, label, make) for symbol in free for label, make in symbol.quantity.special.items()]


def _truth(env: Env, statement: Term) -> bool | None:
    try:
        return bool(env.value(statement))
    except ArithmeticError:  # pole, zero divisor or root of a negative number
        return None
