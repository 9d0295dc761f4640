"""Texts of a package of kernels, and the data of a chart for its templates."""

from __future__ import annotations

import hashlib
import itertools
import sys
import textwrap
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any, Protocol

import mpmath
import sympy

from .. import about
from ..maps import Formula
from ..maps.chart import Chart
from ..output import generated, render, source
from ..proof import Proved, theorems
from .programs.program import Call, Program
from .rows import Table, inside
from .signatures import POSES, ROTATIONS, ChartPrograms, Lowered, geometry

PRINTED_DIGITS = 60  # decimal digits of printed constants: enough for C++ classes of 50 digits
WIDTH = 110  # largest number of characters in a comment line
LETTERS_MAX = 600
"""Largest total length of the polynomials in a header; longer ones are replaced by the command that shows them."""

LICENCE = "SPDX-License-Identifier: BSD-3-Clause"

HASH_COMMENTS = (".txt", ".cmake", ".py", ".pyi", ".toml", ".build", ".options")
"""Suffixes of files whose comments begin with # in every target."""


@dataclass(frozen=True, slots=True)
class Counts:
    """Numbers of calls that agree with the formulas: exact, on floats, and in compiled code (None: no compiler)."""

    validated: int = 0
    replayed: int = 0
    tested: int | None = 0


@dataclass(frozen=True, slots=True)
class Module:
    """Proved and printed chart."""

    name: str  # file of the module for poses; other files are companions, such as the module for rotations
    proved: Proved
    texts: Mapping[str, str] = field(hash=False)  # files by name
    counts: Counts = Counts()  # calls that agree with its formulas

    @property
    def text(self) -> str:
        return self.texts[self.name]

    def __repr__(self) -> str:
        return f"<Module {self.name}: {len(self.proved.proofs)} proofs, {self.counts.validated} calls validated>"


@dataclass(frozen=True, slots=True)
class Package:
    """Package of kernels: the files that all its modules share, by name, and the modules."""

    shared: Mapping[str, str] = field(hash=False)
    modules: tuple[Module, ...]

    @property
    def texts(self) -> dict[str, str]:
        return {name: text for texts in (self.shared, *(m.texts for m in self.modules)) for name, text in texts.items()}

    def __repr__(self) -> str:
        return f"<Package of {', '.join(module.name for module in self.modules)}: {len(self.texts)} files>"


@dataclass(frozen=True)
class Facts:
    """Lowered chart, with the texts that templates use."""

    lowered: Lowered

    @property
    def chart(self) -> Chart:
        return self.lowered.chart

    @property
    def turns(self) -> list[tuple[str, str]]:
        return turns(self.chart)

    @property
    def returns(self) -> list[tuple[str, ...]]:
        return returns(self.chart)

    @property
    def singular_angles(self) -> list[str]:
        return [_multiple_of_pi(angle) for angle in self.chart.singular_angles]

    @property
    def maps(self) -> tuple[Formula, ...]:
        return self.chart.quaternion, self.chart.tensor, self.chart.tangent, self.chart.tangent_inv

    @property
    def definitions(self) -> dict[str, str]:
        """Formulas of the maps in LaTeX, wrapped into indented lines."""
        texts = {f.name: f"{f.symbol} = {f.definition}" for f in self.maps}
        return {n: "\n    ".join(textwrap.wrap(t, WIDTH, break_long_words=False)) for n, t in texts.items()}

    @property
    def domain(self) -> dict[str, str]:
        return {f.name: f.domain for f in self.maps}

    @property
    def singular(self) -> dict[str, str]:
        return {f.name: f.singular for f in self.maps}

    @property
    def overflow(self) -> str:
        """Reason why forward maps are NaN for large v."""
        return self.chart.overflow(1)[0]

    @property
    def largest(self) -> dict[str, str]:
        """Largest Re|v| with finite forward maps, by dtype."""
        most = {"float32": (2 - 2.0**-23) * 2.0**127, "float64": sys.float_info.max}
        return {name: f"{self.chart.overflow(value)[1]:.1g}" for name, value in most.items()}

    def header(self, command: str, template: str) -> list[str]:
        """Return the header lines: command, licence, template, φ, polynomials, and the number of proofs."""
        chart = self.chart
        letters = ((letter, sympy.sstr(value, order="rev-lex")) for letter, value in chart.letters)
        polynomials = [f"  {letter} = {value.replace('**', '^')}" for letter, value in letters]
        if sum(map(len, polynomials)) > LETTERS_MAX:
            polynomials = [f"  p, q: dualcay show {' '.join(chart.selection)} --what p,q"]
        proofs = self.lowered.proved.proofs
        shared = sum(proof in theorems() for proof in proofs)
        own, general = len(proofs) - shared, f" and {shared} theorems for every n" if shared else ""
        proved = f"Proved exactly: {own} identities of this chart{general}, listed in docs/theorems.md."
        title = f"{chart.title}, v = {chart.parameter.replace('α', 'alpha')} u"
        return [*head(command, template), "", title, *polynomials, proved]


