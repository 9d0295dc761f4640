"""Multiples φ = c α of the exponential chart, refusals of φ with a small edge, and constant angles in C."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import sympy

from derive.codegen import generate
from derive.codegen.build import print_package
from derive.codegen.package import _multiple_of_pi
from derive.codegen.programs.trace import Trace
from derive.codegen.signatures import POSES
from derive.codegen.targets import TARGETS
from derive.codegen.validation import validate
from derive.codegen.validation.c_interpreter import load
from derive.codegen.validation.loading import loaded, module_of
from derive.maps import PhiError, family, parameterization
from derive.output import files
from derive.proof import prove
from dualcay import exponential


def test_multiple_of_the_exponential_is_validated_and_agrees(tmp_path: Path) -> None:
    """Detect two errors: a quotient of integers becomes a float in runs with 50 digits; a(0)² overflows in float32."""
    chart, target = parameterization("3*alpha/2", "in_units"), TARGETS["numpy"]
    files.write(tmp_path / "of_units", print_package([family("exponential"), chart], target).texts)
    assert validate(tmp_path / "of_units", chart, geometry=True) > 500
    w = np.random.default_rng(1).normal(size=(50, 6))
    w[0] = 0
    with loaded(tmp_path / "of_units") as package:
        kernels = module_of(package, chart, POSES)
        for dtype in (np.float64, np.float32):
            there, here = (np.asarray(rows, dtype) for rows in (w, 1.5 * w))
            # rounding of v, and a few eps of each kernel; dual parts have the size of w
            close = 16 * np.finfo(dtype).eps * (1 + np.linalg.norm(w, axis=-1, keepdims=True))
            assert np.all(abs(kernels.quaternion(here) - exponential.quaternion(there)) <= close)


@pytest.mark.parametrize("phi", ["sin(alpha)", "alpha/cos(alpha)", "tan(2*alpha/3)"])
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
