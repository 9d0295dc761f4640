"""Base class of the Python targets: one documented interface, with keyword parameters that differ by target."""

from __future__ import annotations

import ast
import re
from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from ... import about
from ...maps.cayley import EQUATIONS
from ...maps.chart import DEFINITIONS, Chart
from ...maps.named import NUMBERED, SINGLE
from ..lowered import Lowered, lower_chart, shared_with_poses
from ..lowered import printed_geometry as lowered_geometry
from ..lowering.scalars import FORMULAS
from ..package import Data, Facts, comment, numbers
from ..programs.program import Program
from ..programs.shared import with_helpers
from ..rows import Function, Table, inside
from ..signatures import JACOBIAN, POSES
from ..validation import NUMPY, Library, Machinery, replay, validate
from . import infix
from .target import require_functions

INTERFACE = "_interface.py"

CLASSES = {"": "PoseKernels", "rotation": "RotationKernels"}
"""Classes of the documented interfaces, by table."""



@dataclass(frozen=True, slots=True)
class Words:
    """Keyword parameters of a target's functions, as its templates spell them.

    Parameters
    ----------
    options : str
        Keyword parameters of functions that return one array.
    passed, passed_alone : str
        Arguments that a method passes on, with and without an array for the result.
    placed : str
        Arguments that place a result.
    makes : bool
        True if functions make arrays without arguments: the identity, random poses.
    """

    options: str
    passed: str
    passed_alone: str
    placed: str
    makes: bool

    @property
    def keywords(self) -> list[str]:
        """Return the names of the keyword parameters of functions that return one array."""
        return re.findall(r"(\w+):", self.options)

    @property
    def plain(self) -> tuple[str, ...]:
        """Return the functions of a module that take no arrays and so have no row in the table."""
        return ("singular_angles", *(("identity", "random") if self.makes else ()))


@dataclass(frozen=True, slots=True)
class Printed:
    """Program for its template: parameters, text of the body, and its formula as a comment."""

    name: str
    parameters: tuple[str, ...]
    forms: Any
    formula: str = ""


class PythonTarget(ABC):
    """Target whose kernels are Python modules."""

    extension = "py"
    entry = "__init__.py"
    comment = "#"
    machinery = Machinery()
    tables: Sequence[Table] = (POSES,)
    uncompiled: tuple[str, ...] = ()
    """Functions without a compiled form in ``dualcay-native``."""
    imports_bases = False
    name: str
    words: Words

    def package(self) -> Mapping[str, Data]:
        """Return the files that import and run a package."""
        option = "" if self.name == about.TARGET else f" --target {self.name}"
        families = "|".join([*SINGLE, *(rf"{stem}[1-9]\d*" for stem in NUMBERED)])
        packages = [table.name for table in self.tables if table.name]
        common: Data = {"option": option, "families": families, "target": self.name, "uncompiled": self.uncompiled}
        inner = {
            inside(table, self.entry): {**common, "packages": [], "package": table.name, "class": CLASSES[table.name]}
            for table in self.tables
        }
        init = {**inner[self.entry], "version": about.__version__, "packages": packages}
        return {**inner, self.entry: init, "__main__.py": {}, "py.typed": {}}

    def per_table(self) -> Mapping[str, Data]:
        """Return the geometry, interface and list of functions of every table, in its folder."""
        found: dict[str, Data] = {}
        for table in self.tables:
            found[inside(table, "_geometry.py")] = self.geometry(table)
            found[inside(table, INTERFACE)] = interface(self.words, table)
            functions = sorted((*table.public, *self.words.plain))
            found[inside(table, "_functions.pyi")] = {"class": CLASSES[table.name], "functions": functions}
        return found

    @abstractmethod
    def geometry(self, table: Table) -> Data:
        """Return the data for the template of a geometry."""

    @abstractmethod
    def programs(self, facts: Facts) -> Data:
        """Return the data for a chart's template, with its scalar programs."""

    def rotations(self, facts: Facts, lowered: Lowered) -> Data:
        """Return the data for a chart's template for rotations, besides its description."""
        return {}

    def module(self, facts: Facts) -> Data:
        return {**described(facts), **self.programs(facts)}

    def companions(self, facts: Facts) -> Mapping[str, tuple[str, Data]]:
        """Return the modules of the chart for further tables, which use scalar programs of the module for poses."""
        found = {}
        for table in self.tables[1:]:
            lowered = lower_chart(facts.chart, table)
            data = {**described_rotations(facts, lowered), **self.rotations(facts, lowered)}
            found[inside(table, f"{facts.chart.name}.py")] = (inside(table, "chart.py"), data)
        return found

    def require_complete(self, texts: Mapping[str, str]) -> None:
        for table in self.tables:
            require_complete(texts, self.words, table)

    def validate(self, folder: Path, chart: Chart, geometry: bool) -> int:
        return validate(folder, chart, geometry, self.tables)

    def replay(self, folder: Path, chart: Chart, geometry: bool) -> int:
        return replay(folder, chart, self.machinery, self.libraries(), self.tables, geometry=geometry)

    def libraries(self) -> Sequence[Library]:
        """Return the array libraries of a replay."""
        return (NUMPY,)

    def test(self, folder: Path, chart: Chart) -> int:
        return 0


