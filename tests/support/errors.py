"""Error measures of the kernel tests: norms, scales and tolerances.

Errors are normwise, in eps of the result's type: ‖Δ‖ / ‖Re‖ for the real part, and ‖Δ‖ / (sum of the norms of its
terms) for the dual part. The dual part of F at v + ε v° is DF(v)[v°]. Its sum of norms is ‖DF(v)‖ ‖v°‖ with the exact
Jacobian, so no formula under test enters. For an ill-conditioned map, the scale is the exact Jacobian of the result
applied to relative perturbations of its inputs.

A scale is a pair (re, du) of norms, stored as a `Nil`. Then the scale of a product of dual quantities is the product of
their scales: |ab|° ≤ |a| |b|° + |a|° |b|.
"""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from tests.support.first_principles import pack
from tests.support.nilpotent import Nil, float_field, inverse, matmul, transpose
from tests.support.oracle import Oracle

Array = Any  # object arrays of mpmath numbers

# Gates in eps, inside the principal range. With a rounding of u = eps/2, x = v·v has the error 3u, and each Horner or
# pair step of p and q adds 2u. The norm p² + x q² is formed from the computed p and q, so their common error cancels.
# Further errors come from one ratio (4u to 6u), its products and sums (3u), and the derivative of x in the dual part.
QUATERNION = 4  # p/N, q v/N: a ratio, a root, a product; measured 2.8
ROTATION = 10  # I + 2pq/N² skew + 2q²/N² skew²: three roundings more, summed over nine entries; measured 6.5
POSITION = 6  # T v°: coefficients as in T, then three products summed; measured 3.1
TANGENT = 6  # like the tensor, without the rounding of its unit entries; measured 2.5
DERIVED = 4  # derivatives of T and T⁻¹: a few more terms than in T, with one dominant term; measured 1.9
RATE = 6  # T⁻¹ ω: three coefficients, three products, summed; measured 2.9
ROUND_TRIP = 8  # v → pose → v: the pose's 6 to 10 eps pass a Jacobian of norm below 1; measured 3.8 (n ≥ 2)
GENERAL = 20  # any other map, in all regimes: at most two of the above in a chain (10 + 10)
CONDITIONED = 8  # other functions, relative to their condition: the gate of the worst factor in a chain (6), plus 2
THREE = 30  # derivatives of inverse maps beyond the first pole: a chain of T⁻¹, the derivative of T, and T⁻¹


def shadow_gate(order: int) -> int:
    """Return the gate of q̂, Q, ρ on shadows, where p and q are alternating sums; measured ≤ 41 at n = 64."""
    return max(16, 2 * order)


def tangent_shadow_gate(order: int) -> int:
    """Return the gate of T on shadows, relative to its norm; coefficients contain p′, q′; measured 126 at n = 64."""
    return max(40, 10 * order)


def derived_shadow_gate(order: int) -> int:
    """Return the gate of derivatives of T on shadows; p″/p′, q″/q′ grow like p′/p, q′/q; measured 144 at n = 11."""
    return 5 * tangent_shadow_gate(order)


PRODUCTS = 4  # number in a second slope of f, g or h: numerator, e times slopes (twice), e² times f, g or h


def underflow(v: Any, dtype: Any) -> Nil:
    """Return the error of derivatives of T from subnormal slopes of f, g, h.

    Each product in a slope loses half the smallest number of the type; sums are exact. In T, slopes are multiplied by
    up to |v|³, and second slopes, in the dual part, also by v·v°. For n = 2, slopes decay like |v|⁻⁶ and second slopes
    like |v|⁻⁸. In float32 they are subnormal from |v| = 4e6 and 1e5 on, at angles 1e-6 and 4e-5 from 2π.
    """
    lost, length = PRODUCTS / 2 * float(np.finfo(dtype).smallest_subnormal), size(v)
    return lost * (length + length * length + length * length * length) * Nil(1.0, length.re * length.du)


# Gate of the difference of two computed quantities: the sum of both gates, rounded up.
AGREE = 40


def norm(a: Any) -> float:
    """Return the Frobenius norm of an array, also of mpmath numbers, without overflow or underflow of squares."""
    entries = [abs(e) for e in np.asarray(a, dtype=object).flat]
    largest = max(entries, default=0)
    if not largest or not math.isfinite(largest):
        return float(largest)
    return float(largest) * math.sqrt(sum(float(e / largest) ** 2 for e in entries))


