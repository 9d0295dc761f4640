"""The table of kinds: what letters stand for at points, and at generic values of an exact field."""

from __future__ import annotations

import mpmath
import pytest

from derive.papers.language.terms import Letter
from derive.papers.numbers.draw import Draw
from derive.papers.numbers.fields import DIGITS, Decimal60
from derive.papers.numbers.generic import Generic
from derive.papers.numbers.kinds import KINDS
from derive.proof.ratio import NotExactError

DRAWN = [kind for kind in KINDS.values() if kind.draw is not None]
EXACT = [kind for kind in KINDS.values() if kind.exact is not None]


def test_draws_with_one_seed_are_equal() -> None:
    for kind in DRAWN:
        if kind is not KINDS["smooth function"]:
            assert kind.generic(Draw("s")) == kind.generic(Draw("s"))


def test_unit_draws_are_unit() -> None:
    with mpmath.workdps(DIGITS):
        field = Decimal60()
        for make in (KINDS["unit quaternion"].generic, *KINDS["unit quaternion"].special.values()):
            norm = make(Draw("unit")).norm2()
            assert field.same(norm.re, 1)
            assert field.same(norm.du, 0)


@pytest.mark.parametrize("kind", EXACT, ids=lambda kind: kind.name)
@pytest.mark.parametrize("dual", [False, True])
def test_a_generic_value_is_of_the_type_that_is_drawn(kind, dual: bool) -> None:
    letter = Letter("a", kind.name)
    value = Generic([letter], dual, moving=False).values[letter]
    drawn = kind.generic(Draw("type"))
    assert hasattr(value, "norm2") == hasattr(drawn, "norm2")
    assert hasattr(value, "dot") == hasattr(drawn, "dot")
    assert hasattr(value, "rows") == hasattr(drawn, "rows")


def test_only_drawn_kinds_are_exact_and_those_without_either_are_refused() -> None:
    assert set(DRAWN) - set(EXACT) == {KINDS["sign"]}
    assert set(EXACT) <= set(DRAWN)
    with pytest.raises(ValueError, match="a letter that is a map has no value of its own"):
        KINDS["map"].generic(Draw("s"))
    with pytest.raises(NotExactError, match="no generic map"):
        Generic([Letter("f", "map")], False, False)
