"""Measured times as data: docs/benchmarks.json, from which come the page, its plot and the figures of the README."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass, field, replace
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from benchmarks.peers import LIBRARIES
from benchmarks.timing import LARGE, Call, measured
from derive.output.files import put

ROOT = Path(__file__).parents[1]
FILE, README = ROOT / "docs" / "benchmarks.json", ROOT / "README.md"

CHARTS = ("cayley2", "exponential")
"""Charts that are drawn, and measured in all forms; libraries take the vectors of the latter."""

ORDERS = (2, 3)
"""Orders of the Cayley maps that are measured in every part."""


OTHERS = {"NumPy": "numpy", "Numba": "numba", "JAX": "jax", "SymPy": "sympy"}
"""Distributions that take part besides the libraries."""

Key = tuple[str, str, str]
"""Type of what identifies a call: who makes it, chart, text."""


@dataclass(frozen=True, slots=True)
class Timed:
    """Call that was timed, with nanoseconds per pose by number of poses.

    Part is a group of calls that take turns; ``chart`` is empty for libraries. A call of a library occurs once.
    """

    part: str
    by: str
    chart: str
    function: str
    call: str
    ns: Mapping[int, float]


@dataclass(frozen=True)
class Data:
    """Everything that one run measured, the versions of what took part, and who was taken from an earlier run.

    ``later`` names the parts that a later run measured again, with its commit.
    """

    commit: str
    versions: Mapping[str, str]
    times: Sequence[Timed]
    kept: Mapping[str, str] = field(default_factory=dict)
    later: Mapping[str, str] = field(default_factory=dict)

    def find(self, part: str, by: str = "", function: str = "", chart: str | None = None) -> list[Timed]:
        """Return the times of a part, of all that is not named."""
        return [
            timed for timed in self.times
            if timed.part == part and by in ("", timed.by) and function in ("", timed.function)
            and chart in (None, timed.chart)
        ]  # fmt: skip

    def first(self, part: str, by: str, function: str, chart: str = "") -> Timed:
        """Return one call; the first, if a library has two. A call that was not measured has no times."""
        return next(iter(self.find(part, by, function, chart)), Timed(part, by, chart, function, "", {}))

    def ns(self, part: str, by: str, function: str, chart: str = "") -> Mapping[int, float]:
        """Return the times of `first`."""
        return self.first(part, by, function, chart).ns

    def with_missing(self, former: Data) -> Data:
        """Return these data with the times of those that took part in a former run alone."""
        present = {(timed.part, timed.by) for timed in self.times}
        lost = [timed for timed in former.times if (timed.part, timed.by) not in present]
        names = sorted({timed.by for timed in lost})
        kept = {name: former.kept.get(name) or former.origin(name) for name in names}
        return Data(self.commit, self.versions, [*self.times, *lost], kept)

    def with_parts(self, found: Data) -> Data:
        """Return these data with the parts that a later run measured in place of their own."""
        parts = dict.fromkeys((timed.part for timed in found.times), found.commit)
        times = [*(timed for timed in self.times if timed.part not in parts), *found.times]
        return replace(self, versions={**self.versions, **found.versions}, times=times, later={**self.later, **parts})

    def origin(self, name: str) -> str:
        """Return the version, if known, and the commit at which someone was measured."""
        return ", ".join(filter(None, (self.versions.get(name), f"commit {self.commit}")))

    def write(self, path: Path = FILE) -> None:
        """Write the data, one call a line."""
        calls = ",\n  ".join(json.dumps(asdict(timed), ensure_ascii=False) for timed in self.times)
        text = json.dumps(asdict(self) | {"times": []}, indent=1, ensure_ascii=False)
        put(path, text.replace('"times": []', f'"times": [\n  {calls}\n ]') + "\n")


def read(path: Path = FILE) -> Data:
    """Return the data of a file; no data if it does not exist."""
    if not path.exists():
        return Data("", {}, [])
    found = json.loads(path.read_text(encoding="utf-8"))
    times = [Timed(**line | {"ns": {int(size): ns for size, ns in line["ns"].items()}}) for line in found.pop("times")]
    return Data(times=times, **found)


def timed(part: str, groups: Iterable[tuple[str, int, Mapping[Key, Call]]], kept: bool = True) -> Iterator[Timed]:
    """Time groups of calls, each of one function and number of poses, that take turns; yield calls with all times.

    ``kept`` keeps the process on one core.
    """
    found: dict[tuple[str, Key], dict[int, float]] = {}
    for function, size, calls in groups:
        print(f"{part}: {function}, N = {size:,}", file=sys.stderr, flush=True)
        for call in calls.values() if size < LARGE else ():
            call()  # the first call may compile
        for key, ns in measured(calls, size, kept).items():
            found.setdefault((function, key), {})[size] = float(f"{ns:.4g}")
    for (function, (by, chart, text)), ns_of in found.items():
        yield Timed(part, by, chart, function, text, ns_of)


def shown(ns: float) -> str:
    """Return a time with three digits."""
    return f"{float(f'{ns:.3g}'):.9g}"


def label(chart: str) -> str:
    """Return the label of a chart in tables: the order of a Cayley map, or its name."""
    order = chart.removeprefix("cayley")
    return f"n = {order}" if order.isdigit() else chart


def commit() -> str:
    """Return the commit of this checkout, marked if files differ from it; empty outside a checkout."""
    command = ("git", "-C", str(ROOT), "describe", "--always", "--dirty", "--exclude=*", "--abbrev=8")
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.stdout.strip()


def versions() -> dict[str, str]:
    """Return the versions of libraries that are installed."""
    found = {}
    for name, distribution in {**{name: of.distribution for name, of in LIBRARIES.items()}, **OTHERS}.items():
        with suppress(PackageNotFoundError):
            found[name] = version(distribution)
    return found