def interface(words: Words, table: Table) -> Data:
    """Return the data for the template of a table's interface."""
    jacobian = (JACOBIAN if table is POSES else JACOBIAN.of_rotation).shape
    return asdict(words) | {
        "definitions": DEFINITIONS,
        "equations": {name: numbers(equations) for name, equations in EQUATIONS.items()},
        "rotations": table is not POSES,
        "up": ".." if table.name else ".",
        "n": jacobian[0],
        "jacobian": f"(..., {', '.join(map(str, jacobian))})",
    }


def described(facts: Facts) -> dict[str, Any]:
    """Return the constants and formulas of a chart for its module for poses."""
    chart = facts.chart
    return {
        "aliases": POSES.aliases(chart),
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
    }


def described_rotations(facts: Facts, lowered: Lowered) -> dict[str, Any]:
    """Return the constants of a chart for its module for rotations."""
    chart = facts.chart
    return {
        "aliases": lowered.table.aliases(chart),
        "name": chart.name,
        "order": chart.order,
        "title": chart.title,
        "parameter": chart.parameter,
        "branches": chart.branches,
        "singular": facts.singular,
    }


def printed_geometry(table: Table) -> list[Printed]:
    """Return the geometry programs of a table as plain functions; all that users call take ``m`` and ``c``."""
    return [
        Printed(name, _parameters(program, name in table.kernels), infix.body(program))
        for name, program in lowered_geometry(table).items()
        if name not in shared_with_poses(table)
    ]


def geometry(table: Table) -> Data:
    """Return the data for a geometry of plain functions; rotations import programs that equal programs of poses."""
    return {"programs": printed_geometry(table), "rows": table.kernels, "same": sorted(shared_with_poses(table))}


def _parameters(program: Program, kernel: bool) -> tuple[str, ...]:
    context = ("m: Any", "c: Any")[: 2 if kernel else len(program.context.split(", ")) if program.context else 0]
    numbers = (names == (argument,) for argument, names in program.inputs)
    given = (f"{argument}: {'Any' if n else 'Components'}" for n, (argument, _) in zip(numbers, program.inputs))
    return (*context, *given)


def printed_scalars(facts: Facts) -> dict[str, list[Printed]]:
    """Return the scalar programs of a chart as plain functions of numbers, and the helpers that they call."""
    helpers, programs = with_helpers(facts.lowered.scalars)
    called = Counter(call.function for program in programs.values() for call in program.calls)
    formulas = {name: f"# steps that {count} programs share" for name, count in called.items()}
    return {
        "helpers": [_printed(program, formulas[name]) for name, program in helpers.items()],
        "scalars": [_printed(program, formula_of(name, facts.chart)) for name, program in programs.items()],
    }


def _printed(program: Program, formula: str) -> Printed:
    parameters = tuple(name for _, names in program.inputs for name in names)
    body = infix.body(program, alone=True, ask=lambda call, passed: f"_{call.function}(m, {passed})")
    return Printed(program.name, parameters, body, formula)


def formula_of(scalar: str, chart: Chart) -> str:
    """Return the formula of a scalar program as a comment: for every chart, for order n, and equation numbers."""
    general, of_order, maps = FORMULAS[scalar]
    texts = [general, of_order] if of_order and chart.cayley else [general]
    equations = dict.fromkeys(number for name in maps for number in getattr(chart, name).equations)
    return comment([*texts[:-1], texts[-1] + (f"; CP23 {numbers(equations)}" if equations else "")], "#")


def require_complete(texts: Mapping[str, str], words: Words, table: Table = POSES) -> None:
    """Compare the methods of the interface and their parameters with a table.

    Raises
    ------
    ValueError
        If a function is missing, is in no row, has no docstring, or takes other parameters than its row says.
    """
    where = inside(table, INTERFACE)
    methods = {method.name: method for method in _methods(texts[where], CLASSES[table.name])}
    require_functions(where, [name for name in methods if name not in words.plain], table)
    for name, method in methods.items():
        if name in table.functions:
            _require_parameters(where, table.functions[name], method.args, words)
        if not ast.get_docstring(method):
            raise ValueError(f"{where}: {name} has no docstring")


def _require_parameters(where: str, row: Function, found: ast.arguments, words: Words) -> None:
    """Require the arguments of the table, then the keywords for one result or for several."""
    given = [argument.arg for argument in (*found.posonlyargs, *found.args)][1:]
    expected = [array.name for array in row.arguments] + ["branch"] * row.branch
    if given != expected:
        raise ValueError(f"{where}: {row.name} takes {', '.join(given)}, and {', '.join(expected)} in the table")
    keywords = [argument.arg for argument in found.kwonlyargs]
    wanted = [*(words.keywords if len(row.results) == 1 else ["axis"]), *row.keywords]
    if keywords != wanted:
        raise ValueError(f"{where}: keywords of {row.name} are {', '.join(keywords)}, not {', '.join(wanted)}")


def _methods(text: str, kernels: str) -> Iterator[ast.FunctionDef]:
    """Yield the public methods of a class."""
    for node in ast.parse(text).body:
        if isinstance(node, ast.ClassDef) and node.name == kernels:
            for item in node.body:
                if isinstance(item, ast.FunctionDef) and not item.name.startswith("_"):
                    yield item
