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
    modulo = f"{MODULO}, error < 2^-{SURE_BITS}"
    if orders_of(claim):
        return _first(claim, (proved_for_all_orders, EVERY))
    return _first(claim, (proved_exactly, "exact"), (proved_modulo, modulo))


def proved_at_orders(claim: Claim) -> str | None:
    """Return at which orders a claim about every order is proved, which is no proof of it; or None."""
    return _first(claim, (proved_exactly, f"exact{orders_of(claim)}")) if orders_of(claim) else None


def _first(claim: Claim, *ways: tuple[Callable[[Claim], bool], str]) -> str | None:
    for prove, how in ways:
        with suppress(NotExactError):
            if prove(claim):
                return how
    return None
