"""Comparison of forward maps and derivatives of the tangent operator with the oracle in one regime."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partialmethod
from typing import Any

import numpy as np

from tests.support import errors, sampling
from tests.support.nilpotent import Nil
from tests.support.trial import Measured, Result

GATES: Mapping[str, Callable[[int], tuple[float, float]]] = {
    "quaternion": lambda n: (errors.QUATERNION, errors.shadow_gate(n)),
    "rotation": lambda n: (errors.ROTATION, errors.shadow_gate(n)),
    "position": lambda n: (errors.POSITION, errors.shadow_gate(n)),
    "moment": lambda n: (errors.GENERAL, max(errors.GENERAL, errors.shadow_gate(n))),
    "tangent": lambda n: (errors.TANGENT, errors.tangent_shadow_gate(n)),
    "twist": lambda n: (errors.GENERAL, errors.tangent_shadow_gate(n)),
    "rate": lambda n: (errors.RATE, errors.GENERAL),
    "derived": lambda n: (errors.DERIVED, errors.derived_shadow_gate(n)),
    "conditioned": lambda n: (errors.CONDITIONED, max(errors.THREE, errors.tangent_shadow_gate(n))),
    "general": lambda n: (errors.GENERAL, errors.GENERAL),
}
"""Functions from order to gates inside and outside the principal range; "moment" is for skew(ρ) Q, two in a chain."""


class ForwardTrial(Measured):
    """Trial of one kernel module in one regime, for functions that select no branch."""

    def gates(self, real: str, dual: str = "") -> tuple[float, float]:
        """Return the gates of real and dual part, given their names."""
        return tuple(GATES[kind](self.order)[not self.inside] for kind in (real, dual or real))  # type: ignore[return-value]

    def _scale(self, v: Any, name: str) -> Nil:
        """Return a named scale at v; outside the principal range, ``tangent_inv`` includes its condition number."""
        kind = "near_pole" if name == "tangent_inv" and not self.inside else name
        found: Nil = getattr(errors.scales(self.order, v), kind)
        return found

    def _forward(self, name: str, scale: str, *gates: str) -> Iterator[Result]:
        for v, got in zip(self.v, getattr(self.module, name)(self.v), strict=True):
            exact = getattr(self.oracle, name)(v)
            yield Result(got, [exact], [self._scale(v, scale)], self.gates(*gates), (v,))

    quaternion = partialmethod(_forward, "quaternion", "quaternion", "quaternion")
    tensor = partialmethod(_forward, "tensor", "tensor", "rotation", "moment")
    tangent = partialmethod(_forward, "tangent", "tangent", "tangent")
    tangent_inv = partialmethod(_forward, "tangent_inv", "tangent_inv", "rate")
    body_tangent = partialmethod(_forward, "body_tangent", "tangent", "tangent")
    body_tangent_inv = partialmethod(_forward, "body_tangent_inv", "tangent_inv", "rate")

    def pose(self) -> Iterator[Result]:
        for v, got in zip(self.v, self.module.pose(self.v), strict=True):
            local = errors.scales(self.order, v)
            assert got[3].tolist() == [0, 0, 0, 1]
            scale = Nil(local.tensor.re, local.position)
            yield Result(got, [self.oracle.pose(v)], [scale], self.gates("rotation", "position"), (v,))

    def inverse(self) -> Iterator[Result]:
        for v, got in zip(self.v, self.module.inverse(self.v), strict=True):
            # only signs change, so nothing is rounded
            yield Result(got, [self.oracle.inverse(v)], [errors.size(v)], (0.5, 0.5), (v,))

    def _applied(self, name: str, scale: str, gates: str) -> Iterator[Result]:
        argument = self.second(sampling.dual_vectors, name)
        for v, w, got in zip(self.v, argument, getattr(self.module, name)(self.v, argument), strict=True):
            allowed = self._scale(v, scale) * errors.size(w)
            yield Result(got, [getattr(self.oracle, name)(v, w)], [allowed], self.gates(gates), (v, w))

    twist = partialmethod(_applied, "twist", "tangent", "twist")
    body_twist = partialmethod(_applied, "body_twist", "tangent", "twist")
    rate = partialmethod(_applied, "rate", "tangent_inv", "rate")
    body_rate = partialmethod(_applied, "body_rate", "tangent_inv", "rate")
    transform_line = partialmethod(_applied, "transform_line", "tensor", "general")

    def _derived(self, name: str, scale: Callable[..., Nil], count: int = 1) -> Iterator[Result]:
        """Yield derivatives of an operator; ``scale(slope, operator, *sizes)`` gets the sizes of further arguments."""
        inverse = name.removeprefix("body_").startswith("rate")
        kind, gates = "tangent_inv" if inverse else "tangent", self.gates("derived")
        given = [self.second(sampling.dual_vectors, name)]
        given += [np.roll(given[0], 1, axis=-1)] * (count - 1)
        for v, *others, got in zip(self.v, *given, getattr(self.module, name)(self.v, *given), strict=True):
            slope = getattr(errors.slopes(self.order, v), "near_pole" if inverse and not self.inside else kind)
            if got.shape == (6, 6):
                assert np.array_equal(got[:3, :3], got[3:, 3:], equal_nan=True)  # NaN where v·v to the order overflows
                assert (got[:3, 3:] == 0).all()
            if not (inverse or self.inside):  # slopes may be subnormal
                slope = slope + errors.underflow(v, self.dtype) / (gates[1] * float(np.finfo(self.dtype).eps))
            allowed = scale(slope, self._scale(v, kind), *map(errors.size, others))
            yield Result(got, [getattr(self.oracle, name)(v, *others)], [allowed], gates, (v, others[0]))

    def _jacobian(self, name: str) -> Iterator[Result]:
        return self._derived(name, lambda slope, _, w: slope * w)

    def _twist_dot(self, name: str) -> Iterator[Result]:
        return self._derived(name, lambda slope, T, w, z: T * z + slope * w * w, 2)

    def _rate_dot(self, name: str) -> Iterator[Result]:
        return self._derived(name, lambda slope, T, w, z: T * z + slope * (T * w) * w, 2)

    tangent_dot = partialmethod(_jacobian, "tangent_dot")
    twist_jacobian = partialmethod(_jacobian, "twist_jacobian")
    cotangent_jacobian = partialmethod(_jacobian, "cotangent_jacobian")
    rate_jacobian = partialmethod(_jacobian, "rate_jacobian")
    body_rate_jacobian = partialmethod(_jacobian, "body_rate_jacobian")
    twist_dot = partialmethod(_twist_dot, "twist_dot")
    body_twist_dot = partialmethod(_twist_dot, "body_twist_dot")
    rate_dot = partialmethod(_rate_dot, "rate_dot")
    body_rate_dot = partialmethod(_rate_dot, "body_rate_dot")

    def transform_point(self) -> Iterator[Result]:
        points = self.second(sampling.points, "transform_point")
        for v, r, got in zip(self.v, points, self.module.transform_point(self.v, points), strict=True):
            local = errors.scales(self.order, v)
            # The result is a real vector; it is compared as the dual part of an otherwise exact result.
            moved = self.oracle.transform_point(v, r)
            exact = np.concatenate([0 * moved, moved])
            allowed = Nil(1.0, local.tensor.re * errors.norm(r) + local.position)
            full = np.concatenate([np.zeros(3, got.dtype), got])
            yield Result(full, [exact], [allowed], (errors.GENERAL,) * 2, (v, r))
