"""Charts of φ of many forms: kernels agree with first principles on floats, and packages of many φ are generated."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import mpmath
import numpy as np
import pytest
import sympy

from derive.algebra.arithmetic import PLAIN
from derive.codegen.catalogue import charts
from derive.maps import parameterization
from derive.maps.any_phi.phi_values import PhiValues
from derive.maps.elementary import alpha, evaluate
from tests.support import families, packages, regimes, sampling, subjects
from tests.support.of_square import OfSquare, Share, series

PHI: dict[str, tuple[str, Share]] = {
    "folded": ("alpha/(1 + alpha**2/40)", lambda field, u: 1 / (1 + u / 40)),
    "hyper": ("2*sinh(alpha/2)", lambda field, u: series(u / 4, 1)),
    "flat": ("10*tanh(alpha/10)", lambda field, u: series(u / 100, 1) / series(u / 100, 0)),
    "bell": ("alpha*exp(-alpha**2/100)", lambda field, u: field.exp(-u / 100)),
    "steep": ("alpha + alpha**3", lambda field, u: 1 + u),
    "bounded": ("alpha/sqrt(1 + alpha**2/40)", lambda field, u: 1 / field.sqrt(1 + u / 40)),
    "wavy": ("alpha + 9*sin(alpha)/10", lambda field, u: 1 + series(-u, 1) * 9 / 10),
    "slow": ("alpha*(1 + log(1 + alpha**2/10))", lambda field, u: 1 + field.log(1 + u / 10)),
}
"""Text of φ, and φ/α as a function of α², by name."""

REGIMES = ((1e-300, 1e-290), (1e-9, 1e-5), (1e-3, 0.1), (1.2, 1.4), (0.3, 3.1), (3.2, 6.0))
"""Ranges of angles below a whole turn; one contains the limit between the formulas near 0 and beyond."""
QUICK = ("folded",)  # chart with a fast oracle, without sums of series


@pytest.fixture(
    scope="module",
    params=[pytest.param(name, marks=[] if name in QUICK else pytest.mark.thorough) for name in PHI],
)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture(scope="module")
def kernels(name: str, tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    return packages.imported(parameterization(PHI[name][0], name), tmp_path_factory.mktemp("phi"))


@pytest.fixture(scope="module")
def oracle(name: str) -> OfSquare:
    return OfSquare(PHI[name][1])


@pytest.mark.thorough
def test_every_function_agrees_with_first_principles(kernels: ModuleType, oracle: OfSquare):
    families.require_every_function(kernels, oracle, REGIMES)


@pytest.mark.parametrize("regime", REGIMES)
def test_no_band_of_angles_loses_digits(kernels: ModuleType, oracle: OfSquare, regime: tuple[float, float]):
    v = families.vectors(oracle, *regime, 1)
    for function in ("tangent", "pose", "tangent_inv", "from_pose"):
        families.require(kernels, oracle, function, families.arguments(kernels, function, v))


FOLDED = pytest.mark.parametrize("name", ["folded"], indirect=True, scope="module")


@FOLDED
def test_no_digits_are_lost_beyond_a_whole_turn(kernels: ModuleType, oracle: OfSquare):
    v = families.vectors(oracle, 6.2, 6.324, 1)  # the edge is at √40
    for function in ("tangent", "pose", "tangent_inv"):
        families.require(kernels, oracle, function, families.arguments(kernels, function, v))


@FOLDED
@pytest.mark.parametrize("regime", ["half turn", "edge", "beyond the edge", "not finite"])
def test_edges_are_right_or_not_finite(kernels: ModuleType, oracle: OfSquare, regime: str):
    """Expect no finite result beyond the edge; try every sixth function. The oracle ends at 2π, before the edge."""
    chart = subjects.Subject(kernels, oracle)
    names = [name for name, row in chart.table.public.items() if regimes.takes_vectors(row)]
    calls = [call for name in names[::6] for call in regimes.calls(chart, name, regime)]
    inside = [call for call in calls if call.fate == subjects.RIGHT]
    reasons = [call.judged() for call in (*inside[::7], *(c for c in calls if c.fate == subjects.OUTSIDE))]
    assert not any(reasons), reasons


@FOLDED
@pytest.mark.thorough
@pytest.mark.parametrize("angle", [5.9, 6.2, 6.27])
def test_steps_near_the_fold_keep_all_digits(kernels: ModuleType, oracle: OfSquare, angle: float):
    """Keep steps shorter than the distance to 2π, because the oracle does not count turns."""
    steps = sampling.dual_vectors(f"steps at {angle}", count=4)
    v, delta = families.vectors(oracle, angle, angle, 4), steps * np.array([0.3 * (6.2832 - angle)] * 3 + [1] * 3)
    for function in families.STEPS:
        families.require(kernels, oracle, function, [v, delta])


@FOLDED
def test_branches_beyond_the_edge_are_nan(kernels: ModuleType):
    """Check at 1 rad, with the edge at √40: branch −1 has a vector, branch 1 has none."""
    v = np.array([1 / (1 + 1 / 40), 0, 0, 0.1, 0.2, 0.3])
    assert np.isnan(kernels.shadow(v, 1)).all()
    back = kernels.shadow(v, -1)
    angle = 1 - 2 * np.pi
    np.testing.assert_allclose(back[0], angle / (1 + angle**2 / 40), rtol=1e-14)
    np.testing.assert_allclose(kernels.pose(back), kernels.pose(v), rtol=0, atol=1e-12)
    np.testing.assert_allclose(kernels.principal(back), v, rtol=0, atol=1e-12)
    assert kernels.singular_angles() == pytest.approx((2 * np.pi, np.sqrt(40)), rel=1e-15)


@FOLDED
def test_complex_steps_go_through_the_origin(kernels: ModuleType):
    rng = np.random.default_rng(3)
    for size in (0.0, 1e-9, 0.5):
        v, v_dot = rng.normal(size=6), rng.normal(size=6)
        v[:3] *= size / np.linalg.norm(v[:3])
        q, q_dot = kernels.quaternion(v), kernels.quaternion(v + 1e-40j * v_dot).imag / 1e-40
        expected = families.half_product(kernels.twist(v, v_dot), q)
        np.testing.assert_allclose(q_dot, expected, rtol=0, atol=64 * np.finfo(float).eps * 5)


# --- functions of α on floats ----------------------------------------------------------------------------------------

DIGITS = 350  # digits of the reference values, enough to hold 1 + 1e-300
ARGUMENTS = (-30.0, -3.0, -0.4, -1e-9, 1e-300, 1e-9, 0.4, 3.0, 30.0)


@pytest.mark.parametrize(
    ("function", "arguments", "units"),
    [
        (sympy.sinh(alpha), ARGUMENTS, 4),
        (sympy.cosh(alpha), ARGUMENTS, 4),
        (sympy.tanh(alpha), (*ARGUMENTS, 800.0), 4),
        (sympy.exp(alpha), ARGUMENTS, 4),
        (sympy.log(1 + alpha), (-0.9, -0.4, -1e-9, 1e-300, 1e-9, 0.4, 3.0, 1e9), 8),
        (sympy.log(alpha), (1e-300, 1e-9, 0.3, 0.7, 3.0, 1e300), 4),
    ],
    ids=str,
)
def test_functions_keep_all_digits(function: sympy.Expr, arguments: tuple[float, ...], units: int):
    """Allow ``units`` eps on floats of both signs, some near 0."""
    for a in arguments:
        got = PhiValues(a, PLAIN).at(function)
        with mpmath.workdps(DIGITS):
            exact = evaluate(function, alpha, mpmath.mpf(a))
            assert abs(got - exact) <= units * np.finfo(float).eps * abs(exact), (a, got, exact)


# --- packages of φ of many forms --------------------------------------------------------------------------------------

FORMS = [
    "tan(alpha/2)", "8*tan(alpha/9)", "tan(2*alpha/5)", "0.7*tan(alpha/3.5)",
    "2*sin(alpha/2)", "9*sin(alpha/9)", "sin(3*alpha/7)", "1.5*sin(alpha/2.5)",
    "tan(alpha/3) + sin(alpha/3)", "alpha + sin(alpha)/2", "tan(alpha/5) + alpha/10", "sin(alpha/2) + alpha/50",
    "3*tan(alpha/7) - sin(alpha/9)", "alpha + 9*sin(alpha)/10", "alpha/2 + alpha/3", "sin(alpha/4) + sin(alpha/8)",
    "alpha/(1 + alpha**2/40)", "alpha*(3 + alpha**2/20)/(3 + alpha**2/50)", "sin(alpha/2)/cos(alpha/2)",
    "sin(alpha/3)/(1 + cos(alpha/3))", "alpha*cos(alpha/9)", "tan(alpha/6)/(1 + tan(alpha/6)**2)",
    "alpha/sqrt(1 + alpha**2/40)", "sin(alpha/4)/sqrt(cos(alpha/4))", "sin(alpha/5)/sqrt(1 - sin(alpha/5)**2/9)",
    "alpha*sqrt(1 + alpha**2)", "3*atan(alpha/5)", "asin(alpha/13)",
]  # fmt: skip
"""φ whose edges are tested too."""
GENERATED = [
    ("numpy", "sin(alpha/4)/sqrt(cos(alpha/4))", "tan(2*alpha/5)", "alpha + 9*sin(alpha)/10", "sinh(alpha/3)"),
    ("array-api", "tan(alpha/3) + sin(alpha/3)", "5*tanh(alpha/9) + alpha/9"),
    ("numba", "2*sin(alpha/2)", "asin(alpha/13)", "alpha*exp(-alpha**2/100)"),
    ("c", "alpha/(1 + alpha**2/40)"),
]  # fmt: skip
"""φ of every kind: named charts and multiples, inverses in closed form, by a fit and by halvings, with poles, folds and
no edge, with and without exponential functions. A target prints its functions from programs that all targets share."""
SAMPLE = ("numpy", "sin(alpha/3)/(1 + cos(alpha/3))")


@pytest.mark.parametrize(
    "asked", [SAMPLE, *(pytest.param(one, marks=pytest.mark.thorough) for one in GENERATED)], ids=lambda asked: asked[0]
)
def test_every_phi_generates(tmp_path: Path, asked: tuple[str, ...]) -> None:
    target, *phi = asked
    made = [chart for i, text in enumerate(phi) for chart in charts(phi=text, name=f"mine{i}")]
    counted = packages.executed(made, target, tmp_path / "kernels")
    assert len(counted) >= len(phi)
    assert min(counted) > 100
