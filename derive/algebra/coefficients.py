"""What every structure of this package asks of its coefficients, and what it promises about itself.

A coefficient is any value of a commutative ring with ``+ - *`` (and ``/`` where a method divides): ``int``, ``float``,
``fractions.Fraction``, mpmath ``mpf``, SymPy expressions, elements of polynomial rings and fraction fields, traced
values, and `Dual` numbers over any of these. Coefficients are duck-typed, hence the alias of ``Any``. Where a zero
divisor must be told apart, ``coefficient == 0`` decides.
"""

from __future__ import annotations

from typing import Any, ClassVar, TypeAlias

Coefficient: TypeAlias = Any


class ZeroDivisorError(ZeroDivisionError):
    """A value with vanishing real part was asked for its inverse, quotient or square root: it is a zero divisor."""


class Structure:
    """Base of vectors, tensors and quaternions: has coefficients and never is one.

    Scalars leave a product with a structure to the structure. ``__array_ufunc__ = None`` makes NumPy scalars and
    arrays do the same instead of looping over its components.
    """

    __slots__ = ()
    __array_ufunc__: ClassVar[None] = None
