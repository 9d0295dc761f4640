"""Seeded alterations of certificates, one for each seed; a checker must refuse every one."""

from __future__ import annotations

import copy
import hashlib
import json
import random
from collections.abc import Iterator
from typing import Any

Node = Any


def altered(certificate: dict[str, Any], seed: int) -> dict[str, Any]:
    """Return the altered certificate; alterations of equations have a right digest."""
    draw, found = random.Random(seed), copy.deepcopy(certificate)
    if KINDS[seed % len(KINDS)](found, draw):
        seal(found)
    return found


def seal(certificate: dict[str, Any]) -> None:
    """Make the digest of a certificate right."""
    text = json.dumps({**certificate, "sha256": ""}, sort_keys=True)
    certificate["sha256"] = hashlib.sha256(text.encode()).hexdigest()


def _sides(certificate: Node) -> Iterator[list[Any]]:
    """Yield the sides and moved terms of all equations."""
    for part in certificate["parts"]:
        for equation in part["equations"]:
            yield equation["right"]
            yield from (
                value["term"] if isinstance(value, dict) else value
                for key, value in equation.items() if key not in ("label", "right")
            )  # fmt: skip


def _filled(certificate: Node, draw: random.Random) -> list[Any]:
    return draw.choice([side for side in _sides(certificate) if side[2]])


def _coefficient(certificate: Node, draw: random.Random) -> bool:
    term = draw.choice(_filled(certificate, draw)[2])
    term[0] += 1 if term[0] != -1 else 2
    return True


def _exponent(certificate: Node, draw: random.Random) -> bool:
    exponents = draw.choice(_filled(certificate, draw)[2])[1]
    exponents[draw.randrange(len(exponents))] += 1
    return True


def _dropped_term(certificate: Node, draw: random.Random) -> bool:
    terms = _filled(certificate, draw)[2]
    terms.pop(draw.randrange(len(terms)))
    return True


def _divisor(certificate: Node, draw: random.Random) -> bool:
    _filled(certificate, draw)[0] += 1
    return True


def _dropped_claim(certificate: Node, draw: random.Random) -> bool:
    """Remove all equations of one claim."""
    for part in certificate["parts"]:
        first = part["equations"][0]["label"].split(", component ")[0]
        part["equations"] = [e for e in part["equations"] if not e["label"].startswith(first)]
    return True


def _status(certificate: Node, draw: random.Random) -> bool:
    certificate["status"] = "failed"
    return True


def _premise(certificate: Node, draw: random.Random) -> bool:
    """Cite a theorem that does not exist."""
    certificate["premises"].append({"text": "p_n = q_n", "by": "no theorem", "claim": "p_n = q_n"})
    return True


def _renamed(certificate: Node, draw: random.Random) -> bool:
    certificate["name"] += " again"
    return False


def _reworded(certificate: Node, draw: random.Random) -> bool:
    certificate["claims"][0] += " + 1"
    return False


def _missing(certificate: Node, draw: random.Random) -> bool:
    del certificate[draw.choice(["claims", "premises", "parts", "status"])]
    return True


KINDS = (
    _coefficient, _exponent, _dropped_term, _divisor, _dropped_claim, _status, _premise, _renamed, _reworded, _missing,
)  # fmt: skip
"""Alterations; each returns whether the digest is made right again."""
