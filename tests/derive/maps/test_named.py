"""Charts by name: recognition of their φ, and poses equal to the Cayley map of the converted vector a(v)."""

from __future__ import annotations

import mpmath
import pytest
import sympy

from derive.about import FAMILIES, OTHER_FAMILIES
from derive.algebra import Dual, Quaternion, Vector, functions
from derive.algebra.arithmetic import PLAIN
from derive.algebra.pose import Screw
from derive.codegen.lowering.scalar_programs import scalar_programs
from derive.maps import Cayley, cayley_scalars, family, parameterization
from derive.maps.any_phi.expressions import parsed
from derive.maps.elementary import alpha, evaluate
from derive.maps.multiple import POWERS
from derive.maps.named import described, recognized
from derive.proof import prove
from derive.proof.scalars import _volume


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
def test_family_has_the_phi_of_its_name(name: str, phi: sympy.Expr):
    found = family(name)
    assert (found.name, found.phi, found.selection) == (name, phi, ("--family", name))


@pytest.mark.parametrize("name", ["", "sine", "sine0", "sine01", "lambert2", "cayley3", "sine9999999999", "Sine3"])
def test_other_names_are_refused(name: str):
    with pytest.raises(ValueError, match=r"a family is one of .*lambert, .*sineN, .*got "):
        family(name)


def test_listed_families_exist():
    assert [family(name).name for name in (*FAMILIES, *OTHER_FAMILIES)] == [*FAMILIES, *OTHER_FAMILIES]


@pytest.mark.parametrize(
    ("phi", "name"),
    [
        ("sin(alpha/6)", "sine3"),
        ("4*tan(alpha/4)", "4 cayley2"),
        ("tan(alpha/10)/3", "1/3 cayley5"),
        ("tan(alpha/2)", "cayley1"),
        ("sin(alpha/2)/cos(alpha/2)", "cayley1"),
        ("(1 - cos(alpha/2))/sin(alpha/2)", "cayley2"),
        ("3*sin(alpha)/(1 + cos(alpha))", "3 cayley1"),
        ("4*sin(alpha/4)*cos(alpha/4)", "2 sine1"),
        ("alpha", "exponential"),
        ("alpha/2 + alpha/3", "5/6 exponential"),
        ("sin(alpha/4)/sqrt(cos(alpha/4))", "breusing"),
    ],
)
def test_known_charts_are_recognized_in_any_form(phi: str, name: str):
    found = recognized(parsed(phi))
    assert found is not None
    assert described(found) == name
    for angle in (sympy.Rational(1, 3), sympy.Rational(7, 5), sympy.Integer(3)):
        assert abs((found.phi - parsed(phi)).subs(alpha, angle).evalf(30)) < 1e-25


@pytest.mark.parametrize(
    "phi",
    [
        "sin(alpha/3)", "-sin(alpha/2)", "sin(alpha/2)**3", "cos(alpha)", "tan(alpha/5)", "sqrt(2)*tan(alpha/4)",
        "pi*alpha", "alpha + sin(alpha)", "tan(alpha/2)*exp(alpha**2)", "3*sin(alpha/14) - 4*sin(alpha/14)**3",
        "sin(999*alpha/1000) + sin(alpha)", "123456789*alpha",
    ],
)  # fmt: skip
def test_other_functions_are_not_recognized(phi: str):
    assert recognized(parsed(phi)) is None


@pytest.mark.parametrize(
    ("phi", "known"), [("tan(alpha/6)", "cayley3"), ("4*tan(alpha/4)", "scaled2"), ("sin(alpha/4)", "lambert")]
)
def test_recognized_charts_have_the_programs_and_proofs_of_the_name(phi: str, known: str):
    mine = parameterization(phi, "mine")
    named = Cayley(3) if known == "cayley3" else family(known)
    assert (mine.name, mine.selection) == ("mine", ("--phi", f"'{phi}' --name mine"))
    assert scalar_programs(mine) == scalar_programs(named)
    assert [proof.name for proof in prove(mine).proofs] == [proof.name for proof in prove(named).proofs]


