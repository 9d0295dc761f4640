"""``python -m derive.proof``: prove everything, and see every control fail. Exit code 1 if a proof fails or a control
does not."""

from __future__ import annotations

import sys
from collections.abc import Iterator

from ..maps import Cayley
from .any_phi import ANY_PHI
from .controls import Control, controls, controls_at, controls_of
from .displacement_theorems import COMPOSITION_AT
from .every_order import decided, stated
from .formulas import Formulas
from .identity import Proof
from .proved import proofs

ORDERS = (1, 2, 3, 4, 5)
"""Orders at which the componentwise road is controlled: without poles and with, even and odd."""


def main() -> int:
    """Print what is proved and how many controls failed, as they must."""
    claimed = (*stated(Formulas()), *COMPOSITION_AT.values(), *ANY_PHI)
    general = decided(claimed)
    at_orders = (proof for n in ORDERS for proof in proofs(Cayley(n)))
    proved = tuple({(proof.scope, proof.name): proof for proof in (*general, *at_orders)}.values())
    known = {proof.name: proof for proof in general}
    altered = [*controls(claimed, known)]
    for n in ORDERS:
        altered += (*controls_at(Cayley(n)), *controls_of(Cayley(n)))
    print("\n".join(_report(proved, altered)))
    wrong = [proof for proof in proved if not proof.proved]
    missed = [control for control in altered if not control.noticed]
    print(f"{len(proved)} statements, {len(wrong)} not proved; ", end="")
    print(f"{len(altered)} controls, {len(missed)} not noticed")
    for line in (*map(str, wrong), *map(str, missed)):
        print(line, file=sys.stderr)
    return 1 if wrong or missed else 0


def _report(proved: tuple[Proof, ...], altered: list[Control]) -> Iterator[str]:
    """A line for each statement: scope, name, how many of its controls failed, and its words."""
    for proof in proved:
        own = [c for c in altered if (c.proof.name, c.proof.scope) == (proof.name, proof.scope)]
        noticed = sum(control.noticed for control in own)
        yield f"{proof.status} [{proof.scope}] {proof.name}, {noticed} of {len(own)} controls failed: {proof.statement}"
        yield from (f"    given {premise}" for premise in proof.premises)
        yield from (f"    multiplied by {factor}, zero where {factor.vanishes}" for factor in proof.multipliers)


if __name__ == "__main__":
    sys.exit(main())
