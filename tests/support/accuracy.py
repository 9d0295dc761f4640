"""Comparison of every kernel function with the oracle in one regime: results, exact values, scales and gates.

`Trial(module, order, regime).check(name)` raises AssertionError with the input if the function of this name misses its
gate. `worst(name)` returns the largest error as a fraction of the gate. The module is an argument: it may also be a
kernel of another order, written elsewhere, or a broken copy.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partialmethod
from typing import Any

import numpy as np

from derive.codegen.signatures import PUBLIC
from tests.support import errors
from tests.support.first_principles import pack
from tests.support.forward_accuracy import ForwardTrial
from tests.support.nilpotent import Nil, hamilton, inverse, matmul
from tests.support.trial import Result, rounded


class Trial(ForwardTrial):
    """Trial of one kernel module in one regime; a method for each function yields its results."""

    # ---- inverse maps ------------------------------------------------------------------------------------------

    def _inverse(self, name: str) -> Iterator[Result]:
        """Yield results of an inverse map for rounded quaternions, tensors or poses, on some branches."""
        forward = getattr(self.oracle, name.removeprefix("from_"))
        entries = self.quaternion_entries if name == "from_quaternion" else self.tensor_entries
        inputs = np.stack([rounded(forward(v), self.dtype) for v in self.v])
        sides, entered = [self.sides(v) for v in self.v], [entries(v) for v in self.v]
        for branch in self.branches():
            found = getattr(self.module, name)(inputs, branch)
            for v, x, ways, entry, got in zip(self.v, inputs, sides, entered, found, strict=True):
                exact, scales = [], []
                for half, axis in ways:
                    result = self.oracle.on_branch(half, axis, branch)
                    exact.append(pack(result))
                    scales.append(self.inverse_scale(result, half, axis, branch, *entry))
                yield Result(got, exact, scales, self.gates("general"), (v,), f"branch {branch}, input {x!r}")

    from_quaternion = partialmethod(_inverse, "from_quaternion")
    from_tensor = partialmethod(_inverse, "from_tensor")
    from_pose = partialmethod(_inverse, "from_pose")

    def sides(self, v: Any) -> list[tuple[Any, Any]]:
        """Return (half the principal angle, axis) for q̂, and at π also for −q̂, which rounding may select."""
        q = self.oracle.unit(self.oracle.unpack(v))
        if q[0].re < 0:
            q = tuple(-c for c in q)
        flipped = [tuple(-c for c in q)] if self.tie else []
        return [self.oracle.half_screw(side) for side in (q, *flipped)]

    def inverse_scale(self, result: Any, half: Any, axis: Any, branch: int, directions: Any, entries: Any) -> Nil:
        if self.regime == "pure translation" and branch:
            return self.translation_shadow_scale(branch, float(half.du) / self.order)
        scale = errors.branch_scale(self.oracle.operator_by_spin(result), result, directions, entries)
        if branch:
            angle = 2 * half + 2 * branch * self.oracle.field.pi
            scale = scale + errors.angle_scale(self.order, angle, axis)
        return scale

    def translation_shadow_scale(self, branch: int, length: float) -> Nil:
        """Return the scale of tan(kπ/n + ε |v°|) u with exact u; T has no inverse at this vector."""
        tangent = math.tan(branch * math.pi / self.order)
        return Nil(abs(tangent), (1 + tangent**2) * length)

    def quaternion_entries(self, v: Any) -> tuple[Any, Any]:
        q = self.oracle.unit(self.oracle.unpack(v))
        back = (q[0], -q[1], -q[2], -q[3])
        units = [tuple(int(i == j) for j in range(4)) for i in range(4)]
        columns = [[2 * c for c in hamilton(e, back)[1:]] for e in units]
        directions = np.array(pack(columns), dtype=float).transpose(0, 2, 1)
        return directions, np.array(errors.parts(pack(q)), dtype=float)

    def tensor_entries(self, v: Any) -> tuple[Any, Any]:
        rotation = self.oracle.rotation(self.oracle.unpack(v))
        return errors.entry_twists(rotation), np.array(pack(rotation), dtype=float).reshape(2, 9)

    def round_trip(self) -> Iterator[Result]:
        """Yield v -> pose -> v, to compare with the principal shadow of v; allow 8 eps for n ≥ 2, 20 eps for n = 1."""
        gate = errors.ROUND_TRIP if self.order > 1 else errors.GENERAL
        inputs = self.module.pose(self.v)
        for v, got in zip(self.v, self.module.from_pose(inputs), strict=True):
            results = [self.oracle.on_branch(half, axis, 0) for half, axis in self.sides(v)]
            operators, entries = [self.oracle.operator_by_spin(r) for r in results], self.tensor_entries(v)
            scales = [errors.branch_scale(t, r, *entries) for t, r in zip(operators, results, strict=True)]
            if not self.inside:
                # The pose of a shadow is accurate only in norm: near 2π its small entries are differences.
                gate, local = errors.shadow_gate(self.order), errors.scales(self.order, v)
                backs = [inverse(t) for t in operators]
                lost = Nil(local.tensor.re, local.position)
                scales = [s + errors.through(back, lost) for s, back in zip(scales, backs, strict=True)]
            yield Result(got, [pack(r) for r in results], scales, (gate, gate), (v,))

    # ---- screws, shadows, composition --------------------------------------------------------------------------

    def from_screw(self) -> Iterator[Result]:
        if self.regime == "identity":
            return
        pairs = [self.oracle.to_screw(v) for v in self.v]
        angle, axis = (rounded(np.stack(column), self.dtype) for column in zip(*pairs, strict=True))
        for v, a, u, got in zip(self.v, angle, axis, self.module.from_screw(angle, axis), strict=True):
            exact = self.oracle.from_screw(a, u)
            (alpha,), direction = self.oracle.unpack(a), self.oracle.unpack(u)
            scale = errors.angle_scale(self.order, alpha, direction) + errors.size(exact)
            yield Result(got, [exact], [scale], self.gates("general"), (v,), f"angle = {a!r}, axis = {u!r}")

    def to_screw(self) -> Iterator[Result]:
        if self.regime == "identity":
            return
        angles, axes = self.module.to_screw(self.v)
        gates = self.gates("general")
        for v, angle, axis in zip(self.v, angles, axes, strict=True):
            alpha, u = self.oracle.reduced(self.oracle.unpack(v))
            other = [(2 * self.oracle.field.pi - alpha, tuple(-c for c in u))] if self.tie else []
            sides = [(alpha, u), *other]
            n, length, size = self.order, errors.norm(v[:3]), errors.norm(v[3:])
            turned = Nil(2 * n * math.atan(length), 2 * n / (1 + length**2) * size)
            direction = Nil(1.0, 2 * size / length if length else 0.0)
            yield Result(angle, [pack((a,)) for a, _ in sides], [turned] * len(sides), gates, (v,), "angle")
            yield Result(axis, [pack(b) for _, b in sides], [direction] * len(sides), gates, (v,), "axis")

    def shadow_scale(self, v: Any, result: Any) -> Nil:
        """Return the scale of a shadow, by its exact Jacobian T(v_k)⁻¹ T(v)."""
        here, there = (self.oracle.operator_by_spin(self.oracle.unpack(w)) for w in (v, result))
        return errors.size(result) + errors.through(matmul(inverse(there), here), errors.size(v))

    def shadow(self) -> Iterator[Result]:
        gate = errors.shadow_gate(self.order)
        for branch in self.branches():
            for v, got in zip(self.v, self.module.shadow(self.v, branch), strict=True):
                exact = [self.oracle.shadow(v, k) for k in ((branch, -branch) if self.tie else (branch,))]
                if self.regime == "pure translation" and branch:
                    scales = [self.translation_shadow_scale(branch, errors.norm(v[3:]))]
                else:
                    scales = [self.shadow_scale(v, e) for e in exact]
                yield Result(got, exact, scales, (gate, gate), (v,), f"branch {branch}")

    def principal(self) -> Iterator[Result]:
        gate = errors.shadow_gate(self.order)
        for v, got in zip(self.v, self.module.principal(self.v), strict=True):
            exact = [self.oracle.principal(v)]
            if self.tie:
                alpha, axis = self.oracle.reduced(self.oracle.unpack(v))
                exact.append(pack(self.oracle.on_branch(alpha / 2, axis, -1)))
            yield Result(got, exact, [self.shadow_scale(v, e) for e in exact], (gate, gate), (v,))

    def compose(self) -> Iterator[Result]:
        """Yield compositions of v, after v1, with v1 from the same regime and from the uniform one."""
        for v1 in self.partners():
            for a, b, got in zip(self.v, v1, self.module.compose(self.v, v1), strict=True):
                exact = self.oracle.compose(a, b)
                scale = self.compose_scale(a, b, exact)
                yield Result(got, [exact], [scale], self.gates("general"), (a, b))

    def compose_scale(self, v2: Any, v1: Any, result: Any) -> Nil:
        """Return the scale of a composition, by its exact Jacobians T(v)⁻¹ T(v2) and T(v)⁻¹ R(v2) T(v1)."""
        unpack, operator = self.oracle.unpack, self.oracle.operator_by_spin
        back = inverse(operator(unpack(result)))
        left = matmul(back, operator(unpack(v2)))
        right = matmul(back, matmul(self.oracle.rotation(unpack(v2)), operator(unpack(v1))))
        own = errors.size(result)
        return own + errors.through(left, errors.size(v2)) + errors.through(right, errors.size(v1))


FUNCTIONS = (*(name for name in PUBLIC if hasattr(Trial, name)), "round_trip")
"""Names of functions of `Trial`."""
