"""Proof of a claim: for every order at once, then at independent generators, exactly or modulo a random prime."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress

from ...algebra.element import NotExactError
from ..language.environment import Env
from ..language.printed import takes_apart
from ..numbers.generic import Generic
from ..numbers.kinds import BRANCH, ORDER, Role
from ..numbers.residues import SURE_BITS
from .claim import Claim
from .identity import ABSENT, MODULO, orders_of, proved_exactly, proved_modulo, steps_of
from .terms import is_frame_free

EVERY = "exact, all n"
"""Words for a proof for every order."""


def proved(claim: Claim) -> str | None:
    """Return how a claim is proved where both sides have a value, or None."""
    of = orders_of(claim)
    ways: tuple[tuple[Callable[[Claim], bool], str], ...] = (
        (_for_all_orders, EVERY), (proved_exactly, f"exact{of}"),
        (proved_modulo, f"{MODULO}, error < 2^-{SURE_BITS}{of}"),
    )
    for prove, how in ways if of else ways[1:]:
        with suppress(NotExactError):
            if prove(claim):
                return how
    return None


def _for_all_orders(claim: Claim) -> bool:
    """Return whether a claim is true for a symbol as its order, with at most one vector or angle whose powers occur."""
    orders = [a for a in claim.letters if a.quantity is ORDER]
    if len(orders) != 1 or claim.constraints or any(a.quantity is BRANCH for a in claim.letters):
        raise NotExactError("no single order")
    roles = [letter.quantity.role for letter in claim.coordinates]
    if (Role.VECTOR in roles) + roles.count(Role.ANGLE) > 1:
        raise NotExactError("a vector and an angle, which a symbolic order relates")
    framed = is_frame_free(*claim.parts)
    dual = claim.dual and takes_apart(claim.statement)
    generic = Generic(claim.coordinates, dual, claim.depth, steps_of(claim.statement), framed, orders[0])
    for fixed in {tuple((a, k) for a, k in every.items() if a not in orders) for every in claim.choices}:
        values = {**dict(fixed), **generic.values}
        env = Env(generic.field, values, claim.entry.definitions, generic.dual, claim.depth)
        try:
            true = env.value(claim.statement)
        except ABSENT as error:
            raise NotExactError("no generic value") from error
        if not true or generic.field.branched:
            return False
    return True
