"""Charts of a user's φ: folds, multiples of α, irrational constants, and their commands."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest
import sympy

import derive
from derive.algebra import Dual, Vector
from derive.algebra.arithmetic import PLAIN
from derive.algebra.pose import Screw
from derive.codegen import build, catalogue, generate
from derive.codegen.build import print_package
from derive.codegen.catalogue import chart_of, charts, command
from derive.codegen.package import _multiple_of_pi
from derive.codegen.programs.trace import Trace
from derive.codegen.signatures import POSES
from derive.codegen.targets import TARGETS
from derive.codegen.validation import reals, validate
from derive.codegen.validation.c_interpreter import load
from derive.codegen.validation.float_cases import cases
from derive.codegen.validation.loading import loaded, module_of
from derive.codegen.validation.reals import Real
from derive.codegen.validation.vectors import Vectors
from derive.maps import PhiError, family, parameterization
from derive.maps.elementary import alpha
from derive.maps.real_constants import BITS, LEVELS, polynomial
from derive.output import files
from derive.proof import prove
from dualcay import exponential
from tests.support import packages

TEXT = "alpha/(1 + alpha**2/40)"


def test_beyond_a_fold_there_is_no_vector():
    """Check a fold just beyond π: branch −1 has vectors only for angles near π, so the replay leaves it out."""
    chart = parameterization("sin(alpha/2) + alpha/50", "folded_early")
    at, axis = Vectors(chart), Vector.dual((Real(1), 0, 0), (0, 0, 0))
    with reals.digits(50):
        found = [next(iter(at.at(Screw(Dual(Real(angle), Real(0)), axis)).re)) for angle in ("3.2", "3.23")]
    assert float(found[0]) == pytest.approx(np.sin(1.6) + 0.064, rel=1e-15)
    assert found[1].is_nan()
    replayed = {case.branch for case in cases(chart) if case.function in ("from_pose", "from_quaternion")}
    assert 0 in replayed
    assert -1 not in replayed


def test_the_command_is_read_back():
    (chart,) = charts([3], phi="2*n*tan(alpha/(2*n)) + alpha**3", name="cubic")
    line = command("numpy", chart)
    assert line == "python -m derive generate --phi '2*n*tan(alpha/(2*n)) + alpha**3' --name cubic -n 3 --target numpy"
    again = chart_of(line)
    assert again is not None
    assert (again.name, again.phi, again.selection) == (chart.name, chart.phi, chart.selection)


# --- lengths that lose digits near 0 ----------------------------------------------------------------------------------


@pytest.mark.thorough
def test_the_homochoric_vector_keeps_all_digits_from_zero_to_its_edge(tmp_path: Path) -> None:
    """Allow 8 eps, and those by which rounding of v moves the angle near 2π, where φ′ has a double zero."""
    chart = family("homochoric")
    kernels, eps = packages.imported(chart, tmp_path), np.finfo(float).eps
    for angle in (1e-150, 1e-20, 1e-8, 1e-3, 0.1, 1.25, 1.26, 2.0, 3.14, 3.15, 5.0, 6.2, 6.28):
        with mpmath.workdps(400):
            r = float(mpmath.cbrt(3 * (mpmath.mpf(angle) - mpmath.sin(mpmath.mpf(angle))) / 4))
        with mpmath.workdps(50):
            exact, slope = chart.inverse(r), chart.phi.diff(alpha).subs(alpha, sympy.Float(angle, 50))
        v = np.array([r, 0, 0, 0, 0, 0])
        moved = float(r / (slope * exact))  # relative change of the angle by that of the length
        assert abs(kernels.angle(v)[0] - exact) <= 8 * eps * moved * exact, angle
        bend = 1 + moved * abs(float(angle / np.tan(angle / 2) - 2))  # change of the terms of T with the angle
        assert abs(np.linalg.det(kernels.tangent(v)[0]) / 8 - 1) <= 64 * eps * moved * bend, angle
        if angle < np.pi:
            found = kernels.from_screw(np.array([angle, 0]), np.array([1.0, 0, 0, 0, 0, 0]))
            assert abs(found[0] / r - 1) <= 8 * eps, angle
    assert not np.isfinite(kernels.quaternion(np.array([1.0001 * float(chart.range), 0, 0, 0, 0, 0]))).any()


# --- multiples of the angle, and edges below half a turn --------------------------------------------------------------


@pytest.mark.thorough
def test_multiple_of_the_exponential_is_validated_and_agrees(tmp_path: Path) -> None:
    """Detect two errors: a quotient of integers becomes a float in runs with 50 digits; a(0)² overflows in float32."""
    chart, target = parameterization("3*alpha/2", "in_units"), TARGETS["numpy"]
    files.write(tmp_path / "of_units", print_package([family("exponential"), chart], target).texts)
    assert validate(tmp_path / "of_units", chart, geometry=False) > 100
    w = np.random.default_rng(1).normal(size=(50, 6))
    w[0] = 0
    with loaded(tmp_path / "of_units") as package:
        kernels = module_of(package, chart, POSES)
        for dtype in (np.float64, np.float32):
            there, here = (np.asarray(rows, dtype) for rows in (w, 1.5 * w))
            # rounding of v, and a few eps of each kernel; dual parts have the size of w
            close = 16 * np.finfo(dtype).eps * (1 + np.linalg.norm(w, axis=-1, keepdims=True))
            assert np.all(abs(kernels.quaternion(here) - exponential.quaternion(there)) <= close)


@pytest.mark.parametrize("phi", ["sin(alpha)", pytest.param("alpha/cos(alpha)", marks=pytest.mark.thorough)])
def test_phi_with_edge_below_half_a_turn_is_refused_with_reason(tmp_path: Path, phi: str) -> None:
    chart = parameterization(phi, "short")
    assert {proof.status for proof in prove(chart).proofs} == {"proved"}
    with pytest.raises(PhiError, match=r"ends at alpha = .*, and poses that turn further, up to pi, have no v"):
        generate(target="numpy", output=tmp_path / "of_short", phi=phi, name="short")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("share", [Fraction(1), Fraction(1, 2), Fraction(3, 2), Fraction(5, 2), Fraction(4)])
def test_a_multiple_of_pi_is_the_same_number_in_c(share: Fraction) -> None:
    text = _multiple_of_pi(sympy.Rational(share.numerator, share.denominator) * sympy.pi)
    assert load(f"double f(double pi) {{ return {text}; }}").call("f", Fraction(22, 7)) == share * Fraction(22, 7)


def test_selection_between_equal_values_is_removed() -> None:
    trace = Trace()
    (x,) = trace.inputs("x", ["x"])
    for same in (1, Fraction(2, 3), x):
        assert trace.where(trace.less(x, 0), same, same) is same
    assert trace.where(trace.less(x, 0), 1, 2) not in (1, 2)


# --- irrational constants ---------------------------------------------------------------------------------------------


@pytest.mark.thorough
@pytest.mark.parametrize("phi", ["pi*alpha/4", "alpha*(pi + alpha**2)/4"])
def test_kernels_are_validated_and_hold_in_single_precision(tmp_path: Path, phi: str) -> None:
    """Require small integers in the split of π: powers of a long integer overflow float32 and spoil v = 0."""
    chart = parameterization(phi, "mine")
    files.write(tmp_path / "of_mine", print_package([chart], TARGETS["numpy"]).texts)
    assert validate(tmp_path / "of_mine", chart, geometry=True) > 500
    v = np.linspace(0, 1, 12, dtype=np.float32).reshape(2, 6)[::-1]
    with loaded(tmp_path / "of_mine") as package:
        kernels = module_of(package, chart, POSES)
        for name in ("quaternion", "tangent", "tangent_inv", "principal"):
            single, double = (getattr(kernels, name)(np.append(v, [6 * [0]], 0).astype(t)) for t in ("f4", "f8"))
            # a few dozen operations on values below 10, each with an error of eps/2
            assert np.all(abs(single - double) < 200 * np.finfo(np.float32).eps), name


def test_all_levels_are_split_at_any_working_precision() -> None:
    with mpmath.workdps(60):
        third = mpmath.mpf(1) / 3
    assert mpmath.mp.prec < BITS * LEVELS
    split = polynomial([third])
    assert split.levels[2] != (0,)
    with mpmath.workdps(60):
        assert abs(split.at(mpmath.mpf(0), PLAIN, "") - third) < 2.0 ** -(BITS * LEVELS)


def test_default_charts_are_the_committed_ones(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[object] = []
    monkeypatch.setattr(build, "generate_charts", lambda charts, *others, **options: asked.extend(charts))
    derive.generate(output=tmp_path)
    assert asked == catalogue.committed()


@pytest.mark.parametrize(
    ("asked", "names"),
    [
        ({"orders": [3, 2, 3]}, ["cayley2", "cayley3"]),
        ({"families": ["lambert"]}, ["lambert"]),
        ({"orders": [2], "families": ["exponential"]}, ["cayley2", "exponential"]),
        ({"phi": "4*tan(alpha/9)", "name": "mine"}, ["mine"]),
    ],
)
def test_orders_families_and_phi_are_charts(asked: dict[str, object], names: list[str]) -> None:
    found = catalogue.charts(asked.get("orders", ()), asked.get("families", ()), asked.get("phi"), asked.get("name"))
    assert [chart.name for chart in found] == names
