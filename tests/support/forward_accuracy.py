"""Forward maps and derivatives of the tangent operator against the oracle in one regime."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tests.support import errors, sampling
from tests.support.nilpotent import Nil
from tests.support.trial import Measured, Result


class ForwardTrial(Measured):
    """The functions of one kernel module in one regime that select nothing."""

    def _forward(self, name: str, scale: str, gates: tuple[float, float]) -> Iterator[Result]:
        for v, got in zip(self.v, getattr(self.module, name)(self.v), strict=True):
            exact = getattr(self.oracle, name)(v)
            yield Result(got, [exact], [getattr(errors.scales(self.order, v), scale)], gates, (v,))

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
            yield Result(got, [self.oracle.pose(v)], [Nil(local.tensor.re, local.position)], gates, (v,))

    def tangent(self) -> Iterator[Result]:
        gates = self.gates(errors.TANGENT, errors.tangent_shadow_gate(self.order))
        return self._forward("tangent", "tangent", gates)

    def tangent_inv(self) -> Iterator[Result]:
        scale = "tangent_inv" if self.inside else "near_pole"
        return self._forward("tangent_inv", scale, self.gates(errors.RATE, errors.GENERAL))

    def body_tangent(self) -> Iterator[Result]:
        gates = self.gates(errors.TANGENT, errors.tangent_shadow_gate(self.order))
        return self._forward("body_tangent", "tangent", gates)

    def body_tangent_inv(self) -> Iterator[Result]:
        scale = "tangent_inv" if self.inside else "near_pole"
        return self._forward("body_tangent_inv", scale, self.gates(errors.RATE, errors.GENERAL))

    def inverse(self) -> Iterator[Result]:
        for v, got in zip(self.v, self.module.inverse(self.v), strict=True):
            # a sign: nothing is rounded
            yield Result(got, [self.oracle.inverse(v)], [errors.size(v)], (0.5, 0.5), (v,))

    def _applied(self, name: str, scale: str, gates: tuple[float, float]) -> Iterator[Result]:
        argument = self.second(sampling.dual_vectors, name)
        for v, w, got in zip(self.v, argument, getattr(self.module, name)(self.v, argument), strict=True):
            allowed = getattr(errors.scales(self.order, v), scale) * errors.size(w)
            yield Result(got, [getattr(self.oracle, name)(v, w)], [allowed], gates, (v, w))

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

    # ---- derivatives of the tangent operator -------------------------------------------------------------------

    def _derived(self, name: str, scale: Any, gates: tuple[float, float], count: int) -> Iterator[Result]:
        """`scale(slope, operator, *sizes)` of the second and third arguments, `count` of them."""
        inverse = name.removeprefix("body_").startswith("rate")
        subnormal = not (inverse or self.inside)
        kind = ("tangent_inv" if self.inside else "near_pole") if inverse else "tangent"
        given = [self.second(sampling.dual_vectors, name) for _ in range(min(count, 1))]
        given += [np.roll(given[0], 1, axis=-1)] * (count - 1)
        for v, *others, got in zip(self.v, *given, getattr(self.module, name)(self.v, *given), strict=True):
            slope, operator = (getattr(of(self.order, v), kind) for of in (errors.slopes, errors.scales))
            if got.shape == (6, 6):
                assert np.array_equal(got[:3, :3], got[3:, 3:], equal_nan=True)  # NaN where v·v to the order overflows
                assert (got[:3, 3:] == 0).all()
            if subnormal:
                slope = slope + errors.underflow(v, self.dtype) / (gates[1] * float(np.finfo(self.dtype).eps))
            allowed = scale(slope, operator, *map(errors.size, others))
            yield Result(got, [getattr(self.oracle, name)(v, *others)], [allowed], gates, (v, others[0]))

    @property
    def _derived_gates(self) -> tuple[float, float]:
        return self.gates(errors.DERIVED, errors.derived_shadow_gate(self.order))

    def tangent_dot(self) -> Iterator[Result]:
        return self._derived("tangent_dot", lambda slope, _, w: slope * w, self._derived_gates, 1)

    def _twist_dot(self, name: str) -> Iterator[Result]:
        return self._derived(name, lambda slope, T, w, z: T * z + slope * w * w, self._derived_gates, 2)

    def twist_dot(self) -> Iterator[Result]:
        return self._twist_dot("twist_dot")

    def body_twist_dot(self) -> Iterator[Result]:
        return self._twist_dot("body_twist_dot")

    def _rate_dot(self, name: str) -> Iterator[Result]:
        return self._derived(name, lambda slope, T, w, z: T * z + slope * (T * w) * w, self._derived_gates, 2)

    def rate_dot(self) -> Iterator[Result]:
        return self._rate_dot("rate_dot")

    def body_rate_dot(self) -> Iterator[Result]:
        return self._rate_dot("body_rate_dot")

    def _jacobian(self, name: str) -> Iterator[Result]:
        return self._derived(name, lambda slope, _, w: slope * w, self._derived_gates, 1)

    def twist_jacobian(self) -> Iterator[Result]:
        return self._jacobian("twist_jacobian")

    def cotangent_jacobian(self) -> Iterator[Result]:
        return self._jacobian("cotangent_jacobian")

    def rate_jacobian(self) -> Iterator[Result]:
        return self._jacobian("rate_jacobian")

    def body_rate_jacobian(self) -> Iterator[Result]:
        return self._jacobian("body_rate_jacobian")

    def transform_line(self) -> Iterator[Result]:
        return self._applied("transform_line", "tensor", self.gates(errors.GENERAL, errors.GENERAL))

    def transform_point(self) -> Iterator[Result]:
        points = self.second(sampling.points, "transform_point")
        for v, r, got in zip(self.v, points, self.module.transform_point(self.v, points), strict=True):
            local = errors.scales(self.order, v)
            # One real vector: as the dual part of an otherwise exact result.
            moved = self.oracle.transform_point(v, r)
            exact = np.concatenate([0 * moved, moved])
            allowed = Nil(1.0, local.tensor.re * errors.norm(r) + local.position)
            full = np.concatenate([np.zeros(3, got.dtype), got])
            yield Result(full, [exact], [allowed], (errors.GENERAL,) * 2, (v, r))
