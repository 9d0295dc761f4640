"""Comparison of two formulas: their smallest differing parts are coloured."""

from __future__ import annotations

from ..language.notation import define
from ..language.terms import ATOM, LIST, POWER, PRODUCT, RELATION, SUM, Apply, Term, latex

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
    applied = isinstance(a, Apply) and isinstance(b, Apply) and a.operator is b.operator
    if applied and len(a.arguments) == len(b.arguments):
        pairs = [_marked(s, t) for s, t in zip(a.arguments, b.arguments, strict=True)]
        return a.operator(*(s for s, _ in pairs)), b.operator(*(t for _, t in pairs))
    return _coloured(a), _coloured(b)


def _coloured(a: Term) -> Term:
    return CHANGED[a.operator.level if isinstance(a, Apply) else ATOM](a)
