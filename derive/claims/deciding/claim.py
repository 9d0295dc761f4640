"""A claim with its letters, evaluated over balls at points given by coordinates."""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from itertools import chain
from typing import Any

from ...algebra import Dual
from ...algebra.element import NotExactError
from ..equation import Entry
from ..language.environment import Env
from ..language.operator_table import both, cos, epsilon, equal, infinity, negated, sin
from ..language.printed import Apply, Number, Symbol, Term, Trait, rate_depth, symbols, walk, with_trait
from ..numbers.balls import PRECISIONS, Ball, Balls, BlurredError, arb, precision
from ..numbers.fields import Constants, Field
from ..numbers.kinds import BRANCH, KINDS, ORDER, SIGN, Kind, Numbers, jet

RELATIONS = frozenset(("less", "at most", "greater", "at least", "unlike", "equal", "nonzero"))
RATES_MAX = 2
"""Highest order of a time derivative for which letters have rates."""
FURTHER = tuple(map(Fraction, (-3, -2, -1, 1, 2, 3)))
"""Dual parts and rates of coordinates."""
ORDERS = (1, 2, 3, 4, 5)
"""Orders at which statements are tried and, without a proof for every order, proved."""
Coordinates = Mapping[Symbol, Numbers]


class RefusedError(Exception):
    """Error for a claim that the engine cannot decide, with the reason."""


@dataclass(frozen=True)
class Place:
    """Point at which a claim is evaluated.

    `generic` points are drawn without relation between letters and near 1, where a region of truth shows; `pair` ones
    have two special letters. `on` tells what is special about a point that lies on a zero set.
    """

    label: str
    at: Coordinates
    generic: bool = False
    on: str = ""
    parts: Mapping[Symbol, Numbers] = field(default_factory=dict)  # dual parts and rates, if not by a fixed seed
    pair: bool = False
    zero: Term | None = None  # number that certainly vanishes somewhere in the balls of the coordinates
    known: Mapping[Term, Term] = field(default_factory=dict)  # parts with a value that is certain there

    @property
    def exact(self) -> bool:
        """Whether all numbers are rational."""
        rows = chain(((c if isinstance(c, Iterable) else (c,)) for c in self.at.values()), self.parts.values())
        return all(isinstance(c, int | Fraction) for row in rows for c in row)


@dataclass(frozen=True)
class Claim:
    """Statement with its stated domain and the entry that contains both, and the orders at which it is tried."""

    entry: Entry
    statement: Term
    orders: Sequence[int] = ORDERS

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
    def constraints(self) -> tuple[Term, ...]:
        """Equations in the stated domain, which points must be moved to satisfy."""
        stated = self.entry.claimed
        return tuple(_equations(stated)) if stated is not None and self.entry.of_file else ()

    @cached_property
    def dual(self) -> bool:
        apart = bool(with_trait(Trait.APART, *self.parts)) or epsilon in (a for p in self.parts for a in symbols(p))
        return apart or bool(self.entry.where) or any(kind(letter).dual for letter in self.coordinates)

    @cached_property
    def depth(self) -> int:
        """Highest order of a time derivative."""
        depth = max(self.entry.moving, *map(rate_depth, self.parts))
        if depth > RATES_MAX:
            raise RefusedError(f"rates are nested more than {RATES_MAX} deep")
        return depth

    @cached_property
    def at_rest(self) -> frozenset[Symbol]:
        """Letters of a claim of a file whose rates no part asks for."""
        asked = {a for part in with_trait(Trait.RATE, *self.parts) for a in symbols(part)}
        plain = self.entry.of_file and not (self.entry.moving or self.entry.where)
        return frozenset(self.coordinates) - asked if plain else frozenset()

    def env(self, place: Place, field: Field | None = None) -> Env:
        """Return the environment at a point, over balls by default."""
        values: dict[Symbol, Any] = {a: value for a, value in place.at.items() if a not in self.coordinates}
        for letter in self.coordinates:
            values[letter] = self.value(letter, place, field)
        balls = Balls(loose=not self.entry.of_file)  # an entry of a transcript states its condition
        return Env(field or balls, values, self.entry.definitions, self.dual, self.depth)

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
        row, coordinates = kind(letter), place.at[letter]
        if row.spread == "integer" and not self.dual and not self.depth:
            return int(coordinates[0])
        number = (lambda c: c) if field else (lambda c: Ball(arb(c)))
        if row.still:
            return row.build([number(c) for c in coordinates])
        further = iter(self.further(letter, place))
        still = row.constant or row.spread == "integer"

        def coefficient(value: Any) -> Any:
            rates = [number(next(further)) for _ in range(self.depth)]
            return value if letter in self.at_rest else jet(value, [0 * rate for rate in rates] if still else rates)

        def part(c: Any) -> Any:
            value = coefficient(number(c))
            if row.dual:
                return Dual(value, coefficient(number(next(further))))
            return Dual(value, 0 * value) if self.dual and self.depth else value

        return row.build([part(c) for c in coordinates])

    def truth(self, place: Place, statement: Term | None = None) -> bool | None:
        """Return whether the claim, or another statement, is true at a point; None where it has no value.

        Raise `BlurredError` if neither the second precision, nor exact numbers, nor a certain zero tell.
        """
        part = (self.statement if statement is None else statement).xreplace(dict(place.known))
        try:
            found: bool | None = self.evaluated(place, part, bool)
            if found is False and _is_endless(part):
                raise BlurredError
        except BlurredError:
            field = Constants() if place.exact else Balls(loose=True) if place.zero in _related(part) else None
            if field is None or _is_endless(part):
                raise
            try:
                with precision(PRECISIONS[0]):
                    return bool(self.env(place, field).value(part))
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
                    if bits == PRECISIONS[-1] or not place.exact:  # else a number may only be too near 0
                        return None
                except BlurredError:
                    continue
        raise BlurredError

    def inside(self, place: Place) -> bool:
        """Return whether a point lies in the stated domain; an overlap of balls tells only of a point moved there."""
        domain = self.entry.claimed
        if domain is None:
            return True
        certain = place.exact or not self.constraints
        return bool(self.truth(place, negated(negated(domain)) if certain else domain))

    def with_statement(self, statement: Term) -> Claim:
        return replace(self, statement=statement)


