"""Table of operators with their traits; equality of values, and their printed components."""

from __future__ import annotations

import pytest

from derive.algebra import Dual, Vector
from derive.claims.language import values
from derive.claims.language.operator_table import Re, epsilon, equal, implies, nonzero, norm, sin, tan
from derive.claims.language.printed import Apply, Symbol, Trait, latex, shown_as, symbols, takes_apart, with_trait
from derive.claims.numbers.kinds import KINDS, QUANTITIES
from derive.papers import PAPERS

a, b, r = Symbol("a", "dual number"), Symbol("b", "dual number"), Symbol("r", "real")


def statements(entry):
    return [*(reading.statement for reading in entry.readings), *filter(None, (entry.corrected, entry.because))]


def test_function_of_a_paper_is_printed_as_there() -> None:
    assert latex(shown_as(tan(a), {"tan": r"\operatorname{Tan} #1"})) == r"\operatorname{Tan} a"


def test_operators_with_separate_real_and_dual_parts() -> None:
    assert takes_apart(equal(Re(a), b))
    assert takes_apart(equal(a, b + epsilon * b))
    assert takes_apart(equal(a, r))
    assert not takes_apart(equal(norm(a), sin(b)))


def test_delicate_operators_are_found_with_their_symbols() -> None:
    (found,) = with_trait(Trait.DELICATE, equal(a, b) + nonzero(b))
    assert symbols(found) == (b,)
    assert len(with_trait(Trait.DELICATE, implies(nonzero(a), equal(a, b)))) == 2


def test_unknown_operators_and_quantities_are_refused() -> None:
    with pytest.raises(ValueError, match="no operator 'sine'"):
        Apply("sine", a)
    with pytest.raises(ValueError, match="no quantity 'scalar': expected order, branch"):
        Symbol("a", "scalar")


def test_every_quantity_is_used_and_names_are_unique_in_an_entry() -> None:
    used = set()
    for entry in (entry for paper in PAPERS for entry in paper.entries()):
        parts = [*statements(entry), *filter(None, (entry.claimed, entry.condition))]
        found = {symbol for part in parts for symbol in symbols(part)}
        assert len({symbol.name for symbol in found}) == len(found), entry.number
        used |= {symbol.quantity for symbol in found}
    assert {row for row in QUANTITIES.values() if row.name not in KINDS} <= used


# --- values -----------------------------------------------------------------------------------------------------------


def test_numbers_of_a_dual_vector_have_the_real_part_first() -> None:
    v = Vector(Dual(1, 4), Dual(2, 5), Dual(3, 6))
    assert list(values.coefficients(v)) == [1, 2, 3, 4, 5, 6]
    assert list(values.coefficients(Dual(v.dot(v).re, 7))) == [14, 7]
