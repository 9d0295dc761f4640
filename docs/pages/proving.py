"""``python -m docs.pages.proving``: prove everything and run all controls.

The exit code is 1 if a proof fails, if a control does not fail, or, with ``--check``, if the page of theorems is stale.
It is 3 if the page cannot be written.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Sequence
from itertools import chain
from pathlib import Path

from derive.maps import Cayley
from derive.output import pages
from derive.output.shown import bar
from derive.proof.displacement_theorems import CLOSED_AT
from derive.proof.identity import ALL_ORDERS, Proof
from derive.proof.methods import decided
from derive.proof.proved import CLAIMS, proofs

from .controls import Control, controls, controls_at, controls_of
from .theorems import as_json, page

ORDERS = (1, 2, 3, 4, 5)
"""Orders of the proofs and controls at single orders: even and odd orders, with and without poles."""

SHOWN = 3
"""Order whose proofs the page shows."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Prove everything and run the controls, print failures and counts, and write or compare the page of theorems."""
    parser = argparse.ArgumentParser(prog="python -m docs.pages.proving", description=main.__doc__)
    parser.add_argument("-o", "--output", type=Path, help="page of theorems to write, with JSON beside it")
    parser.add_argument("--check", action="store_true", help="compare both instead")
    options = parser.parse_args(arguments)
    if not options.check and not pages.writable(options.output):
        return 3
    with bar(2 + 2 * len(ORDERS)) as step:
        step("theorems")
        general = decided(CLAIMS)
        again = {}
        for n in ORDERS:
            step(f"proofs at n = {n}")
            again[n] = at_order(n)
        step("controls of theorems")
        altered = [*controls(CLAIMS, {proof.name: proof for proof in general})]
        for n in ORDERS:
            step(f"controls at n = {n}")
            altered += controlled_at(n)
    proved = (*general, *(proof for found in again.values() for proof in found))
    wrong = [proof for proof in proved if not proof.proved]
    missed = [control for control in altered if not control.noticed]
    print(f"{len(proved)} statements, {len(wrong)} not proved; {len(altered)} controls, {len(missed)} not noticed")
    scopes, count = Counter(proof.scope for proof in general), Counter(control.proof.title for control in altered)
    kinds = ", ".join(f"{number} for {scope}" for scope, number in scopes.items())
    print(f"{len(general)} theorems, {kinds}; {sum(count[proof.title] for proof in general)} controls of theorems")
    for line in (*map(str, wrong), *map(str, missed)):
        print(line, file=sys.stderr)
    if wrong or missed:
        return 1
    if options.output is None:
        return 0
    texts = pages.beside(options.output, page(general, again[SHOWN], count), as_json(general, count))
    return pages.deliver(options.output, texts, options.check, "docs.pages.proving")


def at_order(n: int) -> tuple[Proof, ...]:
    """Return the proofs at order n, without the theorems of `CLAIMS`."""
    once = {theorem.name for theorem in chain(*CLOSED_AT.values())}
    return tuple(proof for proof in proofs(Cayley(n)) if proof.scope != ALL_ORDERS and proof.name not in once)


def controlled_at(n: int) -> tuple[Control, ...]:
    """Return all controls at an order."""
    return (*controls_at(Cayley(n)), *controls_of(Cayley(n)))


if __name__ == "__main__":
    sys.exit(main())
