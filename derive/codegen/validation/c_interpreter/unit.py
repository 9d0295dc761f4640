"""A translation unit: the functions a header defines, ready to be called."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pycparser import c_ast

from .errors import CError, refuse
from .scope import Condition, Scope
from .source import Source, parse
from .statements import declaration, declare_function, define


@dataclass(frozen=True, slots=True)
class Unit:
    """The functions of a translation unit, and its macros."""

    source: Source
    scope: Scope

    def call(self, name: str, *arguments: Any) -> Any:
        """Call a function with pointers and integers.

        Raises
        ------
        CError
            If there is no such function, or C does not define what it does: access beyond an array or to a cell never
            written, a division by the zero of the number type, an overflow.
        """
        function = self.scope.functions.get(name)
        if function is None or function.body is None:
            raise CError(f"there is no function {name}")
        if len(arguments) != len(function.parameters):
            raise CError(f"{name} takes {len(function.parameters)} arguments, not {len(arguments)}")
        try:
            return function.run(arguments)
        except CError as error:
            raise CError(f"{name}: {error}") from error

    @property
    def idle(self) -> list[str]:
        """Functions that nothing has called, and that no other function would call."""
        defined = [f for f in self.scope.functions.values() if f.body is not None]
        inner = {name for function in defined for name in function.names}
        return [f.name for f in defined if not f.calls and f.name not in inner]

    @property
    def one_sided(self) -> list[Condition]:
        """Conditions of functions that were called, which took one truth value only."""
        return [condition for condition in self.scope.conditions if len(condition.taken) == 1]


def load(text: str, folder: Path | None = None, defines: Mapping[str, str] | None = None) -> Unit:
    """Read a text, whose quoted includes are files of the folder, if one is given.

    Raises
    ------
    CError
        For what is not C, or not the part of C that is read here; integer divisions among it.

    Examples
    --------
    >>> from fractions import Fraction
    >>> unit = load("double half(double a) { return a / 2; }")
    >>> unit.call("half", Fraction(3))
    Fraction(3, 2)
    """
    source = parse(text, folder, defines or {})
    scope = Scope()
    for node in source.tree.ext:
        _external(node, scope)
    return Unit(source, scope)


def _external(node: c_ast.Node, scope: Scope) -> None:
    if isinstance(node, c_ast.Typedef):
        scope.types[node.name] = scope.type_of(node.type)
    elif isinstance(node, c_ast.FuncDef):
        define(node, scope)
    elif isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.FuncDecl):
        declare_function(node, scope)
    elif isinstance(node, c_ast.Decl):
        declaration(node, scope)
    elif not isinstance(node, c_ast.Pragma):
        raise refuse(node, f"{type(node).__name__} is not read here")
