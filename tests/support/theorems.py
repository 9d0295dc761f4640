"""Proved theorems, for theorems that rest on them."""

from __future__ import annotations

from derive.proof import theorems
from derive.proof.identity import Proof


def known() -> dict[str, Proof]:
    """The proofs of all theorems for every order, by name."""
    return {proof.name: proof for proof in theorems()}
