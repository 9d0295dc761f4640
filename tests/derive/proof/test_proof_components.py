from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
import sympy

from derive.maps import Cayley, polynomials
from derive.proof import notation as m
from derive.proof.at_order import FUNCTIONS, SYMBOLS, computations, instances
from derive.proof.components import Components
from derive.proof.evaluation import AtPoint


@pytest.mark.parametrize("n", [8, 13, pytest.param(64, marks=pytest.mark.thorough)])
def test_both_roads_agree_with_the_formulas(n: int) -> None:
    """Prove orders beyond those of `make check-theorems`."""
    cayley = Cayley(n)
    for proof in (*instances(cayley), *computations(n), *Components(cayley).proofs()):
        assert proof.proved, str(proof)
        assert proof.scope == f"n = {n}"


@pytest.mark.parametrize(("symbol", "other"), [("p", m.q), ("c", m.d), ("tangent", m.R)])
def test_symbols_are_decided_values(symbol: str, other: sympy.Expr, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(SYMBOLS, symbol, other)  # "Cayley(3).p is q at n = 3"
    failed = [proof for proof in (*instances(Cayley(3)), *computations(3)) if not proof.proved]
    assert failed
    assert all(any(equation.right.args[0] == other for equation in proof.claim) for proof in failed)


def test_roots_at_a_point_are_exact() -> None:
    at = AtPoint(3)
    root = at.power(1 + m.x, sympy.Rational(1, 2))
    assert root * root == at.value(1 + m.x)
    assert at.power(1 + m.x, -sympy.Rational(3, 2)).re == Fraction(1, 11**3)


def test_the_sign_of_a_quaternion_is_decided(stated: Callable[[int], Any]) -> None:
    s, t = stated(3).quaternion.coefficients
    failed = [proof.name for proof in instances(stated(3).with_map("quaternion", (-s, -t))) if not proof.proved]
    assert failed == ["Cayley(3).quaternion"]


@pytest.mark.parametrize(
    ("angles", "label"),
    [
        (lambda n: (*polynomials.singular_angles(n)[:-1], 3 * n * sympy.pi), "[-1] = 3*pi"),
        (lambda n: (sympy.pi, *polynomials.singular_angles(n)[1:]), "sin("),
        (lambda n: (n * sympy.pi,), "the number of poles"),
        (lambda n: (8 * sympy.pi, *polynomials.singular_angles(n)[1:]), "how many are not between"),
    ],
)
def test_wrong_singular_angles_fail(angles: Callable[[int], Any], label: str) -> None:
    *_, proof = computations(3, {**FUNCTIONS, "singular_angles": angles})
    assert not proof.proved
    assert any(label in residue.label for residue in proof.failures)
