"""Proof at independent generators: what is true is proved, exactly or modulo a prime, and nothing else."""

from __future__ import annotations

from contextlib import suppress

import pytest

from derive.algebra.element import NotExactError
from derive.claims.decide import _premised
from derive.claims.deciding.claim import Claim
from derive.claims.deciding.existence import undecided_parts
from derive.claims.deciding.identity import MODULO, proved, proved_exactly, proved_modulo
from derive.claims.language.operations import written
from derive.claims.sheet import claim_alone
from docs.pages.field_facts import sheets
from tests.support.claims_of_known_truth import used

TRUE = {
    "vect(rate(exp(skew(v)))*transpose(exp(skew(v)))) == dexp(v)*rate(v)": "exact",
    "adjoint(exp(xi))*xi == xi": "exact", "norm(R*v) == norm(v)": "exact", "exp(x + y) == exp(x)*exp(y)": "exact",
    "norm(cross(v, w))**2 + dot(v, w)**2 == norm(v)**2*norm(w)**2": "exact",
    "jacobian(jacobian(norm(v)**2, v)*w, v) == 2*transpose(w)": "exact", "inverse(dexp(v))*dexp(v) == I": "exact",
    "left_jacobian(exp(xi), xi) == adjoint(exp(xi))*right_jacobian(exp(xi), xi)": MODULO,
}  # fmt: skip
FALSE = """sqrt(x**2) == x
atan(tan(a)) == a
atan2(sin(a), cos(a)) == a
atan2(x, y) == atan2(-x, -y)
acos(cos(norm(v))) == norm(v)
sqrt((1 - x)**2) == 1 - x
sqrt((1 + trace(exp(skew(v))))/4) == cos(norm(v)/2)
sin(x)**2 + cos(x)**2 == 1 + 1/(10**60*10**60)
sqrt(2)*sqrt(3) == sqrt(6) + 1/(10**60*10**60)
exp(x)*(1 + 1/(10**60*10**60)) == exp(x)
(rate(x)**2 - 1)*(rate(x)**2 - 4)*(rate(x)**2 - 9) == 0
norm(v + w) == norm(v) + norm(w)
log(R) == skew(vect(R))
norm(x*v) == x*norm(v)
vect(log(exp(skew(v)))) == v
floor(x) == x
exp(skew(v))*exp(skew(w)) == exp(skew(v + w))
2*acos(cos(a/2)) == a
log(x*y) == log(x) + log(y)
norm(v)*norm(w) == dot(v, w)
sin(norm(v)) == norm(sin(norm(v)))""".splitlines()
"""Claims that are false somewhere, many of them at another branch or sign alone."""


def of(text: str) -> Claim:
    (entry,) = claim_alone(text, used(text)).entries()
    return _premised(Claim(entry, entry.readings[0].statement))


@pytest.mark.parametrize(("text", "how"), TRUE.items(), ids=str)
def test_true_claims_are_proved(text: str, how: str) -> None:
    assert (proved(of(text)) or "").startswith(how)


@pytest.mark.parametrize("prove", [proved_exactly, proved_modulo])
@pytest.mark.parametrize("text", FALSE)
def test_false_claims_are_not_proved(text: str, prove) -> None:
    with suppress(NotExactError):
        assert not prove(of(text))


@pytest.mark.parametrize(
    ("text", "part"), [("1/(1 + x/sqrt(x**2)) == 1/2", "1 + x/sqrt(x**2)"), ("1/norm(v - w) == 1", "norm(v - w)")]
)
def test_values_exist_for_all_signs_of_roots(text: str, part: str) -> None:
    assert part in map(written, undecided_parts(of(text)))


@pytest.mark.thorough
def test_no_printed_erratum_is_proved() -> None:
    entries = [entry for read in sheets() for entry in read.entries() if entry.corrected is not None]
    assert len(entries) > 80
    claims = [_premised(Claim(entry, entry.readings[0].statement)) for entry in entries]
    assert [claim.entry.number for claim in claims if proved(claim) is not None] == []
