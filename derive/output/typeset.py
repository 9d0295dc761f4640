"""Results that notebooks and ``sympy.latex`` show as formulas."""

from __future__ import annotations


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
