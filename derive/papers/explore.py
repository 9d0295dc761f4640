"""A statement at seeded points: all letters generic, each special value of each letter and of two, and poles."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import mpmath

from .equation import Equation
from .language.evaluation import Env
from .language.terms import Letter, Term
from .numbers.draw import Draw
from .numbers.fields import DIGITS, Decimal60
from .numbers.kinds import BRANCH, ORDER, Make
from .poles import poles

GENERIC_POINTS = 2


@dataclass(frozen=True)
class Outcome:
    """What a statement was at one point: true, false, or without a value."""

    point: str
    inside: bool
    truth: bool | None
    env: Env
    pair: bool = False
    """Whether two letters have special values at once."""

    @property
    def place(self) -> str:
        """The point, in words."""
        return f"{self.point}: {'no value' if self.truth is None else str(self.truth).lower()}"


def explore(entry: Equation, statement: Term, orders: Sequence[int], digits: int = 30) -> Iterator[Outcome]:
    """The statement at all points of the entry's claimed domain."""
    with mpmath.workdps(DIGITS):
        for point in points(entry, statement, orders, digits):
            if entry.claimed is not None and not _truth(point.env, entry.claimed):
                continue
            inside = entry.condition is None or bool(_truth(point.env, entry.condition))
            yield Outcome(point.label, inside, _truth(point.env, statement), point.env, point.pair)


@dataclass(frozen=True)
class Point:
    """Values of all letters, and what is special about them."""

    label: str
    env: Env
    pair: bool = False


def points(entry: Equation, statement: Term, orders: Sequence[int], digits: int = 30) -> Iterator[Point]:
    """Seeded points: all letters generic, each special value of each letter and of two, the entry's own, and poles."""
    free = entry.free(statement)
    order = next((letter for letter in free if letter.kind is ORDER), None)
    others = [letter for letter in free if letter.kind not in (ORDER, BRANCH)]
    branches = [letter for letter in free if letter.kind is BRANCH]
    for n in orders if order is not None else (0,):
        prefix = f"n = {n}, " if order is not None else ""
        for branch in range((entry.branches or n) if branches else 1):
            fixed = {**({order: n} if order is not None else {}), **dict.fromkeys(branches, branch)}
            draw = Draw(f"{entry.number} {n} {branch}", entry.moving, digits)
            for label, values in _variations(draw, others, entry):
                yield Point(f"{prefix}{label}", _environment(entry, {**fixed, **values}))
            start = {**fixed, **{letter: letter.kind.generic(draw) for letter in others}}
            for label, moved in poles(statement, _environment(entry, start)):
                yield Point(f"{prefix}{label}", _environment(entry, {**start, **moved}))
            for label, values in _pairs(draw, others):
                yield Point(f"{prefix}{label}", _environment(entry, {**fixed, **values}), pair=True)


def _environment(entry: Equation, values: dict[Letter, object]) -> Env:
    return Env(Decimal60(), values, entry.definitions, moving=entry.moving)


def _variations(draw: Draw, free: Sequence[Letter], entry: Equation) -> Iterator[tuple[str, dict[Letter, object]]]:
    def generic() -> dict[Letter, object]:
        return {letter: letter.kind.generic(draw) for letter in free}

    for i in range(GENERIC_POINTS):
        yield f"generic point {i + 1}", generic()
    for letter, label, make in _special(free):
        yield f"{letter.name}: {label}", {**generic(), letter: make(draw)}
    for label, point in (entry.also(draw) if entry.also else {}).items():
        yield label, {**generic(), **point}


def _pairs(draw: Draw, free: Sequence[Letter]) -> Iterator[tuple[str, dict[Letter, object]]]:
    for (first, label, make), (second, other, other_make) in combinations(_special(free), 2):
        if first != second:
            values = {letter: letter.kind.generic(draw) for letter in free}
            point = {**values, first: make(draw), second: other_make(draw)}
            yield f"{first.name}: {label}, {second.name}: {other}", point


def _special(free: Sequence[Letter]) -> list[tuple[Letter, str, Make]]:
    """Every special value of every letter."""
    return [(letter, label, make) for letter in free for label, make in letter.kind.special.items()]


def _truth(env: Env, statement: Term) -> bool | None:
    try:
        return bool(env.value(statement))
    except ArithmeticError:  # a pole, a zero divisor, a root of a negative number
        return None
