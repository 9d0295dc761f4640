"""Certificates of proofs: the statement, its premises by name, and both sides of each equation as integer lists."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy

from .differential_ring import DifferentialRing
from .identity import Proof, Sides
from .integer_lists import IntegerLists
from .series_certificate import series
from .statement import Premise

Certificate = dict[str, Any]

def certificate(proof: Proof, known: Mapping[str, Proof]) -> Certificate | str:
    """Return the certificate of a proof, or the reason why there is none; premises cite the `known` proofs by name."""
    if any(equation.right.has(sympy.Sum) for equation in proof.claim):
        parts: dict[str, Any] = {"series": series(proof)}
    else:
        compared = [(residue.label, residue.sides) for residue in proof.residues if residue.sides is not None]
        if not proof.proved or not compared:
            return f"{proof.status}: {proof.method}"
        if not any(premise.theorem for premise in proof.premises) and all(_alike(sides) for _, sides in compared):
            return "both sides come out in one form; " + proof.method
        parts = {"parts": [part(compared)]}
    name = proof.name if proof.name in known else f"{proof.name} [{proof.scope}]"
    head = {"name": name, "scope": proof.scope, "status": proof.status, "method": proof.method}
    premises = [_premise(premise, known) for premise in proof.premises]
    return {**head, "claims": [equation.text for equation in proof.claim], "premises": premises, **parts}


def _premise(premise: Premise, known: Mapping[str, Proof]) -> dict[str, str]:
    """Return a premise with the name of the theorem that claims it, and the text there."""
    if not premise.theorem:
        return {"text": premise.equation.text, "by": "definition"}
    changes = dict(premise.instance)
    cited = next(e for e in known[premise.theorem].claim if e.replaced(changes).text == premise.equation.text)
    return {"text": premise.equation.text, "by": premise.theorem, "claim": cited.text}


def _alike(sides: Sides) -> bool:
    same = sides.left.numerator == sides.right.numerator and sides.left.denominator == sides.right.denominator
    return sides.moved is None and bool(same)


def part(compared: list[tuple[str, Sides]]) -> dict[str, Any]:
    """Return variables, relations, factors and equations, given labels and sides in one ring."""
    ring = compared[0][1].left.ring
    lists = IntegerLists(ring)
    equations = [_equation(label, sides, lists) for label, sides in compared]
    found = {"variables": list(ring.names), "relations": [lists.polynomial(r)[1] for r in ring.relations]}
    return {**found, **_factors(lists, ring), "equations": equations}


def _equation(label: str, sides: Sides, lists: IntegerLists) -> dict[str, Any]:
    """Return both sides of a compared equation; a moved term takes the place of the left side."""
    right = lists.side(sides.right)
    if sides.moved is None:
        return {"label": label, "left": lists.side(sides.left), "right": right}
    term, values = sides.moved()
    moved = {"term": lists.side(term), "values": [lists.side(lists.ring.element(value)) for value in values]}
    return {"label": label, sides.move: moved, "right": right}


def _factors(lists: IntegerLists, ring: Any) -> dict[str, Any]:
    """Return the factors of the denominators with reasons why they are not 0, and the origin."""
    if not isinstance(ring, DifferentialRing):
        free = [{"factor": lists.polynomial(f)[1], "point": lists.point(f)} for f in lists.factors]
        return {"factors": free, "free": list(ring.names), "origin": {}}
    factors = []
    for f in lists.factors:
        base = ring.bases.get(ring.expression(f), f)
        shown = {"factor": lists.polynomial(f)[1], "base": lists.polynomial(base)[1]}
        factors.append({**shown, "point": lists.point(base)} if ring.is_free(base) else shown)
    origin = {str(symbol): lists.side(value) for symbol, value in ring.origin.items()}
    return {"factors": factors, "free": sorted(map(str, ring.free)), "origin": origin}
