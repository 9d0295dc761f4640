"""A theorem: a claim, everything it takes as given, and the way in which it is decided.

What it takes from other theorems holds here under what these suppose: for their orders, with terms of the index that
theirs become, and where symbols stand for what they do there.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Protocol

import sympy

from . import notation
from .identity import ALL_ORDERS, Check, Claim, Multiplier, Proof, decide
from .statement import Equation, Premise


class Method(Protocol):
    """A way to decide a claim under premises."""

    @property
    def sides(self) -> tuple[str, ...]:
        """The sides of an equation that say something: the left one may only name what is determined."""

    @property
    def title(self) -> str:
        """How it is done, in words."""

    def weaker(self) -> Iterator[tuple[str, Method]]:
        """The method with one hypothesis less, for controls, and which."""

    def checks(self, task: Task) -> Iterator[Check | Multiplier]:
        """Residues and multipliers."""


@dataclass(frozen=True)
class Task:
    """What a method is to decide.

    Attributes
    ----------
    claim : tuple of Equation
    premises : tuple of Premise
    supposed : tuple of Equation
        What symbols stand for in the theorems that premises are taken from, which has to hold here, too.
    zeroed : Expr, optional
        A multiplier to be taken as 0, for controls.
    """

    claim: tuple[Equation, ...]
    premises: tuple[Premise, ...]
    supposed: tuple[Equation, ...] = ()
    zeroed: sympy.Expr | None = None


@dataclass(frozen=True)
class Theorem:
    """What is to be proved.

    Attributes
    ----------
    name : str
    claim : tuple of Equation
    premises : tuple of Premise
    method : Method
    scope : str
        "all n", or the one order it is about.
    """

    name: str
    claim: tuple[Equation, ...]
    premises: tuple[Premise, ...]
    method: Method
    scope: str = ALL_ORDERS

    def decide(self, known: Mapping[str, Proof], zeroed: sympy.Expr | None = None) -> Proof:
        """Decide it, given the proofs of the theorems that its premises name.

        Parameters
        ----------
        known : mapping of str to Proof
        zeroed : Expr, optional
            A multiplier to be taken as 0, for controls.
        """
        supposed = self._supposed(known)
        held = tuple(filter(self._said, supposed))

        def checks() -> Iterator[Check | Multiplier]:
            for premise in self.premises:
                if premise.theorem:
                    yield f"premise by {premise.theorem}", 0 if _is_proved(premise, known, self.scope) else 1
            yield from self.method.checks(Task(self.claim, self.premises, held, zeroed))

        laws = notation.Shifted, notation.rate, notation.prime  # they say what sequences and functions are, everywhere
        conditions = tuple(e for e in supposed if e not in held and not isinstance(e.left, laws))
        return decide(Claim(self.name, self.claim, self.method.title, self.premises, conditions), checks, self.scope)

    def _supposed(self, known: Mapping[str, Proof]) -> tuple[Equation, ...]:
        """What symbols stand for in the theorems that premises name, of those that are here and not said here."""
        own = {premise.equation.text for premise in self.premises if not premise.theorem}
        here = set().union(*(e.symbols for e in (*self.claim, *(premise.equation for premise in self.premises))))
        there = (e for premise in self.premises if premise.theorem for e in _rests_on(premise, known))
        return tuple({e.text: e for e in there if e.symbols <= here and e.text not in own}.values())

    def _said(self, equation: Equation) -> bool:
        """Whether something is said here of what an equation is about: then it has to hold, else it is a condition."""
        own = [premise.equation for premise in self.premises if not premise.theorem]
        return equation.left in {e.left for e in own} | {e.right for e in own if e.right.is_Symbol}

    def premise(self, place: int, *instance: tuple[sympy.Expr, sympy.Expr]) -> Premise:
        """An equation of the claim, as a premise of another theorem; with other symbols, if given."""
        equation = self.claim[place]
        return Premise(equation.replaced(dict(instance)) if instance else equation, self.name, instance)

    def given(self) -> tuple[Premise, ...]:
        """All equations of the claim, as premises of another theorem."""
        return tuple(self.premise(place) for place in range(len(self.claim)))

    def with_claim(self, place: int, equation: Equation) -> Theorem:
        """The theorem with another equation in its claim."""
        return replace(self, claim=(*self.claim[:place], equation, *self.claim[place + 1 :]))

    def with_premise(self, place: int, premise: Premise) -> Theorem:
        """The theorem with another premise."""
        return replace(self, premises=(*self.premises[:place], premise, *self.premises[place + 1 :]))


def _rests_on(premise: Premise, known: Mapping[str, Proof]) -> Iterator[Equation]:
    """What symbols stand for in the theorem that a premise names, and in those which that one rests on."""
    for other in known[premise.theorem].premises if premise.theorem in known else ():
        for equation in _rests_on(other, known) if other.theorem else (other.equation,):
            yield equation.replaced(dict(premise.instance))


def _is_proved(premise: Premise, known: Mapping[str, Proof], scope: str) -> bool:
    """Whether the theorem that the premise names is proved, for these orders at least, and says it."""
    proof, changes = known.get(premise.theorem), dict(premise.instance)
    if proof is None or not proof.proved or proof.scope not in (ALL_ORDERS, scope):
        return False
    said = (equation.replaced(changes) for equation in proof.claim if _keeps_terms(equation, changes))
    return any((e.left, e.right) == (premise.equation.left, premise.equation.right) for e in said)


def _keeps_terms(equation: Equation, changes: Mapping[sympy.Expr, sympy.Expr]) -> bool:
    """Whether terms of sequences in an equation become terms of the same ones, with the index as it is then.

    Where an index changes there may be no other symbols, such as dcay_n, that go with it.
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
