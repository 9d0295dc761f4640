"""Claims with integer letters are proved for all of them at once; neighbours that fail somewhere are not proved."""

from __future__ import annotations

import pytest

from derive.claims.decide import decide
from derive.claims.deciding.claim import Claim
from derive.claims.deciding.existence import undecided_parts
from derive.claims.deciding.identity import proved
from derive.claims.deciding.ordering import ordered
from derive.claims.deciding.split import split
from derive.claims.sheet import claim_alone

N, K, X, A = {"n": "order"}, {"k": "integer"}, {"x": "real", "y": "real"}, {"a": "real"}
V, B = {"v": "vector"}, {"k": "branch"}
SCREW = {"u": "unit dual vector", "a": "dual angle"}
REACHED = "vector_part((1 + tan((a + 2*k*pi)/(2*n))*u)**n*conjugate(cos(a/2) + u*sin(a/2))) == 0"
CLAIMS = [  # with letters, domain, and false neighbours: claims, or the claim with other domains
    ("x**n*y**n == (x*y)**n", N | X, "", ("x**n + y**n == (x + y)**n", "x**n*y**n == (x*y)**(n + 1)")),
    ("(-x)**n == (-1)**n*x**n", N | X, "", ("(-x)**n == x**n", "(-x)**(2*n + 1) == x**(2*n + 1)")),
    ("sqrt(x**(2*n)) == norm(x)**n", N | X, "", ("sqrt(x**(2*n)) == x**n", "(x**2)**(n/2) == x**n")),
    ("rate(x**n) == n*x**(n - 1)*rate(x)", N | X, "", ("rate(x**n) == n*x**n*rate(x)",)),
    ("cos(x + k*pi) == (-1)**k*cos(x)", K | X, "", ("cos(x + k*pi) == cos(x)", "sin(k*pi - x) == sin(x)")),
    ("cos(k*pi/2)**2 == (1 + (-1)**k)/2", K, "", ("cos(k*pi/2) == (1 + (-1)**k)/2", "cos(k*pi/2) == 1")),
    ("floor(n/2) + floor((n + 1)/2) == n", N, "", ("floor(n/2) + floor((n + 2)/2) == n", "floor(n/2) == n/2")),
    ("sum(k, 0, n, binomial(n, k)*x**k*y**(n - k)) == (x + y)**n", N | X, "",
     ("sum(k, 0, n - 1, binomial(n, k)*x**k*y**(n - k)) == (x + y)**n", "sum(k, 0, n, binomial(n, k) + x**k) == 2**n",
      "sum(k, 0, n, binomial(n, k)*k*x**k) == (1 + x)**n", "sum(k, 0, n, binomial(n, k)*x**(k*k)) == (1 + x)**n")),
    ("sum(k, 0, floor(n/2), (-1)**k*binomial(n, 2*k)*x**(2*k)) == p(n, x**2)", N | X, "",
     ("sum(k, 0, floor(n/2), binomial(n, 2*k)*x**(2*k)) == p(n, x**2)",
      "sum(k, 0, floor((n - 1)/2), (-1)**k*binomial(n, 2*k)*x**(2*k)) == p(n, x**2)")),
    ("(1 + v)**n*(1 - v)**n == (1 + dot(v, v))**n", N | V, "", ("(1 + v)**n*(1 - v)**n == (1 - dot(v, v))**n",
     "entry(v, 1)*n == 0")),
    ("(1 + v)**(n/2)*(1 + v)**(n/2) == (1 + v)**n", N | V, "", ("((1 + v)**n)**(1/2) == (1 + v)**(n/2)",)),
    (REACHED, N | B | SCREW, "cos(re(a + 2*k*pi)/(2*n)) != 0",
     (REACHED.replace("2*k*pi", "k*pi"), REACHED.replace("(2*n)", "n"), REACHED.replace("sin(a/2)", "sin(a/4)"))),
    ("sqrt(cos(a/(2*n))**(2*n)) == cos(a/(2*n))**n", N | A, "norm(a) < n*pi", ("norm(a) < n*(2*pi)", "")),
]  # fmt: skip


def claim_of(text: str, letters: dict[str, str], domain: str) -> Claim:
    (entry,) = claim_alone(text, letters, domain).entries()
    return Claim(entry.meant, entry.meant.readings[0].statement)


@pytest.mark.parametrize(("text", "letters", "domain", "false"), CLAIMS, ids=[row[0][:40] for row in CLAIMS])
def test_integers_of_any_size(text: str, letters: dict[str, str], domain: str, false: tuple[str, ...]) -> None:
    (entry,) = claim_alone(text, letters, domain).entries()
    found = decide("", entry)
    assert (str(found.status), found.method) == ("holds", "exact, all n" if "n" in letters else "exact")
    for other in false:
        claim = claim_of(other, letters, domain) if "==" in other else claim_of(text, letters, other)
        assert not all(proved(part) for part in split(claim))


@pytest.mark.parametrize("text", [
    "1/(n - 7) == 1/(n - 7)", "sqrt(10**9 - n)**2 == 10**9 - n", "1/cos(n*x) == 1/cos(n*x)",
    "(1 + cos(x))**n/(1 + cos(x))**n == 1", "x**(n - 2)*x**2 == x**n",
    "sum(k, 0, n, binomial(n, k)*x**(k - 1)*x) == (1 + x)**n", "x**m*x == x**(m + 1)",
    "(1 + cos(x/(4*n)))**n/(1 + cos(x/(4*n)))**n == 1",
])  # fmt: skip
def test_values_that_some_order_lacks_are_not_proved_to_exist(text: str) -> None:
    assert undecided_parts(claim_of(text, {"m": "integer", **N, **X}, ""))


def test_branches_are_less_than_their_order() -> None:
    (entry,) = claim_alone("sin(k*pi/n)/sin(k*pi/n) == 1", N | B, "k != 0").entries()
    assert not decide("", entry).found


@pytest.mark.parametrize(("text", "is_true"), [
    ("n*(n - 1) >= 0", True), ("x**(2*n) >= 0", True), ("jacobian(x**n, x) == n*x**(n - 1) and n > 0", True),
    ("x**n >= 0", False), ("n >= 2", False), ("n < 10**12", False), ("(x - 1)**(2*n) > 0", False),
    ("x**n*(x - n)**n == (x*(x - n))**(n + 1) and n > 0", False),
])  # fmt: skip
def test_order_relations_of_every_order(text: str, is_true: bool) -> None:
    assert ordered(claim_of(text, N | X, "")) is is_true
