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
    changed, scaled = any(before), any(after)
    given, found = _divisions(before, scale), _divisions(after, scale)

    def run(m: Any, *arguments: Any) -> Result:
        inner = (*map(call, given[0], arguments, given[1]), *arguments[len(before) :]) if changed else arguments
        results = program(m, *inner)
        if constant:  # convert integers to the type of the arguments: 1/2 would be a float
            zero = arguments[0] - arguments[0]
            results = tuple([r + zero if type(r) is int else r for r in results])
        return tuple(map(call, found[0], results, found[1])) if scaled else results

    return run


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
