"""Catalogue of charts: by order, by family, by a user's φ, committed, and in a folder; also reserved names."""

from __future__ import annotations

import itertools
import re
import shlex
import symtable
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path, PurePath

import sympy

from .. import about
from ..maps import Cayley, family, parameterization
from ..maps.chart import Chart
from ..maps.elementary import alpha
from ..maps.sine import Sine
from ..output import files, generated
from .package import command
from .signatures import ROTATIONS
from .targets import TARGETS, Target

C_HEADERS = frozenset({
    "assert", "complex", "ctype", "errno", "fenv", "float", "inttypes", "iso646", "limits", "locale", "math", "setjmp",
    "signal", "stdalign", "stdarg", "stdatomic", "stdbit", "stdbool", "stdckdint", "stddef", "stdint", "stdio",
    "stdlib", "stdnoreturn", "string", "tgmath", "threads", "time", "uchar", "wchar", "wctype", "python",
})  # fmt: skip
"""Headers of the C library (C23, 7.1.2) and of Python; a module of the same name would hide them."""

DEVICES = frozenset({"con", "prn", "aux", "nul", *(f"{port}{n}" for port in ("com", "lpt") for n in range(10))})
"""Names of devices on Windows, where no file may have them, with any ending."""

NAME_LETTERS_MAX = 100
"""Largest length of a user's name: names of files and C functions, which contain it, are then below 255."""


def charts(
    orders: Iterable[int] = (), families: Iterable[str] = (), phi: str | None = None, name: str | None = None
) -> list[Chart]:
    """Return the charts of the orders, or of φ with an order as n in it, then those of the families, each once.

    Raise ValueError or TypeError for an unknown order or family, a refused φ, or a reserved name.
    """
    named, given = [*map(family, dict.fromkeys(families))], sorted(set(orders))
    if phi is None:
        return [*map(Cayley, given), *named]
    if len(given) > 1:
        raise ValueError(f"n in phi has one value, got {', '.join(map(str, given))}")
    require_free(name or "")
    own: Chart = parameterization(phi, name or "", given[0] if given else None)
    _require_same_chart(own)
    return [own, *named]


def committed() -> list[Chart]:
    return charts(about.ORDERS, about.FAMILIES)


def chart_of(line: str) -> Chart | None:
    """Return the chart that a module's command names; None for any other command."""
    try:
        chosen = dict(itertools.pairwise(shlex.split(line)))
        order = int(chosen["-n"]) if "-n" in chosen else None
        if "--phi" in chosen:
            return parameterization(chosen["--phi"], chosen["--name"], order)
        if "--family" in chosen:
            return family(chosen["--family"])
        return Cayley(order) if order else None
    except (KeyError, ValueError):
        return None


def charts_in(folder: Path, target: Target) -> Iterator[Chart]:
    """Yield the charts whose modules in a folder begin with the command that generates them."""
    for path in sorted(folder.glob(target.file("*"))):
        line = files.header_command(path) or ""
        chart = chart_of(line)
        if chart and folder / target.file(chart.name) == path and command(target.name, chart) == line:
            yield chart


def require_free(name: str) -> None:
    """Raise ValueError if a user's chart may not have this name. Case does not matter, as on some file systems."""
    folded = name.lower()
    if len(name) > NAME_LETTERS_MAX:
        raise ValueError(f"a name has at most {NAME_LETTERS_MAX} letters, got {len(name)}")
    if folded.split("_")[0] == ROTATIONS.name:  # C functions of rotations begin with dualcay_rotation_
        raise ValueError(f"{name!r} is the name of the folder of rotations, or begins as names of its functions do")
    if folded in {chart.name for chart in committed()}:
        raise ValueError(f"{name!r} is the name of a committed module")
    if name.startswith("_"):
        raise ValueError(f"names with a leading underscore are those of a package's own files, got {name!r}")
    if folded in DEVICES:
        raise ValueError(f"{name!r} is the name of a device on Windows: choose another name")
    if folded in C_HEADERS:
        raise ValueError(f"a header {name}.h would hide that of C or Python: take another name than {name!r}")
    if {name, folded} & reserved_names():
        raise ValueError(f"{name!r} is reserved in packages of kernels: choose another name")


@cache
def reserved_names() -> frozenset[str]:
    """Return the names of files and folders in packages of any target, and the global names of their entries."""
    return frozenset(name for target in TARGETS.values() for name in _reserved(target))


def _reserved(target: Target) -> Iterator[str]:
    yield from target.words
    homes = {PurePath(target.file("chart", table)).parent for table in target.tables}  # folders of charts
    for file, make in target.shared().items():
        path = PurePath(file)
        yield from (part.lstrip("+") for part in path.parts[:-1])
        if path.parent in homes and path.suffix in (f".{target.extension}", ".ts"):
            yield path.name.partition(".")[0]
        if path.name == "__init__.py":
            yield from _globals(symtable.symtable(generated(f"{target.name}/{file}", "", **make()), file, "exec"))


def _globals(table: symtable.SymbolTable) -> Iterator[str]:
    """Yield the global names of a module and used built-in functions: a submodule of such a name would hide it."""
    module = table.get_type() == "module"
    yield from (symbol.get_name() for symbol in table.get_symbols() if module or symbol.is_global())
    for inner in table.get_children():
        yield from _globals(inner)


def _require_same_chart(own: Chart) -> None:
    """Raise ValueError if the name belongs to a different chart; sin(α/N) may also be called sineN."""
    name = own.name.lower()
    cayley = re.fullmatch(r"cayley([1-9]\d*)", name)
    try:
        other: Chart = Cayley(int(cayley[1])) if cayley else family(name)
    except ValueError:
        return
    if own.phi != other.phi and not (isinstance(other, Sine) and own.phi == sympy.sin(alpha / other.order)):
        raise ValueError(f"{own.name!r} is the name of the chart of phi = {other.phi}: take another for {own.phi}")
