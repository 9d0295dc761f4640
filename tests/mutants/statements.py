"""Mutants of the papers' true statements: one operator, integer, claim or domain is changed. Points refute them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import replace
from functools import partial
from itertools import chain

from derive.claims.decide import decide
from derive.claims.deciding.claim import Claim
from derive.claims.deciding.places import Probe
from derive.claims.equation import Entry, Reading
from derive.claims.language.operator_table import negated
from derive.claims.language.printed import RELATION, Apply, Number, Term
from derive.claims.numbers.balls import BlurredError
from derive.claims.result import Result
from derive.papers import PAPERS

from .mutant import EQUIVALENT, KILLED, SURVIVED, Mutant, Verdict

UNCOMBINABLE = (TypeError, AttributeError, ValueError, KeyError, IndexError)
"""Exceptions raised by operands that lack an operation."""

REPLACED = {
    "plus": "minus", "minus": "plus", "Re": "Du", "Du": "Re", "sin": "cos", "cos": "sin", "tan": "cot", "cot": "tan",
}
"""Replacement for each operator, by name."""
SWAPPED = ("minus", "over", "power", "implies", "cross", "dyad", "atan2 of two", "vector")
"""Operators whose arguments are swapped."""
DROPPED = (*REPLACED, "times", "negative", "root", "negated", "transpose", "conjugate", "arctan")
"""Operators that are dropped; only their first argument remains."""


def mutants() -> Iterator[Mutant]:
    """Yield every true statement with one mark changed, in the statement or its domain."""
    yield Mutant("papers", "none", "unchanged", partial(Verdict, SURVIVED))
    for paper in PAPERS:
        for entry in paper.entries():
            for statement in true_statements(decide(paper.slug, entry, paper.lost)):
                for change, trial in trials(entry, statement):
                    operator = change.partition(" made ")[0]
                    yield Mutant(f"{paper.short} ({entry.number})", operator, change, trial)


def true_statements(result: Result) -> tuple[Term, ...]:
    """Return the true readings; without one, return the correction."""
    true = tuple(verdict.statement for verdict in result.verdicts if verdict.true)
    return true or (() if result.equation.corrected is None else (result.equation.corrected,))


def trials(entry: Entry, statement: Term) -> Iterator[tuple[str, Callable[[], Verdict]]]:
    """Yield every change of a statement or its domain, with a function that evaluates the mutant."""
    for change, mutant in changed(statement):
        yield change, partial(evaluated, partial(is_true, entry, mutant))
    for change, other in domains(entry):
        yield change, partial(evaluated, partial(is_true_exactly_inside, other, statement))


def evaluated(survives: Callable[[], bool]) -> Verdict:
    """Return the verdict on a mutant; a mutant whose operands lack an operation says nothing."""
    try:
        return Verdict(SURVIVED) if survives() else Verdict(KILLED, "execution")
    except UNCOMBINABLE:
        return Verdict(EQUIVALENT)


def tried(entry: Entry, statement: Term) -> Iterator[tuple[bool, bool | None, bool]]:
    """Yield whether each point satisfies the condition, the truth there, and whether two symbols are special."""
    entry = replace(entry, readings=(Reading(statement),)).meant
    claim = Claim(entry, entry.readings[0].statement)
    probe = Probe(claim)
    for place in chain(probe.first(), probe.zeros()):
        with suppress(BlurredError):
            inside = entry.condition is None or bool(claim.truth(place, entry.condition))
            yield inside, claim.truth(place), place.pair


def is_true(entry: Entry, statement: Term) -> bool:
    """Return whether a statement is true at every point that satisfies the entry's condition."""
    return all(truth is True for inside, truth, _ in tried(entry, statement) if inside)


def is_true_exactly_inside(entry: Entry, statement: Term) -> bool:
    """Return whether a statement is true inside the condition and, unless two symbols are special, false outside."""
    inner = outer = 0
    for inside, truth, pair in tried(entry, statement):
        if inside or not pair:
            if (truth is True) is not inside:
                return False
            inner += inside
            outer += not inside
    return bool(inner and (outer or entry.condition is None))


def domains(entry: Entry) -> Iterator[tuple[str, Entry]]:
    """Yield copies of the entry whose condition or claimed domain is changed or dropped."""
    for name, title in (("condition", "condition"), ("claimed", "claimed domain")):
        domain = getattr(entry, name)
        if domain is not None:
            others = {f"{title}: {change}": mutant for change, mutant in changed(domain) if mutant != negated(domain)}
            every = {f"{title} dropped": None, f"{title}: negated": negated(domain), **others}
            for change, mutant in every.items():
                yield change, replace(entry, **{name: mutant})


def changed(statement: Term) -> Iterator[tuple[str, Term]]:
    """Yield each mutant once, after a description of its change."""
    seen = {statement}
    for change, mutant in _mutants(statement):
        if mutant not in seen:
            seen.add(mutant)
            yield change, mutant


def _mutants(node: Term) -> Iterator[tuple[str, Term]]:
    if isinstance(node, Number):
        yield f"{node.value} raised by 1", Number(node.value + 1)
    if not isinstance(node, Apply):
        return
    yield from _other_operators(node)
    arguments = node.arguments
    for i, argument in enumerate(arguments):
        for change, mutant in _mutants(argument):
            yield change, node.operator(*arguments[:i], mutant, *arguments[i + 1 :])


def _other_operators(node: Apply) -> Iterator[tuple[str, Term]]:
    """Yield the mutants in which only the outermost operator is changed."""
    operator, arguments = node.operator, node.arguments
    name = operator.name.partition(" as ")[0]
    if name in REPLACED:
        yield f"{name} made {REPLACED[name]}", Apply(REPLACED[name], *arguments)
    if name in SWAPPED:
        yield f"arguments of {name} swapped", operator(*reversed(arguments))
    if name in DROPPED and name not in ("Re", "Du"):
        yield f"{name} dropped" if len(arguments) == 1 else f"second part of {name} dropped", arguments[0]
    if name in ("plus", "times", "implies"):
        yield f"first part of {name} dropped", arguments[1]
    if name == "minus":
        yield "first part of minus dropped", -arguments[1]
    if name == "implies":
        yield f"second part of {name} negated", operator(arguments[0], negated(arguments[1]))
    if operator.level == RELATION and name not in ("equal", "negated") and len(arguments) > 0:
        yield f"{name} negated", negated(node)
