"""NumPy: the committed kernels. One plain text per program; batches run it recorded (``_recorder.py``)."""

from __future__ import annotations

from collections.abc import Container, Mapping

from ..facts import Facts
from ..fingerprint import fingerprint
from ..lowered import Lowered
from ..rows import Table
from ..signatures import POSES, ROTATIONS
from ..validation import Machinery
from . import python
from .target import Data

WORDS = python.Words(
    options="*, axis: int = -1, out: Array | None = None",
    passed="axis, out",
    passed_alone="axis, None",
    placed="axis, out",
    makes=True,
)


class Numpy(python.PythonTarget):
    """The target of the committed kernels."""

    name = "numpy"
    words = WORDS
    tables = (POSES, ROTATIONS)
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
            "_native.py": {},
            "_recorder.py": {},
            "_runtime.py": {},
            "_tools.py": {},
        }

    def geometry(self, table: Table) -> Data:
        return python.geometry(table)

    def programs(self, facts: Facts, lowered: Lowered, known: Container[str] = ()) -> Data:
        scalars = [python.printed_scalar(program) for name, program in lowered.scalars.items() if name not in known]
        return {"scalars": scalars, "programs": fingerprint(facts, lowered)}
