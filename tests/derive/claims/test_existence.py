"""Existence of values: a divisor is proved not to be 0 by what the domain says of it, and by nothing less."""

from __future__ import annotations

import pytest

from derive.claims.decide import _premised
from derive.claims.deciding.claim import Claim
from derive.claims.deciding.existence import undecided_parts
from derive.claims.deciding.finding import decided
from derive.claims.deciding.frames import with_frames_at_rest
from derive.claims.deciding.split import split
from derive.claims.result import Status
from derive.claims.sheet import claim_alone

LETTERS = {
    "a": "angle", "x": "real", "y": "real", "v": "vector", "w": "vector", "u": "unit vector", "R": "rotation",
    "S": "rotation", "c": "dual number", "d": "dual number", "b": "dual vector", "h": "dual vector",
    "q": "quaternion", "p": "quaternion", "Q": "orthogonal dual tensor", "T": "pose", "xi": "twist",
}  # fmt: skip
BALL, ACROSS = "0 < norm(v) and norm(v) < 1", "1 - entry(u, 1)**2 != 0"
APART = [
    ("tan(a/2)", "0 < tan(a/2)"), ("2*norm(v) + entry(v, 3)", BALL), ("x", "sin(x/2) != 0"),
    ("norm(b + h)", "re(b + h) != 0"), ("norm(b)", "re(norm(b)) != 0"), ("norm(du(b))", "b != 0 and re(b) == 0"),
    ("entry(u, 3)", f"{ACROSS} and entry(u, 2) == 0"), ("1 - entry(u, 1)**2", "entry(u, 3) != 0"),
    ("x**2 + y**2", "not (x == 0 and y == 0)"), ("1 + norm(R*v + S*w)**2", ""), ("1 + norm(q*b*p)**3", ""),
    ("cos(pi/3) - 1/4", ""), ("sum(i, 1, 2, 1/i + x**2)", ""), ("1 + norm(x*v)**2 + rate(x)**2", ""),
]  # fmt: skip
"""Divisors with a domain that keeps them from 0."""
OPEN = [
    ("tan(a/2)", "0 <= tan(a/2)"), ("norm(v) + entry(v, 3)", BALL), ("x", "cos(x/2) != 0"), ("x", "sin(x) != 1"),
    ("norm(b + h)", "b + h != 0"), ("c + d - 5", "c + d != 5"), ("norm(du(b))", "b != 0"),
    ("entry(u, 3)", ACROSS), ("entry(u, 3)", f"{ACROSS} and entry(u, 3)*entry(u, 2) == 0"),
    ("1 - entry(u, 1)**2", "entry(u, 1) != 0"), ("x**2 + y", "not (x == 0 and y == 0)"),
    ("c**2 + d**2", "not (c == 0 and d == 0)"), ("1 + q", ""), ("norm(v) + norm(w)", ""), ("R - S", "R - S != 0"),
    ("cos(pi/3) - 1/2", ""), ("sin(pi/4) - sqrt(2)/2", ""), ("sum(i, -1, 1, i + x**2)", ""),
    ("1 + norm(x*v)**3 + rate(x)**2", ""),
]  # fmt: skip
"""Divisors that are 0, or whose real part is, somewhere in a domain."""
FIRST, SECOND = "Q*vector(1, 0, 0)", "Q*vector(0, 1, 0)"
AT_REST = [
    f"dot({FIRST}, {SECOND}) == 0", f"norm({FIRST} + b)**2 == 1 + norm(b)**2 + 2*dot({FIRST}, b)",
    f"norm(re({FIRST}) + v)**2 == 1 + norm(v)**2 + 2*dot(re({FIRST}), v)", f"du(dot({FIRST}, {SECOND})) == 0",
]  # fmt: skip
"""Claims that are true for every frame Q if they are for one."""
TURNING = [
    f"du(dot({FIRST}, v)) == 0", f"norm(du({FIRST})) == 0", f"dot({FIRST}, re({SECOND})) == 0",
    f"re({FIRST}) == {FIRST}", f"dot({FIRST}, re(b)) == dot({FIRST}, b)", f"entry({FIRST}, 1) == 1",
    f"norm({FIRST} - vector(1, 0, 0)) == 0", f"dot({FIRST}, Q*b) == dot({FIRST}, b)", "trace(Q) == 3",
    f"rate({FIRST}) == 0*({FIRST})", f"{FIRST} == inverse(Q)*vector(1, 0, 0)",
]  # fmt: skip
"""Claims that are true for the identity and not for every frame Q."""


def of(text: str, domain: str = "") -> Claim:
    (entry,) = claim_alone(text, LETTERS, domain=domain).entries()
    return _premised(Claim(entry, entry.readings[0].statement))


def undecided(number: str, domain: str) -> bool:
    claim = of(f"inverse({number}) == inverse({number})", domain)
    return any(undecided_parts(part) for part in split(claim))


