"""Values of the symbols of a statement, in a ring where exactly its premises hold.

The left side of a premise decides its use:

* a rate ``rate(v) = v'`` or a slope ``prime(p) = …`` (by x) defines the derivation of the ring;
* a value ``Shifted(p, x, 0) = 1`` at the origin certifies multipliers;
* a power ``(1 + x)^n = …`` is replaced; if its square root occurs, a new generator stands for the root;
* a relation ``v . v = x``, ``i^2 = -1`` reduces polynomials;
* any other equation defines a symbol or a term; the right side replaces it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from typing import Any

import sympy

from ..algebra import Dual, Vector, dual_part, real_part, structures
from ..algebra.element import Element
from . import notation
from .evaluation import MEANING, Evaluation, NoValueError, flat, mapped
from .identity import Equation, Premise
from .rings import DifferentialRing


@dataclass(frozen=True)
class Symbols:
    """Symbols that a theorem leaves undefined.

    A relation eliminates its first scalar. Vectors have three independent components each. Free scalars and
    vectors vary independently and may be 0. All other symbols depend on them or are parameters.
    """

    scalars: tuple[sympy.Symbol, ...]
    vectors: tuple[sympy.Symbol, ...] = ()
    free: tuple[sympy.Symbol, ...] = ()


class Setting(Evaluation):
    """Values of expressions in a ring where the premises hold.

    The equations of the claim may contain further powers with exponent n. See `DifferentialRing` for `zeroed`.
    """

    def __init__(
        self,
        symbols: Symbols,
        premises: Iterable[Premise],
        claim: Iterable[Equation] = (),
        zeroed: sympy.Expr | None = None,
    ) -> None:
        given = [premise.equation for premise in premises]
        self._roots = _roots([*given, *claim], [e.left for e in given if _is_power(e.left)])
        roots = tuple(symbol for symbol, _ in self._roots.values())
        components = {v: [sympy.Symbol(f"{v}_{axis}") for axis in (3, 2, 1)] for v in symbols.vectors}
        self._components = {c for v in symbols.vectors for c in components[v]}
        generators = [c for v in symbols.vectors for c in components[v]] + [*roots, *symbols.scalars]
        free = [g for symbol in symbols.free for g in components.get(symbol, [symbol])]
        self.ring = DifferentialRing(generators, free, zeroed)
        values: dict[sympy.Expr, Any] = {g: self.ring.generator(g) for g in (*roots, *symbols.scalars)}
        super().__init__(values | {v: Vector(*map(self.ring.generator, reversed(c))) for v, c in components.items()})
        self._powers: dict[sympy.Expr, Equation] = {}
        self._rates: dict[Any, Any] = {}
        self._slopes: dict[Any, Any] = {}
        for equation in given:
            self._assume(equation)
        for base, (symbol, _) in self._roots.items():
            self.ring.bases[symbol] = self.value(base).numerator

    def _assume(self, equation: Equation) -> None:
        left, right = equation.left, equation.right
        if isinstance(left, notation.Shifted):
            self._start(left, right)
        elif isinstance(left, notation.rate | notation.prime):
            self._derive(self._rates if isinstance(left, notation.rate) else self._slopes, left.args[0], right)
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
        if term in self.ring.symbols and place == 0 and not variable.is_integer:
            self.ring.origin[term] = self.value(value)

    def _derive(self, derivation: dict[Any, Element], term: sympy.Expr, value: sympy.Expr) -> None:
        symbol = self._roots[term.base][0] if term.is_Pow else term
        pairs = zip(flat(self.value(symbol)), flat(self.value(value)), strict=True)
        derivation.update((self.ring.place(generator), rate) for generator, rate in pairs)
        if None in derivation:
            raise NoValueError(f"{notation.text(term)} is no symbol, whose rate or slope may be given")

    def has_rate(self, symbol: sympy.Expr) -> bool:
        return self.ring.symbols.get(symbol) in self.rates

    # --- values ---------------------------------------------------------------------------------------------------

    def number(self, value: Fraction) -> Element:
        return self.ring.constant(value)

    def differentiated(self, operator: Any, value: Any) -> Any:
        return mapped(partial(_derivative, self.rates if operator is notation.rate else self.slopes), value)

    def power(self, base: sympy.Expr, exponent: sympy.Expr) -> Any:
        multiple = exponent.coeff(notation.n)
        rest = sympy.expand(exponent - multiple * notation.n)
        if base in self._roots:
            symbol, step = self._roots[base]
            growing = self.value(symbol) ** int(multiple / step)
        else:
            if base not in self._powers:
                raise NoValueError(f"no premise defines the power {notation.text(base)}^n")
            known = self._powers[base]
            growing = self.value(known.right ** (multiple / known.left.exp.coeff(notation.n)))
        return growing if rest == 0 else structures.multiply(growing, self.value(base**rest))

    @property
    def rates(self) -> dict[Any, Any]:
        """Derivation by time; a symbol with only a slope by x gets the rate ``slope · rate of x``."""
        if self.ring.symbols.get(notation.x) not in self._rates:
            return self._rates
        speed = self._rates[self.ring.symbols[notation.x]]
        return {generator: slope * speed for generator, slope in self._slopes.items()} | self._rates

    @property
    def slopes(self) -> dict[Any, Any]:
        return self._slopes | {self.ring.symbols[notation.x]: self.ring.constant(1)}

    def relation_rates(self) -> list[Element]:
        """Return the differences that must be 0 for the derivations to respect the premises.

        The list holds rates and slopes of all relations, and ``rate − slope · rate of x`` for each symbol with both.
        Relations between components have no slope.
        """
        zeros = [Element(self.ring, relation, self.ring.library.one) for relation in self.ring.relations]
        found = [zero.derivative(self.rates) for zero in zeros if self.rates]
        if self._slopes:
            scalar = (zero for zero in zeros if not self.ring.occurring(zero.numerator) & self._components)
            found += [zero.derivative(self.slopes) for zero in scalar]
        speed = self._rates.get(self.ring.symbols.get(notation.x))
        both = self._slopes.keys() & self._rates.keys() if speed is not None else ()
        return found + [self._rates[symbol] - self._slopes[symbol] * speed for symbol in both]

    def compared(self, equation: Equation) -> list[tuple[Element, Element]]:
        """Return both sides by components, real parts before dual parts."""
        pairs = self.sides(equation)
        found = [(real_part(a), real_part(b)) for a, b in pairs]
        if any(isinstance(c, Dual) for pair in pairs for c in pair):
            found += [(dual_part(a), dual_part(b)) for a, b in pairs]
        return [(self.ring.element(a), self.ring.element(b)) for a, b in found]


def _derivative(rates: Mapping[Any, Any], value: Any) -> Any:
    if isinstance(value, Dual):
        return Dual(_derivative(rates, value.re), _derivative(rates, value.du))
    return value.derivative(rates) if isinstance(value, Element) else 0


def _is_power(term: sympy.Expr) -> bool:
    return bool(term.is_Pow and not term.exp.is_Integer)


def _roots(
    equations: Iterable[Equation], known: Iterable[sympy.Expr]
) -> dict[sympy.Expr, tuple[sympy.Symbol, sympy.Rational]]:
    """Return a new symbol for ``base^(step n)`` and the step, by base, for powers that no premise defines."""
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
