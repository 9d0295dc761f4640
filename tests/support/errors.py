"""Error measures: norms, and scales of figures that compare libraries.

Errors are normwise, in eps of the result's type: ‖Δ‖ / ‖Re‖ for the real part, and ‖Δ‖ / (sum of the norms of its
terms) for the dual part. The dual part of F at v + ε v° is DF(v)[v°]. Its sum of norms is ‖DF(v)‖ ‖v°‖ with the exact
Jacobian, so no formula under test enters. For an ill-conditioned map, the scale is the exact Jacobian of the result
applied to relative perturbations of its inputs. Tests of kernels use the scales of `families`.

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

GENERAL = 20  # largest error in eps of a sum of two chains of operations, relative to norms


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


def size(a: Any) -> Nil:
    """Return the scale of an input: the norms of its parts."""
    re, du = parts(a)
    return Nil(norm(re), norm(du))


def majorant(dual_tensor: Any) -> Nil:
    return size(pack(dual_tensor))


@dataclass(frozen=True)
class Scales:
    """Scales of the forward maps at one pose."""

    tensor: Nil
    position: float
    tangent: Nil
    near_pole: Nil  # of T⁻¹, times its condition: once for T⁻¹, twice for its derivative −T⁻¹ DT T⁻¹


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
        tensor=Nil(math.sqrt(3), norm(gradient(oracle.rotation)) * size_du),
        position=norm(operator) * size_du,
        tangent=Nil(norm(operator), norm(change) * size_du),
        near_pole=Nil(norm(inverted) * (1 + kappa), norm(change_inv) * size_du * (1 + 2 * kappa)),
    )


def scales(order: int, v: Any) -> Scales:
    return _scales(order, tuple(float(c) for c in v))


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


def close(found: np.ndarray, wanted: np.ndarray, bound: float) -> None:
    """Compare within a bound relative to the largest value."""
    np.testing.assert_allclose(found, wanted, rtol=0, atol=bound * max(1, abs(wanted).max()))
