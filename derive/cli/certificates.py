"""File of certificates: what each decision rests on, as JSON that ``tools/check_certificates.py`` checks."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Sequence
from typing import Any

from ..claims.result import Result
from ..papers.entry_certificate import certificate as of_equation
from ..proof.certificate import Certificate
from ..proof.certificate import certificate as of_proof
from ..proof.proved import CLAIMS
from ..proof.theorem import decided

FORMAT = (
    "A polynomial is a list of terms [coefficient, exponents], one exponent for each variable. A side [divisor, "
    "powers, polynomial] is the polynomial over the divisor and over the factors to these powers. The numerator of "
    "left less right is 0 modulo the relations. Without a left side, a term is moved: at the start and in a step of "
    "an induction, values replace the variables; with a rate, the values are the derivatives of the variables. A "
    "factor is not 0: at a point where the relations between its variables hold, or at the origin, where it is a "
    "power of n. A base stands for its n-th power. Sums of binomials are checked for n up to last. The digest is "
    "SHA-256 of the sorted certificate."
)


def certified(results: Iterable[Result], proofs: Iterable[Any], orders: Sequence[int]) -> dict[str, Any]:
    """Return the certificates of all theorems, of further proofs and of results, and the decisions without one."""
    known = {proof.name: proof for proof in decided(CLAIMS)}
    others = (proof for proof in proofs if (proof.name, proof.scope) not in {(p.name, p.scope) for p in known.values()})
    found = [(f"{proof.name} [{proof.scope}]", of_proof(proof, known)) for proof in (*known.values(), *others)]
    found += [(f"{result.paper} ({result.equation.number})", of_equation(result, orders)) for result in results]
    shown = [_sealed(certificate) for _, certificate in found if not isinstance(certificate, str)]
    listed = [{"name": name, "reason": reason} for name, reason in found if isinstance(reason, str)]
    counts = {"certified": len(shown), "uncertified": len(listed)}
    return {"format": FORMAT, **counts, "certificates": shown, "listed": listed}


def _sealed(certificate: Certificate) -> Certificate:
    text = json.dumps({**certificate, "sha256": ""}, sort_keys=True)
    return {**certificate, "sha256": hashlib.sha256(text.encode()).hexdigest()}
