"""Laws of the data files of formulas in use: what each document and each formula must say beside its claim."""

import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import derive

FOLDER = Path(derive.__file__).parent / "papers" / "field"
DOCUMENTS = {path.stem: tomllib.loads(path.read_text("utf-8")) for path in sorted(FOLDER.glob("*.toml"))}
GATHERED = ("code-alone", "preintegration", "reports")
"""Files whose equations come from many places, each named beside the equation."""
COMMIT = re.compile(r"commit [0-9a-f]{40}\b")
PLACE = re.compile(r"^\S+[:/@]\S+|^10\.\d+/\S+")
"""Address of a thread or commit, or a DOI."""


def faults(slug: str, document: dict[str, Any]) -> Iterator[str]:
    """Yield what a data file lacks or says twice."""
    beside = document["field"]
    told = {number: facts for number, facts in beside.items() if isinstance(facts, dict)}
    numbers = [equation["number"] for equation in document["equation"]]
    if document["paper"]["slug"] != slug:
        yield f"{slug}: the slug is not the file's name"
    if slug not in GATHERED:
        if not COMMIT.search(document["paper"]["source"]):
            yield f"{slug}: no commit in the source"
        yield from (f"{slug}: no {key}" for key in ("bibtex", "conventions") if not beside.get(key))
    yield from (f"{slug} {number}: given twice" for number in set(numbers) if numbers.count(number) > 1)
    yield from (f"{slug} {number}: facts of no equation" for number in told if number not in numbers)
    for equation in document["equation"]:
        name, facts = f"{slug} {equation['number']}", told.get(equation["number"], {})
        yield from (f"{name}: no {key}" for key in ("at", "latex", "claim") if not equation.get(key))
        if ("corrected" in equation) != ("error" in facts):
            yield f"{name}: a correction and a kind of error belong together"
        if facts.get("alarm") and "corrected" in equation:
            yield f"{name}: a false alarm has no correction"
        if "report" in facts and not PLACE.search(facts["report"]):
            yield f"{name}: no address of the report"
        for code in facts.get("code", ()):
            yield from (f"{name}: no {key} of the code" for key in ("source", "at", "error") if not code.get(key))
        for figures in facts.get("switch", {}).values():
            if len(figures) != 3 or min(figures) < 0:
                yield f"{name}: a switch has its place and the errors below and above"


def test_every_document_says_what_the_page_needs() -> None:
    assert not [fault for slug, document in DOCUMENTS.items() for fault in faults(slug, document)]


def test_the_library_has_the_size_that_it_claims() -> None:
    documents = [slug for slug in DOCUMENTS if slug not in GATHERED]
    assert len(documents) >= 12
    assert sum(len(DOCUMENTS[slug]["equation"]) for slug in documents) >= 150
    reports = [facts for d in DOCUMENTS.values() for facts in d["field"].values() if "report" in facts]
    alarms = [facts for facts in reports if isinstance(facts, dict) and facts.get("alarm")]
    assert len(alarms) >= 2
    assert len(reports) - len(alarms) >= 15
    switches = [facts for facts in DOCUMENTS["code-alone"]["field"].values() if "switch" in facts]
    assert len(switches) >= 10


def test_a_file_with_a_fault_is_refused() -> None:
    equation = {"number": "1", "at": "a.md:1", "latex": "x", "claim": "x == x", "corrected": "x == 2*x"}
    document = {
        "paper": {"slug": "b", "source": "here"},
        "equation": [equation, equation],
        "field": {"2": {"report": "?"}},
    }
    found = list(faults("a", document))
    for part in ("slug", "no commit", "no bibtex", "twice", "facts of no", "belong together"):
        assert any(part in fault for fault in found), part
