"""Motion from first principles: exponentials, rotation by its action on vectors, the twist ``vect(Ṙ Rᵀ)``, rates.

No closed form of a tangent operator is used: dual numbers differentiate the given map. Twists are in the space frame
unless stated otherwise.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from . import Coefficient, Dual, Quaternion, Tensor, Vector, dual_part, functions, real_part
from .pose import is_zero


def tensor_exponential(a: Vector, library: Any = functions) -> Tensor:
    """Return exp(skew(a)), a rotation by |a| about a; `library` provides ``sin``, ``cos``, ``sqrt``."""
    _, sinc, versine = _circular(a.dot(a), library)
    skew = Tensor.skew(a)
    R: Tensor = Tensor.identity() + skew * sinc + skew @ skew * versine
    return R


def quaternion_exponential(a: Vector, library: Any = functions) -> Quaternion:
    """Return exp(a) = cos|a| + sin|a| a/|a| of a pure quaternion; a rotation by 2|a| about a."""
    cosine, sinc, _ = _circular(a.dot(a), library)
    return Quaternion(cosine, a * sinc)


def _circular(square: Any, library: Any) -> tuple[Any, Any, Any]:
    """Return ``cos a``, ``sin a/a`` and ``(1 − cos a)/a²`` of the square of a.

    At a = 0 their series end with the square of a², in dual numbers whose parts may have rates.
    """
    innermost = square
    while isinstance(innermost, Dual):
        innermost = innermost.re
    if is_zero(innermost):
        twice = square * square
        return 1 - square / 2 + twice / 24, 1 - square / 6 + twice / 120, (1 - square / 12 + twice / 360) / 2
    a = library.sqrt(square)
    return library.cos(a), library.sin(a) / a, (1 - library.cos(a)) / square


def tensor_by_sandwich(q: Quaternion) -> Tensor:
    """Return the tensor of ``r -> q r q*``, column by column, for a unit (dual) quaternion."""
    columns = (q.sandwich(Vector(*row)) for row in Tensor.identity().rows)
    return Tensor.from_entries(entry for column in columns for entry in column).transpose


def twist(R: Tensor, R_dot: Tensor) -> Vector:
    """Return the space twist ``vect(Ṙ Rᵀ)``, CP23 (68), (69)."""
    return (R_dot @ R.transpose).vect()


def body_twist(R: Tensor, R_dot: Tensor) -> Vector:
    """Return the body twist ``Rᵀ ω = vect(Rᵀ Ṙ)``."""
    return (R.transpose @ R_dot).vect()


def tangent(displacement: Callable[[Vector], Tensor | Quaternion], v: Vector) -> Tensor:
    """Return the operator from v̇ to the space twist of a displacement, by differentiation along each axis.

    The displacement is a tensor or a quaternion that need not be a unit.
    """
    columns = []
    for axis in Tensor.identity().rows:
        moved = displacement(Vector(*(_moving(c, rate) for c, rate in zip(v, axis, strict=True))))
        columns.append(_twist(moved))
    return Tensor.from_entries(entry for column in columns for entry in column).transpose


def _moving(c: Coefficient, rate: Coefficient) -> Dual:
    """Return the coefficient with its rate as dual part; each part of a dual number gets its rate."""
    if not isinstance(c, Dual):
        return Dual(c, rate)
    return Dual(Dual(c.re, real_part(rate)), Dual(c.du, dual_part(rate)))


def _part(c: Any, part: Callable[[Any], Any]) -> Any:
    """Return the value or the rate of a moving coefficient, by `real_part` or `dual_part`."""
    return Dual(part(c.re), part(c.du)) if isinstance(c, Dual) and isinstance(c.re, Dual) else part(c)


def _twist(moved: Tensor | Quaternion) -> Vector:
    now: Any = moved.map(lambda c: _part(c, real_part))
    rate: Any = moved.map(lambda c: _part(c, dual_part))
    if isinstance(moved, Tensor):
        return twist(now, rate)
    found: Vector = (rate * now.conjugate()).vector * 2 / now.norm2()
    return found
