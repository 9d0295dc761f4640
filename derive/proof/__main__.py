"""``python -m derive.proof``: prove everything and run all controls.

The exit code is 1 if a proof fails, if a control does not fail, or, with ``--check``, if the page of theorems is stale.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Sequence
from itertools import chain
from pathlib import Path

from ..maps import Cayley
from ..output import files
from ..output.progress import bar
from ..pages.theorems import page
from .controls import Control, controls, controls_at, controls_of
from .displacement_theorems import CLOSED_AT
from .identity import ALL_ORDERS, Proof
from .proved import CLAIMS, proofs
from .theorem import decided

ORDERS = (1, 2, 3, 4, 5)
"""Orders of the proofs and controls at single orders: even and odd orders, with and without poles."""

SHOWN = 3
"""Order whose proofs the page shows."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Prove everything and run the controls, print failures and counts, and write or compare the page of theorems."""
    parser = argparse.ArgumentParser(prog="python -m derive.proof", description="Prove everything, see controls fail.")
    parser.add_argument("-o", "--output", type=Path, help="page of theorems to write")
    parser.add_argument("--check", action="store_true", help="compare the page instead")
    options = parser.parse_args(arguments)
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
    for line in (*map(str, wrong), *map(str, missed)):
        print(line, file=sys.stderr)
    if wrong or missed:
        return 1
    text = page(general, again[SHOWN], Counter(control.proof.title for control in altered))
    return _deliver(text, options.output, options.check)


def at_order(n: int) -> tuple[Proof, ...]:
    """Return the proofs at order n, without the theorems of `CLAIMS`."""
    once = {theorem.name for theorem in chain(*CLOSED_AT.values())}
    return tuple(proof for proof in proofs(Cayley(n)) if proof.scope != ALL_ORDERS and proof.name not in once)


def controlled_at(n: int) -> tuple[Control, ...]:
    """Return all controls at an order."""
    return (*controls_at(Cayley(n)), *controls_of(Cayley(n)))


def _deliver(text: str, output: Path | None, check: bool) -> int:
    if output and not check:
        files.write(output.parent, {output.name: text}, force=True)
    elif output and any(found.path == output for found in files.compare(output.parent, {output.name: text})):
        print(f"{output} is stale; accept with:  python -m derive.proof -o {output}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
