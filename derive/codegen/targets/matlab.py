"""MATLAB and Octave: a package folder with a file for each function, whose arguments have a column for each case.

A file holds the public function, its program with all others written out, and the scalar programs that it calls.
"""

from __future__ import annotations

import itertools
import textwrap
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache, partial
from typing import Any

from ... import about
from ...maps.chart import Chart
from ..descriptions import sections
from ..lowering.scalar_programs import SCALARS
from ..package import Data, Facts
from ..programs.trace import written_out
from ..rows import Function, Table
from ..signatures import POSES, ROTATIONS, geometry
from ..validation.float_cases import FloatCase, cases, composed
from ..validation.straight_text import Grammar
from .c import GATE, copy_of
from .expression import INDENT, OPERATORS, WIDTH, Dialect, Operator
from .json import OWN, numbers_of, wiring
from .straight import Printed, Public, Step, Straight, broken, double, own, printed, public

WORDS = frozenset(("break", "case", "catch", "classdef", "continue", "else", "elseif", "end", "for", "function",
                   "global", "if", "otherwise", "parfor", "persistent", "return", "spmd", "switch", "try",
                   "while"))  # fmt: skip
FUNCTIONS = ("abs", "tan", "atan2", "expm1")
RESERVED = frozenset((*WORDS, *FUNCTIONS, *SCALARS, "dualcay", "out"))
CONTINUED = " ..."
"""Mark at the end of a line whose statement goes on."""
CALLS = {name: name for name in FUNCTIONS} | {
    name: f"dualcay.internal.{own}" for name, own in (("sqrt", "root"), ("log1p", "logarithm"), ("where", "select"))
}
DIALECT = Dialect(
    {name: Operator(f".{row.symbol}" if row.symbol in "*/" else row.symbol, row.strength, row.left, row.right)
     for name, row in OPERATORS.items()},
    CALLS, reciprocal=lambda integer: (f"1 / {integer}", OPERATORS["div"].strength),
)  # fmt: skip
GRAMMAR = Grammar(
    head=r"^function (?:out = (?=\w+_program)|\[?(?P<made>out\d[^=\]]*)\]? = )(?P<name>\w+)"
    r"\((?:\s*out, )?(?P<given>[^()]*)\)$",
    end="^end$",
    statements={
        "call": rf"\[?(?P<names>[^\]=]*)\]? = (?P<called>{'|'.join(SCALARS)})\((?P<given>.*)\)",
        "number": r"(?P<name>(?:limit|cos|sin)\d+) = (?P<value>-?[\d.]+(?:e[-+]?\d+)?)",
        "result": r"out\(?(?P<place>\d+)(?:, :\))? = (?P<value>.*)",
        "value": r"(?P<name>\w+) = (?P<value>.*)",
    },
    functions={text: {"where": "select"}.get(name, name) for name, text in CALLS.items()},
    program=lambda name: name.removesuffix("_program") if name.endswith("_program") else f"{OWN}{name}",
    continued=CONTINUED,
    first=1,
)
functions = cache(public)
TESTED = 2
"""Largest number of cases of a function in the test of a chart."""


def package_of(chart: str, table: Table) -> str:
    return ".".join(filter(None, ("dualcay", table.name, chart)))


def name_of(row: Function) -> str:
    """Return the name of a public function: an underscore follows a word of the language."""
    return f"{row.name}_" if row.name in WORDS else row.name


def statement(head: str, texts: Sequence[str], tail: str, indent: str = INDENT) -> str:
    return broken(head, texts, "", indent, CONTINUED).removesuffix(f"{CONTINUED}\n{indent}") + tail


