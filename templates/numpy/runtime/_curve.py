"""Curve of a spline of poses: products of factors Cay(λ(t) d), their twists, and derivatives by the control poses."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
from numpy.polynomial import polynomial

from ._kernel import Array
from ._motion import OfModule
from ._tools import matrix6

IMAGINARY = 1e-20
"""Imaginary step of the derivative of ``body_tangent_dot``, whose square is lost beside 1: exact within rounding."""


Factors: TypeAlias = tuple[Array, Array, list[Array]]
"""Spans of times, steps of three factors, and their parts λ with time derivatives."""


@dataclass(frozen=True)
class Group(OfModule):
    """Poses (..., 4, 4), or rotations (..., 3, 3), of a kernel module. Twists have ``size`` 6 or 3 components."""

    module: Any

    @cached_property
    def size(self) -> int:
        return len(self.module.identity())

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

    def adjoint(self, X: Array) -> Array:
        """Return the matrices that take body twists to the space frame."""
        Q = X[..., :3, :3]
        if self.size == 3:
            return Q
        moved = np.cross(X[..., None, :3, 3], Q.swapaxes(-1, -2)).swapaxes(-1, -2)
        return np.asarray(matrix6(np.stack([Q, moved], axis=-3)))

    def carried(self, v: Array, w: Array) -> Array:
        """Return twists after a motion by v."""
        return np.asarray((self.module.transform_line if self.size == 6 else self.module.transform_point)(v, w))

    def operator(self, tensor: Array) -> Array:
        """Return the matrix of a tensor of the module on twists."""
        return matrix6(tensor) if self.size == 6 else tensor

    def bracket(self, w: Array, x: Array) -> Array:
        """Return the bracket of twists, the derivative of x if the twist w carries it."""
        turned = np.cross(w[..., :3], x[..., :3])
        if self.size == 3:
            return np.asarray(turned)
        return np.concatenate([turned, np.cross(w[..., :3], x[..., 3:]) + np.cross(w[..., 3:], x[..., :3])], axis=-1)

    def bracket_by(self, w: Array) -> Array:
        """Return the matrix that takes x to the bracket of w and x."""
        return self.bracket(w[..., None, :], np.eye(self.size)).swapaxes(-1, -2)


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
    def table(self) -> Array:
        """Coefficients of λ₁, λ₂, λ₃ by powers of the part u of a span that has passed, shape (4, 3, spans).

        λ is a sum of cubic B-splines. Its slope is 3 Q/s with a quadratic B-spline Q and the length s of its knots.
        """
        a, b, c, d, e, f = (self.knots[k : len(self.knots) - 7 + k] for k in range(1, 7))
        h = d - c
        early, late = h / (d - b), h / (e - c)
        quadratic = [[early, -2 * early, early], [1 - early, 2 * early, -early - late], [0 * h, 0 * h, late]]
        weights = 3 * h / np.array([d - a, e - b, f - c])
        rising = np.array(quadratic) * weights[:, None] / np.array([1, 2, 3])[:, None]
        start = np.array([1 - h * early / (d - a), (1 - early) * (c - b) / (e - b), 0 * h])
        return np.ascontiguousarray(np.concatenate([start[:, None], rising], axis=1).swapaxes(0, 1))

    @cached_property
    def adjoints(self) -> Array:
        return self.group.adjoint(self.controls)

    def factors(self, t: Array, order: int) -> Factors:
        """Return spans of times, the steps of their factors (3, T, size), and λ, λ̇, … (3, T, 1)."""
        span = np.clip(np.searchsorted(self.breaks, t, side="right") - 1, 0, len(self.breaks) - 2)
        length = np.diff(self.breaks)[span]
        part, powers = (t - self.breaks[span]) / length, np.take(self.table, span, axis=-1)
        derivatives = []
        for k in range(order + 1):
            derivatives.append((polynomial.polyval(part, powers, tensor=False) / length**k)[..., None])
            powers = polynomial.polyder(powers)
        return span, np.take(self.steps, span + np.arange(3)[:, None], axis=0), derivatives

    def poses(self, factors: Factors) -> Array:
        span, d, (part, *_) = factors
        first, second, third = self.group.matrix(part * d)
        return np.asarray(np.take(self.controls, span, axis=0) @ first @ second @ third)

    def twists(self, factors: Factors, frame: str = "body") -> list[Array]:
        """Return the twists (T, size), and their time derivatives if the factors have second ones.

        Twist and step of a factor have one screw, so its twist is the same in both of its frames.
        """
        (span, d, (part, *_)), group, side = factors, self.group, 1 if frame == "space" else -1
        own = [values[::-side] for values in self._own_twists(factors)]
        found = [values[0] for values in own]
        for m, place in enumerate((side * part * d)[::-side][1:], 1):
            before = [group.carried(place, one) for one in found]
            found = [one + values[m] for one, values in zip(before, own)]
            if len(found) == 2:
                found[1] -= side * group.bracket(before[0], own[0][m])
        if frame == "space":
            found = [(np.take(self.adjoints, span, axis=0) @ one[..., None])[..., 0] for one in found]
        return found

    def _own_twists(self, factors: Factors) -> list[Array]:
        """Return the twists of the factors (3, T, size), and their time derivatives if asked for."""
        _, d, (part, *rates) = factors
        kernels = self.group.module.body_twist, self.group.module.body_twist_dot
        given = [part * d, *(rate * d for rate in rates)]
        return [kernel(*given[: k + 2]) for k, kernel in enumerate(kernels[: len(rates)])]

    def jacobians(self, factors: Factors) -> list[Array]:
        """Return derivatives (T, 4, size, size) of pose, body twist and its derivative by steps of control poses."""
        size, count = self.group.size, len(factors[0])
        pose, rate, second = self.variations(factors)
        by_twist, by_change = map(self.group.bracket_by, self.twists(factors))
        found = pose, rate + by_twist @ pose, second + by_change @ pose + by_twist @ rate
        return [part.reshape(count, size, 4, size).swapaxes(1, 2) for part in found]

    def variations(self, factors: Factors) -> Array:
        """Return the body step of the pose by body steps of its control poses, and its time derivatives.

        The shape is (orders, T, size, 4 size). A factor A takes a step ε to A⁻¹ ε A and adds ``T(λd) λ δd``.
        """
        (span, d, (part, *_)), size, order = factors, self.group.size, len(factors[2]) - 1
        gains, back = self._gains(factors), self.group.module.adjoint(-part * d)
        turning = [self.group.bracket_by(w) for w in self._own_twists(factors)]
        found = np.zeros((order + 1, len(span), size, 4 * size))
        found[0, :, :, :size] = np.eye(size)
        for m in range(3):
            moved = back[m] @ found
            found = moved.copy()
            if order:
                found[1] -= turning[0][m] @ moved[0]
            if order == 2:
                found[2] -= turning[0][m] @ (moved[1] + found[1]) + turning[1][m] @ moved[0]
            for pose, slope in zip((m, m + 1), self.slopes):
                found[..., pose * size : (pose + 1) * size] += gains[:, m] @ slope[span + m]
        return found

    def _gains(self, factors: Factors) -> Array:
        """Return ``G = λ T(λd)`` and its time derivatives, shape (orders, 3, T, size, size)."""
        module, operator, (_, d, parts) = self.group.module, self.group.operator, factors
        v, (part, *rates) = parts[0] * d, (one[..., None] for one in parts)
        T = operator(module.body_tangent(v))
        found = [part * T]
        if rates:
            T_dot = operator(module.body_tangent_dot(v, d))
            slope = T + part * T_dot
            found.append(rates[0] * slope)
        if len(rates) == 2:
            curved = operator(module.body_tangent_dot(v + 1j * IMAGINARY * d, d + 0j).imag / IMAGINARY)
            found.append(rates[1] * slope + rates[0] ** 2 * (2 * T_dot + part * curved))
        return np.array(found)


def clamped(t: Array) -> Array:
    """Return knots whose ends are fourfold: the curve begins and ends at control poses."""
    return np.pad(t, 3, mode="edge")


def around(t: Array) -> Array:
    """Return knots with three further ones at both ends, from the other side of a period."""
    k, count = np.arange(-3, len(t) + 3), len(t) - 1
    return np.asarray(np.where(k == count, t[-1], t[k % count] + (t[-1] - t[0]) * (k // count)))
