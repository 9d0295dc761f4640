"""Sections of docs/benchmarks.md, each marked by a comment with its name."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

ORDER = ("kernels", "native", "libraries", "motion", "propagate", "compiling", "jitted", "recorded")
"""Names of the sections, in the order of the page."""

INTRODUCTION = """# Speed

This page shows how long the kernels take, beside other libraries. All libraries run in turn in one process, on equal
arguments; other machines have other times, with similar ratios. Times are nanoseconds per pose, n is the order of a
Cayley map, and N the number of poses in one call. A gate is the ratio that a row must reach; the first table tells
which are met, the others are SHORT. `1/3 x` means that ours take three times as long. `make bench`
measures, and writes this page.
"""


def sections(page: str) -> dict[str, str]:
    """Return the sections of a page by name; the text above the first section has the name ''."""
    places = sorted((page.index(_mark(name)), name) for name in ORDER if _mark(name) in page)
    ends = [*(place for place, _ in places), len(page)]
    found = {"": page[: ends[0]].strip()}
    for (place, name), end in zip(places, ends[1:], strict=True):
        found[name] = page[place + len(_mark(name)) : end].strip()
    return found


def joined(head: str, texts: dict[str, str]) -> str:
    """Return a page from the text above its sections, and the texts of its sections."""
    marked: Iterable[str] = (f"{_mark(name)}\n\n{texts[name].strip()}" for name in ORDER if name in texts)
    return "\n\n".join([head, *marked]) + "\n"


def write_section(path: Path, name: str, text: str) -> None:
    """Replace one section of a page, or add it."""
    page = path.read_text(encoding="utf-8") if path.exists() else "# Speed"
    found = sections(page) | {name: text}
    path.write_text(joined(found.pop(""), found), encoding="utf-8")


def _mark(name: str) -> str:
    return f"<!-- {name} -->"
