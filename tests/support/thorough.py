"""Parameters of tests of which normal runs try a fixed part, and thorough ones all."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterable
from typing import Any

import pytest


def shares(most: int, sample: int) -> pytest.MarkDecorator:
    """Return the parameter `share`: one of so many cases by default, and one of fewer in the thorough tests."""
    found = [pytest.param(most, marks=pytest.mark.thorough, id="most"), pytest.param(sample, id="sample")]
    return pytest.mark.parametrize("share", found)


def in_turn(*columns: Iterable[Any]) -> list[Any]:
    """Return all combinations; by default each value of the first column is tried with one of the others in turn."""
    first, *others = map(list, columns)
    pairs = list(itertools.product(*others))
    return [
        pytest.param(one, *other, marks=[pytest.mark.thorough] * (place % len(pairs) != turn))
        for place, one in enumerate(first)
        for turn, other in enumerate(pairs)
    ]


def sampled(values: Iterable[Any], few: Collection[Any]) -> list[Any]:
    """Return all values; by default few of them are tried."""
    return [pytest.param(value, marks=[pytest.mark.thorough] * (value not in few)) for value in values]
