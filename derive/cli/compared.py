"""What is compared of a chart: its shape, what it stretches, what it costs, and what was measured of it."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any, TypeAlias

from ..codegen import catalogue
from ..codegen.lowered import lower_chart
from ..maps import PhiError
from ..maps.any_phi.stretch import Stretch, stretch
from ..maps.chart import Chart
from ..maps.families import alpha

ANGLES = {"π/2": math.pi / 2, "π": math.pi, "3π/2": 3 * math.pi / 2}
"""Where singular values are shown, and errors."""

COUNTED = ("pose", "from_pose", "tangent", "rate", "compose")
"""Functions whose operations are."""

MEASURED = ("pose", "tangent", "from_pose")
"""Functions whose errors were measured."""

TIMED = ("pose", "from_pose")
"""Functions whose times were."""

MEASUREMENTS = catalogue.CHECKOUT / "docs" / "parameterizations.json"
"""By chart, as ``python -m benchmarks.charts`` writes it; a checkout has it."""


@cache
def measurements() -> Mapping[str, Any]:
    """Errors and times by chart; of no chart where there is no checkout."""
    if not (catalogue.is_checkout() and MEASUREMENTS.is_file()):
        return {}
    found: dict[str, Any] = json.loads(MEASUREMENTS.read_text(encoding="utf-8"))
    return found


@dataclass(frozen=True)
class Compared:
    """A chart, and its figures."""

    chart: Chart

    @cached_property
    def edge(self) -> float:
        edge = self.chart.edge
        return math.inf if edge.is_infinite else float(edge.evalf(20))

    @property
    def range(self) -> float:
        """The |v| at the edge."""
        size = self.chart.phi.subs(alpha, self.chart.edge)
        return math.inf if size.is_infinite else float(size.evalf(20))

    @cached_property
    def stretches(self) -> dict[str, Stretch | None]:
        """At the angles shown; None where the chart has ended."""
        return {name: stretch(self.chart.phi, a) if a < self.edge else None for name, a in ANGLES.items()}

    @cached_property
    def operations(self) -> dict[str, int | None]:
        """By function; None of a φ that kernels do not compute."""
        try:
            found = lower_chart(self.chart).operations
        except PhiError:
            return dict.fromkeys(COUNTED)
        return {name: found[name].total() for name in COUNTED}

    @property
    def measured(self) -> Mapping[str, Any] | None:
        """Its ``errors`` by function and angle, its ``nanoseconds`` by function and number of poses, if known."""
        return measurements().get(self.chart.name)


def number(value: float | None) -> str:
    """A figure in few digits; a dash for none."""
    if value is None:
        return "-"
    if math.isinf(value):
        return "∞"
    return f"{value:.3g}" if value < 1000 else f"{value:.0f}"


Rows: TypeAlias = tuple[Sequence[str], Sequence[Sequence[str]]]
"""Headings, and a row for each chart that was measured."""


def errors(compared: Sequence[Compared]) -> Rows:
    """In eps, by function and angle."""
    found = {row.chart.name: row.measured["errors"] for row in compared if row.measured}
    places = [(name, angle) for name in MEASURED for angle in ANGLES if any(angle in m[name] for m in found.values())]
    headings = ["chart", *(f"{name} {angle}" for name, angle in places)]
    return headings, [[chart, *(number(m[name].get(angle)) for name, angle in places)] for chart, m in found.items()]


def times(compared: Sequence[Compared]) -> Rows:
    """In nanoseconds for a pose, by function and number of poses."""
    found = {row.chart.name: row.measured["nanoseconds"] for row in compared if row.measured}
    sizes = dict.fromkeys(size for m in found.values() for size in m[TIMED[0]])
    places = [(name, size) for name in TIMED for size in sizes]
    headings = ["chart", *(f"{name} N = {size}" for name, size in places)]
    return headings, [[chart, *(number(m[name][size]) for name, size in places)] for chart, m in found.items()]
