"""Oracle with derivatives: T is differentiated along each axis of v."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np

from tests.support.first_principles import DIGITS, E, along, pack, remembered
from tests.support.nilpotent import Nil, conjugate, dot, hamilton, inverse, matmul, matvec, split, transpose, vect
from tests.support.oracle_maps import Maps, matrix6


def scaled(tensor: Any, factor: Any) -> Any:
    return tuple(tuple(c * factor for c in row) for row in tensor)


def added(a: Any, b: Any) -> Any:
    """Return the sum of vectors, or of tensors."""
    return tuple(added(p, q) if isinstance(p, tuple) else p + q for p, q in zip(a, b, strict=True))


def directional(slopes: Any, direction: Any) -> Any:
    """Return the derivative of a tensor along a direction, from its derivatives along the axes."""
    return functools.reduce(added, (scaled(slope, c) for slope, c in zip(slopes, direction, strict=True)))


def applied_jacobian(slopes: Any, w: Any) -> np.ndarray:
    """Return the derivative of a tensor applied to a fixed w, as a real matrix."""
    return matrix6(pack(transpose([matvec(slope, w) for slope in slopes])))


def turned(q: Any) -> Any:
    """Return the tensor of a unit quaternion, whose columns are the turned axes."""
    return transpose([hamilton(hamilton(q, (0, *e)), conjugate(q))[1:] for e in E])


@functools.cache
def oracle_of(order: int, digits: int = DIGITS) -> Oracle:
    """Return the oracle of an order, shared by all tests because it remembers results."""
    return Oracle(order, digits)


class Oracle(Maps):
    """Oracle with derivatives of operators and Jacobians."""

    def frame_operator(self, v: Any, body: bool) -> Any:
        """Return T, or in the body frame Rᵀ T."""
        operator = self.operator_by_spin(v)
        return matmul(transpose(self.rotation(v)), operator) if body else operator

    @remembered
    def gradient(self, v: Any, body: bool) -> tuple[Any, tuple[Any, ...]]:
        """Return the operator of a frame, and its derivatives along the three axes."""
        units = [[Nil(a.re * 0 + c, a.re * 0) for a, c in zip(v, e, strict=True)] for e in E]
        values, slopes = zip(*(split(self.frame_operator(along(v, unit), body)) for unit in units), strict=True)
        return values[0], slopes

    @remembered
    def gradient_inv(self, v: Any, body: bool) -> tuple[Any, tuple[Any, ...]]:
        """Return the inverse operator of a frame and its derivatives along the three axes."""
        operator, slopes = self.gradient(v, body)
        back = inverse(operator)
        return back, tuple(scaled(matmul(back, matmul(slope, back)), -1) for slope in slopes)

    def tangent_dot(self, v: Any, v_dot: Any, body: bool = False) -> np.ndarray:
        return pack(directional(self.gradient(self.unpack(v), body)[1], self.unpack(v_dot)))

    def twist_dot(self, v: Any, v_dot: Any, v_ddot: Any, body: bool = False) -> np.ndarray:
        (operator, slopes), rate = self.gradient(self.unpack(v), body), self.unpack(v_dot)
        return pack(added(matvec(operator, self.unpack(v_ddot)), matvec(directional(slopes, rate), rate)))

    def rate_dot(self, v: Any, omega: Any, omega_dot: Any, body: bool = False) -> np.ndarray:
        (back, slopes), twist = self.gradient_inv(self.unpack(v), body), self.unpack(omega)
        change = directional(slopes, matvec(back, twist))
        return pack(added(matvec(back, self.unpack(omega_dot)), matvec(change, twist)))

    def twist_jacobian(self, v: Any, v_dot: Any, body: bool = False) -> np.ndarray:
        return applied_jacobian(self.gradient(self.unpack(v), body)[1], self.unpack(v_dot))

    def rate_jacobian(self, v: Any, omega: Any, body: bool = False) -> np.ndarray:
        return applied_jacobian(self.gradient_inv(self.unpack(v), body)[1], self.unpack(omega))

    def cotangent(self, v: Any, z: Any, body: bool = False) -> np.ndarray:
        return pack(matvec(transpose(self.frame_operator(self.unpack(v), body)), self.unpack(z)))

    def cotangent_jacobian(self, v: Any, z: Any, body: bool = False) -> np.ndarray:
        slopes = self.gradient(self.unpack(v), body)[1]
        return applied_jacobian([transpose(slope) for slope in slopes], self.unpack(z))

    # ---- of groups and motions, by their twists ----------------------------------------------------------------------

    def shadow_jacobian(self, v: Any, branch: int = 1) -> np.ndarray:
        """Solve T(v_k) ∂v_k/∂v = T(v), since v and its shadow v_k have the same twist."""
        if branch % self.order == 0:
            return np.eye(6)
        back = inverse(self.operator_by_spin(self.unpack(self.shadow(v, branch))))
        return matrix6(pack(matmul(back, self.operator_by_spin(self.unpack(v)))))

    def transition(self, v: Any, v0: Any, body: bool = False) -> np.ndarray:
        """Solve T ∂v/∂v0 = T(v0) with the operators of the other frame: a given twist moves all poses alike."""
        back = inverse(self.frame_operator(self.unpack(v), not body))
        return matrix6(pack(matmul(back, self.frame_operator(self.unpack(v0), not body))))

    def compose_jacobians(self, v2: Any, v1: Any) -> tuple[np.ndarray, np.ndarray]:
        """Solve T(v) v̇ = T(v2) v̇2 + R(v2) T(v1) v̇1, the twist of a product, for both Jacobians."""
        later, sooner = self.unpack(v2), self.unpack(v1)
        back = inverse(self.operator_by_spin(self.unpack(self.compose(v2, v1))))
        turned = matmul(self.rotation(later), self.operator_by_spin(sooner))
        return matrix6(pack(matmul(back, self.operator_by_spin(later)))), matrix6(pack(matmul(back, turned)))

    def between_jacobians(self, v2: Any, v1: Any) -> tuple[np.ndarray, np.ndarray]:
        """Solve the twist equation of R(v1)ᵀ R(v2) for both Jacobians."""
        back = inverse(self.operator_by_spin(self.unpack(self.between(v2, v1))))
        back = matmul(back, transpose(self.rotation(self.unpack(v1))))
        one, other = (matrix6(pack(matmul(back, self.operator_by_spin(self.unpack(v))))) for v in (v2, v1))
        return one, -other

    @remembered
    def step_operator(self, delta: Any) -> tuple[Any, ...]:
        """Return dexp(δ), with columns 2 vec(ė e⁻¹) for δ moving along each axis; I + skew(δ)/2 for a translation."""
        if all(a.re == 0 for a in delta):
            (x, y, z), one = (a / 2 for a in delta), delta[0] * 0 + 1
            return ((one, -z, y), (z, one, -x), (-y, x, one))
        columns = []
        for place in range(3):
            unit = [Nil(a.re * 0 + (place == i), a.re * 0) for i, a in enumerate(delta)]
            e, e_dot = split(self.step(along(delta, unit)))
            columns.append([2 * c for c in hamilton(e_dot, conjugate(e))[1:]])
        return transpose(columns)

    def retract_jacobians(
        self, v: Any, delta: Any, body: bool = False, other: bool = False
    ) -> tuple[np.ndarray, np.ndarray]:
        """Solve T(w) ẇ = dexp(δ) δ̇ + exp(δ) T(v) v̇, or T(w) ẇ = T(v) v̇ + R(v) dexp(δ) δ̇ in the body frame."""
        here, small = self.unpack(v), self.unpack(delta)
        back = inverse(self.operator_by_spin(self.unpack(self.retract(v, delta, body, other))))
        by_v, by_delta, q = self.operator_by_spin(here), self.step_operator(small), self.step(small)
        if body:
            by_delta = matmul(self.rotation(here), by_delta)
        else:
            by_v = matmul(turned(q), by_v)
        return matrix6(pack(matmul(back, by_v))), matrix6(pack(matmul(back, by_delta)))

    def local_jacobians(self, v2: Any, v1: Any, body: bool = False) -> tuple[np.ndarray, np.ndarray]:
        """Solve dexp(δ) δ̇ = T(v2) v̇2 − exp(δ) T(v1) v̇1; in the body frame the right side is R(v1)ᵀ (ω2 − ω1)."""
        delta, first = self.unpack((self.body_local if body else self.local)(v2, v1)), self.unpack(v1)
        later, sooner = (self.operator_by_spin(self.unpack(v)) for v in (v2, v1))
        back = inverse(self.step_operator(delta))
        forth = matmul(back, transpose(self.rotation(first)) if body else turned(self.step(delta)))
        return matrix6(pack(matmul(forth if body else back, later))), -matrix6(pack(matmul(forth, sooner)))

    def transform_point_jacobians(self, v: Any, r: Any) -> tuple[np.ndarray, np.ndarray]:
        """Differentiate Q r + vect(R° Qᵀ) by each component of v, and by r."""
        here, point = self.unpack(v), [self.field.number(c) for c in r]
        zero, columns = here[0].re * 0, []
        for place in range(6):
            unit = [Nil(zero + (place == i), zero + (place == 3 + i)) for i in range(3)]
            now, change = (np.array(pack(tensor)) for tensor in split(self.rotation(along(here, unit))))
            shift = change[1] @ now[0].T + now[1] @ change[0].T
            columns.append(change[0] @ np.array(point, dtype=object) + np.array(vect(shift.tolist()), dtype=object))
        return np.stack(columns, axis=-1), self.pose(v)[:3, :3]

    def transform_line_jacobians(self, v: Any, line: Any) -> tuple[np.ndarray, np.ndarray]:
        here, given = self.unpack(v), self.unpack(line)
        units = [[Nil(a.re * 0 + c, a.re * 0) for a, c in zip(here, e, strict=True)] for e in E]
        slopes = [split(self.rotation(along(here, unit)))[1] for unit in units]
        return applied_jacobian(slopes, given), self.adjoint(v)

    body_tangent_dot = functools.partialmethod(tangent_dot, body=True)
    body_twist_dot = functools.partialmethod(twist_dot, body=True)
    body_rate_dot = functools.partialmethod(rate_dot, body=True)
    body_twist_jacobian = functools.partialmethod(twist_jacobian, body=True)
    body_rate_jacobian = functools.partialmethod(rate_jacobian, body=True)
    body_transition = functools.partialmethod(transition, body=True)
    body_cotangent = functools.partialmethod(cotangent, body=True)
    body_cotangent_jacobian = functools.partialmethod(cotangent_jacobian, body=True)
    body_retract_jacobians = functools.partialmethod(retract_jacobians, body=True)
    body_local_jacobians = functools.partialmethod(local_jacobians, body=True)


class SineOracle(Oracle):
    """Oracle of v = sin θ u, with θ = α/2n reduced to (−π/2, π/2]."""

    def base(self, v: Any) -> Any:
        return self.field.sqrt(1 - dot(v, v))

    def size(self, theta: Any) -> Any:
        sine = self.field.sin(theta)
        return -sine if self.field.cos(theta).re < 0 else sine
