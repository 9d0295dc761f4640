"""Base class of the Python targets: one documented interface, with keyword parameters that differ by target."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ... import about
from ...maps.cayley import EQUATIONS
from ...maps.chart import Chart
from ...maps.chart_formulas import DEFINITIONS
from ...maps.named import NUMBERED, SINGLE
from ...proof import shown
from ..lowering.scalar_programs import SCALARS
from ..package import Data, Facts, Target, cited, comment
from ..programs.program import Program
from ..programs.shared import with_helpers
from ..rows import Function, Table, inside
from ..signatures import JACOBIAN, POSES, ROTATIONS, SIDES, printed_geometry, shared_with_poses
from ..validation import validate
from ..validation.calls import require_calls
from . import expression

if TYPE_CHECKING:
    from ..validation.replay import Library

INTERFACE = "_interface.py"
CLASSES = {POSES: "PoseKernels", ROTATIONS: "RotationKernels"}  # classes of the documented interfaces, by table


@dataclass(frozen=True, slots=True)
class PythonFunction:
    """Program for its template: parameters, text of the body, and its formula as a comment."""

    name: str
    parameters: tuple[str, ...]
    forms: str
    formula: str = ""


class PythonTarget(Target):
    """Target whose kernels are Python modules."""

    extension = "py"
    entry = "__init__.py"
    comment = "#"
    files: tuple[str, ...] = ("_branches.py", "_chart.py", "_checks.py", "_runtime.py", "_tools.py")
    """Files whose templates take no data."""
    tools: tuple[str, ...] = ()
    """Public modules that hold no chart, such as those that import further libraries."""
    options: str
    """Keyword parameters of functions that return one array, with types and defaults."""

    @property
    def keywords(self) -> dict[str, str]:
        """Types and defaults of the keyword parameters, as in ``int = -1``, by name."""
        return dict(option.split(": ") for option in self.options.split(", "))

    @property
    def plain(self) -> tuple[str, ...]:
        """Functions without a program of their own, so without a row in the table; makers of arrays need ``out``."""
        found = ("singular_angles", "switch")
        return (*found, "identity", "random") if "out" in self.keywords else found

    def shared(self) -> dict[str, Callable[[], Data]]:
        found: dict[str, Callable[[], Data]] = dict.fromkeys((*self.files, "__main__.py", "py.typed"), dict)
        for table in self.tables:
            functions = sorted((*table.public, *self.plain))
            found[inside(table, self.entry)] = partial(self.init, table)
            found[inside(table, "_geometry.py")] = partial(self.geometry, table)
            found[inside(table, INTERFACE)] = partial(self.interface, table)
            found[inside(table, "_functions.pyi")] = partial(dict, {"class": CLASSES[table], "functions": functions})
        return found

    def init(self, table: Table) -> Data:
        """Return the data for the entry file of a table's folder."""
        found: dict[str, Any] = {
            "option": "" if self.name == about.TARGET else f" --target {self.name}",
            "families": "|".join([*SINGLE, *(rf"{stem}[1-9]\d*" for stem in NUMBERED)]),
            "target": self.name,
            "uncompiled": self.plain if self.name == about.TARGET else (),  # not in ``dualcay-native``
            "parts": [] if table.name else [*(inner.name for inner in self.tables if inner.name), *self.tools],
            "package": table.name,
            "class": CLASSES[table],
        }
        return found if table.name else found | {"version": about.__version__}

    def geometry(self, table: Table) -> Data:
        """Return the data for a table's geometry; rotations import programs that equal programs of poses."""
        same = shared_with_poses(table)
        programs = [
            printed_program(program, kernel=name in table.kernels)
            for name, program in printed_geometry(table).items()
            if name not in same
        ]
        return {"programs": programs, "rows": table.kernels, "same": sorted(same)}

    def interface(self, table: Table) -> Data:
        jacobian = (JACOBIAN if table is POSES else JACOBIAN.of_rotation).shape
        names = {numbers: side for side, numbers in SIDES.items()}
        alone = [kind.partition(" = ")[2] for name, kind in self.keywords.items() if name != "axis"]
        return {
            "options": f"*, {self.options}",
            "passed": ", ".join(self.keywords),
            "passed_alone": ", ".join(["axis", *alone]),
            "placed": ", ".join(name for name in self.keywords if name != "parallel"),
            "makes": "out" in self.keywords,
            "definitions": DEFINITIONS,
            "equations": {name: cited(equations) for name, equations in EQUATIONS.items()},
            "tables": f"{', '.join(SIDES)} = {', '.join(map(repr, SIDES.values()))}".replace("'", '"'),
            "sides": {name: names[row.constants] for name, row in table.public.items() if row.constants},
            "rotations": table is not POSES,
            "up": ".." if table.name else ".",
            "n": jacobian[0],
            "jacobian": f"(..., {', '.join(map(str, jacobian))})",
        }

    def programs(self, facts: Facts) -> Data:
        """Return the data for a chart's template, with its scalar programs."""
        return printed_scalars(facts.chart, facts.lowered.poses.scalars)

    def rotations(self, facts: Facts) -> Data:
        """Return further data, beside `described`, for the template of a rotation module."""
        return {}

    def module(self, facts: Facts) -> Data:
        names = ("definitions", "domain", "singular_angles", "overflow", "largest", "turns", "returns")
        found = {name: getattr(facts, name) for name in names}
        return {**described(facts, POSES), **found, "ends": facts.chart.ends, **self.programs(facts)}

    def index(self, names: Collection[str]) -> Mapping[str, tuple[str, Data]]:
        parts = {table: self.init(table)["parts"] for table in self.tables}
        return {
            inside(table, "_modules.pyi"): ("python/_modules.pyi", {"names": sorted([*names, *parts[table]])})
            for table in self.tables
        }

    def companions(self, facts: Facts) -> Mapping[str, tuple[str, Data]]:
        """Return the module of the chart for rotations, which uses scalar programs of the module for poses."""
        data = {**described(facts, ROTATIONS), "name": facts.chart.name, **self.rotations(facts)}
        return {inside(ROTATIONS, f"{facts.chart.name}.py"): (inside(ROTATIONS, "chart.py"), data)}

    def validate(self, folder: Path, chart: Chart, geometry: bool) -> int:
        return validate(folder, chart, geometry, self.tables)

    def replay(self, folder: Path, chart: Chart, geometry: bool) -> int:
        from ..validation.replay import replay

        return replay(folder, chart, self.libraries(), self.tables, geometry=geometry)

    def libraries(self) -> Sequence[Library]:
        from ..validation.replay import NUMPY

        return (NUMPY,)

    def require_complete(self, texts: Mapping[str, str]) -> None:
        for table in self.tables:
            require_calls(table)
            self.require_interface(texts, table)

    def require_interface(self, texts: Mapping[str, str], table: Table = POSES) -> None:
        """Raise ValueError for a missing, further or undocumented function, or other parameters than in its row."""
        where = inside(table, INTERFACE)
        classes = (c for c in ast.parse(texts[where]).body if isinstance(c, ast.ClassDef) and c.name == CLASSES[table])
        found = (method for kernels in classes for method in kernels.body if isinstance(method, ast.FunctionDef))
        methods = {method.name: method for method in found if not method.name.startswith("_")}
        table.require_complete(where, methods.keys() - set(self.plain))
        for name, method in methods.items():
            if name in table.functions:
                self._require_parameters(where, table.functions[name], method.args)
            if not ast.get_docstring(method):
                raise ValueError(f"{where}: {name} has no docstring")

    def _require_parameters(self, where: str, row: Function, found: ast.arguments) -> None:
        """Require the arguments of the table, then the keywords for one result or for several."""
        given = [argument.arg for argument in (*found.posonlyargs, *found.args)][1:]
        expected = [array.name for array in row.arguments] + ["branch"] * row.branch
        if given != expected:
            raise ValueError(f"{where}: {row.name} takes {', '.join(given)}, and {', '.join(expected)} in the table")
        keywords = [argument.arg for argument in found.kwonlyargs]
        wanted = [*(self.keywords if len(row.results) == 1 else ["axis"]), *row.keywords]
        if keywords != wanted:
            raise ValueError(f"{where}: keywords of {row.name} are {', '.join(keywords)}, not {', '.join(wanted)}")


