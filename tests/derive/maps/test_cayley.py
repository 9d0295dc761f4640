"""Coefficients, matrices and texts of Cayley(n), compared with the paper and independent formulas."""

from __future__ import annotations

import dataclasses
from fractions import Fraction

import pytest
import sympy

import derive
from derive.algebra import Dual, Isotropic, Quaternion, Vector, dual_part, real_part
from derive.maps import Cayley, closed_forms, x

ORDERS = [1, 2, 3, 4, 5, 8, 11]
V = sympy.symbols("v1:4 d1:4")
MAPS = ("tensor", "tangent", "tangent_inv")


def is_zero(expression: sympy.Expr) -> bool:
    return sympy.cancel(sympy.together(expression)) == 0


def test_printed_coefficients() -> None:
    """Compare with CP23 (96)-(98), (103)-(105), (110)-(112); derive common signs and fraction bars."""
    expected = {
        (1, "tangent"): (2 / (1 + x), 2 / (1 + x), 0),
        (1, "tangent_inv"): (sympy.Rational(1, 2), -sympy.Rational(1, 2), sympy.Rational(1, 2)),
        (2, "tangent"): (4 * (1 - x) / (1 + x) ** 2, 8 / (1 + x) ** 2, 8 / (1 + x) ** 2),
        (2, "tangent_inv"): ((1 - x) / 4, -sympy.Rational(1, 2), sympy.Rational(1, 2)),
        (3, "tensor"): (
            1 - 2 * x * (3 - x) ** 2 / (1 + x) ** 3,
            2 * (3 - x) * (1 - 3 * x) / (1 + x) ** 3,
            2 * (3 - x) ** 2 / (1 + x) ** 3,
        ),
        (3, "tangent"): (2 * (1 - 3 * x) * (3 - x) / (1 + x) ** 3, 2 * (3 - x) ** 2 / (1 + x) ** 3, 32 / (1 + x) ** 3),
        (3, "tangent_inv"): ((1 - 3 * x) / (2 * (3 - x)), -sympy.Rational(1, 2), (11 - x) / (6 * (3 - x))),
    }
    for (n, name), coefficients in expected.items():
        for got, wanted in zip(getattr(Cayley(n), name).coefficients, coefficients, strict=True):
            assert is_zero(got - wanted), (n, name)


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_tangent_is_the_derivative_of_the_tensor(n: int) -> None:
    """Compare with ``ω = vect(Ṙ Rᵀ)``, by derivatives along each real symbol at a rational point."""
    R, _ = Cayley(n).tensor.matrix(V)
    T, _ = Cayley(n).tangent.matrix(V)
    point = dict(zip(V, map(sympy.Rational, ("1/3", "-2/5", "3/7", "1", "2", "3")), strict=True))
    for k in range(3):
        rate = R.diff(V[k]).subs(point) * R.subs(point).T
        assert rate + rate.T == sympy.zeros(3)
        assert sympy.Matrix([rate[2, 1], rate[0, 2], rate[1, 0]]) == T.subs(point)[:, k]


@pytest.mark.parametrize("n", ORDERS)
def test_symbolic_and_numeric_forms_agree(n: int, draw_exact) -> None:
    m = Cayley(n)
    for _ in range(3):
        v = draw_exact()
        square = v.dot(v)
        for name in MAPS:
            formula = getattr(m, name)
            values = getattr(closed_forms, name)(n, square)
            for value, expression in zip(values.coefficients, formula.coefficients, strict=True):
                at = {x: sympy.Rational(square.re)}
                assert isinstance(real_part(value), Fraction)  # the next line would accept an equal float
                assert real_part(value) == Fraction(str(expression.subs(at)))
                assert dual_part(value) == square.du * Fraction(str(expression.diff(x).subs(at)))


@pytest.mark.parametrize("n", range(1, 12))
def test_quaternion_is_unit_and_gives_the_tensor(n: int, draw, gap) -> None:
    v = draw(2)
    s, t = closed_forms.quaternion(n, v.dot(v))
    R = closed_forms.tensor(n, v.dot(v))
    assert gap(s * s + v.dot(v) * t * t, Dual(1)) < 1e-45
    assert max(gap(2 * s * t, R.b), gap(2 * t * t, R.c)) < 1e-44


