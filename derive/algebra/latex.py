"""LaTeX of coefficients, matrices, combinations of the elements of a basis, and results that notebooks show."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

import sympy


class Typeset:
    """Base class of results that a notebook and ``sympy.latex`` show as a formula."""

    __slots__ = ()

    def _typeset(self) -> str:
        """Return the formula in LaTeX, without delimiters."""
        raise NotImplementedError

    def _latex(self, printer: object) -> str:
        return self._typeset()

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self._typeset()}$"


def latex(value: Any) -> str:
    """Return a coefficient, with ascending powers as in the papers; elements of exact rings are printed as text."""
    if hasattr(value, "_typeset"):  # a dual number
        return str(value._typeset())
    return str(sympy.latex(sympy.Rational(value) if isinstance(value, Fraction) else value, order="rev-lex"))


def bracketed(value: Any) -> str:
    """Return a coefficient for a product: sums and dual numbers stand in brackets."""
    text = latex(value)
    return rf"\left({text}\right)" if getattr(value, "is_Add", hasattr(value, "_typeset")) else text


def matrix(entries: Iterable[Any], columns: int) -> str:
    cells = [*map(latex, entries)]
    rows = r" \\ ".join(" & ".join(cells[i : i + columns]) for i in range(0, len(cells), columns))
    return rf"\begin{{bmatrix}} {rows} \end{{bmatrix}}"


def combination(coefficients: Iterable[Any], basis: Iterable[str]) -> str:
    """Return the sum of coefficients times the elements of a basis, without zero terms; the element 1 is ``""``."""
    terms = [f"{bracketed(a)} {e}" if e else latex(a) for a, e in zip(coefficients, basis, strict=True) if a != 0]
    return " + ".join(terms or ["0"]).replace("+ - ", "- ").replace("+ -", "- ")
