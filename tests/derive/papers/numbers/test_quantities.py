"""Table of quantities: seeded values, and generic values in an exact field."""

from __future__ import annotations

import mpmath
import pytest

from derive.algebra import Dual, Quaternion, Tensor, Vector, real_part
from derive.papers.language.printed import Symbol
from derive.papers.numbers.draw import Draw
from derive.papers.numbers.fields import FIELD_DIGITS, Decimal60
from derive.papers.numbers.generic import Generic
from derive.papers.numbers.quantities import QUANTITIES

DRAWN = [quantity for quantity in QUANTITIES.values() if quantity.draw is not None]
EXACT = [quantity for quantity in QUANTITIES.values() if quantity.exact is not None]


def test_unit_draws_are_unit() -> None:
    with mpmath.workdps(FIELD_DIGITS):
        field = Decimal60()
        for make in (QUANTITIES["unit quaternion"].generic, *QUANTITIES["unit quaternion"].special.values()):
            norm = make(Draw("unit")).norm2()
            assert field.same(norm.re, 1)
            assert field.same(norm.du, 0)


@pytest.mark.parametrize("quantity", EXACT, ids=lambda quantity: quantity.name)
@pytest.mark.parametrize("dual", [False, True])
def test_generic_value_is_of_the_type_that_is_drawn(quantity, dual: bool) -> None:
    symbol = Symbol("a", quantity.name)
    value = Generic([symbol], dual, moving=False).values[symbol]
    drawn = quantity.generic(Draw("type"))
    assert hasattr(value, "norm2") == hasattr(drawn, "norm2")
    assert hasattr(value, "dot") == hasattr(drawn, "dot")
    assert hasattr(value, "rows") == hasattr(drawn, "rows")


def test_quantities_without_values_are_refused() -> None:
    assert set(DRAWN) - set(EXACT) == {QUANTITIES["sign"]}
    assert set(EXACT) <= set(DRAWN)
    with pytest.raises(ValueError, match="a symbol that is a map has no value of its own"):
        QUANTITIES["map"].generic(Draw("s"))


# ---- special values --------------------------------------------------------------------------------------------------

PI = 3.14159265358979
BEYOND, TURNED = (-0.999, -0.1), (-0.999, 2.999)
SPECIAL = {
    "sign": {"−": (-1, -1)},
    "real": {"0": (0, 0), "negative": (-0.9, -0.2)},
    "real angle": {"0": (0, 0), "π/2": (PI / 2, PI / 2), "π": (PI, PI), "beyond π": (3.2, 6.2), "2π": (2 * PI, 2 * PI),
                   "negative": (-0.9, -0.2)},
    "real vector": {"0": (0, 0)},
    "rotation": {"identity": (3, 3), "half turn": (-1, -1), "beyond a half turn": TURNED},
    "dual number": {"real part 0": (0, 0), "0": (0, 0), "negative": (-0.9, -0.2), "real": (0.2, 0.9)},
    "argument": {"real part 0": (0, 0), "negative": (-0.9, -0.2)},
    "scale": {"negative": (-2, -0.5)},
    "angle": {"0": (0, 0), "real part 0": (0, 0), "real part π": (PI, PI), "real part 2π": (2 * PI, 2 * PI),
              "real part 3π": (3 * PI, 3 * PI), "real part 4π": (4 * PI, 4 * PI), "beyond a half turn": (3.2, 6.2),
              "negative": (-2.8, -0.3)},
    "dual vector": {"real part 0": (0, 0), "0": (0, 0), "real": (0.1, 3)},
    "quaternion": {"real part 0": (0, 0)},
    "unit quaternion": {"1": (1, 1), "−1": (-1, -1), "half turn": (0, 0), "beyond a half turn": BEYOND},
    "tensor": {"singular": (-10, 10)},
    "orthogonal tensor": {"translation": (3, 3), "identity": (3, 3), "half turn": (-1, -1),
                          "beyond a half turn": TURNED},
}  # fmt: skip
"""Lower and upper bound of `size`, by kind of quantity and name of the special value."""
REAL = {("angle", "0"), ("dual number", "0"), ("dual number", "real"), ("dual vector", "0"), ("dual vector", "real"),
        ("orthogonal tensor", "identity")}  # fmt: skip
"""Special values with dual part 0, among dual quantities."""
FUNCTIONS = {"smooth function"}


def size(value):
    """Return the real part of a number, a squared vector, a quaternion's scalar part or a tensor's trace."""
    if isinstance(value, Vector):
        value = value.dot(value)
    return real_part(
        value.scalar if isinstance(value, Quaternion) else value.trace() if isinstance(value, Tensor) else value
    )


def coefficients(value):
    return list(value) if isinstance(value, Vector | Quaternion | Tensor) else [value]


def test_every_special_value_is_described() -> None:
    described = {name: list(cases) for name, cases in SPECIAL.items()}
    assert described == {k.name: list(k.special) for k in QUANTITIES.values() if k.special and k.name not in FUNCTIONS}


@pytest.mark.parametrize(("name", "label"), [(name, label) for name, cases in SPECIAL.items() for label in cases])
def test_special_values_have_the_expected_size(name: str, label: str) -> None:
    low, high = SPECIAL[name][label]
    with mpmath.workdps(FIELD_DIGITS):
        for seed in "abcde":
            value = QUANTITIES[name].special[label](Draw(seed))
            assert low - 1e-12 <= size(value) <= high + 1e-12
            duals = [a.du for a in coefficients(value) if hasattr(a, "du")]
            generic = coefficients(QUANTITIES[name].generic(Draw(seed)))
            assert bool(duals) == any(hasattr(a, "du") for a in generic)
            assert not duals or any(duals) is ((name, label) not in REAL)


def test_singular_tensor_has_no_inverse() -> None:
    with mpmath.workdps(FIELD_DIGITS):
        value = QUANTITIES["tensor"].special["singular"](Draw("s"))
        assert Decimal60().same(value.det().re, 0)
        assert not Decimal60().same(QUANTITIES["tensor"].generic(Draw("s")).det().re, 0)


# ---- constants, and quantities that separate real and dual parts -----------------------------------------------------


def test_constants_have_their_values() -> None:
    field = Decimal60()
    values = {quantity.name: quantity.value(field) for quantity in QUANTITIES.values() if quantity.value is not None}
    assert values == {"dual unit": Dual(0, 1), "identity": Tensor.identity(), "π": mpmath.mpf(mpmath.pi), "words": None}
    assert {quantity.name for quantity in QUANTITIES.values() if not quantity.varies} == {*values, "∞", "index"}


def test_quantities_with_separate_real_and_dual_parts() -> None:
    apart = {quantity.name for quantity in QUANTITIES.values() if quantity.apart}
    real = {name for name in QUANTITIES if name.startswith("real")}
    assert apart == {*real, "proposition", "line", "dual unit"}


def test_exact_values_have_the_declared_number_of_symbols() -> None:
    for quantity in EXACT:
        point = Generic([Symbol("a", quantity.name)], dual=False, moving=False, framed=False)
        declared = {name for name in point.field.functions.names if name[:1] == "a" and name[1:].isdecimal()}
        assert len(declared) == quantity.size
