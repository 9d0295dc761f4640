"""The page of theorems: claims, premises, multipliers, methods and numbers of controls."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from itertools import starmap

from .coverage import COVERAGE, Coverage
from .identity import ALL_ORDERS, Proof

Counts = Mapping[str, int]
"""Numbers of controls by title of the statement."""

HEAD = """# Theorems

Written by `make proofs`; do not edit.

Each theorem lists its claim, its premises, the factors by which differences were multiplied, and its method. Numbers
are those of equations in CP23. A control is the theorem with one error in its claim, a premise or a multiplier. Every
control was decided, and failed as it must.
"""

AT_ORDER = """## At one order

Two further kinds of statements are decided at each order, here shown for {scope}. The formulas of that order are
instances of the theorems. Independently, they follow from the definition, component by component.
"""

COVERED = """## Kernel functions

| function | validated | theorems | validated only |
| --- | --- | --- | --- |"""


def page(general: Iterable[Proof], at_order: Iterable[Proof], controls: Counts) -> str:
    """Return the page as Markdown.

    Parameters
    ----------
    general : iterable of Proof
        Proofs of theorems for all orders.
    at_order : iterable of Proof
        Proofs at one order.
    controls : mapping of str to int
        Numbers of controls by `title`.
    """
    again = tuple(at_order)
    parts = [HEAD, "## For every order\n", *(_section(proof, controls) for proof in general)]
    parts += [AT_ORDER.format(scope=again[0].scope), *(_section(proof, controls) for proof in again)]
    return "\n".join([*parts, COVERED, *starmap(_row, COVERAGE.items()), ""])


def title(proof: Proof) -> str:
    """Return the title of a proof: its name and scope."""
    return proof.name if proof.scope == ALL_ORDERS else f"{proof.name} [{proof.scope}]"


def counts(text: str) -> dict[str, int]:
    """Read the numbers of controls from a page, by title."""
    return {name: int(count) for name, count in re.findall(r"^### (.+)\n\n(?:.+\n)*?- controls: (\d+)$", text, re.M)}


def _row(function: str, covered: Coverage) -> str:
    return f"| `{function}` | {covered.validation} | {', '.join(covered.theorems)} | {covered.only_validated} |"


def _section(proof: Proof, controls: Counts) -> str:
    return "\n".join([f"### {title(proof)}\n", *_lines(proof), f"- controls: {controls[title(proof)]}\n"])


def _lines(proof: Proof) -> Iterator[str]:
    for equation in proof.claim:
        numbers = ", ".join(f"({number})" for number in equation.numbers)
        yield f"- $`{equation.latex}`${f' — CP23 {numbers}' if numbers else ''}"
    yield from (f"- given `{premise}`" for premise in proof.premises)
    yield from (f"- where `{condition}`, by the theorems cited" for condition in proof.conditions)
    yield from (f"- multiplied by `{factor}`, zero where `{factor.vanishes}`" for factor in proof.multipliers)
    yield f"- by {proof.method}; residues: {len(proof.residues)}"
