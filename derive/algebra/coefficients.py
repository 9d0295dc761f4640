"""Coefficients and the base class of the structures of this package.

A coefficient is any value of a commutative ring with ``+ - *`` (and ``/`` where a method divides): ``int``, ``float``,
``fractions.Fraction``, mpmath ``mpf``, SymPy expressions, elements of polynomial rings and fraction fields, traced
values, and `Dual` numbers over any of these. Coefficients are duck-typed, hence the alias of ``Any``. Zero divisors are
detected by ``coefficient == 0``.
"""

from __future__ import annotations

from typing import Any, ClassVar, TypeAlias

Coefficient: TypeAlias = Any


class ZeroDivisorError(ZeroDivisionError):
    """Error: inverse, quotient or square root of a zero divisor, a dual number with real part zero."""


class Structure:
    """Base class of vectors, tensors and quaternions; a structure is never a coefficient.

    The structure computes its products with scalars. ``__array_ufunc__ = None`` makes NumPy scalars and arrays leave
    these products to the structure, instead of looping over its components.
    """

    __slots__ = ()
    __array_ufunc__: ClassVar[None] = None
