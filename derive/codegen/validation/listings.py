"""Run the programs of a JSON file on numbers of any type, and compare their results with the formulas."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import Any

import mpmath

from ...algebra.arithmetic import PLAIN
from ...maps.chart import Chart
from ..rows import Table
from . import reals
from .batches import ValidationFailed, compare, composed
from .decimals import EXACT_DIGITS, Decimal
from .run import chosen

OPERATIONS: Mapping[str, Callable[..., Any]] = {
    "add": operator.add, "subtract": operator.sub, "multiply": operator.mul, "divide": PLAIN.div,
    "negate": operator.neg, "abs": PLAIN.abs, "sqrt": PLAIN.sqrt, "tan": PLAIN.tan, "atan2": PLAIN.atan2,
    "expm1": PLAIN.expm1, "log1p": PLAIN.log1p, "less": operator.lt, "equal": operator.eq, "and": PLAIN.both,
    "or": PLAIN.either, "select": PLAIN.where,
}  # fmt: skip
"""Operations by their names in files."""
OF_DECIMALS: Mapping[str, Callable[..., Any]] = {
    "tan": Decimal.tan, "expm1": Decimal.expm1, "log1p": Decimal.log1p,
    "atan2": lambda y, x: (y if isinstance(y, Decimal) else Decimal(y)).arctan2(x),
}  # fmt: skip
"""Operations of numbers of 50 digits."""


class Listing:
    """Programs of a chart as data. ``made`` turns its numbers into a type of numbers."""

    def __init__(
        self,
        data: Mapping[str, Any],
        made: Callable[[Mapping[str, str]], Any],
        operations: Mapping[str, Callable[..., Any]] = {},
    ) -> None:
        self.data = data
        self.operations = {**OPERATIONS, **operations}
        self.made = made
        self.numbers = {name: made(number) for name, number in self.data["numbers"].items()}

    def call(self, function: str, arguments: Sequence[Sequence[Any]], branch: int = 0) -> list[Any]:
        """Return the joined results of a public function for flat arguments."""
        row = self.data["functions"][function]
        given = [*(number for argument in arguments for number in argument), *map(self.made, row["constants"])]
        k = branch % self.data["branches"] if self.data["branches"] else branch
        if not k or not row["branch"]:
            return self.run(row["program"], given)
        if "instead" in row:
            return self.run(row["instead"], [*given, *self._turn(k)])
        return self.run(row["then"], [*self.run(row["program"], given), *self._turn(k)])

    def _turn(self, k: int) -> tuple[Any, Any]:
        """Return the pair of numbers that turns v by k branches."""
        if self.data["branches"]:
            cosine, sine = map(self.made, self.data["turns"][k])
            return cosine, sine
        cosine, sine = map(self.made, self.data["turns"][0])
        return cosine, k * sine

    def run(self, name: str, given: Sequence[Any]) -> list[Any]:
        """Return the results of a program."""
        program = self.data["programs"][name]
        known = {**self.numbers, **dict(zip(program["given"], given, strict=True))}

        def value(operand: Any) -> Any:
            return known[operand] if isinstance(operand, str) else operand

        for names, called, *operands in program["steps"]:
            values = list(map(value, operands))
            if isinstance(names, list):
                known |= dict(zip(names, self.run(called, values), strict=True))
            else:
                known[names] = self.operations[called](*values)
        return list(map(value, program["results"]))


def validate(files: Mapping[Table, str], read: Callable[[str, Table], Any], chart: Chart, geometry: bool) -> int:
    """Run the functions of a chart's files, one for each table; return the number of calls that equal the formula.

    ``read`` returns the data of a file. Algebraic functions run on symbols, others on numbers of 50 digits.
    `ValidationFailed` names the function.
    """
    count = 0
    with reals.digits(EXACT_DIGITS):
        for table, file in files.items():
            listing = Listing(_done(partial(read, file, table), file), _exact, OF_DECIMALS)
            for batch in (*chosen(chart, table, geometry), *composed(chart, table)):
                for case in batch.cases:
                    call = partial(listing.call, batch.function, case.arguments, *batch.branch)
                    compare(f"{file}: {batch.function}", _done(call, file), case.result, batch.agree)
                    count += 1
    return count


def _done(call: Callable[[], Any], file: str) -> Any:
    """Return what a function returns; its error becomes one that names the file."""
    try:
        return call()
    except ValidationFailed as error:
        raise ValidationFailed(f"{file}: {error}") from error
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        raise ValidationFailed(f"{file}: {type(error).__name__}: {error}") from error


def _exact(number: Mapping[str, str]) -> Any:
    """Return a rational number exactly, a decimal one with 50 digits."""
    if "rational" not in number:
        return Decimal(mpmath.mpf(number["decimal"]))
    value = Fraction(number["rational"])
    return int(value) if value.denominator == 1 else value
