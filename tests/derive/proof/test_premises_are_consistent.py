"""Consistency of premises: contradictory or incomplete premises prove nothing."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy

from derive.maps import family
from derive.proof.at_order import at_order, same_as_theorem
from derive.proof.displacement_theorems import EXPONENTIAL, ROTATION
from derive.proof.evaluation import NoValueError
from derive.proof.identity import Equation, Premise, definition
from derive.proof.map_theorems import ANGLES, COSINE, NORM, ONE, RISE, SINE, SUMS, TURN, recurring
from derive.proof.methods import Determined, Identity, Theorem
from derive.proof.notation import R, Shifted, alpha, cross, dot, n, p, prime, q, rate, skew, u, v, x
from derive.proof.proved import STATED
from derive.proof.scalars import FORMULAS, instance
from derive.proof.setting import Symbols
from tests.support.theorems import known

A, S, G, y, si, co = sympy.symbols("A S G y si co")
ZERO = Equation(alpha, sympy.Integer(0))
ANGULAR = Symbols((COSINE, SINE, TURN, RISE), free=(TURN, RISE))


def by_steps(right: sympy.Expr, following: sympy.Expr, symbol: sympy.Symbol, *others: Premise) -> Theorem:
    """Return a theorem with too few premises on ``symbol``: it claims A = right, with A = 1 at n = 1 and S = n − 1."""
    given = (*recurring(n, (A, 1, following), (S, 0, S + 1)), *others)
    return Theorem("t", (Equation(A, right),), given, Determined(Symbols((S, symbol)), ONE))


def by_rates(right: sympy.Expr, start: int, law: sympy.Expr | int, *others: Premise) -> Theorem:
    """Return a theorem that claims A = right, for A as a function of α given by its start and its rate."""
    given = (definition(Shifted(A, alpha, 0), start), definition(rate(A), law), *others)
    return Theorem("t", (Equation(A, right),), given, Determined(Symbols((alpha,)), ZERO))


def identity(claims: dict[sympy.Expr, sympy.Expr | int], given: tuple[Premise, ...], symbols: Symbols) -> Theorem:
    return Theorem("t", tuple(Equation(a, sympy.sympify(b)) for a, b in claims.items()), given, Identity(symbols))


MISFITS = {
    "a symbol that the index defines": by_steps(1 + S * G, A + G, n, definition(G, n)),
    "a symbol that depends on the index": by_steps(1 + S * q, A + q, q),
    "a variable that stands still": by_rates(1 + alpha, 1, 0),
    "a variable of another speed": by_rates(alpha**2, 0, 4 * alpha, definition(rate(alpha), 2)),
    "slopes against a relation": identity(
        {prime(co**2 + si**2): 4 * si * co},
        (definition(co**2, 1 - si**2), definition(prime(si), co), definition(prime(co), si)),
        Symbols((co, si, x), (), (x,)),
    ),
    "relations that contradict each other": identity(
        {x * y: 1, x: 0}, (definition(x * y, 1), definition(x, 0)), Symbols((y, x))
    ),
    "a rate that is not slope times speed": identity(
        {prime(p): n, rate(p): 7},
        (definition(prime(p), n), definition(rate(p), 7), definition(rate(x), 1)),
        Symbols((p, x, n)),
    ),
    "zero divisors of two relations": identity(
        {(si**2 - co**2) / (si - co): 0}, (definition(si**2, 2), definition(co**2, 2)), Symbols((si, co), (), (si, co))
    ),
    "a vector of another length": identity(
        {
            ROTATION * v: v + sympy.sin(alpha) * cross(u, v) + (1 - sympy.cos(alpha)) * cross(u, cross(u, v)),
            skew(u) ** 3: -4 * skew(u),
        },
        (EXPONENTIAL.premise(0), definition(dot(u, u), 4)),
        Symbols((sympy.sin(alpha), sympy.cos(alpha)), (u, v)),
    ),
    "a first term as a value at the origin": identity(
        {S * y: A}, (definition(S, A / y), definition(Shifted(y, n, 1), 1)), Symbols((y, A, n))
    ),
    "a zeroth term as a value at the origin": identity(
        {S * y: A}, (definition(S, A / y), definition(Shifted(y, n, 0), 1)), Symbols((y, A, n))
    ),
    "a value elsewhere as one at the origin": identity(
        {S * (y - x): A}, (definition(S, A / (y - x)), definition(Shifted(y, x, 5), 5)), Symbols((y, A, x), (), (x,))
    ),
    "a quotient at the origin": identity(
        {S * ((n + 1) * y - 3): A},
        (definition(S, A / ((n + 1) * y - 3)), definition(Shifted(y, x, 0), 3 / (n + 1))),
        Symbols((y, A, x, n), (), (x,)),
    ),
    "the slope of a quotient": identity(
        {prime(p): n}, (definition(G, p / x), definition(prime(G), n)), Symbols((p, x, n), (), (x,))
    ),
    "the slope of a product": identity(
        {prime(p): n}, (definition(G, p * x), definition(prime(G), n)), Symbols((p, x, n), (), (x,))
    ),
    "two definitions of one symbol": identity({y: 2}, (definition(y, 1), definition(y, 2)), Symbols((x,))),
}


@pytest.mark.parametrize("what", MISFITS)
def test_inconsistent_premises_prove_nothing(what: str) -> None:
    assert not MISFITS[what].decide(known()).proved


def test_consistent_premises_prove() -> None:
    assert by_rates(alpha**2, 0, 2 * alpha, definition(rate(alpha), 1)).decide({}).proved
    assert by_steps(1 + S * G, A + G, G).decide({}).proved


def test_conditions_of_cited_theorems_are_listed() -> None:
    symbols = Symbols((COSINE, SINE, TURN, RISE, x), free=(TURN, RISE))
    left, right = (1 + x) ** n * TURN ** (2 * n), COSINE**2 + x * SINE**2 * TURN**2 / RISE**2
    proof = identity({left: right}, (*ANGLES.given(), NORM.premise(0)), symbols).decide(known())
    assert proof.proved
    assert [condition.left for condition in proof.conditions] == [x]  # x must be tan²


def test_induction_checks_conditions_of_cited_theorems() -> None:
    given = (*recurring(n, (A, 1, A)), definition(x, 5), *ANGLES.given())
    proof = Theorem("t", (Equation(A, sympy.Integer(1)),), given, Determined(ANGULAR, ONE)).decide(known())
    assert any(residue.label.startswith("required") for residue in proof.failures)


def test_sums_check_conditions_of_cited_theorems() -> None:
    given = (*SUMS.premises, definition(x, 5), *ANGLES.given())
    proof = replace(SUMS, premises=given).decide(known())
    assert any(residue.label.startswith("required") for residue in proof.failures)


def test_a_failed_theorem_is_no_premise() -> None:
    failed = known()
    failed["slopes"] = replace(failed["slopes"], status="failed")
    twist = next(theorem for theorem in STATED if theorem.name == "twist")
    assert [residue.label for residue in twist.decide(failed).failures] == 2 * ["premise by slopes"]


def test_instances_need_equal_order_and_count() -> None:
    with pytest.raises(NoValueError, match="is not at n = 3"):
        list(at_order(3).same(p, (x,), Shifted(p, n, sympy.Integer(4))))
    with pytest.raises(ValueError, match="zip"):
        same_as_theorem(at_order(3), {"t": (R, lambda: at_order(3).values[R][:2])})


COEFFICIENTS = [(name, place) for name, values in FORMULAS.items() for place in range(len(values))]


@pytest.mark.parametrize(("name", "place"), COEFFICIENTS)
def test_each_coefficient_in_alpha_is_decided(name: str, place: int) -> None:
    chart = family("breusing")
    right = getattr(chart, name)
    doubled = tuple(c * (2 if i == place else 1) for i, c in enumerate(right.coefficients))
    chart.__dict__[name] = replace(right, coefficients=doubled)
    failures = [residue.label for proof in instance(chart) for residue in proof.failures]
    assert [label.rpartition(" = ")[2] for label in failures] == [f"{name}[{place}]"]
