"""The committed 30-digit values: what the entries come to at their seeded points today."""

from __future__ import annotations

import mpmath
import pytest

from derive.papers import PAPERS, Paper
from derive.papers.witnesses import committed, witnesses


@pytest.fixture(scope="module", params=PAPERS, ids=lambda paper: paper.short)
def paper(request) -> Paper:
    return request.param


@pytest.fixture(scope="module")
def kept(paper) -> dict:
    return committed(paper)


@pytest.fixture(scope="module")
def found(paper) -> dict:
    return witnesses(paper)


def numbers(parts: list[str]) -> list:
    return [part if part in ("true", "false") else mpmath.mpf(part) for part in parts]


def close(a, b) -> bool:
    if isinstance(a, str) or isinstance(b, str):
        return a == b == "true"
    return abs(a - b) <= mpmath.mpf(10) ** -27 * (1 + abs(a))


def same(first: list[str], second: list[str]) -> bool:
    with mpmath.workdps(40):
        return len(first) == len(second) and all(map(close, numbers(first), numbers(second)))


def test_every_entry_has_a_witness(paper, kept) -> None:
    assert list(kept) == [entry.number for entry in paper.entries()]


def test_the_points_are_the_same(kept, found) -> None:
    for number, witness in kept.items():
        assert witness["point"] == found[number]["point"], number
        assert list(witness["letters"]) == list(found[number]["letters"]), number
        for name, parts in witness["letters"].items():
            assert same(parts, found[number]["letters"][name]), f"({number}) {name}"


def test_the_values_are_the_same(kept, found) -> None:
    for number, witness in kept.items():
        values = found[number]["values"]
        assert len(witness["values"]) == len(values), number
        assert all(map(same, witness["values"], values)), number
