"""What a formula may do with numbers beyond + − ×: divide exactly, take roots, compare, select, name.

Formulas that serve values and programs alike take an `Arithmetic`. `PLAIN` computes with the numbers as they are; a
trace (``codegen.trace``) records the same operations, and the names of intermediate values with them.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Protocol

from . import functions
from .coefficients import Coefficient


class Arithmetic(Protocol):
    """The operations of one kind of number."""

    def name(self, name: str, value: Coefficient, /) -> Coefficient:
        """Return the value, known by this letter from now on."""

    def name_rest(self, letter: str, /) -> None:
        """Values of formulas that are made by a computer, too many for letters, are known by one and a number."""

    def corrected(self, value: Coefficient, /) -> Coefficient:
        """Return the value, a named one, whose rounding is corrected afterwards: by a step of Newton's method."""

    def rounded_off(self, value: Coefficient, /) -> Coefficient:
        """Return what rounding took from additions that are known to make a value; 0 where none are."""

    def div(self, a: Coefficient, b: Coefficient, /) -> Coefficient:
        """Return a/b, exact where both are exact."""

    def abs(self, a: Coefficient, /) -> Coefficient: ...
    def sqrt(self, a: Coefficient, /) -> Coefficient: ...
    def tan(self, a: Coefficient, /) -> Coefficient: ...
    def atan2(self, a: Coefficient, b: Coefficient, /) -> Coefficient: ...
    def expm1(self, a: Coefficient, /) -> Coefficient: ...
    def log1p(self, a: Coefficient, /) -> Coefficient: ...
    def less(self, a: Coefficient, b: Coefficient, /) -> Any: ...
    def equal(self, a: Coefficient, b: Coefficient, /) -> Any: ...
    def both(self, a: Any, b: Any, /) -> Any: ...
    def either(self, a: Any, b: Any, /) -> Any: ...
    def where(self, condition: Any, a: Coefficient, b: Coefficient, /) -> Coefficient:
        """Return a where the condition holds, b elsewhere."""


class Plain:
    """Numbers of any type as they are; names are forgotten."""

    abs = staticmethod(abs)
    sqrt = staticmethod(functions.sqrt)
    tan = staticmethod(functions.tan)
    atan2 = staticmethod(functions.atan2)
    expm1 = staticmethod(functions.expm1)
    log1p = staticmethod(functions.log1p)

    @staticmethod
    def name(name: str, value: Coefficient) -> Coefficient:
        return value

    @staticmethod
    def corrected(value: Coefficient) -> Coefficient:
        return value

    @staticmethod
    def rounded_off(value: Coefficient) -> Coefficient:
        return 0

    @staticmethod
    def name_rest(letter: str) -> None:
        pass

    @staticmethod
    def div(a: Coefficient, b: Coefficient) -> Coefficient:
        return Fraction(a, b) if isinstance(a, int) and isinstance(b, int) else a / b

    @staticmethod
    def less(a: Coefficient, b: Coefficient) -> bool:
        return bool(a < b)

    @staticmethod
    def equal(a: Coefficient, b: Coefficient) -> bool:
        return bool(a == b)

    @staticmethod
    def both(a: bool, b: bool) -> bool:
        return a and b

    @staticmethod
    def either(a: bool, b: bool) -> bool:
        return a or b

    @staticmethod
    def where(condition: bool, a: Coefficient, b: Coefficient) -> Coefficient:
        return a if condition else b


PLAIN: Arithmetic = Plain()
