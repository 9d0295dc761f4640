"""Exponentials of tensors skew(a) and of pure quaternions, for any numbers, CP23 (17), (25)."""

from __future__ import annotations

from typing import Any

from . import functions
from .dual import real_part
from .pose import is_zero
from .structures import Quaternion, Tensor, Vector


def tensor_exponential(a: Vector, library: Any = functions) -> Tensor:
    """Return exp(skew(a)), a rotation by |a| about a; `library` provides ``sin``, ``cos``, ``sqrt``.

    For Re a = 0 the series terminates: ``skew(a)³ = −|a|² skew(a) = 0``.
    """
    square, skew = a.dot(a), Tensor.skew(a)
    if is_zero(real_part(square)):
        nilpotent: Tensor = Tensor.identity() + skew + skew @ skew / 2
        return nilpotent
    angle = library.sqrt(square)
    R: Tensor = Tensor.identity() + skew * (library.sin(angle) / angle)
    R += skew @ skew * ((1 - library.cos(angle)) / square)
    return R


def quaternion_exponential(a: Vector, library: Any = functions) -> Quaternion:
    """Return exp(a) = cos|a| + sin|a| a/|a| of a pure quaternion; a rotation by 2|a| about a."""
    square = a.dot(a)
    if is_zero(real_part(square)):
        return Quaternion(1 + 0 * square, a)
    angle = library.sqrt(square)
    return Quaternion(library.cos(angle), a * (library.sin(angle) / angle))