@pytest.mark.parametrize("n", range(1, 9))
def test_quaternion_is_the_power_of_its_definition(n: int, draw, gap) -> None:
    """Compare with the square of CP23 (46), ``q̂² = ((1 + v)(1 − v)⁻¹)ⁿ``, by quaternion products."""
    v = draw()
    step = Quaternion(Dual(1), v) * Quaternion(Dual(1), -v).inverse()
    power = step
    for _ in range(n - 1):
        power = power * step
    s, w = closed_forms.quaternion(n, v.dot(v))
    q = Quaternion(s, v * w)
    assert gap(q * q, power) < 1e-42


@pytest.mark.parametrize("n", range(1, 6))
def test_pure_translation(n: int) -> None:
    v = Vector.dual((Fraction(0),) * 3, (Fraction(1), Fraction(-2), Fraction(3)))
    square = v.dot(v)
    assert closed_forms.tensor(n, square).tensor(v) == Isotropic(1, 2 * n, 0, square).tensor(v)
    assert closed_forms.tangent(n, square).tensor(v) == Isotropic(2 * n, 2 * n**2, 0, square).tensor(v)


def test_equation_numbers() -> None:
    assert [getattr(Cayley(3), name).equations for name in ("quaternion", *MAPS)] == [
        (50, 55, 109),
        (57, 110),
        (88, 111),
        (89, 112),
    ]
    assert Cayley(5).tangent_inv.equations == (89, 125)
    assert Cayley(7).tangent.equations == (88,)


def test_domains_and_singular_sets() -> None:
    assert Cayley(2).tangent_inv.domain == "every dual vector v"
    assert Cayley(5).tangent_inv.domain == "every dual vector v with Re q_5 != 0"
    assert Cayley(5).tangent.singular == "loses rank at Re alpha = 2*pi, 4*pi; v is infinite at Re alpha = 5*pi"
    assert Cayley(1).tangent_inv.singular == "pole at no finite v; v is infinite at Re alpha = pi"


def test_latex() -> None:
    assert Cayley(3).tangent_inv.latex() == (
        r"\mathrm{dcay}_{3}^{-1} = \frac{p_{3}}{2 q_{3}} I - \frac{1}{2} \tilde{v} + "
        r"\frac{(1 + x) q_{3} - 3 p_{3}}{6 x q_{3}} v \otimes v = "
        r"\frac{1 - 3 x}{6 - 2 x} I - \frac{1}{2} \tilde{v} + \frac{11 - x}{18 - 6 x} v \otimes v"
    )
    assert (
        Cayley(2)
        .tangent_inv.latex()
        .endswith(r"= \left(\frac{1}{4} - \frac{x}{4}\right) I - \frac{1}{2} \tilde{v} + \frac{1}{2} v \otimes v")
    )
    assert Cayley(1).tangent.latex().endswith(r"= \frac{2}{1 + x} I + \frac{2}{1 + x} \tilde{v}")
    text = Cayley(3).latex()
    for part in (r"p_{3} &= 1 - 3 x", r"q_{3} &= 3 - x", r"\hat{q} &=", r"(1 + x)^{3/2}", r"\mathrm{dcay}_{3}^{-1}"):
        assert part in text
    for item in (Cayley(3), Cayley(3).tensor):
        shown = item._repr_latex_()
        assert shown.startswith("$")
        assert shown.endswith("$")
        assert item.latex() in shown


def test_values_are_frozen_and_equal_by_content() -> None:
    assert Cayley(3) == Cayley(3)
    assert hash(Cayley(3)) == hash(Cayley(3))
    assert Cayley(3).n == Cayley(3).order == 3
    assert Cayley(3).tensor == Cayley(3).tensor != Cayley(3).tangent
    with pytest.raises(dataclasses.FrozenInstanceError):
        Cayley(3).order = 4  # type: ignore[misc]
    with pytest.raises(dataclasses.FrozenInstanceError):
        Cayley(3).tensor.order = 4  # type: ignore[misc]


def test_prove_lists_proofs_for_all_n_and_for_this_one() -> None:
    proofs = derive.Cayley(2).prove()
    assert isinstance(proofs, list)
    assert {"all n", "n = 2"} <= {proof.scope for proof in proofs}
    assert all(proof.status == "proved" for proof in proofs)


def test_bad_input() -> None:
    with pytest.raises(ValueError, match="n must be an integer >= 1, got 0"):
        Cayley(0)
    with pytest.raises(TypeError, match=r"n must be an integer >= 1, got 2.5 of type float"):
        Cayley(2.5)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=r"expected 6 components, .* or 3 for a rotation, got 4"):
        Cayley(2).tensor.matrix(V[:4])
    with pytest.raises(ValueError, match="t"):
        Cayley(2).tensor.matrix(["t", 0, 0])  # type: ignore[list-item]
