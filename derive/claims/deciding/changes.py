"""Claims that differ from a claim in one step: a sign, an inverse, a transpose, a factor, an order of operands."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import islice
from typing import Any

from ..language.calculus import BINDERS
from ..language.matrices import inverse
from ..language.operations import written
from ..language.operator_table import conjugate, transpose
from ..language.printed import Apply, Number, Symbol, Term, symbols
from ..numbers.balls import BlurredError
from .claim import Claim, kind
from .place import Place
from .places import Probe

Change = tuple[int, str, str, Term]
"""Rank (simplest first), sort, words, and the changed claim or part."""
SWAPPED = {"cross": "cross product", "times": "product", "dyad": "dyadic product", "over": "quotient",
           "atan2 of two": "arguments"}  # fmt: skip
CANDIDATES_MAX = 400
"""Largest number of changes that are tried."""
SIGNED = ("plus", "minus")
RELATIONS = ("equal", "both", "implies", "less", "at most", "greater", "at least", "unlike", "negated", "or")


def changes(claim: Term) -> list[Change]:
    """Return the claims that differ from a claim in one step, simplest first."""
    quaternions = any("quaternion" in symbol.quantity.name for symbol in symbols(claim))
    found: dict[Term, Change] = {}
    for node, rebuilt, depth in _places(claim):
        for rank, sort, words, new in _steps(node, depth):
            changed = rebuilt(new)
            trivial = len(set(changed.arguments)) < 2 or changed == claim
            if not trivial and (quaternions or sort != "conjugate"):
                found.setdefault(changed, (rank, sort, words, changed))
    return sorted(found.values(), key=lambda change: change[0])


def signs_and_coefficients(claim: Term) -> Iterator[tuple[str, Term]]:
    """Yield the claims with one sign or one integer changed, each with the words for the term."""
    for node, rebuilt, _ in _places(claim):
        name, arguments = node.operator.name, node.arguments
        if name in SIGNED:
            other = SIGNED[name == "plus"]
            yield f"sign of {written(arguments[1])}", rebuilt(Apply(other, *arguments))
        elif name == "negative":
            yield f"sign of {written(arguments[0])}", rebuilt(arguments[0])
        elif name in ("times", "over"):
            for i, argument in enumerate(arguments):
                if isinstance(argument, Number) and argument.value:
                    changed = [*arguments[:i], Number(argument.value + 1), *arguments[i + 1 :]]
                    yield f"coefficient {argument.value} of {written(node)}", rebuilt(Apply(name, *changed))


def _places(
    node: Term, rebuilt: Callable[[Term], Term] = lambda new: new, depth: int = 0
) -> Iterator[tuple[Term, Callable[[Term], Term], int]]:
    """Yield each part of a term, the function that puts another part in its place, and its depth below a relation."""
    yield node, rebuilt, depth
    for i, argument in enumerate(node.arguments):
        named = isinstance(argument, Symbol) and argument.quantity.name == "function"
        if named or BINDERS.get(node.operator.name) == i:
            continue  # the name of a definition, or a bound letter

        def replaced(new: Term, i: int = i) -> Term:
            return rebuilt(Apply(node.operator.name, *node.arguments[:i], new, *node.arguments[i + 1 :]))

        yield from _places(argument, replaced, depth + (node.operator.name not in RELATIONS))


def _steps(node: Term, depth: int) -> Iterator[Change]:
    """Yield the changes of one part; those of letters and of whole sides rank before those of other parts."""
    name, arguments, shown = node.operator.name, node.arguments, written(node)
    if name in SIGNED:
        yield 0, "sign", f"sign of {written(arguments[1])}", Apply(SIGNED[name == "plus"], *arguments)
        yield 1, "sign", f"sign of {written(arguments[0])}", Apply(name, -arguments[0], arguments[1])
    if name == "negative":
        yield 0, "sign", f"sign of {written(arguments[0])}", arguments[0]
    if name in SWAPPED:
        yield 2, "swapped", f"{SWAPPED[name]} swapped in {shown}", Apply(name, *reversed(arguments))
    if name in ("transpose", "inverse", "conjugate"):
        yield 1, name, f"no {name} of {written(arguments[0])}", arguments[0]
    for pair in _moved(node):
        yield 4, "bracket", f"bracket moved in {shown}", pair
    if isinstance(node, Number):
        n = node.value
        for value in dict.fromkeys((2 * n, *([n // 2] if n % 2 == 0 else []), n + 1, n - 1)) if n > 0 else ():
            if not value:
                continue
            yield 1, "factor", f"{value} for {n}", Number(value)
    elif name not in RELATIONS:
        rank = 1 if depth == 0 or isinstance(node, Symbol) or name.startswith("call") else 2
        for later, sort, words, form in _WRAPPED:
            if sort != name:  # its absence is another change
                yield rank + later, sort, f"{words} {shown}", form(node)


_WRAPPED: tuple[tuple[int, str, str, Callable[[Term], Any]], ...] = (
    (0, "sign", "sign of", lambda a: -a), (1, "transpose", "transpose of", transpose),
    (1, "inverse", "inverse of", inverse), (1, "conjugate", "conjugate of", conjugate),
    (1, "factor", "factor 1/2 at", lambda a: a / 2), (1, "factor", "factor 2 at", lambda a: 2 * a),
    (2, "square", "square of", lambda a: a**2),
)  # fmt: skip


def _moved(node: Term) -> Iterator[Term]:
    """Yield a term with a bracket moved: (a + b) c for a + b c, and back."""
    name, arguments = node.operator.name, node.arguments
    if name not in ("times", "over", *SIGNED):
        return
    a, b = arguments
    if name in SIGNED and b.operator.name in ("times", "over", *SIGNED):
        yield Apply(b.operator.name, Apply(name, a, b.arguments[0]), b.arguments[1])
    if name in SIGNED and a.operator.name == "times":
        yield Apply("times", a.arguments[0], Apply(name, a.arguments[1], b))
    if name in ("times", "over") and a.operator.name in SIGNED:
        yield Apply(a.operator.name, a.arguments[0], Apply(name, a.arguments[1], b))
    if name == "times" and b.operator.name in SIGNED:
        yield Apply(b.operator.name, Apply("times", a, b.arguments[0]), b.arguments[1])


CHANGES_MAX, SAMPLE = 3, 6
"""Changes shown, and points at which a changed claim is tried first."""


def true_at(claim: Claim, found: Sequence[Place], least: int = 1) -> bool:
    """Return whether a claim is false at no point, and true at so many."""
    true = 0
    for place in found:
        try:
            truth = claim.truth(place)
        except BlurredError:
            continue
        except (TypeError, AttributeError, ValueError, LookupError, ArithmeticError):
            return False
        if truth is False:
            return False
        true += truth is True
    return true >= least


def mended(claim: Claim, failing: Place | None, holds: Callable[[Claim], bool]) -> Iterator[str]:
    """Yield the changes in one step that make a false claim true."""
    sample = list(islice(Probe(claim).quick(), SAMPLE))
    first = [failing] if failing else []
    shown: set[str] = set()  # one change of each sort, since changes of one sort are often equivalent
    for _, sort, words, changed in changes(claim.entry.written or claim.statement)[:CANDIDATES_MAX]:
        other = claim.with_statement(claim.entry.expanded(changed))
        wanted = sort not in shown and len(shown) < CHANGES_MAX
        if wanted and true_at(other, [*first, *sample]) and holds(other):
            shown.add(sort)
            yield f"{words}: {written(changed)}"


def vacuous(claim: Claim, true: Sequence[Place]) -> Iterator[str]:
    """Yield the terms of a true claim whose sign or coefficient does not matter, each with the claim so changed."""
    for words, changed in signs_and_coefficients(claim.entry.written or claim.statement):
        if true_at(claim.with_statement(claim.entry.expanded(changed)), true, (len(true) + 1) // 2):
            yield f"{words}: {written(changed)}"


def needed(claim: Claim) -> Iterator[str]:
    """Yield the constraints of letters and of the domain without which a true claim is false."""
    for letter in claim.coordinates:
        row = kind(letter)
        if row.free and row.needs:
            name = f"constant {row.free}" if row.constant else row.free
            free = {letter: Symbol(letter.name, name, *map(str, letter.args[2:]))}
            claimed = None if claim.entry.claimed is None else claim.entry.claimed.xreplace(free)
            entry = replace(claim.entry, claimed=claimed)
            other = replace(claim, entry=entry, statement=claim.statement.xreplace(free))
            if not true_at(other, list(Probe(other).quick())):
                yield row.needs.format(letter.name)
    for constraint in claim.constraints:
        other = replace(claim, entry=replace(claim.entry, claimed=None))
        if not true_at(other, list(Probe(other).quick())):
            yield written(constraint)
