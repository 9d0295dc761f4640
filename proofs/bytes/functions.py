"""Functions of C headers as trees of rounded operations: the emitted text, executed on symbols."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pycparser import c_ast

from derive.codegen.validation.c_interpreter import UNSET, CError, Pointer, load

from ..statements import MachineError
from .equality import Equality
from .numbers import Number, Truth
from .trees import Declined, Tree, Trees

SHARED = ("dualcay.h", "geometry.h", "differential.h")


@dataclass(frozen=True)
class Parameter:
    """Parameter of a function: ``size`` numbers, of an argument or of a result; 0 stands for an integer."""

    name: str
    size: int
    made: bool = False
    single: bool = False  # a number that is not passed in an array


@dataclass(frozen=True)
class Signature:
    """Public function for one value, with its parameters in order."""

    name: str
    parameters: tuple[Parameter, ...]
    returns: bool

    @property
    def given(self) -> list[Parameter]:
        return [each for each in self.parameters if each.size and not each.made]

    @property
    def made(self) -> list[Parameter]:
        return [each for each in self.parameters if each.made]

    @property
    def branched(self) -> bool:
        return any(not each.size for each in self.parameters)


class Source:
    """Header of a chart with that of its rotations, where there is one, and their public functions."""

    def __init__(self, folder: Path, chart: str, trees: Trees) -> None:
        files = [f"{chart}.h", *(f"rotation/{chart}.h" for _ in [0] if (folder / "rotation" / f"{chart}.h").is_file())]
        self.text, self.trees = "".join(f'#include "{name}"\n' for name in files), trees
        self.equality = Equality(trees)  # of all compilers: their trees have much in common
        self.found: dict[tuple[Signature, bool, int], list[Tree]] = {}
        try:
            self.unit = load(self.text, folder, {"DUALCAY_FUNCTION": ""}, constant=self._constant, choose=_choose)
        except (CError, OSError) as error:
            raise MachineError(f"{chart}: {error}") from error
        self.functions = [
            _signature(node.decl) for node in self.unit.source.tree.ext
            if isinstance(node, c_ast.FuncDef) and "static" not in node.decl.storage
        ]  # fmt: skip

    def _constant(self, value: Any) -> Number:
        if isinstance(value, Truth):
            return Number(self.trees, self.trees.number(self.trees.lift(self.trees.constant, value.value)))
        return Number(self.trees, self.trees.constant(value))

    def results(self, function: Signature, rows: bool, branch: int) -> list[Tree]:
        """Return the results of a function, the returned integer last; of the form for rows, those of one row."""
        if (function, rows, branch) not in self.found:
            self.found[function, rows, branch] = self._run(function, rows, branch)
        return self.found[function, rows, branch]

    def _run(self, function: Signature, rows: bool, branch: int) -> list[Tree]:
        made = [Pointer.to([UNSET] * each.size) for each in function.made]
        waiting = iter(made)
        passed: list[Any] = [1] * rows
        for each in function.parameters:
            numbers = [Number(self.trees, given(self.trees, each, place)) for place in range(each.size)]
            if not each.size:
                passed.append(branch)
            elif each.single and not rows:
                passed += numbers
            else:
                passed += [next(waiting) if each.made else Pointer.to(numbers), *[1] * rows]
        try:
            returned = self.unit.call(function.name + "_rows" * rows, *passed)
        except CError as error:
            raise Declined(f"the text: {error}") from error
        found = [cells[place] for cells, each in zip(made, function.made, strict=True) for place in range(each.size)]
        return [_tree(self.trees, each) for each in [*found, *[returned] * function.returns]]


def _choose(condition: Any, one: Callable[[], Any], other: Callable[[], Any]) -> Any:
    if isinstance(condition, Truth):
        return condition.choose(one(), other())
    return one() if condition else other()


def given(trees: Trees, parameter: Parameter, place: int, row: int = 0) -> Tree:
    """Return the number at a place of an argument."""
    return trees.make("given", parameter.name, place, row)


def _tree(trees: Trees, value: Any) -> Tree:
    return value.tree if isinstance(value, Number) else trees.constant(value)


def _signature(declaration: c_ast.Decl) -> Signature:
    parameters = tuple(_parameter(each) for each in declaration.type.args.params)
    return Signature(declaration.name, parameters, declaration.type.type.type.names != ["void"])


def _parameter(node: c_ast.Decl) -> Parameter:
    if isinstance(node.type, c_ast.ArrayDecl):
        return Parameter(node.name, int(node.type.dim.value), "const" not in node.type.type.quals)
    names: Sequence[str] = getattr(getattr(node.type, "type", None), "names", ())
    return Parameter(node.name, 0 if list(names) == ["int"] else 1, single=True)


def charts(folder: Path) -> list[str]:
    """Return the charts of a folder of headers."""
    return sorted(path.stem for path in folder.glob("*.h") if path.name not in SHARED)
