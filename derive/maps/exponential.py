r"""Exponential of so(3) over dual numbers, on tensors and on quaternions.

.. math:: \exp\tilde a = I + \frac{\sin|a|}{|a|}\,\tilde a + \frac{1 - \cos|a|}{|a|^2}\,\tilde a^2 \qquad
    \text{CP23 (17), (25)}

For Re a = 0 the series terminates: ``skew(a)³ = −|a|² skew(a) = 0``.
"""

from __future__ import annotations

from typing import Any

from ..algebra import Quaternion, Tensor, Vector, functions, real_part
from .sign_tests import is_zero


def tensor_exponential(a: Vector, library: Any = functions) -> Tensor:
    """Return exp(skew(a)), a rotation by |a| about a.

    Parameters
    ----------
    a : Vector
        Euler (dual) vector.
    library
        Provider of ``sin``, ``cos``, ``sqrt`` for the coefficients.
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
