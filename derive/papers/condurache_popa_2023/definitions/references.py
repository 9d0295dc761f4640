"""Definition of "equation (n) displays this part"."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ...equation import Equation
from ...language.evaluation import Env
from ...language.terms import Term, walk


def displays(entries: Sequence[Equation], number: str, part: Term) -> Callable[[Env], bool]:
    """Return whether the printed form of the equation with that number has a part."""
    (entry,) = (entry for entry in entries if entry.number == number)
    return lambda env: part in walk(entry.readings[0].statement)
