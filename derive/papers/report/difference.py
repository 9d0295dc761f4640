"""Comparison of two formulas: their smallest differing parts are coloured."""

from __future__ import annotations

from ..language.notation import define
from ..language.terms import ATOM, LIST, POWER, PRODUCT, RELATION, SUM, Term, latex

COLOUR = "#b3261e"
CHANGED = {
    level: define(f"changed {level}", rf"\color{{{{{COLOUR}}}}}{{{{{{0}}}}}}", "{0}", level, (level,), lambda env, a: a)
    for level in (LIST, RELATION, SUM, PRODUCT, POWER, ATOM)
}
"""Operators that colour a term, by binding strength."""


def differing(printed: Term, right: Term) -> tuple[str, str]:
    """Return both formulas as LaTeX, with the differing parts in colour."""
    first, second = _marked(printed, right)
    return latex(first), latex(second)


def _marked(a: Term, b: Term) -> tuple[Term, Term]:
    if a == b:
        return a, b
    if a.arguments and a.operator is b.operator and len(a.arguments) == len(b.arguments):
        firsts, seconds = zip(*map(_marked, a.arguments, b.arguments), strict=True)
        return a.operator(*firsts), b.operator(*seconds)
    return CHANGED[a.operator.level](a), CHANGED[b.operator.level](b)
