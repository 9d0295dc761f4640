r"""Exact evaluation of a formula for every order n at once.

The order n is a symbol. With :math:`X = \tan\theta` and :math:`\psi = n\theta`, the powers of
:math:`1 + iX = \sec\theta\, e^{i\theta}` are

.. math:: (1 + iX)^{an+b} = r^{2a} \sec^b\theta \; e^{i(a\psi + b\theta)}, \qquad r = (1 + X^2)^{n/4}

The quantities n, :math:`\theta`, :math:`\psi`, r and the tangents of :math:`\theta/2` and :math:`\psi/4` are
algebraically independent. An identity in them therefore holds for every n. Time derivatives follow by the chain rule.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import product
from typing import Any

from ...algebra import Dual, Quaternion, Structure
from ...algebra.element import Element, NotExactError
from .fields import Exact, one_over


class EveryOrder(Exact):
    """Field of rational functions that contains powers ``a n + b`` of 1 + X², 1 + v and their multiples.

    There is one vector v = X u of magnitude X, and one angle α = 2nθ. Multiples are products with 2n or with the symbol
    `scale`; their powers are further independent symbols.
    """

    def __init__(self, names: Sequence[str] = ()) -> None:
        super().__init__([*names, "n", "r", "scale", "s", "t"], {"theta": 1, "psi": 2})
        self.n, self.r, self.scale = self.symbol("n"), self.symbol("r"), self.symbol("scale")
        self.bases = ((self.scale, self.symbol("s")), (2 * self.n, self.symbol("t")))  # s = scale^(n/4), t = (2n)^(n/4)
        self.theta, self.psi = self.symbol("theta"), self.symbol("psi")
        self.secant = 1 / super()._cos(self.theta)
        self.X = super()._sin(self.theta) * self.secant  # hence secant² = 1 + X²

    def pair(self, n: Any, x: Any) -> tuple[Any, Any]:
        """Return ``p_n`` and ``q_n`` at x, from ``(1 + iX)ⁿ = p_n + i X q_n``."""
        if isinstance(n, int):
            return super().pair(n, x)
        X = self.sqrt(x)
        cosine, sine = self.turn(n, X)
        size = self.power(1 + x, n / 2)
        return size * cosine, size * sine / X

    def power(self, base: Any, exponent: Any) -> Any:
        if not isinstance(exponent, Element):
            return super().power(base, exponent)
        if isinstance(base, Quaternion):
            return self._quaternion(base, exponent)
        if isinstance(base, Structure):
            raise NotExactError("a vector or tensor has no power with exponent n")
        if isinstance(base, Dual):
            return base.apply(lambda a: self.power(a, exponent), lambda a: exponent * self.power(a, exponent) / a)
        a, b = self._linear(exponent)
        for number, power in self.bases:
            for i, j in product(range(3), range(-2, 3)):
                if base == number**i * self.secant**j:
                    of_number = power ** self._integer(4 * a * i) * number ** self._integer(b * i)
                    return of_number * self.r ** self._integer(2 * j * a) * self.secant ** self._integer(j * b)
        raise NotExactError("only 1 + v² and its multiples have powers with exponent n")

    def _quaternion(self, base: Quaternion, exponent: Element) -> Quaternion:
        """Return a power of ``c (1 + X u)``, or a root if the exponent is a multiple of 1/n."""
        try:
            self._linear(exponent)
        except NotExactError:
            return self._root(base, exponent * self.n)
        c = base.scalar
        if c != 1:
            v = base.vector * one_over(c)
            multiple: Quaternion = self.power(Quaternion(1, v), exponent) * self.power(c, exponent)
            return multiple
        X = self.magnitude(base.vector)
        cosine, sine = self.turn(exponent, X)
        size = self.power(base.norm2(), exponent / 2)
        return Quaternion(size * cosine, size * sine / X * base.vector)

    def _root(self, base: Quaternion, multiple: Element) -> Quaternion:
        """Return the power ``multiple/n`` of a unit quaternion cos ψ + u sin ψ."""
        turn = self._integer(multiple.combination((self.functions.constant(1),))[0]) * self.theta
        if base.scalar != self._cos(self.psi) or base.norm2() != 1:
            raise NotExactError("only cos α/2 + u sin α/2 has n-th roots")
        return Quaternion(self._cos(turn), base.vector / self._sin(self.psi) * self._sin(turn))

    def turn(self, exponent: Element, X: Any) -> tuple[Any, Any]:
        """Return the cosine and sine of ``exponent · arctan X``."""
        if isinstance(X, Dual):
            slope = X.du / (1 + X.re * X.re)
            cosine, sine = self.turn(exponent, X.re)
            return Dual(cosine, -exponent * sine * slope), Dual(sine, exponent * cosine * slope)
        a, b = self._linear(exponent)
        if X != self.X:
            raise NotExactError("powers with exponent n are known for one vector only")
        return self._cos(a * self.psi + b * self.theta), self._sin(a * self.psi + b * self.theta)

    def _cos(self, a: Any) -> Any:
        (c, s), (d, t) = self._parts(a)
        return c * d - s * t

    def _sin(self, a: Any) -> Any:
        (c, s), (d, t) = self._parts(a)
        return s * d + c * t

    def _parts(self, angle: Any) -> list[tuple[Any, Any]]:
        """Return (cos, sin) of both terms of an angle ``a ψ + b θ``, in which ψ may be written nθ."""
        a, also, b = self.functions.element(angle).combination((self.psi, self.theta * self.n, self.theta))
        parts = ((a + also) * self.psi, b * self.theta)
        return [(super(EveryOrder, self)._cos(part), super(EveryOrder, self)._sin(part)) for part in parts]

    def _linear(self, exponent: Element) -> tuple[Fraction, Fraction]:
        """Return (a, b) of an exponent ``a n + b``."""
        a, b = exponent.combination((self.n, self.functions.constant(1)))
        return a, b

    @staticmethod
    def _integer(a: Fraction) -> int:
        if a.denominator != 1:
            raise NotExactError(f"the exponent {a} is not an integer")
        return int(a)
