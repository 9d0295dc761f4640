r"""Comparison of power series in x, whose coefficients are sums of binomials, for all n and j.

A series is a polynomial plus tails :math:`\sum_{j \ge s} e(n, j)\,x^j`. Multiplication by x shifts the index, so the
recurrence of p_n and q_n applies to series too. Two series are equal if their general coefficients agree, and every
coefficient below the start of a tail agrees.

A sum of binomials is decided with :math:`\binom{n}{k} = \frac{n!}{k!\,(n-k)!}` and 1/m! = 0 for m < 0. Terms whose
factorials differ only by integers have a common factor

.. math:: \frac{(n + a)!}{(k + b)!\,(n - k + c)!}

with the least a and the greatest b, c that occur. The cofactor of each term is a polynomial for all integers n and k,
even at the borders of Pascal's triangle. The sum of these polynomials must be zero in Q[n, j].
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy

from ..algebra.exact import RationalFunctions
from .identity import Checks, Equation, definition
from .methods import Method, Theorem
from .notation import Shifted, j, n, text, x

POLYNOMIALS = RationalFunctions(("n", "j"))
VALUES = {symbol: POLYNOMIALS.symbol(symbol.name) for symbol in (n, j)}

upper, lower = sympy.symbols("N K", integer=True)
BINOMIAL = definition(
    sympy.binomial(upper, lower),
    sympy.factorial(upper) / (sympy.factorial(lower) * sympy.factorial(upper - lower)),
    wrong=sympy.factorial(upper) / (sympy.factorial(lower) * sympy.factorial(upper - lower + 1)),
)
"""Definition of the binomial coefficient, with 1/m! = 0 for m < 0."""


class NotDecidedError(ArithmeticError):
    """Error for a coefficient that is not a sum of binomials."""


@dataclass(frozen=True)
class Series:
    """Power series in x: a polynomial with coefficients in n, and tails."""

    head: Mapping[int, sympy.Expr] = field(default_factory=dict)
    tails: tuple[tuple[int, sympy.Expr], ...] = ()  # first index, and general coefficient in n and j

    def __add__(self, other: Series) -> Series:
        total = defaultdict(lambda: sympy.Integer(0), self.head)
        for power, coefficient in other.head.items():
            total[power] += coefficient
        return Series(dict(total), self.tails + other.tails)

    def __mul__(self, other: Series) -> Series:
        if self.tails and other.tails:
            raise NotDecidedError("a product of two sums over j")
        if self.tails:
            return other * self
        result = Series()
        for power, c in self.head.items():
            head = {i + power: c * e for i, e in other.head.items()}
            tails = tuple((start + power, c * e.xreplace({j: j - power})) for start, e in other.tails)
            result = result + Series(head, tails)
        return result

    def coefficient(self, power: int) -> sympy.Expr:
        """Return the coefficient of ``x^power``."""
        begun = (e.xreplace({j: sympy.Integer(power)}) for start, e in self.tails if start <= power)
        return sum(begun, self.head.get(power, sympy.Integer(0)))


@dataclass(frozen=True)
class Coefficients(Method):
    """Decision of a claim whose right sides are series.

    Recurrences among the premises determine the left sides by induction on n. A left side without a recurrence must be
    the only unknown series in an equation among the premises.
    """

    first: int = 1
    """Least n, the start of recurrences."""

    @property
    def title(self) -> str:
        return "coefficient by coefficient as multiples of one quotient of factorials, residues in Q[n, j]"

    def checks(self, theorem: Theorem, required: tuple[Equation, ...], zeroed: sympy.Expr | None) -> Checks:
        claim, given = theorem.claim, [premise.equation for premise in theorem.premises]
        rule = next(e.right for e in given if isinstance(e.left, sympy.binomial))
        known = {e.left: _written_out(e.right, rule) for e in [*given, *claim] if e.right.has(sympy.Sum)}
        reader = _Reader(known, [e for e in given if e.left in known and not e.right.has(sympy.Sum)])
        laws = [e for e in given if not isinstance(e.left, sympy.binomial) and e.left not in known]
        for equation in required:
            yield f"required, {equation.text}", 1  # this method cannot decide it
        for equation in claim:
            yield f"what determines {text(equation.left)}", 0 if self._determined(equation.left, laws) else 1
        for equation in laws:
            left, right, at = equation.left, equation.right, equation.text
            if isinstance(left, Shifted):
                at = f"{'start' if left.args[2] == self.first else 'step'}, {at}"
                left = known[left.args[0]].xreplace({n: left.args[2]})
            yield from _zero(at, reader.series(left - right), self.first)

    def _determined(self, term: sympy.Expr, laws: Sequence[Equation]) -> bool:
        """Return whether premises determine a term, by start and step of its sequence or by an equation with it."""
        if any(e.left.has(term) or e.right.has(term) for e in laws if not isinstance(e.left, Shifted)):
            return True
        places = {e.left.args[2] for e in laws if e.left.args[:2] == (term, n)}
        return places == {self.first, n + 1}


@dataclass(frozen=True)
class _Reader:
    """Conversion of expressions to series, given known series and known products of series."""

    known: Mapping[sympy.Expr, sympy.Expr]
    products: Iterable[Equation]

    def series(self, e: sympy.Expr) -> Series:
        if e in self.known:
            return self.series(self.known[e])
        if e == x:
            return Series({1: sympy.Integer(1)})
        if isinstance(e, sympy.Sum):
            ((_, start, _),) = e.limits
            exponent = e.function.as_powers_dict()[x]
            offset = int(exponent - j)
            general = (e.function / x**exponent).xreplace({j: j - offset})
            return Series(tails=((int(start) + offset, general),))
        if not e.has(x, *self.known):
            return Series({0: e})
        if e.is_Add:
            return sum((self.series(term) for term in e.args), Series())
        if e.is_Mul:
            return self._product(e)
        raise NotDecidedError(f"no series known for {text(e)}")

    def _product(self, e: sympy.Expr) -> Series:
        unknown = sympy.Mul(*(factor for factor in e.args if factor.is_Symbol and factor in self.known))
        for equation in self.products:
            number, product = equation.right.as_coeff_Mul()
            if unknown == product:
                e = e / product * equation.left / number
        result = Series({0: sympy.Integer(1)})
        for factor in sympy.Mul.make_args(e):
            result = result * self.series(factor)
        return result


# ---- deciding ---------------------------------------------------------------------------------------------------


def _zero(label: str, series: Series, first: int) -> Checks:
    general = sum((e for _, e in series.tails), sympy.Integer(0))
    begun = max([start for start, _ in series.tails], default=0)
    if general.has(n) or not series.tails:
        yield f"{label}, general coefficient", residue(general, first)
        last = max([begun, *series.head])
    else:  # n is a number: only finitely many coefficients are nonzero
        last = max([begun, *series.head, *map(_last_index, general.atoms(sympy.factorial))]) + 1
    for power in range(min([0, *series.head, *(start for start, _ in series.tails)]), last + 1):
        yield f"{label}, coefficient of x^{power}", residue(series.coefficient(power), first)


def _last_index(term: sympy.factorial) -> int:
    """Return the last j at which a factorial's argument is >= 0; return 0 unless the argument decreases with j."""
    slope = term.args[0].coeff(j)
    return int(term.args[0].xreplace({j: sympy.Integer(0)}) // -slope) if slope < 0 else 0


def residue(e: sympy.Expr, first: int) -> Any:
    """Return a polynomial that is zero if and only if a sum of binomials is 0 at all j and all n >= first."""
    groups: dict[Any, list[_Term]] = defaultdict(list)
    for product in sympy.Add.make_args(sympy.expand(e)):
        term = _term(product)
        groups[term.kind].append(term)
    sums = (_together(terms, first) for terms in groups.values())
    return next(filter(None, sums), POLYNOMIALS.constant(0))


_Factorial = tuple[sympy.Expr, int]
"""Argument of a factorial, split into a linear form in n and j and an added integer."""


@dataclass(frozen=True)
class _Term:
    """Product of a polynomial in n and j, a quotient of factorials and, if alternating, ``(-1)^j``."""

    number: Any
    alternating: bool
    above: tuple[_Factorial, ...]
    below: tuple[_Factorial, ...]

    @property
    def kind(self) -> Any:
        """Key of the terms that have a common factor of factorials."""
        return self.alternating, *(tuple(h for h, _ in part) for part in (self.above, self.below))


def _term(product: sympy.Expr) -> _Term:
    number, alternating = POLYNOMIALS.constant(1), False
    above: list[_Factorial] = []
    below: list[_Factorial] = []
    for factor in sympy.Mul.make_args(product):
        base, exponent = factor.as_base_exp()
        if base == -1:
            number *= (-1) ** int(exponent.xreplace({j: sympy.Integer(0)}))
            alternating ^= exponent.has(j)
        elif isinstance(base, sympy.factorial):
            (above if exponent > 0 else below).extend([_linear(base.args[0])] * abs(int(exponent)))
        else:
            number *= _polynomial(factor)
    for form, c in list(below):  # (h + a)!/(h + c)! is a polynomial
        pair = next((a for h, a in above if h == form and a >= c), None)
        if pair is not None:
            above.remove((form, pair))
            below.remove((form, c))
            number *= _between(form, c, pair)
    return _Term(number, alternating, *(tuple(sorted(part, key=str)) for part in (above, below)))


def _polynomial(factor: sympy.Expr) -> Any:
    if not factor.is_polynomial(n, j):
        raise NotDecidedError(f"{text(factor)} is no polynomial in n and j")
    return POLYNOMIALS.lift(factor, VALUES)


def _written_out(e: sympy.Expr, rule: sympy.Expr) -> sympy.Expr:
    binomials = e.atoms(sympy.binomial)
    return e.xreplace({b: rule.xreplace({upper: b.args[0], lower: b.args[1]}) for b in binomials})


def _linear(form: sympy.Expr) -> _Factorial:
    """Split a linear form in n and j into its homogeneous part and its constant."""
    constant = form.xreplace({n: sympy.Integer(0), j: sympy.Integer(0)})
    return form - constant, int(constant)


def _between(form: sympy.Expr, low: int, high: int) -> Any:
    """Return ``(h + high)!/(h + low)!``."""
    return _polynomial(sympy.rf(form + low + 1, high - low))


def _together(terms: Sequence[_Term], first: int) -> Any:
    """Return the sum of terms of one `kind` without their common factorials; numerators must exist at n = first."""
    least = [min(a for _, a in column) for column in zip(*(t.above for t in terms), strict=True)]
    greatest = [max(c for _, c in column) for column in zip(*(t.below for t in terms), strict=True)]
    for (form, _), a in zip(terms[0].above, least, strict=True):
        if form.has(j) or form.xreplace({n: sympy.Integer(first)}) + a < 0:
            raise NotDecidedError(f"the factorial of {form} + {a} at n = {first}")
    total = POLYNOMIALS.constant(0)
    for term in terms:
        product = term.number
        for (form, a), low in zip(term.above, least, strict=True):
            product *= _between(form, low, a)
        for (form, c), high in zip(term.below, greatest, strict=True):
            product *= _between(form, c, high)
        total += product
    return total
