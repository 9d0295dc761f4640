"""Operations of formulas other than + − ×: exact division, roots, comparison, selection, names.

A formula with an `Arithmetic` argument computes values or records a program. The class itself computes with numbers. A
trace (``codegen.programs``) overrides every operation and records it, with the names of intermediate values.
"""

from __future__ import annotations

import operator
from fractions import Fraction
from typing import Any

from . import functions
from .dual import Coefficient


class Arithmetic:
    """Operations on numbers of any type; names are ignored."""

    def name(self, name: str, value: Coefficient, /) -> Coefficient:
        """Name a value and return it."""
        return value

    def name_rest(self, letter: str, /) -> None:
        """Set the letter that, with a number, names all further values."""

    def corrected(self, value: Coefficient, /) -> Coefficient:
        """Mark a value whose rounding error a later Newton step corrects, and return the value."""
        return value

    def rounded_off(self, value: Coefficient, /) -> Coefficient:
        """Return the rounding error of the additions recorded for a value; 0 without a record."""
        return 0

    def div(self, a: Coefficient, b: Coefficient, /) -> Coefficient:
        """Return a/b, as an exact fraction for integers."""
        return Fraction(a, b) if isinstance(a, int) and isinstance(b, int) else a / b

    def reciprocal(self, like: Coefficient, b: int, /) -> Coefficient:
        """Return 1/b as a number like another one; programs hold it as a constant."""
        return self.div(like - like + 1, b)

    def beside(self, size: Coefficient, term: Coefficient, /) -> Coefficient:
        """Return size + term, for comparison with the size: equal if the data's precision loses the term."""
        return size + term

    abs = staticmethod(abs)
    sqrt = staticmethod(functions.sqrt)
    tan = staticmethod(functions.tan)
    atan2 = staticmethod(functions.atan2)
    expm1 = staticmethod(functions.expm1)
    log1p = staticmethod(functions.log1p)
    less = staticmethod(operator.lt)
    equal = staticmethod(operator.eq)

    def both(self, a: Any, b: Any, /) -> Any:
        return a and b

    def either(self, a: Any, b: Any, /) -> Any:
        return a or b

    def where(self, condition: Any, a: Coefficient, b: Coefficient, /) -> Coefficient:
        """Return a where the condition holds, else b."""
        return a if condition else b


PLAIN = Arithmetic()


class Marked:
    """Arithmetic whose names end in a mark, for a formula inside another one."""

    def __init__(self, arithmetic: Arithmetic, mark: str) -> None:
        self._arithmetic = arithmetic
        self._mark = mark

    def name(self, name: str, value: Coefficient, /) -> Coefficient:
        return self._arithmetic.name(name + self._mark, value)

    def __getattr__(self, operation: str) -> Any:
        return getattr(self._arithmetic, operation)
