"""Frames at rest: a rotation R that only gives constant directions ``R*c`` is taken as the identity.

All other vectors turn with R, so that a claim is true for each R if it is true for one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from ..language.operator_table import Re
from ..language.printed import Number, Symbol, Term, Trait, symbols, walk, with_trait
from .claim import Claim, kind
from .terms import is_frame_free

INVARIANT = frozenset(("norm", "dot", "trace", "det", "distance"))
"""Operators whose numbers are the same in all frames, with their dual parts."""


def with_frames_at_rest(claim: Claim, *further: Term) -> tuple[Claim, tuple[Term, ...]]:
    """Return a claim and further terms with the identity for each frame, if they allow it."""
    for frame in claim.coordinates if not claim.entry.where else ():
        parts = [part for part in (claim.statement, claim.entry.claimed, *further) if part is not None]
        fixed = kind(frame).constant or not claim.depth
        if fixed and frame.quantity.name.endswith(("rotation", "orthogonal tensor")) and _all_turn(frame, parts):
            axes = {node: node.arguments[1] for part in parts for node in walk(part) if _is_axis(node, frame)}
            claimed = None if claim.entry.claimed is None else claim.entry.claimed.xreplace(axes)
            entry = replace(claim.entry, claimed=claimed, condition=None)
            claim = replace(claim, entry=entry, statement=claim.statement.xreplace(axes))
            further = tuple(part.xreplace(axes) for part in further)
    return claim, further


def _is_axis(node: Term, frame: Symbol) -> bool:
    """Return whether a term is ``R*c`` with a constant direction c."""
    is_product = node.operator.name == "times" and node.arguments[0] == frame
    return is_product and not any(a.quantity.varies for a in symbols(node.arguments[1]))


def _all_turn(frame: Symbol, parts: Sequence[Term]) -> bool:
    """Return whether all vectors turn with a frame, of which nothing but axes occurs.

    Real and dual parts of vectors do not, if the frame is dual, unless its real part occurs alone.
    """
    axis = Symbol(f"axis of {frame.name}", "real vector")
    shown = [part.xreplace({node: axis for node in walk(part) if _is_axis(node, frame)}) for part in parts]
    if not is_frame_free(*shown) or any(frame in symbols(part) for part in shown):
        return False
    rest = [part.xreplace({node: Number(0) for node in walk(part) if node.operator is Re}) for part in shown]
    is_real = not kind(frame).dual or not any(axis in symbols(part) for part in rest)
    return is_real or not any(axis in _vectors(node) for node in with_trait(Trait.APART, *shown))


def _vectors(node: Term) -> Iterator[Term]:
    """Yield the parts of a term that are not within a number that is the same in all frames."""
    yield node
    if node.operator.name not in INVARIANT:
        for part in node.arguments:
            yield from _vectors(part)
