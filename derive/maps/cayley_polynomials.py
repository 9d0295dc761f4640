"""Polynomials p_n, q_n and the brackets c_n, d_n of CP23 (88), (89) at x, with their derivatives.

Above `HORNER_LIMIT` they come from the chain, divided by powers of 1 + x. With ``D = (1 + x)^⌊n/2⌋``, the divisor of p,
q and d is D, and the divisor of c, p² and x q² is D². Scalars use quotients only, where the divisors cancel.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic
from . import polynomials
from .evaluation import HORNER_LIMIT, Jet, chain, horner
from .scalars import scalar


def _polynomial(letter: str, derivative: int, by_chain: Callable[[Any, Jet, Jet], Coefficient]) -> scalar:
    """Return the scalar for a derivative of p, q, c or d, by Horner's rule or from the jets of the chain."""
    return scalar(lambda at: at._at_x(letter, derivative) if at._expanded else by_chain(at, *at._jets))


class CayleyPolynomials:
    """Polynomials of one order at x, each computed and named on first use."""

    def __init__(self, order: int, x: Coefficient, m: Arithmetic) -> None:
        self.order = order
        self.x = x
        self.m = m

    @property
    def _expanded(self) -> bool:
        """Return whether Horner's rule is used; at higher orders it loses digits on shadows."""
        return self.order <= HORNER_LIMIT

    @cached_property
    def _chain(self) -> dict[int, tuple[Jet, Jet]]:
        return chain(self.order, self.x, self._shrinking, self.m)

    _beyond_one = scalar(lambda at: 1 + at.x, "x1")

    @cached_property
    def _shrinking(self) -> Coefficient:
        """Factor ``1/(1 + x)``; NaN where 1 + x to the `CHAIN_POWER` overflows, since second slopes are wrong there."""
        square = self.m.name("x2", self._beyond_one * self._beyond_one)
        fourth = self.m.name("x4", square * square)
        return self.m.name("u", self.m.div(fourth, fourth) / self._beyond_one)

    @cached_property
    def _jets(self) -> tuple[Jet, Jet]:
        return self._chain[self.order]

    def _horner(self, name: str, polynomial: Any) -> Coefficient:
        return self.m.name(name, horner(polynomial, self.x))

    def _at_x(self, letter: str, derivative: int) -> Coefficient:
        """Return a derivative of p, q, c or d by Horner's rule."""
        pair = polynomials.ring_pair if letter in "pq" else polynomials.ring_brackets
        polynomial = pair(self.order)[letter in "qd"]
        for _ in range(derivative):
            polynomial = polynomial.diff(polynomials.RING_X)
        return horner(polynomial, self.x)

    p = _polynomial("p", 0, lambda at, p, q: p.value)  # CP23 (51)
    q = _polynomial("q", 0, lambda at, p, q: q.value)  # CP23 (52)
    dp = _polynomial("p", 1, lambda at, p, q: p.first)
    dq = _polynomial("q", 1, lambda at, p, q: q.first)
    ddq = _polynomial("q", 2, lambda at, p, q: 2 * q.half_second)
    # [n (1+x)ⁿ⁻¹ − p q]/x = 2 (p q′ − q p′)
    c = _polynomial("c", 0, lambda at, p, q: 2 * (at.p * at.dq - at.q * at.dp))
    dc = _polynomial("c", 1, lambda at, p, q: 4 * (at.p * q.half_second - at.q * p.half_second))

    @cached_property
    def _cubic(self) -> Coefficient:
        p, q = self._jets
        return 3 * (self.p * q.sixth_third - self.q * p.sixth_third)

    ddc = _polynomial("c", 2, lambda at, p, q: 4 * (at._cubic + p.first * q.half_second - q.first * p.half_second))
    # [(1+x) q − n p]/x = q − 2 q′ − 2 p′
    d = _polynomial("d", 0, lambda at, p, q: at.q - 2 * (at.dq + at.dp))
    dd = _polynomial("d", 1, lambda at, p, q: at.dq - 4 * (q.half_second + p.half_second))
    ddd = _polynomial("d", 2, lambda at, p, q: at.ddq - 12 * (q.sixth_third + p.sixth_third))
