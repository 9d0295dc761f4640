"""The committed 30-digit values: what some of the entries come to at their seeded points today.

``python -m derive.papers.witnesses`` writes those of all.
"""

from __future__ import annotations

import mpmath
import pytest

from derive.papers import PAPERS, Paper
from derive.papers.witnesses import committed, witness

SAMPLE = 8
"""One of so many entries is computed again."""


@pytest.fixture(scope="module", params=PAPERS, ids=lambda paper: paper.short)
def paper(request) -> Paper:
    return request.param


@pytest.fixture(scope="module")
def kept(paper) -> dict:
    return committed(paper)


@pytest.fixture(scope="module")
def found(paper) -> dict:
    return {entry.number: witness(paper, entry) for entry in paper.entries()[::SAMPLE]}


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
    for number, today in found.items():
        assert kept[number]["point"] == today["point"], number
        assert list(kept[number]["letters"]) == list(today["letters"]), number
        for name, parts in today["letters"].items():
            assert same(kept[number]["letters"][name], parts), f"({number}) {name}"


def test_the_values_are_the_same(kept, found) -> None:
    for number, today in found.items():
        values = kept[number]["values"]
        assert len(values) == len(today["values"]), number
        assert all(map(same, values, today["values"])), number
