"""The Cayley maps of any order from first principles, in mpmath with as many digits as asked for.

Independent of the code under test: no p_n, q_n, no closed form of any coefficient. The dual quaternion is the n-th
power of 1 + v over its own norm, the tensor is the sandwich of the basis vectors, the tangent operator is
vect(Ṙ Rᵀ) with R differentiated exactly in nilpotent arithmetic, the inverse maps take half the dual angle by atan2
and give tan of its n-th part. Where the real part of the vector vanishes (pure translation, identity) axis and angle
come from the dual part, by a case of their own.

Arguments are flat arrays as the kernels take them for one pose; results are object arrays of the kernels' shapes.
"""

from __future__ import annotations

import functools
from typing import Any

import numpy as np

from tests.support.nilpotent import (
    Field,
    Nil,
    conjugate,
    dot,
    hamilton,
    inverse,
    matmul,
    matvec,
    mp_field,
    power,
    split,
    transpose,
    vect,
)

E = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
DIGITS = 50


def pack(value: Any) -> np.ndarray:
    """Real parts first, then dual parts, along a new leading axis (vectors and quaternions flat)."""
    entries = np.array(value, dtype=object)
    parts = [np.array([getattr(e, part) for e in entries.flat], dtype=object) for part in ("re", "du")]
    if entries.ndim == 1:
        return np.concatenate(parts)
    return np.stack([p.reshape(entries.shape) for p in parts])


def along(v: Any, rate: Any) -> tuple[Nil, ...]:
    """The vector with its rate beside it."""
    return tuple(Nil(Nil(a.re, d.re), Nil(a.du, d.du)) for a, d in zip(v, rate, strict=True))


def matrix6(tensor: np.ndarray) -> np.ndarray:
    """The real matrix that acts on dual vectors as a dual tensor does."""
    zero = tensor[0] * 0
    return np.block([[tensor[0], zero], [tensor[1], tensor[0]]])


def scaled(tensor: Any, factor: Any) -> Any:
    return tuple(tuple(c * factor for c in row) for row in tensor)


def added(a: Any, b: Any) -> Any:
    """The sum of vectors, or of tensors."""
    return tuple(added(p, q) if isinstance(p, tuple) else p + q for p, q in zip(a, b, strict=True))


def directional(slopes: Any, direction: Any) -> Any:
    """The derivative of a tensor along a direction, by those along the axes."""
    return functools.reduce(added, (scaled(slope, c) for slope, c in zip(slopes, direction, strict=True)))


def applied_jacobian(slopes: Any, w: Any) -> np.ndarray:
    """The derivative of a tensor applied to w as a real matrix."""
    return matrix6(pack(transpose([matvec(slope, w) for slope in slopes])))


def value_key(value: Any) -> Any:
    """What tells a number, a dual number or an array or tuple of them from others."""
    if isinstance(value, Nil):
        return value_key(value.re), value_key(value.du)
    if isinstance(value, np.ndarray):
        return value.shape, tuple(value.flat)
    return tuple(map(value_key, value)) if isinstance(value, tuple | list) else value


def remembered(method: Any) -> Any:
    """Keep an oracle's results, for many functions are tested at the same vectors."""

    @functools.wraps(method)
    def kept(self: Oracle, *arguments: Any) -> Any:
        key = (method.__name__, *map(value_key, arguments))
        if key not in self.results:
            self.results[key] = method(self, *arguments)
        return self.results[key]

    return kept


@functools.cache
def oracle_of(order: int, digits: int = DIGITS) -> Oracle:
    """The oracle of an order, one for all tests: it remembers results."""
    return Oracle(order, digits)


