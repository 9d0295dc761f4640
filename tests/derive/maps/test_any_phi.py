"""Laws over 200 φ: edges, range and singular angles agree with a search; kernels invert φ; refusals give reasons."""

from __future__ import annotations

import math
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy

import derive
from derive.algebra.arithmetic import PLAIN
from derive.codegen.signatures import POSES
from derive.codegen.validation.samples import at_numbers
from derive.maps import PhiError, parameterization
from derive.maps.any_phi import edges, first_guess, intervals, rounding
from derive.maps.any_phi.expressions import parsed
from derive.maps.any_phi.guesses import Halved
from derive.maps.elementary import alpha
from tests.derive.codegen.test_hyperbolic_phi import FORMS
from tests.support import packages, phis

ALL = [*FORMS, *phis.drawn(200 - len(FORMS))]


def sampled(items: Iterable[Any], stride: int) -> list[Any]:
    """Return parameters; normal runs test one of ``stride``."""
    return [pytest.param(one, marks=pytest.mark.thorough if k % stride else ()) for k, one in enumerate(items)]


chart_of = cache(lambda text: parameterization(text, "mine"))
"""Chart of a φ, whose fits are made once."""
CLOSE = mpmath.mpf(10) ** -25
LEAST = "alpha + 0.999999*sin(8*alpha)/8"
"""φ whose slope is nearly 0 at an angle."""
KNOWN = {
    "0.999*alpha + 0.001*tan(alpha/2)": ("pole", "pi"),
    LEAST: ("cut", "4*pi"),
    "alpha/cos(alpha/4)**2": ("pole", "2*pi"),
    "tan(alpha/4)/cos(alpha/4)": ("pole", "2*pi"),
    "alpha/(1 + cos(alpha/3))": ("pole", "3*pi"),
    "alpha + sin(alpha)": ("fold", "pi"),
    "alpha + tan(alpha/8)": ("pole", "4*pi"),
    "alpha + tanh(28*alpha)/6": ("cut", "4*pi"),
    "asinh(2*tan(alpha/5))": ("pole", "5*pi/2"),
    "sqrt(1 + tan(alpha/5)**2)*tan(alpha/5)": ("pole", "5*pi/2"),
    "alpha/cbrt(cos(alpha/5)) + alpha": ("pole", "5*pi/2"),
    "tan(alpha/4)*cos(alpha/4) + alpha/15": ("fold", "7.3629164905"),
    "alpha + alpha/(9 - alpha**2)": ("pole", "3"),
}
"""Kind and edge of φ with narrow, even or broken poles, nearly flat places and plateaus, which samples miss."""


def test_two_hundred_phi_are_listed() -> None:
    assert len(set(ALL)) == 200


@pytest.mark.parametrize("text", sampled(ALL, 10))
def test_edge_range_and_singular_angles_agree_with_a_search(text: str) -> None:
    found, kind = phis.edge(text)
    if kind == "end":
        with pytest.raises(PhiError, match=r"is singular at .*, where it is finite"):
            parameterization(text, "mine")
        return
    chart = parameterization(text, "mine")
    with mpmath.workdps(50):
        edge = mpmath.inf if chart.edge.is_infinite else mpmath.mpf(chart.edge.evalf(50))
        if kind == "cut":
            assert edge >= found - CLOSE
            return
        assert abs(edge - found) < CLOSE
        size = chart.range
        assert size.is_infinite if kind == "pole" else abs(size.evalf(40) - phis.value(text, found)) < CLOSE
        turns = [k for k in range(1, 3) if 2 * k * mpmath.pi < found - CLOSE]
        whole = [2 * sympy.pi * k for k in turns]
        assert chart.singular_angles == (*whole, chart.edge)


@pytest.mark.parametrize("text", list(KNOWN))
def test_edges_that_samples_miss(text: str) -> None:
    found = edges.edge_of.__wrapped__(parsed(text))
    kind, angle = KNOWN[text]
    assert found.kind == kind
    assert str(found.angle).startswith(angle)