def described(facts: Facts, table: Table) -> Data:
    """Return the constants of a chart that its modules for poses and for rotations state."""
    names = ("title", "vector", "parameter", "branches", "order")
    found = {name: getattr(facts.chart, name) for name in names}
    return {**found, "aliases": table.aliases(facts.chart), "singular": facts.singular}


def printed_program(program: Program, kernel: bool = False) -> PythonFunction:
    """Return a geometry program as a plain function of numbers; every kernel takes ``m`` and ``c``."""
    context = "m, c" if kernel else program.context
    given = (f"{name}: {'Any' if parts == (name,) else 'Components'}" for name, parts in program.inputs)
    parameters = (*(f"{name}: Any" for name in context.split(", ") if name), *given)
    return PythonFunction(program.name, parameters, expression.body(program))


def printed_scalars(chart: Chart, scalars: Mapping[str, Program]) -> dict[str, list[PythonFunction]]:
    """Return scalar programs of a chart as plain functions of numbers, and the helpers that they call."""
    helpers, programs = with_helpers(scalars)
    called = Counter(call.function for program in programs.values() for call in program.calls)
    formulas = {name: f"# steps that {count} programs share" for name, count in called.items()}
    return {
        "helpers": [_printed(program, formulas[name]) for name, program in helpers.items()],
        "scalars": [_printed(program, formula_of(name, chart)) for name, program in programs.items()],
    }


def _printed(program: Program, formula: str) -> PythonFunction:
    parameters = tuple(part for _, parts in program.inputs for part in parts)
    body = expression.body(program, alone=True, ask=lambda call, passed: f"_{call.function}(m, {passed})")
    return PythonFunction(program.name, parameters, body, formula)


def formulas_of(scalar: str, chart: Chart) -> list[str]:
    """Return the formulas of a scalar program: for every chart, and for order n."""
    row = SCALARS[scalar]
    return [shown(row.every), *([shown(row.of_order, chart.cayley)] if row.of_order and chart.cayley else [])]


def formula_of(scalar: str, chart: Chart) -> str:
    """Return the formula of a scalar program as a comment, with equation numbers."""
    texts = formulas_of(scalar, chart)
    equations = dict.fromkeys(number for name in SCALARS[scalar].maps for number in getattr(chart, name).equations)
    return comment([*texts[:-1], texts[-1] + (f"; CP23 {cited(equations)}" if equations else "")], "#")
