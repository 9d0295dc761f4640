"""Values for the letters of a statement: a ring in which what the premises say is true, and nothing else is known.

By the form of its left side a premise is

* a rate ``rate(v) = v'`` or a slope ``prime(p) = …`` (by x): they make the derivation of the ring;
* the value ``Shifted(p, x, 0) = 1`` at the origin, by which units are certified;
* the power ``(1 + x)^n = …``: where half of it occurs, a generator whose square it is;
* a relation ``v . v = x``, ``i^2 = -1``: reduced by;
* otherwise the definition of a letter or a term: replaced by its right side.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from typing import Any

import sympy

from ..algebra import Dual, Vector, dual_part, mixed, real_part
from ..algebra.element import Element
from . import notation
from .differential_ring import DifferentialRing
from .evaluation import MEANING, Evaluation, NoValueError, flat, mapped
from .statement import Equation, Premise


@dataclass(frozen=True)
class Letters:
    """The letters of a theorem that have no definition.

    Attributes
    ----------
    scalars : tuple of Symbol
        A letter that a relation eliminates stands before the others in it.
    vectors : tuple of Symbol
        Each with three components of its own.
    free : tuple of Symbol
        The scalars and vectors that vary independently and may be 0 (all others depend on them, or are parameters).
    """

    scalars: tuple[sympy.Symbol, ...]
    vectors: tuple[sympy.Symbol, ...] = ()
    free: tuple[sympy.Symbol, ...] = ()


class Setting(Evaluation):
    """Values of expressions in a ring, as the premises say.

    Parameters
    ----------
    letters : Letters
    premises : iterable of Premise
    claim : iterable of Equation, optional
        What will be evaluated; it says which powers with exponent n occur.
    zeroed : Expr, optional
        See `DifferentialRing`.
    """

    def __init__(
        self,
        letters: Letters,
        premises: Iterable[Premise],
        claim: Iterable[Equation] = (),
        zeroed: sympy.Expr | None = None,
    ) -> None:
        given = [premise.equation for premise in premises]
        self._roots = _roots([*given, *claim], [e.left for e in given if _is_power(e.left)])
        roots = tuple(symbol for symbol, _ in self._roots.values())
        components = {v: [sympy.Symbol(f"{v}_{axis}") for axis in (3, 2, 1)] for v in letters.vectors}
        self._components = {c for v in letters.vectors for c in components[v]}
        generators = [c for v in letters.vectors for c in components[v]] + [*roots, *letters.scalars]
        free = [g for letter in letters.free for g in components.get(letter, [letter])]
        self.ring = DifferentialRing(generators, free, zeroed)
        values: dict[sympy.Expr, Any] = {g: self.ring.generator(g) for g in (*roots, *letters.scalars)}
        super().__init__(values | {v: Vector(*map(self.ring.generator, reversed(c))) for v, c in components.items()})
        self._powers: dict[sympy.Expr, Equation] = {}
        self._rates: dict[Any, Any] = {}
        self._slopes: dict[Any, Any] = {}
        for equation in given:
            self._take(equation)
        for base, (symbol, _) in self._roots.items():
            self.ring.grows(symbol, self.value(base))

    def _take(self, equation: Equation) -> None:
        """Make a premise true."""
        left, right = equation.left, equation.right
        if isinstance(left, notation.Shifted):
            self._start(left, right)
        elif isinstance(left, notation.rate):
            self._derive(self._rates, left.args[0], right)
        elif isinstance(left, notation.prime):
            self._derive(self._slopes, left.args[0], right)
        elif _is_power(left):
            self._powers[left.base] = equation
            if left.base in self._roots:
                self.ring.relate(self.value(left) - self.value(right))
        elif left not in self.values and (left.is_Symbol or (left.is_Function and left.func not in MEANING)):
            self.definitions[left] = right
        else:
            self.ring.relate(self.value(left) - self.value(right))

    def _start(self, shifted: sympy.Expr, value: sympy.Expr) -> None:
        self.definitions[shifted] = value
        term, variable, place = shifted.args
        if term in self.ring.letters and place == 0 and not variable.is_integer:
            self.ring.origin[term] = self.value(value)

    def _derive(self, derivation: dict[Any, Element], term: sympy.Expr, value: sympy.Expr) -> None:
        letter = self._roots[term.base][0] if term.is_Pow else term
        pairs = zip(flat(self.value(letter)), flat(self.value(value)), strict=True)
        derivation.update((self.ring.place(generator), rate) for generator, rate in pairs)
        if None in derivation:
            raise NoValueError(f"{notation.text(term)} is no letter, whose rate or slope may be given")

    def has_rate(self, letter: sympy.Expr) -> bool:
        """Whether something says how a letter varies."""
        return self.ring.letters.get(letter) in self.rates

    # --- values ---------------------------------------------------------------------------------------------------

    def number(self, value: Fraction) -> Element:
        return self.ring.constant(value)

    def differentiated(self, mark: Any, value: Any) -> Any:
        return mapped(partial(_derivative, self.rates if mark is notation.rate else self.slopes), value)

    def power(self, base: sympy.Expr, exponent: sympy.Expr) -> Any:
        multiple = exponent.coeff(notation.n)
        rest = sympy.expand(exponent - multiple * notation.n)
        if base in self._roots:
            symbol, step = self._roots[base]
            growing = self.value(symbol) ** int(multiple / step)
        else:
            if base not in self._powers:
                raise NoValueError(f"nothing says what the power {notation.text(base)}^n is")
            known = self._powers[base]
            growing = self.value(known.right ** (multiple / known.left.exp.coeff(notation.n)))
        return growing if rest == 0 else mixed.multiply(growing, self.value(base**rest))

    @property
    def rates(self) -> dict[Any, Any]:
        """The derivation by time: what follows x has the rate of x times its slope."""
        if self.ring.letters.get(notation.x) not in self._rates:
            return self._rates
        speed = self._rates[self.ring.letters[notation.x]]
        return {generator: slope * speed for generator, slope in self._slopes.items()} | self._rates

    @property
    def slopes(self) -> dict[Any, Any]:
        """The derivation by x."""
        return self._slopes | {self.ring.letters[notation.x]: self.ring.constant(1)}

    def relation_rates(self) -> list[Element]:
        """Rates and slopes of what the relations say is 0, and of letters with both, the rate less slope times speed.

        Vectors have no slope: what is said of their components is not asked for one.
        """
        zeros = [Element(self.ring, relation, self.ring.library.one) for relation in self.ring.relations]
        found = [zero.derivative(self.rates) for zero in zeros if self.rates]
        if self._slopes:
            scalar = (zero for zero in zeros if not self.ring.occurring(zero.numerator) & self._components)
            found += [zero.derivative(self.slopes) for zero in scalar]
        speed = self._rates.get(self.ring.letters.get(notation.x))
        both = self._slopes.keys() & self._rates.keys() if speed is not None else ()
        return found + [self._rates[letter] - self._slopes[letter] * speed for letter in both]

    def differences(self, equation: Equation) -> list[Element]:
        """Left minus right, by components, real parts before dual parts."""
        pairs = self.sides(equation)
        found = [real_part(a) - real_part(b) for a, b in pairs]
        if any(isinstance(c, Dual) for pair in pairs for c in pair):
            found += [dual_part(a) - dual_part(b) for a, b in pairs]
        return [part if isinstance(part, Element) else self.ring.constant(part) for part in found]


def _derivative(rates: Mapping[Any, Any], value: Any) -> Any:
    if isinstance(value, Dual):
        return Dual(_derivative(rates, value.re), _derivative(rates, value.du))
    return value.derivative(rates) if isinstance(value, Element) else 0


def _is_power(term: sympy.Expr) -> bool:
    """Whether it is a power whose exponent varies."""
    return bool(term.is_Pow and not term.exp.is_Integer)


def _roots(
    equations: Iterable[Equation], known: Iterable[sympy.Expr]
) -> dict[sympy.Expr, tuple[sympy.Symbol, sympy.Rational]]:
    """For each base of a power with exponent a n + b that no premise knows: a letter, and its exponent divided by n."""
    steps: dict[sympy.Expr, sympy.Rational] = {}
    for equation in equations:
        for power in equation.left.atoms(sympy.Pow) | equation.right.atoms(sympy.Pow):
            if multiple := power.exp.coeff(notation.n):
                steps[power.base] = min(steps.get(power.base, sympy.Integer(1)), sympy.Rational(1, multiple.q))
    given = {power.base: power.exp.coeff(notation.n) for power in known}
    return {
        base: (sympy.Symbol(f"({notation.text(base)})^({notation.text(step * notation.n)})"), step)
        for base, step in steps.items()
        if not (step / given.get(base, 0)).is_integer
    }
