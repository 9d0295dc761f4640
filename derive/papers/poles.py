"""Points at which a denominator of a formula vanishes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Any

import mpmath

from derive.algebra import Vector

from .language.evaluation import Env
from .language.terms import Apply, Symbol, Term, symbols, text, walk
from .numbers.fields import innermost

SCALES = tuple(mpmath.mpf(k) / 8 for k in range(1, 41))
"""Scale factors for a symbol; sign changes are searched between neighbouring factors."""
SCALED = ("dual vector", "dual number", "argument")


def poles(statement: Term, env: Env) -> Iterator[tuple[str, Mapping[Symbol, Any]]]:
    """Yield, per denominator and symbol, the first multiple of the symbol that makes the denominator's real part 0."""
    for below in dict.fromkeys(denominators(statement)):
        for symbol in symbols(below):
            if symbol.quantity.name in SCALED and symbol not in env.definitions:
                scale = _root(below, symbol, env)
                if scale is not None:
                    yield f"{text(below)} has the real part 0", {symbol: _scaled(env.values[symbol], scale)}


def denominators(statement: Term) -> Iterator[Term]:
    """Yield the denominators that contain symbols."""
    for node in walk(statement):
        if isinstance(node, Apply) and node.operator.name == "over" and symbols(node.arguments[1]):
            yield node.arguments[1]


def _root(below: Term, symbol: Symbol, env: Env) -> Any | None:
    def real_part(scale: Any) -> Any:
        values = {a: v for a, v in env.values.items() if a not in env.definitions}
        moved = Env(env.field, {**values, symbol: _scaled(env.values[symbol], scale)}, env.definitions, env.dual,
                    env.moving)
        return innermost(moved.value(below))

    try:
        for low, high in pairwise(SCALES):
            if real_part(low) * real_part(high) < 0:
                return mpmath.findroot(real_part, (low, high), solver="anderson")
    except (ArithmeticError, TypeError, ValueError):
        pass
    return None


def _scaled(value: Any, scale: Any) -> Any:
    return value.map(lambda c: c * scale) if isinstance(value, Vector) else value * scale
