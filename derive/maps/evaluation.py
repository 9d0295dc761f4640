"""Evaluation of p_n, q_n and their derivatives without loss of digits, by Horner's rule or a chain of doublings.

The chain divides by powers of 1 + x at each step. Every order then overflows no sooner than order 4.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce
from operator import add, sub
from typing import Any

from ..algebra import Coefficient
from ..algebra.arithmetic import Arithmetic

HORNER_LIMIT = 8
"""Largest order evaluated by Horner's rule: above it, large alternating coefficients cancel and digits are lost."""

CHAIN_POWER = 4
"""Largest power of 1/(1 + x) in second slopes: ``(1 + x)^4`` must not overflow."""


@dataclass(frozen=True, slots=True)
class Jet:
    """Taylor coefficients in x: the value, its first, half its second and a sixth of its third derivative."""

    value: Coefficient
    first: Coefficient = 0
    half_second: Coefficient = 0
    sixth_third: Coefficient = 0

    def __add__(self, other: Jet) -> Jet:
        return Jet(*map(add, self.terms, other.terms))

    def __sub__(self, other: Jet) -> Jet:
        return Jet(*map(sub, self.terms, other.terms))

    def __mul__(self, other: Jet) -> Jet:
        a, b = self.terms, other.terms
        return Jet(*(reduce(add, (a[i] * b[k - i] for i in range(k + 1))) for k in range(len(a))))

    @property
    def terms(self) -> tuple[Coefficient, Coefficient, Coefficient, Coefficient]:
        return self.value, self.first, self.half_second, self.sixth_third

    def square(self) -> Jet:
        bend = 2 * (self.value * self.half_second) + self.first * self.first
        twist = 2 * (self.value * self.sixth_third + self.first * self.half_second)
        return Jet(self.value * self.value, 2 * (self.value * self.first), bend, twist)

    def named(self, m: Arithmetic, letter: str) -> Jet:
        """Return the jet with its coefficients named p, p_x, p_xx, p_xxx."""
        suffixes = "", "_x", "_xx", "_xxx"
        return Jet(*(m.name(letter + suffix, term) for suffix, term in zip(suffixes, self.terms, strict=True)))


def horner(polynomial: Any, x: Coefficient) -> Coefficient:
    """Return the value of an element of Z[x] at a number x, by Horner's rule."""
    value: Coefficient = 0
    for power in range(max(polynomial.degree(), 0), -1, -1):
        value = value * x + int(polynomial.get((power,), 0))
    return value


def chain(order: int, x: Coefficient, shrinking: Coefficient, m: Arithmetic) -> dict[int, tuple[Jet, Jet]]:
    """Return the jets of (p_k, q_k), divided by ``(1 + x)^⌊k/2⌋``, for each k on a chain of doublings up to ``order``.

    Steps are ``p_2k = p² − x q²``, ``q_2k = 2 p q`` and ``p_(k+1) = p − x q``, ``q_(k+1) = p + q``, without alternating
    sums. Derivatives of p_k and q_k are divided by the same power. Doubling an odd k divides once more by 1 + x.
    """
    argument, two, shrink = Jet(x, 1), Jet(2), Jet(shrinking)
    k, p, q = 1, Jet(1), Jet(1)
    pairs = {1: (p, q)}
    for bit in bin(order)[3:]:
        pp, qq = p.square().named(m, f"p{k}p{k}"), q.square().named(m, f"q{k}q{k}")
        xqq = (argument * qq).named(m, f"xq{k}q{k}")
        odd = k % 2
        k *= 2
        p, q = pp - xqq, two * (p * q)
        if odd:
            p, q = p * shrink, q * shrink
        pairs[k] = p, q = p.named(m, f"p{k}"), q.named(m, f"q{k}")
        if bit == "1":
            k += 1
            p, q = p - argument * q, p + q
            pairs[k] = p, q = p.named(m, f"p{k}"), q.named(m, f"q{k}")
    return pairs
