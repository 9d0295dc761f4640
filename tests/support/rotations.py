"""Comparison of modules of rotations alone with the real part of the oracle, at dual parts 0."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from types import ModuleType
from typing import Any

import numpy as np

from derive.codegen.signatures import ROTATIONS
from tests.support import errors, sampling
from tests.support.calculus import EVERY, CalculusTrial
from tests.support.nilpotent import Nil
from tests.support.trial import Result

FUNCTIONS = tuple(name for name in EVERY if name in ROTATIONS.sources)
"""Functions of rotations, under the names of their counterparts for poses."""

REGIMES = tuple(r for r in sampling.REGIMES if r not in ("translation 1e6", "pure rotation", "pure translation"))
"""Regimes with different real parts."""


class Called:
    """Module of rotations with the interface for poses; it uses only the real parts of arguments."""

    def __init__(self, module: ModuleType) -> None:
        self.module = module

    def __getattr__(self, name: str) -> Callable[..., Any]:
        row = ROTATIONS.sources[name]

        def call(*values: Any) -> Any:
            arrays = row.pose.arguments
            given = [real(value, *pair) for value, *pair in zip(values, arrays, row.arguments, strict=False)]
            return getattr(self.module, row.name)(*given, *values[len(arrays) :])

        return call


def real(value: Any, pose: Any, rotation: Any) -> Any:
    """Return the components of an array for poses that the corresponding array for rotations has."""
    value = np.asarray(value)
    batch = value.shape[: value.ndim - len(pose.shape)]
    return value.reshape((*batch, pose.size))[..., list(pose.places)].reshape(batch + rotation.shape)


class RotationTrial(CalculusTrial):
    """Trial of pose functions with dual parts 0 in arguments, and no dual parts in results."""

    def __init__(self, module: ModuleType, *arguments: Any, **options: Any) -> None:
        super().__init__(Called(module), *arguments, **options)
        self.v = still(self.v)

    def second(self, draw: Callable[..., np.ndarray], name: str) -> np.ndarray:
        drawn = super().second(draw, name)
        return still(drawn) if drawn.shape[-1] == 6 else drawn

    def partners(self) -> list[np.ndarray]:
        return [still(v) for v in super().partners()]

    def in_eps(self, result: Result) -> list[tuple[float, float]]:
        pairs = zip(result.exact, result.scales, strict=True)
        return [(errors.error(result.got, errors.parts(e)[0], s.re, self.oracle), 0.0) for e, s in pairs]

    def transform_point(self) -> Iterator[Result]:
        points = self.second(sampling.points, "transform_point")
        for v, r, got in zip(self.v, points, self.module.transform_point(self.v, points), strict=True):
            moved = self.oracle.transform_point(v, r)
            size = errors.scales(self.order, v).tensor.re * errors.norm(r)
            yield Result(got, [np.concatenate([moved, 0 * moved])], [Nil(size, 0.0)], (errors.GENERAL,) * 2, (v, r))

    def transform_point_jacobians(self) -> Iterator[Result]:
        points = self.second(sampling.points, "transform_point_jacobians")
        found = self.module.transform_point_jacobians(self.v, points)
        for v, r, *got in zip(self.v, points, *found, strict=True):
            exact, local = self.oracle.transform_point_jacobians(v, r), errors.scales(self.order, v)
            sizes = Nil(local.tangent.re * errors.norm(r), 0.0), Nil(local.tensor.re, 0.0)
            halves = [np.stack([tensor[:, :3], 0 * tensor[:, :3]]) for tensor in exact]
            yield from self._both(got, halves, sizes, (v, r))


def still(v: np.ndarray) -> np.ndarray:
    """Return vectors with dual part 0."""
    return np.concatenate([v[..., :3], np.zeros_like(v[..., 3:])], axis=-1)
