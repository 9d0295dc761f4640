"""Sums and products between numbers, vectors, quaternions and tensors, in the notation of the papers.

A number plus a vector is a quaternion, and two adjacent vectors are multiplied as quaternions. A tensor left of a
vector or a tensor acts on it.
"""

from __future__ import annotations

from typing import Any

from .dual import Structure
from .structures import Quaternion, Tensor, Vector


class MeaninglessError(TypeError):
    """Error for an operation that is not defined for its operands."""


def quaternion(a: Any) -> Quaternion:
    """Return a number, vector or quaternion as a quaternion."""
    if isinstance(a, Quaternion):
        return a
    if isinstance(a, Vector):
        return Quaternion(0, a)
    if isinstance(a, Structure):
        raise MeaninglessError(f"a {type(a).__name__.lower()} is no quaternion")
    return Quaternion(a, Vector(0, 0, 0))


def add(a: Any, b: Any) -> Any:
    """Return the sum; a number plus a vector is a quaternion."""
    if type(a) is type(b) or not (isinstance(a, Structure) or isinstance(b, Structure)):
        return a + b
    return quaternion(a) + quaternion(b)


def multiply(a: Any, b: Any) -> Any:
    """Return the product of two adjacent factors in a formula."""
    if not (isinstance(a, Structure) and isinstance(b, Structure)):
        return a * b
    if isinstance(a, Tensor) and isinstance(b, Tensor | Vector):
        return a @ b
    return quaternion(a) * quaternion(b)
