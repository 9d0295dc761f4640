"""p_n, q_n and the brackets c_n, d_n of CP23 (88) and (89) at one x, with two derivatives, named when asked for.

Those of the chain are divided by one power of 1 + x: p, q and d, which scalars take in quotients only, by the power
⌊n/2⌋, and c, as p² and x q² are, by its square.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic
from . import polynomials
from .evaluation import HORNER_LIMIT, Jet, chain, horner
from .scalar import scalar


class CayleyPolynomials:
    """The polynomials of an order at x; every value is computed, and named, when it is asked for."""

    def __init__(self, order: int, x: Coefficient, m: Arithmetic) -> None:
        self.order = order
        self.x = x
        self.m = m

    @property
    def _expanded(self) -> bool:
        """Small orders are evaluated by Horner's rule; above, it loses digits on shadows and the chain does not."""
        return self.order <= HORNER_LIMIT

    @cached_property
    def _chain(self) -> dict[int, tuple[Jet, Jet]]:
        return chain(self.order, self.x, self._shrinking, self.m)

    _beyond_one = scalar(lambda at: 1 + at.x, "x1")

    @cached_property
    def _shrinking(self) -> Coefficient:
        """``1/(1 + x)``, and NaN where `CHAIN_POWER` of it would be 0, and slopes of slopes finite and wrong."""
        square = self.m.name("x2", self._beyond_one * self._beyond_one)
        fourth = self.m.name("x4", square * square)
        return self.m.name("u", self.m.div(fourth, fourth) / self._beyond_one)

    @cached_property
    def _jets(self) -> tuple[Jet, Jet]:
        return self._chain[self.order]

    def _horner(self, name: str, polynomial: Any, derivative: int = 0) -> Coefficient:
        for _ in range(derivative):
            polynomial = polynomial.diff(polynomials.RING_X)
        return self.m.name(name, horner(polynomial, self.x))

    @cached_property
    def p(self) -> Coefficient:
        """p_n, CP23 (51)."""
        return self._horner("p", polynomials.ring_pair(self.order)[0]) if self._expanded else self._jets[0].value

    @cached_property
    def q(self) -> Coefficient:
        """q_n, CP23 (52)."""
        return self._horner("q", polynomials.ring_pair(self.order)[1]) if self._expanded else self._jets[1].value

    @cached_property
    def dp(self) -> Coefficient:
        if self._expanded:
            return self._horner("dp", polynomials.ring_pair(self.order)[0], 1)
        return self._jets[0].first

    @cached_property
    def dq(self) -> Coefficient:
        if self._expanded:
            return self._horner("dq", polynomials.ring_pair(self.order)[1], 1)
        return self._jets[1].first

    @cached_property
    def ddq(self) -> Coefficient:
        if self._expanded:
            return self._horner("ddq", polynomials.ring_pair(self.order)[1], 2)
        return self.m.name("ddq", 2 * self._jets[1].half_second)

    @cached_property
    def c(self) -> Coefficient:
        """``[n (1+x)ⁿ⁻¹ − p q]/x = 2 (p q′ − q p′)``."""
        if self._expanded:
            return self._horner("c", polynomials.ring_brackets(self.order)[0])
        return self.m.name("c", 2 * (self.p * self.dq - self.q * self.dp))

    @cached_property
    def dc(self) -> Coefficient:
        if self._expanded:
            return self._horner("dc", polynomials.ring_brackets(self.order)[0], 1)
        p, q = self._jets
        return self.m.name("dc", 4 * (self.p * q.half_second - self.q * p.half_second))

    @cached_property
    def ddc(self) -> Coefficient:
        if self._expanded:
            return self._horner("ddc", polynomials.ring_brackets(self.order)[0], 2)
        p, q = self._jets
        cubic = 3 * (self.p * q.sixth_third - self.q * p.sixth_third)
        return self.m.name("ddc", 4 * (cubic + p.first * q.half_second - q.first * p.half_second))

    @cached_property
    def d(self) -> Coefficient:
        """``[(1+x) q − n p]/x = q − 2 q′ − 2 p′``."""
        if self._expanded:
            return self._horner("d", polynomials.ring_brackets(self.order)[1])
        return self.m.name("d", self.q - 2 * (self.dq + self.dp))

    @cached_property
    def dd(self) -> Coefficient:
        if self._expanded:
            return self._horner("dd", polynomials.ring_brackets(self.order)[1], 1)
        p, q = self._jets
        return self.m.name("dd", self.dq - 4 * (q.half_second + p.half_second))

    @cached_property
    def ddd(self) -> Coefficient:
        if self._expanded:
            return self._horner("ddd", polynomials.ring_brackets(self.order)[1], 2)
        p, q = self._jets
        return self.m.name("ddd", self.ddq - 12 * (q.sixth_third + p.sixth_third))
