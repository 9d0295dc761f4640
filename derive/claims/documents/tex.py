"""LaTeX documents: displays, comments, and files taken in. Macros are not filled in, and nothing is evaluated."""

from __future__ import annotations

import re

from .comments import Collector, Place
from .files import Files, SheetError
from .scanner import ENVIRONMENTS, Scanner

VERBATIM = ("verbatim", "Verbatim", "lstlisting", "minted", "comment")
TOKEN = re.compile(
    r"\\(?P<edge>begin|end)\s*\{(?P<name>\w+)(?P<star>\*?)\}|\\(?P<bracket>[][])|(?P<dollar>\$\$?)|(?P<percent>%)"
    r"|\\(?:input|include)\b\s*(?:\{(?P<file>[^{}]*)\}|(?P<word>[^\s\\{}%]+))|\\verb\b\*?(?P<verb>[^\w\s])"
    r"|\\(?P<iffalse>iffalse)\b|\\."
)
MACRO = re.compile(r"\s*\\(?:(?:re)?newcommand|(?:re)?newenvironment|providecommand|def|let)\b")
"""Beginning of a line that defines a macro, whose parts are no displays."""


def read(files: Files, collected: Collector) -> None:
    Reader(files, collected).read(files.first)


class Reader(Scanner):
    """Reader of a LaTeX document, line by line."""

    def __init__(self, files: Files, collected: Collector) -> None:
        super().__init__(collected, files.first)
        self.files = files
        self.verbatim = ""
        self.inline = False  # whether a formula within a paragraph is open
        self.ended = False

    def read(self, path: str) -> None:
        """Read a file; one that it takes in is read at its place."""
        self.files.open.append(path)
        for number, line in enumerate(self.files.text(path).split("\n"), 1):
            self.file, name = path, self.files.name(path)
            self.prefix = f"{name} " if name else ""
            self.inline = self.inline and bool(line.strip())
            if not (self.ended or (MACRO.match(line) and not self.kind)):
                self._line(number, line)
        self.files.open.pop()
        if not self.files.open:
            self.finish()

    def _line(self, number: int, line: str) -> None:
        if not line.lstrip().startswith("%"):
            self.going_on = False
        at = first = 0
        while not self.ended:
            if self.verbatim:
                ending = line.find(self.verbatim, at)
                if ending < 0:
                    return
                self.verbatim, at = "", ending + len(self.verbatim)
            token = TOKEN.search(line, at)
            if token is None:
                break
            at = token.end()
            if token["iffalse"]:
                self.verbatim = r"\fi"
            elif token["verb"]:
                at = line.find(token["verb"], at) + 1 or len(line)
            elif token["percent"]:
                self.add(number, line, first, token.start())
                self.comment(number, at + 1, line[at:])
                return
            elif token["file"] is not None or token["word"]:
                self.add(number, line, first, token.start())
                self._take_in(number, (token["file"] or token["word"] or "").strip())
                first = at
            elif kind := self._kind(token):
                first = self.edge(kind, number, line, first, token)
        self.add(number, line, first, len(line))

    def _kind(self, token: re.Match[str]) -> str:
        """Return the kind of the display that a token begins or ends; empty if it does neither."""
        if token["dollar"]:
            self.inline ^= token["dollar"] == "$" and not self.kind
            return "$$" if token["dollar"] == "$$" and not self.inline else ""
        name, kind = token["name"], f"{token['name']}{token['star']}"
        if not name:
            return r"\[" if token["bracket"] == ("]" if self.kind else "[") else ""
        if token["edge"] == "end":
            self.ended = name == "document"
        elif name in VERBATIM:
            self.verbatim = rf"\end{{{kind}}}"
        return kind if name in ENVIRONMENTS and bool(self.kind) == (token["edge"] == "end") else ""

    def _take_in(self, number: int, name: str) -> None:
        before = self.file, self.prefix
        try:
            path = self.files.taken_in(name)
        except SheetError:
            raise
        except ValueError as error:
            self.collected.problem(f"file {name}", Place(self.file, number, 1), str(error))
            return
        self.read(path)
        self.file, self.prefix = before
