r"""Generic values of symbols in an exact field: one evaluation decides a statement for all values, and for every order.

The frame is chosen along the vectors: the first lies on the first axis, the second in the plane of the first two axes.
The papers' operations do not depend on the frame, so no generality is lost. The magnitude X of the first vector is then
rational. X is the tangent of an angle of the field, so ``sqrt(1 + X²)`` is rational too.

Statements that separate real and dual parts (ε, Re, Du, real symbols) get dual coefficients, and the frame is chosen
along the real parts. For other statements, an identity of rational functions over Q also holds for dual numbers.

For every order n at once, n is a symbol. With ``X = tan θ`` and ``ψ = nθ``, the powers of ``1 + iX = sec θ e^(iθ)`` are
``(1 + iX)^(an+b) = r^(2a) sec^b θ e^(i(aψ + bθ))``, where ``r = (1 + X²)^(n/4)``. The quantities n, θ, ψ, r and the
tangents of θ/2 and ψ/4 are algebraically independent. Time derivatives follow by the chain rule.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import product
from math import lcm
from typing import Any

import flint

from ...algebra import Dual, Quaternion, Structure, Vector
from ...algebra.element import Element, NotExactError
from .fields import Exact, one_over
from .kinds import Role, jet, sphere, versor


class EveryOrder(Exact):
    """Field of rational functions that contains powers ``a n + b`` of 1 + X², 1 + v and their multiples.

    There is one vector v = X u of magnitude X, and one angle α = 2nθ. Multiples are products with 2n or with the symbol
    `scale`; their powers are further independent symbols.
    """

    def __init__(self, names: Sequence[str] = (), has_vector: bool = False) -> None:
        known = ("tan_theta", "n", "r", "s", "t") if has_vector else ()
        super().__init__([*names, "n", "r", "scale", "s", "t"], {"theta": 1, "psi": 2}, known)
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


LIMITS = (200, 500, 1000)
"""Largest numbers of polynomials in a basis, of terms and of bits of coefficients; a cut basis decides less."""


class Ideal:
    """Ideal of the numerators of exact numbers; `contains` is sound, and complete if the basis was not cut."""

    def __init__(self, elements: Sequence[Element]) -> None:
        self.elements = elements
        names = [f"g{i}" for i in range(len(elements[0].ring.names))]
        self._context = flint.fmpz_mpoly_ctx.get(names, flint.Ordering.degrevlex)
        given = flint.fmpz_mpoly_vec([self._integral(a) for a in elements], self._context)
        self._basis, _ = given.buchberger_naive(limits=LIMITS)

    def contains(self, element: Element) -> bool:
        return bool(self._integral(element).reduction_primitive_part(self._basis) == 0)

    def _integral(self, element: Element) -> Any:
        terms = element.ring.library.terms(element.numerator)
        scale = lcm(*(c.denominator for c in terms.values()))
        return self._context.from_dict({powers: int(c * scale) for powers, c in terms.items()})


RATES = ("˙", "¨")
STEPS = 4  # sine and cosine of multiples of α/4 are exact


class Generic:
    """Generic values of some free symbols.

    Coefficients are dual if `dual` and carry rates up to the order `moving`, as in
    `derive.claims.language.environment.Env`. Multiples of ``angle/steps`` have exact sine and cosine. A frame is chosen
    along the vectors if `framed`. The magnitude of the first vector is itself an angle if `turning`. With the symbol
    `order`, the values hold for every n; then the other symbols contain at most one vector and one angle.
    """

    def __init__(
        self, free: Iterable[Any], dual: bool, moving: int, steps: int = STEPS, framed: bool = True, order: Any = None,
        turning: bool = False,
    ) -> None:  # fmt: skip
        self.dual, self.moving, self.turning = dual, moving, turning
        self.symbols = tuple(free)
        self.framed = framed and not any(symbol.quantity.role is Role.TENSOR for symbol in self.symbols)
        self.first = next((symbol.name for symbol in self.symbols if symbol.quantity.role is Role.VECTOR), None)
        roles = [symbol.quantity.role for symbol in self.symbols]
        self.every: EveryOrder | None = None if order is None else EveryOrder(self._names(), Role.VECTOR in roles)
        magnitude = f"arctan {self.first}"  # name of the angle for the magnitude of the first vector
        positive = {magnitude if turning else f"tan_{magnitude}"} if self.framed and self.first else set()
        self.field = self.every or Exact(self._names(), self._angles(steps), positive)
        self._vectors = 0  # number of vectors along which the frame is already chosen
        self.values: dict[Any, Any] = {}
        for symbol in self.symbols:
            quantity = symbol.quantity
            exact = quantity.exact if framed or quantity.role is Role.ANGLE else quantity.built or quantity.exact
            if exact is None:
                raise NotExactError(f"no generic {quantity.name}")
            self.values[symbol] = exact(self, symbol.name)
        if self.every:
            self.values[order] = self.every.n

    def fix_branch(self, branch: Any, k: int) -> None:
        """Set the branch to k and subtract 2kπ from each angle, so that α + 2kπ is the generic angle."""
        self.values[branch] = k
        for symbol in self.symbols:
            if symbol.quantity.role is Role.ANGLE:
                self.values[symbol] -= 2 * k * self.field.pi

    # ---- values for the table of quantities, by the name of a symbol ------------------------------------------------

    def number(self, name: str, i: int = 0, at: Any = None, constant: bool = False) -> Any:
        """Return coordinate i of a symbol as a free number, with dual part and rates if needed; `at` fixes it."""

        def plain(part: str) -> Any:
            value = at if at is not None and not part else self.field.symbol(f"{name}{i}{part}")
            rates = [self.field.symbol(f"{name}{i}{part}{dots}") for dots in RATES[: self.moving]]
            return jet(value, [0 * rate for rate in rates] if constant else rates)

        return Dual(plain(""), plain("°")) if self.dual else plain("")

    def real(self, number: Any) -> Any:
        """Return the real part of a number; in motion, as a number with dual part 0."""
        if not self.dual:
            return number
        return Dual(number.re, 0 * number.re) if self.moving else number.re

    def angle(self, name: str) -> Any:
        """Return an angle with exact sine and cosine; it is 2nθ for a symbolic order."""
        return self.number(name, at=2 * self.every.n * self.every.theta if self.every else self.field.symbol(name))

    def vector(self, name: str) -> Vector:
        """Return a vector; the frame is chosen along it while axes are still free."""
        if not self.framed:
            return self._free_vector(name)
        self._vectors += 1
        zero = self.field.functions.constant(0)
        at = [self._magnitude() if self._vectors == 1 and name == self.first else None, None, None]
        at = [*at[: self._vectors], zero, zero][:3]
        return Vector(*(self.number(name, i, value) for i, value in enumerate(at)))

    def unit(self, name: str) -> Vector:
        """Return a unit vector; the frame is chosen along it while axes are still free."""
        zero = self.field.functions.constant(0)
        self._vectors += self.framed
        if self.framed and self._vectors == 1:
            u = sphere((1, self.number(name, 0, zero), self.number(name, 1, zero)))
            return Vector(u.c3, u.c1, u.c2)
        in_plane = self.framed and self._vectors == 2
        return sphere((1, self.number(name, 0), self.number(name, 1, zero if in_plane else None)))

    def turn(self, name: str) -> Quaternion:
        """Return a unit quaternion: from half angle and axis, or ``q²/|q|²`` if the field lacks the angle."""
        if self.moving:
            raise NotExactError("a moving displacement: give it by a definition")
        if name in self.field.functions.angles:
            half = self.number(name, 2, at=self.field.symbol(name))
            return Quaternion(self.field.cos(half), self.unit(name) * self.field.sin(half))
        return versor((1, *self._free_vector(name)))

    # ---- helpers --------------------------------------------------------------------------------------------------

    def _angles(self, steps: int) -> dict[str, int]:
        angles = {symbol.name: steps for symbol in self.symbols if symbol.quantity.role in (Role.ANGLE, Role.TURN)}
        return angles if self.first is None else {**angles, f"arctan {self.first}": steps if self.turning else 1}

    def _names(self) -> list[str]:
        stems = [f"{symbol.name}{i}" for symbol in self.symbols for i in range(symbol.quantity.size)]
        parts = product(stems, ("", "°") if self.dual else ("",), ("", *RATES[: self.moving]))
        return ["".join(part) for part in parts]

    def _free_vector(self, name: str) -> Vector:
        return Vector(*(self.number(name, i) for i in range(3)))

    def _magnitude(self) -> Any:
        """Return the magnitude of the first vector as the tangent of an angle, or as an angle."""
        if self.every:
            return self.every.X
        angle = self.field.symbol(f"arctan {self.first}")
        return angle if self.turning else self.field.sin(angle) / self.field.cos(angle)
