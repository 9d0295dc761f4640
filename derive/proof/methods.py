"""Theorems, each with a claim, its premises, and the method to decide it; two methods that decide a claim in a ring.

A premise from another theorem is valid under the conditions of that theorem. Orders and definitions of symbols must
agree, and terms of sequences are taken at the replaced index.

An *identity* is evaluated. A quantity *determined* by a start and a law equals every quantity with the same start and
law. Sequences start with a first term and obey a recurrence. Functions start with an initial value and obey a
differential equation.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any, ClassVar

import sympy

from . import notation
from .identity import ALL_ORDERS, Checks, Equation, Premise, Proof, decide
from .setting import Setting, Symbols


class Method(ABC):
    """Method to decide a claim under premises."""

    sides: ClassVar[tuple[str, ...]] = ("right",)
    """Sides of an equation that controls alter, without a left side that only names the unknown."""

    @property
    @abstractmethod
    def title(self) -> str:
        """Description of the method."""

    def weaker(self) -> Iterator[tuple[str, Method]]:
        """Yield each hypothesis with the method that lacks this hypothesis, for controls."""
        return iter(())

    @abstractmethod
    def checks(self, theorem: Theorem, required: tuple[Equation, ...], zeroed: sympy.Expr | None) -> Checks:
        """Yield residues and multipliers of a claim.

        The `required` definitions from cited theorems must hold too. Controls take a multiplier `zeroed` as 0.
        """


@dataclass(frozen=True)
class Theorem:
    """Statement to be proved; its scope is "all n", or one order."""

    name: str
    claim: tuple[Equation, ...]
    premises: tuple[Premise, ...]
    method: Method
    scope: str = ALL_ORDERS

    def decide(self, known: Mapping[str, Proof], zeroed: sympy.Expr | None = None) -> Proof:
        """Decide the theorem, given the proofs of cited theorems; controls take a multiplier `zeroed` as 0."""
        cited = self._cited_definitions(known)
        own = [premise.equation for premise in self.premises if not premise.theorem]
        defined = {e.left for e in own} | {e.right for e in own if e.right.is_Symbol}
        required = tuple(e for e in cited if e.left in defined)  # the other definitions are conditions

        def checks() -> Checks:
            for premise in self.premises:
                if premise.theorem:
                    yield f"premise by {premise.theorem}", 0 if _is_proved(premise, known, self.scope) else 1
            yield from self.method.checks(self, required, zeroed)

        laws = notation.Shifted, notation.rate, notation.prime  # definitions of sequences and functions hold everywhere
        conditions = tuple(e for e in cited if e not in required and not isinstance(e.left, laws))
        return decide(self.name, self.claim, self.method.title, checks, self.scope, self.premises, conditions)

    def _cited_definitions(self, known: Mapping[str, Proof]) -> tuple[Equation, ...]:
        """Return definitions from cited theorems whose symbols all occur here, without definitions repeated here."""
        own = {premise.equation.text for premise in self.premises if not premise.theorem}
        here = set().union(*(e.symbols for e in (*self.claim, *(premise.equation for premise in self.premises))))
        there = (e for premise in self.premises if premise.theorem for e in _rests_on(premise, known))
        return tuple({e.text: e for e in there if e.symbols <= here and e.text not in own}.values())

    def premise(self, place: int, *instance: tuple[sympy.Expr, sympy.Expr]) -> Premise:
        """Return an equation of the claim as a premise of another theorem, with symbols replaced."""
        equation = self.claim[place]
        return Premise(equation.replaced(dict(instance)) if instance else equation, self.name, instance)

    def given(self) -> tuple[Premise, ...]:
        return tuple(self.premise(place) for place in range(len(self.claim)))

    def with_claim(self, place: int, equation: Equation) -> Theorem:
        return replace(self, claim=(*self.claim[:place], equation, *self.claim[place + 1 :]))

    def with_premise(self, place: int, premise: Premise) -> Theorem:
        return replace(self, premises=(*self.premises[:place], premise, *self.premises[place + 1 :]))


def decided(claimed: Iterable[Theorem]) -> tuple[Proof, ...]:
    """Decide the theorems in their order; each may cite the proofs of the theorems before it."""
    known: dict[str, Proof] = {}
    for theorem in claimed:
        known[theorem.name] = theorem.decide(known)
    return tuple(known.values())


def _rests_on(premise: Premise, known: Mapping[str, Proof]) -> Iterator[Equation]:
    """Yield the definitions in the theorem that a premise cites, and in all theorems used by it."""
    for other in known[premise.theorem].premises if premise.theorem in known else ():
        for equation in _rests_on(other, known) if other.theorem else (other.equation,):
            yield equation.replaced(dict(premise.instance))


def _is_proved(premise: Premise, known: Mapping[str, Proof], scope: str) -> bool:
    """Return whether the cited theorem is proved for these orders and claims the premise."""
    proof, changes = known.get(premise.theorem), dict(premise.instance)
    if proof is None or not proof.proved or proof.scope not in (ALL_ORDERS, scope):
        return False
    claimed = (equation.replaced(changes) for equation in proof.claim if _keeps_terms(equation, changes))
    return any((e.left, e.right) == (premise.equation.left, premise.equation.right) for e in claimed)


def _keeps_terms(equation: Equation, changes: Mapping[sympy.Expr, sympy.Expr]) -> bool:
    """Return whether replaced terms are terms of the same sequences at the replaced index.

    If an index changes, the equation may not contain other symbols with this index, such as dcay_n.
    """
    known = {*notation.TERMS, *notation.INDICES, notation.x, notation.j}
    if changes.keys() & notation.INDICES and not equation.symbols <= known:
        return False
    for symbol in equation.symbols & notation.TERMS.keys():
        sequence, index = notation.TERMS[symbol]
        there = notation.TERMS.get(changes.get(symbol, symbol))
        if notation.x in changes or there != (sequence, index.xreplace(changes)):
            return False
    return True


@dataclass(frozen=True)
class InRing(Method):
    """Method that evaluates equations in the ring of the given symbols."""

    symbols: Symbols

    def names(self) -> str:
        names = ", ".join(str(symbol) for symbol in (*self.symbols.scalars, *self.symbols.vectors))
        free = ", ".join(map(str, self.symbols.free))
        return f"{names}; {free} free" if free else names

    def weaker(self) -> Iterator[tuple[str, Method]]:
        for symbol in self.symbols.free:
            rest = tuple(other for other in self.symbols.free if other != symbol)
            yield f"{symbol} not free", replace(self, symbols=replace(self.symbols, free=rest))


@dataclass(frozen=True)
class Identity(InRing):
    """Method that evaluates both sides of each equation."""

    sides = ("left", "right")

    @property
    def title(self) -> str:
        return f"identity, residues in Q[{self.names()}] localized, modulo the relations given"

    def checks(self, theorem: Theorem, required: tuple[Equation, ...], zeroed: sympy.Expr | None) -> Checks:
        setting = Setting(self.symbols, theorem.premises, (*theorem.claim, *required), zeroed)
        yield from _check_consistency(setting, theorem.premises)
        for equation in theorem.claim:
            yield from differences(setting, equation.text, equation)
        for equation in required:
            yield from differences(setting, f"required, {equation.text}", equation)


def identity(
    name: str, symbols: Symbols, claim: tuple[Equation, ...], *premises: Premise, scope: str = ALL_ORDERS
) -> Theorem:
    """Return a theorem that is an identity in the ring of the given symbols."""
    return Theorem(name, claim, premises, Identity(symbols), scope)


@dataclass(frozen=True)
class Determined(InRing):
    """Method that compares the starts and laws of both sides of each equation."""

    start: Equation  # index or variable, and its value at the start

    @property
    def by_steps(self) -> bool:
        return bool(self.start.left.is_integer)

    @property
    def title(self) -> str:
        way = "induction on" if self.by_steps else "initial value and differential equation in"
        return f"{way} {self.start.left}, residues in Q[{self.names()}] localized"

    def _check_laws(
        self, ring: Setting, starts: Container[Any], steps: Container[Any], others: Sequence[Premise]
    ) -> Checks:
        """Check that every dependent symbol has a recurrence or a differential equation among the premises."""
        index = self.start.left
        for symbol in self.symbols.scalars:
            goes = symbol != index and index in notation.TERMS.get(symbol, ("", symbol))[1].free_symbols
            known = (symbol in starts and symbol in steps) if self.by_steps else ring.has_rate(symbol)
            yield f"law of {notation.text(symbol)}", 1 if goes and not known else 0
        if self.by_steps:
            yield "premises at one index only", sum(index in premise.equation.symbols for premise in others)
        elif index in self.symbols.scalars:
            yield f"rate of {index} less 1", ring.value(notation.rate(index)) - 1

    def checks(self, theorem: Theorem, required: tuple[Equation, ...], zeroed: sympy.Expr | None) -> Checks:
        premises, index, first = theorem.premises, self.start.left, self.start.right
        starts = _laws(premises, index, first)
        steps = _laws(premises, index, index + 1)
        others = [p for p in premises if not _is_law(p.equation, index, (first, index + 1))]
        unknown = {equation.left: equation.right for equation in theorem.claim}
        terms = [Equation(right, right) for right in unknown.values()]
        ring = Setting(self.symbols, [p for p in others if _rated(p) not in unknown], terms, zeroed)
        yield from _check_consistency(ring, premises)
        for equation in required:
            yield from differences(ring, f"required, {equation.text}", equation)
        yield from self._check_laws(ring, starts, steps, others)
        at_start = {index: first} | {term: value for term, value in starts.items() if term not in unknown}
        for left, right in unknown.items():
            name = notation.text(left)
            begun = Equation(right.xreplace(at_start), starts[left])
            yield from differences(ring, f"start, {name}", begun)
            if self.by_steps:
                onward = {index: index + 1} | {t: value for t, value in steps.items() if t not in unknown}
                reached, law = right.xreplace(onward), steps[left]
            else:
                reached, law = notation.rate(right), next(p.equation.right for p in premises if _rated(p) == left)
            yield from differences(ring, f"law, {name}", Equation(reached, law.xreplace(unknown)))


def determined(
    name: str, symbols: Symbols, start: Equation, claim: tuple[Equation, ...], *premises: Premise,
    scope: str = ALL_ORDERS,
) -> Theorem:
    """Return a theorem on quantities that are determined by a start and a law."""
    return Theorem(name, claim, premises, Determined(symbols, start), scope)


def differences(setting: Setting, label: str, equation: Equation) -> Checks:
    """Yield the residues of an equation by components, and its multipliers."""
    found = setting.compared(equation)
    for place, (left, right) in enumerate(found):
        difference = left - right
        name = f"{label}, component {place + 1}" if len(found) > 1 else label
        yield name, setting.ring.residue(difference)
        yield from setting.ring.multipliers(difference.denominator)


def _check_consistency(setting: Setting, premises: Sequence[Premise]) -> Checks:
    """Check that premises are consistent.

    No left side may occur twice. Relations may not leave zero divisors or contradict each other. Their multipliers
    must be certified, and the derivation must respect them.
    """
    ring, lefts = setting.ring, [premise.equation.left for premise in premises]
    yield "left sides that occur twice", len(lefts) - len(set(lefts))
    leading = [next(iter(ring.library.terms(relation))) for relation in ring.relations]
    shared = sum(any(map(min, a, b)) for a, b in combinations(leading, 2))
    yield "relations that reduce the same symbol", shared  # if 0, the relations are a Groebner basis without 1
    for relation, denominator in zip(ring.relations, ring.cleared_by, strict=True):
        factors = sum(power for _, power in ring.library.factors(relation))
        yield f"the relation {ring.text(relation)} is irreducible", factors - 1
        yield from ring.multipliers(denominator)
    for difference in setting.relation_rates():
        yield "the rate of a relation", ring.residue(difference)
        yield from ring.multipliers(difference.denominator)


def _rated(premise: Premise) -> sympy.Expr | None:
    left = premise.equation.left
    return left.args[0] if isinstance(left, notation.rate) else None


def _is_law(equation: Equation, index: sympy.Expr, values: Iterable[sympy.Expr]) -> bool:
    left = equation.left
    return isinstance(left, notation.Shifted) and left.args[1] == index and left.args[2] in values


def _laws(premises: Iterable[Premise], index: sympy.Expr, value: sympy.Expr) -> dict[sympy.Expr, sympy.Expr]:
    """Map u to the right side of each premise ``[u](index -> value) = right side``."""
    equations = (premise.equation for premise in premises)
    return {e.left.args[0]: e.right for e in equations if _is_law(e, index, (value,))}
