"""Mutants of a statement or of its domain: one mark changed. What is checked at all must not survive them.

The mutants come from the tree that is printed and executed: integers are raised by one, and every mark says how its
terms can be changed (`language.changes`). `try_mutants` executes them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import partial

from .decide import ORDERS
from .equation import Equation
from .explore import explore
from .language.notation import negated
from .language.terms import Apply, Number, Symbol, Term, text
from .numbers.quantities import PROPOSITION
from .result import Result

UNCOMBINABLE = (TypeError, AttributeError, ValueError, KeyError, IndexError)
"""What combining things raises that have no such operation."""


@dataclass(frozen=True)
class Survivor:
    """A mutant that is as true as what it was made from."""

    number: str
    change: str
    statement: str


@dataclass
class Score:
    """How the mutants of some entries fared.

    Attributes
    ----------
    killed : int
        Those that are false somewhere, or true outside of their condition.
    meaningless : int
        Those that do not count, for they combine things which have no such operation.
    survivors : list of Survivor
        Those that are as true as what they were made from.
    """

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
        for i, (_, trial) in enumerate(trials(result.equation, statement, orders)):
            if i % every == len(result.equation.number) % every:
                score += trial()
    return score


def trials(
    entry: Equation, statement: Term, orders: Sequence[int] = ORDERS
) -> Iterator[tuple[str, Callable[[], Score]]]:
    """What can be changed in a statement of an entry and in its domain, and the way to execute it changed."""
    for change, mutant in mutants(statement):
        yield change, partial(try_mutant, entry, change, mutant, orders)
    for change, changed in domains(entry):
        yield change, partial(try_domain, entry, changed, change, statement, orders)


def try_domain(
    entry: Equation, changed: Equation, change: str, statement: Term, orders: Sequence[int] = ORDERS
) -> Score:
    """Execute a statement on another domain than the one of its entry: true inside, nowhere outside of a condition."""
    inside = outside = 0
    try:
        for outcome in explore(changed, statement, orders):
            if outcome.inside or not outcome.pair:
                if (outcome.truth is True) is not outcome.inside:
                    return Score(killed=1)
                inside += outcome.inside
                outside += not outcome.inside
    except UNCOMBINABLE:
        return Score(meaningless=1)
    if not inside or not (outside or changed.condition is None):
        return Score(killed=1)
    return Score(survivors=[Survivor(entry.number, change, text(statement))])


def try_mutant(entry: Equation, change: str, mutant: Term, orders: Sequence[int] = ORDERS) -> Score:
    """Execute one mutant of a statement of an entry."""
    try:
        alive = all(outcome.truth is True for outcome in explore(entry, mutant, orders) if outcome.inside)
    except UNCOMBINABLE:  # a vector where a number belongs
        return Score(meaningless=1)
    return Score(survivors=[Survivor(entry.number, change, text(mutant))]) if alive else Score(killed=1)


def domains(entry: Equation) -> Iterator[tuple[str, Equation]]:
    """The entry with its condition or the domain that it claims changed, or without it."""
    if entry.condition is not None:
        yield "condition dropped", replace(entry, condition=None)
        for change, mutant in _changed(entry.condition):
            yield f"condition: {change}", replace(entry, condition=mutant)
    if entry.claimed is not None:
        yield "claimed domain dropped", replace(entry, claimed=None)
        for change, mutant in _changed(entry.claimed):
            yield f"claimed domain: {change}", replace(entry, claimed=mutant)


def _changed(domain: Term) -> Iterator[tuple[str, Term]]:
    yield "negated", negated(domain)
    yield from (found for found in mutants(domain) if found[1] != negated(domain))


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
    if isinstance(node, Symbol) and node.quantity is PROPOSITION:
        yield f"{node.name} negated", negated(node)
    if not isinstance(node, Apply):
        return
    for change in node.operator.changes:
        yield change.what.format(node.operator.name), change.made(node)
    arguments = node.arguments
    for i, argument in enumerate(arguments):
        for what, mutant in _mutants(argument):
            yield what, node.operator(*arguments[:i], mutant, *arguments[i + 1 :])
