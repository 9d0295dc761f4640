from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest

from derive.maps import polynomials
from derive.proof import differential_field, induction, theorems
from derive.proof.differential_field import Formulas, p_slope, q_slope
from derive.proof.identity import ALL_ORDERS
from derive.proof.map_theorems import motion_theorems


def test_everything_is_proved_for_all_orders() -> None:
    proofs = theorems()
    assert len(proofs) == 18
    for proof in proofs:
        assert proof.proved, str(proof)
        assert proof.residues
        assert not proof.failures
        assert proof.scope == ALL_ORDERS
        assert proof.latex
        assert proof.method
        assert proof.seconds >= 0
    assert theorems() is proofs


def test_induction_shows_base_and_step() -> None:
    by_induction = [proof for proof in theorems() if proof.method.startswith("induction")]
    assert len(by_induction) == 7
    for proof in by_induction:
        labels = " ".join(residue.label for residue in proof.residues)
        assert "base" in labels
        assert "step" in labels


@pytest.mark.parametrize("name", ["tensor", "tangent", "tangent_inv"])
@pytest.mark.parametrize("index", [0, 1, 2])
@pytest.mark.parametrize("change", ["sign", "factor"])
def test_a_wrong_coefficient_fails(name: str, index: int, change: str) -> None:
    right: Callable[..., Any] = getattr(differential_field, name)

    def wrong(n: Any, x: Any, p: Any, q: Any) -> tuple[Any, ...]:
        coefficients = list(right(n, x, p, q))
        coefficients[index] = -coefficients[index] if change == "sign" else coefficients[index] * n
        return tuple(coefficients)

    failed = [proof for proof in motion_theorems(Formulas(**{name: wrong})) if not proof.proved]
    assert failed
    assert all(proof.failures and not proof.failures[0].vanishes for proof in failed)


def test_a_wrong_recurrence_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(induction, "_next", lambda x, p, q: (p + x * q, p + q))
    failed = {proof.statement for proof in induction.polynomial_theorems() if not proof.proved}
    assert any(statement.startswith("(1 + iX)^n") for statement in failed)
    assert any(statement.startswith("p_n^2 + x q_n^2") for statement in failed)
    assert any(statement.startswith("p_n' =") for statement in failed)


def test_a_wrong_slope_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(induction, "p_slope", lambda n, x, p, q: n * (p - q) / (1 + x))
    failed = {proof.statement.split(" ")[0] for proof in induction.polynomial_theorems() if not proof.proved}
    assert {"p_n'", "n"} <= failed


@pytest.mark.parametrize("n", range(1, 9))
def test_slopes_are_those_of_the_polynomials(n: int) -> None:
    at = Fraction(3, 7)
    p, q, dp, dq = polynomials.pair_with_derivative(n, at)
    assert dp == p_slope(n, at, p, q)
    assert dq == q_slope(n, at, p, q)
