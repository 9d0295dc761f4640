"""Tables of quantities and kinds: values at points, and special values."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import pytest

from derive.algebra import Dual, Quaternion, Tensor, Vector, real_part
from derive.claims.deciding.claim import Claim
from derive.claims.deciding.place import Place
from derive.claims.equation import equation
from derive.claims.language.operator_table import equal
from derive.claims.language.printed import Symbol
from derive.claims.numbers.balls import Balls, precision
from derive.claims.numbers.kinds import KINDS, QUANTITIES, special, sphere


def at_special(name: str, label: str):
    """Return the value of a letter at special coordinates."""
    letter = Symbol("a", name)
    claim = Claim(equation("1", equal(letter, letter)), equal(letter, letter))
    return claim.value(letter, Place("", {letter: special(KINDS[name])[label]}))


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
    real = {name for name, kind in KINDS.items() if not kind.dual} - {"rotation"}
    assert apart == {*real, "dual unit", "function of parts"}


# ---- builders of values ----------------------------------------------------------------------------------------------


def test_projected_points_lie_on_the_sphere() -> None:
    numbers = [Dual(Fraction(re), Fraction(du)) for re, du in (("2", "5"), ("0.3", "-1"), ("0", "1"))]
    for s, t in product(numbers, repeat=2):
        u = sphere((1, s, t))
        assert u.dot(u) == Dual(1, 0)
        for side, c in ((s, u.c1), (t, u.c2)):  # stereographic projection from (0, 0, −1)
            assert side * (1 + u.c3) == c