def _related(statement: Term) -> tuple[Term, ...]:
    """Return the difference of both sides of a statement's only relation, which decides it; else nothing."""
    relations = [node for node in walk(statement) if node.operator.name in RELATIONS]
    if len(relations) != 1:
        return ()
    a, *rest = relations[0].arguments
    return (bare(a if not rest or rest[0] == Number(0) else a - rest[0]),)


def kind(letter: Symbol) -> Kind:
    return KINDS[letter.quantity.name]


def _equations(domain: Term) -> Iterator[Term]:
    if domain.operator is both:
        for part in domain.arguments:
            yield from _equations(part)
    elif domain.operator is equal:
        yield domain


def _is_endless(part: Term) -> bool:
    """Return whether a term has a sum without end, whose rest has no bound, so that it refutes nothing."""
    return any(node.operator.name == "sum" and infinity in node.arguments for node in walk(part))


def operators(*statements: Term) -> set[str]:
    return {node.operator.name for statement in statements for node in walk(statement)}


def bare(part: Term) -> Term:
    """Return a part without signs, brackets, powers, magnitudes and divisors, which vanishes at the same points."""
    part = _quotient(part)[0]
    name, arguments = part.operator.name, part.arguments
    power = name == "power" and isinstance(arguments[1], Number) and arguments[1].value > 0
    return bare(arguments[0]) if power or name in ("negative", "bracket", "norm", "root", "Re") else part


def _quotient(part: Term) -> tuple[Term, Term | None]:
    """Return a term as numerator and divisor; without a divisor the term itself and None."""
    name, arguments = part.operator.name, part.arguments
    if name in ("tan", "cot"):
        above, below = (sin, cos) if name == "tan" else (cos, sin)
        return above(*arguments), below(*arguments)
    if name not in ("plus", "minus", "times", "over", "negative", "bracket"):
        return part, None
    (a, b), *rest = map(_quotient, arguments)
    if not rest:
        return (part, None) if b is None else (-a if name == "negative" else a, b)
    ((c, d),) = rest
    if name == "over":
        return _product(a, d), _product(c, b)
    if b is None and d is None:
        return part, None
    if name == "times":
        return Apply("times", a, c), _product(b, d)
    return Apply(name, _product(a, d), _product(c, b)), _product(b, d)


def _product(a: Term | None, b: Term | None) -> Any:
    return b if a is None else a if b is None else a * b
