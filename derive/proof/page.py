"""The page of theorems: what is proved, from what, multiplied by what, and how many controls each statement has."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from itertools import starmap

from .coverage import COVERAGE, Coverage
from .identity import ALL_ORDERS, Proof

Counts = Mapping[str, int]
"""How many controls statements have, by their titles."""

HEAD = """# Theorems

Written by `make proofs`: change that, not this page.

Everything that is decided, from what is given and nothing else; numbers are those of the equations in CP23. A control
is the statement, a premise or a multiplier with one thing wrong: every one was seen to fail.
"""

AT_ORDER = """## At one order

What is decided again for each order, shown for {scope}: that the formulas are instances of the theorems, and, on a road
of its own, by components.
"""

COVERED = """## Kernel functions

| function | validated | theorems | validated only |
| --- | --- | --- | --- |"""


def page(general: Iterable[Proof], at_order: Iterable[Proof], controls: Counts) -> str:
    """All of it as Markdown.

    Parameters
    ----------
    general : iterable of Proof
        What is proved once.
    at_order : iterable of Proof
        What is decided for one order.
    controls : mapping of str to int
        By `title`.
    """
    again = tuple(at_order)
    parts = [HEAD, "## For every order\n", *(_section(proof, controls) for proof in general)]
    parts += [AT_ORDER.format(scope=again[0].scope), *(_section(proof, controls) for proof in again)]
    return "\n".join([*parts, COVERED, *starmap(_row, COVERAGE.items()), ""])


def title(proof: Proof) -> str:
    """Name and scope."""
    return proof.name if proof.scope == ALL_ORDERS else f"{proof.name} [{proof.scope}]"


def counts(text: str) -> dict[str, int]:
    """The numbers of controls that a page gives, by title."""
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
    yield from (f"- where `{condition}`, as theorems given suppose" for condition in proof.conditions)
    yield from (f"- multiplied by `{factor}`, zero where `{factor.vanishes}`" for factor in proof.multipliers)
    yield f"- by {proof.method}; residues: {len(proof.residues)}"
