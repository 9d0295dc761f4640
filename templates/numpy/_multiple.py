"""Multiple v = K w of a chart: its scalar programs are the base chart's at w = v/K, scaled by powers of K."""

from __future__ import annotations

from collections.abc import Callable, Container, Sequence
from fractions import Fraction
from operator import mul, truediv
from typing import Any, TypeAlias

from ._chart import Chart
from ._derived import POWERS
from ._kernel import Result
from ._program import call

Function: TypeAlias = Callable[..., Any]


def multiple(
    base: Chart, module: str, numerator: int, denominator: int, constant: Container[str], programs: str
) -> Chart:
    """Return the chart v = K w of a module, where w is a vector of the base chart and K = ``numerator/denominator``.

    ``constant`` names the scalar programs of the base chart that return integers.
    """
    scale = Fraction(numerator, denominator)
    functions = {name: _scaled(of, POWERS[name], scale, name in constant) for name, of in base.functions.items()}
    branches = base.branches, base.singular_angles, base.turns, base.returns
    return Chart(module, *branches, functions, base.kernels, programs, base.ends)


def _scaled(
    program: Function, powers: tuple[Sequence[int], Sequence[int]], scale: Fraction, constant: bool
) -> Function:
    """Return a scalar program whose arguments and results are divided by powers of K."""
    before, after = powers
    if not any((*before, *after)):
        return program
    given, found = _divisions(before, scale), _divisions(after, scale)
    if {*given[0], *found[0]} <= {truediv, _kept} and not constant:
        return _divided_alike(program, given[1], found[1])
    pairs = list(zip(found[0], found[1], strict=True))

    def run(m: Any, *arguments: Any) -> Result:
        results = program(m, *map(call, given[0], arguments, given[1]), *arguments[len(before) :])
        if not constant:
            return tuple([operation(r, by) for r, (operation, by) in zip(results, pairs, strict=True)])
        # integers take the type of the arguments, since 1/2 would be a float; 0 stays
        zero = arguments[0] - arguments[0]
        return tuple([
            operation(r, by) if type(r) is not int else r and operation(r + zero, by)
            for r, (operation, by) in zip(results, pairs, strict=True)
        ])

    return run


def _divided_alike(program: Function, given: Sequence[int], found: Sequence[int]) -> Function:
    """Return a scalar program whose arguments and results are all divided, in the shortest time for a single pose."""

    def run(m: Any, *arguments: Any) -> Result:
        return tuple(map(truediv, program(m, *map(truediv, arguments, given)), found))

    def of_squares(m: Any, first: Any, second: Any, third: Any) -> Result:
        return tuple(map(truediv, program(m, first / most, second / most, third / most), found))

    most = given[0]
    return of_squares if [*given] == [most] * 3 else run


def _divisions(powers: Sequence[int], scale: Fraction) -> tuple[list[Function], list[Any]]:
    """Return an operation and its second operand for each power of K; integers if one operation is enough."""
    operations: list[Function] = []
    operands: list[Any] = []
    for power in powers:
        divisor = scale**power
        if divisor.denominator == 1:
            operations.append(truediv if divisor != 1 else _kept)
            operands.append(divisor.numerator)
        elif divisor.numerator == 1:
            operations.append(mul)
            operands.append(divisor.denominator)
        else:
            operations.append(_divided)
            operands.append(divisor)
    return operations, operands


def _divided(value: Any, divisor: Fraction) -> Any:
    """Return a value divided by a fraction, by integer multiplication and division."""
    return value * divisor.denominator / divisor.numerator


def _kept(value: Any, _: int) -> Any:
    """Return a value unchanged."""
    return value
