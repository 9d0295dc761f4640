"""Coverage of validation cases: every comparison in the programs is true in some case and false in another."""

from __future__ import annotations

import operator
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import pytest

from derive.codegen.programs.program import Call, Program
from derive.codegen.signatures import POSES, ChartPrograms, geometry, lower_chart
from derive.codegen.validation import decimals, reals, samples
from derive.codegen.validation.calls import Case, grouped
from derive.codegen.validation.decimals import Decimal
from derive.maps import Cayley

OPERATIONS: Mapping[str, Callable[..., Any]] = {
    "add": operator.add, "beside": operator.add, "sub": operator.sub, "mul": operator.mul, "div": operator.truediv,
    "neg": operator.neg, "abs": abs, "sqrt": Decimal.sqrt, "tan": Decimal.tan, "atan2": Decimal.arctan2,
    "reciprocal": lambda like, integer: 1 / integer, "expm1": Decimal.expm1, "log1p": Decimal.log1p,
    "lt": operator.lt, "eq": operator.eq,
    "and": operator.and_, "or": operator.or_, "where": lambda which, a, b: a if which else b,
}  # fmt: skip
COMPARISONS = ("lt", "eq")

Sides = Mapping[tuple[str, str], set[bool]]
"""Observed truth values of each comparison, by program and name."""


class Watched:
    """Runner of a chart's programs on numbers of 50 digits; it records the truth values of comparisons."""

    def __init__(self, chart: Cayley) -> None:
        self.chart = chart
        self.lowered: ChartPrograms = lower_chart(chart)
        self.programs = geometry()
        self.sides: dict[tuple[str, str], set[bool]] = defaultdict(set)

    def call(self, case: Case) -> None:
        row, branch = case.row, [] if case.branch is None else [case.branch % self.chart.branches]
        turn = self.chart.turn(*branch) if any(branch) else ()
        given = [Decimal(c) for argument in case.arguments for c in argument]
        if "table" not in dict(self.programs[row.kernel].inputs):
            found = self.run(self.programs[row.kernel], given)
            if turn:
                self.run(self.programs["turn"], found, turn)
        elif table := turn if branch else [c for back in self.chart.returns() for c in back]:
            self.run(self.programs[row.kernel], given, table)

    def run(self, program: Program, given: Sequence[Any], table: Sequence[Any] = ()) -> list[Any]:
        names = [name for _, group in program.inputs for name in group]
        known: dict[Any, Any] = dict(zip(names, [*given, *map(Decimal, table)]))
        for statement in program.statements:
            arguments = [known[a] if isinstance(a, str) else Decimal(Fraction(a)) for a in statement.args]
            if isinstance(statement, Call):
                rest = table if statement.rest else ()
                found = self.run(self.lowered.scalars[statement.function], arguments, rest)
                known |= zip(statement.names, found, strict=True)
            else:
                known[statement.name] = OPERATIONS[statement.op](*arguments)
                if statement.op in COMPARISONS:
                    self.sides[program.name, statement.name].add(bool(known[statement.name]))
        return [known[output] if isinstance(output, str) else output for output in program.outputs]


def sides(n: int, some: slice = slice(None)) -> Sides:
    """Return the truth values of all comparisons; ``some`` selects cases of each function and branch."""
    watched = Watched(Cayley(n))
    with reals.digits(decimals.EXACT_DIGITS):
        for _, cases in grouped(samples.at_numbers(watched.chart, POSES)):
            for case in cases[some]:
                watched.call(case)
    return watched.sides


NOISE = ("adrift", "clear_of_turn", "sharp")
"""Comparisons with rounding noise at whole turns, which numbers of 50 digits do not have."""
BY_CHART = (("to_exponential", "steep"), ("coefficient_of", "t3"), ("coefficient_of", "nextto"))
"""Comparisons with one side in a chart: φ bends one way, and interpolation stays on the side of its start."""


def one_sided(found: Sides) -> list[tuple[str, str]]:
    """Return the comparisons with one side only, but for those of which the tests of whole turns take both."""
    both = (at for at in found if at[1] not in NOISE and at not in BY_CHART)
    return [comparison for comparison in both if len(found[comparison]) < 2]


@pytest.mark.parametrize("n", [3, *(pytest.param(n, marks=pytest.mark.thorough) for n in (4, 8))])
def test_every_comparison_is_true_and_false_in_some_case(n: int) -> None:
    # at orders 1 and 2, some comparisons change only at the edge of the chart
    found = sides(n)
    assert len(found) > 15
    assert one_sided(found) == []


def test_fewer_cases_leave_comparisons_one_sided() -> None:
    assert len(one_sided(sides(3, slice(1)))) > 5


def test_lattice_directions_differ_and_have_one_to_three_components():
    """Expect |v| = 1, √2 and √3, and components of both signs."""
    squares = sorted(sum(c * c for c in u) for u in samples.LATTICE)
    assert squares == [1, 1, 2, 3, 3]
    assert len({frozenset((u, tuple(-c for c in u))) for u in samples.LATTICE}) == len(squares)
    assert {c for u in samples.LATTICE for c in u} == {-1, 0, 1}
