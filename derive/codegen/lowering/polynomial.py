"""Evaluate the polynomials of a map: Horner's rule for small orders, the pair chain by squaring above."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ..trace import Number, Trace

HORNER_LIMIT = 8
"""Largest order evaluated by Horner's rule: above, cancellation between its large alternating coefficients shows."""


@dataclass(frozen=True, slots=True)
class Jet:
    """Taylor coefficients in x: a value, its first derivative, and half its second derivative."""

    value: Number
    first: Number = 0
    half_second: Number = 0

    def __add__(self, other: Jet) -> Jet:
        return Jet(self.value + other.value, self.first + other.first, self.half_second + other.half_second)

    def __sub__(self, other: Jet) -> Jet:
        return Jet(self.value - other.value, self.first - other.first, self.half_second - other.half_second)

    def __mul__(self, other: Jet) -> Jet:
        return Jet(
            self.value * other.value,
            self.value * other.first + self.first * other.value,
            self.value * other.half_second + self.first * other.first + self.half_second * other.value,
        )

    def square(self) -> Jet:
        bend = 2 * (self.value * self.half_second) + self.first * self.first
        return Jet(self.value * self.value, 2 * (self.value * self.first), bend)

    def named(self, trace: Trace, letter: str, mark: str) -> Jet:
        """The same jet with its coefficients named p, p_x, p_xx."""
        return Jet(
            trace.name(letter + mark, self.value),
            trace.name(f"{letter}_x{mark}", self.first),
            trace.name(f"{letter}_xx{mark}", self.half_second),
        )


def horner(polynomial: Any, x: Number) -> Number:
    """The value of an element of Z[x] at a number x by Horner's rule."""
    value: Number = 0
    for power in range(max(polynomial.degree(), 0), -1, -1):
        value = value * x + int(polynomial.get((power,), 0))
    return value


def chain(trace: Trace, order: int, x: Number, mark: str = "") -> dict[int, tuple[Jet, Jet]]:
    """Jets of (p_k, q_k) for every k on the way from 1 to ``order`` by doubling and stepping.

    ``p_2k = p² - x q²``, ``q_2k = 2 p q``; ``p_(k+1) = p - x q``, ``q_(k+1) = p + q``: no alternating sums.
    Derivatives ride along; those which nothing reads are dropped with the rest of the dead code.
    """
    argument, two = Jet(x, 1), Jet(2)
    k, p, q = 1, Jet(1), Jet(1)
    pairs = {1: (p, q)}
    for bit in bin(order)[3:]:
        pp, qq = p.square().named(trace, f"p{k}p{k}", mark), q.square().named(trace, f"q{k}q{k}", mark)
        xqq = (argument * qq).named(trace, f"xq{k}q{k}", mark)
        k *= 2
        p, q = pp - xqq, two * (p * q)
        pairs[k] = p, q = p.named(trace, f"p{k}", mark), q.named(trace, f"q{k}", mark)
        if bit == "1":
            k += 1
            p, q = p - argument * q, p + q
            pairs[k] = p, q = p.named(trace, f"p{k}", mark), q.named(trace, f"q{k}", mark)
    return pairs
