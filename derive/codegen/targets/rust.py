"""Rust: a crate without allocation, whose programs are generic over the real type and the chart."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping, Sequence
from functools import partial

from ... import about
from ...maps.chart import Chart
from ..lowering.scalar_programs import SCALARS
from ..package import Data, Facts
from ..rows import Table, inside
from ..signatures import POSES, ROTATIONS, TABLE
from ..validation.straight_text import Grammar
from .c import copy_of, programs
from .expression import INDENT, OPERATORS, WIDTH, Dialect, Text
from .json import OWN, numbers_of
from .straight import (
    Printed,
    Public,
    Step,
    Straight,
    broken,
    called,
    double,
    own,
    public,
    single,
)

PI = "3.14159265358979323846264338327950288419716939937510582097494"
WORDS = frozenset((
    "Self", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do", "dyn",
    "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match",
    "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "self", "static", "std", "struct", "super",
    "trait", "true", "try", "type", "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
))  # fmt: skip
"""Words of the language, and the name of its library: neither variables nor modules have them."""
FUNCTIONS = {"abs": "abs", "sqrt": "sqrt", "tan": "tan", "atan2": "atan2", "expm1": "exp_m1", "log1p": "ln_1p"}
"""Methods of the real type."""


def number(decimal: str) -> str:
    return f"T::number({double(decimal)}, {single(decimal)})"


def literal(integer: int) -> str:
    return f"T::of({integer})"


def reciprocal(integer: int) -> Text:
    return f"T::of(1) / {number(str(integer))}", OPERATORS["div"].strength


DIALECT = Dialect(
    OPERATORS, {name: f"T::{method}" for name, method in FUNCTIONS.items()} | {"where": "select"},
    literal=literal, reciprocal=reciprocal,
)  # fmt: skip


def program(text: str) -> str:
    """Return the name of a program in listings, by the text of its head or of a call."""
    name = text.split("::<")[0].split("::")[-1].split()[-1]
    return f"{OWN}{name}" if text.startswith(("C::", "fn ")) else name


TRUTHS = {literal(0): "false", literal(1): "true"}
GRAMMAR = Grammar(
    head=r"^ *(?P<name>(?:pub\(crate\) )?fn (?!stayed|returned)\w+)(?:<C: Chart<T>, T: Real>)?"
    r"\((?!k: i32)(?P<given>[^()]*)\) -> [^{]*\{",
    end=r"^ *\}",
    statements={
        "unpacked": r"let \[(?P<names>[^\]]*)\] = (?P<whole>\w+)",
        "call": r"let [\[(]?(?P<names>[^\])=]*)[\])]? = (?P<called>C::\w+|\w+::<C, T>)\((?P<given>.*)\)",
        "number": r"let (?P<name>\w+) = T::number\((?P<value>[^,]*), [^,]*\)",
        "value": r"let (?P<name>\w+) = (?P<value>.*)",
        "result": r"\[?(?P<value>.*?)\]?",
    },
    functions={"select": "select", "T::of": "number", "T::number": "number"}
    | {f"T::{method}": name for name, method in FUNCTIONS.items()},
    program=program,
    made=r"\w+: \[T; (\d+)\]",
)


def around(texts: Sequence[str]) -> tuple[str, Sequence[str], str]:
    """Return texts with brackets around several of them, a tuple."""
    return ("", texts, "") if len(texts) == 1 else ("(", texts, ")")


def tupled(texts: Sequence[str]) -> str:
    before, _, after = around(texts)
    return f"{before}{', '.join(texts)}{after}"


def array(size: int) -> str:
    return "T" if size == 1 else f"[T; {size}]"


def step(one: Step) -> str:
    """Return a statement."""
    if not one.called:
        return broken(f"let {one.names[0]} = ", [one.text], ";", INDENT)
    groups = [text if isinstance(text, str) else f"[{', '.join(text)}]" for text in one.groups]
    if one.of_chart:
        return broken(f"let {tupled(one.names)} = C::{one.called}(", groups, ");", INDENT)
    if len(made := f"let [{', '.join(one.names)}] = {one.called}::<C, T>(") <= WIDTH // 2:
        return broken(made, groups, ");", INDENT)
    return broken("let [", one.names, "] =", INDENT) + "\n" + broken(f"{one.called}::<C, T>(", groups, ");", 2 * INDENT)


def shared_function(program: Printed) -> Data:
    """Return the data of a program that all charts share: it takes and returns arrays."""
    given = [
        f"{argument}: {'T' if names == (argument,) else f'[T; {len(names)}]'}" for argument, names in program.given
    ]
    loads = [broken("let [", names, f"] = {argument};", INDENT) for argument, names in program.given
             if names != (argument,) and set(names) != {"_"}]  # fmt: skip
    lines = [*loads, *map(step, program.steps), broken("[", program.results, "]", INDENT)]
    made = f") -> [T; {len(program.results)}] {{"
    head = broken(f"pub(crate) fn {program.name}<C: Chart<T>, T: Real>(", given, made, "")
    return {"head": head, "text": "\n".join(lines)}


def chart_function(program: Printed) -> Data:
    """Return the data of a scalar program of a chart: it takes numbers and returns a tuple."""
    numbers = [f"    let {name} = {number(text)};" for name, text in program.numbers.items()]
    results = [TRUTHS.get(text, text) if truth else text for text, truth in zip(program.results, program.truths)]
    lines = [*numbers, *map(step, program.steps), broken(*around(results), INDENT)]
    return {"head": signature(program.name, program.components, program.truths), "text": "\n".join(lines)}


def signature(name: str, given: Sequence[str], truths: Sequence[bool]) -> str:
    types = tupled(["bool" if truth else "T" for truth in truths])
    return f"fn {name}({', '.join(f'{each}: T' for each in given)}) -> {types}"


def declaration(name: str) -> Data:
    """Return the declaration of a scalar program that every chart has, with its formula."""
    row = SCALARS[name]
    head = signature(name, [argument for argument in row.arguments if argument != TABLE],
                     [result in row.truths for result in row.results])  # fmt: skip
    return {"head": head, "about": f"{tupled(row.results)}: {row.every.replace('`', '')}"}


def public_function(f: Public) -> Data:
    """Return the texts of a public function: parameters of both forms, arguments of its program, and its results."""
    given, made, branch = f.row.arguments, f.row.results, ["branch: i32"] * f.row.branch
    starts = itertools.accumulate((a.size for a in made), initial=0)
    alone, zipped, each = len(made) == 1, given[0].name, given[0].name
    for a in (*given[1:], *made):
        zipped, each = f"{zipped}.zip({a.name})", f"({each}, {a.name})"
    return {
        "name": f.row.name,
        "plain": ", ".join([*(f"{a.name}: {'&' * (a.size > 1)}{array(a.size)}" for a in given), *branch]),
        "result": tupled([array(a.size) for a in made]),
        "passed": [*(f"*{a.name}" if a.size > 1 else f"[{a.name}]" for a in given),
                   *[f"[{', '.join(map(number, f.constants))}]"] * bool(f.constants)],
        "parts": tupled([f"made[{start}]" if a.size == 1 else "made" if alone else part(start)
                         for start, a in zip(starts, made)]),
        "rows": ", ".join([*(f"{a.name}: &[{array(a.size)}]" for a in given), *branch,
                           *(f"{a.name}: &mut [{array(a.size)}]" for a in made)]),
        "each": each,
        "zipped": zipped.replace(given[0].name, f"{given[0].name}.iter()", 1),
        "stored": tupled([f"*{a.name}" for a in made]),
        "again": ", ".join([*("*" * (a.size == 1) + a.name for a in given), *["branch"] * f.row.branch]),
    }  # fmt: skip


def part(start: int) -> str:
    return f"core::array::from_fn(|i| made[{start} + i])" if start else "core::array::from_fn(|i| made[i])"


def angle(text: str) -> str:
    """Return a multiple of pi, or another angle, in the real type."""
    if "." in text:
        return number(text)
    words = {"*": "*", "/": "/", "pi": number(PI)}
    return " ".join(words.get(word) or literal(int(word)) for word in text.split())


class Rust(Straight):
    """Target of Rust crates."""

    name = "rust"
    extension = "rs"
    entry = "lib.rs"
    comment = "//"
    dialect = DIALECT
    words = WORDS
    reserved = WORDS
    grammar = GRAMMAR

    def texts(self, chart: Chart, table: Table) -> Sequence[str]:
        return f"{chart.name}.rs", inside(table, "geometry.rs")

    def shared(self) -> Mapping[str, Callable[[], Data]]:
        geometry = {inside(table, "geometry.rs"): partial(self.geometry, table) for table in self.tables}
        scalars: Callable[[], Data] = partial(dict, scalars=list(map(declaration, called(self.tables))))
        return {"lib.rs": dict, "Cargo.toml": partial(dict, version=about.__version__), "build.rs": dict,
                "real.rs": dict, "scalars.rs": scalars, **geometry}  # fmt: skip

    def geometry(self, table: Table) -> Data:
        (v,) = table.sources["shadow"].arguments
        found = *programs(table).values(), copy_of(table)
        return {"programs": [shared_function(self.printed(program)) for program in found],
                "functions": [(f, public_function(f)) for f in public(table)], "size": v.size}  # fmt: skip

    def module(self, facts: Facts) -> Data:
        chart, numbers = facts.chart, numbers_of(facts.chart)
        return {
            "name": chart.name,
            "order": chart.order,
            "branches": chart.branches,
            "ends": chart.ends,
            "turns": [tuple(map(number, pair)) for pair in facts.turns],
            "angles": list(map(angle, facts.singular_angles)),
            "scalars": [chart_function(self.printed(program, numbers)) for program in own(facts, self.tables).values()],
            "aliases": POSES.aliases(chart),
            "domain": facts.domain,
            "singular": facts.singular,
        }

    def companions(self, facts: Facts) -> dict[str, tuple[str, Data]]:
        name = facts.chart.name
        data = {"name": name, "aliases": ROTATIONS.aliases(facts.chart)}
        return {inside(ROTATIONS, f"{name}.rs"): (inside(ROTATIONS, "chart.rs"), data)}
