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
from .language.terms import Term, Trait, latex
from .numbers.fields import DIGITS
from .result import Counterexample

SHOWN_DIGITS = 30
"""Digits shown for a value."""


def counterexample(point: str, env: Env, entry: Equation, statement: Term) -> Counterexample:
    """Return the values of a statement's free symbols at a point, and the sides that differ there."""
    with mpmath.workdps(DIGITS):
        numbers = {latex(symbol): shown(env.value(symbol)) for symbol in entry.free(statement)}
        return Counterexample(point, {name: parts for name, parts in numbers.items() if parts}, _sides(env, statement))


def _sides(env: Env, statement: Term) -> tuple[list[str], ...]:
    """Return the first two neighbouring sides of an equation that are unequal."""
    if Trait.JOINS in statement.operator.traits:
        return next((found for part in statement.arguments if (found := _sides(env, part))), ())
    if statement.operator is equal:
        for pair in pairwise(statement.arguments):
            try:
                a, b = (env.now(env.value(side)) for side in pair)
            except ArithmeticError:
                return ()
            if not values.equal(env.field, a, b):
                return shown(a), shown(b)
    return ()


def shown(value: Any) -> list[str]:
    """Return all parts of a value as decimal numbers; none if the value does not consist of numbers."""
    first = value.first if isinstance(value, values.Either) else value
    if isinstance(first, bool) or not isinstance(first, Structure | Pose | Dual | mpmath.mpf | int):
        return []
    return [mpmath.nstr(mpmath.mpf(part), SHOWN_DIGITS) for part in values.coefficients(first)]
