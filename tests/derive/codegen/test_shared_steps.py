"""Helper programs that hold the steps which several scalar programs share."""

from __future__ import annotations

import pytest

from derive.codegen import catalogue
from derive.codegen.programs.program import Call, Program
from derive.codegen.programs.shared import with_helpers
from derive.codegen.signatures import lower_chart
from derive.maps import parameterization

OWN = parameterization("2*sinh(alpha/2)", "own")
"""Chart with two helpers from ``aa`` to ``w``, whose names must differ."""

CHARTS = {chart.name: chart for chart in (*catalogue.committed(), OWN) if not chart.base}


def computed(program: Program, helpers: dict[str, Program], known: dict[object, int]) -> tuple[list[object], set[int]]:
    """Return the numbers of a program's outputs and of all its values; equal values have equal numbers."""
    numbers: dict[object, int] = {}
    values: set[int] = set()
    for statement in program.statements:
        steps = helpers[statement.function].steps if isinstance(statement, Call) else (statement,)
        own = dict(numbers) if isinstance(statement, Call) else numbers
        for step in steps:
            value = step.op, tuple(own.get(arg, arg) if isinstance(arg, str) else (arg,) for arg in step.args)
            own[step.name] = known.setdefault(value, len(known))
            values.add(own[step.name])
        if isinstance(statement, Call):
            numbers |= {name: own[name] for name in statement.names if name != "_"}
    return [numbers.get(output, output) for output in program.outputs], values


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.thorough if name == OWN.name else ()) for name in CHARTS]
)
def test_callers_of_helpers_compute_the_same_values_and_no_others(name: str) -> None:
    programs = lower_chart(CHARTS[name]).scalars
    helpers, callers = with_helpers(programs)
    known: dict[object, int] = {}
    for key, program in programs.items():
        assert computed(callers[key], helpers, known) == computed(program, {}, known)
