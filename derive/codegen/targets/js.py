"""JavaScript: ES modules whose programs take numbers and write into an array, with types for TypeScript."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from functools import partial

from ... import about
from ...maps.chart import Chart
from ..lowering.scalar_programs import SCALARS
from ..package import Data, Facts
from ..rows import Array, Table, inside
from ..signatures import POSES, ROTATIONS
from ..validation.straight_text import Grammar
from .c import copy_of, programs
from .c99 import OPERATORS
from .expression import INDENT, Dialect, Text, items
from .json import OWN, numbers_of
from .straight import Printed, Public, Step, Straight, broken, called, double, own, public

WORDS = frozenset((
    "arguments", "await", "break", "case", "catch", "class", "const", "continue", "debugger", "default", "delete", "do",
    "else", "enum", "eval", "export", "extends", "false", "finally", "for", "function", "if", "implements", "import",
    "in", "instanceof", "interface", "let", "new", "null", "package", "private", "protected", "public", "return",
    "static", "super", "switch", "this", "throw", "true", "try", "typeof", "var", "void", "while", "with", "yield",
))  # fmt: skip
"""Words of the language, which are no names of variables."""
TAKEN = frozenset(("c", "out", "work"))
"""Names in every program: the chart, the array of the results, and the array for results of other programs."""
FUNCTIONS = ("abs", "sqrt", "tan", "atan2", "expm1", "log1p")
BODY = 2 * INDENT


def reciprocal(integer: int) -> Text:
    return f"1 / {integer}", OPERATORS["div"].strength


DIALECT = Dialect(OPERATORS, {name: f"Math.{name}" for name in FUNCTIONS}, 2.0**53, reciprocal=reciprocal)
"""Dialect of JavaScript: a truth value is 0 or 1 once it was in an array."""


def program(text: str) -> str:
    """Return the name of a program in listings, by the text of its head or of a call."""
    name = re.split(r"[ .]", text)[-1].rstrip("_")
    return f"{OWN}{name}" if text.startswith(("c.", INDENT)) else name


GRAMMAR = Grammar(
    head=r"^(?: +(?=function))?(?P<name>(?:    |function )(?!turn\(k)\w+)\((?P<given>[^()]*?),?\s*out\s*\) \{",
    end=r"^    \}",
    statements={
        "read": r"const (?P<names>\w+ = work\[\d+\].*)",
        "number": r"const (?P<name>\w+) = (?P<value>-?\d[\d.]*(?:e-?\d+)?)",
        "value": r"const (?P<name>\w+) = (?P<value>.*)",
        "result": r"out\[(?P<place>\d+)\] = (?P<value>.*)",
        "call": r"(?P<called>(?:c\.)?\w+)\((?P<given>.*),\s*work\s*\)",
    },
    functions={f"Math.{name}": name for name in FUNCTIONS},
    program=program,
)


def step(one: Step) -> str:
    """Return a statement; a call is followed by one that reads its results."""
    if not one.called:
        return broken(f"const {one.names[0]} = ", [one.text], ";", BODY)
    call = broken(f"{'c.' * one.of_chart}{one.called}(", [*one.arguments, "work"], ");", BODY)
    read = [f"{name} = work[{place}]" for place, name in enumerate(one.names) if name != "_"]
    return "\n".join([call, *([broken("const ", read, ";", BODY)] if read else [])])


def function(program: Printed, word: str = "") -> Data:
    """Return the text of a program, with a word before its name, and without its last line."""
    given = [f"_{place}" if name == "_" else name for place, name in enumerate(program.components)]
    numbers = [f"{BODY}const {name} = {double(text)};" for name, text in program.numbers.items()]
    results = [broken(f"out[{place}] = ", [text], ";", BODY) for place, text in enumerate(program.results)]
    head = broken(f"{word}{variable(program.name)}(", [*given, "out"], ") {", INDENT)
    return {"text": "\n".join([head, *numbers, *map(step, program.steps), *results])}


def public_function(f: Public) -> Data:
    """Return the texts of a public function: its parameters, what its programs take, and where its results lie."""
    given, made, branch = f.row.arguments, f.row.results, ["branch"] * f.row.branch
    parts = [f"{a.name}[{place}]" if a.size > 1 else a.name for a in given for place in range(a.size)]
    results = [f"work[{place}]" for place in range(sum(a.size for a in made))]
    passed, turn = [*parts, *f.constants], ["turned[0]", "turned[1]"]
    number = len(made) == 1 and made[0].size == 1
    room = [f"new Float64Array({a.size})" if a.size > 1 else "0" for a in made]
    new = room[0] if len(made) == 1 else f"[{', '.join(room)}]"
    out = [] if number else [f"out = {new}"]
    return {
        "name": f.row.name,
        "parameters": ", ".join([*(a.name for a in given), *(f"{each} = 0" for each in branch), *out]),
        "run": run(f.way.program, parts, BODY * 2) if f.way.instead else run(f.way.program, passed, BODY + INDENT),
        "then": run(f.way.then, [*results, *turn], BODY * 2),
        "instead": run(f.way.instead, [*passed, *turn], BODY * 2),
        "sizes": [a.size for a in made],
        "number": number,
        "typed": ", ".join([*(f"{a.name}: {'Numbers' if a.size > 1 else 'number'}" for a in given),
                            *(f"{each}?: number" for each in branch), *["out?: Made"] * bool(out)]),
        "made": _type(made),
        "default": _type(made, "Float64Array"),
        "variable": variable(f.row.name),
    }  # fmt: skip


def run(program: str, passed: Sequence[str], indent: str) -> str:
    """Return the call of a program by a public function."""
    return broken(f"{variable(program)}(", [*passed, "work"], ");", indent)


def _type(made: Sequence[Array], array: str = "Out") -> str:
    types = [array if a.size > 1 else "number" for a in made]
    return types[0] if len(made) == 1 else f"[{', '.join(f'{a.name}: {each}' for a, each in zip(made, types))}]"


def variable(name: str) -> str:
    """Return a name for a variable of a function, which may have a word of the language as its name."""
    return f"{name}_" if name in WORDS else name


class Js(Straight):
    """Target of ES modules."""

    name = "js"
    extension = "js"
    entry = "arrays.js"
    comment = "//"
    dialect = DIALECT
    reserved = WORDS | TAKEN
    grammar = GRAMMAR

    def texts(self, chart: Chart, table: Table) -> Sequence[str]:
        return f"{chart.name}.js", inside(table, "geometry.js")

    def shared(self) -> Mapping[str, Callable[[], Data]]:
        files: dict[str, Callable[[], Data]] = {"package.json": partial(dict, version=about.__version__)}
        files |= {"arrays.js": dict, "arrays.d.ts": dict}
        for table in self.tables:
            files[inside(table, "geometry.js")] = partial(self.geometry, table)
            files[inside(table, "functions.d.ts")] = partial(typed, table)
        return files

    def geometry(self, table: Table) -> Data:
        printed = [self.printed(program) for program in (*programs(table).values(), copy_of(table))]
        largest = max(len(SCALARS[name].results) for name in called(self.tables))
        return {
            "programs": [function(program, "function ") for program in printed],
            **typed(table),
            "size": max(largest, *(len(program.results) for program in printed)),
        }

    def module(self, facts: Facts) -> Data:
        chart, numbers = facts.chart, numbers_of(facts.chart)
        scalars = [function(self.printed(program, numbers)) for program in own(facts, self.tables).values()]
        return {
            **named(facts, POSES),
            "order": chart.order,
            "branches": chart.branches,
            "ends": chart.ends,
            "turns": [tuple(map(double, pair)) for pair in facts.turns],
            "angles": [angle.replace("pi", "Math.PI") for angle in facts.singular_angles],
            "scalars": scalars,
            "domain": facts.domain,
            "singular": facts.singular,
        }

    def companions(self, facts: Facts) -> dict[str, tuple[str, Data]]:
        chart = facts.chart
        types = {"name": chart.name, "order": chart.order, "aliases": POSES.aliases(chart)}
        rotations = {"name": chart.name, "aliases": ROTATIONS.aliases(chart)}
        return {
            f"{chart.name}.d.ts": ("chart.d.ts", types),
            inside(ROTATIONS, f"{chart.name}.js"): (inside(ROTATIONS, "chart.js"), named(facts, ROTATIONS)),
            inside(ROTATIONS, f"{chart.name}.d.ts"): (inside(ROTATIONS, "chart.d.ts"), rotations),
        }


def named(facts: Facts, table: Table) -> Data:
    """Return the name of a chart, the variables of its functions, and their exports."""
    names = [f.row.name for f in public(table)]
    variables = [name if variable(name) == name else f"{name}: {variable(name)}" for name in names]
    exports = [name if variable(name) == name else f"{variable(name)} as {name}" for name in names]
    exports += [f"{name} as {alias}" for alias, name in table.aliases(facts.chart).items()]
    return {"name": facts.chart.name, "variables": items(variables, INDENT), "exports": items(exports, INDENT)}


def home(table: Table) -> str:
    return "../" if table.name else "./"


def typed(table: Table) -> Data:
    return {"functions": [(f, public_function(f)) for f in public(table)], "home": home(table)}