def test_a_multiple_names_its_base_and_factor():
    found = family("scaled3")
    assert (found.base, found.factor) == (Cayley(3), 6)
    assert family("wiener_milenkovic").base == Cayley(2)
    assert (Cayley(3).base, Cayley(3).factor) == (None, 1)


@pytest.mark.parametrize("phi", ["6*tan(alpha/6)", "3*sin(alpha/6)", "5*alpha/4"])
def test_scalars_of_a_multiple_match_its_base_by_powers_of_the_factor(phi: str):
    chart = parameterization(phi, "mine")
    x, K = mpmath.mpf("0.7"), mpmath.mpf(chart.factor.numerator) / chart.factor.denominator
    here, there = chart.scalars(x, PLAIN), chart.base.scalars(x / K**2, PLAIN)
    for name, power in POWERS.items():
        value = mpmath.mpf(0) + mpmath.mpmathify(getattr(here, name))
        assert abs(value - getattr(there, name) / K**power) < mpmath.mpf(10) ** -45, name


@pytest.mark.parametrize("name", ["orthographic", "lambert", "breusing", "scaled3"])
def test_limits_are_the_scalars_at_no_rotation(name: str):
    chart = family(name)
    at, (tangent, tangent_inv) = chart.scalars(sympy.Integer(0), PLAIN), chart.limits
    found = (at.f, at.g, at.h, at.fi / 2, -sympy.Rational(1, 2), at.hi / 2)
    assert all(sympy.nsimplify(a - b) == 0 for a, b in zip(found, (*tangent, *tangent_inv), strict=True))


@pytest.mark.parametrize("phi", [3 * sympy.sin(alpha / 6), sympy.sin(alpha / 4) / 2, 3 * sympy.tan(alpha / 8)])
def test_scalars_of_any_multiple_are_proved(phi: sympy.Expr):
    chart = parameterization(phi, "multiple")
    assert chart.phi == phi
    assert prove(chart).formulas is chart


def test_breusing_quaternion_has_norm_one_for_any_rounding_of_the_cosine():
    """Allow 64 eps; the formulas 2 c² − 1 and 2 √c³ would magnify the error of c up to 8 times."""
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


# --- families and the Cayley map of the converted vector --------------------------------------------------------------

TINY = mpmath.mpf(10) ** -40


def screw(angle: str = "0.9") -> Screw:
    direction = [mpmath.mpf(c) / 7 for c in (2, 3, 6)]
    moment = [mpmath.mpf(c) / 4 for c in (3, -2, 0)]
    return Screw(Dual(mpmath.mpf(angle), mpmath.mpf("1.7")), Vector.dual(direction, moment))


@pytest.mark.parametrize("name", ["lambert", "breusing", "sine5", "scaled3", "exponential"])
def test_scale_belongs_to_the_parameterization(name: str, gap) -> None:
    chart, at = family(name), screw()
    a = evaluate(chart.scale, alpha, at.angle)
    w = at.axis * evaluate(chart.phi, alpha, at.angle) / a
    s, t = cayley_scalars.quaternion(chart.order, w.dot(w))
    half = at.angle / 2
    assert gap(Quaternion(s, w * t), Quaternion(functions.cos(half), at.axis * functions.sin(half))) < TINY


@pytest.mark.parametrize(
    ("name", "volume"), [("homochoric", 8), pytest.param("isochoric", 1, marks=pytest.mark.thorough)]
)
def test_volume_elements_are_constant(name: str, volume: int) -> None:
    chart = family(name)
    (proof,) = (proof for proof in prove(chart).proofs if proof.name == "constant volume element")
    assert proof.claim[0].right == volume
    assert sympy.expand(chart.written**3 - 6 * (alpha - sympy.sin(alpha)) / volume) == 0
    for length in ("1e-9", "0.7", "1"):
        det = chart.tangent.matrix([sympy.Float(length, 20), 0, 0, 0, 0, 0])[0].det()
        assert abs(det - volume) < 1e-15


def test_other_volume_elements_are_not_constant() -> None:
    for chart in (family("lambert"), parameterization("cbrt(alpha - sin(alpha)*cos(alpha/9))", "mine")):
        assert not [*_volume(chart)]
