"""Charts under test: a kernel module with its oracle, and vectors in regimes at the ends of charts and number types.

Each regime is a row of `REGIMES`. Its vectors are right for every function, singular for some, or outside the domain.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from types import ModuleType
from typing import Any

import mpmath
import numpy as np

import derive
from derive.codegen.signatures import POSES, ROTATIONS
from tests.support import families, oracle

RIGHT, SINGULAR, OUTSIDE = "finite and right", "right or not finite", "not finite"

FAR = 1e6
AXES = np.array([[2.0, -3, 6], [0, 0, 7]]) / 7
MOMENT = np.array([1.0, -2, 0.5])


class Subject:
    """Chart under test: a kernel module for poses or for rotations alone, and its oracle."""

    def __init__(self, module: ModuleType, known: oracle.Oracle, *, singles_in_double: bool = True) -> None:
        self.module, self.oracle, self.singles_in_double = module, known, singles_in_double
        self.table = ROTATIONS if ".rotation." in module.__name__ else POSES
        self.ends: bool = module.CHART.ends
        self.edge = np.inf if module.__name__.endswith(".exponential") else module.singular_angles()[-1]

    @property
    def components(self) -> int:
        return self.table.public["inverse"].shape[0]

    def limit(self, largest: float) -> float:
        """Return |v| beyond which powers of it overflow, which docstrings name."""
        name = self.module.__name__.split(".")[-1]
        chart: Any = derive.Cayley(int(name[6:])) if name.startswith("cayley") else derive.family(name)
        return float(chart.overflow(largest)[1])

    def size(self, angle: float) -> float:
        """Return |v| at an angle, which is √φ² of a dual number without dual part."""
        zero = self.oracle.unpack((0, 0))[0]
        with mpmath.workdps(families.DIGITS):
            return float(self.oracle.size(zero + mpmath.mpf(angle) / (2 * self.oracle.order)).re)

    def at(self, sizes: Sequence[float], dtype: Any, far: float = 1.0) -> np.ndarray:
        """Return vectors of these lengths about every axis, as (…, 6) or (…, 3)."""
        real = np.array([size * axis for size in sizes for axis in AXES])
        return np.concatenate([real, np.broadcast_to(far * MOMENT, real.shape)], -1)[:, : self.components].astype(dtype)


@cache
def subject(name: str, table: str = "", digits: int = families.DIGITS) -> Subject:
    """Return a chart of the catalogue by name, with an oracle of a number of digits."""
    module = importlib.import_module(".".join(filter(None, ("dualcay", table, name))))
    return Subject(module, families.oracle_of(name, digits))


Made = Iterator[tuple[str, np.ndarray]]
"""Vectors, each group with what a function of them may return."""


def _angles(chart: Subject, dtype: Any, angles: Sequence[float], fate: str = RIGHT, **options: Any) -> Made:
    inside = [angle for angle in angles if angle < 0.995 * chart.edge]
    yield fate, chart.at([chart.size(angle) for angle in inside], dtype, **options)


def _identity(chart: Subject, dtype: Any) -> Made:
    still = np.zeros((2, 6), dtype)
    still[1, 3:] = MOMENT
    yield RIGHT, still[:, : chart.components]


def _tiny(chart: Subject, dtype: Any) -> Made:
    """Lengths whose squares are subnormal, 0, or small."""
    least = float(np.finfo(dtype).smallest_normal)
    for far in (0.0, 1.0, FAR):
        yield RIGHT, chart.at([least * 2.0**20, least**0.55, least**0.505, least**0.07], dtype, far)


def _beside(size: float, dtype: Any, steps: Sequence[int]) -> list[float]:
    return [float(size * (1 + k * np.finfo(dtype).eps)) for k in steps]


def _half_turn(chart: Subject, dtype: Any) -> Made:
    if chart.edge > 3.2:
        yield RIGHT, chart.at(_beside(chart.size(np.pi), dtype, range(-2, 3)), dtype)


def _whole_turns(chart: Subject, dtype: Any) -> Made:
    """The oracle of the exponential counts no turns: vectors lie before the turn."""
    for turns in (1, 2):
        if 2 * turns * np.pi < min(chart.edge, 9) - 0.1:
            yield SINGULAR, chart.at(_beside(chart.size(2 * turns * np.pi), dtype, (-8, -4, -2)), dtype)


def _edge(chart: Subject, dtype: Any) -> Made:
    """Vectors just before the end of a chart, and beyond it."""
    if chart.ends:
        end = _beside(chart.size(chart.edge), dtype, (-64, -8, 16, 64))
        yield SINGULAR, chart.at(end[:2], dtype)
        yield OUTSIDE, chart.at(end[2:], dtype)


def _beyond(chart: Subject, dtype: Any) -> Made:
    if chart.ends:
        largest = float(np.finfo(dtype).max) ** 0.4
        yield OUTSIDE, chart.at([chart.size(chart.edge) * share for share in (1.05, 2.0, 1e3, largest)], dtype)


def _overflow(chart: Subject, dtype: Any) -> Made:
    """Lengths up to the one beyond which forward maps may be NaN, as docstrings say, and longer ones."""
    largest = float(np.finfo(dtype).max)
    powers = (0.1, 0.26, 0.34, 0.51)
    if chart.edge == np.inf:
        yield OUTSIDE, chart.at([largest**power for power in (0.51, 0.8, 0.99)], dtype)
    elif not chart.ends:
        yield RIGHT, chart.at([chart.limit(largest) ** share for share in (0.4, 0.75)], dtype)
        yield SINGULAR, chart.at([largest**power for power in powers], dtype)


def _not_finite(chart: Subject, dtype: Any) -> Made:
    v = chart.at([chart.size(1.0)], dtype)[0]
    bad = [np.where(np.arange(v.size) == i, wrong, v) for i in range(v.size) for wrong in (np.nan, np.inf, -np.inf)]
    yield OUTSIDE, np.array(bad, dtype)


def _ordinary(chart: Subject, dtype: Any) -> Made:
    yield from _angles(chart, dtype, (1e-3, 0.4, 1.3, 2.9, 3.4, 4.4, 0.99 * min(chart.edge, 6.0)))


def _few_digits(chart: Subject, dtype: Any) -> Made:
    for fate, v in _angles(chart, dtype, (0.02, 1.0, 3.0, 3.14159)):
        yield fate, v.astype(np.float32).astype(dtype)
        yield fate, v.round(6)


def _far(chart: Subject, dtype: Any) -> Made:
    yield from _angles(chart, dtype, (1e-9, 0.3, 3.1), far=FAR)


REGIMES: Mapping[str, Callable[[Subject, Any], Made]] = {
    "identity": _identity, "tiny": _tiny, "ordinary": _ordinary, "half turn": _half_turn, "whole turns": _whole_turns,
    "edge": _edge, "beyond the edge": _beyond, "overflow": _overflow, "not finite": _not_finite,
    "few digits": _few_digits, "far": _far,
}  # fmt: skip
"""Vectors by regime, from a chart and a dtype."""
