"""Proof of a claim at independent generators: for all signs of its roots, exactly or modulo a random prime.

Such a proof shows that both sides are equal wherever both have a value; it shows no value. Modulo a prime a proof is
fast, and large formulas have no other.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from math import lcm
from typing import Any

from ...algebra.element import NotExactError
from ..language.environment import Env
from ..language.operator_table import both
from ..language.printed import Symbol, Term, Trait, with_trait
from ..language.written import written
from ..numbers.generators import Generators
from ..numbers.kinds import ORDER
from ..numbers.residues import Residues, UnluckyError
from .claim import Claim, kind
from .polar import Polar, bounds
from .proof import steps_of

PRIMES_MAX = 40
"""Largest number of primes that are tried for one with all roots."""
TESTS = 2**20
"""More equalities than a proof tests."""
Make = Callable[..., Generators]


def proved_modulo(claim: Claim) -> bool:
    """Return whether a claim is true for all signs of roots, modulo a random prime."""
    for attempt in range(PRIMES_MAX):
        seed = f"{written(claim.statement)} {attempt}"
        try:
            return _for_all_signs(claim, partial(Residues, seed=seed))
        except UnluckyError:
            continue
    return False


def proved_exactly(claim: Claim) -> bool:
    """Return whether a claim is true for all signs of roots, exactly."""
    return _for_all_signs(claim, Generators)


def _for_all_signs(claim: Claim, make: Make) -> bool:
    """Return whether a claim is true for all orders and for all signs of roots whose sign is unknown.

    Raise NotExactError if the field cannot tell.
    """
    if claim.dual or claim.constraints:
        raise NotExactError("dual numbers, or equations in the domain")
    domain = [] if claim.entry.claimed is None else _conjuncts(claim.entry.claimed)
    for fixed in claim.choices:
        waiting: list[tuple[int, ...]] = [()]
        while waiting:
            signs = waiting.pop()
            field = _evaluated(claim, make, fixed, signs, domain)
            if field is None:
                return False
            waiting += [(*field.signs[:i], -1) for i in range(len(signs), len(field.roots))]
    return True


def _conjuncts(domain: Term) -> list[Term]:
    return [part for one in domain.arguments for part in _conjuncts(one)] if domain.operator is both else [domain]


def _evaluated(
    claim: Claim, make: Make, fixed: Mapping[Symbol, int], signs: Sequence[int], domain: Sequence[Term]
) -> Generators | None:
    """Return the field if the claim is true with these signs of the first roots, else None."""
    steps = lcm(steps_of(claim.statement), *(4 * n for a, n in fixed.items() if a.quantity is ORDER))
    letters = Polar(claim.coordinates, claim.depth, bounds(domain), partial(make, steps=steps, signs=signs))
    values = letters.values | _related(claim, letters.values)
    env = Env(letters.field, values | dict(fixed), claim.entry.definitions, False, claim.depth)
    try:
        true = env.value(claim.statement)
    except NotExactError:
        raise
    except (ArithmeticError, TypeError, AttributeError) as error:
        if isinstance(error, UnluckyError):
            raise
        raise NotExactError("no generic value") from error
    if isinstance(letters.field, Residues) and not letters.field.certain(TESTS):
        raise NotExactError("a formula too large for the prime")
    return letters.field if true else None


def _related(claim: Claim, values: Mapping[Symbol, Any]) -> dict[Symbol, Any]:
    """Return R = S K for rotations R, K and a free S if the claim has the logarithm of ``R*inverse(K)``, or alike.

    The logarithm of a product of two rotations in polar form is no rational function.
    """
    for node in with_trait(Trait.TRANSCENDENTAL, claim.statement):
        if node.operator.name != "log" or node.arguments[0].operator.name != "times":
            continue
        a, b = node.arguments[0].arguments[:2]
        for one, other, left in ((a, b, False), (b, a, True)):
            if not isinstance(one, Symbol) or other.operator.name not in ("inverse", "transpose"):
                continue
            (base,) = other.arguments
            if not isinstance(base, Symbol) or one not in values or base not in values:
                continue
            moved, fixed = (base, one) if kind(one).constant else (one, base)
            product = values[fixed] @ values[moved] if left else values[moved] @ values[fixed]
            if moved is base:
                product = values[fixed] @ values[moved].transpose if left else values[moved].transpose @ values[fixed]
            return {moved: product}
    return {}
