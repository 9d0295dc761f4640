"""Mutants of a statement or domain: one operator, integer or claim is changed. Evaluation must refute them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

from .decide import ORDERS
from .equation import Equation
from .explore import explore
from .language.notation import negated
from .language.terms import RELATION, Apply, Number, Symbol, Term, text
from .numbers.quantities import PROPOSITION
from .result import Result

UNCOMBINABLE = (TypeError, AttributeError, ValueError, KeyError, IndexError)
"""Exceptions raised by operands that lack an operation."""

REPLACED = {
    "plus": "minus", "minus": "plus", "Re": "Du", "Du": "Re", "sin": "cos", "cos": "sin", "tan": "cot", "cot": "tan",
    "sin²": "cos²", "cos²": "sin²", "tan²": "sin²", "K10 Sin": "K10 Cos", "K10 Cos": "K10 Sin", "K10 Tan": "cot",
    "K10 Tan2": "K10 Tan3", "K10 Tan3": "K10 Tan2", "K10 sum over i and j": "K10 sum over i ≤ j",
    "K10 sum over i ≤ j": "K10 sum over i < j", "K10 sum over i < j": "K10 sum over i and j",
}
"""Replacement for each operator, by name."""
SWAPPED = ("minus", "over", "power", "implies", "cross", "dyad", "atan2", "commutator", "K10 parts", "K10 column")
"""Operators whose arguments are swapped."""
DROPPED = (*REPLACED, "times", "negative", "root", "negated", "transpose", "conjugate", "arctan", "K10 power 1/2")
"""Operators that are dropped; only their first argument remains."""


@dataclass
class Score:
    """Numbers of refuted and meaningless mutants, and descriptions of the survivors."""

    killed: int = 0
    meaningless: int = 0
    survivors: list[str] = field(default_factory=list)


def true_statements(result: Result) -> tuple[Term, ...]:
    """Return the true readings; without one, return the correction."""
    true = tuple(verdict.statement for verdict in result.verdicts if verdict.true)
    return true or (() if result.equation.corrected is None else (result.equation.corrected,))


def trials(
    entry: Equation, statement: Term, orders: Sequence[int] = ORDERS
) -> Iterator[tuple[str, Callable[[], Score]]]:
    """Yield every change of a statement or its domain, with a function that evaluates the mutant."""
    for change, mutant in mutants(statement):
        yield change, partial(try_mutant, entry, mutant, orders)
    for change, changed in domains(entry):
        yield change, partial(try_domain, changed, change, statement, orders)


def try_mutant(entry: Equation, mutant: Term, orders: Sequence[int] = ORDERS) -> Score:
    """Evaluate a mutant of a statement; return its score."""
    try:
        alive = all(outcome.truth is True for outcome in explore(entry, mutant, orders) if outcome.inside)
    except UNCOMBINABLE:
        return Score(meaningless=1)
    return Score(survivors=[text(mutant)]) if alive else Score(killed=1)


def try_domain(changed: Equation, change: str, statement: Term, orders: Sequence[int] = ORDERS) -> Score:
    """Evaluate a statement on a changed domain; the mutant survives if the statement is true exactly inside it."""
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
    return Score(survivors=[change])


def domains(entry: Equation) -> Iterator[tuple[str, Equation]]:
    """Yield copies of the entry whose condition or claimed domain is changed or dropped."""
    for name, title in (("condition", "condition"), ("claimed", "claimed domain")):
        domain = getattr(entry, name)
        if domain is not None:
            others = {f"{title}: {change}": mutant for change, mutant in mutants(domain) if mutant != negated(domain)}
            changed: dict[str, Any] = {f"{title} dropped": None, f"{title}: negated": negated(domain), **others}
            for change, mutant in changed.items():
                yield change, replace(entry, **{name: mutant})


def mutants(statement: Term) -> Iterator[tuple[str, Term]]:
    """Yield each mutant once, after a description of its change."""
    seen = {statement}
    for change, mutant in _mutants(statement):
        if mutant not in seen:
            seen.add(mutant)
            yield change, mutant


def _mutants(node: Term) -> Iterator[tuple[str, Term]]:
    if isinstance(node, Number):
        yield f"{node.value} raised by 1", Number(node.value + 1)
    if isinstance(node, Symbol) and node.quantity is PROPOSITION:
        yield f"{node.name} negated", negated(node)
    if not isinstance(node, Apply):
        return
    yield from _changed(node)
    arguments = node.arguments
    for i, argument in enumerate(arguments):
        for change, mutant in _mutants(argument):
            yield change, node.operator(*arguments[:i], mutant, *arguments[i + 1 :])


def _changed(node: Apply) -> Iterator[tuple[str, Term]]:
    """Yield the mutants in which only the outermost operator is changed."""
    operator, arguments = node.operator, node.arguments
    name = operator.name
    if name in REPLACED:
        yield f"{name} made {REPLACED[name]}", Apply(REPLACED[name], *arguments)
    if name in SWAPPED:
        yield f"arguments of {name} swapped", operator(*reversed(arguments))
    if name in DROPPED and name not in ("Re", "Du") and not name.startswith("K10 sum"):
        yield f"{name} dropped" if len(arguments) == 1 else f"second part of {name} dropped", arguments[0]
    if name in ("plus", "times", "implies", "iff"):
        yield f"first part of {name} dropped", arguments[1]
    if name == "minus":
        yield "first part of minus dropped", -arguments[1]
    if name in ("implies", "iff"):
        yield f"second part of {name} negated", operator(arguments[0], negated(arguments[1]))
    if operator.level == RELATION and name not in ("equal", "negated") and len(arguments) > 0:
        yield f"{name} negated", negated(node)
