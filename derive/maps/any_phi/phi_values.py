"""Values of φ and its derivatives at an angle, in the operations of an arithmetic.

Sines come from the tangent of a quarter of the angle, exponentials from ``e^a − 1``, logarithms from ``log(1 + a)``.
Arc functions come from a series that takes complex numbers. No operation loses digits near 0.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import comb
from typing import Any

import mpmath
import sympy

from ...algebra import Coefficient
from ...algebra.arithmetic import Arithmetic, Pair
from ..elementary import alpha, elementary
from ..order_charts import double_angle
from ..real_constants import is_small, number, plus, times
from .edges import PHI_DIGITS
from .near_zero import Ratio

SQUARE = sympy.Symbol("square", positive=True)
LEVELS = 5
"""Levels of a constant (`real_constants`), enough to separate half a turn from angles 1e-30 below it."""

ARC_SERIES = tuple(45045 // odd for odd in range(1, 15, 2))
"""Coefficients of the arc tangent series, without signs, scaled to integers."""


class PhiValues:
    """Values of expressions at one angle; each part is computed once."""

    def __init__(self, angle: Coefficient, m: Arithmetic) -> None:
        self.m: Any = _Unnamed(m)
        self._known: dict[Any, Coefficient] = {alpha: angle}

    def at(self, expression: sympy.Expr) -> Coefficient:
        if alpha not in expression.free_symbols:
            found = number(expression)
            if is_small(found):
                return found if found.denominator != 1 else int(found)
        if expression not in self._known:
            self._known[expression] = self._computed(expression)
        return self._known[expression]

    def derivative(self, phi: sympy.Expr, count: int) -> Coefficient:
        """Return a derivative of φ, or φ itself for count 0.

        For a quotient ``φ = N/D``, Leibniz's rule for ``φ D = N`` gives the derivative from shared parts. A product of
        sums is no such part: its terms would cancel where a sum is near 0. At 0 itself φ must not be a `Quotient`.
        """
        phi = elementary(phi)
        above, below = sympy.fraction(sympy.together(phi)) if phi.is_rational_function(alpha) else (phi, sympy.S.One)
        if not below.has(alpha) or _sums(above) > 1 or _sums(below) > 1:
            return self.at(phi.diff(alpha, count))
        if (phi, count) not in self._known:
            value = self.at(_nested(above.diff(alpha, count)))
            for k in range(count):
                change = self.at(_nested(below.diff(alpha, count - k)))
                value = value - comb(count, k) * (self.derivative(phi, k) * change)
            self._known[phi, count] = self.m.div(value, self.at(_nested(below)))
        return self._known[phi, count]

    def _computed(self, e: sympy.Expr) -> Coefficient:
        if alpha not in e.free_symbols:
            return self._constant(number(e))
        if e.is_Add:
            return self._sum(e)
        if e.is_Mul:
            return self._product(e)
        if e.is_Pow:
            return self._power(e)
        return FUNCTIONS[e.func](self, e.args[0])

    def _constant(self, value: Any) -> Coefficient:
        angle = self._known[alpha]
        return times(value, angle - angle + 1, self.m, "", LEVELS)

    def _sum(self, e: sympy.Expr) -> Coefficient:
        constants, terms = e.as_independent(alpha, as_Add=True)
        first, *rest = map(self.at, sympy.Add.make_args(terms))
        for term in rest:
            first = first + term
        return first if constants == 0 else plus(first, number(constants), self.m, "", LEVELS)

    def _product(self, e: sympy.Expr) -> Coefficient:
        constant, factors = e.as_independent(alpha, as_Add=False)
        above: Coefficient = 1
        below: Coefficient = 1
        for factor in sympy.Mul.make_args(factors):
            base, exponent = factor.as_base_exp()
            if exponent.is_Rational and exponent < 0:
                below = below * self.at(base**-exponent)
            else:
                above = above * self.at(factor)
        if constant != 1:
            above = times(number(constant), above, self.m, "", LEVELS) if not _is_one(above) else above
        if _is_one(above):
            return _over(number(constant), below, self.m)
        return above if _is_one(below) else self.m.div(above, below)

    def _power(self, e: sympy.Expr) -> Coefficient:
        base, exponent = e.as_base_exp()
        value = _to_power(self._root(base, int(exponent.q)), abs(int(exponent.p)))
        return value if exponent > 0 else self.m.div(1, value)

    def _root(self, base: sympy.Expr, degree: int) -> Coefficient:
        """Return a root of a number ≥ 0: beyond degree 2 by its logarithm, with a Newton step for all digits."""
        m, a = self.m, self.at(base)
        if degree <= 2:
            return a if degree == 1 else m.sqrt(a)
        size, below = self._side(sympy.log(base))
        larger = 1 + m.expm1(m.div(size, degree))
        root = m.corrected(m.where(below, 1, larger) / m.where(below, larger, 1))
        power = _to_power(root, degree - 1)
        return m.where(m.equal(a, 0), a, root - (root - a / power) / degree)

    def _atan(self, a: Coefficient) -> Coefficient:
        """Return the arc tangent, by ``π/2 − atan(1/a)`` beyond 1.

        The operation `atan2` takes no complex numbers, but complex steps through forward maps need them.
        """
        m = self.m
        short = m.less(a * a, 1)
        arc = self._short_arc(m.where(short, a, 1) / m.where(short, 1, a))
        side = m.where(m.less(a, 0), -1, 1)
        with mpmath.workdps(PHI_DIGITS):
            right_angle = mpmath.pi / 2
        return m.where(short, arc, side * plus(-(side * arc), right_angle, m, "", LEVELS))

    def _short_arc(self, u: Coefficient) -> Coefficient:
        """Return the arc tangent of a number up to 1.

        A series gives a quarter of the angle, to 1e-10. The tangent of the error then corrects the angle.
        """
        m, quarter = self.m, u
        for _ in range(2):
            quarter = quarter / (1 + m.sqrt(1 + quarter * quarter))
        square, series = quarter * quarter, 0
        for coefficient in reversed(ARC_SERIES):
            series = coefficient - square * series
        start = m.corrected(m.div(4 * (quarter * series), ARC_SERIES[0]))
        tangent = m.tan(start)
        return start - (tangent - u) / (1 + tangent * u)

    def _circular(self, argument: sympy.Expr) -> Pair:
        """Return sine and cosine from the tangent of a quarter of the angle, whose pole is far away."""
        sine, cosine = double_angle(self.m.tan(self.m.div(self.at(argument), 4)), self.m)
        return 2 * (sine * cosine), 1 - 2 * (sine * sine)

    def _side(self, argument: sympy.Expr) -> tuple[Coefficient, Any]:
        """Return |a| and whether a is negative; the selection, unlike `abs`, has a derivative at 0."""
        m, a = self.m, self.at(argument)
        below = m.less(a, 0)
        return m.where(below, -a, a), below

    def _exp(self, argument: sympy.Expr) -> Coefficient:
        """Return the exponential from ``E = e^|a| − 1``: ``1 + E``, or ``1/(1 + E)`` for negative a."""
        m, (size, below) = self.m, self._side(argument)
        power = 1 + m.expm1(size)
        return m.where(below, 1, power) / m.where(below, power, 1)

    def _hyperbolic(self, argument: sympy.Expr) -> Pair:
        """Return hyperbolic sine and cosine from ``E = e^|a| − 1``: ``(E + E/(1 + E))/2`` and ``1 + E²/(2 + 2E)``."""
        m, (size, below) = self.m, self._side(argument)
        more = m.expm1(size)
        less = more / (1 + more)
        sine = m.div(more + less, 2)
        return m.where(below, -sine, sine), 1 + m.div(more * less, 2)

    def _tanh(self, argument: sympy.Expr) -> Coefficient:
        """Return the hyperbolic tangent ``−sgn(a) E/(2 + E)`` from ``E = e^(−2|a|) − 1``; E cannot overflow."""
        size, below = self._side(argument)
        less = self.m.expm1(-2 * size)
        return self.m.where(below, less, -less) / (2 + less)

    def _asinh(self, argument: sympy.Expr) -> Coefficient:
        """Return the inverse hyperbolic sine ``sgn(a) log(1 + |a| + a²/(1 + √(1 + a²)))``."""
        m, (size, below) = self.m, self._side(argument)
        square = size * size
        return m.where(below, -1, 1) * m.log1p(size + square / (1 + m.sqrt(1 + square)))

    def _atanh(self, argument: sympy.Expr) -> Coefficient:
        """Return the inverse hyperbolic tangent ``sgn(a) log(1 + 2|a|/(1 − |a|))/2``."""
        m, (size, below) = self.m, self._side(argument)
        return m.where(below, -1, 1) * m.div(m.log1p(2 * size / (1 - size)), 2)

    def _log(self, argument: sympy.Expr) -> Coefficient:
        """Return log a as ``log(1 + (a − 1))``, or as ``−log(1 + (1 − a)/a)`` for a < 1/2 to keep all digits."""
        m, a, beside = self.m, self.at(argument), self.at(argument - 1)
        small = m.less(2 * a, 1)
        return m.where(small, -1, 1) * m.log1p(m.where(small, -beside, beside) / m.where(small, a, 1))


FUNCTIONS: Mapping[Any, Callable[[PhiValues, sympy.Expr], Coefficient]] = {
    sympy.sin: lambda at, e: at._circular(e)[0],
    sympy.cos: lambda at, e: at._circular(e)[1],
    sympy.tan: lambda at, e: at.m.tan(at.at(e)),
    sympy.asin: lambda at, e: 2 * at._short_arc(at.at(e) / (1 + at.at(sympy.sqrt(1 - e**2)))),
    sympy.acos: lambda at, e: 2 * at._atan(at.at(sympy.sqrt((1 - e) / (1 + e)))),
    sympy.atan: lambda at, e: at._atan(at.at(e)),
    sympy.sinh: lambda at, e: at._hyperbolic(e)[0],
    sympy.cosh: lambda at, e: at._hyperbolic(e)[1],
    sympy.tanh: PhiValues._tanh,
    sympy.asinh: PhiValues._asinh,
    sympy.atanh: PhiValues._atanh,
    sympy.exp: PhiValues._exp,
    sympy.log: PhiValues._log,
}
"""Functions that kernels compute, with the lowering of each."""


def _sums(product: sympy.Expr) -> Any:
    return sum(power for base, power in product.as_powers_dict().items() if base.is_Add)


def _nested(polynomial: sympy.Expr) -> sympy.Expr:
    """Return an odd or even polynomial of α by Horner's rule in α²."""
    odd = sympy.Poly(polynomial, alpha).degree() % 2 if polynomial.has(alpha) else 0
    nested = sympy.horner(sympy.expand(polynomial / alpha**odd).subs(alpha, sympy.sqrt(SQUARE)), wrt=SQUARE)
    return alpha**odd * nested.subs(SQUARE, alpha**2)


