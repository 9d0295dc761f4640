"""Kernel functions from first principles, without derivatives, one pose at a time."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np

from tests.support.first_principles import E, FirstPrinciples, pack, remembered
from tests.support.nilpotent import Nil, conjugate, dot, hamilton, inverse, matmul, matvec, transpose, vect


def matrix6(tensor: np.ndarray) -> np.ndarray:
    """Return the real matrix that acts on dual vectors as a dual tensor does."""
    zero = tensor[0] * 0
    return np.block([[tensor[0], zero], [tensor[1], tensor[0]]])


class Maps(FirstPrinciples):
    """Forward and inverse maps, and motions."""

    def quaternion(self, v: Any) -> np.ndarray:
        return pack(self.unit(self.unpack(v)))

    def tensor(self, v: Any) -> np.ndarray:
        return pack(self.rotation(self.unpack(v)))

    def pose(self, v: Any) -> np.ndarray:
        r = self.rotation(self.unpack(v))
        q = tuple(tuple(c.re for c in row) for row in r)
        rho = vect(matmul([[c.du for c in row] for row in r], transpose(q)))
        zero = q[0][0] * 0
        rows = [(*row, shift) for row, shift in zip(q, rho, strict=True)]
        return np.array([*rows, (zero, zero, zero, zero + 1)], dtype=object)

    def tangent(self, v: Any) -> np.ndarray:
        return pack(self.operator(self.unpack(v)))

    def tangent_inv(self, v: Any) -> np.ndarray:
        return pack(inverse(self.operator(self.unpack(v))))

    def body_tangent(self, v: Any) -> np.ndarray:
        """Return the operator with the body twist for v̇ = e_j as column j."""
        dual = self.unpack(v)

        def column(e: Any) -> tuple[Any, ...]:
            r, r_dot = self.rotation_and_derivative(dual, [Nil(dual[0].re * 0 + c, dual[0].re * 0) for c in e])
            return vect(matmul(transpose(r), r_dot))

        return pack(transpose([column(e) for e in E]))

    def body_tangent_inv(self, v: Any) -> np.ndarray:
        dual = self.unpack(v)
        return pack(matmul(inverse(self.operator(dual)), self.rotation(dual)))

    def inverse(self, v: Any) -> np.ndarray:
        """Return the vector of the inverse pose, by the conjugate of |v| cot θ + v."""
        dual = self.unpack(v)
        theta, axis = self.half_screw(conjugate((self.base(dual), *dual)))
        return pack(dual if axis is None else tuple(self.size(theta) * c for c in axis))

    def twist(self, v: Any, v_dot: Any) -> np.ndarray:
        return pack(self.space_twist(self.unpack(v), self.unpack(v_dot)))

    def body_twist(self, v: Any, v_dot: Any) -> np.ndarray:
        r, r_dot = self.rotation_and_derivative(self.unpack(v), self.unpack(v_dot))
        return pack(vect(matmul(transpose(r), r_dot)))

    def rate(self, v: Any, omega: Any) -> np.ndarray:
        return pack(matvec(inverse(self.operator(self.unpack(v))), self.unpack(omega)))

    def body_rate(self, v: Any, omega: Any) -> np.ndarray:
        dual = self.unpack(v)
        return pack(matvec(inverse(self.operator(dual)), matvec(self.rotation(dual), self.unpack(omega))))

    # ---- inverse maps, screws ----------------------------------------------------------------------------------------

    def from_quaternion(self, q: Any, branch: int = 0) -> np.ndarray:
        return pack(self.vector_of(self.unpack(q), branch))

    def from_tensor(self, r: Any, branch: int = 0) -> np.ndarray:
        return pack(self.vector_of(self.quaternion_of(self.unpack_tensor(r)), branch))

    def from_pose(self, t: Any, branch: int = 0) -> np.ndarray:
        number = self.field.number
        q = tuple(tuple(number(t[i][j]) for j in range(3)) for i in range(3))
        x, y, z = (number(t[i][3]) for i in range(3))
        moments = matmul(((0, -z, y), (z, 0, -x), (-y, x, 0)), q)
        dual = tuple(tuple(Nil(a, b) for a, b in zip(*rows, strict=True)) for rows in zip(q, moments, strict=True))
        return pack(self.vector_of(self.quaternion_of(dual), branch))

    def from_screw(self, angle: Any, axis: Any) -> np.ndarray:
        (alpha,) = self.unpack(angle)
        size = self.size(alpha / (2 * self.order))
        return pack(tuple(size * c for c in self.unpack(axis)))

    def to_screw(self, v: Any) -> tuple[np.ndarray, np.ndarray]:
        alpha, axis = self.reduced(self.unpack(v))
        if axis is None:
            nan = self.field.number(float("nan"))
            axis = (Nil(nan, nan),) * 3
        return pack((alpha,)), pack(axis)

    def angle(self, v: Any) -> np.ndarray:
        """Return the angle on v's own branch."""
        dual = self.unpack(v)
        theta, _ = self.half_screw((self.base(dual), *dual))
        return pack((2 * self.order * theta,))

    def to_exponential(self, v: Any) -> np.ndarray:
        """Return α u on v's own branch."""
        dual = self.unpack(v)
        theta, axis = self.half_screw((self.base(dual), *dual))
        return pack([2 * self.order * theta * c for c in axis or dual])

    def from_exponential(self, w: Any) -> np.ndarray:
        """Return v, inside the edge, on the branch with exponential coordinates w."""
        half, axis = self.half_screw(self.step(self.unpack(w)))
        along = sum(float(a.re) * float(b) for a, b in zip(axis or (), w, strict=False))
        return pack(self.on_branch(half, axis, round((along / 2 - float(half.re)) / np.pi)))

    # ---- branches, groups, motions -----------------------------------------------------------------------------------

    @remembered
    def shadow(self, v: Any, branch: int = 1) -> np.ndarray:
        dual = self.unpack(v)
        alpha, axis = self.reduced(dual)
        if axis is None:
            return pack(self.on_branch(alpha, None, branch))
        # Branch 0 is v itself; other branches add turns to its angle along the axis.
        coefficient = dot(dual, axis)
        own = self.field.atan2(coefficient, self.base(dual)) + branch * self.field.pi / self.order
        size = self.size(own)
        return pack(tuple(size * c for c in axis))

    def principal(self, v: Any) -> np.ndarray:
        alpha, axis = self.reduced(self.unpack(v))
        return pack(self.on_branch(alpha / 2, axis, 0))

    @remembered
    def compose(self, v2: Any, v1: Any) -> np.ndarray:
        return pack(self.vector_of(hamilton(self.unit(self.unpack(v2)), self.unit(self.unpack(v1)))))

    @remembered
    def between(self, v2: Any, v1: Any) -> np.ndarray:
        return pack(self.vector_of(hamilton(conjugate(self.unit(self.unpack(v1))), self.unit(self.unpack(v2)))))

    @remembered
    def step(self, delta: Any) -> tuple[Any, ...]:
        """Return exp(δ/2), the unit dual quaternion of a step."""
        half = tuple(c / 2 for c in delta)
        if all(c.re == 0 for c in half):
            return (Nil(half[0].re + 1, half[0].re), *half)
        length = self.field.sqrt(dot(half, half))
        return (self.field.cos(length), *(self.field.sin(length) * c / length for c in half))

    def retract(self, v: Any, delta: Any, body: bool = False, other: bool = False) -> np.ndarray:
        """Return the new vector on the branch with the angle, along the new axis, nearest to the angle of v.

        Of two branches, return the one that a step of at most half a turn leads to, or the other one.
        """
        here, small = self.unpack(v), self.step(self.unpack(delta))
        q = hamilton(self.unit(here), small) if body else hamilton(small, self.unit(here))
        if self.order == 2 and (small[0].re < 0) != other:
            q = tuple(-c for c in q)
        half, axis = self.half_screw(q)
        theta, own = self.half_screw((self.base(here), *here))
        if axis is None or self.order == 2:
            return pack(self.on_branch(half, axis, 0))
        along = 0 if own is None else self.order * theta.re * dot(own, axis).re
        turns = int(self.field.number(round(float((along - half.re) / self.field.pi))))
        return pack(self.on_branch(half, axis, turns))

    def local(self, v2: Any, v1: Any, body: bool = False) -> np.ndarray:
        later, sooner = self.unit(self.unpack(v2)), conjugate(self.unit(self.unpack(v1)))
        q = hamilton(sooner, later) if body else hamilton(later, sooner)
        half, axis = self.half_screw(tuple(-c for c in q) if q[0].re < 0 else q)
        zero = half.re * 0
        return pack(tuple(2 * half * c for c in axis or (Nil(zero, zero),) * 3))

    def interpolate(self, v1: Any, v2: Any, t: Any, steps: int = 24) -> np.ndarray:
        """Follow the motion in small steps; each takes the exponential coordinates α u nearest to the previous ones."""
        here, (share,) = self.unpack(v1), np.ravel(t)
        way = hamilton(self.unit(self.unpack(v2)), conjugate(self.unit(here)))
        half, axis = self.half_screw(tuple(-c for c in way) if way[0].re < 0 else way)
        theta, own = self.half_screw((self.base(here), *here))
        zero = half.re * 0
        direction = axis or (Nil(zero, zero),) * 3
        at = np.array([float(2 * self.order * theta.re * c.re) for c in own or direction])
        for step in range(steps + 1):
            gone = half * (self.field.number(share) * step / steps)
            q = (self.field.cos(gone), *(self.field.sin(gone) * c for c in direction))
            now, u = self.half_screw(hamilton(q, self.unit(here)))
            line = np.array([float(c.re) for c in u or direction])
            turns = [(np.linalg.norm(2 * (float(now.re) + k * np.pi) * line - at), abs(k), k) for k in range(-5, 6)]
            turn = min(turns)[-1]
            at = 2 * (float(now.re) + turn * np.pi) * line
        return pack(self.on_branch(now, u, turn))

    def adjoint(self, v: Any) -> np.ndarray:
        return matrix6(self.tensor(v))

    def transform_point(self, v: Any, r: Any) -> np.ndarray:
        pose = self.pose(v)
        return pose[:3, :3] @ np.array([self.field.number(c) for c in r], dtype=object) + pose[:3, 3]

    def transform_line(self, v: Any, line: Any) -> np.ndarray:
        return pack(matvec(self.rotation(self.unpack(v)), self.unpack(line)))

    body_retract = functools.partialmethod(retract, body=True)
    body_local = functools.partialmethod(local, body=True)
