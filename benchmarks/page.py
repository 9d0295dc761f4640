"""Page docs/benchmarks.md: the first screen from the data, then sections, each marked by a comment with its name.

The sections of data are printed anew; those that other commands write are kept until these run again.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

from benchmarks import slower
from benchmarks.maps import COMPILED, NUMPY, PART
from benchmarks.peers import LIBRARIES
from benchmarks.times import CHARTS, Data, commit, label, shown
from benchmarks.timing import ALLOCATOR, table
from derive.output.files import put

ORDER = (
    "slower", "maps", "clouds", "rows", "jacobians", "derivatives", "given", "motion", "propagate", "splines",
    "compiling", "jitted", "recorded", "gates",
)  # fmt: skip
"""Names of the sections, in the order of the page."""

COMMAND = "python -m benchmarks -o docs/benchmarks.md"
INTRODUCTION = """# Speed

Plot and table give nanoseconds per pose, with N poses in one call. They compare our kernels in NumPy, compiled ones (in
brackets), and other libraries. n is the order of a Cayley map. Other machines have other times, with similar ratios.
"""

SCREEN = ("pose", "quaternion", "from_pose", "compose")
SIZES = (1, 100, 10_000)
OTHERS = ("fastest other", "kept transforms")
"""Functions and numbers of poses of the first table, and the names of the lines of others' first and second calls."""


def head(data: Data) -> str:
    """Return the first screen: the plot, a table of four functions, and where others are faster."""
    chart = CHARTS[0]
    rows = []
    for function in SCREEN:
        numpy, compiled = (data.ns(PART, by, function, chart) for by in (NUMPY, COMPILED))
        ours = (f"{_ns(numpy, size)} ({_ns(compiled, size)})" for size in SIZES)
        rows.append([f"`{function}`", *ours])
        calls = max(len(of.texts.get(function, ())) for of in LIBRARIES.values())
        for place, name in enumerate(OTHERS[:calls]):
            rows.append([name, *(_fastest(data, function, size, place) for size in SIZES)])
    settings = " ".join(f"{name}={value}" for name, value in ALLOCATOR.items())
    how = [
        f"`{COMMAND}` measured all of this at commit {data.commit}, and wrote [the data](benchmarks.json) too. All "
        "calls of a function take turns in one process, on one core and equal arguments; a call of a library is "
        "measured once for each N. The times are medians of processor time, with the allocator fixed: "
        f"`{settings}`.",
        *(f"Part `{part}` was measured later, at commit {at}." for part, at in data.later.items()),
        *(f"{name} was missing: its times are those of {origin}." for name, origin in data.kept.items()),
    ]
    return "\n".join([
        INTRODUCTION, f"![ns per pose against the number of poses in a call]({FILE_OF_PLOT})\n",
        table((f"{label(chart)} (compiled)", *(f"N = {size:,}" for size in SIZES)), rows),
        "\n**Slower than others in:**\n", *slower.summary(data), "", " ".join(how),
    ])  # fmt: skip


FILE_OF_PLOT = "benchmarks.svg"


def _ns(ns: Mapping[int, float], size: int) -> str:
    return shown(ns[size]) if size in ns else "–"


def _fastest(data: Data, function: str, size: int, place: int) -> str:
    """Return the least time of a library with its name, of the first calls or of the second ones."""
    calls = {(name, *of.texts.get(function, ())[place : place + 1]) for name, of in LIBRARIES.items()}
    others = [
        (of.ns[size], of.by) for of in data.find(PART, "", function) if (of.by, of.call) in calls and size in of.ns
    ]
    return f"{shown(min(others)[0])} {min(others)[1]}" if others else "–"


README = re.compile(r"^(\| speed \| ).+?( \|)", re.MULTILINE)


def figures(data: Data) -> str:
    """Return the figures of speed in the README."""
    size = 10_000
    who = ((NUMPY, CHARTS[0]), ("SciPy", ""), ("pytransform3d", ""))
    ours, *others = (_ns(data.ns(PART, by, "pose", chart), size) for by, chart in who)
    return f"`pose` for {size} vectors: {ours} ns each; SciPy {others[0]} ns, pytransform3d {others[1]} ns"


def folded(text: str) -> str:
    """Fold the tables of a section; folded ones stay as they are."""
    return re.sub(r"(?<=\n\n)(?<!</summary>\n\n)\|.*\n\|[-:| ]+\|\n((?:\|.*\n)+)", _folded, text + "\n").rstrip()


def _folded(found: re.Match[str]) -> str:
    rows = found[1].count("\n")
    return f"<details><summary>Table, {rows} rows</summary>\n\n{found[0]}\n</details>\n"


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
    marked = (f"{_mark(name)}\n\n{folded(texts[name].strip())}" for name in ORDER if name in texts)
    return "\n\n".join([head, *marked]) + "\n"


def write_section(path: Path, name: str, text: str) -> None:
    """Replace one section of a page, or add it, with the commit at which it was measured."""
    page = path.read_text(encoding="utf-8") if path.exists() else "# Speed"
    found = sections(page) | {name: f"{text.strip()}\n\nMeasured at commit {commit()}."}
    put(path, joined(found.pop(""), found))


def _mark(name: str) -> str:
    return f"<!-- {name} -->"
