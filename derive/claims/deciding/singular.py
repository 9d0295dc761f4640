"""Singular parts of a formula: where a claim may fail or has no value.

A singular part is a divisor, a matrix to invert, a radicand, the argument of a logarithm or of an inverse function, or
the difference of both sides of an inequality.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from ...algebra import Quaternion, Structure, Tensor, Vector, matrix
from ..language.operator_table import cos, sin
from ..language.printed import Number, Symbol, Term, symbols, walk
from ..numbers.balls import BlurredError, arb
from ..numbers.fields import innermost
from ..numbers.kinds import BRANCH, ORDER, SIGN
from .claim import Claim, kind
from .place import Place
from .terms import bare

ORDERED = frozenset(("less", "at most", "greater", "at least", "unlike"))
"""Operators of inequalities."""
PLAIN = frozenset(("plus", "minus", "times", "over", "negative", "bracket", "power"))
"""Operators whose value at a large integer is found fast."""
ABSENT = (ArithmeticError, BlurredError, TypeError, AttributeError, ValueError)
"""Errors of a number that has no value at a point."""


@dataclass(frozen=True)
class Singular:
    """Part of a formula without a value where some number is 0, such as a divisor; `size` returns this number."""

    part: Term
    size: Callable[[Any], Any]

    def number(self, claim: Claim, place: Place) -> Any:
        """Return the number at a point as Arb's ball."""
        return arb(self.size(claim.env(place).value(self.part)))


def size(value: Any) -> Any:
    """Return the number that vanishes where a value has no inverse."""
    if isinstance(value, Quaternion):
        return innermost(value.norm2())
    if isinstance(value, Vector):
        return innermost(value.dot(value))
    if isinstance(value, Tensor):
        return innermost(value.det())
    if isinstance(value, Structure):
        rows, columns = matrix.shape(value)
        return innermost(matrix.det(value) if rows == columns else sum(c * c for c in value))
    return innermost(value)


def singular(*statements: Term) -> Iterator[Singular]:
    """Yield the singular parts of statements that contain letters."""
    found: dict[Term, Singular] = {}
    asserted = {part for statement in statements for part in _asserted(statement)}
    for node in (node for statement in statements for node in walk(statement)):
        name, arguments = node.operator.name, node.arguments
        part, number = None, size
        if name in ("over", "power"):
            exponent = arguments[1]
            if name == "over" or not (isinstance(exponent, Number) and exponent.value >= 0):
                part = bare(arguments[1 if name == "over" else 0])
        elif name in ("inverse", "root", "norm", "atan2 of two"):
            part = bare(arguments[0]) if name == "root" else arguments[0]
        elif name == "log":
            part, number = arguments[0], _half_turn
        elif name in ("acos", "asin"):
            part, number = arguments[0], _beyond_one
        elif name in ("tan", "cot"):
            part = (cos if name == "tan" else sin)(*arguments)
        elif name in ORDERED or (name == "equal" and node not in asserted):
            part = bare(arguments[0] if arguments[1] == Number(0) else arguments[0] - arguments[1])
        elif name in ("nonzero", "positive"):
            part = bare(arguments[0])
        if part is not None:
            found.setdefault(node if number is _beyond_one else part, Singular(part, number))
    for one in found.values():
        letters = symbols(one.part)
        if letters and not any(a.quantity.name == "index" for a in letters):
            yield one


def _asserted(statement: Term) -> Iterator[Term]:
    """Yield the relations that a statement asserts, whose sides are equal at all points if it is true."""
    yield statement
    if statement.operator.name in ("both", "remark"):
        for part in statement.arguments:
            yield from _asserted(part)


def _beyond_one(value: Any) -> Any:
    """Return the number that vanishes where an inverse function ends."""
    return 1 - innermost(value) * innermost(value)


def _half_turn(value: Any) -> Any:
    """Return the number that vanishes where the logarithm of a value is singular."""
    if isinstance(value, Tensor):
        return innermost(value.trace()) + 1
    if isinstance(value, matrix.Matrix):
        return innermost(sum(value.rows[i][i] for i in range(4)))
    return size(value)


def is_integer(letter: Symbol) -> bool:
    return letter.quantity is ORDER or (letter.quantity not in (SIGN, BRANCH) and kind(letter).spread == "integer")


def plain_in(part: Term, letter: Symbol) -> bool:
    """Return whether a letter occurs in sums, products, quotients and powers by numbers only, so it may be large."""
    nodes = [node for node in walk(part) if node.arguments and letter in symbols(node)]
    return all(node.operator.name in PLAIN and not (node.operator.name == "power" and symbols(node.arguments[1]))
               for node in nodes)  # fmt: skip
