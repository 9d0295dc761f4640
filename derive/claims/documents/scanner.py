"""Displayed equations of a document and the comments between their lines, whatever its format."""

from __future__ import annotations

import re

from .comments import KNOWN, LABEL, LAYOUT, Collector, Place, Written

COMMENT = re.compile(rf"\s*(?:[%#]+\s*)?(?:dualcay:|(?=dualcay\s+(?:{'|'.join(KNOWN)})\b))")
"""Beginning of a comment of ours, also of one without its colon, which is told."""
GOES_ON = re.compile(r"[%#]*(?=(?:\t|  )\s*\S)")
WITH_ARGUMENT = ("alignat", "IEEEeqnarray")
"""Environments whose first group in braces is no part of an equation."""
OF_ROWS = (*WITH_ARGUMENT, "align", "eqnarray", "flalign", "gather")
"""Environments whose rows are equations of their own."""
ENVIRONMENTS = ("displaymath", "equation", "multline", *OF_ROWS)
ARGUMENT = re.compile(r"\s*\{[^{}]*\}")
ROW = re.compile(r"\\\\(?:\*|[ \t]*\[[^][{}\\]{0,20}\])?|\\(begin|end)\b|[{}]|\\.", re.DOTALL)


class Scanner:
    """State of a reader between lines: the open display, and the comments not yet handed on."""

    def __init__(self, collected: Collector, file: str, cell: str = "") -> None:
        self.collected, self.file, self.cell = collected, file, cell
        self.prefix = ""  # name of a file other than the first one
        self.kind = ""  # environment or sign that began the open display; empty outside
        self.label = ""
        self.begun = Place(file, 1, 1)
        self.body: list[tuple[Place, str]] = []
        self.comments: list[tuple[int, list[tuple[Place, str]]]] = []  # with the size of the open display before each
        self.size = 0
        self.going_on = False  # whether a further line may belong to the last comment

    def begin(self, kind: str, line: int, column: int) -> None:
        self.hand_on()
        self.kind, self.label, self.body, self.size = kind, "", [], 0
        self.begun = Place(self.file, line, column)

    def add(self, line: int, text: str, first: int, end: int) -> None:
        """Add a part of a line to the open display, if there is one."""
        if self.kind:
            self.body.append((Place(self.file, line, first + 1), text[first:end]))
            self.size += end - first + 1

    def edge(self, kind: str, line: int, text: str, first: int, token: re.Match[str]) -> int:
        """Begin or end a display at a token; return where the text after it begins, `first` if it did neither."""
        if not self.kind:
            self.begin(kind, line, token.start() + 1)
            argument = ARGUMENT.match(text, token.end()) if kind.rstrip("*") in WITH_ARGUMENT else None
            return (argument or token).end()
        if self.kind != kind:
            return first
        self.add(line, text, first, token.start())
        self.end()
        return token.end()

    def end(self) -> None:
        """Collect the rows of the open display, and after each the comments that follow its first sign."""
        whole = Written.of(self.body)
        of_rows = self.kind.rstrip("*") in OF_ROWS
        rows = _rows(whole) if of_rows else [(0, len(whole))] if whole.strip() else []
        self.kind, nexts = "", [first for first, _ in rows[1:]]
        for i, (first, end) in enumerate(rows):
            latex, place = whole[first:end], whole.place(first) if of_rows else self.begun
            labels = [" ".join(label.split()) for label in LABEL.findall(latex)] or [self.label] * bool(self.label)
            self.collected.equation(latex, place, self.cell or f"{self.prefix}line {place.line}", labels)
            while nexts[i:] and self.comments and self.comments[0][0] <= nexts[i]:
                self.collected.comment(Written.of(self.comments.pop(0)[1]))
        self.hand_on()

    def comment(self, line: int, column: int, text: str, inside: bool = False) -> None:
        """Take a comment, which begins one of ours or goes on with the last one; `inside`, any line goes on."""
        start = COMMENT.match(text)
        more = GOES_ON.match(text) if self.going_on else None
        self.going_on = bool(start or more or (self.going_on and inside))
        if start:
            self.comments.append((self.size if self.kind else 0, []))
        if self.going_on:
            after = (start or more or re.match("", text)).end()  # type: ignore[union-attr]
            self.comments[-1][1].append((Place(self.file, line, column + after), text[after:]))

    def hand_on(self) -> None:
        """Collect the comments after a display."""
        for _, lines in self.comments:
            self.collected.comment(Written.of(lines))
        self.comments, self.going_on = [], False

    def finish(self) -> None:
        if self.kind:
            said = f"{self.kind} begins in line {self.begun.line} and has no end"
            self.collected.problem("display", self.begun, said)
        self.kind = ""
        self.hand_on()


def _rows(text: str) -> list[tuple[int, int]]:
    """Return the rows of a display, from the first sign of each; one with an empty left side goes on with the last."""
    rows, first, depth = [], 0, 0
    for token in ROW.finditer(text):
        if token[1] or token[0] in "{}":
            depth += 1 if token[1] == "begin" or token[0] == "{" else -1
        elif token[0].startswith("\\\\") and depth == 0:
            rows.append((first, token.start()))
            first = token.end()
    found: list[tuple[int, int]] = []
    for start, end in (*rows, (first, len(text))):
        shown = text[start:end]
        if found and shown.lstrip().startswith("&"):
            found[-1] = found[-1][0], end
        elif LAYOUT.sub("", shown).strip():
            found.append((start + len(shown) - len(shown.lstrip()), end))
    return found
