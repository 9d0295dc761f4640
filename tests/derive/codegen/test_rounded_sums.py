"""Rounding errors of sums: programs compute them from the terms, and the exponential chart corrects for them."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import mpmath
import pytest

from derive.algebra.arithmetic import PLAIN
from derive.codegen.lowering.scalar_programs import SQUARES, scalar_program
from derive.codegen.programs.program import Program
from derive.codegen.programs.trace import Trace
from derive.codegen.targets import expression
from derive.maps.exponential import Exponential
from tests.support.sharp import Sharp

EPS = 2.0**-52


def compiled(program: Program) -> Callable[..., tuple[float, ...]]:
    """Return a program compiled to a function of numbers."""
    space: dict[str, Any] = {"m": Sharp()}
    inputs = ", ".join(name for name, _ in program.inputs)
    exec(f"def f({inputs}):\n{expression.body(program)}", space)
    return space["f"]


def traced(sum_of: Callable[[Trace, Sequence[Any]], Any], count: int = 3) -> Callable[..., tuple[float, ...]]:
    """Return the function that computes a sum and its rounding error."""
    trace = Trace()
    terms = [value for i in range(count) for value in trace.inputs(f"v{i}{i}", [f"v{i}{i}"])]
    total = sum_of(trace, terms)
    return compiled(trace.program("f", (total, trace.rounded_off(total))))


def drawn(count: int) -> list[list[float]]:
    generator = random.Random(5)
    return [[generator.uniform(-1, 1) * 2.0 ** generator.randint(-30, 30) for _ in range(count)] for _ in range(300)]


def test_error_of_two_terms_is_exact():
    of = traced(lambda trace, terms: trace.name("x", terms[0] + terms[1]), 2)
    found = [of(*terms) for terms in drawn(2)]
    assert any(rest for _, rest in found)
    for (total, rest), terms in zip(found, drawn(2), strict=True):
        assert Fraction(total) + Fraction(rest) == sum(map(Fraction, terms))


@pytest.mark.parametrize(
    "sum_of",
    [
        lambda trace, terms: trace.name("x", terms[0] + terms[1] + terms[2]),
        lambda trace, terms: terms[0] + (terms[1] + terms[2]),
    ],
)
def test_error_of_three_terms_is_rounded_once(sum_of: Callable[[Trace, Sequence[Any]], Any]):
    """Allow eps² of the largest term: the error of each addition is exact, and only their sum is rounded."""
    of, lost = traced(sum_of), 0.0
    for terms in drawn(3):
        total, rest = of(*terms)
        exact = sum(map(Fraction, terms))
        assert abs(exact - Fraction(total) - Fraction(rest)) <= EPS**2 * max(map(abs, terms))
        lost = max(lost, abs(float(exact - Fraction(total))) / max(map(abs, terms)))
    assert lost > EPS / 4


def test_error_of_anything_but_a_sum_is_0():
    trace = Trace()
    a, b = trace.inputs("v", ["a", "b"])
    assert [trace.rounded_off(value) for value in (a, a * b, a - b, 7)] == [0, 0, 0, 0]
    assert PLAIN.rounded_off(3.0) == 0


def off(x: Fraction, f: float, g: float) -> float:
    """Return the larger error of ``sin α`` and ``1 − cos α``, in eps."""
    with mpmath.workdps(40):
        xx = mpmath.mpf(x.numerator) / x.denominator
        angle = mpmath.sqrt(xx)
        return float(max(abs(f * angle - mpmath.sin(angle)), abs(g * xx - 1 + mpmath.cos(angle))) / EPS)


def test_exponential_corrects_for_the_rounded_sum_of_squares():
    """Expect errors up to 2 eps, as for an exact x, and larger errors for the uncorrected sum."""
    of, generator, worst, lost = compiled(scalar_program("pose_scalars", Exponential())), random.Random(7), 0.0, 0.0
    for _ in range(500):
        squares = [generator.uniform(0, 13) for _ in SQUARES]
        if 17 < (x := sum(map(Fraction, squares))) < 39:
            at = Exponential().scalars(sum(squares), Sharp())
            worst, lost = max(worst, off(x, *of(*squares)[:2])), max(lost, off(x, at.f, at.g))
    assert worst <= 2 < lost
