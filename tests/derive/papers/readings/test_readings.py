"""All readings of a display: what is put in, what is counted, and that no status rests on which reading is listed."""

from __future__ import annotations

import sys
from dataclasses import replace

import pytest

from derive.papers import PAPERS, Reading, Status, UndecidedError
from derive.papers.condurache_popa_2023.alphabet import LOST, v
from derive.papers.condurache_popa_2023.sections import s09a_orders_1_to_3 as section
from derive.papers.condurache_popa_2023.sections.s07_general_order import VV, I, V, x
from derive.papers.decide import decide
from derive.papers.equation import Equation, equation
from derive.papers.language import values
from derive.papers.language.notation import equal, norm, skew
from derive.papers.language.terms import Letter, text
from derive.papers.readings import enumeration
from derive.papers.readings.enumeration import Readings, UnreadableError, read
from derive.papers.readings.tokens import surviving

a, b, c = (Letter(name, "dual number") for name in "abc")
ENTRIES = {entry.number: entry for entry in PAPERS[0].entries()}


def entry(number: str, **changes) -> Equation:
    return replace(ENTRIES[number], **changes)


# ---- what is put in --------------------------------------------------------------------------------------------------


def test_a_difference_of_products_has_all_its_bracketings() -> None:
    found = read(equation("1", "title", 1, equal(a, b - c)), LOST)
    assert found.complete
    assert found.true == ()
    assert found.count == 6  # b c, b − c, b/c, and their opposites


def test_equal_sides_are_found_with_the_fewest_marks() -> None:
    found = read(equation("1", "title", 1, equal((a - b) * (a - b), a**2 - 2 * a * b + b**2)), LOST)
    assert found.true or not found.complete


@pytest.mark.parametrize("number", ["14", "45", "50", "88", "96", "97", "102", "103", "104"])
def test_displays_with_a_second_reading_have_it(number: str) -> None:
    assert read(ENTRIES[number], LOST, search=False).count > 1


def test_the_order_of_listed_readings_changes_nothing() -> None:
    first, second = ENTRIES["30"].readings
    swapped = entry("30", readings=(second, first))
    assert decide("paper", swapped, LOST).status is decide("paper", ENTRIES["30"], LOST).status is Status.HOLDS


def test_signs_are_tokens_that_survive_only_where_they_do() -> None:
    tokens = surviving(I + skew(v) - VV, LOST)
    assert [t.mark.name if t.mark else text(t.term) for t in tokens] == ["I", "plus", "v", "skew", "v", "v"]


def test_reading_twice_gives_the_same() -> None:
    assert read(ENTRIES["96"], LOST) == read(ENTRIES["96"], LOST)


def test_a_claim_in_words_has_no_readings_to_put_together() -> None:
    with pytest.raises(UnreadableError):
        read(ENTRIES["44-domain"], LOST)


# ---- holes that must stay closed -------------------------------------------------------------------------------------

false_104 = equal(section.o2.dcay, 4 / (1 + x) ** 2 * (1 - x) * I + 2 * V + 2 * VV)


def test_a_true_equation_listed_by_a_false_reading_is_no_erratum() -> None:
    listed = entry("104", readings=(Reading(false_104),), corrected=ENTRIES["104"].readings[0].statement)
    result = decide("paper", listed, LOST)
    assert result.status is Status.HOLDS
    assert [verdict.true for verdict in result.verdicts] == [True, False]


def test_a_correction_that_the_surviving_marks_allow_is_refused(monkeypatch) -> None:
    module = sys.modules["derive.papers.decide"]
    monkeypatch.setattr(module, "read", lambda *_: Readings(1, True, ()))
    listed = entry("104", readings=(Reading(false_104),), corrected=ENTRIES["104"].readings[0].statement)
    with pytest.raises(UndecidedError, match="the correction is a reading of line 431"):
        decide("paper", listed, LOST)


def test_poles_come_from_the_formula_itself() -> None:
    with pytest.raises(UndecidedError, match="the correction is false"):
        decide("paper", entry("112", condition=None, also=None), LOST)


def test_no_magnitude_is_taken_for_granted(monkeypatch) -> None:
    monkeypatch.setattr(values, "norm", lambda field, value: 7)
    assert norm.name == "norm"
    with pytest.raises(UndecidedError, match="supporting identity is not proved"):
        decide("paper", ENTRIES["magnitude-square"], LOST)


def test_too_many_readings_never_make_an_erratum(monkeypatch) -> None:
    monkeypatch.setattr(enumeration._Chain, "_misses", lambda *_: False)
    assert decide("paper", ENTRIES["111"], LOST).status is Status.AMBIGUOUS


def test_a_legible_place_for_a_false_reading_makes_it_ambiguous() -> None:
    first, second = ENTRIES["30"].readings
    supported = replace(first, supported_by="line 172")
    assert decide("paper", entry("30", readings=(supported, second)), LOST).status is Status.AMBIGUOUS
