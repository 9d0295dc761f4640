"""Seeded draws, and the table of quantities: seeded values, and generic values in an exact field."""

from __future__ import annotations

from itertools import product

import mpmath
import pytest

from derive.algebra import Dual, Quaternion, Tensor, Vector, real_part
from derive.papers.language.printed import Symbol
from derive.papers.numbers.draw import Draw, polynomial, sphere
from derive.papers.numbers.fields import FIELD_DIGITS, Decimal60
from derive.papers.numbers.generic import Generic
from derive.papers.numbers.kinds import KINDS
from derive.papers.numbers.quantities import QUANTITIES

DRAWN = [quantity for quantity in QUANTITIES.values() if quantity.draw is not None]
EXACT = [quantity for quantity in QUANTITIES.values() if quantity.exact is not None]


@pytest.fixture(autouse=True)
def _digits():
    with mpmath.workdps(FIELD_DIGITS):
        yield


def test_unit_draws_are_unit() -> None:
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
    for seed in "abcde":
        value = QUANTITIES[name].special[label](Draw(seed))
        assert low - 1e-12 <= size(value) <= high + 1e-12
        duals = [a.du for a in coefficients(value) if hasattr(a, "du")]
        generic = coefficients(QUANTITIES[name].generic(Draw(seed)))
        assert bool(duals) == any(hasattr(a, "du") for a in generic)
        assert not duals or any(duals) is ((name, label) not in REAL)


def test_singular_tensor_has_no_inverse() -> None:
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
    real = {name for name, kind in KINDS.items() if not kind.dual} - {"rotation"}
    assert apart == {*real, "real tensor", "real quaternion", "proposition", "line", "function of parts", "dual unit"}


def test_exact_values_have_the_declared_number_of_symbols() -> None:
    for quantity in EXACT:
        point = Generic([Symbol("a", quantity.name)], dual=False, moving=False, framed=False)
        declared = {name for name in point.field.functions.names if name[:1] == "a" and name[1:].isdecimal()}
        assert len(declared) == quantity.size


FIELD = Decimal60()


SEEDED = ["-0.8848645", "0.8416006", "0.53936883", "0.6785535"]
"""First numbers of a seed; published counterexamples depend on them."""


def test_seed_determines_the_numbers() -> None:
    draw = Draw("a")
    assert [mpmath.nstr(draw.signed(), 8) for _ in range(4)] == SEEDED


def test_numbers_are_away_from_zero() -> None:
    draw = Draw("range")
    assert all(0.2 <= draw.real() <= 0.9 for _ in range(100))
    assert all(3 <= draw.real(3, 4) <= 4 for _ in range(100))
    signed = [draw.signed() for _ in range(100)]
    assert {mpmath.sign(a) for a in signed} == {-1, 1}
    assert all(0.2 <= abs(a) <= 0.9 for a in signed)


def test_numbers_have_as_many_decimals_as_asked_for() -> None:
    draw = Draw("digits", digits=2)
    for a in (draw.real(), draw.real(), draw.signed()):
        assert a * 100 == round(float(a * 100))
    assert Draw("digits").real() * 10**30 % 1 == 0
    assert Draw("digits").real() * 10**20 % 1 != 0


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
    numbers = [Dual(mpmath.mpf(re), mpmath.mpf(du)) for re, du in (("2", "5"), ("0.3", "-1"), ("0", "1"))]
    for s, t in product(numbers, repeat=2):
        u = sphere(s, t)
        square = u.dot(u)
        assert FIELD.same(square.re, 1)
        assert FIELD.same(square.du, 0)
        for side, c in ((s, u.c1), (t, u.c2)):  # stereographic projection from (0, 0, −1)
            assert FIELD.same((side * (1 + u.c3) - c).re, 0)
            assert FIELD.same((side * (1 + u.c3) - c).du, 0)


@pytest.mark.parametrize("half", ["0.3", "1.3", "2.9"])
def test_quaternions_have_the_half_angle_asked_for(half: str) -> None:
    q = Draw(half).quaternion(mpmath.mpf(half))
    assert FIELD.same(q.scalar.re, mpmath.cos(mpmath.mpf(half)))
    assert FIELD.same(q.vector.re.dot(q.vector.re), mpmath.sin(mpmath.mpf(half)) ** 2)
    assert all(FIELD.same(a, b) for a, b in ((q.norm2().re, 1), (q.norm2().du, 0)))


# ---- functions -------------------------------------------------------------------------------------------------------


def test_polynomials_have_these_values() -> None:
    f = polynomial([1, 2, 3])
    assert [f(a) for a in (0, 1, 2, -1)] == [1, 6, 17, 2]
    assert [f.derivative(a) for a in (0, 1, 2, -1)] == [2, 8, 14, -4]


@pytest.mark.parametrize("a", ["-1.5", "0", "0.7", "1.9"])
def test_series_is_the_exponential(a: str) -> None:
    f, at = QUANTITIES["smooth function"].special["exponential"](Draw("f")), mpmath.mpf(a)
    assert FIELD.same(f(at), mpmath.exp(at))
    assert FIELD.same(f.derivative(at), mpmath.exp(at))


@pytest.mark.parametrize("name", ["generic", *QUANTITIES["smooth function"].special])
def test_derivatives_match_the_function(name: str) -> None:
    quantity = QUANTITIES["smooth function"]
    f = {"generic": quantity.generic, **quantity.special}[name](Draw("f"))
    for a in (mpmath.mpf("0.7"), mpmath.mpf("-1.2")):
        assert FIELD.same(f(Dual(a, mpmath.mpf(2))).du, 2 * f.derivative(a))
        assert FIELD.same(f(Dual(a, mpmath.mpf(2))).re, f(a))
