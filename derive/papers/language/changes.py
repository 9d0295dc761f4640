"""What mutants make of a term by its mark; each row of the notation table names those that fit it."""

from __future__ import annotations

from .terms import Apply, Change, Term


def made(sibling: str) -> Change:
    """Another mark in its place."""
    return Change(f"{{}} made {sibling}", lambda term: Apply(sibling, *term.arguments))


def _swapped(term: Apply) -> Term:
    return term.operator(*reversed(term.arguments))


SWAPPED = Change("arguments of {} swapped", _swapped)
DROPPED = Change("{} dropped", lambda term: term.arguments[0])
SECOND_DROPPED = Change("second part of {} dropped", lambda term: term.arguments[0])
FIRST_DROPPED = Change("first part of {} dropped", lambda term: term.arguments[1])
NEGATED = Change("{} negated", lambda term: Apply("negated", term))
SECOND_NEGATED = Change(
    "second part of {} negated", lambda term: term.operator(term.arguments[0], Apply("negated", term.arguments[1]))
)
MINUEND_DROPPED = Change("first part of {} dropped", lambda term: -term.arguments[1])
