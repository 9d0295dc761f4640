"""Interpreter that executes the text of C headers on exact numbers.

Only the subset of C used in emitted headers is read; anything else raises `CError`. Numbers of any Python type may be
passed in for real arguments, and constants become exact fractions.
"""

from __future__ import annotations

import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .memory import UNSET, CError, Pointer

if TYPE_CHECKING:
    from .source import Source
    from .translate import Translator

__all__ = ["UNSET", "CError", "Pointer", "Unit", "load"]

FILE = "<translated from C>"


def _remainder(a: int, b: int) -> int:
    """Return the remainder of a truncating integer division, as in C."""
    return abs(a) % abs(b) * (-1 if a < 0 else 1)


def _chosen(condition: Any, one: Callable[[], Any], other: Callable[[], Any]) -> Any:
    """Return the value of one side of a selection; the other is not computed."""
    return one() if condition else other()


@dataclass(frozen=True, slots=True)
class Unit:
    """Functions of a translation unit, its preprocessed source, and the names of functions called so far."""

    source: Source
    translator: Translator
    functions: Mapping[str, Callable[..., Any]]
    called: set[str]

    def call(self, name: str, *arguments: Any) -> Any:
        """Call a function with pointers and numbers; raise `CError` with the line whose behaviour is undefined in C."""
        if name not in self.functions:
            raise CError(f"there is no function {name}")
        try:
            return self.functions[name](*arguments)
        except (CError, ArithmeticError, AttributeError, TypeError, ValueError) as error:
            frames = traceback.walk_tb(error.__traceback__)
            lines = [line for frame, line in frames if frame.f_code.co_filename == FILE]
            place = f"{self.translator.places[lines[-1] - 1]}: " if lines else ""
            raise CError(f"{name}: {place}{error}") from error

    @property
    def idle(self) -> list[str]:
        """Functions that were never called and that no other function calls."""
        return [name for name in self.functions if name not in self.called | self.translator.referred]


def load(
    text: str,
    folder: Path | None = None,
    defines: Mapping[str, str] | None = None,
    instead: Mapping[str, Callable[..., Any]] | None = None,
    constant: Callable[[Any], Any] = Fraction,
    choose: Callable[..., Any] = _chosen,
) -> Unit:
    """Read C text, whose quoted includes are files of a folder; a `CError` names any text outside the subset of C.

    Functions named in ``instead`` are replaced by functions of Python when others call them. ``constant`` makes real
    constants, of decimals and integers. ``choose`` takes a condition and two functions that return the values of sides.

    Examples
    --------
    >>> load("double half(double a) { return a / 2; }").call("half", Fraction(3))
    Fraction(3, 2)
    """
    from .source import LIBRARY, parse  # the parser of C is loaded for C only
    from .translate import Translator

    source, translator, called = parse(text, folder, defines or {}), Translator(), set[str]()
    for node in source.tree.ext:
        translator.external(node)
    names: dict[str, Any] = {f"f_{name}": function for name, (_, function) in LIBRARY.items()}
    names |= {"CError": CError, "Fraction": constant, "Pointer": Pointer, "UNSET": UNSET, "choose": choose}
    names |= {"remainder": _remainder, "called": called}
    exec(compile("\n".join(translator.lines), FILE, "exec", dont_inherit=True), names)
    names |= {f"f_{name}": function for name, function in (instead or {}).items()}
    defined = {name: names[f"f_{name}"] for name, function in translator.functions.items() if function.defined}
    return Unit(source, translator, defined, called)
