"""NumPy: the committed kernels, with programs as plain Python; batches run recorded programs (``_recorder.py``)."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from ..lowering.calculus import screw_twist
from ..lowering.forward import LOCAL, PROGRAMS
from ..lowering.point import traced
from ..lowering.scalar_programs import SCALARS, powers_of_factor
from ..package import Data, Facts, fingerprint
from ..rows import Function
from ..signatures import POSES, geometry, lower_chart
from .expression import items
from .python import CLASSES, PythonTarget, printed_program, printed_scalars

STEP_KERNELS = ("quaternion", "rate")  # kernels of the chart `LOCAL` that steps of a motion run


class Numpy(PythonTarget):
    """Target of the committed kernels."""

    name = "numpy"
    options = "axis: Axis = -1, out: Array | None = None"
    files = (
        *PythonTarget.files, "_arguments.py", "_covariances.py", "_curve.py", "_factors.py", "_kernel.py",
        "_listing.py", "_means.py", "_motion.py", "_multiple.py", "_native.py", "_numbers.py", "_other_vectors.py",
        "_packed.py", "_pose_files.py", "_pose_graph.py", "_prepared.py", "_program.py", "_propagate.py",
        "_recorder.py", "_ros.py", "_sequences.py", "_solving.py", "_spline.py", "_stepping.py", "_switching.py",
        "_trajectory.py", "_twist.py", "extended.py", "interop.py", "plot.py",
    )  # fmt: skip
    tools = ("dask", "extended", "interop", "plot")
    imports_bases = True

    def shared(self) -> dict[str, Callable[[], Data]]:
        tables = {
            CLASSES[table]: {name: signature(row) for name, row in sorted(table.public.items())}
            for table in self.tables
        }
        return {**super().shared(), "dask.py": partial(dict, tables=tables), "_derived.py": derived}

    def programs(self, facts: Facts) -> Data:
        """Return the scalar programs; for a multiple, its base, factor, and base programs with constant results."""
        base = facts.chart.base
        own = {"scalars": [], "helpers": []} if base else printed_scalars(facts.chart, facts.lowered.poses.scalars)
        inherited = lower_chart(base, POSES).scalars.values() if base else ()
        return {
            **own,
            "names": items((f"_{program.name}" for program in own["scalars"]), " " * 8),
            "programs": fingerprint(facts, facts.lowered.poses),
            "base": base.name if base else None,
            "factor": facts.chart.factor,
            "constant": tuple(p.name for p in inherited if not all(isinstance(output, str) for output in p.outputs)),
        }

    def rotations(self, facts: Facts) -> Data:
        return {"programs": fingerprint(facts, facts.lowered.rotations)}


def derived() -> Data:
    """Return the data for the formulas of run-time parts, with the scalars of the chart `LOCAL` that its steps call."""
    called = {call.function for name in STEP_KERNELS for call in geometry()[name].calls}
    scalars = {name: program for name, program in lower_chart(LOCAL).scalars.items() if name in called}
    return {
        "programs": [printed_program(traced(recipe)) for recipe in (*PROGRAMS, screw_twist)],
        "title": LOCAL.parameter,
        **printed_scalars(LOCAL, scalars),
        "powers": {name: powers_of_factor(name) for name in SCALARS},
    }


def signature(row: Function) -> str:
    """Return the shapes of the arguments and results of a function as NumPy writes them: ``(6),(6)->(6,6)``."""
    sides = (row.arguments, row.results)
    return "->".join(",".join(f"({','.join(map(str, array.shape))})" for array in side) for side in sides)
