"""Evaluation of elementary expressions in one symbol, for any number type."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache, reduce
from operator import mul
from typing import Any, TypeAlias

import mpmath
import sympy

from ..algebra import Coefficient, Dual, functions, real_part
from ..algebra.pose import is_zero
from .quotient import BESIDE_ORDER, BOUND, Quotient, lost, taylor

FUNCTIONS = ("sin", "cos", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "atanh", "exp", "log")
"""Functions that a library may provide in addition to sqrt."""

QUOTIENTS = {sympy.tan: (sympy.sin, sympy.cos), sympy.cot: (sympy.cos, sympy.sin)}

EXPRESSIONS_MAX = 256
"""Number of cached expressions; reading an expression takes longer than evaluating it."""

Step: TypeAlias = Callable[[Sequence[Coefficient], Coefficient, Any], Coefficient]
"""Function that computes one part of an expression from known parts, the value of the symbol and a library."""


def evaluate(expression: sympy.Expr, symbol: sympy.Symbol, value: Coefficient, library: Any = functions) -> Coefficient:
    """Return the value of an elementary expression in one symbol; each part is computed once.

    `library` provides ``sin``, ``cos``, ``sqrt`` for the numbers, ``exp``, ``log`` for rational exponents with
    denominators above 2. It may provide ``constant`` for numbers such as π, ``power`` for integer exponents, and
    ``quotient`` for `Quotient`. Division by zero raises ZeroDivisionError for every number type. A part that is not
    elementary, or contains another symbol, raises ValueError.
    """
    known: list[Coefficient] = []
    for step in _steps(expression, symbol):
        known.append(step(known, value, library))
    return known[-1]


@lru_cache(maxsize=EXPRESSIONS_MAX)
def _steps(expression: sympy.Expr, symbol: sympy.Symbol) -> Sequence[Step]:
    reader = _Reader(symbol)
    reader.place(expression)
    return reader.steps


class _Reader:
    def __init__(self, symbol: sympy.Symbol) -> None:
        self.steps: list[Step] = [lambda known, value, library: value]
        self._symbol, self._places = symbol, {symbol: 0}

    def place(self, e: sympy.Expr) -> int:
        """Return the index of the step that computes an expression."""
        if e not in self._places:
            step = self._step(e)
            self._places[e] = len(self.steps)
            self.steps.append(step)
        return self._places[e]

    def _step(self, e: sympy.Expr) -> Step:
        if e.is_Integer:
            integer = int(e)
            return lambda known, value, library: integer
        if e.is_Add:
            terms = [self.place(a) for a in e.args]
            return lambda known, value, library: sum(known[i] for i in terms)
        if e.is_Mul:
            return self._product(*sympy.fraction(e))
        if e.is_Rational:
            p, q = int(e.p), int(e.q)
            return lambda known, value, library: over(value * 0 + p, q)
        if not e.free_symbols:
            return lambda known, value, library: value * 0 + getattr(library, "constant", _constant)(e)
        return self._power(e) if e.is_Pow else self._function(e)

    def _product(self, numerator: sympy.Expr, denominator: sympy.Expr) -> Step:
        factors = [self.place(a) for a in sympy.Mul.make_args(numerator)]
        if denominator == 1:
            return lambda known, value, library: reduce(mul, (known[i] for i in factors))
        below = self.place(denominator)
        return lambda known, value, library: over(reduce(mul, (known[i] for i in factors)), known[below])

    def _power(self, e: sympy.Expr) -> Step:
        base, exponent = e.as_base_exp()
        if not exponent.is_Rational:
            raise ValueError(f"not an elementary expression in {self._symbol}: {e}")
        at, p, q = self.place(base), int(exponent.p), int(exponent.q)
        if q > 2:  # for positive numbers
            return lambda known, value, library: library.exp(library.log(known[at]) * (value * 0 + p) / q)

        def power(known: Sequence[Coefficient], value: Coefficient, library: Any) -> Coefficient:
            raised = getattr(library, "power", pow)(known[at] if q == 1 else library.sqrt(known[at]), abs(p))
            return raised if p > 0 else over(1 + 0 * raised, raised)

        return power

    def _function(self, e: sympy.Expr) -> Step:
        if isinstance(e, Quotient):
            place = self.place(e.args[2])
            return lambda known, value, library: getattr(library, "quotient", _quotient)(e, known[place])
        if e.func.__name__ not in FUNCTIONS and e.func not in QUOTIENTS:
            raise ValueError(f"not an elementary expression in {self._symbol}: {e}")
        argument = e.args[0]
        if quotient := QUOTIENTS.get(e.func):
            above, below = (self.place(f(argument, evaluate=False)) for f in quotient)
            return lambda known, value, library: over(known[above], known[below])
        name, at = e.func.__name__, self.place(argument)
        return lambda known, value, library: getattr(library, name)(known[at])


def _quotient(e: Quotient, value: Coefficient) -> Coefficient:
    """Return a quotient at a number, perhaps a nested dual one, in the working precision of mpmath."""
    real = value
    while isinstance(real, Dual):
        real = real.re
    if isinstance(real, float):
        return float(_quotient(e, mpmath.mpf(real)))
    if is_zero(real):
        terms = [value * 0 + _constant(taylor(e.above, e.power + count)) for count in range(BESIDE_ORDER + 1)]
        return reduce(lambda total, term: total * value + term, reversed(terms))
    with mpmath.extraprec(lost(real, e.power)):
        return evaluate(e.above, BOUND, value) / value**e.power


def _constant(e: sympy.Expr) -> Any:
    return mpmath.mpf(e.evalf(mpmath.mp.dps + 5))


def over(a: Coefficient, b: Coefficient) -> Coefficient:
    """Return a/b; raise `ZeroDivisionError` where b is 0, for every number type."""
    if is_zero(real_part(b)):
        raise ZeroDivisionError(f"division of {a!r} by {b!r}")
    return a / b
