"""Kinematic equations: each is the printed equation exactly, and its rates are those of the kernels."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
import pytest

import derive
from derive.algebra.arithmetic import Arithmetic
from derive.claims.deciding.polar import Polar
from derive.claims.language import values
from derive.claims.language.environment import Env
from derive.claims.language.printed import Symbol
from derive.claims.numbers.generators import Generators
from derive.claims.numbers.kinds import ORDER
from derive.motion_equations import KINDS, MotionEquation, motion_equation
from tests.support import motions
from tests.support.libraries import LIBRARIES, QUICKLY

ALL = [(number, None) for number in KINDS if number < "90"] + [(k, n) for k in ("90", "91") for n in (2, 3)]
EVERY = pytest.mark.parametrize(("number", "order"), ALL)
MIRRORED = {"70": "74", "75": "76", "83": "85", "90": "91"}
MIRRORED |= {body: space for space, body in MIRRORED.items()}
TWIST = {"space": ("omega", "omega_v"), "body": ("omega_B", "omega_vb")}
ANY = Symbol("any twist", "dual vector")


class ExactArithmetic(Arithmetic):
    """Operations on elements of an exact field, beyond the limit up to which the exponential uses series."""

    def __init__(self, field: Any) -> None:
        self.sqrt = field.sqrt
        self.tan = lambda a: field.sin(a) / field.cos(a)
        self.less = lambda a, b: False


@cache
def true_reading(number: str) -> Any:
    """Return the reading of a printed equation that is decided to be true."""
    (result,) = derive.verify("condurache-popa-2023", number)
    assert result.status in ("holds", "holds-if")
    return result.equation, result.verdicts[0].statement


def equals_printed(number: str, order: int | None, equation: MotionEquation) -> bool:
    """Return whether an equation has the right-hand side of a printed one, at generic dual states and twists."""
    entry, statement = true_reading(number)
    rate, printed = statement.arguments
    (state,) = rate.arguments
    twist = next(symbol for symbol in entry.definitions if symbol.name in TWIST[KINDS[number][0]])
    # tan(α/4) needs sine and cosine of eighths of an angle
    free = [symbol for symbol in entry.free(printed) if symbol.quantity is not ORDER]
    at = Polar([*free, ANY], 0, {}, partial(Generators, steps=8), dual=True, free=True)
    orders = {symbol: order for symbol in entry.free(printed) if symbol.quantity is ORDER}
    env = Env(at.field, {**at.values, **orders, twist: at.values[ANY]}, entry.definitions)
    found = equation.rate(env.value(state), at.values[ANY], ExactArithmetic(at.field))
    return values.equal(at.field, env.value(printed), found)


@EVERY
def test_right_hand_sides_are_the_printed_ones_exactly(number: str, order: int | None) -> None:
    equation = motion_equation(number, order)
    assert equals_printed(number, order, equation)
    # controls: the other frame, and the next order
    assert not equals_printed(number, order, motion_equation(MIRRORED[number], order))
    assert order is None or not equals_printed(number, order, replace(equation, chart=derive.Cayley(order + 1)))


@EVERY
def test_rates_are_those_of_the_kernels(number: str, order: int | None) -> None:
    equation = motion_equation(number, order)
    module, omega = motions.kernels(equation), np.arange(1.0, 7.0) / 7
    for v in module.from_pose(motions.pose(0.7)) * np.array([[1.0], [2.5]]):  # beyond the series of the exponential too
        found = equation.rhs(0, motions.state(equation, v), lambda t: omega)
        # a complex step of the kernels along v̇, accurate to rounding
        v_dot = (module.rate if equation.frame == "space" else module.body_rate)(v, omega)
        moved = motions.state(equation, v + 1e-30j * v_dot)
        np.testing.assert_allclose(found, moved.imag / 1e-30, rtol=0, atol=1e-13)


@EVERY
def test_batches_are_their_rows(number: str, order: int | None) -> None:
    equation = motion_equation(number, order)
    y = np.stack([motions.start(equation, t) for t in (0.0, 0.2, 0.9)], axis=-1)
    twists = np.arange(18.0).reshape(6, 3) / 20
    rates = equation.rhs(0, y, lambda t: twists)
    for i in range(3):
        np.testing.assert_array_equal(rates[:, i], equation.rhs(0, y[:, i], lambda t, i=i: twists[:, i]))


@pytest.mark.parametrize("number", ["70", "76", "91"])
def test_fractions_stay_fractions(number: str) -> None:
    equation = motion_equation(number, 3 if number == "91" else None)
    y = np.array([Fraction(k, 30) for k in range(1, equation.states + 1)])
    rate = equation.rhs(0, y, lambda t: np.array([Fraction(k) for k in range(6)]))
    assert all(isinstance(c, Fraction) for c in rate)


@pytest.mark.parametrize("number", list(KINDS)[::4])
def test_compiled_steps_have_the_same_rates(number: str) -> None:
    LIBRARIES["jax"]()
    import jax

    equation, omega = motion_equation(number, 3 if number >= "90" else None), np.arange(1.0, 7.0) / 7
    compiled = jax.jit(lambda y: equation.rhs(0, y, lambda t: jax.numpy.asarray(omega)), compiler_options=QUICKLY)
    y = motions.start(equation, 0.7)
    np.testing.assert_allclose(compiled(y), equation.rhs(0, y, lambda t: omega), rtol=1e-14, atol=1e-14)


def test_wrong_calls_say_what_is_expected() -> None:
    equation = motion_equation("90", 1)
    still = np.zeros(6)
    for said, call in {
        "expected the number of a kinematic equation, 70, 74, ": lambda: motion_equation("88"),
        r"\(91\) needs an order": lambda: motion_equation("91"),
        r"\(83\) has no order, got 2": lambda: motion_equation("83", 2),
        r"expected 6 components of a state of \(90\), got 8": lambda: equation.rhs(0, np.zeros(8), lambda t: still),
        "expected 6 components of the twist, got 3": lambda: equation.rhs(0, still, lambda t: still[:3]),
    }.items():
        with pytest.raises(ValueError, match=said):
            call()
    with pytest.raises(ValueError, match="order"):
        motion_equation("90", 0)
