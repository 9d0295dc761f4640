"""Measurement of errors and speed of charts, for ``dualcay compare``; written to docs/parameterizations.json.

Errors are measured at seeded vectors of given angles, against values of 60 digits. An error is in eps of the result's
size and condition, for its worse part. Times are per pose, in calls with one pose and with many.
"""

from __future__ import annotations

import importlib
import json
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console

from benchmarks.accuracy.__main__ import progress
from benchmarks.gates import GATED
from benchmarks.maps import arguments
from benchmarks.nearest import searched
from benchmarks.peers import Poses
from benchmarks.timing import fix_allocator, measured
from derive.codegen import catalogue
from derive.maps.chart import Chart
from derive.output.files import put
from derive.pages.comparison import ANGLES, MEASURED, MEASUREMENTS, NEAREST, TIMED, Compared
from tests.support import families, oracle

SAMPLES = 6


def oracle_of(chart: Chart) -> oracle.Oracle:
    """Return the oracle of a chart from first principles."""
    if chart.cayley:
        return oracle.oracle_of(chart.order, families.DIGITS)
    return families.oracle_of(chart.name)


def errors(chart: Chart) -> dict[str, dict[str, float]]:
    """Return errors by function and angle, up to the edge of the chart; for ``from_pose``, up to half a turn."""
    kernels, exact = importlib.import_module(f"dualcay.{chart.name}"), oracle_of(chart)
    found: dict[str, dict[str, float]] = {name: {} for name in MEASURED}
    for label, angle in ANGLES.items():
        if angle >= Compared(chart).edge:
            continue
        v = families.vectors(exact, angle, angle, SAMPLES)
        for name in MEASURED:
            if name != "from_pose" or angle < np.pi:
                branch = 0 if name == "from_pose" else None
                found[name][label] = float(f"{families.worst(kernels, exact, name, v, branch):.2g}")
    return found


def nanoseconds(charts: Sequence[Chart]) -> dict[str, dict[str, dict[str, float]]]:
    """Return ns per pose by chart, function and number of poses; charts are timed in turn, for correct ratios."""
    kernels = {chart.name: importlib.import_module(f"dualcay.{chart.name}") for chart in charts}
    found: dict[str, dict[str, dict[str, float]]] = {chart: {name: {} for name in TIMED} for chart in kernels}
    for size in GATED:
        poses = {chart: Poses.draw(module, size) for chart, module in kernels.items()}
        for name in TIMED:
            calls = {
                chart: partial(getattr(module, name), *arguments(name, poses[chart]))
                for chart, module in kernels.items()
            }
            for chart, ns in measured(calls, size).items():
                found[chart][name][str(size)] = float(f"{ns:.3g}")
    return found


def main() -> None:
    """Measure errors and speed of the committed charts."""
    console, charts = Console(), catalogue.committed()
    times = nanoseconds(charts)
    found: dict[str, Any] = {NEAREST: searched()}
    with progress(console) as bar:
        row = bar.add_task("charts", total=len(charts))
        for chart in charts:
            found[chart.name] = {"errors": errors(chart), "nanoseconds": times[chart.name]}
            bar.advance(row)
    put(Path(MEASUREMENTS), json.dumps(found, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    fix_allocator()
    main()