@cache
def turns(chart: Chart) -> list[tuple[str, str]]:
    """Return decimals of the two numbers that turn v to each branch; for an unbounded chart, to branch 1 only."""
    with mpmath.workdps(PRINTED_DIGITS + 10):
        return [(_decimal(a), _decimal(b)) for a, b in map(chart.turn, range(chart.branches) or [1])]


@cache
def returns(chart: Chart) -> list[tuple[str, ...]]:
    """Return decimals of the table of returns, row by row."""
    with mpmath.workdps(PRINTED_DIGITS + 10):
        return [tuple(map(_decimal, row)) for row in chart.returns()]


def command(target: str, *charts: Chart) -> str:
    """Return the command that writes the modules of charts; without charts, the command for shared files."""
    chosen = [chart.selection for chart in charts]
    values = {option: ",".join(value for other, value in chosen if other == option) for option, _ in chosen}
    options = "".join(f" {option} {value}" for option, value in values.items())
    largest = max((chart.order for chart in charts), default=0)
    cap = f" --max-n {largest}" if largest > about.MAX_ORDER else ""
    return f"python -m derive generate{options} --target {target}{cap}"


def head(command: str, template: str) -> list[str]:
    """Return the first lines of a generated file: its command, its licence, its template."""
    return [command, LICENCE, f"Generated by the command above from templates/{template}: change that, not this file."]


def comment(lines: Iterable[str], mark: str) -> str:
    """Return lines as comment lines, with long ones wrapped and indented."""
    indents = ((line, " " * (len(line) - len(line.lstrip()) + 4)) for line in lines)
    wrapped = (textwrap.wrap(line, WIDTH, subsequent_indent=indent) or [""] for line, indent in indents)
    return "\n".join(f"{mark} {line}".rstrip() for line in itertools.chain(*wrapped))


def _header(lines: Sequence[str], mark: str) -> str:
    """Return a header as comment lines. The command stays on one line, however long, as it is read from there."""
    return f"{mark} {lines[0]}\n{comment(lines[1:], mark)}"


def cited(equations: Iterable[int]) -> str:
    """Return equation numbers in brackets, separated by commas."""
    return ", ".join(f"({number})" for number in equations)


def _decimal(value: Any) -> str:
    return str(mpmath.nstr(value, PRINTED_DIGITS, min_fixed=-PRINTED_DIGITS))


def _multiple_of_pi(angle: sympy.Expr) -> str:
    factor = angle / sympy.pi
    if not factor.is_Rational:
        with mpmath.workdps(PRINTED_DIGITS + 10):
            return _decimal(mpmath.mpf(angle.evalf(PRINTED_DIGITS + 10)))
    above = "pi" if factor.p == 1 else f"{factor.p} * pi"
    return above if factor.q == 1 else f"{above} / {factor.q}"  # 3/2 would be 1 in C


def fingerprint(facts: Facts, programs: ChartPrograms) -> str:
    """Return a digest of a chart's programs and the geometry: packages with equal digests compute equal results."""
    shared = _shared_lines(programs.table)
    lines = [*shared[0], *_program_lines(programs.scalars), *shared[1], f"{facts.turns} {facts.returns}"]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:16]


@cache
def _shared_lines(table: Table) -> tuple[Sequence[str], Sequence[str]]:
    """Return the lines of the geometry programs and of the table, which all charts share."""
    rows = [f"{row.name} {row.arguments} {row.results} {row.constants}" for row in table.kernels.values()]
    return list(_program_lines(geometry(table))), rows


