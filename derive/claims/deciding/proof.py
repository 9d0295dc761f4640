"""Proof of a claim: for every order at once, then at independent generators, exactly or modulo a random prime."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress

from ...algebra.element import NotExactError
from ..numbers.residues import SURE_BITS
from .claim import Claim
from .identity import MODULO, orders_of, proved_exactly, proved_for_all_orders, proved_modulo

EVERY = "exact, all n"
"""Words for a proof for every order."""


def proved(claim: Claim) -> str | None:
    """Return how a claim is proved where both sides have a value, or None."""
    of = orders_of(claim)
    ways: tuple[tuple[Callable[[Claim], bool], str], ...] = (
        (proved_for_all_orders, EVERY), (proved_exactly, f"exact{of}"),
        (proved_modulo, f"{MODULO}, error < 2^-{SURE_BITS}{of}"),
    )
    for prove, how in ways if of else ways[1:]:
        with suppress(NotExactError):
            if prove(claim):
                return how
    return None
