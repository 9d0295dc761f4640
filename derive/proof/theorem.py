"""A theorem: a claim, everything it takes as given, and the way in which it is decided.

There are two ways in a ring. An *identity* is evaluated. What is *determined* by a start and a law (a sequence by its
first term and its recurrence, a function by its initial value and its differential equation) equals what has the same
start and obeys the same law; which of the two it is, the premises say.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Any, Protocol

import sympy

from . import marks
from .identity import ALL_ORDERS, Check, Claim, Multiplier, Proof, decide
from .setting import Letters, Setting
from .statement import Equation, Premise


class Method(Protocol):
    """A way to decide a claim under premises."""

    @property
    def sides(self) -> tuple[str, ...]:
        """The sides of an equation that say something: the left one may only name what is determined."""

    @property
    def title(self) -> str:
        """How it is done, in words."""

    def checks(
        self, claim: Sequence[Equation], premises: Sequence[Premise], zeroed: sympy.Expr | None
    ) -> Iterator[Check | Multiplier]:
        """Residues and multipliers."""


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

        def checks() -> Iterator[Check | Multiplier]:
            for premise in self.premises:
                if premise.theorem:
                    yield f"premise by {premise.theorem}", 0 if _is_proved(premise, known) else 1
            yield from self.method.checks(self.claim, self.premises, zeroed)

        return decide(Claim(self.name, self.claim, self.method.title, self.premises), checks, self.scope)

    def premise(self, place: int, *instance: tuple[sympy.Expr, sympy.Expr]) -> Premise:
        """An equation of the claim, as a premise of another theorem; with other letters, if given."""
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


def _is_proved(premise: Premise, known: Mapping[str, Proof]) -> bool:
    """Whether the theorem that the premise names is proved and says it, or whether it is altered for a control."""
    proof = known.get(premise.theorem)
    if proof is None or not proof.proved:
        return False
    said = (equation.replaced(dict(premise.instance)) for equation in proof.claim)
    return any((e.left, e.right) == (premise.equation.left, premise.equation.right) for e in said)


@dataclass(frozen=True)
class Identity:
    """Both sides are evaluated in the ring of the given letters."""

    letters: Letters
    sides = ("left", "right")

    @property
    def title(self) -> str:
        return f"identity, residues in Q[{_names(self.letters)}] localized, modulo the relations given"

    def checks(
        self, claim: Sequence[Equation], premises: Sequence[Premise], zeroed: sympy.Expr | None
    ) -> Iterator[Check | Multiplier]:
        setting = Setting(self.letters, premises, claim, zeroed)
        yield from _compatible(setting)
        for equation in claim:
            yield from differences(setting, equation.text, equation)


@dataclass(frozen=True)
class Determined:
    """Both sides of each equation have the same start and obey the same law.

    Attributes
    ----------
    letters : Letters
    start : Equation
        The index or variable, and its value at the start.
    """

    letters: Letters
    start: Equation
    sides = ("right",)

    @property
    def by_steps(self) -> bool:
        """Whether the law is a recurrence."""
        return bool(self.start.left.is_integer)

    @property
    def title(self) -> str:
        way = "induction on" if self.by_steps else "initial value and differential equation in"
        return f"{way} {self.start.left}, residues in Q[{_names(self.letters)}] localized"

    def checks(
        self, claim: Sequence[Equation], premises: Sequence[Premise], zeroed: sympy.Expr | None
    ) -> Iterator[Check | Multiplier]:
        index, first = self.start.left, self.start.right
        starts = dict(_laws(premises, index, first))
        steps = dict(_laws(premises, index, index + 1))
        others = [p for p in premises if not _is_law(p.equation, index, (first, index + 1))]
        unknown = {equation.left: equation.right for equation in claim}
        terms = [Equation(right, right) for right in unknown.values()]
        ring = Setting(self.letters, [p for p in others if _rated(p) not in unknown], terms, zeroed)
        yield from _compatible(ring)
        at_start = {index: first} | {term: value for term, value in starts.items() if term not in unknown}
        for left, right in unknown.items():
            begun = Equation(right.xreplace(at_start), starts[left])
            yield from differences(ring, f"start, {marks.text(left)}", begun)
            if self.by_steps:
                onward = {index: index + 1} | {t: value for t, value in steps.items() if t not in unknown}
                reached, law = right.xreplace(onward), steps[left]
            else:
                reached, law = marks.rate(right), next(p.equation.right for p in premises if _rated(p) == left)
            yield from differences(ring, f"law, {marks.text(left)}", Equation(reached, law.xreplace(unknown)))


def differences(setting: Setting, label: str, equation: Equation) -> Iterator[Check | Multiplier]:
    """The residues of an equation, component by component, and what it was multiplied by."""
    found = setting.differences(equation)
    for place, difference in enumerate(found, 1):
        yield f"{label}, component {place}" if len(found) > 1 else label, difference.residue
        yield from setting.ring.multiplier(difference.powers)


def _compatible(setting: Setting) -> Iterator[Check | Multiplier]:
    """The relations leave no zero divisors, and the derivation keeps them."""
    for relation in setting.ring.relations:
        yield f"the relation {relation} is irreducible", _factors(relation) - 1
    for difference in setting.relation_rates():
        yield "the rate of a relation", difference.residue
        yield from setting.ring.multiplier(difference.powers)


@cache
def _factors(relation: Any) -> int:
    """How many factors a polynomial has."""
    return sum(power for _, power in relation.factor_list()[1])


def _rated(premise: Premise) -> sympy.Expr | None:
    left = premise.equation.left
    return left.args[0] if isinstance(left, marks.rate) else None


def _is_law(equation: Equation, index: sympy.Expr, values: Iterable[sympy.Expr]) -> bool:
    left = equation.left
    return isinstance(left, marks.Shifted) and left.args[1] == index and left.args[2] in values


def _laws(
    premises: Iterable[Premise], index: sympy.Expr, value: sympy.Expr
) -> Iterator[tuple[sympy.Expr, sympy.Expr]]:
    """Terms and what they are at that value of the index."""
    for premise in premises:
        if _is_law(premise.equation, index, (value,)):
            yield premise.equation.left.args[0], premise.equation.right


def _names(letters: Letters) -> str:
    return ", ".join(str(letter) for letter in (*letters.scalars, *letters.vectors))
