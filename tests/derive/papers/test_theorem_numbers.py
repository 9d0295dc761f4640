"""Equation numbers of theorems: the paper's entry of that number contains the same formula."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import cache
from itertools import chain
from typing import Any

import pytest
import sympy

from derive.claims.equation import Entry
from derive.claims.language.names import CALL
from derive.claims.language.printed import Apply, Number, Symbol, Term
from derive.maps import Cayley, cayley_scalars
from derive.maps.cayley import EQUATIONS
from derive.papers import PAPERS
from derive.proof import evaluation
from derive.proof import notation as m
from derive.proof.calculus_theorems import GROWING_ORDER
from derive.proof.components import STATEMENTS
from derive.proof.displacement_theorems import CLOSED_AT
from derive.proof.identity import Equation
from derive.proof.phi_theorems import ANY_PHI
from derive.proof.proved import STATED

SYMBOLS = {
    **dict.fromkeys(("R", "R_s", "R_au", "R_n"), m.R), **dict.fromkeys(("q_t", "q_au", "cay_qv"), m.q_hat),
    **dict.fromkeys(("omega", "omega_v"), m.omega), **dict.fromkeys(("omega_B", "omega_vb"), m.omega_body),
    **dict.fromkeys(("v", "vq"), m.v), "I": m.I, "n": m.n, "X": sympy.sqrt(m.x), "alpha": m.alpha, "u": m.u,
    "skew_B": m.skew(m.omega_body), "Dcay_n": m.dcay, "Dcay_n_T": m.transpose(m.dcay), "Dcay_n_inv": m.dcay_inv,
    "Dcay_n_inv_T": m.transpose(m.dcay_inv), "ε": m.epsilon, "rho": m.rho, "Q": m.Q, "q_s": m.scalar, "q_v": m.vector,
    "b1": m.b_1, "b2": m.b_2, "sigma1": m.sigma_1, "sigma2": m.sigma_2, "k": m.j, "∞": sympy.oo,
}  # fmt: skip
"""Symbols of the theorems, by name in the file of the paper."""

DEFINED = {
    "pn": lambda n, x: m.p, "qn": lambda n, x: m.q, "qn2": lambda n, x: m.q**2, "group": lambda a: a,
    "upper": lambda a: a, "times": lambda a, b: a * b, "Delta": m.sandwich,
}  # fmt: skip
"""Definitions with arguments."""

STATED_OF = {
    **dict.fromkeys(("lifts", "lifts_both", "q_is"), m.q_hat), "is_sigma_composed": m.sigma, "is_b_composed": m.b,
}  # fmt: skip
"""Subjects of named relations, which are printed as equal to the arguments."""

FUNCTIONS = {
    "skew": m.skew, "transpose": m.transpose, "rate": m.rate, "det": m.det, "vect": m.vect,
    "conjugate": m.conjugate, "dyad": m.dyad, "cross": m.cross, "binomial": sympy.binomial,
    "cos": sympy.cos, "sin": sympy.sin, "exp": m.exponential, "factorial": sympy.factorial,
}  # fmt: skip


class OtherWordsError(Exception):
    """Exception for a formula with symbols or operators unknown to the theorems."""


def converted(term: Term) -> Any:
    """Return a printed formula rewritten in the symbols of the theorems."""
    if isinstance(term, Number):
        return sympy.Integer(term.value)
    if isinstance(term, Symbol):
        name = str(term.args[3])
        if name not in SYMBOLS:
            raise OtherWordsError(name)
        return SYMBOLS[name]
    assert isinstance(term, Apply)
    if name := called(term):
        arguments = list(map(converted, term.arguments[1:]))
        return DEFINED[name](*arguments) if name in DEFINED else converted(term.arguments[0])
    arguments = [converted(argument) for argument in term.arguments if not _is_bound(term, argument)]
    return _applied(term.operator.name, arguments)


def called(term: Term) -> str:
    """Return the name of the definition that a term calls, or an empty text."""
    return str(term.arguments[0].args[3]) if term.operator.name.startswith(CALL) else ""


def _is_bound(term: Apply, argument: Term) -> bool:
    """Return whether an argument is the upper bound of a sum; terms beyond it vanish."""
    return term.operator.name == "sum" and argument is term.arguments[2]


def _applied(head: str, a: list[Any]) -> Any:
    if head in FUNCTIONS:
        return FUNCTIONS[head](*a)
    if head == "norm":
        return sympy.sqrt(m.x if a[0] == m.v else m.dot(a[0], a[0]))
    if head == "root":
        return a[0].base ** (a[0].exp / 2) if a[0].is_Pow else sympy.sqrt(a[0])
    if head == "dot":
        return a[0] * a[1] if a[0].is_commutative else m.dot(*a)
    if head == "sum":
        return sympy.Sum(a[2], (a[0], a[1], sympy.oo))
    simple = {
        "plus": lambda: a[0] + a[1], "minus": lambda: a[0] - a[1], "negative": lambda: -a[0], "pm": lambda: a[0],
        "times": lambda: a[0] * a[1], "over": lambda: a[0] / a[1], "power": lambda: a[0] ** a[1],
    }  # fmt: skip
    if head not in simple:
        raise OtherWordsError(head)
    return simple[head]()


def chains(statement: Term) -> Iterator[list[Any]]:
    """Yield, for every chain of equalities, its members that can be converted."""
    if statement.operator.name == "both":
        for part in statement.arguments:
            yield from chains(part)
    elif statement.operator.name == "equal" or called(statement) in STATED_OF:
        about = STATED_OF.get(called(statement))
        members = [] if about is None else [about]
        for member in statement.arguments[about is not None :]:
            try:
                members.append(converted(member))
            except (OtherWordsError, TypeError):
                continue
        yield members


def decided_form(entry: Entry) -> Term:
    return entry.corrected if entry.corrected is not None else entry.readings[0].statement


CHAINS = {
    int(entry.number): [set(map(sympy.expand, members)) for members in chains(decided_form(entry))]
    for entry in PAPERS[0].entries() if entry.number.isdecimal()
}  # fmt: skip
RENAMED = {m.R_dual: m.R}  # tensor of a dual vector, named R in the paper


def says(number: int, equation: Equation) -> bool:
    """Return whether the entry with this number contains the equation."""
    sides = {sympy.expand(side.xreplace(RENAMED)) for side in (equation.left, equation.right)}
    return any(sides <= members for members in CHAINS[number])


@cache
def equations() -> list[Equation]:
    """Return the equations of all claims and definitions of the theorems."""
    found = [e for t in (*STATED, *chain(*CLOSED_AT.values())) for e in (*t.claim, *_definitions(t))]
    return list({(e.left, e.right, e.numbers): e for e in found}.values())


def _definitions(theorem: Any) -> Iterator[Equation]:
    return (premise.equation for premise in theorem.premises if not premise.theorem)


@pytest.mark.parametrize("equation", equations(), ids=str)
def test_numbers_of_theorems_match_entries(equation: Equation) -> None:
    same = tuple(number for number in CHAINS if says(number, equation))
    assert same == tuple(sorted(equation.numbers))


@cache
def further() -> list[Equation]:
    """Return the numbered equations on single orders, on every φ and on growing n."""
    found = [e for _, claim, premises in STATEMENTS for e in (*claim, *(premise.equation for premise in premises))]
    found += [e for t in (*ANY_PHI, *GROWING_ORDER) for e in (*t.claim, *_definitions(t))]
    return [equation for equation in found if equation.numbers]


@pytest.mark.parametrize("equation", further(), ids=str)
def test_numbers_of_further_statements_match_entries(equation: Equation) -> None:
    assert all(says(number, equation) for number in equation.numbers)


def test_most_numbers_are_cited() -> None:
    cited = {number for equation in equations() for number in equation.numbers}
    assert len(cited) >= 25


def test_wrong_number_is_noticed() -> None:
    for equation in equations():
        for number in equation.numbers:
            assert not any(says(other, equation) for other in (number - 1, number + 1) if other not in equation.numbers)


QUANTITIES = {
    "quaternion": "unit dual quaternion", "tensor": "orthogonal dual tensor", "tangent": "tangent operator",
    "tangent_inv": "kinematic tensor",
}  # fmt: skip


@pytest.mark.parametrize("n", range(1, 8))
@pytest.mark.parametrize("name", QUANTITIES)
def test_numbers_of_maps_match_entries(name: str, n: int) -> None:
    """Compare the numbers of the general equation and, if printed, of the equation at order n."""
    printed = {entry.title: int(entry.number) for entry in PAPERS[0].entries() if entry.number.isdecimal()}
    at_order = printed.get(f"{QUANTITIES[name]}, n = {n}")
    assert getattr(Cayley(n), name).equations == (*EQUATIONS[name], *([] if at_order is None else [at_order]))
    assert (at_order is not None) == (n <= 5)
    general = [number for title, number in printed.items() if title.startswith(f"{QUANTITIES[name]} of order n")]
    assert list(EQUATIONS[name]) == general


WRITTEN = [getattr(at, name) for at in (cayley_scalars, evaluation) for name in QUANTITIES if hasattr(at, name)]


@pytest.mark.parametrize("function", WRITTEN, ids=lambda function: f"{function.__module__}.{function.__name__}")
def test_numbers_in_docstrings_match_maps(function: Callable[..., Any]) -> None:
    assert function.__doc__
    cited = re.findall(r"CP23 \((\d+)\)", function.__doc__)
    assert cited == [str(EQUATIONS[function.__name__][0])]