class _Unnamed:
    """Arithmetic without names of values; a trace numbers the values used more than once."""

    def __init__(self, m: Arithmetic) -> None:
        m.name_rest("e")
        self._m = m

    def name(self, name: str, value: Coefficient) -> Coefficient:
        return value

    def __getattr__(self, operation: str) -> Any:
        return getattr(self._m, operation)


def _to_power(base: Coefficient, exponent: int) -> Coefficient:
    value: Coefficient = 1
    for bit in bin(exponent)[2:]:
        value = value if _is_one(value) else value * value
        value = value * base if bit == "1" else value
    return value


def _is_one(value: Coefficient) -> bool:
    return isinstance(value, int) and value == 1


def _over(constant: Any, below: Coefficient, m: Arithmetic) -> Coefficient:
    if is_small(constant):
        return m.div(constant.numerator, below if constant.denominator == 1 else constant.denominator * below)
    return times(constant, m.div(1, below), m, "over", LEVELS)


class Lengths:
    """Derivatives of a φ that is a quotient at 0: below a limit those of ``α b(α²)``, with a polynomial b."""

    def __init__(
        self, near: Ratio, end: Any, angle: Coefficient, square: Coefficient, m: Arithmetic, mark: str
    ) -> None:
        self.m, self.angle, self.mark, self.near = m, angle, mark, near
        limit = near.limit
        self._known: dict[int, Coefficient] = {}
        self.is_near = m.name(f"closeby{mark}", m.less(limit.denominator * square, limit.numerator))
        self.square = m.name(f"squaren{mark}", m.where(self.is_near, square, square - square))
        self.side = m.name(f"sideof{mark}", m.where(m.less(angle, 0), -1, 1))
        beside = plus(angle - angle, end / 2, m, f"between{mark}")  # an unused angle
        self.far = PhiValues(m.name(f"large{mark}", m.where(self.is_near, beside, self.side * angle)), m)

    def derivative(self, phi: sympy.Expr, count: int) -> Coefficient:
        """Return a derivative up to the third, or φ itself for count 0."""
        far, xi, angle = self.far.derivative(phi, count), self.square, self.angle
        near = (
            lambda: angle * self._b(0),
            lambda: self._b(0) + 2 * (xi * self._b(1)),
            lambda: angle * (6 * self._b(1) + 4 * (xi * self._b(2))),
            lambda: 6 * self._b(1) + 24 * (xi * self._b(2)) + 8 * (xi * xi * self._b(3)),
        )[count]()
        value = self.m.where(self.is_near, near, far if count % 2 else self.side * far)
        return self.m.name(f"phi{count}{self.mark}", value)

    def _b(self, count: int) -> Coefficient:
        if count not in self._known:
            self._known[count] = self.near.polynomials[count].at(self.square, self.m, f"b{count}{self.mark}")
        return self._known[count]
