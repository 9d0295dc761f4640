"""Partial operations of a statement: what each asks of a number, and terms that are not 0 by their form."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from math import inf, prod
from types import MappingProxyType

from ..language.calculus import BINDERS
from ..language.matrices import zeros
from ..language.operator_table import Re, cos, det, infinity, sin
from ..language.printed import Number, Symbol, Term, Trait, symbols, walk
from ..numbers.kinds import BRANCH, ORDER
from .terms import is_dual, magnitudes

ROOTS = tuple(Number(k) / Number(2) for k in (1, 3, 5))
"""Exponents of powers that have a value at 0."""
OPEN = "open"
"""Mark of an operation whose values are not proved to exist."""
EXPANDED = ("series", "limit at")
"""Operators that fill removable singularities; that they have a value is seen when they are evaluated."""
TURNS = ("rotation", "pose 4x4", "unit real quaternion", "orthogonal tensor", "unit quaternion")
"""Kinds whose values have an inverse."""


def _evaluated_nodes(statement: Term) -> Iterator[Term]:
    """Yield the terms whose values a statement takes; that of a magnitude in an even power is not one of them."""
    yield statement
    if statement.operator.name not in EXPANDED:
        for part in statement.arguments[0].arguments if _is_square_of_length(statement) else statement.arguments:
            yield from _evaluated_nodes(part)


def _is_square_of_length(node: Term) -> bool:
    """Return whether a term is an even power of a magnitude, whose value `power` takes by that of a square."""
    if node.operator.name != "power" or Trait.LENGTH not in node.arguments[0].operator.traits:
        return False
    return isinstance(node.arguments[1], Number) and node.arguments[1].value % 2 == 0


def _point(node: Term) -> Term:
    """Return the point about which a series or limit is taken; a vector is 0 by its kind."""
    letter, point = node.arguments[1], Number(0) if node.operator.name == "series" else node.arguments[2]
    vector = isinstance(letter, Symbol) and "vector" in letter.quantity.name
    zero: Term = zeros(Number(3), Number(1)) if vector and point == Number(0) else point
    return zero


def is_invertible(part: Term) -> bool:
    """Return whether a term is a product of displacements, whose inverse exists."""
    name = part.operator.name
    if isinstance(part, Symbol):
        return part.quantity.name.removeprefix("constant ") in TURNS
    if name in ("times", "inverse", "transpose", "conjugate", "bracket"):
        return all(map(is_invertible, part.arguments))
    return (name == "pose of" and is_invertible(part.arguments[0])) or (
        name == "exp" and part.arguments[0].operator.name == "skew")


def real(part: Term) -> Term:
    """Return a term that has an inverse where the real part of a term or of its magnitude is not 0."""
    return real(part.arguments[0]) if part.operator.name in ("Re", "norm") else part


def is_named(part: Term, named: Sequence[Term]) -> bool:
    """Return whether a term is not 0 if these terms are not, as a power, a product or a magnitude of them."""
    if not {part, det(part)}.isdisjoint(named):
        return True
    name, arguments = part.operator.name, part.arguments
    if name in ("power", "norm", "negative", "bracket", "root", "Re"):
        return is_named(arguments[0], named)
    return name == "times" and all(isinstance(a, Number) or is_named(a, named) for a in arguments)


def least(term: Term, indices: Mapping[Term, Collection[Term]] = MappingProxyType({})) -> float:
    """Return the least value of a sum or product of numbers, orders and indices; -∞ if it is not known.

    The `indices` start at 0 or above, and end at these terms.
    """
    if isinstance(term, Number):
        return term.value
    if isinstance(term, Symbol):
        return 1 if term.quantity is ORDER else 0 if term.quantity is BRANCH or term in indices else -inf
    name, parts = term.operator.name, [least(a, indices) for a in term.arguments]
    if name == "minus" and {term.arguments[0]} == indices.get(term.arguments[1]):
        return 0
    if name == "plus" or (name == "minus" and isinstance(term.arguments[1], Number)):
        return parts[0] + parts[1] * (1 if name == "plus" else -1)
    return prod(parts) if name in ("times", "bracket") and min(parts) >= 0 else -inf


def _indices(statement: Term) -> dict[Term, set[Term]]:
    """Return the indices of sums and products that are never negative, with their ends."""
    rows = [node.arguments for node in walk(statement) if BINDERS.get(node.operator.name) == 0]
    negative = {index for index, low, *_ in rows if least(low) < 0}
    return {index: {high for one, _, high, *_ in rows if one == index} for index, *_ in rows if index not in negative}


def partial_operations(
    statement: Term, has_slope: Callable[[Term], bool], given: Sequence[Term] = ()
) -> Iterator[tuple[Term, str]]:
    """Yield the terms on which a partial operation of a statement depends, with what it asks of them.

    At 0 a magnitude or root has no slope, nor has an arc sine at 1. Nothing is asked of the series and limits that are
    `given` to have a value.
    """
    indices, bent = _indices(statement), magnitudes(statement)
    for node in _evaluated_nodes(statement):
        name, arguments = node.operator.name, node.arguments
        if name == "over":
            yield arguments[1], "not 0"
        elif name == "power" and least(arguments[1], indices) < 0:
            exponent = arguments[1]
            if exponent not in ROOTS:
                yield arguments[0], "not 0"
            if exponent.operator.name in ("over", "negative", "bracket"):
                yield arguments[0], "logarithm" if has_slope(arguments[0]) else "not negative"
        elif name in ("inverse", "rotation of quaternion"):
            yield arguments[0], "not 0"
        elif name == "norm" and has_slope(arguments[0] if node in bent else Re(arguments[0])):
            yield arguments[0], "not 0" if has_slope(Re(arguments[0])) else "magnitude"  # ε y has one, ε |y|
        elif name == "root":
            yield arguments[0], "logarithm" if has_slope(arguments[0]) else "not negative"
        elif name in EXPANDED and node not in given:
            point = None if infinity in arguments else _point(node)
            for part, asked in partial_operations(arguments[0], has_slope):
                if any(a.quantity.varies and a != arguments[1] for a in symbols(part)):
                    yield from [(part.xreplace({arguments[1]: point}), asked)] if point is not None else [(node, OPEN)]
        elif name == "log":
            yield arguments[0], "logarithm"
        elif name in ("acos", "asin"):
            yield arguments[0], "inside 1" if has_slope(arguments[0]) else "within 1"
        elif name in ("tan", "cot"):
            yield (cos if name == "tan" else sin)(*arguments), "not 0"
        elif name == "atan2 of two":
            y, x = arguments
            yield y**2 + x**2, "not 0"
            if has_slope(y) and not is_dual(y) and not is_dual(x):  # a rate asks for no jump, dual parts take one side
                yield (y**2 + x**2) ** ROOTS[0] + x, "not 0"
