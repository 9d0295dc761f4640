"""The scalars of one chart point, traced: x = v·v, p_n, q_n, the coefficients of R and dcay and their x-derivatives.

Every tensor of a Cayley map is made of three scalars f, g, h of x (CP23 (57), (88))::

    R    = I + f skew(v) + g skew(v)²        dcay = f I + g skew(v) + h v⊗v
    f = 2pq/N    g = 2q²/N    h = 2c/N       N = p² + x q² = (1 + x)ⁿ

so the dual part of R is the translation rho = Re(dcay) v°, and no tensor needs more than f', g', h'.
N is computed as p² + x q²: its rounding error then stays independent of n.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from ...algebra import Vector
from ...maps import polynomials
from ..trace import Number, Trace
from .polynomial import HORNER_LIMIT, Jet, chain, horner


class CayleyChart:
    """Traced scalars at one Rodrigues dual vector; ``mark`` tells two vectors of one program apart."""

    def __init__(self, trace: Trace, order: int, components: Sequence[Number], mark: str = "") -> None:
        self.trace = trace
        self.order = order
        self.mark = mark
        self.re = Vector(*components[:3])
        self.du = Vector(*components[3:6])

    def name(self, letter: str, value: Number) -> Number:
        return self.trace.name(letter + self.mark, value)

    @cached_property
    def squares(self) -> tuple[Number, Number, Number]:
        """v1², v2², v3²."""
        names = ("v11", "v22", "v33")
        first, second, third = (self.name(name, c * c) for name, c in zip(names, self.re, strict=True))
        return first, second, third

    @cached_property
    def x(self) -> Number:
        first, second, third = self.squares
        return self.name("x", first + second + third)

    @cached_property
    def y(self) -> Number:
        """v·v°, half the dual part of x."""
        return self.name("y", self.re.dot(self.du))

    @cached_property
    def k(self) -> Number:
        return self.name("k", 1 + self.x)

    # --- polynomials ------------------------------------------------------------------------------------------

    @cached_property
    def _half(self) -> tuple[Number, Number]:
        """p and q of half the order."""
        half = self.order // 2
        if self._expanded:
            p, q = polynomials.ring_pair(half)
            return self.name("ph", horner(p, self.x)), self.name("qh", horner(q, self.x))
        p, q = self._chain[half]
        return p.value, q.value

    @property
    def _expanded(self) -> bool:
        """Small orders are evaluated by Horner's rule; above, it loses digits on shadows and the chain does not."""
        return self.order <= HORNER_LIMIT

    @cached_property
    def _chain(self) -> dict[int, tuple[Jet, Jet]]:
        return chain(self.trace, self.order, self.x, self.mark)

    @cached_property
    def _jets(self) -> tuple[Jet, Jet]:
        return self._chain[self.order]

    @cached_property
    def p(self) -> Number:
        if self._expanded:
            return self.name("p", horner(polynomials.ring_pair(self.order)[0], self.x))
        return self._jets[0].value

    @cached_property
    def q(self) -> Number:
        if self._expanded:
            return self.name("q", horner(polynomials.ring_pair(self.order)[1], self.x))
        return self._jets[1].value

    @cached_property
    def dp(self) -> Number:
        if self._expanded:
            return self.name("dp", horner(polynomials.ring_pair(self.order)[0].diff(polynomials.RING_X), self.x))
        return self._jets[0].first

    @cached_property
    def dq(self) -> Number:
        if self._expanded:
            return self.name("dq", horner(polynomials.ring_pair(self.order)[1].diff(polynomials.RING_X), self.x))
        return self._jets[1].first

    @cached_property
    def c(self) -> Number:
        """[n (1+x)^(n-1) - p q] / x = 2 (p q' - q p')."""
        if self._expanded:
            return self.name("c", horner(polynomials.ring_brackets(self.order)[0], self.x))
        return self.name("c", 2 * (self.p * self.dq - self.q * self.dp))

    @cached_property
    def dc(self) -> Number:
        if self._expanded:
            return self.name("dc", horner(polynomials.ring_brackets(self.order)[0].diff(polynomials.RING_X), self.x))
        p, q = self._jets
        return self.name("dc", 4 * (self.p * q.half_second - self.q * p.half_second))

    @cached_property
    def d(self) -> Number:
        """[(1+x) q - n p] / x = q - 2 q' - 2 p'."""
        if self._expanded:
            return self.name("d", horner(polynomials.ring_brackets(self.order)[1], self.x))
        return self.name("d", self.q - 2 * (self.dq + self.dp))

    @cached_property
    def dd(self) -> Number:
        if self._expanded:
            return self.name("dd", horner(polynomials.ring_brackets(self.order)[1].diff(polynomials.RING_X), self.x))
        p, q = self._jets
        return self.name("dd", self.dq - 4 * (q.half_second + p.half_second))

    # --- coefficients -----------------------------------------------------------------------------------------

    @cached_property
    def qq(self) -> Number:
        return self.name("qq", self.q * self.q)

    @cached_property
    def norm(self) -> Number:
        """N = p² + x q² = (1 + x)ⁿ."""
        return self.name("N", self.p * self.p + self.x * self.qq)

    @cached_property
    def root(self) -> Number:
        """√N: for an even order the norm of half the order, no square root taken."""
        if self.order % 2:
            return self.name("root", self.trace.sqrt(self.norm))
        p, q = self._half
        return self.name("root", p * p + self.x * (q * q))

    @staticmethod
    def _reciprocal(norm: Number) -> Number:
        """(N/N)/N: NaN where N has overflowed, and 1/N would be a finite, wrong result."""
        return norm / norm / norm

    @cached_property
    def _twice_inverse_norm(self) -> Number:
        return self.name("s", 2 * self._reciprocal(self.norm))

    @cached_property
    def f(self) -> Number:
        return self.name("f", self.p * self.q * self._twice_inverse_norm)

    @cached_property
    def g(self) -> Number:
        return self.name("g", self.qq * self._twice_inverse_norm)

    @cached_property
    def h(self) -> Number:
        return self.name("h", self.c * self._twice_inverse_norm)

    @cached_property
    def _growth(self) -> Number:
        """N'/N = n / (1 + x)."""
        return self.name("e", self.order / self.k)

    @cached_property
    def _growing_g(self) -> Number:
        return self.name("eg", self._growth * self.g)

    @cached_property
    def df(self) -> Number:
        """f' = h/2 - n g/(1+x)."""
        return self.name("df", self.h / 2 - self._growing_g)

    @cached_property
    def dg(self) -> Number:
        slope = self.q * self.dq * self._twice_inverse_norm
        return self.name("dg", 2 * slope - self._growing_g)

    @cached_property
    def dh(self) -> Number:
        return self.name("dh", self.dc * self._twice_inverse_norm - self._growth * self.h)

    @cached_property
    def quaternion(self) -> tuple[Number, Number, Number, Number]:
        """Scalar part, factor of v in the vector part, and the dual parts of both."""
        s = self.name("sr", self._reciprocal(self.root))
        scalar = self.name("sc", self.p * s)
        factor = self.name("w", self.q * s)
        decay = self.name("minus_e", -self.order / self.k)
        scalar_du = self.name("sco", factor * (decay * self.y))
        factor_du = self.name("wo", 2 * self.dq * (self.y * s) + scalar_du)
        return scalar, factor, scalar_du, factor_du

    # --- coefficients of the inverse operator f I - skew(v)/2 + h v⊗v -----------------------------------------

    @cached_property
    def _half_inverse_q(self) -> Number:
        return self.name("iq", self.trace.div(1, 2 * self.q))

    @cached_property
    def inverse(self) -> tuple[Number, Number]:
        """fi = p/(2q) and hi = d/(2nq)."""
        return (
            self.name("fi", self.p * self._half_inverse_q),
            self.name("hi", self.trace.div(self.d * self._half_inverse_q, self.order)),
        )

    @cached_property
    def inverse_derivatives(self) -> tuple[Number, Number]:
        """fi' = -c/(4q²) and hi' = (d' - d q'/q)/(2nq)."""
        half = self._half_inverse_q
        return (
            self.name("dfi", -(self.c * (half * half))),
            self.name("dhi", (self.dd - 2 * (self.d * self.dq * half)) * half / self.order),
        )
