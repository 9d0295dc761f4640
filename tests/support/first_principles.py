"""Cayley maps of any order from first principles, in mpmath at any precision.

Nothing is shared with the code under test: there are no p_n, q_n and no closed forms of coefficients. The dual
quaternion is the normalized n-th power of 1 + v, and the tensor rotates the basis vectors by it. The tangent operator
is vect(Ṙ Rᵀ), with R differentiated exactly in nilpotent arithmetic. Inverse maps compute half the dual angle by atan2
and return the tangent of its n-th part. A vector without real part (pure translation, identity) is a separate case:
its axis and angle come from the dual part.

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
    matmul,
    mp_field,
    power,
    split,
    transpose,
    vect,
)

E = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
DIGITS = 50


def pack(value: Any) -> np.ndarray:
    """Stack real parts, then dual parts, along a new first axis; vectors and quaternions become flat."""
    entries = np.array(value, dtype=object)
    parts = [np.array([getattr(e, part) for e in entries.flat], dtype=object) for part in ("re", "du")]
    if entries.ndim == 1:
        return np.concatenate(parts)
    return np.stack([p.reshape(entries.shape) for p in parts])


def rounded(exact: Any, dtype: Any) -> np.ndarray:
    """Round mpmath numbers to the nearest floats of a type."""
    flat = [np.longdouble(float(c)) + np.longdouble(float(c - float(c))) for c in exact.flat]
    return np.array(flat, dtype=np.longdouble).reshape(exact.shape).astype(dtype)


def along(v: Any, rate: Any) -> tuple[Nil, ...]:
    """Return a vector with rates as the nilpotent parts of its components."""
    return tuple(Nil(Nil(a.re, d.re), Nil(a.du, d.du)) for a, d in zip(v, rate, strict=True))


def value_key(value: Any) -> Any:
    """Return a hashable key of a number, a dual number, or an array or tuple of them."""
    if isinstance(value, Nil):
        return value_key(value.re), value_key(value.du)
    if isinstance(value, np.ndarray):
        return value.shape, tuple(value.flat)
    return tuple(map(value_key, value)) if isinstance(value, tuple | list) else value


def remembered(method: Any) -> Any:
    """Decorate a method so that it remembers results; many functions are tested at the same vectors."""

    @functools.wraps(method)
    def kept(self: FirstPrinciples, *arguments: Any) -> Any:
        key = (method.__name__, *map(value_key, arguments))
        if key not in self.results:
            self.results[key] = method(self, *arguments)
        return self.results[key]

    return kept


class FirstPrinciples:
    """Cayley maps of order n over a field of numbers (50-digit mpmath unless another is given)."""

    def __init__(self, order: int, dps: int = DIGITS, field: Field | None = None) -> None:
        self.order = order
        self.field = mp_field(dps) if field is None else field
        # Angles this close to a multiple of π count as equal; input rounding is far larger.
        self.tie = 10.0 ** (-dps / 2)
        self.results: dict[Any, Any] = {}

    def unpack(self, array: Any) -> tuple[Nil, ...]:
        """Convert a flat (2m,) array to m dual numbers."""
        numbers = [self.field.number(a) for a in array]
        half = len(numbers) // 2
        return tuple(Nil(a, b) for a, b in zip(numbers[:half], numbers[half:], strict=True))

    def unpack_tensor(self, array: Any) -> tuple[Any, ...]:
        number = self.field.number
        return tuple(tuple(Nil(number(array[0][i][j]), number(array[1][i][j])) for j in range(3)) for i in range(3))

    # ---- the chart: v = tan θ u, θ = α/2n --------------------------------------------------------------------

    def base(self, v: Any) -> Any:
        """Return |v| cot θ."""
        return v[0] * 0 + 1

    def size(self, theta: Any) -> Any:
        """Return |v| as a function of θ."""
        return self.field.tan(theta)

    # ---- forward maps, on tuples of dual numbers -------------------------------------------------------------

    def spin(self, v: Any) -> tuple[Any, ...]:
        """Return (|v| cot θ + v)^n without normalization."""
        return power((self.base(v), v[0], v[1], v[2]), self.order)

    @remembered
    def unit(self, v: Any) -> tuple[Any, ...]:
        w = self.spin(v)
        norm = self.field.sqrt(hamilton(w, conjugate(w))[0])
        return tuple(c / norm for c in w)

    @remembered
    def rotation(self, v: Any) -> tuple[Any, ...]:
        """Return the tensor with columns w e w⁻¹ for the basis vectors e."""
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
        """Return the tangent operator; its column j is the twist for v̇ = e_j."""

        def column(e: Any) -> tuple[Any, ...]:
            return self.space_twist(v, [Nil(v[0].re * 0 + c, v[0].re * 0) for c in e])

        return transpose([column(e) for e in E])

    @remembered
    def operator_by_spin(self, v: Any) -> tuple[Any, ...]:
        """Return the tangent operator by ω = 2 vec(ẇ w⁻¹), at a third of the cost; tests compare it with `operator`."""

        def column(e: Any) -> tuple[Any, ...]:
            moving = tuple(Nil(Nil(a.re, a.re * 0 + c), Nil(a.du, a.du * 0)) for a, c in zip(v, e, strict=True))
            w, w_dot = split(self.spin(moving))
            norm2 = hamilton(w, conjugate(w))[0]
            return tuple(2 * c / norm2 for c in hamilton(w_dot, conjugate(w))[1:])

        return transpose([column(e) for e in E])

    # ---- inverse maps ---------------------------------------------------------------------------------------

    def half_screw(self, q: Any) -> tuple[Any, Any]:
        """Return (half the dual angle, unit dual axis) of a dual quaternion with its sign; the axis is None at ±1."""
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
        """Return v on branch k, at θ = (α + 2kπ)/2n."""
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
        """Return the dual quaternion of a dual tensor: q is the longest of four proportional rows, q° = ρ q / 2."""
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
        """Return the principal dual angle α, 0 ≤ Re α ≤ π, of v's pose, and its axis u (None at the identity)."""
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
            # At whole turns the pose is a translation, and its direction is the axis.
            alpha = Nil(pi * 0, alpha.du)
        if alpha.re < 0 or (alpha.re == 0 and alpha.du < 0):
            return -alpha, tuple(-c for c in axis)
        return alpha, axis