@pytest.mark.parametrize("text", sampled([*phis.REMOVABLE, *phis.SUMS], 4))
def test_edges_of_removable_zeros_and_of_sums_with_poles(text: str) -> None:
    chart: Any = parameterization(text, "mine")
    kind, angle = {**phis.REMOVABLE, **phis.SUMS}[text]
    assert chart._edge.kind == kind
    assert str(chart.edge).startswith(angle)
    assert chart.phi.diff(alpha).subs(alpha, 0) > 0


def test_a_fold_just_before_a_flat_place_is_found() -> None:
    edge = edges.edge_of(parsed("alpha + 1.000001*sin(8*alpha)/8"))
    assert edge.kind == "fold"
    assert float(edge.angle) == pytest.approx(math.acos(-1 / 1.000001) / 8, rel=1e-12)


# --- controls -----------------------------------------------------------------------------------------------------


def test_coarse_intervals_decide_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """Expect a refusal, never a wrong edge, if intervals may not shrink."""
    step = mpmath.mpf(1) / 100
    monkeypatch.setattr(edges.cells, "__defaults__", (step,))
    for text in (LEAST, "0.999*alpha + 0.001*tan(alpha/2)"):
        with pytest.raises(PhiError, match="intervals do not decide"):
            edges.edge_of.__wrapped__(parsed(text))


@pytest.mark.thorough
def test_too_few_halvings_are_not_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    chart: Any = chart_of(LEAST)
    assert isinstance(chart.far, Halved)
    monkeypatch.setattr(first_guess, "HALVINGS_MAX", chart.far.count - 3)
    with pytest.raises(PhiError, match="not inverted to full precision"):
        first_guess.guess(chart.phi, chart._edge, chart.near.limit)


REFUSED = [
    (sympy.Symbol("alpha", real=True), "the symbol alpha with other assumptions"),
    (sympy.Symbol("beta") * alpha, "the symbol beta"),
    (sympy.erf(alpha), "holds erf; known functions are sin"),
    (3, "a text or a SymPy expression in derive.alpha, given 3"),
    (None, "a text or a SymPy expression in derive.alpha, given None"),
    ("n*alpha", "by -n or as order="),
    (sympy.I * alpha, "holds I, which is no real number"),
    ("alpha*asin(2)", "holds asin(2), which is no real number"),
    ("alpha*csc(alpha/4)", "not odd by its structure"),
    ("alpha*cot(alpha/4)**2", "divides by zero at alpha = 0"),
    ("(1 - cos(alpha))/alpha**3", "divides by zero at alpha = 0"),
    ("cbrt(alpha + alpha**3)", "has no derivative at alpha = 0"),
    ("cbrt(alpha**5 + alpha**7)", "has no derivative at alpha = 0"),
    ("sqrt(2 - 2*cos(alpha))", "has no derivative at alpha = 0"),
    ("tan(alpha/4) + 0*log(alpha)", "log(alpha) cancels in phi, and nothing proves that it has a value at alpha = 0.0"),
    ("tan(alpha/4) + log(alpha) - log(alpha)", "log(alpha) cancels in phi"),
    ("alpha + 0/alpha", "1/alpha cancels in phi"),
    ("tan(alpha/4) + 0*sec(alpha/2)", "1/cos(alpha/2) cancels in phi, and nothing proves that it has a value at alpha"),
    ("alpha + sin(alpha)/9 + 0*tan(alpha/7)", "tan(alpha/7) cancels in phi"),
    ("asin(alpha/5)", "is singular at alpha = 5.0, where it is finite"),
    ("atan(2*tan(alpha/5))", "is singular at alpha = 7.85398, where it is finite"),
    ("sqrt(2 + sqrt(1 + tan(alpha/5)**2))*tan(alpha/5)", "nothing proves that"),
    ("alpha + (1 - 1e-20*1e-10*1e-10*1e-10*1e-10*1e-10*1e-10*1e-10)*sin(alpha)", "intervals do not decide"),
]


