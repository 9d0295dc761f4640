"""The formulas of one order are the theorem's: equal as functions of x, decided in Q(x)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any, Protocol

import sympy
from sympy.polys.fields import field

from .differential_field import Formulas
from .identity import Check, Claim, Proof, decide

METHOD = "instance of the theorem for all n, residues in Q(x)"


class Coefficients(Protocol):
    """A map given by its coefficients."""

    @property
    def coefficients(self) -> tuple[sympy.Expr, ...]:
        """SymPy expressions in x."""


class CayleyFormulas(Protocol):
    """What a proof needs of a Cayley map: its order and its formulas as SymPy expressions in x."""

    @property
    def order(self) -> int: ...
    @property
    def p(self) -> sympy.Expr: ...
    @property
    def q(self) -> sympy.Expr: ...
    @property
    def c(self) -> sympy.Expr: ...
    @property
    def d(self) -> sympy.Expr: ...
    @property
    def quaternion(self) -> Coefficients: ...
    @property
    def tensor(self) -> Coefficients: ...
    @property
    def tangent(self) -> Coefficients: ...
    @property
    def tangent_inv(self) -> Coefficients: ...


def instances(cayley: CayleyFormulas) -> tuple[Proof, ...]:
    """Prove that each formula of a Cayley map is that of the theorems at its order.

    Parameters
    ----------
    cayley : CayleyFormulas
        Such as ``derive.Cayley(7)``.

    Returns
    -------
    tuple of Proof
        Of scope "n = 7": the polynomials, the quaternion (its coefficients squared, free of the root), the orthogonal
        tensor, the tangent operator and its inverse.
    """
    n = cayley.order
    functions, at = field("x", sympy.ZZ)
    p = q = functions.one
    for _ in range(n - 1):
        p, q = p - at * q, p + q
    power = (1 + at) ** n
    theorem = Formulas()

    def same(names: Sequence[str], stated: Sequence[Any], expected: Sequence[Any]) -> Iterator[Check]:
        for name, expression, value in zip(names, stated, expected, strict=True):
            yield name, functions.from_expr(expression) - value

    def polynomials() -> Iterator[Check]:
        brackets = ((n * power / (1 + at) - p * q) / at, ((1 + at) * q - n * p) / at)
        yield from same(("p", "q", "c", "d"), (cayley.p, cayley.q, cayley.c, cayley.d), (p, q, *brackets))

    def quaternion() -> Iterator[Check]:
        s, t = cayley.quaternion.coefficients
        expected = (p * p / power, p * q / power, q * q / power)
        yield from same(("scalar^2", "scalar * vector", "vector^2"), (s * s, s * t, t * t), expected)

    def isotropic(stated: Coefficients, formula: Callable[..., Sequence[Any]]) -> Callable[[], Iterator[Check]]:
        return lambda: same(("of I", "of skew(v)", "of v⊗v"), stated.coefficients, formula(n, at, p, q))

    table = (
        (Claim("p, q, c, d", "p_n, q_n, c_n, d_n", METHOD, (51, 52, 56)), polynomials),
        (Claim("quaternion, squared", r"\hat q \otimes \hat q", METHOD, (50, 55)), quaternion),
        (Claim("tensor R", "R", METHOD, (57,)), isotropic(cayley.tensor, theorem.tensor)),
        (Claim("tangent dcay", r"\mathrm{dcay}", METHOD, (88,)), isotropic(cayley.tangent, theorem.tangent)),
        (
            Claim("tangent_inv dcay^-1", r"\mathrm{dcay}^{-1}", METHOD, (89,)),
            isotropic(cayley.tangent_inv, theorem.tangent_inv),
        ),
    )
    return tuple(decide(_instance(claim), checks, f"n = {n}") for claim, checks in table)


def _instance(claim: Claim) -> Claim:
    statement = f"the coefficients of {claim.statement} are those of the theorem"
    latex = rf"{claim.latex}\text{{: coefficients as in the theorem}}"
    return Claim(statement, latex, claim.method, claim.equations)