def bracketed(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"[{', '.join(names)}]"


def step(one: Step) -> str:
    if not one.called:
        return statement(f"{one.names[0]} = ", [one.text], ";")
    made = bracketed(["~" if name == "_" else name for name in one.names])
    return statement(f"{made} = {one.called}(", one.arguments, ");")


def text_of(program: Printed, shared: bool) -> str:
    """Return the text of a program, whose arguments are rows of numbers.

    One that all charts share stores its results in the rows of an array, its first argument. A scalar program of a
    chart returns rows.
    """
    given = ["~" if name == "_" else name for name in program.components]
    made = [f"out({place}, :)" if shared else f"out{place}" for place in range(1, len(program.results) + 1)]
    stored = (statement(f"{name} = ", [text], ";") for name, text in zip(made, program.results, strict=True))
    numbers = (f"{INDENT}{name} = {double(text)};" for name, text in program.numbers.items())
    name = f"out = {program.name}_program" if shared else f"{bracketed(made)} = {program.name}"
    head = statement(f"function {name}(", [*["out"] * shared, *given], ")", "")
    return "\n".join([head, *numbers, *map(step, program.steps), *stored, "end"])


@cache
def program_of(table: Table, name: str) -> tuple[str, frozenset[str]]:
    """Return the text of a program for all charts, and the names of the scalar programs that it calls."""
    program = copy_of(table) if name == "copy" else geometry(table).get(name)
    program = program or written_out(table.composed[name].traced())
    return text_of(printed(program, DIALECT, RESERVED), True), frozenset(call.function for call in program.calls)


def function(f: Public, facts: Facts, scalars: Mapping[str, str]) -> Data:
    """Return the data of the file of a public function."""
    chart, given = facts.chart, [a.name for a in f.row.arguments]
    first = wiring(f.row, f.table, chart)["program"]
    turned = "" if chart.branches == 1 else f.way.then or f.way.instead
    found = [program_of(f.table, name) for name in (first, turned) if name]
    called = frozenset[str]().union(*(names for _, names in found))
    made = [a.name if a.name != f.row.name else "out" for a in f.row.results]
    starts = itertools.accumulate((a.size for a in f.row.results), initial=0)
    parts = [f"{name} = made({start + 1}{f':{start + a.size}' * (a.size > 1)}, :);"
             for name, a, start in zip(made, f.row.results, starts)] * (len(made) > 1)  # fmt: skip
    parameters = ", ".join([*given, *["branch"] * f.row.branch])
    whole = "made" if parts else made[0]
    rows = [f"{a.name}({place}, :)" for a in f.row.arguments for place in range(1, a.size + 1)]
    stored = [f"{whole}({place}, :)" for place in range(1, f.row.results[0].size + 1)]
    turn = ["turns(1, k + 1)", "turns(2, k + 1)"] if chart.branches else ["turns(1)", "k * turns(2)"]

    def call(program: str, texts: Sequence[str], indent: str = INDENT) -> str:
        kind = " + ".join(f"{argument}([])" for argument in given)  # single if one of them is
        array = f"zeros({sum(a.size for a in f.row.results)}, n, 'like', {kind})"
        return statement(f"{whole} = {program}_program(", [array, *texts], ");", indent)

    return {
        "head": f"function {bracketed(made)} = {name_of(f.row)}({parameters})",
        "help": "\n".join(f"%{line}" for line in help_of(f, chart.name, made, parameters)),
        "f": f,
        "parts": parts,
        "branches": chart.branches,
        "first": call(first, [*rows, *map(double, f.constants)]),
        "turned": turned and call(turned, [*(stored if f.way.then else rows), *turn], 2 * INDENT),
        "turns": "; ".join(", ".join(map(double, row)) for row in zip(*facts.turns, strict=True)),
        "texts": [text for text, _ in found] + [text for name, text in scalars.items() if name in called],
    }


def help_of(f: Public, chart: str, made: Sequence[str], parameters: str) -> Iterator[str]:
    """Yield the lines of the help text of a public function."""
    name, package = name_of(f.row), package_of(chart, f.table)
    first, _, rest = " ".join(f.lines).partition(". ")
    yield from _wrapped(f"{name.upper()}  {first.rstrip('.')}.", "", "  ")
    yield from _wrapped(rest, "  ", "  ")
    yield from ("", f"  {bracketed(made)} = {package}.{name}({parameters})", "")
    arrays = zip([*(a.name for a in f.row.arguments), *made], [*f.row.arguments, *f.row.results], strict=True)
    for array, row in arrays:
        yield from _wrapped(f"{array}, {row.size} x N: {f.about(row)}", "  ")
    if f.row.branch:
        yield "  branch: integer, 0 if left out; taken modulo the number of branches"
    yield from ("", "  Each column is a case. An argument of one column goes with others of N columns.", "")
    near = next(one.functions for one in sections(f.table) if f.row.name in one.functions)
    others = ", ".join(f"{package}.{other}" for other in near if other not in (f.row.name, *WORDS))
    yield from _wrapped(f"See also {others}.", "  ", "  ")


def _wrapped(text: str, indent: str, further: str = "      ") -> list[str]:
    return textwrap.wrap(text, WIDTH - 1, initial_indent=indent, subsequent_indent=further, break_on_hyphens=False)


def tested(found: Sequence[FloatCase]) -> Iterator[Data]:
    """Yield calls of a function for its test: cases of equal branches, as columns, with their results and scales."""
    chosen = found[:: len(found) // -TESTED]  # the last ones have other branches
    part_of: list[int] = []
    for array in found[0].row.results:
        part_of += [max(part_of, default=0) + 1 + part for part in array.part_of]
    for branch, group in itertools.groupby(sorted(chosen, key=branch_of), branch_of):
        some = list(group)
        arguments = [_columns([case.arguments[i] for case in some]) for i in range(len(some[0].arguments))]
        yield {
            "name": name_of(some[0].row),
            "arguments": [*arguments, *[str(branch)] * some[0].row.branch],
            "made": [f"made{place}" for place in range(1, len(some[0].row.results) + 1)],
            "expected": _columns([case.result for case in some]),
            "scales": _columns([case.scales for case in some]),
            "part_of": ", ".join(map(str, part_of)),
        }


def branch_of(case: FloatCase) -> int:
    return case.branch or 0


def _columns(rows: Sequence[Sequence[Any]]) -> str:
    lines = (", ".join(repr(float(number)) for number in row) for row in rows)
    return f"[{f'{CONTINUED}{chr(10)}{3 * INDENT}'.join(f'{line};' for line in lines)}]'"


class Matlab(Straight):
    """Target of packages of MATLAB and Octave."""

    name = "matlab"
    extension = "m"
    entry = "+dualcay/+internal/cases.m"
    comment = "%"
    words = WORDS
    dialect = DIALECT
    reserved = RESERVED
    grammar = GRAMMAR

    def texts(self, chart: Chart, table: Table) -> Sequence[str]:
        return [self.file(chart.name, table, name_of(f.row)) for f in functions(table)]

    def file(self, chart: str, table: Table = POSES, function: str = "Contents") -> str:
        return "/".join([*(f"+{part}" for part in package_of(chart, table).split(".")), f"{function}.m"])

    def shared(self) -> Mapping[str, Callable[[], Data]]:
        names = ("cases", "branch_of", "compare", "logarithm", "root", "select")
        helpers: Mapping[str, Callable[[], Data]] = {f"+dualcay/+internal/{name}.m": dict for name in names}
        return {**helpers, "Contents.m": partial(dict, version=about.__version__)}

    def module(self, facts: Facts) -> Data:
        return contents(facts, POSES)

    def companions(self, facts: Facts) -> dict[str, tuple[str, Data]]:
        name, numbers = facts.chart.name, numbers_of(facts.chart)
        scalars = {program.name: text_of(self.printed(program, numbers), False)
                   for program in own(facts, self.tables).values()}  # fmt: skip
        files = {self.file(name, ROTATIONS): ("chart.m", contents(facts, ROTATIONS))}
        for table in self.tables:
            package = {"package": package_of(name, table)}
            angles = {**package, "angles": ", ".join(facts.singular_angles)}
            files[self.file(name, table, "singular_angles")] = "singular_angles.m", angles
            for f in functions(table):
                files[self.file(name, table, name_of(f.row))] = "function.m", function(f, facts, scalars)
            for alias, of in table.aliases(facts.chart).items():
                files[self.file(name, table, alias)] = "alias.m", {**package, "alias": alias, "name": of}
        return files

    def tests(self, facts: Facts) -> dict[str, tuple[str, Data]]:
        found: dict[str, tuple[str, Data]] = {}
        for table in self.tables:
            every = (*cases(facts.chart, table), *composed(facts.chart, table))
            groups = (list(group) for _, group in itertools.groupby(every, lambda case: case.function))
            data = {"package": package_of(facts.chart.name, table), "gate": GATE,
                    "calls": list(itertools.chain(*map(tested, groups)))}  # fmt: skip
            found[self.file(facts.chart.name, table, "test")] = "test.m", data
        return found


def contents(facts: Facts, table: Table) -> Data:
    """Return the data of the list of a chart's functions: their names with the first sentence about each."""
    chart = facts.chart
    listed = [(name_of(f.row), " ".join(f.lines).split(". ")[0].split(": ")[0].rstrip(".")) for f in functions(table)]
    listed += [(alias, f"Another name of {name}") for alias, name in table.aliases(chart).items()]
    listed += [("singular_angles", "Rotation angles (rad) where the chart or its operators are singular"),
               ("test", "Compare the functions with exact results")]  # fmt: skip
    return {"name": chart.name, "title": chart.title, "kind": "poses" if table is POSES else "rotations alone",
            "order": chart.order, "branches": chart.branches, "domain": facts.domain, "singular": facts.singular,
            "functions": listed}  # fmt: skip