@pytest.mark.parametrize(("phi", "reason"), REFUSED, ids=str)
def test_refusals_give_their_reason(phi: Any, reason: str) -> None:
    with pytest.raises(PhiError) as raised:
        derive.Parameterization(phi)
    assert reason in str(raised.value)


@pytest.mark.parametrize("text", ["alpha + 0*sin(alpha)", "tan(alpha/4)*(1 + 0*tan(alpha/4))", "alpha*sec(alpha/5)"])
def test_terms_that_cancel_may_have_values(text: str) -> None:
    assert derive.Parameterization(text).phi.subs(alpha, 0) == 0


def test_an_order_is_an_integer() -> None:
    with pytest.raises(TypeError, match=r"an integer >= 1, got 1\.5"):
        derive.Parameterization("tan(alpha/(2*n))", order=1.5)


WITHOUT_KERNELS = [
    ("atanh(alpha/5)", "grows like a logarithm near its edge"),
    ("alpha + sin(alpha)", "double zero at its edge"),
    ("alpha + 0.99999999*sin(8*alpha)/8", "1/phi' would lose half of its digits"),
    ("alpha - 0.98*sin(alpha)", "near alpha"),
    ("1.000001*sin(alpha/2 + alpha/1000)", "ends at alpha"),
    *(pytest.param(*one, marks=pytest.mark.thorough) for one in (
        ("asinh(2*tan(alpha/5))", "grows like a logarithm near its edge"),
        ("alpha + sin(300*alpha)/400", "the inverse of phi = alpha + sin(300*alpha)/400 is analytic"),
    )),
]  # fmt: skip


@pytest.mark.parametrize(("phi", "reason"), WITHOUT_KERNELS)
def test_phi_that_floats_cannot_invert_has_no_kernels(tmp_path: Path, phi: str, reason: str) -> None:
    with pytest.raises(PhiError, match="its chart is symbolic only") as raised:
        derive.generate(phi=phi, name="mine", output=tmp_path / "kernels")
    assert reason in str(raised.value)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("text", ["sec", "csc", "cot"])
def test_reciprocals_are_quotients(text: str) -> None:
    given = {"sec": "alpha*sec(alpha/5)", "csc": "alpha*csc(alpha/5 + pi/2)", "cot": "1/cot(alpha/5)"}[text]
    same = {"sec": "alpha/cos(alpha/5)", "csc": "alpha/sin(alpha/5 + pi/2)", "cot": "sin(alpha/5)/cos(alpha/5)"}[text]
    assert parsed(given) == parsed(same)


BESIDE_EDGES = [
    "alpha/(1 + alpha**2/3.1416**2)", "alpha/(1 - alpha**2/9.8697)", next(iter(phis.REMOVABLE)),
    "alpha - alpha**3/(3*pi**2)",
    "tan(alpha/5) + alpha", "alpha/(1 - alpha**2/30)**3", "0.999*alpha + 0.001*tan(alpha/2)",
]  # fmt: skip
"""φ with folds and poles at π, just beyond it, and later; inverted in closed form, by a fit and by halvings."""


@pytest.mark.parametrize("text", sampled(BESIDE_EDGES, len(BESIDE_EDGES)))
def test_floats_find_the_angle_beside_an_edge(text: str) -> None:
    """Allow 16 eps of the length and of the edge; lengths come as near to a fold or pole as floats do."""
    chart: Any = chart_of(text)
    for dtype in (np.float64, np.float32):
        eps = float(np.finfo(dtype).eps)
        end = mpmath.inf if chart.range.is_infinite else mpmath.mpf(chart.range.evalf(50))
        lengths = [10.0**k for k in range(1, 19)]
        if chart.range.is_finite:
            lengths = [float(end) * (1 - eps * k / 2) for k in (*range(6), *(2.0**j for j in range(3, 20, 8)))]
        for r in map(dtype, lengths):
            exact, less = (chart.inverse(min(size, end)) for size in (float(r), float(r) * (1 - 16 * eps)))
            with np.errstate(all="ignore"):
                found = chart.far_angle(r * r, r, PLAIN)
            assert abs(found - exact) <= exact - less + 16 * eps * float(chart.edge), (dtype, r)


