"""Proof, printing and validation of a chart unknown to the toolkit, v = sin(α/6) u."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import mpmath
import pytest
import sympy

from derive.algebra import Vector
from derive.codegen import ValidationFailed
from derive.codegen.build import build
from derive.codegen.signatures import POSES
from derive.codegen.targets import TARGETS
from derive.codegen.validation.run import chosen
from derive.codegen.validation.vectors import Vectors, flat, vectors_of
from derive.maps import Cayley, x
from derive.maps.families import alpha
from derive.output import files
from derive.proof import ProofFailed, prove
from derive.proof.controls import controls_of
from tests.support import families, packages
from tests.support.oracle import SineOracle
from tests.support.sine import Sine

pytestmark = pytest.mark.thorough

# --- proof ----------------------------------------------------------------------------------------------------------


def test_scalars_of_an_unknown_chart_are_proved():
    proved = prove(Sine())
    assert {proof.scope for proof in proved.proofs} == {"sine6"}
    assert sum(len(proof.residues) for proof in proved.proofs) > 20


def test_each_wrong_scalar_is_refused():
    found = list(controls_of(Sine()))
    assert len(found) == 27
    assert [str(control) for control in found if not control.noticed] == []


@pytest.mark.parametrize("name", ["quaternion", "tensor", "tangent", "tangent_inv"])
def test_a_wrong_formula_is_not_proved(name: str):
    right = getattr(Sine(), name)
    for i, coefficient in enumerate(right.coefficients):
        changed = (*right.coefficients[:i], coefficient + x, *right.coefficients[i + 1 :])
        chart = Sine()
        chart.__dict__[name] = replace(right, coefficients=changed)
        with pytest.raises(ProofFailed, match=rf"{name}\[{i}\]"):
            prove(chart)


@pytest.mark.parametrize("phi", [sympy.tan(alpha / 6), sympy.sin(alpha / 4), 2 * sympy.sin(alpha / 6)])
def test_scalars_of_another_phi_are_not_proved(phi: sympy.Expr):
    class Mistaken(Sine):
        pass

    Mistaken.phi = phi
    with pytest.raises(ProofFailed, match="phi'"):
        prove(Mistaken())


# --- kernels --------------------------------------------------------------------------------------------------------


# the native target uses the C headers; tests/targets builds its package
@pytest.mark.parametrize("target", [t for t in TARGETS.values() if t.name != "native"], ids=lambda target: target.name)
def test_unknown_chart_generates_in_every_target(target):
    (module,) = build([Sine()], target).modules
    assert module.name == f"sine6.{target.extension}"
    assert module.counts.validated >= sum(len(batch.cases) for batch in chosen(Sine(), POSES, whole=False))


@pytest.fixture(scope="module")
def texts() -> dict[str, str]:
    return build([Sine()], packages.unvalidated(TARGETS["numpy"])).texts


@pytest.mark.parametrize(
    ("function", "right", "wrong"),
    [
        ("_quaternion_scalars", "-3 * (w / c)", "-2 * (w / c)"),
        ("_tangent_scalars", "128 * c", "64 * c"),
        ("_gain", "/ 6", "/ 4"),
        ("_gain", "1 + tt", "1 - tt"),
        ("_direction", "y < 0", "0 < y"),
        ("_natural", "6 / c", "3 / c"),
        ("_turned", "further < 0", "1 < 0"),
        ("_beyond", "limit1 + (x", "limit1 - (x"),
        ("_coefficient", "1 - tt", "1 + tt"),
    ],
)
def test_a_wrong_kernel_fails_validation(texts: dict[str, str], tmp_path: Path, function: str, right: str, wrong: str):
    head, rest = texts["sine6.py"].split(f"def {function}(", 1)
    assert right in rest
    files.write(tmp_path, {**texts, "sine6.py": f"{head}def {function}({rest.replace(right, wrong, 1)}"})
    with pytest.raises(ValidationFailed, match=r"sine6\.\w+.*component"):
        TARGETS["numpy"].validate(tmp_path, Sine(), geometry=True)


ANGLES = ((1e-7, 1e-6), (0.05, 3.0), (3.4, 6.0), (7.0, 9.0))


def test_floats_agree_with_first_principles(tmp_path: Path):
    kernels = packages.imported(Sine(), tmp_path)
    for first, branch in enumerate((0, 1, 2, 0)):
        families.require_every_function(kernels, SineOracle(3), ANGLES[first:] + ANGLES[:first], branch)


# --- angles of a vector ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("phi", "edge", "angles"),
    [
        (sympy.sin(alpha / 6), 3 * sympy.pi, ("1e-30", "0.1", "9.4247")),
        (sympy.tan(alpha / 2), sympy.pi, ("1e-30", "3.1", "3.14159265")),
        (alpha, sympy.oo, ("1e-30", "1", "100")),
    ],
)
def test_angles_of_vectors_are_found(phi: sympy.Expr, edge: sympy.Expr, angles: tuple[str, ...]):
    class Other(Sine):
        pass

    Other.phi, Other.edge = phi, edge
    with mpmath.workdps(50):
        chart = Vectors(Other())
        for text in angles:
            angle = mpmath.mpf(text)
            found = chart.angle(chart.size(angle))
            # a relative error eps of |v| changes α by φ/(α φ′) eps, which is 3e3 eps for the sine near its edge
            assert abs(found / angle - 1) < 10 ** mpmath.mpf(-44)


def test_length_without_angle_below_the_edge_is_an_error():
    with mpmath.workdps(50), pytest.raises(ArithmeticError, match=r"no angle below 3\*pi has \|v\| = 1.5 in sine6"):
        Vectors(Sine()).angle(mpmath.mpf("1.5"))


def test_edges_have_full_precision_at_any_working_precision():
    with mpmath.workdps(50):
        chart = vectors_of(Cayley(3))
    found = chart.edge, chart.first_pole
    with mpmath.workdps(50):
        assert chart is vectors_of(Cayley(3))
        assert all(abs(angle - k * mpmath.pi) < mpmath.mpf(10) ** -48 for angle, k in zip(found, (3, 2), strict=True))


def test_long_vector_below_half_a_turn_is_on_branch_0():
    """Check that α is not mistaken for π: 1 − α/π is about 1e-155, far from 0 at 670 digits."""
    with mpmath.workdps(670):
        v = Vector.dual((mpmath.mpf(10) ** 155, 0, 0), (1, 2, 3))
        chart = Vectors(Cayley(1))
        screw, branch = chart.screw(v)
        assert branch == 0
        assert screw.angle.re < mpmath.pi
        assert all(abs(a - b) < mpmath.mpf(10) ** -300 for a, b in zip(flat(chart.at(screw)), flat(v), strict=True))
