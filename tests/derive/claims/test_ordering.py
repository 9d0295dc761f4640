"""Proof of order relations: those that touch equality are proved, and neither strictly nor with less room."""

from __future__ import annotations

import pytest

from derive.claims.deciding.claim import Claim
from derive.claims.deciding.existence import undecided_parts
from derive.claims.deciding.ordering import ordered
from derive.claims.sheet import claim_alone
from tests.support.claims_of_known_truth import used

BALLS = "norm(v) <= 2 and norm(w) <= 3"
UNIT = "0 <= x and x <= 1 and 0 <= y and y <= 1"
TOUCHING = {
    # both sides are equal somewhere in the domain, often at one point or corner alone
    ("norm(v + 2*w)", "8"): BALLS, ("dot(v, w)", "6"): BALLS,
    ("-dot(v, w)", "6"): BALLS, ("norm(cross(v, w))", "6"): BALLS, ("norm(v)*norm(w)", "6"): BALLS,
    ("norm(v + w)**2", "2*norm(v)**2 + 2*norm(w)**2"): "", ("dot(v, w)", "norm(v)*norm(w)"): "",
    ("norm(v) - norm(w)", "norm(v - w)"): "", ("norm(norm(v) - norm(w))", "norm(v - w)"): "",
    ("dot(u, cross(v, w))", "norm(u)*norm(v)*norm(w)"): "", ("norm(x*v)", "2*norm(v)"): "norm(x) <= 2",
    ("norm(R*v)", "2"): BALLS, ("norm(R*v + w)", "5"): BALLS,
    ("entry(v, 1) + entry(v, 2)", "2*sqrt(2)"): BALLS, ("0", "acos(x)"): "norm(x) <= 1",
    ("entry(v, 1)", "2"): BALLS, ("-entry(v, 3)", "2"): BALLS,
    ("entry(v, 1)**2", "dot(v, v)"): "",
    ("trace(R)", "3"): "", ("-trace(R)", "1"): "", ("entry(R, 1, 2)", "1"): "", ("norm(entry(R, 1, 1))", "1"): "",
    ("entry(e, 3)", "1"): "", ("-entry(e, 3)", "1"): "", ("dot(e, v)", "norm(v)"): "",
    ("-trace(R) - entry(e, 3)", "2"): "",
    ("x*y", "1"): UNIT, ("x + 2*y", "3"): UNIT, ("x**2*y + x*y**2", "2"): UNIT, ("x*(1 - x)*y*(1 - y)", "1/16"): UNIT,
    ("x*(1 - x)", "1/4"): "", ("2*x*y", "x**2 + y**2"): "", ("1 + 3*x", "(1 + x)**3"): "x >= -3",
    ("4*s", "(1 + s)**2"): "",
    ("x**3 - 3*x", "2"): "norm(x) <= 2", ("3*x*y*s", "x**3 + y**3 + s**3"): "x >= 0 and y >= 0",
    ("2", "s + 1/s"): "", ("sqrt(x*y)", "(x + y)/2"): "x >= 0 and y >= 0", ("sqrt(1 + x)", "1 + x/2"): "x >= -1",
    ("sin(x)", "1"): "", ("sin(x)*cos(x)", "1/2"): "", ("sin(x) + cos(x)", "sqrt(2)"): "", ("sin(x)*sin(y)", "1"): "",
    ("cos(x)**2*sin(y)", "1"): "", ("1/2", "cos(a)"): "norm(a) <= pi/3", ("sin(x)", "x"): "x >= 0",
    ("norm(sin(x))", "norm(x)"): "", ("x - x**3/6", "sin(x)"): "x >= 0", ("1 - x**2/2", "cos(x)"): "",
    ("1 + x", "exp(x)"): "", ("1", "cosh(x)"): "", ("1 + x**2/2", "cosh(x)"): "", ("x", "sinh(x)"): "x >= 0",
    ("exp(-x**2)", "1"): "", ("log(s)", "s - 1"): "", ("log(1 + x)", "x"): "x > -1", ("tanh(x)", "x"): "x >= 0",
    ("atan(x)", "x"): "x >= 0", ("2*x/pi", "sin(x)"): "0 <= x and x <= pi/2",
}  # fmt: skip
APART = ("tanh(x) < 1", "acos(tanh(x)) > 0", "1 + exp(-x**2) > 1", "x**4 + y**4 + 1 > 2*x*y", "log(1 + exp(x)) > x",
         "exp(x) > x",
         "trace(R) + entry(e, 3) > -3", "norm(v) + 1 > 0", "exp(x) != 0", "norm(v)**2 + x**2 + 1 != 0")  # fmt: skip