def test_steps_beside_a_fold_are_noise(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(first_guess.Fitted, "to_edge", False)
    with pytest.raises(AssertionError):
        test_floats_find_the_angle_beside_an_edge(BESIDE_EDGES[0])


# --- kernels at their worst points --------------------------------------------------------------------------------

@pytest.mark.parametrize("text", sampled([LEAST, "0.999*alpha + 0.001*tan(alpha/2)"], 2))
def test_floats_find_the_angle_near_the_least_slope_and_the_pole(text: str) -> None:
    """Allow 8 eps of the length and of the terms of φ, divided by φ′."""
    chart: Any = chart_of(text)
    for angle in (*map(float, chart.steep), 1.17332, 3.0, 3.14):
        r = float(phis.value(text, mpmath.mpf(angle)))
        exact = chart.inverse(r)
        found = chart.far_angle(r * r, r, PLAIN)
        allowed = 8 * np.finfo(float).eps * (_noise(chart.phi, exact) + r) / phis.slope(text, exact)
        assert abs(found - exact) <= allowed + 2 * np.finfo(float).eps * exact, angle


def test_kernels_are_validated_where_the_slope_is_least() -> None:
    least = float(phis.value(LEAST, mpmath.pi / 8))
    calls = at_numbers(chart_of(LEAST), POSES)
    lengths = [float(mpmath.norm(case.arguments[0][:3])) for case in calls if case.row.arguments[0].vector]
    assert min(abs(length - least) for length in lengths) < 1e-12


KERNELS = [
    LEAST, "0.999*alpha + 0.001*tan(alpha/2)", "tan(alpha/4)/cos(alpha/4)",
    "alpha*cbrt(1 + alpha**2/50)", "alpha/sqrt(cos(alpha/5)) + alpha", "sin(alpha/5) + 0.158*sin(4*alpha)/9",
]  # fmt: skip


@pytest.mark.thorough
@pytest.mark.parametrize("text", KERNELS)
def test_kernels_are_as_accurate_as_their_condition(tmp_path: Path, text: str) -> None:
    """Allow 64 eps of the rounding bound of φ in the angle, and of φ′ too in the translation.

    The angle of r has the error ``eps (N + r)/φ′``, with N of `rounding`. The translation holds ``1/φ′``. Its relative
    error is that of φ′, and the change of φ′ with the angle.
    """
    chart = parameterization(text, f"worst{KERNELS.index(text)}")  # modules are imported once by name
    kernels = packages.imported(chart, tmp_path)
    end = min(float(chart.edge), 4 * math.pi)
    angles = [float(a) for a in chart.steep] + [end * share for share in (1e-6, 0.01, 0.1, 0.37, 0.6, 0.9, 0.98)]
    for angle in angles:
        with mpmath.workdps(50):
            r = float(phis.value(text, mpmath.mpf(angle)))
            exact = chart.inverse(r)
            slope, bend = (mpmath.mpf(chart.phi.diff(alpha, k).subs(alpha, sympy.Float(exact, 50))) for k in (1, 2))
            noise = _noise(chart.phi, exact) + r
            allowed = 64 * np.finfo(float).eps * (noise / abs(slope) + exact)
            found, drift = kernels.angle(np.array([r, 0, 0, 1, 0, 0]))
            assert abs(found - exact) <= allowed, (angle, found)
            relative = _noise(chart.phi.diff(alpha), exact) / slope * np.finfo(float).eps * 64
            assert abs(drift * slope - 1) <= relative + abs(bend / slope) * allowed, (angle, drift)


def _noise(expression: sympy.Expr, angle: Any) -> Any:
    with intervals.precise() as at:
        return rounding.noise(at, expression, at.interval(angle, angle))
