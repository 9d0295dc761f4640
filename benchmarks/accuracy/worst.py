"""Worst errors: largest measured error of each function, order and type, with its regime and gate."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from dataclasses import dataclass

from benchmarks.accuracy.measure import Measurement
from derive.codegen.signatures import POSES, ROTATIONS
from derive.output.pages import json_rows

SHORT = {
    "uniform": "u",
    "angle 1e-12": "a12",
    "angle 1e-7": "a7",
    "middle band": "m",
    "below pi": "bπ",
    "coordinate axes": "ax",
    "translation 1e6": "t6",
    "pure rotation": "r",
    "pure translation": "t",
    "identity": "i",
    "above pi": "aπ",
    "at pi": "π",
    "near 2 pi": "2π",
    "shadow": "s",
}

TITLES = {POSES.name: "", ROTATIONS.name: ", rotations alone"}


@dataclass(frozen=True)
class Worst:
    """Largest error of one row and order."""

    row: str
    order: int
    dtype: str
    regime: str
    error: float
    gate: float

    @property
    def fraction(self) -> float:
        return self.error / self.gate

    def __str__(self) -> str:
        if self.error < 0.005:
            return "0"
        error = "∞" if math.isinf(self.error) else f"{self.error:.2g}" if self.error < 9.95 else f"{self.error:.0f}"
        return f"{error} {SHORT[self.regime]}"


Rows = dict[tuple[str, str, str, bool], dict[int, Worst]]


def table(measurements: Iterable[Measurement]) -> Rows:
    """Return the worst errors by (table of functions, type, row, inside the principal range) and order."""
    found: Rows = {}
    for m in measurements:
        worst = Worst(m.function, m.order, m.dtype, m.regime, m.error, m.gate)
        row = found.setdefault((m.table, m.dtype, m.function, m.inside), {})
        old = row.get(m.order)
        # Ties go to the later regime name, so that the result does not depend on the order of workers.
        if old is None or (worst.fraction, worst.regime) > (old.fraction, old.regime):
            row[m.order] = worst
    return found


TABLES = re.compile(r"<summary>(\w+) \(eps = .*?\)(.*?), (principal range|at π).*?</summary>\n\n(.+?)\n\n", re.DOTALL)


def data(page: str) -> str:
    """Return the tables of worst errors on the page as JSON: by order n the error in eps, and its regime."""
    names, rows = {short: regime for regime, short in SHORT.items()}, []
    for dtype, kind, where, text in TABLES.findall(page):
        head, _, *lines = ([cell.strip(" *") for cell in line.strip("|").split("|")] for line in text.splitlines())
        for function, gate, *cells in lines:
            by_order = {}
            for order, cell in zip(head[2:], cells, strict=True):
                if cell:
                    size, *regime = cell.split(" ")
                    by_order[order] = [float(size.replace("∞", "inf")), *(names[short] for short in regime)]
            place = {"type": dtype, "rotations": bool(kind), "beyond half a turn": where != "principal range"}
            rows.append({"function": function, **place, "gate": gate, "errors": by_order})
    return json_rows(schema=1, errors=rows)


def short_of_gate(measurements: Iterable[Measurement]) -> list[str]:
    """Return a line for every missed gate."""
    rows = table(measurements)
    missed = [(TITLES[kind], w) for (kind, *_), row in rows.items() for w in row.values() if w.fraction > 1]
    missed.sort(key=lambda found: (found[0], found[1].row, found[1].dtype, found[1].order))
    return [
        f"{w.row}{kind}, n = {w.order}, {w.dtype}, {w.regime}: {w.error:.3g} eps, gate {w.gate:g} FALLS SHORT"
        for kind, w in missed
    ]
