"""Multiple v = K w of a chart: its scalar programs are the base chart's at w = v/K, scaled by powers of K."""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping, Sequence
from fractions import Fraction
from operator import mul, truediv
from typing import Any, TypeAlias

from ._chart import Chart
from ._kernel import Result
from ._program import call

Function: TypeAlias = Callable[..., Any]

POWERS: Mapping[str, tuple[tuple[int, ...], tuple[int, ...]]] = {
    "quaternion_scalars": ((2,), (0, 1, 2, 3)),
    "pose_scalars": ((2, 2, 2), (1, 2, 3)),
    "tangent_scalars": ((2, 2, 2), (1, 2, 3, 3, 4, 5)),
    "tangent_dot_scalars": ((2, 2, 2), (1, 2, 3, 3, 4, 5, 5, 6, 7)),
    "rate_scalars": ((2,), (1,)),
    "inverse_scalars": ((2, 1), (-1, 1)),
    "inverse_at": ((2, 1, 0), (1,)),
    "tangent_inv_at": ((2, 1, 0), (-1, 1, 1, 3)),
    "tangent_inv_scalars": ((2,), (-1, 1, 1, 3)),
    "tangent_inv_dot_scalars": ((2,), (-1, 1, 1, 3, 3, 5)),
    "ray": ((2,), (0, 1, 0, 1, 2, 3)),
    "gain_unit": ((0, 0, 0, 0), (-1,)),
    "gain_positive": ((0, 0, 0, 0), (-1,)),
    "gain_product": ((0, 0, 0, 0, 0, 0), (-1,)),
    "direction": ((2, 2, 1), (0,)),
    "natural": ((2, 2, 1), (0, 1, 0)),
    "unfolded": ((2, 1), (0,)),
    "reached": ((0,), (0,)),
    "turned": ((1, 0, 0), (-1, 0, 1)),
    "beyond": ((2,), ()),
    "coefficient": ((0,), (-1, -1)),
    "coefficient_of": ((0, 0, 0), (-1, -1)),
}
"""Exponents of K by scalar program: divisors of its arguments, then divisors of its results; 0 for all others."""


def multiple(
    base: Chart, module: str, numerator: int, denominator: int, constant: Container[str], programs: str
) -> Chart:
    """Return the chart v = K w of a module, where w is a vector of the base chart and K = ``numerator/denominator``.

    ``constant`` names the scalar programs of the base chart that return integers.
    """
    scale = Fraction(numerator, denominator)
    programs_of_base = base.functions.items()
    functions = {name: _scaled(program, *POWERS[name], scale, name in constant) for name, program in programs_of_base}
    branches = base.branches, base.singular_angles, base.turns, base.returns
    return Chart(module, *branches, functions, base.kernels, programs)


def _scaled(
    program: Function, before: Sequence[int], after: Sequence[int], scale: Fraction, constant: bool
) -> Function:
    """Return a scalar program whose arguments and results are divided by powers of K."""
    changed = any(before)
    given, found = _divisions(before, scale), _divisions(after, scale)

    def run(m: Any, *arguments: Any) -> Result:
        inner = (*map(call, given[0], arguments, given[1]), *arguments[len(before) :]) if changed else arguments
        results = program(m, *inner)
        if constant:  # convert integers to the type of the arguments: 1/2 would be a float
            zero = arguments[0] - arguments[0]
            results = tuple([r + zero if type(r) is int else r for r in results])
        return tuple(map(call, found[0], results, found[1])) if after else results

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
