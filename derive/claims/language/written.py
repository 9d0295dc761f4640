"""Terms as claims in plain text: the inverse of parsing."""

from __future__ import annotations

from .calculus import BINDERS
from .operations import CONSTANTS, OPERATIONS
from .printed import Number, Symbol, Term, text

OR, AND, NOT, RELATION, SUM, PRODUCT, POWER, ATOM = range(8)
"""Binding strengths, in Python's order."""

INFIX: dict[str, tuple[str, int, int, int]] = {
    "or": (" or ", OR, OR, AND), "both": (" and ", AND, AND, NOT), "equal": (" == ", RELATION, SUM, SUM),
    "unlike": (" != ", RELATION, SUM, SUM), "less": (" < ", RELATION, SUM, SUM),
    "at most": (" <= ", RELATION, SUM, SUM),
    "greater": (" > ", RELATION, SUM, SUM), "at least": (" >= ", RELATION, SUM, SUM),
    "plus": (" + ", SUM, SUM, PRODUCT),
    "minus": (" - ", SUM, SUM, PRODUCT), "times": ("*", PRODUCT, PRODUCT, POWER),
    "over": ("/", PRODUCT, PRODUCT, POWER),
    "power": ("**", POWER, ATOM, POWER),
}  # fmt: skip
"""Sign, strength of the result, and least strengths of the left and right operand."""

PREFIX = {"negative": ("-", PRODUCT, POWER), "negated": ("not ", NOT, NOT), "nonzero": ("{} != 0", RELATION, SUM)}
LOCAL = ("limit at", "integral")
"""Operators whose letter has no value outside."""
NAMES = {symbol: name for name, (symbol, _) in CONSTANTS.items()}
CALLS = {row.operator or name: name for name, row in OPERATIONS.items()} | {"entry of column": "entry", "bracket": ""}
"""Name of a call by the name of its operator."""


def written(term: Term) -> str:
    """Return a term as a claim; an operator of a paper in Python keeps the characters of its text."""
    return _written(term)[0]


def _written(term: Term) -> tuple[str, int]:
    if isinstance(term, Number):
        return (str(term.value), ATOM) if term.value >= 0 else (str(term.value), PRODUCT)
    if isinstance(term, Symbol):
        return NAMES.get(term, str(term.args[3])), ATOM
    name, arguments = term.operator.name, term.arguments
    if BINDERS.get(name) == 1 and name not in LOCAL and str(arguments[1].args[3]) == written(arguments[2]):
        arguments = (*arguments[:2], *arguments[3:])
    if name in INFIX and len(arguments) >= 2:
        sign, level, left, right = INFIX[name]
        return sign.join(_at_least(a, right if i else left) for i, a in enumerate(arguments)), level
    if name in PREFIX:
        sign, level, least = PREFIX[name]
        inside = _at_least(arguments[0], least)
        return (sign.format(inside) if "{" in sign else sign + inside), level
    if name in CALLS:
        return f"{CALLS[name]}({', '.join(map(written, arguments))})", ATOM
    if not arguments:
        return text(term), ATOM
    return term.operator.text.format(*map(written, arguments)) if "{0}" in term.operator.text else text(term), ATOM


def _at_least(term: Term, least: int) -> str:
    shown, level = _written(term)
    return shown if level >= least else f"({shown})"
