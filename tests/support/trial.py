"""How one kernel function in one regime is compared with the oracle, and the maps from v themselves.

`Trial` in `accuracy` adds the inverse maps; tests use that.
"""

from __future__ import annotations

from collections.abc import Iterator
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np

from tests.support import errors, sampling
from tests.support.nilpotent import Nil
from tests.support.oracle import oracle_of


class Result(NamedTuple):
    """One computed value, what it may be (two values only where a tie leaves the side open), and what is allowed."""

    got: np.ndarray
    exact: list[Any]
    scales: list[Nil]
    gates: tuple[float, float]
    note: str


class ForwardTrial:
    """One kernel module in one regime: the maps from v, and how a result is judged."""

    def __init__(
        self, module: ModuleType, order: int, regime: str, dtype: Any = np.float64, count: int = sampling.COUNT
    ) -> None:
        self.module, self.order, self.regime, self.dtype = module, order, regime, dtype
        self.oracle = oracle_of(order)
        self.v = sampling.poses(order, regime, dtype, count)
        self.inside = regime in sampling.PRINCIPAL
        self.tie = regime == "at pi"

    def gates(self, inside: float, outside: float) -> tuple[float, float]:
        gate = inside if self.inside else outside
        return gate, gate

    def branches(self) -> list[int]:
        """Some branches, those left out where the angle α + 2kπ is the end nπ of the chart."""
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
                f"{result.gates} for {result.note}\ngot   {result.got!r}\nexact {result.exact[0].astype(float)!r}"
            )

    def in_eps(self, result: Result) -> list[tuple[float, float]]:
        return [errors.errors(result.got, e, s, self.oracle) for e, s in zip(result.exact, result.scales, strict=True)]

    def fractions(self, result: Result) -> tuple[float, float]:
        """Error over gate, of the nearer of the values allowed."""
        found = [(re / result.gates[0], du / result.gates[1]) for re, du in self.in_eps(result)]
        return min(found, key=max)

    def worst(self, name: str) -> float:
        return max((max(self.fractions(result)) for result in getattr(self, name)()), default=0.0)

    # ---- forward maps ------------------------------------------------------------------------------------------

    def _forward(self, name: str, scale: str, gates: tuple[float, float]) -> Iterator[Result]:
        for v, got in zip(self.v, getattr(self.module, name)(self.v), strict=True):
            exact = getattr(self.oracle, name)(v)
            yield Result(got, [exact], [getattr(errors.scales(self.order, v), scale)], gates, f"v = {v!r}")

    def quaternion(self) -> Iterator[Result]:
        gates = self.gates(errors.QUATERNION, errors.shadow_gate(self.order))
        return self._forward("quaternion", "quaternion", gates)

    def tensor(self) -> Iterator[Result]:
        # The dual part is skew(ρ) Q: both errors, in a chain.
        outside = errors.shadow_gate(self.order)
        gates = (errors.ROTATION, errors.GENERAL) if self.inside else (outside, max(errors.GENERAL, outside))
        return self._forward("tensor", "tensor", gates)

    def pose(self) -> Iterator[Result]:
        outside = errors.shadow_gate(self.order)
        gates = (errors.ROTATION, errors.POSITION) if self.inside else (outside, outside)
        for v, got in zip(self.v, self.module.pose(self.v), strict=True):
            local = errors.scales(self.order, v)
            assert got[3].tolist() == [0, 0, 0, 1]
            yield Result(got, [self.oracle.pose(v)], [Nil(local.tensor.re, local.position)], gates, f"v = {v!r}")

    def tangent(self) -> Iterator[Result]:
        gates = self.gates(errors.TANGENT, errors.tangent_shadow_gate(self.order))
        return self._forward("tangent", "tangent", gates)

    def tangent_inv(self) -> Iterator[Result]:
        scale = "tangent_inv" if self.inside else "near_pole"
        return self._forward("tangent_inv", scale, self.gates(errors.RATE, errors.GENERAL))

    def _applied(self, name: str, scale: str, gates: tuple[float, float]) -> Iterator[Result]:
        argument = sampling.dual_vectors(f"{name} {self.regime}", self.dtype, len(self.v))
        for v, w, got in zip(self.v, argument, getattr(self.module, name)(self.v, argument), strict=True):
            allowed = getattr(errors.scales(self.order, v), scale) * errors.size(w)
            yield Result(got, [getattr(self.oracle, name)(v, w)], [allowed], gates, f"v = {v!r}, argument = {w!r}")

    def twist(self) -> Iterator[Result]:
        outside = errors.tangent_shadow_gate(self.order)
        return self._applied("twist", "tangent", self.gates(errors.GENERAL, outside))

    def body_twist(self) -> Iterator[Result]:
        outside = errors.tangent_shadow_gate(self.order)
        return self._applied("body_twist", "tangent", self.gates(errors.GENERAL, outside))

    def rate(self) -> Iterator[Result]:
        scale = "tangent_inv" if self.inside else "near_pole"
        return self._applied("rate", scale, self.gates(errors.RATE, errors.GENERAL))

    def body_rate(self) -> Iterator[Result]:
        scale = "tangent_inv" if self.inside else "near_pole"
        return self._applied("body_rate", scale, self.gates(errors.RATE, errors.GENERAL))

    def transform_line(self) -> Iterator[Result]:
        return self._applied("transform_line", "tensor", self.gates(errors.GENERAL, errors.GENERAL))

    def transform_point(self) -> Iterator[Result]:
        points = sampling.points(f"transform_point {self.regime}", self.dtype, len(self.v))
        for v, r, got in zip(self.v, points, self.module.transform_point(self.v, points), strict=True):
            local = errors.scales(self.order, v)
            # One real vector: as the dual part of an otherwise exact result.
            exact = np.concatenate([0 * self.oracle.transform_point(v, r), self.oracle.transform_point(v, r)])
            allowed = Nil(1.0, local.tensor.re * errors.norm(r) + local.position)
            full = np.concatenate([np.zeros(3, got.dtype), got])
            yield Result(full, [exact], [allowed], (errors.GENERAL,) * 2, f"v = {v!r}, r = {r!r}")
