"""Definition of the claim "equation (n) displays this term"."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ...equation import Equation
from ...language.evaluation import Env
from ...language.terms import Term, walk


def displays(entries: Sequence[Equation], number: str, part: Term) -> Callable[[Env], bool]:
    """Return the definition of a claim: the printed equation with this number contains a term."""
    (entry,) = (entry for entry in entries if entry.number == number)
    return lambda env: part in walk(entry.readings[0].statement)
