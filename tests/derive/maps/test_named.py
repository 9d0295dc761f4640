"""Families by name, and what a φ of a known form is."""

from __future__ import annotations

import mpmath
import pytest
import sympy

from derive.about import FAMILIES
from derive.algebra.arithmetic import PLAIN
from derive.maps import families, family, parameterization
from derive.maps.families import alpha
from derive.maps.named import SYMBOLIC, recognized
from derive.proof import prove

THIRD = sympy.Rational(1, 3)


@pytest.mark.parametrize(
    ("name", "phi"),
    [
        ("orthographic", sympy.sin(alpha / 2)),
        ("lambert", sympy.sin(alpha / 4)),
        ("sine7", sympy.sin(alpha / 14)),
        ("scaled12", 24 * sympy.tan(alpha / 24)),
        ("wiener_milenkovic", 4 * sympy.tan(alpha / 4)),
        ("reduced_euler_rodrigues", 2 * sympy.sin(alpha / 2)),
    ],
)
def test_a_name_stands_for_its_phi(name: str, phi: sympy.Expr):
    found = family(name)
    assert (found.name, found.phi, found.selection) == (name, phi, ("--family", name))


@pytest.mark.parametrize("name", ["", "sine", "sine0", "sine01", "lambert2", "cayley3", "sine9999999999", "Sine3"])
def test_other_names_are_refused(name: str):
    with pytest.raises(ValueError, match=r"a family is one of .*lambert, .*sineN, .*got "):
        family(name)


def test_what_is_symbolic_only_is_said_to_be():
    with pytest.raises(ValueError, match=r"isochoric is symbolic only.*families.isochoric\(\)"):
        family("isochoric")
    assert all(getattr(families, name)().name == name for name in SYMBOLIC)


def test_committed_families_exist():
    assert [family(name).name for name in FAMILIES] == list(FAMILIES)


@pytest.mark.parametrize(
    ("phi", "order", "scale"),
    [(sympy.sin(alpha / 6), 3, 1), (4 * sympy.tan(alpha / 4), 2, 4), (sympy.tan(alpha / 10) / 3, 5, THIRD)],
)
def test_multiples_of_sine_and_tangent_are_recognized(phi: sympy.Expr, order: int, scale: sympy.Rational):
    found = recognized(phi, "mine", ("--phi", str(phi)))
    assert found is not None
    assert (found.order, sympy.Rational(found.scale), found.phi) == (order, scale, phi)


@pytest.mark.parametrize(
    "phi", [alpha, sympy.sin(alpha / 3), -sympy.sin(alpha / 2), sympy.sin(alpha / 2) ** 3, sympy.cos(alpha)]
)
def test_others_are_not(phi: sympy.Expr):
    assert recognized(phi, "mine", ("--phi", str(phi))) is None


@pytest.mark.parametrize("name", ["orthographic", "lambert", "breusing", "scaled3"])
def test_coefficients_at_no_rotation(name: str):
    """φ = c₁ α + c₃ α³ + …: T has 1/c₁, 1/(2c₁²), (1/6 − 2c₃/c₁)/c₁³ there, T⁻¹ c₁, −1/2, 2c₃/c₁² + 1/(12c₁)."""
    chart = family(name)
    first, third = (chart.phi.diff(alpha, k).subs(alpha, 0) / sympy.factorial(k) for k in (1, 3))
    at = chart.scalars(sympy.Integer(0), PLAIN)
    sixth = sympy.Rational(1, 6)
    bend = 2 * third / first
    expected = (1 / first, 1 / (2 * first**2), (sixth - bend) / first**3, first, bend / first + sixth / (2 * first))
    found = (at.f, at.g, at.h, at.fi / 2, at.hi / 2)
    assert all(sympy.nsimplify(a - b) == 0 for a, b in zip(found, expected, strict=True))


@pytest.mark.parametrize("phi", [3 * sympy.sin(alpha / 6), sympy.sin(alpha / 4) / 2, 3 * sympy.tan(alpha / 8)])
def test_scalars_of_any_multiple_are_proved(phi: sympy.Expr):
    chart = recognized(phi, "multiple", ("--phi", str(phi)))
    assert chart is not None
    assert chart.phi == phi
    assert prove(chart).formulas is chart


def test_rounding_of_the_cosine_leaves_the_quaternion_of_breusings_chart_a_unit():
    """To 64 eps, where 2 c² − 1 and 2 √c³ would make of c its error times 8."""
    for x in (mpmath.mpf("1e-3"), mpmath.mpf(1)):
        at = family("breusing").scalars(x, PLAIN)
        off = at.c * (1 + mpmath.mpf("1e-3"))
        at = family("breusing").scalars(x, PLAIN)
        at.__dict__["c"] = off
        a, b, size = at.ray
        assert abs(a * a + x * b * b - size * size) < 64 * mpmath.eps
        assert abs(at.s**2 + x * at.w**2 - 1) < 64 * mpmath.eps
        assert abs(at.f**2 + x * at.g**2 - 2 * at.g) < 64 * mpmath.eps
        assert abs((2 * off * off - 1) ** 2 + 4 * x * off**3 - 1) > 1e-3


def test_operators_are_singular_at_whole_turns_and_at_the_edge():
    two_pi = 2 * sympy.pi
    assert family("exponential").singular_angles == (two_pi, 2 * two_pi)
    assert family("sine4").singular_angles == (two_pi, 2 * two_pi)
    assert parameterization("alpha/(1 + alpha**2/60)", "wide").singular_angles == (two_pi, sympy.sqrt(60))
    assert parameterization("alpha/(1 + alpha**2/20)", "narrow").singular_angles == (sympy.sqrt(20),)
