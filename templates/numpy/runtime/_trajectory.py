"""Trajectory of a motion from its steps: poses, branches, derivatives and covariances at any time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from scipy.optimize import brentq  # type: ignore[import, unused-ignore]

from ._derived import pose_of, tensor_of
from ._kernel import Array
from ._stepping import Form, Problem, Step, displaced, largest_angle
from ._tools import matrix6

NODES, WEIGHTS = np.polynomial.legendre.leggauss(5)
"""Quadrature of the noise, exact for polynomials of degree 9 between two times."""

OFFSETS = np.arange(-2, 3)
"""Five times around t, in units of the increment, for the derivative of a twist."""

TO_COEFFICIENTS = np.linalg.inv(np.vander(OFFSETS, increasing=True))

INCREMENT = 2e-3
"""Increment in steps. The derivative is off by about 3e-12 and 1e-13 of the twist per step, by order and rounding."""


@dataclass(frozen=True)
class Trajectory:
    """Steps of a problem; without a step, the start alone."""

    problem: Problem
    form: Form
    steps: Sequence[Step]
    begin: float
    start: Any
    switched: bool

    @property
    def module(self) -> Any:
        return self.problem.module

    @property
    def end(self) -> float:
        return self.steps[-1].end if self.steps else self.begin

    def quaternions(self, t: Array) -> Array:
        """Return unit dual quaternions (T, 8) whose sign is continuous along the motion."""
        if not self.steps:
            return np.tile(np.array(self.start, float), (len(t), 1))
        places = self._places(t)
        y = np.empty((6, len(t)))
        for place in np.unique(places):
            y[:, places == place] = self.steps[place].local(t[places == place])
        centres, starts = (table[places].T for table in self._tables)
        q = np.array(displaced(np, self.problem.frame, self.form.quaternion(y), centres))
        return np.asarray((q * np.where(np.sum(q[:4] * starts[:4], axis=0) < 0, -1, 1)).T)

    @cached_property
    def _tables(self) -> tuple[Array, Array]:
        """Centres and starting poses of the steps, (S, 8) each."""
        centres, starts = ([getattr(step, name) for step in self.steps] for name in ("centre", "start"))
        return np.array(centres, float), np.array(starts, float)

    def _places(self, t: Array) -> Array:
        """Return the index of the step that holds each time."""
        ends = [step.end for step in self.steps]
        return np.minimum(np.searchsorted(ends, t), len(ends) - 1)

    @cached_property
    def switches(self) -> Array:
        """Times where v changes its branch, because the rotation angle of v passes its limit.

        The quaternion, with the sign that belongs to v, then passes the cosine of half the limit.
        """
        limit = np.cos(largest_angle(self.problem.module) / 2)
        found, side = [self.begin] if self.switched else [], 1.0

        def excess(t: float) -> float:
            return float(side * self.quaternions(np.array([t]))[0, 0] - limit)

        scalars = [*(step.start[0] for step in self.steps[1:]), self.quaternions(np.array([self.end]))[0, 0]]
        for step, scalar in zip(self.steps, scalars):
            if side * scalar < limit:
                within = excess(step.begin) > 0 > excess(step.end)  # false only by rounding at an end
                root: Any = brentq(excess, step.begin, step.end) if within else step.end
                found.append(root)
                side = -side
        return np.array(found, float)

    def vectors(self, t: Array) -> tuple[Array, Array, Array]:
        """Return v (T, 6), poses (T, 4, 4) and branches (T,), each the one that `shadow` takes from the principal v.

        v has the direction of the quaternion's vector part, also at half a turn within rounding.
        """
        changes = np.searchsorted(self.switches, t, side="right") - self.switched
        q = self.quaternions(t) * np.where(changes % 2, -1, 1)[:, None]
        module, near = self.problem.module, self.problem.module.from_quaternion(q)
        beyond = np.sum(near[:, :3] * q[:, 1:4], axis=-1, keepdims=True) < 0
        v = np.where(beyond, module.from_quaternion(q, -1), near)
        branch, count = -np.any(module.principal(v) != v, axis=-1).astype(int), module.CHART.branches
        return v, poses(q), branch % count if count else branch

    def derivative(self, t: Array, order: int) -> Array:
        """Return v or its first or second time derivative (T, 6)."""
        v = self.vectors(t)[0]
        if order == 0:
            return v
        twist, module = np.array([self.problem.twist(float(one)) for one in t]).reshape(-1, 6), self.problem.module
        prefix = "" if self.problem.frame == "space" else "body_"
        if order == 1:
            return np.asarray(getattr(module, f"{prefix}rate")(v, twist))
        return np.asarray(getattr(module, f"{prefix}rate_dot")(v, twist, self._twist_dot(t)))

    def _twist_dot(self, t: Array) -> Array:
        """Return the derivative of the twist: the spline's, or a polynomial's through five values in the step.

        NaN without a step.
        """
        known = self.problem.twist.derivative(t)
        if known is not None:
            return known
        found = np.full((len(t), 6), np.nan)
        for row, one, place in zip(found, t, self._places(t) if self.steps else ()):
            begin, end = self.steps[place].begin, self.steps[place].end
            h = INCREMENT * (end - begin)
            middle = np.clip(one, begin + 2 * h, end - 2 * h)
            times = np.minimum(middle + h * OFFSETS, np.nextafter(end, begin))  # the twist may jump at the end
            values = np.array([self.problem.twist(time) for time in times.tolist()])
            powers = [k * ((one - middle) / h) ** (k - 1) if k else 0.0 for k in range(5)]
            row[:] = powers @ TO_COEFFICIENTS @ values / h
        return found

    def covariances(self, t: Array, v0: Array, covariance: Array, noise: Array | None) -> Array:
        """Return covariances of v (T, 6, 6).

        A prescribed space twist multiplies the pose from the left and keeps the perturbation δ at the right, which is
        ``body_tangent(v) v̇``. So the covariance of δ is constant, and noise n adds ``Ad(R⁻¹) n`` to its rate.
        In the body frame the sides change: ``tangent(v)`` and ``Ad(R)``.
        """
        module, space = self.problem.module, self.problem.frame == "space"
        forward, backward = (module.body_tangent, module.body_tangent_inv) if space else (
            module.tangent, module.tangent_inv)  # fmt: skip
        first, last = matrix6(forward(v0)), matrix6(backward(self.vectors(t)[0]))
        constant = first @ covariance @ first.T
        return np.asarray(last @ (constant + self._noise(t, noise)) @ last.swapaxes(-1, -2))

    def _noise(self, t: Array, noise: Array | None) -> Array | float:
        """Return the integrals of the noise from the first time to each, in the frame where δ is constant."""
        if noise is None:
            return 0.0
        knots = np.union1d(t, [self.begin, *(step.end for step in self.steps if step.end <= t[-1])])
        half = np.diff(knots) / 2
        times = knots[:-1, None] + half[:, None] * (1 + NODES)
        tensors = np.stack(tensor_of([*self.quaternions(times.ravel()).T]), axis=-1).reshape(-1, 2, 3, 3)
        moved = matrix6(tensors.swapaxes(-1, -2) if self.problem.frame == "space" else tensors)
        parts = (moved @ noise @ moved.swapaxes(-1, -2)).reshape(*times.shape, 6, 6)
        sums = np.cumsum(np.einsum("i,j,ijkl->ikl", half, WEIGHTS, parts), axis=0)
        return np.concatenate([np.zeros((1, 6, 6)), sums])[np.searchsorted(knots, t)]


def poses(q: Array) -> Array:
    """Return homogeneous matrices (T, 4, 4) of unit dual quaternions (T, 8)."""
    matrices = np.tile(np.eye(4), (len(q), 1, 1))
    matrices[:, :3] = np.stack(pose_of([*q.T]), axis=-1).reshape(-1, 3, 4)
    return matrices
