"""Counterexamples: values of the symbols and of both sides at a point."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import mpmath

from derive.algebra import Dual, Structure
from derive.maps.pose import Pose

from .equation import Equation
from .language import values
from .language.evaluation import Env
from .language.notation import equal
from .language.terms import Apply, Term, Trait, latex
from .numbers.fields import DIGITS
from .result import Counterexample

SHOWN_DIGITS = 30
"""Digits shown for a value."""


def counterexample(point: str, env: Env, entry: Equation, statement: Term) -> Counterexample:
    """Return the values of a statement's free symbols at a point, and the sides that differ there."""
    with mpmath.workdps(DIGITS):
        symbols = {latex(symbol): shown(env.value(symbol)) for symbol in entry.free(statement)
                   if is_value(env.value(symbol))}
        return Counterexample(point, symbols, _different(env, statement))


def _different(env: Env, statement: Term) -> tuple[list[str], ...]:
    """Return the first two neighbouring sides of an equation that are unequal."""
    if not isinstance(statement, Apply):
        return ()
    if Trait.JOINS in statement.operator.traits:
        return next((found for part in statement.arguments if (found := _different(env, part))), ())
    if statement.operator is equal:
        for pair in pairwise(statement.arguments):
            try:
                a, b = (env.now(env.value(side)) for side in pair)
            except ArithmeticError:
                return ()
            if not values.equal(env.field, a, b):
                return tuple(shown(side) if is_value(side) else [] for side in (a, b))
    return ()


def is_value(value: Any) -> bool:
    """Return whether a value consists of numbers."""
    if isinstance(value, values.Either):
        return is_value(value.first)
    return isinstance(value, Structure | Pose | Dual | mpmath.mpf | int) and not isinstance(value, bool)


def shown(value: Any, digits: int = SHOWN_DIGITS) -> list[str]:
    """Return all parts of a value as decimal numbers."""
    if isinstance(value, Pose):
        return [*shown(value.rotation, digits), *shown(value.displacement, digits)]
    return [mpmath.nstr(mpmath.mpf(part), digits) for part in values.coefficients(value)]
