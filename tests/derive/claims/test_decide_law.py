"""Law of sound verdicts: true identities are called true, and each of them made false in five ways is refuted."""

from __future__ import annotations

from itertools import product

import pytest

from derive.claims.deciding.claim import Claim
from derive.claims.deciding.finding import decided
from derive.claims.result import Status
from derive.claims.sheet import claim_alone

MATRICES = ("tensor", "rotation", "dual tensor", "orthogonal dual tensor", "pose")
FAMILIES = {
    # left side, then the factors X and Y of the right side X*Y, then the kinds of A and B
    "transpose(A*B)": ("transpose(B)", "transpose(A)", MATRICES),
    "inverse(A*B)": ("inverse(B)", "inverse(A)", MATRICES),
    "A*B*A": ("A", "(B*A)", MATRICES),
    "(A + B)**2 - A**2 - B**2 - B*A": ("A", "B", MATRICES),
    "inverse(inverse(B)*A)": ("inverse(A)", "B", MATRICES),
    "(A + B)*A*B": ("(A + B)", "(A*B)", ("tensor", "rotation", "dual tensor", "orthogonal dual tensor")),
    "rate(A*B) - rate(A)*B": ("A", "rate(B)", MATRICES),
    "-A*rate(inverse(A))*A": ("(rate(A)*inverse(A))", "A", ("tensor", "dual tensor")),
    "dyad(A*v, w)": ("A", "dyad(v, w)", ("tensor", "rotation")),
    "-transpose(skew(v)*transpose(A))": ("A", "skew(v)", ("tensor", "rotation")),
    "skew(A*v)": ("A", "(skew(v)*transpose(A))", ("rotation",)),
    "skew(A*v)*A": ("A", "skew(v)", ("rotation",)),
    "dyad(A*v, A*w)": ("A", "(dyad(v, w)*transpose(A))", ("tensor", "rotation")),
    "A*exp(skew(v))*transpose(A)": ("exp(skew(A*v))", "I", ()),
    "exp(skew(A*v))*A": ("A", "exp(skew(v))", ("rotation",)),
    "adjoint(A*B)": ("adjoint(A)", "adjoint(B)", ("pose",)),
    "adjoint(inverse(A*B))": ("adjoint(inverse(B))", "adjoint(inverse(A))", ("pose",)),
    "ad(adjoint(A)*xi)*adjoint(A)": ("adjoint(A)", "ad(xi)", ("pose",)),
    "A*exp(xi)": ("exp(adjoint(A)*xi)", "A", ("pose",)),
    "skew(adjoint(A)*xi)*A": ("A", "skew(xi)", ("pose",)),
    "rotation_of(q*p)": ("rotation_of(q)", "rotation_of(p)", ("rotation",)),
    "rotation_of(conjugate(q)*p)": ("transpose(rotation_of(q))", "rotation_of(p)", ("rotation",)),
    "exp(skew(v))*exp(skew(-v))*A*B": ("A", "B", ("tensor", "rotation")),
    "A*skew(v)*B - A*B*skew(v)": ("A", "(skew(v)*B - B*skew(v))", ("tensor", "rotation")),
    "vect(A)*0 + A*B*v": ("A", "B*v", ()),
    "cay(2, v)*cay(2, w)": ("cay(1, 2*v/(1 - dot(v, v)))", "cay(2, w)", ("rotation",)),
    "exp(skew(2*v))*A": ("exp(skew(v))", "(exp(skew(v))*A)", ("tensor", "rotation")),
    "transpose(dexp(v))*A": ("dexp(-v)", "A", ("tensor",)),
    "exp(skew(v))*transpose(dexp(v))*A": ("dexp(v)", "A", ("tensor",)),
}  # fmt: skip
IDENTITIES = [(left, x, y, kind) for left, (x, y, kinds) in FAMILIES.items() for kind in kinds]
WAYS = {"sign": "-({x})*{y}", "transpose": "transpose({x})*{y}", "factor": "2*{x}*{y}", "swapped factors": "{y}*{x}",
        "inverse": "inverse({x})*{y}"}  # fmt: skip
CASES = list(product(IDENTITIES, ("{x}*{y}", *WAYS.values())))
SAMPLE = CASES[::23]


def verdict(identity: tuple[str, str, str, str], form: str) -> Status:
    left, x, y, kind = identity
    units, vectors = dict.fromkeys("qp", "unit quaternion"), dict.fromkeys("vw", "vector")
    kinds = {"A": kind, "B": kind, "xi": "twist", **vectors, **units}
    (entry,) = claim_alone(f"{left} == {form.format(x=x, y=y)}", kinds).entries()
    return decided(Claim(entry, entry.readings[0].statement)).status


def right(identity: tuple[str, str, str, str], form: str) -> bool:
    found = verdict(identity, form)
    return found in (Status.HOLDS, Status.HOLDS_IF) if form == "{x}*{y}" else found is Status.FALSE


def test_a_sample_of_the_law() -> None:
    assert [case for case in SAMPLE if not right(*case)] == []


@pytest.mark.thorough
def test_sixty_identities_and_five_errors_in_each() -> None:
    assert len(CASES) >= 360
    assert [case for case in CASES if not right(*case)] == []
