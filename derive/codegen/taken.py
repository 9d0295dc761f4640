"""Names that modules of packages hold already, which no chart of one's own may bear."""

from __future__ import annotations

import symtable
from collections.abc import Iterator
from functools import cache
from pathlib import PurePath

from ..output import render
from .targets import TARGETS, Target

ENTRY = "__init__.py"

HEADERS = frozenset({
    "assert", "complex", "ctype", "errno", "fenv", "float", "inttypes", "iso646", "limits", "locale", "math", "setjmp",
    "signal", "stdalign", "stdarg", "stdatomic", "stdbit", "stdbool", "stdckdint", "stddef", "stdint", "stdio",
    "stdlib", "stdnoreturn", "string", "tgmath", "threads", "time", "uchar", "wchar", "wctype", "python",
})  # fmt: skip
"""Of C's library (C23, 7.1.2) and Python's: a package's own would be found before them where its folder is searched."""


@cache
def names() -> frozenset[str]:
    """Of files, of folders, and in the entries of Python packages: in every target, as a chart has one name in all."""
    return frozenset(name for target in TARGETS.values() for name in _names(target))


def _names(target: Target) -> Iterator[str]:
    for file, data in target.shared().items():
        path = PurePath(file)
        yield from path.parts[:-1]
        if path.suffix == f".{target.extension}":
            yield path.stem
        if path.name == ENTRY:
            yield from _globals(symtable.symtable(render(f"{target.name}/{file}.j2", header="", **data), file, "exec"))


def _globals(table: symtable.SymbolTable) -> Iterator[str]:
    """What a text defines or reads of its module, built-in functions too: a submodule would stand before them."""
    module = table.get_type() == "module"
    yield from (symbol.get_name() for symbol in table.get_symbols() if module or symbol.is_global())
    for inner in table.get_children():
        yield from _globals(inner)


def require_free(name: str) -> None:
    """Refuse a name that is taken, or may be by a file to come.

    Raises
    ------
    ValueError
        Naming what is expected.
    """
    if name.startswith("_"):
        raise ValueError(f"names with a leading underscore are those of a package's own files, got {name!r}")
    if name.lower() in HEADERS:  # some file systems tell no capitals
        raise ValueError(f"a header {name}.h would stand before that of C or Python: take another name than {name!r}")
    if name in names():
        raise ValueError(f"{name!r} is the name of a file or of something else in packages of kernels: take another")
