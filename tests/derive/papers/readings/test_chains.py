"""What a display says in all its readings: how many, whether none was left out, and the true one with fewest marks."""

from __future__ import annotations

import gc

import pytest

from derive.papers.condurache_popa_2023.alphabet import LOST
from derive.papers.equation import Equation, equation
from derive.papers.language.evaluation import let
from derive.papers.language.notation import both, equal, nonzero, pm, remark, root, words
from derive.papers.language.terms import Letter, Term
from derive.papers.readings import enumeration
from derive.papers.readings.enumeration import Readings, UnreadableError, read
from derive.papers.readings.search import CAP, Side

a, b, c, d = (Letter(name, "dual number") for name in "abcd")
u, v = (Letter(name, "dual vector") for name in "uv")
x, y = (Letter(name, "number") for name in "xy")
WHERE = (
    let(x, lambda env, a, b: a / b, a, b),
    let(y, lambda env, a, b, c: (a - b) * c, a, b, c),
)


def entry(statement: Term, **rest: object) -> Equation:
    return equation("1", "title", 1, statement, where=WHERE, **rest)


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    """Sides with more than four readings are not listed."""
    monkeypatch.setattr(enumeration, "Side", lambda *rest: Side(*rest[:4], *rest[4:] or (4,)))
    monkeypatch.setattr(enumeration, "LISTED", 4)


@pytest.mark.parametrize(
    ("statement", "count", "true"),
    [(equal(a, b - c), 6, None), (equal(a, b), 1, None), (equal(a, a), 1, equal(a, a)),
     (equal(x, a * b), 6, equal(x, a / b)), (equal(x, a / b, a - b), 36, equal(x, a / b, a / b)),
     (equal(a * b, a - b), 36, equal(a * b, a * b)), (equal(x, pm(a - b)), 3, equal(x, pm(a / b))),
     (equal(pm(x), a / b), 6, equal(pm(x), a / b)),
     (remark(equal(x, a * b), words("", "")), 6, equal(x, a / b)),
     (both(equal(x, a * b), equal(a, b - c)), 36, None),
     (both(equal(x, a * b), equal(y, a - b - c)), 6 * 28, both(equal(x, a / b), equal(y, (a - b) * c))),
     (equal(v, a * v), 10, None)],
    ids=str,
)  # fmt: skip
def test_a_display_is_read_in_so_many_ways(statement: Term, count: int, true: Term | None) -> None:
    assert read(entry(statement), LOST) == Readings(count, True, () if true is None else (true,))


def test_no_more_readings_are_counted_than_the_cap() -> None:
    assert read(entry(equal(a * b * c * d, a * b * c * d)), LOST).count == CAP
    assert read(entry(both(equal(a * b * c, a * b * c), equal(y, a * b * c))), LOST).count == CAP


def test_radicals_are_put_in_where_a_listed_form_has_one() -> None:
    plain, statement = equal(a, b - c), equal(a, root(b - c))
    assert read(entry(plain), LOST).count == 6
    assert read(entry(statement), LOST).count == read(entry(plain, corrected=statement), LOST).count == 10


@pytest.mark.parametrize("statement", [nonzero(a), both(equal(a, b), nonzero(a)), equal(a, Letter("T", "map") * b)])
def test_what_is_no_chain_of_values_is_not_read(statement: Term) -> None:
    with pytest.raises(UnreadableError, match="1"):
        read(entry(statement), LOST)


def test_a_listed_reading_with_a_mark_that_is_not_put_in_is_not_read() -> None:
    with pytest.raises(UnreadableError, match="has a mark that is not put in"):
        read(entry(equal(a, 1 * b)), LOST)  # nobody prints that


# ---- beyond what is listed -------------------------------------------------------------------------------------------


@pytest.mark.usefixtures("few")
@pytest.mark.parametrize(
    ("statement", "complete"),
    [(equal(a, b * c), True), (equal(x, a * b), False), (equal(a * b, a * b), False), (equal(y, a * b * c), False),
     (equal(a, b * c, b - c), True), (both(equal(a, b * c), equal(x, a * b)), True),
     (both(equal(x, a * b), equal(a, b * c)), True), (both(equal(x, a * b), equal(y, a * b * c)), False),
     (both(equal(a, b), equal(x, a * b)), True), (both(equal(a, a), equal(x, a * b)), False),
     (equal(a, pm(b * c * d)), True), (equal(y, pm(a * b * c)), False), (equal(a + b, b * c), True),
     (equal(-x, a * b), False), (equal(v, a * v), True), (equal(u, a * v), False)],
    ids=str,
)  # fmt: skip
def test_a_side_that_is_not_listed_is_searched_for_what_the_others_are(statement: Term, complete: bool) -> None:
    found = read(entry(statement), LOST)
    assert (found.complete, found.true) == (complete, ())
    assert not read(entry(statement), LOST, search=False).complete


@pytest.mark.usefixtures("few")
def test_a_side_that_is_not_listed_counts_as_the_cap() -> None:
    assert read(entry(equal(a, b * c)), LOST).count == 4
    assert read(entry(equal(a * d, b * c)), LOST).count == 16


def test_the_collector_is_as_it_was_before() -> None:
    for switch in (gc.disable, gc.enable):
        switch()
        before = gc.isenabled()
        read(entry(equal(a, b)), LOST)
        assert gc.isenabled() is before
