"""Operations of formulas beyond + − ×: exact division, roots, comparison, selection, names.

Formulas that compute values and also record programs take an `Arithmetic`. `PLAIN` computes with numbers. A trace
(``codegen.trace``) records the operations and the names of intermediate values.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Protocol

from . import functions
from .coefficients import Coefficient


class Arithmetic(Protocol):
    """Operations on one kind of number."""

    def name(self, name: str, value: Coefficient, /) -> Coefficient:
        """Name a value and return it."""

    def name_rest(self, letter: str, /) -> None:
        """Name all further values by a letter and a number, where single letters do not suffice."""

    def corrected(self, value: Coefficient, /) -> Coefficient:
        """Return a named value whose rounding error a later Newton step corrects."""

    def rounded_off(self, value: Coefficient, /) -> Coefficient:
        """Return the rounding error of the additions recorded for a value; 0 without a record."""

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
        """Return a where the condition holds, else b."""


class Plain:
    """Operations on numbers of any type; names are ignored."""

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
