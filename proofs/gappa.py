"""Scripts of Gappa that bound the rounding errors of emitted C programs, from the transcripts of their text on disk.

A script holds a straight-line program twice: with every operation rounded to double, and in real arithmetic. Arguments
have |v| ≤ 1 and a translation of length at most 1.
"""

from __future__ import annotations

import math
import operator
import re
import shutil
from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import reduce
from typing import Any

import numpy as np
import sympy

from derive import workers
from derive.maps import Cayley
from derive.maps.polynomials import x

from .coq_definitions import V
from .statements import MachineError
from .transcript import Operand, Transcript

EPS = Fraction(1, 2**52)  # unit of bounds and errors, the distance from 1 to the next double
STEPS = 16  # steps of a bound per eps
SLACK = Fraction(102, 100)
"""Factor from a found bound to its claim. Gappa drops improvements of a result below 1 %, so its own bound may fail."""

SPLITS = 16
"""Parts of the range of |v|, each bounded alone. Twice as many lower the bounds by a sixth, in twice the time."""

SECONDS = 300  # of processor time for one script, ten times that of the slowest


def outputs(program: Transcript) -> tuple[int, ...]:
    """Return the outputs that are not constant."""
    return tuple(i for i, result in enumerate(program.results) if isinstance(result, str))


def reach(order: int, square: Any) -> Any:
    """Return the largest dual part of v for a translation of length 1, on any numbers; ``square`` is v·v.

    The dual part is T⁻¹ times the translation. T⁻¹ stretches vectors across v by |p/(2q) + i|v|/2|, which is
    (1 + v·v)^(n/2) / (2q), and vectors along v by (1 + v·v) / (2n), which is not larger for |v| ≤ 1.
    """
    coefficients = map(int, sympy.Poly(Cayley(order).q, x).all_coeffs())
    q = reduce(lambda value, coefficient: value * square + coefficient, coefficients)
    factors = [1 + square] * (order // 2) + [np.sqrt(1 + square)] * (order % 2)
    return reduce(operator.mul, factors) / (2 * q)


def premises(program: Transcript, order: int) -> Iterator[str]:
    """Yield what Gappa may assume: ranges, and exact values of steps, which are decided as polynomials.

    v is length times a vector, its dual part reach times another; neither is longer than 1, cosine is of their angle.
    """
    yield "length in [0, 1]"
    yield from (f"{name} in [-1, 1]" for name in ("cosine", *(f"{each}_unit" for each in V)))
    symbols = sympy.symbols(V)
    v, dual = symbols[:3], symbols[3:]
    dot, slope = (sum(a * b for a, b in zip(v, other, strict=True)) for other in (v, dual))
    forms = {
        sympy.expand(dot): "square",
        sympy.expand(slope): "length * reach * cosine",
        sympy.expand((1 + dot) ** order): " * ".join(["(1 + square)"] * order),
    }
    for name, found in program.values(dict(zip(V, symbols, strict=True)), sympy.sqrt).items():
        if found.is_polynomial(*symbols) and (form := forms.get(sympy.expand(found))):
            yield f"{name}_exact - ({form}) in [0, 0]"


def script(program: Transcript, order: int, claims: Mapping[int, str]) -> str:
    """Return the script of Gappa that proves claims on outputs, such as ``in ?`` or ``in [-1b-50, 1b-50]``."""
    largest = Transcript(lambda square: [reach(order, square)], ["square"], letter="r")
    lines = ["@rnd = float<ieee_64, ne>;", "square = length * length;"]
    lines += [f"{step.names[0]} = {step.text(_rounded)};" for step in largest.steps]
    lines += [f"reach = {largest.results[0]};"]
    lines += [f"{name} = {'length' if i < 3 else 'reach'} * {name}_unit;" for i, name in enumerate(V)]
    for mark, write in ((" rnd=", _rounded), ("_exact =", _exact)):
        lines += [f"{step.names[0]}{mark} {step.text(write)};" for step in program.steps]
    goals = [f"{program.results[i]} - {program.results[i]}_exact {claim}" for i, claim in claims.items()]
    known, wanted = map("\n/\\ ".join, (premises(program, order), goals))
    lines.append(f"{{ {known}\n->\n{wanted} }}")
    ratios = {step.operands[0] for step in program.steps if step.symbol == "/" and len({*step.operands}) == 1}
    hints = [f"{each} / {each} -> 1 {{{each} <> 0}};" for name in ratios for each in (name, _exact(name))]
    return "\n".join([*lines, *hints, f"$ length in {SPLITS};", ""])


def _rounded(operand: Operand) -> str:
    """Return an operand of a rounded operation; constants of the type double may hold folded operations."""
    if isinstance(operand, str):
        return operand
    if isinstance(operand, Fraction) or abs(operand) > 1 / EPS:
        raise MachineError(f"the constant {operand} is refused: only integers of C up to 2^52 are exact for certain")
    return f"({operand})"


def _exact(operand: Operand) -> str:
    """Return an operand of an exact operation."""
    return f"{operand}_exact" if isinstance(operand, str) and operand not in V else _rounded(operand)


def rounded_up(bound: Fraction) -> float:
    """Return a bound in eps a little larger than a found one, in whole steps."""
    return math.ceil(SLACK * bound / EPS * STEPS) / STEPS


def claim(bound: float) -> str:
    """Return the claim that an error is within a bound in eps."""
    steps = round(bound * STEPS)
    scale = int(math.log2(EPS / STEPS))
    return f"in [-{steps}b{scale}, {steps}b{scale}]"


def require() -> None:
    """Raise `MachineError` if Gappa is missing."""
    if shutil.which("gappa") is None:
        raise MachineError("Gappa is needed, and no gappa is found: install it with  apt-get install gappa", 3)


def run(text: str) -> tuple[dict[str, Fraction], str]:
    """Run a script; return the bounds that Gappa prints, by step, and its words on unproved claims."""
    command = ["gappa", "-Edichotomy=0", "-Wno-null-denominator"]
    try:
        done = workers.run(command, SECONDS, input=text)
    except workers.SlowError as error:
        return {}, str(error)
    printed = done.stdout + done.stderr
    _, failed, unproved = printed.partition("Error: some properties were not satisfied:")
    if done.returncode and not failed:
        raise MachineError(f"Gappa cannot read its script: {' '.join(printed.split())}")
    return bounds_of(printed), " ".join(unproved.split())


def bounds_of(printed: str) -> dict[str, Fraction]:
    """Return the largest sizes of the errors in Gappa's table of results, by step.

    Examples
    --------
    >>> bounds_of("  t2 - t2_exact in [-3b-2 {-0.75, -2^(-0.4)}, 0.5 {0.5, 2^(-1)}]")
    {'t2': Fraction(3, 4)}
    """
    number = r"(-?[\d.]+(?:b-?\d+)?)(?: \{[^}]*\})?"
    found = re.findall(rf"(t\d+) - \1_exact in \[{number}, {number}\]", printed)
    return {step: max(abs(_rational(low)), abs(_rational(high))) for step, low, high in found}


def _rational(text: str) -> Fraction:
    mantissa, _, exponent = text.partition("b")
    return Fraction(mantissa) * Fraction(2) ** int(exponent or 0)
