"""Whether an equation that a sentence names displays what the sentence says of it."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ...equation import Equation
from ...language.evaluation import Env
from ...language.terms import Term, walk


def displays(entries: Sequence[Equation], number: str, part: Term) -> Callable[[Env], bool]:
    """Whether the printed form of the equation with that number has a part."""
    (entry,) = (entry for entry in entries if entry.number == number)
    return lambda env: part in walk(entry.readings[0].statement)