class Oracle:
    """Order n over a field of numbers (50-digit mpmath unless another is given)."""

    def __init__(self, order: int, dps: int = DIGITS, field: Field | None = None) -> None:
        self.order = order
        self.field = mp_field(dps) if field is None else field
        # An angle closer than this to a multiple of π counts as equal: far below any input's rounding.
        self.tie = 10.0 ** (-dps / 2)
        self.results: dict[Any, Any] = {}

    def unpack(self, array: Any) -> tuple[Nil, ...]:
        """Flat (2m,) array to m dual numbers."""
        numbers = [self.field.number(a) for a in array]
        half = len(numbers) // 2
        return tuple(Nil(a, b) for a, b in zip(numbers[:half], numbers[half:], strict=True))

    def unpack_tensor(self, array: Any) -> tuple[Any, ...]:
        number = self.field.number
        return tuple(tuple(Nil(number(array[0][i][j]), number(array[1][i][j])) for j in range(3)) for i in range(3))

    # ---- the chart: v = tan θ u, θ = α/2n --------------------------------------------------------------------

    def base(self, v: Any) -> Any:
        """|v| cot θ."""
        return v[0] * 0 + 1

    def size(self, theta: Any) -> Any:
        """|v| of θ."""
        return self.field.tan(theta)

    # ---- forward maps, on tuples of dual numbers -------------------------------------------------------------

    def spin(self, v: Any) -> tuple[Any, ...]:
        """(|v| cot θ + v)^n, not normalised."""
        return power((self.base(v), v[0], v[1], v[2]), self.order)

    @remembered
    def unit(self, v: Any) -> tuple[Any, ...]:
        w = self.spin(v)
        norm = self.field.sqrt(hamilton(w, conjugate(w))[0])
        return tuple(c / norm for c in w)

    @remembered
    def rotation(self, v: Any) -> tuple[Any, ...]:
        """Columns w e w⁻¹ for the basis vectors e."""
        w = self.spin(v)
        norm2 = hamilton(w, conjugate(w))[0]
        back = tuple(c / norm2 for c in conjugate(w))
        return transpose([hamilton(hamilton(w, (0, *e)), back)[1:] for e in E])

    def rotation_and_derivative(self, v: Any, v_dot: Any) -> tuple[Any, Any]:
        return split(self.rotation(along(v, v_dot)))

    def space_twist(self, v: Any, v_dot: Any) -> tuple[Any, ...]:
        r, r_dot = self.rotation_and_derivative(v, v_dot)
        return vect(matmul(r_dot, transpose(r)))

    @remembered
    def operator(self, v: Any) -> tuple[Any, ...]:
        """The tangent operator: column j is the twist of v moving along e_j."""

        def column(e: Any) -> tuple[Any, ...]:
            return self.space_twist(v, [Nil(v[0].re * 0 + c, v[0].re * 0) for c in e])

        return transpose([column(e) for e in E])

    @remembered
    def operator_by_spin(self, v: Any) -> tuple[Any, ...]:
        """The same through ω = 2 vec(ẇ w⁻¹): a third of the cost, checked against `operator`."""

        def column(e: Any) -> tuple[Any, ...]:
            moving = tuple(Nil(Nil(a.re, a.re * 0 + c), Nil(a.du, a.du * 0)) for a, c in zip(v, e, strict=True))
            w, w_dot = split(self.spin(moving))
            norm2 = hamilton(w, conjugate(w))[0]
            return tuple(2 * c / norm2 for c in hamilton(w_dot, conjugate(w))[1:])

        return transpose([column(e) for e in E])

    # ---- inverse maps ---------------------------------------------------------------------------------------

    def half_screw(self, q: Any) -> tuple[Any, Any]:
        """(half the dual angle, unit dual axis) of a dual quaternion as given; axis None at ±1."""
        scalar, vector = q[0], q[1:]
        if any(c.re != 0 for c in vector):
            norm = self.field.sqrt(dot(vector, vector))
            return self.field.atan2(norm, scalar), tuple(c / norm for c in vector)
        zero = scalar.re * 0
        moment = tuple(c.du for c in vector)
        if all(c == 0 for c in moment):
            return Nil(zero, zero), None
        size = self.field.sqrt(dot(moment, moment))
        return Nil(zero, size / scalar.re), tuple(Nil(c / size, zero) for c in moment)

    def on_branch(self, half: Any, axis: Any, branch: int) -> tuple[Any, ...]:
        """v of (α + 2kπ)/2n."""
        zero = half.re * 0
        if axis is None:
            value = zero if branch % self.order == 0 else self.field.number(float("nan"))
            return (Nil(value, value),) * 3
        size = self.size((half + branch * self.field.pi) / self.order)
        return tuple(size * c for c in axis)

    def vector_of(self, q: Any, branch: int = 0) -> tuple[Any, ...]:
        if q[0].re < 0:
            q = tuple(-c for c in q)
        return self.on_branch(*self.half_screw(q), branch)

    def quaternion_of(self, r: Any) -> tuple[Any, ...]:
        """Dual quaternion of an orthogonal dual tensor: of four proportional rows the longest; then q° = ρ q / 2."""
        m = [[c.re for c in row] for row in r]
        trace = m[0][0] + m[1][1] + m[2][2]
        skew = [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]]
        rows = [[1 + trace, *skew]]
        for i in range(3):
            symmetric = [m[i][j] + m[j][i] for j in range(3)]
            symmetric[i] = 1 - trace + 2 * m[i][i]
            rows.append([skew[i], *symmetric])
        row = max(rows, key=lambda entries: sum(c * c for c in entries))
        size = self.field.sqrt(sum(c * c for c in row))
        leading = next(c for c in row if c != 0)
        sign = -1 if leading < 0 else 1
        real = tuple(sign * c / size for c in row)
        rho = vect(matmul([[c.du for c in row] for row in r], transpose(m)))
        dual = hamilton((0, *rho), real)
        return tuple(Nil(a, b / 2) for a, b in zip(real, dual, strict=True))

    @remembered
    def reduced(self, v: Any) -> tuple[Any, Any]:
        """(α, u) of v's pose with 0 ≤ Re α ≤ π: the principal dual angle and its axis (None at the identity)."""
        half, axis = self.half_screw((self.base(v), *v))
        alpha = 2 * self.order * half
        if axis is None or all(c.re == 0 for c in v):
            return alpha, axis
        pi = self.field.pi
        turns = int((alpha.re + pi) / (2 * pi))
        alpha = alpha - 2 * turns * pi
        if abs(abs(alpha.re) - pi) < self.tie:
            return Nil(pi, alpha.du), axis
        if turns and abs(alpha.re) < self.tie:
            # A whole number of turns: a translation, and its side is the axis.
            alpha = Nil(pi * 0, alpha.du)
        if alpha.re < 0 or (alpha.re == 0 and alpha.du < 0):
            return -alpha, tuple(-c for c in axis)
        return alpha, axis

    # ---- the kernels' interface, one pose at a time -----------------------------------------------------------

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
        """Column j is the body twist of v moving along e_j."""
        dual = self.unpack(v)

        def column(e: Any) -> tuple[Any, ...]:
            r, r_dot = self.rotation_and_derivative(dual, [Nil(dual[0].re * 0 + c, dual[0].re * 0) for c in e])
            return vect(matmul(transpose(r), r_dot))

        return pack(transpose([column(e) for e in E]))

    def body_tangent_inv(self, v: Any) -> np.ndarray:
        dual = self.unpack(v)
        return pack(matmul(inverse(self.operator(dual)), self.rotation(dual)))

    def inverse(self, v: Any) -> np.ndarray:
        """From the conjugate of the n-th root that v stands for."""
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

    # ---- derivatives: T at a vector that moves along each axis -------------------------------------------------

    def frame_operator(self, v: Any, body: bool) -> Any:
        """T, or what gives the twist in the body: Rᵀ T."""
        operator = self.operator_by_spin(v)
        return matmul(transpose(self.rotation(v)), operator) if body else operator

    @remembered
    def gradient(self, v: Any, body: bool) -> tuple[Any, tuple[Any, ...]]:
        """The operator of a frame, and its derivatives along the three axes."""
        units = [[Nil(a.re * 0 + c, a.re * 0) for a, c in zip(v, e, strict=True)] for e in E]
        values, slopes = zip(*(split(self.frame_operator(along(v, unit), body)) for unit in units), strict=True)
        return values[0], slopes

    @remembered
    def gradient_inv(self, v: Any, body: bool) -> tuple[Any, tuple[Any, ...]]:
        """The same of the inverse."""
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

    body_tangent_dot = functools.partialmethod(tangent_dot, body=True)
    body_twist_dot = functools.partialmethod(twist_dot, body=True)
    body_rate_dot = functools.partialmethod(rate_dot, body=True)
    body_twist_jacobian = functools.partialmethod(twist_jacobian, body=True)
    body_rate_jacobian = functools.partialmethod(rate_jacobian, body=True)
    body_cotangent = functools.partialmethod(cotangent, body=True)
    body_cotangent_jacobian = functools.partialmethod(cotangent_jacobian, body=True)

    # ---- inverse maps, screws, shadows, composition -----------------------------------------------------------

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
        """Of v's own branch."""
        dual = self.unpack(v)
        theta, _ = self.half_screw((self.base(dual), *dual))
        return pack((2 * self.order * theta,))

    def to_exponential(self, v: Any) -> np.ndarray:
        """α u of v's own branch."""
        dual = self.unpack(v)
        theta, axis = self.half_screw((self.base(dual), *dual))
        return pack([2 * self.order * theta * c for c in axis or dual])

    def from_exponential(self, w: Any) -> np.ndarray:
        """Of the branches of the pose that whose α u is w, which is before the edge."""
        half, axis = self.half_screw(self.step(self.unpack(w)))
        along = sum(float(a.re) * float(b) for a, b in zip(axis or (), w, strict=False))
        return pack(self.on_branch(half, axis, round((along / 2 - float(half.re)) / np.pi)))

    @remembered
    def shadow(self, v: Any, branch: int = 1) -> np.ndarray:
        dual = self.unpack(v)
        alpha, axis = self.reduced(dual)
        if axis is None:
            return pack(self.on_branch(alpha, None, branch))
        # Branches count from where v itself stands: from the multiple of 2π nearest to its angle along the axis.
        coefficient = dot(dual, axis)
        own = self.field.atan2(coefficient, self.base(dual)) + branch * self.field.pi / self.order
        size = self.size(own)
        return pack(tuple(size * c for c in axis))

    def shadow_jacobian(self, v: Any, branch: int = 1) -> np.ndarray:
        """By the twist, which is that of the shadow too: T(v_k) ∂v_k/∂v = T(v)."""
        if branch % self.order == 0:
            return np.eye(6)
        back = inverse(self.operator_by_spin(self.unpack(self.shadow(v, branch))))
        return matrix6(pack(matmul(back, self.operator_by_spin(self.unpack(v)))))

    def principal(self, v: Any) -> np.ndarray:
        alpha, axis = self.reduced(self.unpack(v))
        return pack(self.on_branch(alpha / 2, axis, 0))

    @remembered
    def compose(self, v2: Any, v1: Any) -> np.ndarray:
        return pack(self.vector_of(hamilton(self.unit(self.unpack(v2)), self.unit(self.unpack(v1)))))

    @remembered
    def between(self, v2: Any, v1: Any) -> np.ndarray:
        return pack(self.vector_of(hamilton(conjugate(self.unit(self.unpack(v1))), self.unit(self.unpack(v2)))))

    def compose_jacobians(self, v2: Any, v1: Any) -> tuple[np.ndarray, np.ndarray]:
        """By the twist of a product: T(v) v̇ = T(v2) v̇2 + R(v2) T(v1) v̇1."""
        later, sooner = self.unpack(v2), self.unpack(v1)
        back = inverse(self.operator_by_spin(self.unpack(self.compose(v2, v1))))
        turned = matmul(self.rotation(later), self.operator_by_spin(sooner))
        return matrix6(pack(matmul(back, self.operator_by_spin(later)))), matrix6(pack(matmul(back, turned)))

    def between_jacobians(self, v2: Any, v1: Any) -> tuple[np.ndarray, np.ndarray]:
        """The same of R(v1)ᵀ R(v2)."""
        back = inverse(self.operator_by_spin(self.unpack(self.between(v2, v1))))
        back = matmul(back, transpose(self.rotation(self.unpack(v1))))
        one, other = (matrix6(pack(matmul(back, self.operator_by_spin(self.unpack(v))))) for v in (v2, v1))
        return one, -other

    @remembered
    def step(self, delta: Any) -> tuple[Any, ...]:
        """exp(δ/2)."""
        half = tuple(c / 2 for c in delta)
        if all(c.re == 0 for c in half):
            return (Nil(half[0].re + 1, half[0].re), *half)
        length = self.field.sqrt(dot(half, half))
        return (self.field.cos(length), *(self.field.sin(length) * c / length for c in half))

    def retract(self, v: Any, delta: Any, body: bool = False) -> np.ndarray:
        """On the branch whose angle is nearest that of v along the new axis."""
        here, small = self.unpack(v), self.step(self.unpack(delta))
        q = hamilton(self.unit(here), small) if body else hamilton(small, self.unit(here))
        half, axis = self.half_screw(q)
        theta, own = self.half_screw((self.base(here), *here))
        if axis is None:
            return pack(self.on_branch(half, None, 0))
        along = 0 if own is None else self.order * theta.re * dot(own, axis).re
        turns = int(self.field.number(round(float((along - half.re) / self.field.pi))))
        return pack(self.on_branch(half, axis, turns))

    @remembered
    def step_operator(self, delta: Any) -> tuple[Any, ...]:
        """dexp(δ): the twist of exp(δ) as δ moves along the axes, ω = 2 vec(ė e⁻¹); I + skew(δ)/2 of a translation."""
        if all(a.re == 0 for a in delta):
            (x, y, z), one = (a / 2 for a in delta), delta[0] * 0 + 1
            return ((one, -z, y), (z, one, -x), (-y, x, one))
        columns = []
        for place in range(3):
            unit = [Nil(a.re * 0 + (place == i), a.re * 0) for i, a in enumerate(delta)]
            e, e_dot = split(self.step(along(delta, unit)))
            columns.append([2 * c for c in hamilton(e_dot, conjugate(e))[1:]])
        return transpose(columns)

    def retract_jacobians(self, v: Any, delta: Any, body: bool = False) -> tuple[np.ndarray, np.ndarray]:
        """By the twist of a product: T(w) ẇ = dexp(δ) δ̇ + exp(δ) T(v) v̇, or T(v) v̇ + R(v) dexp(δ) δ̇."""
        here, small = self.unpack(v), self.unpack(delta)
        back = inverse(self.operator_by_spin(self.unpack(self.retract(v, delta, body))))
        by_v, by_delta, q = self.operator_by_spin(here), self.step_operator(small), self.step(small)
        if body:
            by_delta = matmul(self.rotation(here), by_delta)
        else:
            turned = transpose([hamilton(hamilton(q, (0, *e)), conjugate(q))[1:] for e in E])
            by_v = matmul(turned, by_v)
        return matrix6(pack(matmul(back, by_v))), matrix6(pack(matmul(back, by_delta)))

    def local(self, v2: Any, v1: Any, body: bool = False) -> np.ndarray:
        later, sooner = self.unit(self.unpack(v2)), conjugate(self.unit(self.unpack(v1)))
        q = hamilton(sooner, later) if body else hamilton(later, sooner)
        half, axis = self.half_screw(tuple(-c for c in q) if q[0].re < 0 else q)
        zero = half.re * 0
        return pack(tuple(2 * half * c for c in axis or (Nil(zero, zero),) * 3))

    body_retract = functools.partialmethod(retract, body=True)
    body_retract_jacobians = functools.partialmethod(retract_jacobians, body=True)
    body_local = functools.partialmethod(local, body=True)

    def interpolate(self, v1: Any, v2: Any, t: Any, steps: int = 24) -> np.ndarray:
        """Step by step: of all α u of a pose on the way, the one nearest the last."""
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

    def transform_point_jacobians(self, v: Any, r: Any) -> tuple[np.ndarray, np.ndarray]:
        """Rates of Q r + vect(R° Qᵀ) as each component of v goes."""
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

    def transform_point(self, v: Any, r: Any) -> np.ndarray:
        pose = self.pose(v)
        return pose[:3, :3] @ np.array([self.field.number(c) for c in r], dtype=object) + pose[:3, 3]

    def transform_line(self, v: Any, line: Any) -> np.ndarray:
        return pack(matvec(self.rotation(self.unpack(v)), self.unpack(line)))


class SineOracle(Oracle):
    """v = sin θ u, θ = α/2n brought into (−π/2, π/2]."""

    def base(self, v: Any) -> Any:
        return self.field.sqrt(1 - dot(v, v))

    def size(self, theta: Any) -> Any:
        sine = self.field.sin(theta)
        return -sine if self.field.cos(theta).re < 0 else sine
