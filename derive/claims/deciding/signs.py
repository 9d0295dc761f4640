"""Signs of exact numbers on a stated domain: which are 0 nowhere, and which are not negative.

A number has one sign where its factors have; a domain or a condition keeps further ones from 0.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from dataclasses import field as of_class
from fractions import Fraction
from typing import Any

import sympy

from ...algebra import Tensor
from ...algebra.element import Element, NotExactError
from ...algebra.matrix import Matrix
from ..language.environment import Env
from ..language.operator_table import RELATIONS, Du, Re, difference, nonzero
from ..language.printed import Number, Term
from ..numbers.fields import innermost
from ..numbers.ideal import Ideal
from ..numbers.intervals import interval
from .claim import Claim, kind
from .far import is_apart_at_infinity
from .identity import ABSENT, not_negative
from .partial import partial_operations, real
from .singular import size
from .terms import STRICT, is_dual, is_frame_free

MARGIN = Fraction(1, 1000)
"""Distance from 0 of a number that is proved not to be 0 at generic values, so it is 0 nowhere."""
DEPTH = 4
"""Largest number of roots and logarithms that a proof of a sign takes in turn."""


@dataclass(frozen=True)
class Signs:
    """Numbers over a field of generators, and factors that a domain or condition keeps from 0."""

    env: Env
    nonzero: list[Any] = of_class(default_factory=list)
    apart: list[Element] = of_class(default_factory=list)  # numbers that are not 0
    named: list[Term] = of_class(default_factory=list)  # terms that are not 0
    free: bool = False  # whether a frame may be turned so that no direction is the one that polar forms leave out
    numbers: frozenset[str] = frozenset()  # letters that are numbers, whose polar form leaves nothing out
    outward: tuple[str, ...] = ()  # coordinates that are infinite for the direction that a letter's form leaves out

    @property
    def field(self) -> Any:
        """Return the field of generators."""
        return self.env.field

    @property
    def ring(self) -> Any:
        """Return the ring of the field, which knows signs."""
        return self.field.ring

    def number(self, part: Term, of: Any = size) -> Element:
        """Return a number of a term as an exact number, or raise one of ABSENT."""
        found: Element = self.field.element(of(self.env.now(self.env.value(part))))
        return found

    def _is_matrix(self, part: Term) -> bool:
        """Return whether a term may be a matrix, which may have no inverse where it is not 0."""
        with suppress(*ABSENT):
            return isinstance(self.env.value(real(part)), Tensor | Matrix)
        return True

    def assume(self, part: Term) -> None:
        """Note what a relation of a stated domain, or of a condition, says of numbers; its own divisors are not 0."""
        name, arguments = part.operator.name, part.arguments
        try:
            for one, asked in partial_operations(part, lambda a: False) if name in RELATIONS else ():
                if asked == "not 0" and not self._is_matrix(one):
                    self.named.append(one)
                    self.nonzero.extend(self.ring.factors(self.number(one)))
            if name in ("unlike", "nonzero"):
                gap = difference(part)
                self.named.extend([] if is_dual(gap) or self._is_matrix(gap) else [real(gap)])
                self._keep_from_0(self._not_0(gap))
            elif name == "equal" and part.arguments[1] != Number(0) and isinstance(part.arguments[1], Number):
                self.apart.append(self.number(part.arguments[0]))
            elif name in STRICT:
                number = self.field.element(not_negative(self.env, part))
                lesser, greater = arguments if name in ("less", "at most") else arguments[::-1]
                found = [number, *self._squared(number)]
                if lesser.operator.name == "norm" and isinstance(greater, Number):
                    found.append(self.number(greater**2 - lesser**2))
                self.field.assumed += found
                for one in found if STRICT[name] else ():
                    self._keep_from_0(one)
            elif name in ("both", "and"):
                for one in arguments:
                    self.assume(one)
        except ABSENT:
            return

    def _keep_from_0(self, a: Element) -> None:
        self.apart.append(a)
        self.nonzero.extend(self.ring.factors(a))

    def _not_0(self, part: Term) -> Element:
        """Return a number that is not 0 where a term is not 0: of a dual one its dual part, if the real part is 0."""
        if self._is_matrix(part):
            raise NotExactError("a determinant may be 0")
        if not is_dual(part):
            return self.number(part)
        if not self.env.dual or not self.field.same(self.number(part), 0):
            raise NotExactError("the real part of a dual number that is not 0 may be 0")
        return self.number(Du(part))

    def _squared(self, gap: Element) -> Iterator[Element]:
        """Yield ``a a - b b r r`` for a number ``a - b r`` that is not negative, with a root r and positive a and b."""
        for _, name in self.field.extensions:
            part = -self._lone(gap, name) * self.field.symbol(name)
            if part and self.field.is_positive(part) and self.field.is_positive(gap + part):
                yield (gap + part) ** 2 - part**2

    def is_nonzero(self, a: Element) -> bool:
        """Return whether a number is proved to be 0 nowhere."""
        if a in self.apart or -a in self.apart:
            return True
        a = self._without_quotients(a)
        far = bool(a) and is_apart_at_infinity(self, a) and (all(map(self._is_apart, self.ring.factors(a))) or (
            not self.free and any(self.field.is_positive(b - MARGIN) for b in (a, -a))) or self._is_excluded(a))
        return far or (bool(a) and self._is_above_square(a))

    def _without_quotients(self, a: Element) -> Element:
        """Return a number without the quotients of tangents and their angles, which are 0 nowhere."""
        rows = [self.ring.library.factors(part) for part in (a.numerator, a.denominator)]

        def power(factors: Any, of: Element) -> int:
            return next((count for factor, count in factors if factor == of.numerator), 0)

        for angle, name in self._tangents():
            tangent = self.field.symbol(name)
            for (above, below), sign in ((rows, 1), (rows[::-1], -1)):
                a = a * (angle / tangent) ** (sign * min(power(above, tangent), power(below, angle)))
        return a

    def _is_above_square(self, a: Element) -> bool:
        """Return whether a number is at least the square of one that is not 0, up to its sign."""
        with suppress(NotExactError):
            return any(self.is_positive(b - known * known, depth=0) for known in self.apart for b in (a, -a))
        return False

    def _is_excluded(self, a: Element) -> bool:
        """Return whether with a number one would be 0 that is not, by the equations of the domain."""
        return bool(self.gaps) and any(map(Ideal([*self.gaps, a]).contains, self.apart))

    @property
    def gaps(self) -> Sequence[Element]:
        """Numbers that the equations of the domain make 0."""
        found: Sequence[Element] = () if self.field.ideal is None else self.field.ideal.elements
        return found

    def _is_apart(self, factor: Any) -> bool:
        """Return whether a factor is 0 nowhere; that of several letters also in limits of polar forms."""
        if factor in (self.ring.library.one, *self.nonzero) or self._is_function_apart(factor):
            return True
        if any(factor == self.field.product(monomial).numerator and self.field.symbol(name).numerator in self.nonzero
               for (what, monomial), name in self.field.meanings.items() if what == "tangent"):  # fmt: skip
            return True  # the angle is not 0, for its tangent is not
        if any(self._is_above(factor, known * known) for known in self.nonzero):
            return True
        if not self.ring.definite(factor, strict=True):
            return False
        letters = self._letters(self.ring.fraction(factor, self.ring.library.one))
        reached = self.free or len(letters) < 2  # no direction that polar forms leave out
        return letters <= self.numbers or (reached and self.ring.definite(factor, strict=True, limits=True))

    def _is_above(self, factor: Any, square: Any) -> bool:
        """Return whether a factor has one sign even without a multiple of a square of this sign."""
        terms, other = (self.ring.library.terms(a) for a in (factor, square))
        ratios = {terms[powers] / c for powers, c in other.items() if powers in terms}
        a, b = (self.ring.fraction(polynomial, self.ring.library.one) for polynomial in (factor, square))
        return any(self.is_positive((a - ratio * b) * (1 if ratio > 0 else -1), depth=0) for ratio in ratios)

    def _letters(self, a: Element) -> set[str]:
        """Return the names of the letters on which a number depends."""
        meaning = self.field.meaning

        def of(number: Any, above: frozenset[str]) -> Iterator[str]:
            for name in self.field.used(number):
                known = meaning.get(name, ("", ()))[1]
                parts = known if isinstance(known, tuple) else (known,)
                if not parts or name in above:  # an angle may be that of a point given by its own tangent
                    yield name.split(".")[0]
                for part in parts if name not in above else ():
                    yield from of(part, above | {name}) if isinstance(part, Element) else ()

        return {*of(a, frozenset())} - {"pi"}

    def _is_function_apart(self, factor: Any) -> bool:
        """Return whether a factor is 0 nowhere, since a number is not of which it is a root, a power or a tangent."""
        rows = (*self.field.extensions, *self.field.powers.values(), *self._tangents())
        return any(self.is_nonzero(base) for base, name, *_ in rows if factor == self.field.symbol(name).numerator)

    def _tangents(self) -> Iterator[tuple[Element, str]]:
        """Yield the angles, with their tangents, for which 0 is the only angle with tangent 0."""
        for (what, monomial), name in self.field.meanings.items():
            if what == "tangent" and max(map(abs, interval(self.field, monomial))) < 2 * self.field.steps * sympy.pi:
                yield self.field.product(monomial), name

    def is_positive(self, a: Element, strict: bool = False, depth: int = DEPTH) -> bool:
        """Return whether a number is proved not to be negative, or to be positive if `strict`.

        Of ``a + b r`` with a root r the squares tell, of ``a + b log(c)`` the exponentials.
        """
        if not strict and (not a or self.field.is_positive(a)):
            return True
        if strict and self.field.is_positive(a) and self.is_nonzero(a):
            return True
        return bool(depth) and (
            self._is_above_root(a, strict, depth - 1) or self._is_above_logarithm(a, strict, depth - 1)
            or self._is_above_assumed(a, strict)
        )  # fmt: skip

    def is_above(self, part: Term, strict: bool = False) -> bool:
        """Return whether a term is a number that is proved not to be negative, or to stay above 0, also by its form.

        The numbers of a large sum may be too large to be evaluated, such as the square of a magnitude in it.
        """
        name, arguments = part.operator.name, part.arguments
        if name == "plus":
            return all(map(self.is_above, arguments)) and (not strict or any(self.is_above(a, True) for a in arguments))
        is_power = name == "power" and isinstance(arguments[1], Number) and arguments[1].value > 0
        if (is_power or name == "bracket") and self.is_above(arguments[0], strict):
            return True
        if not strict and (name == "norm" or (name == "dot" and arguments[0] == arguments[1])):
            return True
        with suppress(*ABSENT):
            return self.is_positive(self.number(part, innermost) - (MARGIN if strict else 0))
        return False

    def _lone(self, a: Element, name: str) -> Element:
        """Return the factor of a generator in a number, if it occurs to the first power only."""
        found: Element = self.ring.fraction(a.numerator.derivative(self.ring.index(name)), a.denominator)
        return found

    def _is_above_root(self, a: Element, strict: bool, depth: int) -> bool:
        for _, name in self.field.extensions:
            part = self._lone(a, name) * self.field.symbol(name)
            for one, other in ((a - part, part), (part, a - part)) if part else ():
                if self.is_positive(one, False, depth) and self.is_positive(one * one - other * other, strict, depth):
                    return True
        return False

    def _is_above_logarithm(self, a: Element, strict: bool, depth: int) -> bool:
        for known, logarithm in self.field.logarithms:
            lone = self._lone(a, str(logarithm))
            with suppress(NotExactError):
                if lone and self.field.is_positive(lone):
                    return self.is_positive(known - self.field.exp(-(a - lone * logarithm) / lone), strict, depth)
        return False

    def _is_above_assumed(self, a: Element, strict: bool) -> bool:
        """Return whether a number is positive even without a multiple of one that is assumed not to be negative."""
        for known in self.field.assumed:
            top, bottom = (self.ring.library.terms(b.numerator) for b in (a, known))
            ratios = {top[powers] / c for powers, c in bottom.items() if powers in top}
            if any(self.is_positive(a - ratio * known, strict, 0) for ratio in ratios if ratio > 0):
                return True
        return False


def signs_in(claim: Claim, env: Env, condition: Sequence[Term] = ()) -> Signs:
    """Return the signs in an environment over generators, with what domain and condition say."""
    domain = [nonzero(Re(a)) for a in claim.coordinates if kind(a).invertible]
    domain += [] if claim.entry.claimed is None else [claim.entry.claimed]
    free = is_frame_free(*claim.parts) and not any(kind(a).projective and kind(a).size == 4 for a in claim.coordinates)
    outward = (f"{a.name}.{stem}" for a in claim.coordinates for stem in ("s", *(["1"] if kind(a).projective else [])))
    signs = Signs(env, free=free, numbers=frozenset(a.name for a in claim.coordinates if kind(a).size == 1),
                  outward=tuple(outward))  # fmt: skip
    for part in (*domain, *condition):
        signs.assume(part)
    return signs
