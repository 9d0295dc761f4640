"""Markdown and reStructuredText: displays and comments, line by line. Code and other verbatim text is passed over."""

from __future__ import annotations

import re
from collections.abc import Iterable

from .comments import Collector
from .files import Files
from .scanner import ENVIRONMENTS, Scanner

FENCE = re.compile(r"[ \t>]*(`{3,}|~{3,}|:{3,})\s*(.*)")
OPTION = re.compile(r"\s*:?(label|name):\s*(\S+)|\s*:[\w-]+:|\s*---\s*$")
TOKEN = re.compile(
    r"`+[^`]*`+|(?P<comment><!--|-->)|(?P<dollars>\$\$)(?:\s*(?:\(|\{#)(?P<label>[\w:.-]+)[)}])?|\\(?P<edge>begin|end)\{(?P<name>\w+)\*?\}|\\."
)


class Markdown(Scanner):
    """Reader of Markdown: ``$$``, blocks ``math``, environments of LaTeX, and comments ``<!-- dualcay: … -->``."""

    fence = ""  # signs that began the open block
    in_comment = in_head = False

    def lines(self, lines: Iterable[tuple[int, str]]) -> None:
        for number, line in lines:
            fence = None if self.in_comment or (self.kind and not self.fence) else FENCE.match(line)
            if self.fence:
                self._in_block(number, line, fence)
            elif fence and (fence[1][0] != ":" or fence[2].strip() == "{math}"):
                self.fence = fence[1]
                if fence[2].strip() in ("math", "{math}"):
                    self.begin("a block math", number, 1)
                    self.in_head = True
            else:
                self._line(number, line)
        self.finish()

    def _in_block(self, number: int, line: str, fence: re.Match[str] | None) -> None:
        if fence and fence[1].startswith(self.fence) and not fence[2].strip():
            self.fence = ""
            if self.kind:
                self.end()
        elif self.kind:
            option = OPTION.match(line) if self.in_head else None
            self.in_head = option is not None
            if option is None:
                self.add(number, line, 0, len(line))
            elif option[2]:
                self.label = option[2]

    def _line(self, number: int, line: str) -> None:
        at = 0
        for token in TOKEN.finditer(line):
            opening = token["comment"] == "<!--"
            if token["comment"] and self.in_comment is not opening:
                self._part(number, line, at, token.start())
                self.in_comment, self.going_on, at = opening, False, token.end()
            elif self.in_comment or token["comment"]:
                continue
            elif token["dollars"] or (token["name"] in ENVIRONMENTS and bool(self.kind) == (token["edge"] == "end")):
                kind = "$$" if token["dollars"] else token[0].partition("{")[2][:-1]
                self.label = token["label"] or ""
                at = self.edge(kind, number, line, at, token)
        self._part(number, line, at, len(line))

    def _part(self, number: int, line: str, first: int, end: int) -> None:
        if self.in_comment:
            self.comment(number, first + 1, line[first:end], inside=True)
        else:
            self.add(number, line, first, end)


DIRECTIVE = re.compile(r"(\s*)\.\. (?:(math)::\s*(.*)|(dualcay\b.*))")
CODE = re.compile(r"(?:(?!\.\. ).*::|\s*\.\. (?:code|code-block|sourcecode|parsed-literal|raw|prompt)::.*)\s*$")


class Rest(Scanner):
    """Reader of reStructuredText: directives ``math`` and comments ``.. dualcay: …`` with the indented lines below."""

    def lines(self, lines: Iterable[tuple[int, str]]) -> None:
        block, indent = "", 0
        for number, line in lines:
            depth = len(line) - len(line.lstrip())
            if not line.strip():
                self.going_on = False
                continue
            directive = DIRECTIVE.match(line)
            if block and depth > indent and not (self.kind and directive):
                self._in_block(block, number, depth, line)
                continue
            if self.kind:
                self.end()
            indent = depth
            block = "code" if CODE.match(line) and not (directive and directive[2]) else ""
            if directive and directive[2]:
                block = "math"
                self.begin("directive math", number, depth + 1)
                self.add(number, line, directive.start(3), len(line))
            elif directive:
                block = "comment"
                self.comment(number, directive.start(4) + 1, directive[4])
        if self.kind:
            self.end()
        self.finish()

    def _in_block(self, block: str, number: int, depth: int, line: str) -> None:
        option = OPTION.match(line) if block == "math" else None
        if option and option[2]:
            self.label = option[2]
        elif block == "comment":
            self.comment(number, depth + 1, line[depth:], inside=True)
        elif block == "math" and not option:
            self.add(number, line, 0, len(line))


def read(kind: type[Markdown | Rest], files: Files, collected: Collector) -> None:
    kind(collected, files.first).lines(enumerate(files.text(files.first).split("\n"), 1))
