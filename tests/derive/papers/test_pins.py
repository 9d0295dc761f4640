"""What entries quote is what the papers' texts say at those lines: by hashes, for the texts are not here."""

from __future__ import annotations

from dataclasses import replace

import pytest

from derive.papers import PAPERS
from tests.support import pins


@pytest.mark.smoke
@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.short)
def test_every_quotation_is_in_the_text(paper) -> None:
    kept = pins.committed(paper)
    for entry in paper.entries():
        found = {name: (line, pins.digest(pins.marks(paper, words, quoted=name == "extract")))
                 for name, line, words in pins.quotations(entry)}  # fmt: skip
        known = {name: (at["line"], at["quotation"]) for name, at in kept.get(entry.number, {}).items()}
        assert found == known, f"({entry.number}): see tests/support/pins.py"
    assert set(kept) <= {entry.number for entry in paper.entries()}


def test_a_line_has_one_text() -> None:
    for paper in PAPERS:
        lines: dict[tuple[int, int], str] = {}
        for known in pins.committed(paper).values():
            for at in known.values():
                assert lines.setdefault((at["line"], at["lines"]), at["text"]) == at["text"]


def test_a_quotation_is_found_in_pieces_and_nothing_else_is() -> None:
    paper = PAPERS[0]
    text = ["where a = b + ε", "and b = 2 c hold"]
    assert pins.pin(paper, text, "said", 2, "b = 2 c")["pieces"] == [[3, 7]]
    assert pins.pin(paper, text, "extract", 1, "a = b + ε b = 2 c")["lines"] == 2
    for wrong in ("b = 3 c", "2 c b =", "b = 2 c +"):
        with pytest.raises(pins.NotInTheTextError):
            pins.pin(paper, text, "said", 2, wrong)


def test_a_changed_extract_is_noticed() -> None:
    paper, entry = PAPERS[0], next(entry for entry in PAPERS[0].entries() if entry.number == "112")
    changed = replace(entry, extract=entry.extract.replace("11", "12"))
    ((_, _, words),) = pins.quotations(changed)
    assert pins.digest(pins.marks(paper, words, quoted=True)) != pins.committed(paper)["112"]["extract"]["quotation"]