def _program_lines(programs: Mapping[str, Program]) -> Iterator[str]:
    for name, program in programs.items():
        yield f"{name} {program.inputs} -> {program.outputs}"
        for s in program.statements:
            if isinstance(s, Call):
                yield f"{s.names} {s.function} {s.args} {s.rest} {sorted(s.truths)}"  # sets have no order
            else:
                yield f"{s.name} {s.op} {s.args}"


Data = Mapping[str, Any]  # values for the names in a template, except ``header``


class Target(Protocol):
    """Language in which kernels are printed: its files and texts, and the execution of printed text."""

    name: str  # also of the template folder
    extension: str
    entry: str  # shared file that is read before any other
    comment: str  # prefix of comment lines
    tables: Sequence[Table] = (POSES, ROTATIONS)  # each has a module for every chart
    imports_bases: bool = False  # True if the module of a multiple imports that of its base chart
    words: Collection[str] = ()  # words of the language, which name no module

    def file(self, chart: str, table: Table = POSES) -> str:
        """Return the module of the chart of a name, or with * the pattern of all modules."""
        return inside(table, f"{chart}.{self.extension}")

    def shared(self) -> Mapping[str, Callable[[], Data]]:
        """Return functions that make the data of the files in every package; a file has the template of its name."""

    def module(self, facts: Facts) -> Data:
        """Return the data for the module of a chart."""

    def index(self, names: Collection[str]) -> Mapping[str, tuple[str, Data]]:
        """Return files that list the charts of a folder, as `companions` does."""
        return {}

    def companions(self, facts: Facts) -> Mapping[str, tuple[str, Data]]:
        """Return further files of a chart: by name, the template and its data."""

    def tests(self, facts: Facts) -> Mapping[str, tuple[str, Data]]:
        """Return files, as `companions` does, that `test` compiles and runs."""
        return {}

    def require_complete(self, texts: Mapping[str, str]) -> None:
        """Raise ValueError unless the shared texts define the functions of the table."""

    def validate(self, folder: Path, chart: Chart, geometry: bool) -> int:
        """Execute the chart's own functions, or with ``geometry`` all; return the number of calls that agree."""

    def replay(self, folder: Path, chart: Chart, geometry: bool) -> int:
        """Call the functions of `validate` on floats; return the number of calls that agree with the formulas."""
        return 0

    def test(self, folder: Path, chart: Chart) -> int | None:
        """Compile and run the files of `tests`; return the number of agreeing calls, None without a compiler."""
        return 0


def shared_texts(target: Target) -> dict[str, str]:
    """Return the files that every package of a target holds; raise ValueError if functions of the table are missing."""
    texts = {}
    for name, make in target.shared().items():
        file = f"{target.name}/{name}"
        version = [f"Version {about.__version__}."] if name == target.entry else []  # no other header tells it
        lines = [*head(command(target.name), source(file)), *version]
        texts[name] = generated(file, _header(lines, _mark(name, target)), **make())
    target.require_complete(texts)
    return texts


def index_texts(target: Target, names: Collection[str]) -> dict[str, str]:
    """Render the files that list the charts of a folder, by file name."""
    made_by = command(target.name)
    found = target.index(names).items()
    return {name: generated(file, _header(head(made_by, source(file)), "#"), **data) for name, (file, data) in found}


def module_texts(facts: Facts, target: Target, tested: bool = True) -> dict[str, str]:
    """Render the module of a proved chart, its companions and, if ``tested``, its tests, by file name."""
    made_by = command(target.name, facts.chart)
    template = f"{target.name}/chart.{target.extension}.j2"
    header = _header(facts.header(made_by, template), target.comment)
    texts = {target.file(facts.chart.name): render(template, header=header, **target.module(facts))}
    further = {**target.companions(facts), **(target.tests(facts) if tested else {})}
    for name, (companion, data) in further.items():
        file = f"{target.name}/{companion}"
        texts[name] = generated(file, _header(head(made_by, source(file)), target.comment), **data)
    return texts


def notices(charts: Sequence[Chart], target: Target) -> dict[str, str]:
    """Render the temporary entry file of a package, by name: it stands there while the other files are replaced."""
    template, made_by = f"interrupted/{target.entry}.j2", command(target.name, *charts)
    header = "\n".join(f"{_mark(target.entry, target)} {line}" for line in head(made_by, template))
    return {target.entry: render(template, header=header, command=made_by)}


def _mark(name: str, target: Target) -> str:
    return "#" if name.endswith(HASH_COMMENTS) else target.comment
