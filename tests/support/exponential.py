"""Exponential map from screws to poses by its power series, for number types of any precision.

A screw is the dual vector ξ = ω + ε t of exponential coordinates; its length is the dual angle α. With
S = skew(ξ) the pose is Σ Sᵏ/k! and the tangent operator, ω = T ξ̇, is Σ Sᵏ/(k+1)!.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tests.support.errors import norm
from tests.support.first_principles import pack
from tests.support.nilpotent import Nil, dot, inverse, matmul

TERMS = 400


def skew(a: Any) -> tuple[Any, ...]:
    zero = a[0] * 0
    return ((zero, -a[2], a[1]), (a[2], zero, -a[0]), (-a[1], a[0], zero))


def exponential(screw: Any) -> tuple[Any, Any]:
    """Return (dual tensor, tangent operator) of a dual vector, by series summed until terms change nothing."""
    matrix, zero = skew(screw), screw[0].re * 0
    term = tuple(tuple(Nil(zero + (i == j), zero) for j in range(3)) for i in range(3))
    rotation = operator = term
    for k in range(1, TERMS):
        term = tuple(tuple(c / k for c in row) for row in matmul(term, matrix))
        before, rotation = rotation, _added(rotation, term, 1)
        operator = _added(operator, term, k + 1)
        if (pack(before) == pack(rotation)).all():
            return rotation, operator
    raise ArithmeticError("the series has not ended")


def _added(total: Any, term: Any, divisor: int) -> Any:
    return tuple(tuple(a + b / divisor for a, b in zip(*rows, strict=True)) for rows in zip(total, term, strict=True))


def rodrigues(order: int, screw: Any, field: Any) -> tuple[Any, ...]:
    """Return v = tan(α/2n) u of a screw with ω ≠ 0."""
    alpha = field.sqrt(dot(screw, screw))
    factor = field.tan(alpha / (2 * order)) / alpha
    return tuple(factor * c for c in screw)


class ExponentialScales:
    """Scales of errors of the exponential map at one screw of six floats, named as in `errors.Scales`."""

    def __init__(self, screw: Any) -> None:
        floats, size = [float(c) for c in screw], norm(screw[3:])
        here = exponential([Nil(c, 0.0) for c in floats[:3]])
        operator = np.array(pack(here[1])[0], dtype=float)
        inverted = np.array(inverse(operator.tolist()))
        turned = [exponential([Nil(a, 1.0 * (i == j)) for i, a in enumerate(floats[:3])])[1] for j in range(3)]
        change = np.array([pack(t)[1] for t in turned], dtype=float)
        condition = norm(inverted) * norm(change) * norm(floats[:3])
        self.tensor = Nil(math.sqrt(3), 0.0)
        self.position = norm(operator) * size
        self.tangent = Nil(norm(operator), norm(change) * size)
        change_inv = norm(-inverted @ change @ inverted) * size
        self.near_pole = Nil(norm(inverted) * (1 + condition), change_inv * (1 + 2 * condition))
