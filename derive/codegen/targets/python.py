"""What the targets in Python share: one documented interface, and the words in which they differ."""

from __future__ import annotations

import ast
import re
import textwrap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ... import about
from ...maps.cayley import EQUATIONS
from ...maps.chart import DEFINITIONS, Chart
from ...maps.named import NUMBERED, SINGLE
from ..facts import Facts, comment, numbers, theorem_lines
from ..programs.program import Program, summary
from ..signatures import FUNCTIONS, KERNELS, PUBLIC, Function, aliases
from ..validation import NUMPY, Choose, Library, Machinery, everything, replay, validate
from .expression import WIDTH
from .target import Data, require_functions

INTERFACE = "_interface.py"
CLASS = "PoseKernels"


@dataclass(frozen=True, slots=True)
class Words:
    """How a target speaks of arrays, what it keeps of them, and the keyword parameters of its functions.

    ``passed`` is what a function passes on of them, ``passed_alone`` one that does more with the result; ``placed`` is
    where that result goes. ``makes`` says that there are arrays without arguments: the identity, random poses.
    """

    value: str
    array_like: str
    array: str
    kept: str
    options: str
    passed: str
    passed_alone: str
    placed: str
    makes: bool

    @property
    def keywords(self) -> list[str]:
        """Names of the keyword parameters of functions that return one array."""
        return re.findall(r"(\w+):", self.options)

    @property
    def plain(self) -> tuple[str, ...]:
        """Functions of a module that take no arrays, and so have no row in the table."""
        return ("singular_angles", *(("identity", "random") if self.makes else ()))


@dataclass(frozen=True, slots=True)
class Printed:
    """A program as its template shows it: parameters of its function, operations, and what the printer makes of it."""

    name: str
    summary: str
    parameters: tuple[str, ...]
    forms: Any


class PythonTarget:
    """What the rows of these targets share."""

    extension = "py"
    entry = "__init__.py"
    comment = "#"
    machinery = Machinery()
    uncompiled: tuple[str, ...] = ()
    """Functions that run as they are even where compiled ones are installed; empty where nothing uses those."""
    name: str
    words: Words

    def package(self) -> Mapping[str, Data]:
        """The files by which a package is imported and run."""
        option = "" if self.name == about.TARGET else f" --target {self.name}"
        families = "|".join([*SINGLE, *(rf"{stem}[1-9]\d*" for stem in NUMBERED)])
        init = {"version": about.__version__, "target": self.name, "option": option, "families": families}
        return {self.entry: {**init, "uncompiled": self.uncompiled}, "__main__.py": {}, "py.typed": {}}

    def companions(self, chart: Chart) -> Mapping[str, tuple[str, Data]]:
        return {}

    def require_complete(self, texts: Mapping[str, str]) -> None:
        require_complete(texts, self.words)

    def validate(self, folder: Path, chart: Chart, choose: Choose = everything) -> int:
        return validate(folder, chart, choose)

    def replay(self, folder: Path, chart: Chart, all_ways: bool) -> int:
        return replay(folder, chart, self.machinery, self.libraries(), all_ways=all_ways)

    def libraries(self) -> Sequence[Library]:
        """Whose arrays the functions are given in a replay."""
        return (NUMPY,)

    def test(self, folder: Path, chart: Chart) -> int:
        return 0


def interface(words: Words) -> Data:
    """What the template of the interface is given."""
    equations = {name: numbers(equations) for name, equations in EQUATIONS.items()}
    theorems = comment(theorem_lines(), "#")
    return {"words": words, "definitions": DEFINITIONS, "equations": equations, "theorems": theorems}


def described(facts: Facts, words: Words) -> dict[str, Any]:
    """What every Python module says of its chart."""
    chart = facts.chart
    exported = aliases(chart) | {name: name for name in (*PUBLIC, *words.plain)}
    return {
        "title": chart.title,
        "parameter": chart.parameter,
        "branches": chart.branches,
        "definitions": facts.definitions("    "),
        "domain": facts.domain,
        "singular": facts.singular,
        "singular_angles": facts.singular_angles,
        "order": chart.order,
        "overflow": facts.overflow,
        "largest": facts.largest,
        "turns": facts.turns,
        "returns": facts.returns,
        "exports": _quoted(exported),
        "exported": dict(sorted(exported.items())),
    }


def _quoted(names: Iterable[str]) -> str:
    """Names as lines of a list."""
    lines = textwrap.wrap(" ".join(f'"{name}",' for name in sorted(names)), WIDTH - 4)
    return "\n".join(f"    {line}" for line in lines)


def printed(program: Program, forms: Any, parameters: tuple[str, ...] = ()) -> Printed:
    """A program of a geometry, whose parameters are its arguments, or another with the parameters given."""
    arguments = tuple(argument for argument, _ in program.inputs)
    return Printed(program.name, f"operations {summary(program.operations)}", parameters or arguments, forms)


def components(program: Program) -> tuple[str, ...]:
    """The parameters of a scalar program."""
    return tuple(name for _, names in program.inputs for name in names)


def rows() -> Mapping[str, Any]:
    """The rows of the table that have a program, for the template of a geometry."""
    return KERNELS


def require_complete(texts: Mapping[str, str], words: Words) -> None:
    """Compare the methods of the interface, and their parameters, with the table.

    Raises
    ------
    ValueError
        If a function is missing, is in no row, has no docstring, or takes other parameters than its row says.
    """
    methods = {method.name: method for method in _methods(texts[INTERFACE])}
    require_functions(INTERFACE, [name for name in methods if name not in words.plain])
    for name, method in methods.items():
        if name in FUNCTIONS:
            _require_parameters(FUNCTIONS[name], method.args, words)
        if not ast.get_docstring(method):
            raise ValueError(f"{INTERFACE}: {name} has no docstring")


def _require_parameters(row: Function, found: ast.arguments, words: Words) -> None:
    """Arguments as in the table; after them the keywords of every function, or of those that return several arrays."""
    given = [argument.arg for argument in (*found.posonlyargs, *found.args)][1:]
    expected = [array.name for array in row.arguments] + ["branch"] * row.branch
    if given != expected:
        raise ValueError(f"{INTERFACE}: {row.name} takes {', '.join(given)}, and {', '.join(expected)} in the table")
    keywords = [argument.arg for argument in found.kwonlyargs]
    wanted = [*(words.keywords if len(row.results) == 1 else ["axis"]), *row.keywords]
    if keywords != wanted:
        raise ValueError(f"{INTERFACE}: keywords of {row.name} are {', '.join(keywords)}, not {', '.join(wanted)}")


def _methods(text: str) -> Iterator[ast.FunctionDef]:
    """Public methods of the class of kernels."""
    for node in ast.parse(text).body:
        if isinstance(node, ast.ClassDef) and node.name == CLASS:
            for item in node.body:
                if isinstance(item, ast.FunctionDef) and not item.name.startswith("_"):
                    yield item
