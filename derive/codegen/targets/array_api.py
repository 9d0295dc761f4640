"""The arrays of any library: plain Python on arrays of components, nothing written in place."""

from __future__ import annotations

from collections.abc import Mapping

from ..facts import Facts
from ..lowered import geometry
from . import infix, python
from .target import Data

WORDS = python.Words(
    value="Array",
    array_like="array",
    array="array",
    kept="the library, type and device of their arguments",
    options="*, axis: int = -1",
    passed="axis",
    passed_alone="axis",
)


class ArrayApi(python.PythonTarget):
    """The target that imports no array library and takes the arrays of each."""

    name = "array-api"
    unproved = "what array libraries do with arrays other than NumPy's arrays of objects; rounding errors"

    def shared(self) -> Mapping[str, Data]:
        programs = [python.printed(program, infix.body(program)) for program in geometry().values()]
        return {
            "__init__.py": {},
            "_chart.py": {},
            "_geometry.py": {"programs": programs, "rows": python.rows()},
            "_interface.py": python.interface(WORDS),
            "_runtime.py": {},
            "_tools.py": {},
            "py.typed": {},
        }

    def module(self, facts: Facts) -> Data:
        scalars = [
            python.printed(program, infix.body(program, alone=True), python.components(program))
            for program in facts.lowered.scalars.values()
        ]
        own = [python.printed(program, infix.body(program)) for program in facts.lowered.own.values()]
        return python.described(facts) | {"scalars": scalars, "own": own, "rows": python.rows()}
