"""Scalars of a chart, each computed and named on first use."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ..algebra import Coefficient


class scalar:
    """Scalar of a class with an arithmetic ``m``, given by its formula.

    Parameters
    ----------
    formula : callable
        Return the value from the other scalars.
    name : str, optional
        Name in programs; the name of the attribute by default.
    """

    def __init__(self, formula: Callable[[Any], Coefficient], name: str = "") -> None:
        self.formula = formula
        self.name = name

    def __set_name__(self, owner: type, attribute: str) -> None:
        self.attribute = attribute
        self.name = self.name or attribute

    def __get__(self, at: Any, owner: type | None = None) -> Any:
        if at is None:
            return self
        value = at.m.name(self.name, self.formula(at))
        at.__dict__[self.attribute] = value
        return value
