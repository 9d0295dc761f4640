"""Mutants of a statement: one mark changed. A statement that is checked at all must not survive them.

The mutants come from the tree that is printed and executed: integers are raised by one, and every mark says how its
terms can be changed (`language.changes`). `try_mutants` executes them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from .decide import ORDERS
from .equation import Equation
from .explore import explore
from .language.terms import Apply, Number, Term, text
from .result import Result


@dataclass(frozen=True)
class Survivor:
    """A mutant that is as true as what it was made from."""

    number: str
    change: str
    statement: str


@dataclass
class Score:
    """How the mutants of some entries fared; those that combine things which have no such operation do not count."""

    killed: int = 0
    meaningless: int = 0
    survivors: list[Survivor] = field(default_factory=list)

    @property
    def share(self) -> float:
        """The share of the mutants that were killed."""
        tried = self.killed + len(self.survivors)
        return self.killed / tried if tried else 1.0

    def __add__(self, other: Score) -> Score:
        survivors = [*self.survivors, *other.survivors]
        return Score(self.killed + other.killed, self.meaningless + other.meaningless, survivors)


def true_statements(result: Result) -> tuple[Term, ...]:
    """What was found true: the readings that are, else the correction."""
    true = tuple(verdict.statement for verdict in result.verdicts if verdict.true)
    return true or (() if result.equation.corrected is None else (result.equation.corrected,))


def try_mutants(result: Result, every: int = 1, orders: Sequence[int] = ORDERS) -> Score:
    """Execute the mutants of what was found true.

    Parameters
    ----------
    every : int
        Take each mutant, or only every second, third …
    """
    score = Score()
    for statement in true_statements(result):
        for i, (change, mutant) in enumerate(mutants(statement)):
            if i % every == len(result.equation.number) % every:
                score += try_mutant(result.equation, change, mutant, orders)
    return score


def try_mutant(entry: Equation, change: str, mutant: Term, orders: Sequence[int] = ORDERS) -> Score:
    """Execute one mutant of a statement of an entry."""
    try:
        alive = all(outcome.truth is True for outcome in explore(entry, mutant, orders) if outcome.inside)
    except (TypeError, AttributeError, ValueError, KeyError, IndexError):  # a vector where a number belongs
        return Score(meaningless=1)
    return Score(survivors=[Survivor(entry.number, change, text(mutant))]) if alive else Score(killed=1)


def mutants(statement: Term) -> Iterator[tuple[str, Term]]:
    """All mutants with a description, each once."""
    seen = {statement}
    for what, mutant in _mutants(statement):
        if mutant not in seen:
            seen.add(mutant)
            yield what, mutant


def _mutants(node: Term) -> Iterator[tuple[str, Term]]:
    if isinstance(node, Number):
        yield f"{node.value} raised by 1", Number(node.value + 1)
    if not isinstance(node, Apply):
        return
    for change in node.mark.changes:
        yield change.what.format(node.mark.name), change.made(node)
    arguments = node.arguments
    for i, argument in enumerate(arguments):
        for what, mutant in _mutants(argument):
            yield what, node.mark(*arguments[:i], mutant, *arguments[i + 1 :])
