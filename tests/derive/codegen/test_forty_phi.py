"""Generation of kernels for forty φ: Python targets take turns, and two φ are also compiled as C.

One package holds several φ, because each package checks the geometry that its charts share.
The forty are tangents, sines, their multiples, sums, quotients and roots, with divisors 1 … 9 and fractions.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from derive.codegen.catalogue import charts
from derive.codegen.publish import generate_charts

TANGENTS = ["tan(alpha/2)", *(f"{k}*tan(alpha/{k + 1})" for k in range(2, 9)), "tan(2*alpha/5)", "0.7*tan(alpha/3.5)"]
SINES = [*(f"{k}*sin(alpha/{k})" for k in range(2, 10)), "sin(3*alpha/7)", "1.5*sin(alpha/2.5)"]
SUMS = [
    "tan(alpha/3) + sin(alpha/3)", "alpha + sin(alpha)/2", "tan(alpha/5) + alpha/10", "sin(alpha/2) + alpha/50",
    "3*tan(alpha/7) - sin(alpha/9)", "alpha + 9*sin(alpha)/10", "alpha/2 + alpha/3", "sin(alpha/4) + sin(alpha/8)",
]  # fmt: skip
QUOTIENTS = [
    "alpha/(1 + alpha**2/40)", "alpha*(3 + alpha**2/20)/(3 + alpha**2/50)", "sin(alpha/2)/cos(alpha/2)",
    "sin(alpha/3)/(1 + cos(alpha/3))", "alpha*cos(alpha/9)", "tan(alpha/6)/(1 + tan(alpha/6)**2)",
]  # fmt: skip
ROOTS = [
    "alpha/sqrt(1 + alpha**2/40)", "sin(alpha/4)/sqrt(cos(alpha/4))", "sin(alpha/5)/sqrt(1 - sin(alpha/5)**2/9)",
    "alpha*sqrt(1 + alpha**2)", "3*atan(alpha/5)", "asin(alpha/13)",
]  # fmt: skip
PHI = [*TANGENTS, *SINES, *SUMS, *QUOTIENTS, *ROOTS]
TARGETS = ("numpy", "array-api", "numba")
COMPILED = ("4*tan(alpha/5)", "asin(alpha/13)")  # φ generated for C: one with a pole, one with an inverse function
SAMPLE = ("5*tan(alpha/6)", "2*sin(alpha/2)", "sin(alpha/3)/(1 + cos(alpha/3))")
"""φ that every run tests, the fastest of each kind; other packages are marked thorough."""
THOROUGH = [("c", COMPILED), *((TARGETS[i % 3], PHI[i::6]) for i in range(6))]


def test_forty_phi_are_listed() -> None:
    assert len(set(PHI)) == 40


@pytest.mark.parametrize(
    ("target", "phi"), [("numpy", SAMPLE), *(pytest.param(*one, marks=pytest.mark.thorough) for one in THOROUGH)]
)
def test_every_phi_generates(tmp_path: Path, target: str, phi: tuple[str, ...]) -> None:
    made = [chart for i, text in enumerate(phi) for chart in charts(phi=text, name=f"mine{i}")]
    package = generate_charts(made, target, tmp_path / "kernels")
    assert len(package.modules) >= len(phi)
    assert all(module.counts.validated > 100 for module in package.modules)
