"""All theorems for every order n ≥ 1, without bound: on the polynomials, the maps made with them, displacements."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from .displacement_theorems import displacement_theorems
from .formulas import Formulas
from .identity import Proof
from .map_theorems import map_theorems
from .polynomial_theorems import POLYNOMIAL_THEOREMS
from .theorem import Theorem


def stated(formulas: Formulas) -> tuple[Theorem, ...]:
    """Everything that is claimed for every order of the given formulas, each after what it rests on."""
    return (*POLYNOMIAL_THEOREMS, *map_theorems(formulas), *displacement_theorems(formulas))


def decided(claimed: Iterable[Theorem]) -> tuple[Proof, ...]:
    """Decide theorems one after the other, each given those before it."""
    known: dict[str, Proof] = {}
    for theorem in claimed:
        known[theorem.name] = theorem.decide(known)
    return tuple(known.values())


@cache
def theorems() -> tuple[Proof, ...]:
    """Prove everything that is proved for every order.

    Returns
    -------
    tuple of Proof
        Of scope "all n", decided once per process.
    """
    return decided(stated(Formulas()))
