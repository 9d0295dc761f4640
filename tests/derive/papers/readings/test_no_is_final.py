"""What full enumeration finds is never excluded by a search that lists few readings of a stretch."""

from __future__ import annotations

import pytest

from derive.papers.language.notation import norm
from derive.papers.language.terms import Number, text
from derive.papers.readings.reach import Reach
from derive.papers.readings.stretches import Stretches
from derive.papers.readings.targets import UndecidedSearchError, scaled
from tests.derive.papers.readings.test_reach import ALONG, I, a, b, c, one, plus, side, skew, tilde, two, v

DISPLAYS = [
    (a, b, v), (a, v, b), (v, a, b), (v, a, v), (v, v, a), (a, v, v), (two, v, a), (v, two, a), (a, v, two),
    (a, b, v, c), (a, plus, v, b), (a, plus, v, two, b), (a, b, two, plus, v), (a, b, plus, c, v),
    (v, plus, a, v, b), (v, plus, a, v, plus, v), (a, plus, b, plus, c, plus, v), (a, Number(12), b),
    (b, v, tilde, two, I), (v, tilde, two, a, I), (I, plus, b, v, tilde, two), (I, plus, v, tilde, two, a),
    (I, v, tilde, a), (I, a, v, v), (I, v, a, v), (I, v, b, v, tilde), (I, plus, v, tilde, v, tilde),
    (I, v, tilde, two, v), (I, plus, v, plus, a, v, v), (I, a, b, v, tilde, two), (I, a, v, tilde, c, two),
    (a, I, v, v, tilde), (a, I, one, b, v, tilde), (a, v, tilde, v, tilde),
]  # fmt: skip
FEW = (1, 3, 8)


def name(tokens) -> str:
    return " ".join(token.mark.name if hasattr(token, "place") else text(token) for token in tokens)


def values(known: Stretches):
    """Every stretch as a number, a quaternion or a vector, or a tensor, with what it can be."""
    end = len(known.side.tokens)
    kinds = (1, 2) if known.side.quaternions else (1, 2, 3)
    return [((i, j), known.listed(i, j, n)) for i in range(end) for j in range(i + 1, end + 1) for n in kinds]


@pytest.mark.parametrize("tokens", DISPLAYS, ids=name)
def test_a_reading_is_found_or_the_search_cannot_tell(tokens) -> None:
    found = values(Stretches(side(tokens, 100_000), ALONG))
    for few in FEW:
        for short in (0, len(tokens) - 1):
            reach = Reach(side(tokens, few), ALONG, short)
            for (i, j), listed in found:
                for target in listed:
                    try:
                        assert reach.can(i, j, target), (few, short, i, j, target)
                    except UndecidedSearchError:
                        continue


KINDS = [
    ((a, b, v), a / (b - v)), ((a, v, b), (a - v) * b),
    ((b, v, tilde, two, I), skew(b * v) ** 2 - I), ((v, tilde, two, a, I), skew(v) / (two * a) - I),
    ((I, plus, b, v, tilde, two), I + skew(b * v) ** 2),
    ((a, I, one, b, v, tilde), (a * I) ** Number(-1) - skew(b * v)),
    ((a, Number(12), b), a ** Number(12) - b),
]  # fmt: skip


@pytest.mark.parametrize(("tokens", "reading"), KINDS, ids=[text(reading) for _, reading in KINDS])
def test_each_kind_is_found_where_its_parts_are_listed(tokens, reading) -> None:
    reach = Reach(side(tokens, 1), ALONG, len(tokens) - 1)
    target = reach.stretches.target(reach.stretches.side.env.value(reading))
    assert reach.stretches.known(0, len(tokens), len(target)) is None
    assert reach.can(0, len(tokens), target)
    assert not reach.can(0, len(tokens), scaled(7, target))


def test_a_norm_is_known_where_all_readings_are() -> None:
    reach = Reach(side((a, b, v), 1), ALONG)
    target = reach.stretches.target(reach.stretches.side.env.value(norm(a - b * v)))
    assert reach.stretches.listed(0, 3, 2) is None
    assert reach.can(0, 3, target)
    assert not reach.can(0, 3, scaled(7, target))


def test_the_norm_of_a_long_quaternion_is_not_decided() -> None:
    with pytest.raises(UndecidedSearchError, match="the norm of a long quaternion"):
        Reach(side((a, b, v), 1), ALONG, 2).can(0, 3, (49,))
