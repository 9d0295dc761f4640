"""Claims that differ from a claim in one step: a sign, an inverse, a transpose, a factor, an order of operands."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from .language.printed import OPERATORS, Apply, Number, Symbol, Term

Change = tuple[int, str, Term]
"""Rank (simplest first), words, and the changed claim."""
SWAPPED = {"cross": "cross product", "times": "product", "dyad": "dyadic product", "over": "quotient", "atan2": "arguments"}
SIGNED = ("plus", "minus")


def changes(claim: Term, named: Callable[[Term], str]) -> list[Change]:
    """Return the claims that differ from a claim in one step, simplest first; `named` prints a term."""
    found: dict[Term, Change] = {}
    for rank, words, changed in _changed(claim, named):
        if changed != claim:
            found.setdefault(changed, (rank, words, changed))
    return sorted(found.values(), key=lambda change: change[0])


def signs_and_coefficients(claim: Term, named: Callable[[Term], str]) -> Iterator[tuple[str, Term]]:
    """Yield the claims with one sign or one integer changed, each with the words for the term."""
    for node, rebuilt in _places(claim):
        name, arguments = node.operator.name, node.arguments
        if name in SIGNED:
            other = SIGNED[name == "plus"]
            yield f"sign of {named(arguments[1])}", rebuilt(Apply(other, *arguments))
        elif name == "negative":
            yield f"sign of {named(arguments[0])}", rebuilt(arguments[0])
        elif name in ("times", "over"):
            for i, argument in enumerate(arguments):
                if isinstance(argument, Number) and argument.value:
                    changed = [*arguments[:i], Number(argument.value + 1), *arguments[i + 1 :]]
                    yield f"coefficient {argument.value} of {named(node)}", rebuilt(Apply(name, *changed))


def _places(node: Term, rebuilt: Callable[[Term], Term] = lambda new: new) -> Iterator[tuple[Term, Callable[[Term], Term]]]:
    """Yield each part of a term, with the function that puts another part in its place."""
    yield node, rebuilt
    for i, argument in enumerate(node.arguments):

        def replaced(new: Term, i: int = i) -> Term:
            return rebuilt(Apply(node.operator.name, *node.arguments[:i], new, *node.arguments[i + 1 :]))

        yield from _places(argument, replaced)


def _changed(claim: Term, named: Callable[[Term], str]) -> Iterator[Change]:
    for node, rebuilt in _places(claim):
        for rank, words, new in _steps(node, named, node is claim):
            yield rank, words, rebuilt(new)


def _steps(node: Term, named: Callable[[Term], str], whole: bool) -> Iterator[Change]:
    """Yield the changes of one part."""
    name, arguments, shown = node.operator.name, node.arguments, named(node)
    if name in SIGNED:
        yield 0, f"sign of {named(arguments[1])}", Apply(SIGNED[name == "plus"], *arguments)
        yield 1, f"sign of {named(arguments[0])}", Apply(name, -arguments[0], arguments[1])
    if name == "negative":
        yield 0, f"sign of {named(arguments[0])}", arguments[0]
    if name in SWAPPED:
        yield 2, f"{SWAPPED[name]} swapped in {shown}", Apply(name, *reversed(arguments))
    if name in ("transpose", "inverse", "conjugate"):
        yield 1, f"without {name} of {named(arguments[0])}", arguments[0]
    yield from _moved(node, shown)
    if whole or name in ("equal", "both", "implies", "less", "at most") or isinstance(node, Number):
        if isinstance(node, Number) and node.value > 1:
            for value in {node.value * 2, node.value - 1, node.value + 1, *([node.value // 2] if node.value % 2 == 0 else [])}:
                yield 3, f"{value} for {node.value}", Number(value)
        return
    for rank, words, form in _WRAPPED:
        yield rank + (name not in ("call", "at") and not isinstance(node, Symbol)), f"{words} {shown}", form(node)


def _apply(name: str) -> Callable[[Term], Term]:
    return lambda a: Apply(name, a)


_WRAPPED: tuple[tuple[int, str, Callable[[Term], Term]], ...] = (
    (1, "sign of", lambda a: -a), (2, "transpose of", _apply("transpose")), (2, "inverse of", lambda a: inverse(a)),
    (2, "conjugate of", _apply("conjugate")), (3, "factor 1/2 at", lambda a: a / 2), (3, "factor 2 at", lambda a: 2 * a),
    (3, "square of", lambda a: a**2),
)  # fmt: skip


def inverse(a: Term) -> Term:
    """Return the term of an inverse."""
    return Apply("inverse", a) if "inverse" in OPERATORS else a ** (-1)


def _moved(node: Term, shown: str) -> Iterator[Change]:
    """Yield a term with a bracket moved: (a + b) c for a + b c, and back."""
    name, arguments = node.operator.name, node.arguments
    if name not in ("times", "over", *SIGNED):
        return
    a, b = arguments
    words = f"bracket moved in {shown}"
    pairs: list[Any] = []
    if name in SIGNED and b.operator.name in ("times", "over"):
        pairs.append(Apply(b.operator.name, Apply(name, a, b.arguments[0]), b.arguments[1]))
    if name in SIGNED and a.operator.name in ("times",):
        pairs.append(Apply("times", a.arguments[0], Apply(name, a.arguments[1], b)))
    if name in ("times", "over") and a.operator.name in SIGNED:
        pairs.append(Apply(a.operator.name, a.arguments[0], Apply(name, a.arguments[1], b)))
    if name == "times" and b.operator.name in SIGNED:
        pairs.append(Apply(b.operator.name, Apply("times", a, b.arguments[0]), b.arguments[1]))
    if name in SIGNED and b.operator.name in SIGNED:
        pairs.append(Apply(b.operator.name, Apply(name, a, b.arguments[0]), b.arguments[1]))
    for pair in pairs:
        yield 4, words, pair
