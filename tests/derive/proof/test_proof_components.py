from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
import sympy

from derive.maps import Cayley, polynomials
from derive.proof import notation as m
from derive.proof.at_order import FUNCTIONS, SYMBOLS, computations, instances
from derive.proof.components import ROTATED, STATEMENTS, Components
from derive.proof.evaluation import AtPoint
from derive.proof.identity import Equation, Multiplier


@pytest.mark.parametrize("n", [8, 13, pytest.param(64, marks=pytest.mark.thorough)])
def test_both_roads_agree_with_the_formulas(n: int) -> None:
    """Prove orders beyond those of `make check-theorems`."""
    cayley = Cayley(n)
    for proof in (*instances(cayley), *computations(n), *Components(cayley).proofs()):
        assert proof.proved, str(proof)
        assert proof.scope == f"n = {n}"


Mutations = Callable[[int], Iterator[tuple[str, str, Any]]]
CHECKS = {"tensor": Components.tensor, "tangent": Components.twist, "tangent_inv": Components.inverse}


def noticed(checks: Iterator[Any]) -> bool:
    """Return whether any residue is not zero."""
    return any(check[1] != 0 for check in checks if not isinstance(check, Multiplier))


@pytest.mark.parametrize("n", [1, 2, 5])
def test_each_coefficient_is_decided(n: int, mutations: Mutations) -> None:
    caught = 0
    for name, description, wrong in mutations(n):
        checks = CHECKS[name](Components(wrong))
        assert noticed(checks), f"not noticed by components: {description}"
        assert any(not proof.proved for proof in instances(wrong)), f"not noticed by the instance: {description}"
        caught += 1
    assert caught >= 8


@pytest.mark.parametrize("n", [3, 4])
def test_wrong_quaternion_fails(n: int, stated: Callable[[int], Any]) -> None:
    right = stated(n)
    s, t = right.quaternion.coefficients
    for wrong in ((s, -t), (-s, t), (t, s), (2 * s, t), (s * sympy.Symbol("x"), t)):
        changed = right.with_map("quaternion", wrong)
        assert noticed(Components(changed).quaternion())
        assert not all(proof.proved for proof in instances(changed))
    both = right.with_map("quaternion", (-s, -t))  # −q̂ is the same rotation, so the statement holds
    assert not noticed(Components(both).quaternion())


def test_formulas_of_another_order_fail(stated: Callable[[int], Any]) -> None:
    other = Cayley(4)
    for name in ("quaternion", "tensor", "tangent", "tangent_inv"):
        mixed = stated(3).with_map(name, getattr(other, name).coefficients)
        assert not all(proof.proved for proof in Components(mixed).proofs()), name


def test_multiplying_by_zero_proves_nothing() -> None:
    class Nothing(Components):
        def defined(self) -> Any:
            return self.identity[0] * self.zero

    decided = [*Nothing(Cayley(3)).proofs()]
    assert not any(proof.failures for proof in decided)  # all residues are 0
    assert [proof.proved for proof in decided] == [False] * 5 + [True]


def test_printed_claims_are_evaluated() -> None:
    for proof in Components(Cayley(4)).proofs():
        labels = [residue.label for residue in proof.residues if " at v = " in residue.label]
        assert any(label.startswith(equation.text) for equation in proof.claim for label in labels)


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


def test_premises_are_evaluated() -> None:
    wrong = replace(ROTATED, equation=Equation(m.R * m.point, m.q_hat * m.point * m.q_hat))
    words = [(name, claim, tuple(wrong if p == ROTATED else p for p in given)) for name, claim, given in STATEMENTS]
    decided = list(Components(Cayley(3)).proofs(words))
    assert [proof.proved for proof in decided] == [wrong not in proof.premises for proof in decided]
    assert not all(proof.proved for proof in decided)


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


def test_each_computation_has_a_proof() -> None:
    names = " ".join(proof.name for proof in computations(3))
    assert all(f".{name}(" in names for name in FUNCTIONS)
