"""Preprocess and parse a header and the files that it includes."""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from pcpp import Preprocessor
from pycparser import CParser, c_ast
from pycparser.c_parser import ParseError

from ..decimals import Decimal
from .memory import CError


def _number(value: Any) -> Any:
    """Return a number that has functions; where a selection leaves a constant, only an exact one is at hand."""
    return Decimal(value) if type(value) is Fraction else value


LIBRARY: Mapping[str, tuple[int, Callable[..., Any]]] = {
    "fabs": (1, abs),
    "sqrt": (1, lambda a: _number(a).sqrt()),
    "tan": (1, lambda a: _number(a).tan()),
    "atan2": (2, lambda a, b: _number(a).arctan2(b)),
    "expm1": (1, lambda a: _number(a).expm1()),
    "log1p": (1, lambda a: _number(a).log1p()),
}
"""Functions of the C library by name: the number of arguments, and the method to call on the numbers."""

SYSTEM: Mapping[str, str] = {
    "stddef.h": "typedef unsigned long size_t;\n",
    "math.h": "".join(f"double {name}({', '.join(['double'] * n)});\n" for name, (n, _) in LIBRARY.items()),
}
"""Declarations by header of the C library."""


@dataclass(frozen=True, slots=True)
class Source:
    """Preprocessed text, its syntax tree, and the preprocessor that holds its macros."""

    text: str
    tree: c_ast.FileAST
    macros: Preprocessor

    def expand(self, text: str) -> str:
        """Return the text with the macros of the header expanded."""
        return "".join(token.value for token in self.macros.expand_macros(self.macros.tokenize(text)))


class _Preprocessor(Preprocessor):  # type: ignore[misc]  # pcpp has no type hints
    """Preprocessor that includes only files of one folder and C library headers; problems raise `CError`."""

    def __init__(self, folder: Path | None) -> None:
        super().__init__()
        self.folder, self.line_directive = folder and folder.resolve(), "#line"
        if self.folder:
            self.add_path(str(self.folder))

    def on_file_open(self, is_system_include: bool, includepath: str) -> io.StringIO:
        path = Path(includepath)
        if is_system_include and path.name in SYSTEM:
            return io.StringIO(SYSTEM[path.name])
        if is_system_include or self.folder not in path.resolve().parents:
            raise OSError(f"{path} is outside of {self.folder}")
        return io.StringIO(path.read_text(encoding="utf-8"))

    def on_error(self, file: str, line: int, msg: str) -> None:
        raise CError(f"{Path(file).name}:{line}: {msg}")

    def on_include_not_found(self, is_malformed: bool, is_system_include: bool, curdir: str, includepath: str) -> None:
        raise CError(f"{includepath} is neither in the folder nor one of {', '.join(SYSTEM)}")

    def on_directive_unknown(self, directive: Any, toks: Any, ifpassthru: bool, precedingtoks: Any) -> None:
        text = "".join(token.value for token in toks)
        raise CError(f"{Path(directive.source).name}:{directive.lineno}: #{directive.value} {text}")


def parse(text: str, folder: Path | None, defines: Mapping[str, str]) -> Source:
    """Preprocess and parse a text; quoted includes are files of the folder, if one is given."""
    preprocessor, written = _Preprocessor(folder), io.StringIO()
    for name, value in defines.items():
        preprocessor.define(f"{name} {value}")
    preprocessor.parse(text, "unit.c")
    preprocessor.write(written)
    try:
        tree = CParser().parse(written.getvalue(), "unit.c")
    except ParseError as error:
        where, _, message = str(error).partition(":")
        raise CError(f"{Path(where).name}:{message}") from error
    return Source(written.getvalue(), tree, preprocessor)
