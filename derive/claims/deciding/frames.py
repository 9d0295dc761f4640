"""Rotations of a claim in other forms: frames at rest, and a product in a logarithm as one rotation.

A rotation R that only gives constant directions ``R*c`` is taken as the identity. All other vectors turn with R, so
that a claim is true for each R if it is true for one.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum, auto

from ..language.matrices import distance, inverse
from ..language.operator_table import RELATIONS, Re
from ..language.printed import Symbol, Term, Trait, symbols, walk, with_trait
from ..numbers.kinds import KINDS
from .claim import Claim, kind
from .terms import is_frame_free


class Turn(Enum):
    """Rotation with which vectors turn; two vectors of one formula turn with the same one."""

    FRAME = auto()
    REAL_PART = auto()


ROTATION, PRODUCT = "rotation", "S of rotations"
INVARIANT = frozenset(("norm", "dot", "trace", "det", "distance"))
"""Operators whose numbers are the same in all frames, with their dual parts."""


def with_frames_at_rest(claim: Claim, *further: Term) -> tuple[Claim, tuple[Term, ...]]:
    """Return a claim and further terms with the identity for each frame, if they allow it."""
    for frame in claim.coordinates:
        parts = [part for part in (claim.statement, claim.entry.claimed, *further) if part is not None]
        fixed = kind(frame).constant or not claim.depth
        if fixed and frame.quantity.name.endswith(("rotation", "orthogonal tensor")) and _all_turn(frame, parts):
            axes = {node: node.arguments[1] for part in parts for node in walk(part) if _is_axis(node, frame)}
            claimed = None if claim.entry.claimed is None else claim.entry.claimed.xreplace(axes)
            claim = claim.on(claimed).with_statement(claim.statement.xreplace(axes))
            further = tuple(part.xreplace(axes) for part in further)
    return claim, further


def _is_axis(node: Term, frame: Symbol) -> bool:
    """Return whether a term is ``R*c`` with a constant direction c."""
    is_product = node.operator.name == "times" and node.arguments[0] == frame
    return is_product and not any(a.quantity.varies for a in symbols(node.arguments[1]))


def _all_turn(frame: Symbol, parts: Sequence[Term]) -> bool:
    """Return whether all vectors turn with a frame, of which nothing but axes occurs."""
    axis = Symbol(f"axis of {frame.name}", "dual vector")
    shown = [part.xreplace({node: axis for node in walk(part) if _is_axis(node, frame)}) for part in parts]
    if not is_frame_free(*shown) or any(frame in symbols(part) for part in shown):
        return False
    return not kind(frame).dual or not any(map(_turning, shown))


def _turning(node: Term) -> set[Turn]:
    """Return by what the vectors in a term turn, if they are not within a number that is the same in all frames."""
    if isinstance(node, Symbol):
        row = KINDS.get(node.quantity.name)
        return set() if row is None or row.size == 1 else {Turn.FRAME if row.dual else Turn.REAL_PART}
    found = set[Turn]().union(*map(_turning, node.arguments))
    if node.operator is Re and found == {Turn.FRAME}:
        found = {Turn.REAL_PART}
    is_apart = Trait.APART in node.operator.traits and node.operator is not distance
    if is_apart and Turn.FRAME in found:
        return {*Turn}
    return set() if node.operator.name in INVARIANT | RELATIONS and len(found) < 2 else found


def with_free_product(claim: Claim, *further: Term) -> tuple[Claim, tuple[Term, ...]]:
    """Return a claim and further terms with a rotation S for ``R*inverse(K)`` in a logarithm, and R = S K.

    The logarithm of a product of two rotations in polar form is no rational function.
    """
    found = next(filter(None, map(_product_of_rotations, with_trait(Trait.TRANSCENDENTAL, claim.statement))), None)
    if found is None:
        return claim, further
    node, moved, product = found
    letter = Symbol(PRODUCT, ROTATION, PRODUCT, PRODUCT)
    a, b = node.arguments
    opposite = b.arguments[0] * inverse(a) if isinstance(a, Symbol) else inverse(b) * a.arguments[0]

    def shown(part: Term) -> Term:
        found: Term = part.xreplace({node: letter, opposite: inverse(letter)}).xreplace({moved: product})
        return found

    domain = None if claim.entry.claimed is None else shown(claim.entry.claimed)
    return claim.on(domain).with_statement(shown(claim.statement)), tuple(map(shown, further))


def _product_of_rotations(node: Term) -> tuple[Term, Symbol, Term] | None:
    """Return the product in a logarithm, its letter that moves, and this letter by the product and the other one."""
    inner = node.arguments[0]
    if node.operator.name != "log" or inner.operator.name != "times" or len(inner.arguments) != 2:
        return None
    a, b = inner.arguments
    product = Symbol(PRODUCT, ROTATION, PRODUCT, PRODUCT)
    for one, other, left in ((a, b, False), (b, a, True)):
        base = other.arguments[0] if other.operator.name in ("inverse", "transpose") else None
        if not (isinstance(one, Symbol) and isinstance(base, Symbol) and one.quantity.name.endswith("rotation")):
            continue
        if kind(one).constant:
            return inner, base, one * inverse(product) if left else inverse(product) * one
        return inner, one, base * product if left else product * base
    return None
