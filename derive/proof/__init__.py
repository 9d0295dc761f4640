"""Exact proofs of identities, for every order n at once and, independently, at each requested order.

Read `notation`, `identity`, `methods`, then the modules of theorems. `proved` collects all proofs.
"""

from __future__ import annotations

from ..algebra.element import Element
from .identity import Proof, decide
from .proved import ProofFailed, Proved, citing, proofs, prove, shown, theorems
from .rings import Ring
from .scalars import root_of

__all__ = [
    "Element", "Proof", "ProofFailed", "Proved", "Ring", "citing", "decide", "proofs", "prove", "root_of", "shown",
    "theorems",
]  # fmt: skip
