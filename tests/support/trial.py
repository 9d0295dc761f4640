"""Trial of every kernel function in one regime of `sampling`, judged by the oracle as in `regimes`.

The module is an argument: it may also be a kernel of another order or of another target, or a broken copy.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any

import numpy as np

from derive.codegen.rows import Array, Function
from derive.codegen.signatures import PUBLIC
from tests.support import families, ranges, regimes, sampling
from tests.support.oracle import oracle_of
from tests.support.regimes import Call
from tests.support.subjects import RIGHT, SINGULAR, Subject

DIGITS = 50

COMPOSITE = ("jacobian", "transition", "retract", "local", "between", "interpolate", "adjoint", "exponential")
"""Parts of names of functions that multiply several operators, or whose exact values are slow."""
FUNCTIONS = tuple(name for name in PUBLIC if not any(part in name for part in COMPOSITE))
"""Functions of poses with quick exact values."""

PROMISED = {
    "inverse": 0.5, "quaternion": 2, "tangent": 3, "body_tangent": 3, "tangent_inv": 3, "body_tangent_inv": 3,
    "rate": 3, "body_rate": 3,
}  # fmt: skip
"""Largest error in eps of a size, by function, where it is smaller than `families.GATE`; `make accuracy` found half."""


def gate(source: str) -> float:
    """Return the largest error of a function in eps of a size, given its name for poses."""
    return PROMISED.get(source, families.GATE)


class Trial:
    """Calls of the functions of one module with the vectors of one regime."""

    def __init__(
        self,
        module: Any,
        order: int,
        regime: str,
        dtype: Any = np.float64,
        *,
        digits: int = DIGITS,
        count: int = sampling.COUNT,
        seed: int = 0,
        **options: bool,
    ) -> None:
        self.chart = Subject(module, oracle_of(order, digits), **options)
        self.order, self.regime, self.dtype = order, regime, dtype
        self.drawn = {"dtype": dtype, "count": count, "seed": seed}
        self.v = self._vectors(regime)

    def _vectors(self, regime: str) -> np.ndarray:
        return sampling.poses(self.order, regime, **self.drawn)[:, : self.chart.components]

    @property
    def inside(self) -> bool:
        return self.regime in sampling.PRINCIPAL

    def calls(self, name: str) -> Iterator[Call]:
        """Yield calls of a function with every vector of the regime, on some branches, also beside ordinary vectors."""
        row = self.chart.table.public[name]
        if (row.source, self.regime) == ("interpolate", "near 2 pi"):
            return  # the oracle's steps are too long there
        if (row.source, self.regime, self.order) == ("quaternion", "coordinate axes", 1):
            return  # next to the pole, the dual part along an axis is a difference; other axes show its error
        several = sum(array.vector for array in row.arguments) > 1
        others = [self._vectors("uniform")[::-1], *([np.roll(self.v, 1, axis=0)] if len(self.v) > 1 else [])]
        for other, branch in itertools.product(others if several else others[:1], self._branches(row)):
            for rows in zip(*self._arguments(row, other), strict=True):
                given = tuple(map(np.asarray, rows))
                if all(np.isfinite(array).all() for array in given):
                    yield self.call(row, given, branch)

    def call(self, row: Function, given: tuple[np.ndarray, ...], branch: tuple[int, ...] = ()) -> Call:
        """Return a call of a function; powers of 1 + x may overflow, and no rotation has no axis."""
        vectors = [v for v, array in zip(given, row.arguments, strict=True) if array.vector]
        still = any(not (v[:3] if "jacobian" in row.source else v).any() for v in vectors)
        singular = still and branch != (0,) and row.source in regimes.OF_AXIS
        finite = not singular and all(ranges.in_range(self.order, v) for v in vectors)
        return Call(self.chart, row, given, RIGHT if finite else SINGULAR, branch=branch, gate=gate(row.source))

    def _branches(self, row: Function) -> list[tuple[int, ...]]:
        """Return some branches of a function that takes one, without a branch at the edge nπ of the chart."""
        n = self.order
        chosen = sorted({0, 1 % n, n // 2, n - 1}) if self.regime != "identity" else [0]
        if self.regime == "pure translation":
            chosen = [k for k in chosen if 2 * k != n]
        elif self.regime == "at pi":
            chosen = [k for k in chosen if abs(2 * k - n) != 1]
        return [(k,) for k in chosen] if row.branch else [()]

    def _arguments(self, row: Function, other: np.ndarray) -> list[np.ndarray]:
        """Return the arguments of a function, one row for each vector."""
        vectors = iter((self.v, other))
        return [self._argument(array, row, vectors) for array in row.arguments]

    def _argument(self, array: Array, row: Function, vectors: Iterator[np.ndarray]) -> np.ndarray:
        if array.vector:
            return next(vectors)
        if array.name == "t":
            return np.full(len(self.v), 0.375, self.dtype)
        if array.name in FORWARD and row.source.startswith("from_"):
            name, place = FORWARD[array.name]
            with np.errstate(all="ignore"):
                found = getattr(self.chart.module, self.chart.table.sources[name].name)(self.v)
            return np.asarray(found[place] if isinstance(found, tuple) else found)
        drawn = sampling.dual_vectors(f"{row.name} {array.name} {self.regime}", **self.drawn)
        return drawn[:, : array.size].reshape(-1, *array.shape)

    def check(self, name: str) -> None:
        wrong = [reason for reason in (call.judged() for call in self.calls(name)) if reason]
        assert not wrong, f"n = {self.order}, {self.regime}: {wrong}"


FORWARD = {
    "q": ("quaternion", 0), "R": ("tensor", 0), "T": ("pose", 0), "w": ("to_exponential", 0), "angle": ("to_screw", 0),
    "line": ("to_screw", 1), "axis": ("to_screw", 1), "u": ("to_screw", 1),
}  # fmt: skip
"""Function that makes an argument of an inverse map, and the place of its result."""
