"""All theorems for every order n ≥ 1, without bound: those on the polynomials and those on the maps made with them."""

from __future__ import annotations

from functools import cache

from .differential_field import Formulas
from .identity import Proof
from .induction import polynomial_theorems
from .map_theorems import motion_theorems


@cache
def theorems() -> tuple[Proof, ...]:
    """Prove everything that is proved for every order.

    Returns
    -------
    tuple of Proof
        Of scope "all n", decided once per process.
    """
    return polynomial_theorems() + motion_theorems(Formulas())
