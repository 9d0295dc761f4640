"""What an extraction leaves of a formula: letters, numerals and the marks that survive, in the order of the page."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum, auto

from ..language.notation import equal, remark
from ..language.terms import Apply, Letter, Mark, Number, Term, Trait

INSERTED = ("minus", "over", "times", "power", "dyad", "at", "negative", "norm", "root", "bracket")
"""The marks that are put back where they were lost."""


class Place(Enum):
    """Where a surviving mark stands."""

    BEFORE = auto()
    AFTER = auto()
    BETWEEN = auto()


@dataclass(frozen=True)
class Token:
    """A letter, a numeral or a part that is read as a whole; or a mark that survives, with its place."""

    term: Term | None = None
    mark: Mark | None = None
    place: Place | None = None


def equations(statement: Term) -> tuple[tuple[Term, ...], ...]:
    """The chains of equal sides that a statement consists of; none for one that says something else too."""
    if isinstance(statement, Apply) and statement.mark is equal:
        return (tuple(_sequence(side) for side in statement.arguments),)
    if isinstance(statement, Apply) and statement.mark is remark:
        return equations(statement.arguments[0])
    if isinstance(statement, Apply) and Trait.JOINS in statement.mark.traits and not statement.mark.lazy:
        parts = [equations(part) for part in statement.arguments]
        return tuple(chain for part in parts for chain in part) if all(parts) else ()
    return ()


def _sequence(side: Term) -> Term:
    """What a limit is taken of: a sequence that is constant is its own limit at every order."""
    if isinstance(side, Apply) and Trait.EVENTUAL in side.mark.traits:
        *_, side = side.arguments
    return side


def surviving(side: Term, lost: str) -> tuple[Token, ...]:
    """What an extraction that lost these marks leaves of one side."""
    return tuple(_tokens(side, str.maketrans("", "", lost + " ")))


def _tokens(node: Term, drop: dict[int, int | None]) -> Iterator[Token]:
    if not isinstance(node, Apply) or isinstance(node, Number | Letter):
        yield Token(node)
        return
    if _is_even_power(node):
        yield Token(node)
        return
    literals = [piece.translate(drop) for piece in re.split(r"\{\d+\}", node.mark.text)]
    place = _place(node.mark, literals, len(node.arguments))
    if place is None and not (node.mark.name in INSERTED and not any(literals)):
        yield Token(node)
        return
    mark = Token(mark=node.mark, place=place)
    if place is Place.BEFORE:
        yield mark
    for i, argument in enumerate(node.arguments):
        if i and place is Place.BETWEEN:
            yield mark
        yield from _tokens(argument, drop)
    if place is Place.AFTER:
        yield mark


def _is_even_power(node: Apply) -> bool:
    """|v|², |v|⁴ …, the X², X⁴ … of every polynomial of the paper: read as wholes."""
    base, *exponent = node.arguments
    return (
        node.mark.name == "power" and isinstance(base, Apply) and Trait.LENGTH in base.mark.traits
        and isinstance(base.arguments[0], Letter) and isinstance(exponent[0], Number) and exponent[0].value % 2 == 0
    )  # fmt: skip


def _place(mark: Mark, literals: list[str], arity: int) -> Place | None:
    """Where the one surviving sign of a mark stands; none if it has several, or none."""
    if mark.lazy or len(literals) != arity + 1 or sum(map(bool, literals)) != 1:
        return None
    if arity == 1:
        return Place.BEFORE if literals[0] else Place.AFTER
    return Place.BETWEEN if arity == 2 and literals[1] else None