def parts(array: Any) -> tuple[Any, Any]:
    """Split a packed dual vector, quaternion, tensor or Jacobian into real and dual part; split a pose into Q and ρ."""
    array = np.asarray(array)
    if array.shape == (6, 6):
        return array[:3, :3], array[3:, :3]
    if array.shape == (4, 4):
        return array[:3, :3], array[:3, 3]
    if array.ndim == 3:
        return array[0], array[1]
    half = len(array) // 2
    return array[:half], array[half:]


def ratio(difference: float, scale: float) -> float:
    """Return difference / scale; 0 if the difference is 0, otherwise infinity for NaN and for scale 0."""
    if difference == 0:
        return 0.0
    return difference / scale if scale > 0 and not math.isnan(difference) else math.inf


def errors(got: Any, exact: Any, scale: Nil, oracle: Oracle) -> tuple[float, float]:
    """Return the (real, dual) error of one result in eps of its type."""
    re, du = zip(parts(got), parts(exact), (scale.re, scale.du), strict=True)
    return error(*re, oracle), error(*du, oracle)


def error(got: Any, exact: Any, scale: float, oracle: Oracle) -> float:
    """Return the error of one part in eps of its type."""
    found = np.array([oracle.field.number(c) for c in got.flat], dtype=object)
    return ratio(norm(found - exact.ravel()), scale) / float(np.finfo(got.dtype).eps)


def assert_close(got: Any, expected: Any, scale: Nil, tolerance: float = AGREE * float(np.finfo(float).eps)) -> None:
    """Require agreement of real and dual part to a tolerance times their scale."""
    for a, b, s in zip(parts(got), parts(expected), (scale.re, scale.du), strict=True):
        assert norm(a - b) <= tolerance * s, (got, expected)


def size(a: Any) -> Nil:
    """Return the scale of an input: the norms of its parts."""
    re, du = parts(a)
    return Nil(norm(re), norm(du))


def majorant(dual_tensor: Any) -> Nil:
    return size(pack(dual_tensor))


@dataclass(frozen=True)
class Scales:
    """Scales of the forward maps at one pose."""

    vector: Nil
    quaternion: Nil
    tensor: Nil
    position: float
    tangent: Nil
    tangent_inv: Nil
    slope: float  # norm of the derivative of the tangent operator: ‖DT‖
    condition: float  # relative condition number of inverting the tangent operator: ‖T⁻¹‖ ‖DT‖ ‖v‖
    near_pole: Nil  # tangent_inv times its condition: once for T⁻¹, twice for its derivative −T⁻¹ DT T⁻¹


@functools.lru_cache(maxsize=4096)
def _scales(order: int, vector: tuple[float, ...]) -> Scales:
    oracle = Oracle(order, 15, float_field())
    re, size_du = vector[:3], norm(vector[3:])
    turned = [[Nil(a, 1.0 * (i == j)) for i, a in enumerate(re)] for j in range(3)]

    def gradient(f: Any) -> list[Any]:
        return [parts(pack(f(v)))[1] for v in turned]

    operator = parts(pack(oracle.operator([Nil(a, 0.0) for a in re])))[0].astype(float)
    inverted = np.array(inverse(operator.tolist()))
    change = np.array(gradient(oracle.operator), dtype=float)
    change_inv = -inverted @ change @ inverted
    kappa = norm(inverted) * norm(change) * norm(re)
    return Scales(
        vector=Nil(norm(re), size_du),
        quaternion=Nil(1.0, norm(gradient(oracle.unit)) * size_du),
        tensor=Nil(math.sqrt(3), norm(gradient(oracle.rotation)) * size_du),
        position=norm(operator) * size_du,
        tangent=Nil(norm(operator), norm(change) * size_du),
        tangent_inv=Nil(norm(inverted), norm(change_inv) * size_du),
        slope=norm(change),
        condition=kappa,
        near_pole=Nil(norm(inverted) * (1 + kappa), norm(change_inv) * size_du * (1 + 2 * kappa)),
    )


@dataclass(frozen=True)
class Slopes:
    """Scales of derivatives of T and T⁻¹ by v; ``near_pole`` is the scale for T⁻¹ with its condition included."""

    tangent: Nil
    tangent_inv: Nil
    near_pole: Nil


