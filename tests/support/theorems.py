"""Proved theorems, for use as premises of other theorems."""

from __future__ import annotations

from derive.proof import theorems
from derive.proof.identity import Proof


def known() -> dict[str, Proof]:
    """Return the proofs of all theorems for every order, by name."""
    return {proof.name: proof for proof in theorems()}
