"""Proof, printing and validation of a chart unknown to the toolkit, v = sin(α/6) u."""

from __future__ import annotations

import pytest

from derive.algebra import Vector
from derive.codegen.build import build
from derive.codegen.signatures import POSES
from derive.codegen.targets import TARGETS
from derive.codegen.validation import reals
from derive.codegen.validation.reals import Real
from derive.codegen.validation.run import chosen
from derive.codegen.validation.vectors import Vectors, flat, vectors_of
from derive.maps import Cayley
from derive.proof import prove
from docs.pages.controls import controls_of
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


# --- kernels --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["numpy", "array-api"])
def test_unknown_chart_generates(name):
    """Take two targets: test_hyperbolic_phi.py generates charts of φ in all that print programs."""
    target = TARGETS[name]
    (module,) = build([Sine()], target).modules
    assert module.name == f"sine6.{target.extension}"
    assert module.counts.validated >= sum(len(batch.cases) for batch in chosen(Sine(), POSES, whole=False))


# --- angles of a vector ---------------------------------------------------------------------------------------------


def test_length_without_angle_below_the_edge_is_an_error():
    with reals.digits(50), pytest.raises(ArithmeticError, match=r"no angle below 3\*pi has \|v\| = 1.5 in sine6"):
        Vectors(Sine()).angle(Real("1.5"))


def test_edges_have_full_precision_at_any_working_precision():
    with reals.digits(50):
        chart = vectors_of(Cayley(3))
    found = chart.edge, chart.first_pole
    with reals.digits(50):
        assert chart is vectors_of(Cayley(3))
        assert all(abs(angle - k * Real.pi()) < Real(10) ** -48 for angle, k in zip(found, (3, 2), strict=True))


def test_long_vector_below_half_a_turn_is_on_branch_0():
    """Check that α is not mistaken for π: 1 − α/π is about 1e-155, far from 0 at 670 digits."""
    with reals.digits(670):
        v = Vector.dual((Real(10) ** 155, 0, 0), (1, 2, 3))
        chart = Vectors(Cayley(1))
        screw, branch = chart.screw(v)
        assert branch == 0
        assert screw.angle.re < Real.pi()
        assert all(abs(a - b) < Real(10) ** -300 for a, b in zip(flat(chart.at(screw)), flat(v), strict=True))
