"""Page of theorems: what is proved by whom, then for each theorem its premises, multipliers, method and controls."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain

from derive.output.pages import json_rows
from derive.pages.explain import ROWS
from derive.pages.sheet import CLOSED, EVERY_PHI, MAPS_OF_ORDER, MOTION_OF_ORDER
from derive.proof.identity import Premise, Proof
from derive.proof.notation import latex
from derive.proof.spline_theorems import SPLINES

from .coq import in_coq

HEAD = """# Theorems

A theorem is an identity for every order n, for every φ or for splines with any knots; the formulas of the kernels are
its instances. The toolkit proves each one. Coq shares nothing with the toolkit; it proves the theorems of `proofs/`
over any commutative ring and for every n (`make machine-proofs`). The groups are those of the
[formula sheet](sheet.md). An entry below has premises and method, and what Coq leaves out. Numbers are those of
equations in CP23 (Condurache and Popa 2023). [Its facts](theorems.json) are there as JSON, too.
"""

ENTRIES = """## For every order

In an entry, $`\\left[p_{n}\\right]_{n \\to 1 + n}`$ is $`p_{n+1}`$. A residue is the difference of two sides as a
polynomial; all of them are 0. A multiplier is a denominator that was multiplied out; it is proved not to be a zero
divisor. A control is the theorem with one error in its claim, a premise or a multiplier; every control failed, as it
must.

`make proofs` writes this page.
"""

AT_ORDER = """## At one order

Two further kinds of statements are decided at each order, here shown for {scope}. The formulas of that order are
instances of the theorems. Independently, they follow from the definition, component by component.
"""

COVERED = """## Kernel functions

| functions | validated | theorems | validated only |
| --- | --- | --- | --- |"""

TABLE = """| theorem | formula | Coq | functions that rest on it |
| --- | --- | --- | --- |"""

GROUPS = {
    "Order n: maps and twists": chain(*MAPS_OF_ORDER.values()),
    "Order n: Jacobians, transition, switching": chain(*MOTION_OF_ORDER.values()),
    "Orders 1 and 2": chain(*CLOSED.values()),
    "Every v = φ(α) u": chain(*EVERY_PHI.values()),
}
THEOREMS = {
    **{heading: tuple(dict.fromkeys(name for name, *_ in wanted)) for heading, wanted in GROUPS.items()},
    "Splines": tuple(theorem.name for theorem in SPLINES),
}
"""Names of theorems by the headings of the formula sheet, and those on splines."""

FUNCTIONS = {
    theorem: ", ".join(f"`{name}`" for names, covered in ROWS.items() if theorem in covered.theorems for name in names)
    for theorem in chain(*(covered.theorems for covered in ROWS.values()))
}
"""Kernel functions by theorem."""


def page(general: Iterable[Proof], at_order: Iterable[Proof], controls: Mapping[str, int]) -> str:
    """Return the page as Markdown, from the proofs for all orders and at one order.

    The mapping `controls` gives the number of controls by the title of a proof.
    """
    general, again = tuple(general), tuple(at_order)
    known = {proof.name: proof for proof in general}
    shown = {*chain(*THEOREMS.values())}
    groups = {**THEOREMS, "Behind these": tuple(name for name in known if name not in shown)}
    lines = [HEAD]
    for heading, names in groups.items():
        lines += [f"## {heading}\n", TABLE, *(_row(known[name]) for name in names if name in known), ""]
    lines += [ENTRIES, *(line for proof in general for line in _entry(proof, controls))]
    lines += [AT_ORDER.format(scope=again[0].scope)]
    lines += [*(line for proof in again for line in _entry(proof, controls)), COVERED]
    for functions, covered in ROWS.items():
        named, theorems = ", ".join(f"`{name}`" for name in functions), ", ".join(covered.theorems)
        lines.append(f"| {named} | {covered.validation} | {theorems} | {covered.only_validated} |")
    return "\n".join([*lines, ""])


def as_json(general: Sequence[Proof], controls: Mapping[str, int]) -> str:
    """Return the facts about the theorems as JSON."""
    rows = [
        {
            "name": proof.name, "id": anchor(proof), "scope": proof.scope, "status": proof.status,
            "claim": [{"latex": equation.latex, "equations": list(equation.numbers)} for equation in proof.claim],
            "premises": [premise.equation.latex for premise in proof.premises],
            "conditions": [condition.latex for condition in proof.conditions], "method": proof.method,
            "residues": len(proof.residues),
            "coq": list(in_coq(proof).theorems), "controls": controls[proof.title],
            "functions": FUNCTIONS.get(proof.name, "").replace("`", "").split(", ") if proof.name in FUNCTIONS else [],
        }
        for proof in general
    ]  # fmt: skip
    return json_rows(schema=1, theorems=rows)


def anchor(proof: Proof) -> str:
    """Return the anchor of a proof's entry, made from its title as those of headings are."""
    return re.sub(r"[^\w -]", "", proof.title.lower()).replace(" ", "-")


def _row(proof: Proof) -> str:
    """Return the row of a theorem; what does not prove it leaves its cell empty."""
    formulas = "<br>".join(f"$`{equation.latex}`$" for equation in proof.claim).replace("|", r"\vert ")
    cells = (
        f"[{proof.name}](#{anchor(proof)})", formulas, "yes" * bool(in_coq(proof).theorems),
        FUNCTIONS.get(proof.name, ""),
    )  # fmt: skip
    return f"| {' | '.join(cells)} |"


def _entry(proof: Proof, controls: Mapping[str, int]) -> Iterator[str]:
    """Yield the lines of a folded entry."""
    yield f'<details><summary><b>{proof.title}</b></summary>\n\n<a id="{anchor(proof)}"></a>'
    for equation in proof.claim:
        numbers = ", ".join(f"({number})" for number in equation.numbers)
        yield f"- $`{equation.latex}`${f' — CP23 {numbers}' if numbers else ''}"
    yield from (f"- given $`{premise.equation.latex}`${_source(premise)}" for premise in proof.premises)
    yield from (f"- where $`{condition.latex}`$, by the theorems cited" for condition in proof.conditions)
    for factor in proof.multipliers:
        base, power = latex(factor.expression), "" if factor.power == 1 else f" to the power {factor.power}"
        yield f"- multiplied by $`{base}`${power}, zero where $`{base} = 0`$"
    yield f"- by {proof.method}; residues: {len(proof.residues)}"
    entry = in_coq(proof)
    if entry.theorems:
        yield f"- in Coq: {', '.join(f'`{name}`' for name in entry.theorems)}"
    if entry.left_out:
        yield f"- not covered by Coq: {entry.left_out}"
    yield f"- controls: {controls[proof.title]}\n\n</details>\n"


def _source(premise: Premise) -> str:
    """Return where a premise comes from, nothing for a definition."""
    at = ", ".join(f"$`{latex(old)} \\to {latex(new)}`$" for old, new in premise.instance)
    return f", theorem “{premise.theorem}”{f' at {at}' if at else ''}" if premise.theorem else ""
