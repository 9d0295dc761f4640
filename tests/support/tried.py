"""What is tried of a chart, by kind and function, as a count and a digest: no case is lost or changed unnoticed.

``python -m tests.support.tried`` writes that down, beside the tests, where a change is meant.
"""

from __future__ import annotations

import decimal
import hashlib
import json
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import mpmath
from derive.codegen.cases import batches, cases, far, samples
from derive.codegen.cases.decimals import DIGITS, Decimal

from derive.codegen.rows import Table
from derive.codegen.signatures import POSES, ROTATIONS
from derive.maps import Cayley, family
from derive.maps.chart import Chart

FILE = Path(__file__).parents[1] / "derive" / "codegen" / "tried.json"
EDGED = family("orthographic")
CHARTS: Mapping[str, tuple[Chart, ...]] = {
    "batches": (Cayley(3), family("exponential"), EDGED),
    "cases": (EDGED,),
    "samples": (Cayley(3), family("exponential"), EDGED),
}
TABLES = {"poses": POSES, "rotations": ROTATIONS}
SHOWN = 12
"""Digits that count: there are many more, so that no rounding makes one of these another."""
ROUNDED = decimal.Context(prec=SHOWN)
FAR = 1e20

Call = tuple[str, Any]
"""The function, and all that belongs to it."""


def _batches(chart: Chart, table: Table) -> Iterator[Call]:
    for batch in batches(chart, table):
        for case in batch.cases:
            numbers = (case.arguments, case.result) if not batch.exact else len(case.result)
            yield batch.function, (batch.branch, batch.tolerance, numbers)


def _cases(chart: Chart, table: Table) -> Iterator[Call]:
    for case in cases(chart, table):
        yield case.function, (case.branch, case.arguments, case.result, case.scales)


def _samples(chart: Chart, table: Table) -> Iterator[Call]:
    for sample in (*samples(chart, table), *far(chart, FAR, table)):
        yield sample.function, (sample.branch, sample.arguments, sample.results)


KINDS: Mapping[str, Callable[[Chart, Table], Iterator[Call]]] = {
    "batches": _batches,
    "cases": _cases,
    "samples": _samples,
}

Tried = dict[str, str]


def tried(kind: str, table: str) -> Tried:
    """By chart and function: how many calls, and a digest of their numbers."""
    calls: dict[str, list[str]] = {}
    with mpmath.workdps(DIGITS):
        for chart in CHARTS[kind]:
            for function, numbers in KINDS[kind](chart, TABLES[table]):
                calls.setdefault(f"{chart.name}.{function}", []).append(_text(numbers))
    return {name: f"{len(texts)} {_digest(texts)}" for name, texts in calls.items()}


def _text(value: Any) -> str:
    """Numbers as they are read, in the parentheses of what holds them."""
    if isinstance(value, tuple | list):
        return f"({' '.join(map(_text, value))})"
    if value is None or isinstance(value, int | str):
        return str(value)
    if isinstance(value, Decimal):
        return str(value.value.normalize(ROUNDED) + 0)  # no zero has a sign
    return str(mpmath.nstr(value, SHOWN))


def _digest(texts: Iterable[str]) -> str:
    return hashlib.sha256("\n".join(texts).encode()).hexdigest()[:12]


def committed() -> dict[str, Tried]:
    """What was written down, by kind and table."""
    return json.loads(FILE.read_text(encoding="utf-8"))  # type: ignore[no-any-return]


if __name__ == "__main__":
    found = {f"{kind} of {table}": tried(kind, table) for kind in KINDS for table in TABLES}
    FILE.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