@pytest.mark.parametrize(("number", "domain"), APART)
def test_domain_keeps_a_divisor_from_0(number: str, domain: str) -> None:
    assert not undecided(number, domain)


@pytest.mark.parametrize(("number", "domain"), OPEN)
def test_divisor_that_is_0_somewhere_stays_open(number: str, domain: str) -> None:
    assert undecided(number, domain)


@pytest.mark.parametrize("text", AT_REST)
def test_frame_of_constant_directions_is_at_rest(text: str) -> None:
    assert "Q" not in {letter.name for letter in with_frames_at_rest(of(text))[0].letters}


@pytest.mark.parametrize("text", TURNING)
def test_frame_that_matters_is_not_at_rest(text: str) -> None:
    claim = of(text)
    assert with_frames_at_rest(claim)[0] == claim


ONE = {
    "identity(2)": ["zeros(2, 2)", "matrix([[0, x], [0, 0]])", "matrix([[0, c], [0, 0]])"], "identity(6)": ["ad(xi)"],
    "I": ["skew(v)", "zeros(3, 3)", "Q"], "identity(4)": ["T", "skew(xi)", "zeros(4, 4)"], "1": ["q", "c", "x", "0"],
}  # fmt: skip
"""Bases whose zeroth power is this, also those without an inverse."""
PROVED = [
    *((f"({base})**0 == {one}", f"({base})**0 == 2*{one}", "") for one, bases in ONE.items() for base in bases),
    *((f"{f}(pi/{m}) == {number}", f"{f}(pi/{m}) == 1/10**90 + {number}", "") for f, m, number in (
        ("cos", 3, "1/2"), ("sin", 4, "sqrt(2)/2"), ("tan", 8, "sqrt(2) - 1"), ("cot", 12, "2 + sqrt(3)"),
        ("cos", 5, "(1 + sqrt(5))/4"), ("sin", 5, "sqrt((5 - sqrt(5))/8)"), ("sin", 12, "(sqrt(6) - sqrt(2))/4"))),
    ("sin(a + 4*pi/3) + sin(a)/2 == -sqrt(3)/2*cos(a)", "sin(a + 4*pi/3) + sin(a)/2 == sqrt(3)/2*cos(a)", ""),
    ("4*cos(pi/9)**3 - 3*cos(pi/9) == cos(pi/3)", "4*cos(pi/9)**3 - 3*cos(pi/9) == cos(pi/5)", ""),
    ("1/(cos(pi/3) - 1/4) == 4", "1/(cos(pi/3) - 1/2) == 4", ""),
    ("sum(i, 0, 1, (x*identity(2))**i) == (1 + x)*identity(2)", "sum(i, 0, 1, (x*I)**i) == x*I", ""),
    ("sum(i, 1, 3, 1/factorial(i)) == 5/3", "sum(i, 0, 3, 1/factorial(i)) == 5/3", ""),
    ("all(i, 1, 2, x**(i - 1) == x**(i - 1))", "all(i, 1, 2, x**(i - 1) == x)", ""),
    ("sum(i, 1, 2, sum(j, i + 1, 3, 1/(i + j))) == 47/60", "sum(i, 1, 2, sum(i, i + 1, 3, 1/(i + i))) == 47/60", ""),
    ("product(i, 1, 2, 1/(x**2 + i)) == 1/(x**4 + 3*x**2 + 2)", "product(i, 1, 2, 1/(x**2 + i)) == 1/x**4", ""),
    ("sum(i, 5, 6, 1/(x + i)) == sum(i, 5, 6, 1/(i + x))", "sum(i, 5, 6, 1/(x + i)) == 1", "x != -5 and x != -6"),
    ("all(i, 0, 1, x**(i - 1) == x**i/x)", "all(i, 0, 1, x**(i - 1) == x**i)", "x != 0"),
    ("norm(x*v)**2 + rate(x) == x**2*dot(v, v) + rate(x)", "norm(x*v)**2 + rate(x) == x**2 + rate(x)", ""),
    ("rate(norm(x*b)**4) == rate(x**4*dot(b, b)**2)", "rate(norm(x*b)**4) == rate(x**4)", ""),
    ("rate(norm(v)) == dot(v, rate(v))/norm(v)", "rate(norm(v)) == norm(rate(v))", "norm(v) != 0"),
]  # fmt: skip
"""Claims that are true, false ones beside them, and the condition under which both sides have a value."""


@pytest.mark.parametrize(("true", "false", "condition"), PROVED)
def test_closed_values_are_proved_and_false_ones_beside_them_are_not(true: str, false: str, condition: str) -> None:
    found = decided(of(true))
    assert (found.certainty, found.found) == ("exact", condition)
    assert found.status is (Status.HOLDS_IF if condition else Status.HOLDS)
    assert not decided(of(false)).holds
