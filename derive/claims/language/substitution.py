"""Substitution of letters in terms, and sums, products and relations over integers written out."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from functools import lru_cache, reduce
from typing import Any

from .calculus import BINDERS
from .operator_table import both, equal
from .printed import Apply, Number, Symbol, Term, symbols

BODIES = {"sum": 3, "product": 3, "every": 3}
"""Place of the term in which the letter is bound; the first by default."""
WRITTEN_MAX = 32
"""Largest number of terms of a sum that is written out."""
JOINS: dict[str, tuple[Callable[[Any, Any], Term], Term]] = {
    "sum": (operator.add, Number(0)), "product": (operator.mul, Number(1)), "every": (both, equal(0, 0)),
}  # fmt: skip
"""Operator between the terms of a sum, product or relation over integers, with what stands for no terms."""
FOLDS: dict[str, Callable[..., int]] = {
    "plus": operator.add, "minus": operator.sub, "times": operator.mul, "negative": operator.neg, "bracket": int,
}  # fmt: skip
"""Operators of integers."""


def substituted(term: Term, meanings: Mapping[Symbol, Term]) -> Term:
    """Return a term with symbols replaced; a bound letter that would be mistaken for another one is renamed."""
    if isinstance(term, Symbol):
        return meanings.get(term, term)
    if not isinstance(term, Apply) or not meanings:
        return term
    place = BINDERS.get(term.operator.name)
    if place is None:
        return Apply(term.operator.name, *(substituted(a, meanings) for a in term.arguments))
    letter, body = term.arguments[place], BODIES.get(term.operator.name, 0)
    assert isinstance(letter, Symbol)
    taken = {symbol for meaning in meanings.values() for symbol in symbols(meaning)}
    fresh = letter
    while fresh in taken or (fresh in meanings and fresh == letter):
        fresh = Symbol(f"{fresh.name}'", "index", str(letter.args[2]), str(letter.args[3]))
    inner = {a: b for a, b in meanings.items() if a != letter} | ({letter: fresh} if fresh != letter else {})
    parts = [substituted(a, inner if i == body else meanings) for i, a in enumerate(term.arguments)]
    parts[place] = fresh
    return Apply(term.operator.name, *parts)


def each(node: Term) -> list[Term] | None:
    """Return the terms of a sum, product or relation over few integers between two numbers; else None."""
    if BINDERS.get(node.operator.name) != 0:
        return None
    index, low, high, body = node.arguments
    if not (isinstance(low, Number) and isinstance(high, Number) and high.value - low.value < WRITTEN_MAX):
        return None
    assert isinstance(index, Symbol)
    return [_folded(substituted(body, {index: Number(k)})) for k in range(low.value, high.value + 1)]


def _folded(term: Term) -> Term:
    """Return a term with the values of its sums and products of integers."""
    if not isinstance(term, Apply):
        return term
    fold, arguments = FOLDS.get(term.operator.name), [_folded(a) for a in term.arguments]
    numbers = [a.value for a in arguments if isinstance(a, Number)]
    if fold is None or len(numbers) < len(arguments):
        return Apply(term.operator.name, *arguments)
    return Number(fold(*numbers))


@lru_cache(maxsize=256)
def written_out(term: Term) -> Term:
    """Return a term with sums, products and relations over integers written out."""
    if not isinstance(term, Apply):
        return term
    name, parts = term.operator.name, each(term)
    if parts is None:
        return Apply(name, *map(written_out, term.arguments))
    join, empty = JOINS[name]
    return reduce(join, map(written_out, parts)) if parts else empty
