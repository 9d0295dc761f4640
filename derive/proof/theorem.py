"""Theorems, each with a claim, its premises, and the method to decide it.

A premise from another theorem is valid under the conditions of that theorem. Orders and definitions of symbols must
agree, and terms of sequences are taken at the replaced index.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import ClassVar

import sympy

from . import notation
from .identity import ALL_ORDERS, Checks, Equation, Premise, Proof, decide


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
        """Return all equations of the claim as premises of another theorem."""
        return tuple(self.premise(place) for place in range(len(self.claim)))

    def with_claim(self, place: int, equation: Equation) -> Theorem:
        """Return the theorem with another equation in its claim."""
        return replace(self, claim=(*self.claim[:place], equation, *self.claim[place + 1 :]))

    def with_premise(self, place: int, premise: Premise) -> Theorem:
        """Return the theorem with another premise."""
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
