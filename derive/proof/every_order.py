"""All theorems for every order n ≥ 1."""

from __future__ import annotations

from collections.abc import Container
from functools import cache

from .calculus_theorems import calculus_theorems
from .displacement_theorems import displacement_theorems
from .formulas import Formulas
from .identity import Proof
from .map_theorems import map_theorems
from .polynomial_theorems import POLYNOMIAL_THEOREMS
from .theorem import Theorem, decided
from .transport_theorems import transport_theorems


def stated(formulas: Formulas) -> tuple[Theorem, ...]:
    """Return all theorems on the given formulas, each after the theorems it uses."""
    of_maps = (map_theorems, displacement_theorems, calculus_theorems, transport_theorems)
    return (*POLYNOMIAL_THEOREMS, *(theorem for theorems_of in of_maps for theorem in theorems_of(formulas)))


def citing(numbers: Container[int]) -> tuple[Proof, ...]:
    """Prove the theorems that claim CP23's equations of these numbers, and all theorems they use."""
    claimed = stated(Formulas())
    wanted = {t.name for t in claimed if any(n in numbers for equation in t.claim for n in equation.numbers)}
    needed = set(wanted)
    for theorem in reversed(claimed):  # each theorem stands after the theorems it uses
        if theorem.name in needed:
            needed |= {premise.theorem for premise in theorem.premises}
    return tuple(proof for proof in decided(t for t in claimed if t.name in needed) if proof.name in wanted)


@cache
def theorems() -> tuple[Proof, ...]:
    """Return the proofs of scope "all n", decided once per process."""
    return decided(stated(Formulas()))
