"""A translation unit: the functions that a header defines, ready to be called."""

from __future__ import annotations

import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from .memory import UNSET, CError, Pointer
from .source import Source, parse
from .translate import Translator
from .types import LIBRARY

FILE = "<translated from C>"


def _remainder(a: int, b: int) -> int:
    """Return the remainder of a division that truncates, as in C."""
    return abs(a) % abs(b) * (-1 if a < 0 else 1)


def _size(value: int) -> int:
    if value < 0:
        raise CError(f"{value} overflows size")
    return value


RUNTIME: Mapping[str, Any] = {
    "CError": CError, "Fraction": Fraction, "Pointer": Pointer, "UNSET": UNSET, "remainder": _remainder, "size": _size,
    **{f"f_{name}": function for name, (_, function) in LIBRARY.items()},
}  # fmt: skip
"""Names that translated functions use."""


@dataclass(frozen=True, slots=True)
class Unit:
    """The functions of a translation unit, and its macros."""

    source: Source
    translator: Translator
    functions: Mapping[str, Callable[..., Any]]
    called: set[str]

    def call(self, name: str, *arguments: Any) -> Any:
        """Call a function with pointers and integers.

        Raises
        ------
        CError
            If there is no such function, or C does not define what it does: access beyond an array or to a cell never
            written, a division by the zero of the number type.
        """
        function = self.functions.get(name)
        if function is None:
            raise CError(f"there is no function {name}")
        wanted = len(self.translator.functions[name].parameters)
        if len(arguments) != wanted:
            raise CError(f"{name} takes {wanted} arguments, not {len(arguments)}")
        try:
            return function(*arguments)
        except (CError, ArithmeticError, AttributeError, TypeError, ValueError) as error:
            raise CError(f"{name}: {self._place(error)}: {error}") from error

    def _place(self, error: Exception) -> str:
        """Return file and line of the innermost C statement that was being executed."""
        lines = [line for frame, line in traceback.walk_tb(error.__traceback__) if frame.f_code.co_filename == FILE]
        return self.translator.places[lines[-1] - 1]

    def expand(self, text: str) -> str:
        """Return the text with the macros of the header expanded."""
        return self.source.expand(text)

    @property
    def idle(self) -> list[str]:
        """Functions that nothing has called, and that no other function refers to."""
        return [name for name in self.functions if name not in self.called | self.translator.referred]


def load(text: str, folder: Path | None = None, defines: Mapping[str, str] | None = None) -> Unit:
    """Read a text, whose quoted includes are files of the folder, if one is given.

    Raises
    ------
    CError
        For what is not C, or not the subset of C that is read here; integer divisions among it.

    Examples
    --------
    >>> from fractions import Fraction
    >>> unit = load("double half(double a) { return a / 2; }")
    >>> unit.call("half", Fraction(3))
    Fraction(3, 2)
    """
    source, translator, called = parse(text, folder, defines or {}), Translator(), set[str]()
    for node in source.tree.ext:
        translator.external(node)
    names = {**RUNTIME, "called": called}
    exec(compile("\n".join(translator.lines), FILE, "exec", dont_inherit=True), names)
    defined = (function.name for function in translator.functions.values() if function.defined)
    return Unit(source, translator, {name: names[f"f_{name}"] for name in defined}, called)
