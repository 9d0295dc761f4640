"""Tables of quantities and kinds: values at points, special values, and generic values in an exact field."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import pytest

from derive.algebra import Dual, Quaternion, Tensor, Vector, real_part
from derive.papers.claim import Claim, Place
from derive.papers.equation import equation
from derive.papers.language.operator_table import equal
from derive.papers.language.printed import Symbol
from derive.papers.numbers.balls import Ball, Balls, arb, precision
from derive.papers.numbers.draw import Draw, polynomial, sphere
from derive.papers.numbers.generic import Generic
from derive.papers.numbers.kinds import KINDS, drawn, special
from derive.papers.numbers.quantities import QUANTITIES

EXACT = [quantity for quantity in QUANTITIES.values() if quantity.exact is not None]
IN_PYTHON = [name for name, kind in KINDS.items() if QUANTITIES[name].exact and not kind.constant]


def at_special(name: str, label: str):
    """Return the value of a letter at special coordinates."""
    letter = Symbol("a", name)
    claim = Claim(equation("1", "", 1, equal(letter, letter)), equal(letter, letter))
    return claim.value(letter, Place("", {letter: special(KINDS[name])[label]}))


@pytest.mark.parametrize("quantity", EXACT, ids=lambda quantity: quantity.name)
@pytest.mark.parametrize("dual", [False, True])
def test_generic_value_is_of_the_type_of_values_at_points(quantity, dual: bool) -> None:
    symbol = Symbol("a", quantity.name)
    value = Generic([symbol], dual, moving=False).values[symbol]
    built = drawn(quantity.name, Draw("type"))
    assert all(hasattr(value, part) == hasattr(built, part) for part in ("norm2", "dot", "rows"))


def test_every_quantity_with_a_generic_value_has_coordinates() -> None:
    assert {quantity.name for quantity in EXACT} == set(KINDS)


# ---- special values --------------------------------------------------------------------------------------------------

SIZES = {
    "real": {"0": 0, "1": 1, "-1": -1}, "real angle": {"1*pi/2": "pi/2", "2*pi": "2*pi", "0": 0},
    "rotation": {"identity": 3, "half turn": -1}, "unit quaternion": {"one": 1, "minus one": -1, "half turn": 0},
    "orthogonal tensor": {"identity": 3, "half turn": -1}, "unit vector": {"third axis": 1, "in plane": 1},
    "dual vector": {"0": 0, "unit": 1}, "scale": {"minus one": -1},
}  # fmt: skip
"""Number, squared vector, scalar part or trace at special values; of a dual kind the real part."""


def size(value):
    if isinstance(value, Vector):
        value = value.dot(value)
    return real_part(
        value.scalar if isinstance(value, Quaternion) else value.trace() if isinstance(value, Tensor) else value
    )


@pytest.mark.parametrize(("name", "label"), [(name, label) for name, rows in SIZES.items() for label in rows])
def test_special_values_have_the_expected_size(name: str, label: str) -> None:
    with precision(256):
        expected = {"pi/2": Balls().pi / 2, "2*pi": 2 * Balls().pi}.get(SIZES[name][label], SIZES[name][label])
        assert Balls().same(size(at_special(name, label)), expected)


def test_singular_tensor_has_no_inverse() -> None:
    assert real_part(at_special("tensor", "singular").det()) == 0


# ---- constants, and quantities that separate real and dual parts -----------------------------------------------------


def test_constants_have_their_values() -> None:
    field = Balls()
    values = {quantity.name: quantity.value(field) for quantity in QUANTITIES.values() if quantity.value is not None}
    assert values == {"dual unit": Dual(0, 1), "identity": Tensor.identity(), "π": Balls().pi, "words": None}
    assert {quantity.name for quantity in QUANTITIES.values() if not quantity.varies} == {*values, "∞", "index"}


def test_quantities_with_separate_real_and_dual_parts() -> None:
    apart = {quantity.name for quantity in QUANTITIES.values() if quantity.apart}
    real = {name for name, kind in KINDS.items() if not kind.dual} - {"rotation", "smooth function"}
    assert apart == {*real, "real tensor", "real quaternion", "proposition", "line", "dual unit"}


def test_exact_values_have_the_declared_number_of_symbols() -> None:
    for quantity in EXACT:
        point = Generic([Symbol("a", quantity.name)], dual=False, moving=False, framed=False)
        declared = {name for name in point.field.functions.names if name[:1] == "a" and name[1:].isdecimal()}
        assert len(declared) == quantity.size


# ---- seeded values ---------------------------------------------------------------------------------------------------


def test_numbers_are_short_and_away_from_zero() -> None:
    draw = Draw("range")
    signed = [draw.signed() for _ in range(100)]
    assert {a > 0 for a in signed} == {False, True}
    assert all(Fraction(1, 5) <= abs(a) <= Fraction(9, 10) for a in signed)
    assert [Draw("a").signed() for _ in range(3)] == [Draw("a").signed() for _ in range(3)]


@pytest.mark.parametrize("moving", [False, True])
def test_layout_of_parts(moving: bool) -> None:
    draw = Draw("parts", moving)
    vector = draw.still((1, 2, 3), (4, 5, 6))
    other = draw.vector((1, 2, 3), (4, 5, 6))
    number = draw.number(7, 8)
    if moving:
        assert all(part.du == 0 for c in vector for part in (c.re, c.du))
        assert all(part.du != 0 for c in (*other, number) for part in (c.re, c.du))
        now = [Dual(c.re.re, c.du.re) for c in (*vector, *other, number)]
    else:
        now = [*vector, *other, number]
    expected = [Dual(1, 4), Dual(2, 5), Dual(3, 6)]
    assert now == [*expected, *expected, Dual(7, 8)]


def test_parts_not_given_are_drawn() -> None:
    draw = Draw("rest")
    assert all(c.re != 0 != c.du for c in draw.vector())
    assert [c.re for c in draw.vector(re=(1, 2, 3))] == [1, 2, 3]
    assert [c.du for c in draw.vector(du=(1, 2, 3))] == [1, 2, 3]
    assert draw.number(0).du != 0
    assert draw.number(1, 0).du == 0


def test_projected_points_lie_on_the_sphere() -> None:
    numbers = [Dual(Fraction(re), Fraction(du)) for re, du in (("2", "5"), ("0.3", "-1"), ("0", "1"))]
    for s, t in product(numbers, repeat=2):
        u = sphere(s, t)
        assert u.dot(u) == Dual(1, 0)
        for side, c in ((s, u.c1), (t, u.c2)):  # stereographic projection from (0, 0, −1)
            assert side * (1 + u.c3) == c


@pytest.mark.parametrize("half", ["0.3", "1.3", "2.9"])
def test_quaternions_have_the_half_angle_asked_for(half: str) -> None:
    with precision(256):
        angle, field = Ball(arb(Fraction(half))), Balls()
        q = Draw(half).quaternion(angle)
        assert field.same(q.scalar.re, field.cos(angle))
        assert field.same(q.norm2().re, 1)
        assert field.same(q.norm2().du, 0)


# ---- functions -------------------------------------------------------------------------------------------------------


def test_polynomials_have_these_values() -> None:
    f = polynomial([1, 2, 3])
    assert [f(a) for a in (0, 1, 2, -1)] == [1, 6, 17, 2]
    assert [f.derivative(a) for a in (0, 1, 2, -1)] == [2, 8, 14, -4]


def test_special_function_is_the_exponential() -> None:
    with precision(256):
        f, at = at_special("smooth function", "exponential"), Ball(arb(Fraction(7, 10)))
        assert Balls().same(f(at), Balls().exp(at))
        assert Balls().same(f.derivative(at), Balls().exp(at))


def test_derivatives_match_the_function() -> None:
    f, a = drawn("smooth function", Draw("f")), Fraction(7, 10)
    assert f(Dual(a, 2)) == Dual(f(a), 2 * f.derivative(a))
