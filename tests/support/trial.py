"""Trial of one kernel module in one regime: samples, and comparison of errors with gates."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np

from tests.support import errors, sampling
from tests.support.first_principles import DIGITS
from tests.support.nilpotent import Nil
from tests.support.oracle import oracle_of


class Result(NamedTuple):
    """Computed value, allowed exact values (two at a tie between sides), their scales, and gates."""

    got: np.ndarray
    exact: list[Any]
    scales: list[Nil]
    gates: tuple[float, float]
    given: tuple[np.ndarray, ...]  # v, and the second argument if any
    note: str = ""


def rounded(exact: Any, dtype: Any) -> np.ndarray:
    """Round mpmath numbers to the nearest floats of a type."""
    flat = [np.longdouble(float(c)) + np.longdouble(float(c - float(c))) for c in exact.flat]
    return np.array(flat, dtype=np.longdouble).reshape(exact.shape).astype(dtype)


class Repeated:
    """Kernel module whose batches are repeated, so that their recorded programs run."""

    def __init__(self, module: ModuleType) -> None:
        self._module = module

    def __getattr__(self, name: str) -> Callable[..., Any]:
        return partial(self._call, getattr(self._module, name))

    def _call(self, function: Callable[..., Any], first: np.ndarray, *rest: Any) -> Any:
        times, size = -(-sampling.CROWD // len(first)), len(first)
        many = [np.tile(a, (times, *[1] * (a.ndim - 1))) if isinstance(a, np.ndarray) else a for a in (first, *rest)]
        found = function(*many)
        return tuple(part[:size] for part in found) if isinstance(found, tuple) else found[:size]


class Measured:
    """Samples of one regime, drawn by `seed` or `given`: vectors, and second arguments for functions that need them.

    Subclasses have a method for each function, which yields a `Result` for every sample.
    """

    def __init__(
        self,
        module: ModuleType,
        order: int,
        regime: str,
        dtype: Any = np.float64,
        *,
        digits: int = DIGITS,
        count: int = sampling.COUNT,
        seed: int = 0,
        given: tuple[np.ndarray, ...] | None = None,
    ) -> None:
        self.module, self.order, self.regime, self.dtype = Repeated(module), order, regime, dtype
        self.oracle = oracle_of(order, digits)
        self.drawn = {"dtype": dtype, "count": count, "seed": seed}
        self.given = given
        self.v = sampling.poses(order, regime, **self.drawn) if given is None else given[0]
        self.inside = regime in sampling.PRINCIPAL
        self.tie = regime == "at pi"

    def second(self, draw: Callable[..., np.ndarray], name: str) -> np.ndarray:
        """Draw second arguments of a function, one for each vector."""
        return draw(f"{name} {self.regime}", **self.drawn) if self.given is None else self.given[1]

    def partners(self) -> list[np.ndarray]:
        """Return second poses for compositions, from the same regime and from the uniform one."""
        if self.given is not None:
            return [self.given[1]]
        return [np.roll(self.v, 1, axis=0), sampling.poses(self.order, "uniform", **self.drawn)[::-1]]

    def branches(self) -> list[int]:
        """Return some branches, without a branch at the edge nπ of the chart."""
        n = self.order
        chosen = sorted({0, 1 % n, n // 2, n - 1})
        if self.regime == "identity":
            return [0]
        if self.regime == "pure translation":
            return [k for k in chosen if 2 * k != n]
        return [k for k in chosen if not (self.tie and abs(2 * k - n) == 1)]

    def check(self, name: str) -> None:
        for result in getattr(self, name)():
            assert result.got.dtype == self.dtype, f"{name}: {result.got.dtype} for {self.dtype}"
            found = self.fractions(result)
            assert max(found) <= 1, (
                f"{name}, n = {self.order}, {self.regime}: (real, dual) error {self.in_eps(result)} eps, allowed "
                f"{result.gates} for {result.given!r} {result.note}\n"
                f"got   {result.got!r}\nexact {result.exact[0].astype(float)!r}"
            )

    def in_eps(self, result: Result) -> list[tuple[float, float]]:
        return [errors.errors(result.got, e, s, self.oracle) for e, s in zip(result.exact, result.scales, strict=True)]

    def fractions(self, result: Result) -> tuple[float, float]:
        """Return both errors divided by their gates, for the nearest of the allowed exact values."""
        found = [(re / result.gates[0], du / result.gates[1]) for re, du in self.in_eps(result)]
        return min(found, key=max)

    def worst(self, name: str) -> float:
        return max((max(self.fractions(result)) for result in getattr(self, name)()), default=0.0)
