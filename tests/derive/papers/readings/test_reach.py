"""What a side can be is the same whether its readings are listed or looked for one by one."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import pytest

from derive.algebra import Dual, Tensor, Vector
from derive.papers.language.evaluation import Env
from derive.papers.language.notation import dot, dyad, skew
from derive.papers.language.terms import MARKS, Letter, Number, Term, text
from derive.papers.numbers.residues import PRIME, Reduced
from derive.papers.readings.reach import Reach
from derive.papers.readings.search import Side
from derive.papers.readings.stretches import Stretches
from derive.papers.readings.targets import UndecidedSearchError, scaled
from derive.papers.readings.tokens import Place, Token

v = Letter("v", "dual vector")
a, b, c, d = (Letter(name, "dual number") for name in "abcd")
I = Letter("I", "identity")
n, f = Letter("n", "order"), Letter("f", "function")
plus, tilde = Token(mark=MARKS["plus"], place=Place.BETWEEN), Token(mark=skew, place=Place.AFTER)
one, two, three = Number(1), Number(2), Number(3)
POINT = Reduced([v, a, b, c, d], dual=False, moving=False)
SHORT = 0
"""No stretch is so short that all its values are known."""
ALONG = POINT.values[v].c1.value
"""The vector lies along the first axis."""


def side(tokens: tuple[Term | Token, ...], cap: int = 10_000) -> Side:
    """What has I is a tensor, so that numbers and vectors make no quaternions."""
    env = Env(POINT.field, {**POINT.values, n: 7, f: lambda x: x * x + 1}, {}, POINT.dual, POINT.moving)
    marks = [token if isinstance(token, Token) else Token(token) for token in tokens]
    return Side(marks, env, radicals=False, quaternions=I not in tokens, cap=cap)


def spans(whole: Stretches) -> Iterator[tuple[int, int, int]]:
    """Every stretch as a number, and as what the whole side is."""
    end = len(whole.side.tokens)
    kinds = {1, 3 if not whole.side.quaternions else 1 if v not in [token.term for token in whole.side.tokens] else 2}
    return ((i, j, n) for i in range(end) for j in range(i + 1, end + 1) for n in kinds)


LISTED = [
    ((a, b, c), 1), ((a, b, c, d), 3), ((a, b, c, d), 16), ((a, two, b), 1), ((a, two, three, b), 20),
    ((a, b, plus, c, d), 3), ((a, b, plus, c, d), 8), ((a, plus, b, two, c), 1), ((a, b, two, plus, c), 1),
    ((a, plus, b, plus, two, c), 1), ((two, a, plus, three, b), 3), ((one, a, b), 1), ((a, a, b), 1), ((a, a, b), 3),
    ((a, I, v, tilde), 2), ((a, b, I, v, tilde), 3),
    ((a, I, plus, b, v, tilde), 1), ((I, plus, a, b, v, tilde), 1), ((I, plus, a, b, v, tilde), 4),
    ((a, b, I, plus, v, tilde), 1), ((a, I, plus, v, tilde), 1), ((I, plus, v, tilde, a), 1),
    ((I, plus, a, v, tilde, b), 1), ((two, a, I, plus, v, tilde, b), 1), ((two, a, I, plus, v, tilde, b), 5),
    ((I, plus, a, v, tilde, plus, v, tilde, two), 1), ((a, I, plus, b, v, tilde, plus, c, v, tilde, two), 4),
    ((two, I, plus, a, v, tilde, plus, b, v, tilde, two), 5),
]  # fmt: skip
"""Tokens, and so few readings of a stretch that longer ones are not listed."""


@pytest.mark.parametrize(("tokens", "few"), LISTED)
def test_what_is_listed_is_found_where_it_is_not(tokens, few: int) -> None:
    known, reach = Stretches(side(tokens), ALONG), Reach(side(tokens, few), ALONG, SHORT)
    opened = [span for span in spans(known) if reach.stretches.listed(*span) is None]
    assert opened
    for i, j, n in opened:
        values = known.listed(i, j, n)
        assert values is not None
        assert all(reach.can(i, j, value) for value in values)
        wrong = {*(tuple((x + 5) % PRIME for x in t) for t in values), *(scaled(7, t) for t in values)}
        wrong |= {tuple(7 * x % PRIME if k == m else x for k, x in enumerate(t)) for m in range(n) for t in values}
        assert not any(reach.can(i, j, value) for value in wrong - values.keys())


@pytest.mark.parametrize(("tokens", "few"), LISTED)
def test_components_are_those_of_the_values(tokens, few: int) -> None:
    known, stretches = Stretches(side(tokens), ALONG), Stretches(side(tokens, few), ALONG, SHORT)
    for i, j, n in spans(known):
        values = known.listed(i, j, n)
        assert values is not None
        other = {k for value in values for k, component in enumerate(value) if component}
        assert stretches.support(i, j, n) == (other or ({0} if values else set()))
        inside = [(p, q, 1) for p in range(i, j) for q in range(p + 1, j + 1)]
        numbers = n > 1 and all(stretches.listed(*part) is not None for part in inside if known.listed(*part))
        for k in range(n):
            found = stretches.listed_component(i, j, k, n)
            assert found is not None or not numbers
            if found is not None:
                assert found - {0} == {value[k] for value in values} - {0}


QUATERNIONS = [
    ((a, b, plus, c, v), 3, (a * b + c * v, a / b + c * v, a * (b + c * v), a / b + (c - v))),
    ((a, b, v), 3, ((a - b) * v, a * b - v, a - b * v, a / b * v, a / b - v, a * (b - v))),
    ((two, v, a), 5, (two * v / a, two * (v - a), (two - v) / a, two - v / a)),
    ((a, plus, v, b), 3, (a + v / b, (a + v) / b, a + (v - b))),
]  # fmt: skip


@pytest.mark.parametrize(("tokens", "few", "readings"), QUATERNIONS)
def test_numbers_beside_vectors_are_found(tokens, few: int, readings) -> None:
    reach = Reach(side(tokens, few), ALONG, SHORT)
    whole = (0, len(reach.stretches.side.tokens))
    assert reach.stretches.listed(*whole, 2) is None
    for reading in readings:
        target = reach.stretches.target(reach.stretches.side.env.value(reading))
        assert len(target) == 2
        assert reach.can(*whole, target), text(reading)
        assert not reach.can(*whole, (target[0], 7 * target[1] % PRIME)), text(reading)
        assert not reach.can(*whole, ((target[0] + 5) % PRIME, target[1])), text(reading)


def test_two_long_parts_of_a_sum_are_found_one_by_one() -> None:
    reach = Reach(side((a, b, I, plus, c, d, v, tilde), 2), ALONG, SHORT)
    assert reach.stretches.listed(0, 3, 3) is reach.stretches.listed(4, 8, 3) is None
    target = reach.stretches.target(reach.stretches.side.env.value(a * b * I + c * d * skew(v)))
    assert reach.can(0, 8, target)
    for k in (0, 1):
        assert not reach.can(0, 8, tuple(7 * x % PRIME if k == m else x for m, x in enumerate(target)))


# ---- what is known of stretches --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("tokens", "few", "n"),
    [((a, I, v, tilde), 2, 3), ((a, b, I, v, tilde), 3, 3)],
)
def test_components_are_known_where_one_factor_is_a_multiple_of_the_unit(tokens, few: int, n: int) -> None:
    stretches = Stretches(side(tokens, few), ALONG, SHORT)
    whole = (0, len(tokens))
    assert stretches.listed(*whole, n) is None
    assert None not in [stretches.listed_component(*whole, k, n) for k in range(n)]


@pytest.mark.parametrize(
    ("tokens", "units"),
    [((a, plus, v), (one, v)), ((I, v, v), (I, skew(v), dyad(v, v))), ((I, v, tilde, two), (I, skew(v), skew(v) ** 2))],
)
def test_components_of_products_are_those_of_the_units(tokens, units) -> None:
    stretches = Stretches(side(tokens), ALONG)
    value, n = stretches.side.env.value, len(units)
    parts = [stretches.target(value(unit)) for unit in units[1:]]
    assert [[k for k, c in enumerate(part) if c] for part in parts] == [[k] for k in range(1, n)]
    for i, j in product(range(1, n), repeat=2):
        target = stretches.target(value(units[i] * units[j]))
        target = target if len(target) == n else (*target, 0)
        assert stretches.closed(frozenset({i}), frozenset({j}), n) == {k for k, c in enumerate(target) if c}
        assert stretches.closed(frozenset({0}), frozenset({j}), n) == {j}


@pytest.mark.parametrize(
    ("value", "target"),
    [(a, ("a",)), (two, (2,)), (a * v, (0, "a")), (b + a * v, ("b", "a")), (a * I, ("a", 0, 0)),
     (a * I - b * skew(v), ("a", "-b", 0)), (a * dyad(v, v), (0, 0, "a")),
     (I + a * skew(v) + b * dyad(v, v), (1, "a", "b"))],
)  # fmt: skip
def test_targets_are_the_components_along_the_vector(value: Term, target) -> None:
    stretches = Stretches(side((I, v, v)), ALONG)
    letters = {"a": POINT.values[a].value, "b": POINT.values[b].value, "-b": -POINT.values[b].value % PRIME}
    assert stretches.target(stretches.side.env.value(value)) == tuple(letters.get(part, part) for part in target)


# ---- what is not decided ---------------------------------------------------------------------------------------------


def test_the_shorter_of_two_stretches_is_asked_first(monkeypatch) -> None:
    reach, asked = Reach(side((a, b, c, d)), ALONG), []
    monkeypatch.setattr(reach, "can", lambda i, j, target: asked.append((i, j)) is None)
    assert reach._both((0, 1, (1,)), (1, 4, (1,)))
    assert reach._both((0, 3, (1,)), (3, 4, (1,)))
    assert asked == [(0, 1), (1, 4), (3, 4), (0, 3)]


def test_two_long_stretches_of_one_sum_are_not_decided() -> None:
    with pytest.raises(UndecidedSearchError, match="two long stretches with the same components"):
        Reach(side((a, b, plus, c, d), 1), ALONG, SHORT).can(0, 5, (7,))


def test_a_long_stretch_with_another_mark_is_not_decided() -> None:
    with pytest.raises(UndecidedSearchError, match="a long stretch with dot"):
        Reach(side((a, b, Token(mark=dot, place=Place.BETWEEN), c, d), 1), ALONG, SHORT).can(0, 5, (7,))


def test_a_search_that_takes_too_long_is_given_up() -> None:
    reach = Reach(side((a, b, c), 1), ALONG, SHORT)
    reach.left = 1
    with pytest.raises(UndecidedSearchError, match="too many stretches"):
        reach.can(0, 3, (7,))


@pytest.mark.parametrize(
    ("value", "reason"),
    [(Vector(1, 2, 0), "more than one direction"), (Tensor.skew(Vector(0, 1, 0)), "more than one direction"),
     (Tensor.identity() * Dual(1, 2), "a dual tensor"), (Dual(1, 2), "a value with dual parts"),
     (Vector(Dual(1, 2), 0, 0), "a value with dual parts")],
)  # fmt: skip
def test_values_in_more_directions_are_no_targets(value, reason: str) -> None:
    with pytest.raises(UndecidedSearchError, match=reason):
        Stretches(side((I, v)), ALONG).target(value)
