"""What entries quote, held against the lines of the papers' texts, which are not in the repository.

``python -m tests.support.pins FOLDER``, with the texts as ``PACKAGE.txt`` in a folder, finds every quotation in its
line and writes, beside the tests, where it stands there and the hashes of both. Tests compare the entries with these.
"""

from __future__ import annotations

import hashlib
import importlib
import json
import sys
from collections.abc import Iterator
from difflib import SequenceMatcher
from pathlib import Path
from typing import Any

from derive.papers import PAPERS, Equation, Paper

FILE = Path(__file__).parents[1] / "derive" / "papers" / "pins.json"
LINES = 10
"""The most lines that one display takes, empty ones between its rows included."""
PIECES = 4
"""The most pieces that one display is in; between them are words, or marks that the entry leaves out."""

Pins = dict[str, dict[str, Any]]


class NotInTheTextError(Exception):
    """A quotation is not where its entry says."""


def quotations(entry: Equation) -> Iterator[tuple[str, int, str]]:
    """What an entry quotes: a name for it, line and words."""
    if entry.extract:
        yield "extract", entry.line, entry.extract
    if entry.said:
        yield "said", entry.line, entry.said
    if entry.stated is not None:
        yield ("stated", *entry.stated)


def marks(paper: Paper, words: str, quoted: bool) -> str:
    """The marks that survive, without spaces; of a line as its paper's alphabet reads LaTeX."""
    alphabet = importlib.import_module(f"{paper.package}.alphabet")
    read = words if quoted or not hasattr(alphabet, "marks") else alphabet.marks(words)
    return "".join(read.translate(str.maketrans("", "", paper.lost)).split())


def digest(words: str) -> str:
    """The hash of some marks."""
    return hashlib.sha256(words.encode()).hexdigest()


def pin(paper: Paper, text: list[str], name: str, line: int, words: str) -> dict[str, Any]:
    """Where a quotation stands, in the fewest lines, as pieces [from, to) of their marks; and the hashes of both."""
    wanted = marks(paper, words, quoted=name == "extract")
    for count in range(1, LINES + 1):
        found = "".join(marks(paper, part, quoted=False) for part in text[line - 1 : line - 1 + count])
        pieces = _pieces(wanted, found)
        if "".join(found[a:b] for a, b in pieces) == wanted and len(pieces) <= PIECES:
            return {"line": line, "lines": count, "pieces": pieces, "quotation": digest(wanted), "text": digest(found)}
    raise NotInTheTextError(f"{paper.short} line {line}: {words}")


def _pieces(wanted: str, found: str) -> list[list[int]]:
    if wanted in found:
        start = found.index(wanted)
        return [[start, start + len(wanted)]]
    blocks = SequenceMatcher(None, wanted, found, autojunk=False).get_matching_blocks()
    return [[block.b, block.b + block.size] for block in blocks if block.size]


def pins(paper: Paper, text: list[str]) -> Pins:
    """The pins of all entries of a paper."""
    return {
        entry.number: {name: pin(paper, text, name, line, words) for name, line, words in quotations(entry)}
        for entry in paper.entries()
    }


def committed(paper: Paper) -> Pins:
    """The pins that are kept."""
    kept: dict[str, Pins] = json.loads(FILE.read_text("utf-8"))
    return kept[paper.slug]


def main(folder: Path) -> None:
    """Write the file again."""
    parts = []
    for paper in PAPERS:
        text = (folder / f"{paper.package.rpartition('.')[2]}.txt").read_text("utf-8").splitlines()
        rows = (f"  {json.dumps(number)}: {json.dumps(found)}" for number, found in pins(paper, text).items() if found)
        parts.append(f"{json.dumps(paper.slug)}: {{\n" + ",\n".join(rows) + "\n}")
    FILE.write_text("{\n" + ",\n".join(parts) + "\n}\n", "utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
