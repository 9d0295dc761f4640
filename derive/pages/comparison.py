r"""Charts side by side: how far they reach, how they stretch, what they cost.

The singular value of Re T along the axis is ``1/φ′``. In the plane across the axis Re T is ``f I + g skew(v)``, and the
singular value is ``2 sin(α/2)/φ``, from ``f² + x g² = 2 g``.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mpmath
import sympy

from .. import about
from ..codegen import catalogue
from ..codegen.signatures import lower_chart
from ..maps import PhiError
from ..maps.chart import Chart
from ..maps.elementary import alpha, evaluate
from ..output.shown import Listing, Step, bar

ANGLES = {"π/2": math.pi / 2, "π": math.pi, "3π/2": 3 * math.pi / 2}
"""Angles at which singular values and errors are shown."""

COUNTED = ("pose", "from_pose", "tangent", "rate", "compose")
MEASURED = ("pose", "tangent", "from_pose")
TIMED = ("pose", "from_pose")
"""Functions with counted operations, functions with measured errors, and functions with measured times."""

MEASUREMENTS = "docs/parameterizations.json"
"""File of measurements in a checkout; the command ``python -m benchmarks.charts`` writes it."""

NEAREST = "nearest to a rotation"
"""Measurement of the φ that stretches least."""


def measurements(name: str) -> Any:
    """Return what is measured of a chart, or the `NEAREST`; None if nothing is known."""
    root = about.checkout()
    return json.loads((root / MEASUREMENTS).read_text(encoding="utf-8")).get(name) if root else None


@dataclass(frozen=True)
class Stretch:
    """Value of φ and both singular values at an angle: ``1/φ′`` along the axis, ``2 sin(α/2)/φ`` across it."""

    size: float
    along: float
    across: float

    @property
    def condition(self) -> float:
        """Quotient of the largest and the smallest singular value."""
        return max(self.along, self.across) / min(self.along, self.across)


def stretch(phi: sympy.Expr, angle: float) -> Stretch:
    """Return φ and both singular values at an angle ≥ 0."""
    at = mpmath.mpf(angle)
    slope = float(mpmath.re(evaluate(phi.diff(alpha), alpha, at)))
    if angle == 0:
        return Stretch(0.0, 1 / slope, 1 / slope)
    size = float(mpmath.re(evaluate(phi, alpha, at)))
    return Stretch(size, 1 / slope, 2 * math.sin(angle / 2) / size)


def as_float(value: sympy.Expr) -> float:
    return math.inf if value.is_infinite else float(value.evalf(20))


@dataclass(frozen=True)
class Compared:
    """Chart with the figures that are compared."""

    chart: Chart

    @cached_property
    def edge(self) -> float:
        return as_float(self.chart.edge)

    @property
    def range(self) -> float:
        """Value of |v| at the edge of the chart."""
        return as_float(self.chart.range)

    @cached_property
    def stretches(self) -> dict[str, Stretch | None]:
        """Singular values at `ANGLES`; None beyond the edge."""
        return {name: stretch(self.chart.phi, a) if a < self.edge else None for name, a in ANGLES.items()}

    @cached_property
    def refusal(self) -> str:
        """Reason for which kernels cannot compute the chart; empty if they can."""
        try:
            self.chart.require_kernels()
        except PhiError as error:
            return str(error)
        return ""

    @cached_property
    def operations(self) -> dict[str, int | None]:
        """Number of operations by function; None for a φ that kernels cannot compute."""
        if self.refusal:
            return dict.fromkeys(COUNTED)
        found = lower_chart(self.chart).operations
        return {name: found[name].total() for name in COUNTED}

    @cached_property
    def measured(self) -> Mapping[str, Any] | None:
        """Measured ``errors`` by function and angle, and ``nanoseconds`` by function and number of poses, if known."""
        found: Mapping[str, Any] | None = measurements(self.chart.name)
        return found

    def cells(self) -> dict[str, str]:
        """Return the row in a table of charts."""
        conditions = {name: number(found.condition if found else None) for name, found in self.stretches.items()}
        return {
            "chart": self.chart.name,
            "φ": f"${sympy.latex(self.chart.written)}$",
            "edge/π": number(self.edge / math.pi),
            **{f"condition of Re T at {name}": condition for name, condition in conditions.items()},
            **{f"operations of {name}": number(count) for name, count in self.operations.items()},
        }

    def __repr__(self) -> str:
        return f"<Compared {self.chart.name}: v = {self.chart.parameter} u, edge at {number(self.edge / math.pi)} π>"


def number(value: float | None) -> str:
    """Format a number with few digits, and None as a dash."""
    if value is None:
        return "-"
    if math.isinf(value):
        return "∞"
    return f"{value:.3g}" if value < 1000 else f"{value:.0f}"


def compare(orders: Iterable[int] = (), families: Iterable[str] = (), phi: str | None = None) -> Listing[Compared]:
    """Compare parameterizations by largest angle, condition of the tangent operator, and operations.

    Parameters
    ----------
    orders : iterable of int
        Orders n of Cayley maps.
    families : iterable of str
        Names of parameterizations, such as ``"lambert"`` or ``"sine7"``.
    phi : str, optional
        Formula φ of a chart of your own, such as ``"alpha/(1 + alpha**2/40)"``.

    Returns
    -------
    list of Compared
        Rows of a table, as notebooks show it; by default n = 1 … 4 and the committed families but multiples. Each has
        its ``chart``, ``edge`` (rad), ``range`` (length of v there), ``stretches`` by angle, and ``operations`` by
        function.

    Raises
    ------
    ValueError
        If an order or a family does not exist, or φ is refused.

    Examples
    --------
    >>> import derive
    >>> derive.compare([2], ["lambert"])
    [<Compared cayley2: v = tan(α/4) u, edge at 2 π>,
     <Compared lambert: v = sin(α/4) u, edge at 2 π>]
    """
    chosen = charts(orders, families, phi)
    with bar(len(chosen)) as step:
        return Listing(compared(chosen, step))


def charts(orders: Iterable[int], families: Iterable[str], phi: str | None) -> list[Chart]:
    """Return the charts to compare: n = 1 … 4 and the committed families but multiples of others, if none is named."""
    chosen = catalogue.charts(orders, families) + (catalogue.charts((), (), phi, "phi") if phi is not None else [])
    return chosen or [chart for chart in catalogue.charts((1, 2, 3, 4), about.FAMILIES) if not chart.base]


def compared(chosen: Sequence[Chart], step: Step) -> list[Compared]:
    """Return the figures of charts, with their operations counted; a step reports each."""
    rows = []
    for chart in chosen:
        step(chart.name)
        rows.append(Compared(chart))
        _ = rows[-1].operations  # counted now, while progress is shown
    return rows
