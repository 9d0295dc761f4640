"""Multiple v = K w of a chart: its scalar programs are the base chart's at w = v/K, scaled by powers of K."""

from __future__ import annotations

from collections.abc import Callable, Container, Sequence
from fractions import Fraction
from typing import Any, TypeAlias

from ._chart import Chart
from ._derived import POWERS

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
    """Return a scalar program whose arguments and results are divided by powers of K.

    It is compiled from text, for the shortest time of a single pose.
    """
    before, after = powers
    if not any((*before, *after)):
        return program
    given = ", ".join(_divided(f"a{place}", scale**power) for place, power in enumerate(before))
    names = ", ".join(f"r{place}" for place in range(len(after)))
    found = ", ".join(_result(f"r{place}", scale**power, constant) for place, power in enumerate(after))
    taken = ", ".join(f"a{place}" for place in range(len(before)))
    zero = "    zero = a0 - a0\n" if constant else ""  # integers take the type of the arguments
    text = f"def run(m, {taken}, *rest):\n    {names}, = program(m, {given}, *rest)\n{zero}    return {found},\n"
    made: dict[str, Any] = {"program": program}
    exec(text, made)
    run: Function = made["run"]
    return run


def _result(name: str, divisor: Fraction, constant: bool) -> str:
    """Return the text of a scaled result; an integer becomes a number, since 1/2 would be a float, but 0 stays."""
    scaled = _divided(name, divisor)
    if not constant or scaled == name:
        return scaled
    number = _divided(f"({name} + zero)", divisor)
    return f"{scaled} if type({name}) is not int else {name} and {number}"


def _divided(name: str, divisor: Fraction) -> str:
    """Return the text of a value divided by a fraction, by integer multiplication and division."""
    times = f" * {divisor.denominator}" if divisor.denominator > 1 else ""
    return f"{name}{times} / {divisor.numerator}" if divisor.numerator > 1 else f"{name}{times}"