@functools.lru_cache(maxsize=4096)
def _slopes(order: int, vector: tuple[float, ...]) -> Slopes:
    oracle, re, size_du = Oracle(order, 15, float_field()), vector[:3], norm(vector[3:])
    pairs = [(i, j) for i in range(3) for j in range(3)]
    moved = ([Nil(Nil(a, 1.0 * (k == i)), Nil(1.0 * (k == j), 0.0)) for k, a in enumerate(re)] for i, j in pairs)
    found = [np.array(oracle.operator_by_spin(v), dtype=object) for v in moved]
    slopes = [part(found[3 * i], lambda e: e.re.du) for i in range(3)]
    bends = [part(tensor, lambda e: e.du.du) for tensor in found]
    back = np.array(inverse(part(found[0], lambda e: e.re.re).tolist()))
    slopes_inv = [-back @ slope @ back for slope in slopes]
    bends_inv = [
        -(slopes_inv[i] @ slopes[j] + back @ bend) @ back - back @ slopes[j] @ slopes_inv[i]
        for (i, j), bend in zip(pairs, bends, strict=True)
    ]
    inverted, kappa = Nil(norm(slopes_inv), norm(bends_inv) * size_du), _scales(order, vector).condition
    return Slopes(
        tangent=Nil(norm(slopes), norm(bends) * size_du),
        tangent_inv=inverted,
        near_pole=Nil(inverted.re * (1 + 2 * kappa), inverted.du * (1 + 3 * kappa)),
    )


def part(tensor: Array, of: Any) -> np.ndarray:
    """Return an array of floats: the part ``of(entry)`` of every entry of a tensor."""
    return np.array([of(entry) for entry in tensor.flat], float).reshape(tensor.shape)


def slopes(order: int, v: Any) -> Slopes:
    return _slopes(order, tuple(float(c) for c in v))


def scales(order: int, v: Any) -> Scales:
    return _scales(order, tuple(float(c) for c in v))


def through(jacobian: Any, argument: Nil) -> Nil:
    """Return the scale of a result with this exact Jacobian, for relative perturbations of the argument."""
    return majorant(jacobian) * argument


def branch_scale(operator: Any, result: Any, directions: Any, entries: Any) -> Nil:
    """Return the scale of an inverse map: the sum of v̇ = T(v)⁻¹ ω over relative changes of the input entries.

    `operator` is T at the `result` v; ω is the twist caused by a relative change of an entry.

    `directions` (2, 3, m) contains the dual twists per unit of the m entries, `entries` (2, m) their real and dual
    values. Entries count one by one, not in norm: small entries determine a small rotation to full relative precision.
    """
    re, du = np.array(pack(inverse(operator)), dtype=float)
    turn, shift = re @ directions[0], du @ directions[0] + re @ directions[1]
    turn, shift = np.linalg.norm(turn, axis=0), np.linalg.norm(shift, axis=0)
    own = size(pack(result))
    return own + Nil(float(turn @ abs(entries[0])), float(turn @ abs(entries[1]) + shift @ abs(entries[0])))


def angle_scale(order: int, alpha: Nil, axis: Any) -> Nil:
    """Return the effect |dv/dα| |α| of a relative error of α (with all turns) on tan(α/2n) u, with its dual part."""
    tangent = math.tan(float(alpha.re) / (2 * order))
    slope = (1 + tangent * tangent) / (2 * order)
    bend = slope * abs(tangent) / order
    tilt = Nil(slope, bend * abs(float(alpha.du))) * Nil(abs(float(alpha.re)), abs(float(alpha.du)))
    return tilt * size(pack(axis))


def entry_twists(rotation: Any) -> np.ndarray:
    """Return the dual twists vect(E Rᵀ) for unit changes E of each entry of R, in shape (2, 3, 9)."""
    back = transpose(rotation)
    columns = []
    for i in range(3):
        for j in range(3):
            unit = tuple(tuple(int((i, j) == (k, m)) for m in range(3)) for k in range(3))
            m = matmul(unit, back)
            columns.append([(m[2][1] - m[1][2]) / 2, (m[0][2] - m[2][0]) / 2, (m[1][0] - m[0][1]) / 2])
    return np.array(pack(columns), dtype=float).transpose(0, 2, 1)
