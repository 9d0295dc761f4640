"""Exact angles: at the reference point, their values are close to values of the real functions."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from derive.algebra.angles import AngleField
from derive.algebra.element import Element, NotExactError

STEPS = 3
NEAR = 1e-3  # tolerance; at the reference point an angle and its tangent t ≤ 1/37 differ by t³/3


@pytest.fixture(scope="module")
def field() -> AngleField:
    return AngleField(("a", "b"), {"alpha": STEPS})


def at_reference(element: Element) -> float:
    at = element.ring.value
    return float(at(element.numerator) / at(element.denominator))


def test_reference_point_is_consistent(field: AngleField) -> None:
    values = {name: at_reference(field.symbol(name)) for name in field.names}
    assert values["pi"] == pytest.approx(math.pi, abs=1e-6)
    assert values["tan_alpha"] == pytest.approx(math.tan(values["alpha"] / (2 * STEPS)), rel=NEAR)
    assert len(set(values.values())) == len(values)
    assert min(values.values()) > 0


@pytest.mark.parametrize("quarters", range(-1, 5))
@pytest.mark.parametrize("k", range(-2 * STEPS, 2 * STEPS + 1))
def test_sine_and_cosine_at_the_reference_point(field: AngleField, k: int, quarters: int) -> None:
    angle = field.symbol("alpha") * Fraction(k, STEPS) + field.symbol("pi") * Fraction(quarters, 2)
    assert at_reference(field.sin(angle)) == pytest.approx(math.sin(at_reference(angle)), abs=NEAR)
    assert at_reference(field.cos(angle)) == pytest.approx(math.cos(at_reference(angle)), abs=NEAR)
    assert field.sin(angle) ** 2 + field.cos(angle) ** 2 == 1


@pytest.mark.parametrize("k", range(-2 * STEPS, 2 * STEPS + 1))
def test_atan2_inverts_sine_and_cosine(field: AngleField, k: int) -> None:
    angle = field.symbol("alpha") * Fraction(k, STEPS)
    length = field.symbol("a")
    assert field.atan2(length * field.sin(angle), length * field.cos(angle)) == angle


def test_other_angles_are_refused(field: AngleField) -> None:
    a, alpha = field.symbol("a"), field.symbol("alpha")
    for wrong in (a, alpha / (2 * STEPS), alpha * a, alpha + a, 1 / alpha, field.symbol("pi") / 3, field.constant(1)):
        with pytest.raises(NotExactError):
            field.sin(wrong)
    with pytest.raises(NotExactError):
        field.atan2(a, field.constant(1))
    with pytest.raises(NotExactError):
        field.atan2(-field.sin(alpha), a * field.cos(alpha))


def test_arithmetic_agrees_at_the_reference_point(field: AngleField) -> None:
    a, b = field.symbol("a"), field.symbol("b")
    x, y = at_reference(a), at_reference(b)
    made = [
        (a + b, x + y), (a - b, x - y), (2 - a, 2 - x), (a - 2, x - 2), (a * b, x * y), (a / b, x / y), (3 / a, 3 / x),
        (a**3, x**3), (a**-2, x**-2), (a**0, 1.0), (-a, -x), (+a, x), (abs(a - b), abs(x - y)),
        (abs(b - a), abs(x - y)), (a / b + b / a, x / y + y / x), (a / b + 1 / b, (x + 1) / y),
    ]  # fmt: skip
    for element, value in made:
        assert at_reference(element) == pytest.approx(value)
    root = ((a - b) * (a - b) / (4 * a * a)).sqrt()
    assert at_reference(root) == pytest.approx(abs(x - y) / (2 * x))
    assert (a * b) / (b * b) == a / b
    assert a != b
    assert not (a - a)
    with pytest.raises(ZeroDivisionError):
        a / (b - b)
