"""Page of theorems: claims, premises, multipliers, methods and numbers of controls."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from ..proof.certificate import certificate
from ..proof.identity import ALL_ORDERS, Proof
from .coq import in_coq
from .coverage import COVERAGE

HEAD = """# Theorems

This page lists what is proved and from what. A theorem is an identity for every order n or every φ, and the formulas
of the kernels are its instances. An entry states the claim with its numbers in CP23 (Condurache and Popa 2023),
premises and method. A control is the theorem with one error in its claim, a premise or a multiplier; every control
failed, as it must. The last two tables tell who proves a theorem, and on which theorems each kernel function rests.

`[p_n](n -> 1 + n)` is p_n at the order n + 1. A residue is the difference of two sides as a polynomial; all of them
are 0. A multiplier is a denominator that was multiplied out; it is proved not to be a zero divisor.

Written by `make proofs`; do not edit.
"""

AT_ORDER = """## At one order

Two further kinds of statements are decided at each order, here shown for {scope}. The formulas of that order are
instances of the theorems. Independently, they follow from the definition, component by component.
"""

COVERED = """## Kernel functions

| function | validated | theorems | validated only |
| --- | --- | --- | --- |"""

BY = """## Who proves what

The toolkit proves every statement with its own prover. A certificate holds the polynomials of a proof, which
`tools/check_certificates.py` checks without the toolkit (`dualcay verify --certificates FILE`). Coq shares nothing
with it; it proves the theorems of `proofs/` over any commutative ring and for every n (`make machine-proofs`).

| theorem | by the toolkit | by certificate | by Coq, for every n | not covered by Coq |
| --- | --- | --- | --- | --- |"""


def page(general: Iterable[Proof], at_order: Iterable[Proof], controls: Mapping[str, int]) -> str:
    """Return the page as Markdown, from the proofs for all orders and at one order.

    The mapping `controls` gives the number of controls by the `title` of a proof.
    """
    general, again = tuple(general), tuple(at_order)
    lines = [HEAD, "## For every order\n", *(line for proof in general for line in _section(proof, controls))]
    lines += [AT_ORDER.format(scope=again[0].scope), *(line for proof in again for line in _section(proof, controls))]
    known = {proof.name: proof for proof in general}
    lines += [BY, *(_row(proof, known) for proof in (*general, *again)), "", COVERED]
    for name, covered in COVERAGE.items():
        theorems = ", ".join(covered.theorems)
        lines.append(f"| `{name}` | {covered.validation} | {theorems} | {covered.only_validated} |")
    return "\n".join([*lines, ""])


def title(proof: Proof) -> str:
    """Return the title of a proof: its name and scope."""
    return proof.name if proof.scope == ALL_ORDERS else f"{proof.name} [{proof.scope}]"


def _row(proof: Proof, known: Mapping[str, Proof]) -> str:
    """Return the row of a proof; a statement without certificate gives the reason."""
    entry, written = in_coq(proof), certificate(proof, known)
    cells = (
        proof.name, proof.scope, f"no: {written.partition('; ')[0]}" if isinstance(written, str) else "yes",
        ", ".join(f"`{name}`" for name in entry.theorems), entry.left_out,
    )  # fmt: skip
    return f"| {' | '.join(cells)} |"


def _section(proof: Proof, controls: Mapping[str, int]) -> Iterator[str]:
    yield f"### {title(proof)}\n"
    for equation in proof.claim:
        numbers = ", ".join(f"({number})" for number in equation.numbers)
        yield f"- $`{equation.latex}`${f' — CP23 {numbers}' if numbers else ''}"
    yield from (f"- given `{premise}`" for premise in proof.premises)
    yield from (f"- where `{condition}`, by the theorems cited" for condition in proof.conditions)
    yield from (f"- multiplied by `{factor}`, zero where `{factor.text} = 0`" for factor in proof.multipliers)
    yield f"- by {proof.method}; residues: {len(proof.residues)}"
    yield f"- controls: {controls[title(proof)]}\n"
