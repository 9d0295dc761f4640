"""Curve of a spline of poses: products of factors Cay(λ(t) d), their twists, and derivatives by the control poses."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import comb
from typing import Any

import numpy as np

from ._arguments import vector_size
from ._factors import COEFFICIENTS, STEPS, bracket, programs, shares
from ._kernel import Array
from ._motion import OfModule
from ._runtime import call
from ._tools import matrix6

IMAGINARY = 1e-20
"""Imaginary step of the derivative of ``body_tangent_dot``, whose square is lost beside 1: exact within rounding."""

BLOCK = 4096
"""Number of times computed at once, whose values fit into the cache."""


@dataclass(frozen=True)
class Group(OfModule):
    """Poses (..., 4, 4), or rotations (..., 3, 3), of a kernel module. Twists have ``size`` 6 or 3 components."""

    module: Any

    def __post_init__(self) -> None:
        vector_size(self.module)

    @cached_property
    def size(self) -> int:
        return vector_size(self.module)

    def matrix(self, v: Array) -> Array:
        return np.asarray((self.module.pose if self.size == 6 else self.module.tensor)(v))

    def vector(self, X: Array) -> Array:
        return np.asarray((self.module.from_pose if self.size == 6 else self.module.from_tensor)(X))

    def steps(self, controls: Array, former: Array | None = None) -> Array:
        """Return vectors from each pose to the next: principal ones, or those of the branch nearest to former ones."""
        d = self.vector(self.between(controls[:-1], controls[1:]))
        if former is None:
            return d
        other = np.asarray(self.module.shadow(d, -1))
        nearer = np.linalg.norm(other - former, axis=-1) < np.linalg.norm(d - former, axis=-1)
        return np.where(nearer[:, None], other, d)

    def between(self, X: Array, Y: Array) -> Array:
        """Return X⁻¹ Y, without loss of digits far from the origin."""
        turned = X[..., :3, :3].swapaxes(-1, -2)
        found = np.array(np.broadcast_arrays(Y, X)[0])
        found[..., :3, :3] = turned @ Y[..., :3, :3]
        if self.size == 6:
            found[..., :3, 3] = (turned @ (Y[..., :3, 3] - X[..., :3, 3])[..., None])[..., 0]
        return found

    def operator(self, tensor: Array) -> Array:
        """Return the matrix of a tensor of the module on twists."""
        return matrix6(tensor) if self.size == 6 else tensor

    def bracket_by(self, w: Array) -> Array:
        """Return the matrix that takes x to the bracket of w and x."""
        return np.stack(bracket([*w.T[..., None]], [*np.eye(self.size)[:, None]]), axis=-2)


@dataclass(frozen=True)
class Curve:
    """Cumulative cubic B-spline of N control poses, the vectors of N - 1 steps between them, and N + 4 knots.

    It lasts from knot 3 to the last but three.
    """

    group: Group
    knots: Array
    controls: Array
    steps: Array

    @cached_property
    def breaks(self) -> Array:
        """Knots between which the curve is smooth, from its first time to its last."""
        return self.knots[3:-3]

    @cached_property
    def slopes(self) -> tuple[Array, Array]:
        """Derivatives of the steps by body steps of the pose before, and of the pose after."""
        module, operator = self.group.module, self.group.operator
        return -operator(module.tangent_inv(self.steps)), operator(module.body_tangent_inv(self.steps))

    @cached_property
    def spans(self) -> Array:
        """Columns of data of a span: 1/length, coefficients of three parts λ by powers, three steps, control pose.

        A part λ is a sum of cubic B-splines of the share u of the span that has passed. Its slope is 3 Q/s with a
        quadratic B-spline Q and the length s of its knots.
        """
        a, b, c, d, e, f = (self.knots[k : len(self.knots) - 7 + k] for k in range(1, 7))
        h = d - c
        early, late = h / (d - b), h / (e - c)
        quadratic = [[early, -2 * early, early], [1 - early, 2 * early, -early - late], [0 * h, 0 * h, late]]
        starts = 1 - h * early / (d - a), (1 - early) * (c - b) / (e - b), 0 * h
        rows = [1 / h]
        for start, length, slope in zip(starts, (d - a, e - b, f - c), quadratic):
            rows += [start, *(3 * h / length * part / k for k, part in enumerate(slope, 1))]
        steps = (self.steps[k : len(self.steps) - 2 + k].T for k in range(3))
        return np.concatenate([rows, *steps, self.controls[: len(h), :3].reshape(len(h), -1).T])

    def place(self, t: Array) -> tuple[Array, Array]:
        """Return the spans of times, and the share of the span that has passed."""
        span = np.clip(np.searchsorted(self.breaks, t, side="right") - 1, 0, len(self.breaks) - 2)
        return span, (t - self.breaks[span]) / np.diff(self.breaks)[span]

    def parts(self, t: Array) -> tuple[Array, Array]:
        """Return control poses of times (T, 4), and λ, λ̇, λ̈ of three factors, shape (3, T, 3)."""
        span, share = self.place(t)
        coefficients = self.spans[COEFFICIENTS:STEPS, span].reshape(3, 4, -1).swapaxes(0, 1)
        parts = shares(share, self.spans[0, span], [*coefficients])
        return span[:, None] + np.arange(4), np.array(parts).swapaxes(1, 2)

    def values(self, name: str, t: Array) -> Array:
        """Return a quantity of `ORDERS` at times (T,), block by block in the same memory."""
        chart, name = programs(self.group.module.CHART), f"spline_{name}"
        found = np.empty((len(t), *chart.kernels[name].shape))
        rows = np.empty((len(self.spans), min(len(t), BLOCK)))
        for start in range(0, len(t), BLOCK):
            block = slice(start, start + BLOCK)
            span, share = self.place(t[block])
            data = np.take(self.spans, span, axis=1, out=rows[:, : len(span)], mode="clip")
            call(chart, name, 0, np.moveaxis(found[block], 0, -1), share, data)
        return found

    def jacobians(self, t: Array) -> list[Array]:
        """Return control poses (T, 4), and derivatives (T, 4, size, size) of pose, body twist and its derivative."""
        size, (index, pose, rate, second) = self.group.size, self.variations(t, 2)
        twists = self.values("body_twist", t), self.values("body_acceleration", t)
        by_twist, by_change = map(self.group.bracket_by, twists)
        found = pose, rate + by_twist @ pose, second + by_change @ pose + by_twist @ rate
        return [index, *(part.reshape(-1, size, 4, size).swapaxes(1, 2) for part in found)]

    def variations(self, t: Array, order: int) -> list[Array]:
        """Return control poses (T, 4), the body step of the pose by theirs (T, size, 4 size), and time derivatives.

        A factor A takes a step ε to A⁻¹ ε A and adds G δd.
        """
        (index, parts), size = self.parts(t), self.group.size
        found = [np.zeros((len(t), size, 4 * size)) for _ in range(order + 1)]
        found[0][:, :, :size] = np.eye(size)
        for k in range(3):
            row = index[:, k]
            back, gains = self._factor(self.steps[row], parts[: order + 1, :, k, None])
            terms = [[comb(n, i) * back[i] @ found[n - i] for i in range(n + 1)] for n in range(order + 1)]
            found = [np.sum(one, axis=0) for one in terms]
            for one, gain in zip(found, gains):
                for place, slope in enumerate(self.slopes, k):
                    one[..., place * size : (place + 1) * size] += gain @ slope[row]
        return [index, *found]

    def _factor(self, d: Array, parts: Array) -> tuple[list[Array], list[Array]]:
        """Return the matrices of ε ↦ A⁻¹ ε A and of ``G = λ T(λd)``, and their time derivatives."""
        group, module, (part, *rates) = self.group, self.group.module, parts
        v, rate_of_v = part * d, [rate * d for rate in rates]
        T = group.operator(module.body_tangent(v))
        back, gains = [module.adjoint(-v)], [part[..., None] * T]
        if rates:
            turning = group.bracket_by(module.body_twist(v, rate_of_v[0]))
            changing = group.bracket_by(module.body_twist_dot(v, *rate_of_v))
            back += [-turning @ back[0], (turning @ turning - changing) @ back[0]]
            T_dot = group.operator(module.body_tangent_dot(v, d))
            curved = group.operator(module.body_tangent_dot(v + 1j * IMAGINARY * d, d + 0j).imag / IMAGINARY)
            part, rate, change = (one[..., None] for one in parts)
            gains += [rate * (T + part * T_dot), change * (T + part * T_dot) + rate**2 * (2 * T_dot + part * curved)]
        return back, gains


def of_controls(group: Group, t: Array, controls: Array, period: float | None) -> Curve:
    """Return the curve with given control poses."""
    count = len(controls)
    if period is not None:
        if len(t) != count + 1:
            raise ValueError(f"t must have {count + 1} knots for a closed curve of {count} control poses, got {len(t)}")
        knots, controls = around(t), controls[np.arange(-1, count + 2) % count]
    elif count >= 4 and len(t) in (count - 2, count):
        knots = clamped(t if len(t) < count else np.delete(t, [1, -2]))
    elif count >= 4 and len(t) == count + 4:
        knots = t
    else:
        raise ValueError(f"t must have N, N - 2 or N + 4 knots for N ≥ 4 control poses, got {len(t)} for {count}")
    return Curve(group, knots, controls, group.steps(controls))


def clamped(t: Array) -> Array:
    """Return knots whose ends are fourfold: the curve begins and ends at control poses."""
    return np.pad(t, 3, mode="edge")


def around(t: Array) -> Array:
    """Return knots with three further ones at both ends, from the other side of a period."""
    k, count = np.arange(-3, len(t) + 3), len(t) - 1
    return np.asarray(np.where(k == count, t[-1], t[k % count] + (t[-1] - t[0]) * (k // count)))
