"""Section of docs/accuracy.md: certified bounds of rounding errors beside the largest measured ones."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from proofs.rounding import SAMPLES, Bound, load

FILE = Path(__file__).parents[1] / "certified.json"
"""Bounds, written by ``make bounds``."""

HEADING, NEXT = "## Certified bounds", "## Range"
"""Headings of the section and of the one after it."""

TEXT = (
    "Largest error of each output of the C functions in double, in eps (2.22e-16), not relative to the output.",
    "Gappa certifies the bounds for every v with |v| ≤ 1 and a translation of length at most 1, if each operation is "
    "rounded to nearest and none is fused (`-ffp-contract=off`). Arguments count as exact, and entries that are "
    "constant have no row. "
    f"Measured errors are those of {SAMPLES} random v with the largest dual parts. `make machine-proofs` reads the "
    "programs back from the headers and certifies the bounds again.",
)


def section() -> Iterator[str]:
    """Yield the lines of the section."""
    rows: dict[tuple[str, int], dict[int, Bound]] = {}
    for bound in load(FILE):
        rows.setdefault((bound.function, bound.output), {})[bound.order] = bound
    orders = sorted({order for row in rows.values() for order in row})
    yield from (HEADING, "", TEXT[0], "", TEXT[1], "")
    yield _row("output", *(f"n = {n}: certified | measured" for n in orders))
    yield _row("---", *("--- | ---" for _ in orders))
    for row in (rows[key] for key in sorted(rows)):
        name = next(iter(row.values())).name
        yield _row(name, *(_errors(row[n]) for n in orders))
    yield ""


def _row(*cells: str) -> str:
    return f"| {' | '.join(cells)} |"


def _errors(bound: Bound) -> str:
    """Return the cells of certified and measured error; a bound is printed in full, so that it stays one."""
    return f"{bound.reason or bound.bound} | {bound.measured:.2g}"


def renewed(page: str) -> str:
    """Return the page with the section written anew."""
    before, _, after = page.partition(NEXT)
    return "\n".join([before.partition(HEADING)[0].rstrip("\n"), "", *section(), f"{NEXT}{after}"])
