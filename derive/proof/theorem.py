"""A theorem: a claim, everything it takes as given, and the way in which it is decided.

There are two ways in a ring. An *identity* is evaluated. What is *determined* by a start and a law (a sequence by its
first term and its recurrence, a function by its initial value and its differential equation) equals what has the same
start and obeys the same law; which of the two it is, the premises say.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import combinations
from typing import Any, Protocol, TypeVar

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
        What letters stand for in the theorems that premises are taken from, which has to hold here, too.
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

        def checks() -> Iterator[Check | Multiplier]:
            for premise in self.premises:
                if premise.theorem:
                    yield f"premise by {premise.theorem}", 0 if _is_proved(premise, known, self.scope) else 1
            yield from self.method.checks(Task(self.claim, self.premises, tuple(filter(self._said, supposed)), zeroed))

        laws = marks.Shifted, marks.rate, marks.prime
        conditions = tuple(e for e in supposed if not self._said(e) and not isinstance(e.left, laws))
        return decide(Claim(self.name, self.claim, self.method.title, self.premises, conditions), checks, self.scope)

    def _supposed(self, known: Mapping[str, Proof]) -> tuple[Equation, ...]:
        """What letters stand for in the theorems that premises name, of those that are here and not said here."""
        own = {premise.equation.text for premise in self.premises if not premise.theorem}
        here = set().union(*(e.letters for e in (*self.claim, *(premise.equation for premise in self.premises))))
        there = (e for premise in self.premises if premise.theorem for e in _rests_on(premise, known))
        return tuple({e.text: e for e in there if e.letters <= here and e.text not in own}.values())

    def _said(self, equation: Equation) -> bool:
        """Whether something is said here of what an equation is about: then it has to hold, else it is a condition."""
        own = [premise.equation for premise in self.premises if not premise.theorem]
        return equation.left in {e.left for e in own} | {e.right for e in own if e.right.is_Symbol}

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


def _rests_on(premise: Premise, known: Mapping[str, Proof]) -> Iterator[Equation]:
    """What letters stand for in the theorem that a premise names, and in those which that one rests on."""
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
    """Whether terms of sequences in an equation become terms of the same ones, with the index as it is then."""
    for letter in equation.letters & marks.TERMS.keys():
        sequence, index = marks.TERMS[letter]
        there = marks.TERMS.get(changes.get(letter, letter))
        if marks.x in changes or there != (sequence, index.xreplace(changes)):
            return False
    return True


@dataclass(frozen=True)
class Identity:
    """Both sides are evaluated in the ring of the given letters."""

    letters: Letters
    sides = ("left", "right")

    @property
    def title(self) -> str:
        return f"identity, residues in Q[{_names(self.letters)}] localized, modulo the relations given"

    def weaker(self) -> Iterator[tuple[str, Identity]]:
        return _less_free(self)

    def checks(self, task: Task) -> Iterator[Check | Multiplier]:
        setting = Setting(self.letters, task.premises, (*task.claim, *task.supposed), task.zeroed)
        yield from _compatible(setting, task.premises)
        for equation in task.claim:
            yield from differences(setting, equation.text, equation)
        for equation in task.supposed:
            yield from differences(setting, f"supposed, {equation.text}", equation)


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

    def weaker(self) -> Iterator[tuple[str, Determined]]:
        return _less_free(self)

    def _moving(
        self, ring: Setting, starts: Container[Any], steps: Container[Any], others: Sequence[Premise]
    ) -> Iterator[Check]:
        """There is a law for every letter that goes with the index or variable, which goes by itself."""
        index = self.start.left
        for letter in self.letters.scalars:
            goes = letter != index and index in marks.TERMS.get(letter, ("", letter))[1].free_symbols
            known = (letter in starts and letter in steps) if self.by_steps else ring.has_rate(letter)
            yield f"law of {marks.text(letter)}", 1 if goes and not known else 0
        if self.by_steps:
            yield "what is said at one index only", sum(index in premise.equation.letters for premise in others)
        elif index in self.letters.scalars:
            yield f"rate of {index} less 1", ring.value(marks.rate(index)) - 1

    def checks(self, task: Task) -> Iterator[Check | Multiplier]:
        claim, premises = task.claim, task.premises
        index, first = self.start.left, self.start.right
        starts = dict(_laws(premises, index, first))
        steps = dict(_laws(premises, index, index + 1))
        others = [p for p in premises if not _is_law(p.equation, index, (first, index + 1))]
        unknown = {equation.left: equation.right for equation in claim}
        terms = [Equation(right, right) for right in unknown.values()]
        ring = Setting(self.letters, [p for p in others if _rated(p) not in unknown], terms, task.zeroed)
        yield from _compatible(ring, premises)
        for equation in task.supposed:
            yield from differences(ring, f"supposed, {equation.text}", equation)
        yield from self._moving(ring, starts, steps, others)
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


def _compatible(setting: Setting, premises: Sequence[Premise]) -> Iterator[Check | Multiplier]:
    """Nothing is said twice. The relations leave no zero divisors and do not contradict each other, nothing uncertified
    was multiplied by to have them, and the derivation keeps them."""
    ring, said = setting.ring, [premise.equation.left for premise in premises]
    yield "what is said more than once", len(said) - len(set(said))
    leading = [relation.leading_expv() for relation in ring.relations]
    shared = sum(any(map(min, a, b)) for a, b in combinations(leading, 2))
    yield "relations that reduce the same letter", shared  # without, they are a Groebner basis, and 1 is not in it
    for relation, powers in zip(ring.relations, ring.cleared, strict=True):
        yield f"the relation {relation} is irreducible", _factors(relation) - 1
        yield from ring.multiplier(powers)
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
    names = ", ".join(str(letter) for letter in (*letters.scalars, *letters.vectors))
    return f"{names}; {', '.join(map(str, letters.free))} free" if letters.free else names


_InLetters = TypeVar("_InLetters", Identity, Determined)


def _less_free(method: _InLetters) -> Iterator[tuple[str, _InLetters]]:
    """A method that knows of one letter less that it varies independently."""
    for letter in method.letters.free:
        rest = tuple(other for other in method.letters.free if other != letter)
        yield f"{letter} that depends on others", replace(method, letters=replace(method.letters, free=rest))