"""Relations whose sides are never equal, some at no distance."""
FALSE = ("sqrt(4*x**2 - x**4) >= sqrt(3) | norm(x) <= 1", "tan(x) >= x | x >= 0", "norm(x) >= 2 | norm(x) <= 2",
         "sqrt(x**2*(1 + x**2)) >= 2*x**2 | norm(x) <= 1",
         "1/(1 - x) >= 1 | x >= 0", "atan2(x - 1, x - 2) <= 3 | x >= 0", "norm(x - 1) + norm(x) > 1",
         "norm(v) + norm(w) > 0",
         "2 + entry(e, 3) + trace(R) > 0", "norm(v) - entry(v, 3) > 0", "norm(cross(v, w)) + norm(v - w) > 0",
         "sqrt(x**2 + y**2) > 0", "x*log(s) >= x*(s - 1)",
         "norm(v + w + u) > 0", "norm(v)*norm(w) - dot(v, w) > 0", "exp(x**2) > 1", "exp(s*x) >= 1")  # fmt: skip
"""Relations that are false at some places, some beyond a jump or where letters in polar form have no value."""
VANISHING = ("1 + entry(e, 3) + norm(v)", "trace(R) + 1 + norm(v)", "3 - trace(R) + norm(v)", "norm(v) + norm(w)",
             "norm(cross(v, w)) + norm(v)", "norm(v) + dot(e, v)", "x**2 + norm(v)", "scalar(q) + 1 + norm(v)",
             "2 + entry(e, 3) + entry(u/norm(u), 3)", "norm(v) - entry(v, 3)")  # fmt: skip
"""Numbers that are 0 where several letters are special at once, or in a direction that polar forms leave out."""
APART_FROM_0 = ("1 + exp(x)*norm(v)", "s + norm(v)", "dot(v, v) + dot(w, w) + 1", "4 + trace(R) + entry(e, 3)")


def of(text: str, domain: str = "") -> Claim:
    (entry,) = claim_alone(text, used(text + domain), domain=domain).entries()
    return Claim(entry, entry.readings[0].statement)


@pytest.mark.parametrize(("sides", "domain"), TOUCHING.items(), ids=str)
def test_relations_that_touch_are_proved_and_no_more(sides: tuple[str, str], domain: str) -> None:
    a, b = sides
    assert ordered(of(f"{a} <= {b}", domain))
    assert not ordered(of(f"{a} < {b}", domain))


@pytest.mark.thorough
@pytest.mark.parametrize(("sides", "domain"), TOUCHING.items(), ids=str)
@pytest.mark.parametrize("more", ["!= {}", "<= {} - 1/10**9", ">= {}"])
def test_relations_with_less_room_are_not_proved(sides: tuple[str, str], domain: str, more: str) -> None:
    assert not ordered(of(f"{sides[0]} {more.format(sides[1])}", domain))


@pytest.mark.parametrize("text", APART)
def test_relations_whose_sides_are_never_equal_are_proved(text: str) -> None:
    assert ordered(of(text))


@pytest.mark.parametrize("text", FALSE)
def test_relations_that_are_false_somewhere_are_not_proved(text: str) -> None:
    claim, _, domain = text.partition(" | ")
    assert not ordered(of(claim, domain))


@pytest.mark.parametrize("number", VANISHING)
def test_numbers_that_vanish_where_several_letters_are_special_are_not_proved_to_be_divisors(number: str) -> None:
    assert undecided_parts(of(f"1/({number}) == 1/({number})"))


@pytest.mark.parametrize("number", APART_FROM_0)
def test_numbers_that_vanish_nowhere_are_proved_to_be_divisors(number: str) -> None:
    assert not undecided_parts(of(f"1/({number}) == 1/({number})"))
