"""Certificates of the papers' equations: both sides of each equation as unreduced integer lists."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..algebra.element import Element
from ..claims.deciding.claim import ORDERS, Claim
from ..claims.deciding.proof import Pairs, proved
from ..claims.equation import Entry
from ..claims.language import operator_table
from ..claims.language.printed import Apply, Symbol, Term, text
from ..claims.language.written import written
from ..claims.result import Result, Status
from ..proof.certificate import Certificate, part
from ..proof.identity import Sides

TERMS_MAX = 2000
"""Largest number of terms in a certified polynomial; equations with more are listed with their number of terms."""


def certificate(result: Result, orders: Sequence[int] = ORDERS) -> Certificate | str:
    """Return the certificate of an equation or of its correction, or the reason why there is none."""
    entry = result.equation
    corrected = result.status is Status.ERRATUM
    statement = entry.corrected if corrected else result.verdicts[0].statement
    assert statement is not None
    if not _only_equations(statement):
        return "its statement is more than equations; " + result.method
    found: list[Pairs] = []
    method = proved(Claim(entry, statement, orders), found)
    pairs = [[pair for pair in part if any(isinstance(side, Element) for side in pair)] for part in found]
    if method is None or not any(pairs):
        return "it is decided by numbers; " + result.method
    if all(_alike(*pair) for part in pairs for pair in part):
        return "both sides come out in one form; " + result.method
    most = max(_terms(side) for part in pairs for pair in part for side in pair)
    if most > TERMS_MAX:
        return f"its polynomials have {most} terms, more than {TERMS_MAX}; {result.method}"
    claim = text(statement) if entry.written is None else written(statement)
    return {
        "name": f"{result.paper} ({entry.number}){', corrected' if corrected else ''}",
        "scope": method,
        "status": "proved",
        "method": "both sides evaluated at generic values, fractions not reduced",
        "claims": [claim],
        "premises": [{"text": _defined(entry, d.symbol), "by": "definition"} for d in entry.where],
        "parts": [part([(claim, _sides(*pair)) for pair in pairs]) for pairs in pairs if pairs],
    }


def _defined(entry: Entry, symbol: Symbol) -> str:
    """Return the definition of a symbol as its file gives it, or the place of one in Python."""
    found = entry.abbreviations.get(str(symbol.args[3]))
    return f"{found.head} = {found.text}" if found else f"{symbol.name} as defined in derive.maps"


def _only_equations(statement: Term) -> bool:
    if not isinstance(statement, Apply):
        return False
    if statement.operator is operator_table.both:
        return all(map(_only_equations, statement.arguments))
    return statement.operator is operator_table.equal or (
        statement.operator is operator_table.remark and _only_equations(statement.arguments[0])
    )


def _sides(left: Any, right: Any) -> Sides:
    ring = next(side.ring for side in (left, right) if isinstance(side, Element))
    return Sides(ring.element(left), ring.element(right))


def _alike(left: Any, right: Any) -> bool:
    """Return whether both sides have the same numerator and denominator."""
    if not (isinstance(left, Element) and isinstance(right, Element)):
        return not any(map(_terms, (left, right)))
    return bool(left.numerator == right.numerator and left.denominator == right.denominator)


def _terms(side: Any) -> int:
    """Return the number of terms of the numerator; 0 for the number 0."""
    return len(side.ring.library.terms(side.numerator)) if isinstance(side, Element) else int(side != 0)
