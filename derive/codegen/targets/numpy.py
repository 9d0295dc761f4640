"""NumPy: the committed kernels, with one plain text per program; batches run a recording (``_recorder.py``)."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping

from ...maps.chart import Chart
from ..lowered import Lowered, lower_chart
from ..package import Data, Facts, fingerprint
from ..rows import Table
from ..signatures import POSES, ROTATIONS
from ..validation import Machinery
from . import python
from .expression import WIDTH

WORDS = python.Words(
    options="*, axis: int = -1, out: Array | None = None",
    passed="axis, out",
    passed_alone="axis, None",
    placed="axis, out",
    makes=True,
)


class Numpy(python.PythonTarget):
    """Target of the committed kernels."""

    name = "numpy"
    words = WORDS
    tables = (POSES, ROTATIONS)
    imports_bases = True
    uncompiled = WORDS.plain
    machinery = Machinery(few="_runtime.POINTWISE_MAX", block="_kernel.BLOCK")
    unproved = "rounding errors, which are measured; NumPy itself; the recorder, which is tested"

    def shared(self) -> Mapping[str, Data]:
        return {
            **self.package(),
            **self.per_table(),
            "_branches.py": {},
            "_chart.py": {},
            "_checks.py": {},
            "_kernel.py": {},
            "_multiple.py": {},
            "_native.py": {},
            "_program.py": {},
            "_recorder.py": {},
            "_runtime.py": {},
            "_tools.py": {},
        }

    def geometry(self, table: Table) -> Data:
        return python.geometry(table)

    def programs(self, facts: Facts) -> Data:
        own = {"scalars": [], "helpers": []} if facts.chart.base else python.printed_scalars(facts)
        names = textwrap.wrap(", ".join(f"_{program.name}" for program in own["scalars"]) + ",", WIDTH - 8)
        found = {**own, "names": textwrap.indent("\n".join(names), " " * 8)}
        return {**found, "programs": fingerprint(facts, facts.lowered), **_multiple(facts.chart)}

    def rotations(self, facts: Facts, lowered: Lowered) -> Data:
        return {"programs": fingerprint(facts, lowered)}


def _multiple(chart: Chart) -> Data:
    """Return the base chart of a multiple, the factor, and the base's scalar programs that return integers."""
    base = chart.base
    programs = lower_chart(base).scalars.values() if base else ()
    constant = tuple(p.name for p in programs if not all(isinstance(output, str) for output in p.outputs))
    return {"base": base.name if base else None, "factor": chart.factor, "constant": constant}
