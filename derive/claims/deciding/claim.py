"""A claim with its letters, evaluated over balls at points given by coordinates."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property, reduce
from itertools import chain, product
from typing import Any

from ...algebra import Dual
from ...algebra.element import NotExactError
from ..equation import Entry
from ..language.environment import Env
from ..language.matrices import either
from ..language.operator_table import Re, both, epsilon, equal, infinity, negated
from ..language.printed import Symbol, Term, Trait, distinct, rate_depth, symbols, with_trait
from ..numbers.balls import PRECISIONS, Ball, Balls, BlurredError, arb, precision
from ..numbers.fields import Constants, Field
from ..numbers.kinds import BRANCH, KINDS, ORDER, SIGN, Kind, Numbers, jet
from .place import Place
from .terms import at_zero, conjuncts, takes_parts

RATES_MAX = 2
"""Highest order of a time derivative for which letters have rates."""
FURTHER = tuple(map(Fraction, (-3, -2, -1, 1, 2, 3)))
"""Dual parts and rates of coordinates."""
ORDERS = (1, 2, 3, 4, 5)
"""Orders at which statements are tried and, without a proof for every order, proved."""


class RefusedError(Exception):
    """Error for a claim that the engine cannot decide, with the reason."""


@dataclass(frozen=True)
class Claim:
    """Statement with its stated domain and the entry that contains both, and the orders at which it is tried."""

    entry: Entry
    statement: Term
    orders: Sequence[int] = ORDERS
    flat: bool = False  # whether numbers have neither dual parts nor rates

    @cached_property
    def parts(self) -> tuple[Term, ...]:
        """Statement, domain and condition."""
        return self.statement, *(part for part in (self.entry.claimed, self.entry.condition) if part is not None)

    @cached_property
    def letters(self) -> tuple[Symbol, ...]:
        """Free letters; raise if one has no kind."""
        found = self.entry.free(self.statement)
        for letter in found:
            if letter.quantity.name not in KINDS and letter.quantity not in (ORDER, BRANCH, SIGN):
                raise RefusedError(f"the letter {letter.name} is a {letter.quantity.name}, which cannot be drawn")
        return found

    @cached_property
    def coordinates(self) -> tuple[Symbol, ...]:
        """Letters with coordinates: all but orders and signs."""
        return tuple(letter for letter in self.letters if letter.quantity.name in KINDS)

    @cached_property
    def choices(self) -> tuple[dict[Symbol, int], ...]:
        """Values of orders, branches and signs, all letters of a kind alike."""
        order, branch, sign = ([a for a in self.letters if a.quantity is row] for row in (ORDER, BRANCH, SIGN))
        orders = tuple(n for n in self.orders if self.entry.orders is None or n in self.entry.orders)
        return tuple(
            {**dict.fromkeys(order, n), **dict.fromkeys(branch, k), **dict.fromkeys(sign, s)}
            for n in (orders or self.entry.orders or self.orders if order else (1,))
            for k in range(n if branch else 1) for s in ((1, -1) if sign else (1,))
        )  # fmt: skip

    @cached_property
    def general(self) -> tuple[dict[Symbol, int], ...]:
        """Values of signs alone if orders and branches are free in a proof, else also of these."""
        if self.entry.orders is not None:
            return self.choices
        signs = [{a: s for a, s in fixed.items() if a.quantity is SIGN} for fixed in self.choices]
        return tuple(row for i, row in enumerate(signs) if row not in signs[:i])

    @cached_property
    def domain(self) -> tuple[Term, ...]:
        """Relations of the stated domain."""
        return tuple(conjuncts(self.entry.claimed))

    @cached_property
    def constraints(self) -> tuple[Term, ...]:
        """Equations in the stated domain, which points must be moved to satisfy."""
        return tuple(part for part in self.domain if part.operator is equal)

    @cached_property
    def aims(self) -> tuple[Claim, ...]:
        """Claims on the alternatives of the stated domain, to whose equations points must be moved."""
        stated = self.entry.claimed
        alternatives = [] if stated is None else map(self.on, _alternatives(stated))
        return tuple(claim for claim in alternatives if claim.constraints)

    @cached_property
    def apart(self) -> bool:
        """Whether dual parts are taken, or given."""
        return takes_parts(*self.parts)

    @cached_property
    def dual(self) -> bool:
        dual = self.apart or any(kind(letter).dual for letter in self.coordinates)
        return dual and not self.flat

    @cached_property
    def depth(self) -> int:
        """Highest order of a time derivative."""
        depth = max(map(rate_depth, self.parts))
        if depth > RATES_MAX:
            raise RefusedError(f"rates are nested more than {RATES_MAX} deep")
        return 0 if self.flat else depth

    @cached_property
    def at_rest(self) -> frozenset[Symbol]:
        """Letters whose rates no part asks for."""
        asked = {a for part in with_trait(Trait.RATE, *self.parts) for a in symbols(part)}
        return frozenset(self.coordinates) - asked

    def env(self, place: Place, field: Field | None = None) -> Env:
        """Return the environment at a point, over balls by default."""
        values: dict[Symbol, Any] = {a: value for a, value in place.at.items() if a not in self.coordinates}
        for letter in self.coordinates:
            values[letter] = self.value(letter, place, field)
        if self.flat:
            values[epsilon] = 0
        return Env(field or Balls(moving=bool(self.depth)), values, self.dual, self.depth)

    @cached_property
    def _last(self) -> dict[str, Any]:
        return {}

    def _env_at(self, place: Place, bits: int) -> Env:
        """Return the environment at a point; domain, condition and statement share the last one."""
        if self._last.get("place") is not place or self._last["bits"] != bits:
            self._last.update(place=place, bits=bits, env=self.env(place))
        found: Env = self._last["env"]
        return found

    def further(self, letter: Symbol, place: Place) -> Numbers:
        """Return the dual parts and rates of a letter's coordinates, by a fixed seed if the point gives none."""
        row = kind(letter)
        if letter in place.parts:
            return place.parts[letter]
        source = random.Random(f"{letter.name} {place.label}")
        count = row.size * ((1 + self.depth) * (1 + row.dual) - 1)
        return [source.choice(FURTHER) for _ in range(count)]

    def value(self, letter: Symbol, place: Place, field: Field | None = None) -> Any:
        """Return the value of a letter: each coordinate with its rates, its dual part and the rates of this."""
        row, coordinates, over = kind(letter), place.at[letter], place.over_pi(letter)
        if field is not None and over is not None:
            coordinates = [field.pi * c for c in over]
        if row.spread == "integer" and not self.dual and not self.depth:
            return int(coordinates[0])
        number = (lambda c: c) if field else (lambda c: Ball(arb(c)))
        if row.still:
            return row.build([number(c) for c in coordinates])
        further = iter(() if self.flat else self.further(letter, place))
        still = row.constant or row.spread == "integer"

        def coefficient(value: Any) -> Any:
            rates = [number(next(further)) for _ in range(self.depth)]
            return value if letter in self.at_rest else jet(value, [0 * rate for rate in rates] if still else rates)

        def part(c: Any) -> Any:
            value = coefficient(number(c))
            if row.dual and not self.flat:
                return Dual(value, coefficient(number(next(further))))
            return Dual(value, 0 * value) if self.dual and self.depth else value

        return row.build([part(c) for c in coordinates])

    def truth(self, place: Place, statement: Term | None = None) -> bool | None:
        """Return whether the claim, or another statement, is true at a point; None where it has no value.

        Raise `BlurredError` if neither the second precision nor exact numbers tell.
        """
        part = self.statement if statement is None else statement
        part = at_zero(part, place.zero, self.dual).xreplace(dict(place.known))
        try:
            found: bool | None = self.evaluated(place, part, bool)
            if found is False and _is_endless(part):
                raise BlurredError
            if found is False and any(node.operator.name.startswith("cases") for node in distinct(part)):
                found = not self.evaluated(place, negated(part), bool)  # with certain cases
        except BlurredError:
            if not place.exact or _is_endless(part):
                raise
            try:
                return bool(self.env(place, Constants()).value(part))
            except (ArithmeticError, TypeError, AttributeError) as error:
                raise BlurredError from error
        return found

    def evaluated(self, place: Place, part: Term, form: Any = lambda a: a) -> Any:
        """Return the value of a term at a point, or None where it has no value."""
        for bits in PRECISIONS:
            with precision(bits):
                try:
                    return form(self._env_at(place, bits).value(part))
                except NotExactError:
                    raise
                except ArithmeticError:
                    if bits == PRECISIONS[-1] or not place.sharp:  # else a number may only be too near 0
                        return None
                except BlurredError:
                    continue
        raise BlurredError

    def inside(self, place: Place) -> bool:
        """Return whether a point lies in the stated domain; an overlap of balls tells only of a point moved there."""
        domain = self.entry.claimed
        if domain is None:
            return True
        certain = place.exact or not self.aims
        return bool(self.truth(place, negated(negated(domain)) if certain else domain))

    def with_statement(self, statement: Term) -> Claim:
        return replace(self, statement=statement)

    def of_number(self, part: Term) -> Claim:
        """Return the claim about the current real value of a part, if dual parts and rates do not matter for it."""
        alone = self.within().with_statement(part)
        taken = [node for node in with_trait(Trait.APART, part) if node.operator is not Re]
        return alone if taken or with_trait(Trait.RATE, part) else replace(alone, flat=True)

    def within(self, *terms: Term) -> Claim:
        """Return the claim on the part of its stated domain where some terms are true, without a condition."""
        stated = (*([] if self.entry.claimed is None else [self.entry.claimed]), *terms)
        return self.on(reduce(both, stated) if stated else None)

    def on(self, domain: Term | None) -> Claim:
        """Return the claim on another domain, without a condition."""
        return replace(self, entry=replace(self.entry, claimed=domain, condition=None))


def kind(letter: Symbol) -> Kind:
    return KINDS[letter.quantity.name]


def _alternatives(domain: Term) -> Iterator[Term]:
    """Yield the domains that a domain joins by "or"."""
    if domain.operator is either:
        yield from chain.from_iterable(map(_alternatives, domain.arguments))
    elif domain.operator is both:
        yield from (reduce(both, parts) for parts in product(*map(_alternatives, domain.arguments)))
    else:
        yield domain


def _is_endless(part: Term) -> bool:
    """Return whether a term has a sum without end, whose rest has no bound, so that it refutes nothing."""
    return any(node.operator.name == "sum" and infinity in node.arguments for node in distinct(part))
