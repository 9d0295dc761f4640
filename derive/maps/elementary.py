"""Elementary expressions in the angle α: scalars of a chart, quotients that are 0/0 at 0, values at any number.

A `Quotient` ``N(α)/α^k`` is analytic at α = 0, where N has a zero of order k or more. Its derivative is
``(α N′ − k N)/α^(k+1)``; its value at 0 is a Taylor coefficient of N. Numbers near 0 are evaluated with as many further
digits as N loses there.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache, reduce
from operator import mul
from types import SimpleNamespace
from typing import Any, TypeAlias

import mpmath
import sympy

from ..algebra import Coefficient, Dual, functions, real_part
from ..algebra.pose import is_zero

alpha = sympy.Symbol("alpha")
"""Dual angle α: rotation angle + ε translation along the screw axis."""


def of_angle(phi: sympy.Expr) -> SimpleNamespace:
    r"""Return the scalars of a chart (`chart_formulas.Scalars`) and x as functions of α; T is not defined where φ′ = 0.

    .. math::
        T &= \frac{\sin\alpha}{\varphi}\,I + \frac{1 - \cos\alpha}{\varphi^2}\,\tilde v
            + \frac{1/\varphi' - \sin\alpha/\varphi}{\varphi^2}\,v \otimes v \\
        T^{-1} &= \frac{\varphi}{2} \cot\frac{\alpha}{2}\,I - \frac12\,\tilde v
            + \frac{\varphi' - (\varphi/2) \cot(\alpha/2)}{\varphi^2}\,v \otimes v
    """
    sine, cosine, slope = sympy.sin(alpha / 2), sympy.cos(alpha / 2), phi.diff(alpha)
    f, fi = 2 * sine * cosine / phi, phi * cosine / sine
    g, h, hi = 2 * sine**2 / phi**2, (1 / slope - f) / phi**2, (2 * slope - fi) / phi**2
    return SimpleNamespace(x=phi**2, s=cosine, w=sine / phi, f=f, g=g, h=h, fi=fi, hi=hi)


BOUND = sympy.Symbol("_t")
"""Bound symbol of N; no name of a user's symbol begins so by accident."""
BESIDE_ORDER = 3
"""Orders beyond k whose digits are kept near 0, for derivatives by dual numbers."""


class Quotient(sympy.Function):  # type: ignore[misc]  # SymPy is untyped
    """Quotient of a function N and a power of the angle: ``Quotient(Lambda(BOUND, N), k, angle)``."""

    nargs = 3
    is_commutative = True

    @classmethod
    def of(cls, above: sympy.Expr, power: int, angle: sympy.Symbol) -> sympy.Expr:
        """Return ``above/angle^power``, for a function of the angle that has a zero of this order at 0."""
        if above.is_polynomial(angle):
            return sympy.expand(above / angle**power)
        return cls(sympy.Lambda(BOUND, above.subs(angle, BOUND)), sympy.Integer(power), angle)

    @classmethod
    def eval(cls, above: sympy.Lambda, power: sympy.Integer, angle: sympy.Expr) -> sympy.Expr | None:
        """Return the value at a number; the quotient at −α is written with that at α."""
        N, k = above.expr, int(power)
        if angle.is_zero:
            return taylor(N, k)
        if angle.is_number:
            floats = angle.atoms(sympy.Float)
            digits = min((mpmath.libmp.prec_to_dps(f._prec) for f in floats), default=0)
            near = angle.evalf(digits + int(lost(mpmath.mpf(angle.evalf()), k) / 3)) if floats else angle
            value = N.subs(BOUND, near) / near**k
            return value.evalf(digits) if floats else value
        if angle.could_extract_minus_sign() and (side := mirror(N)):
            return side * (-1) ** k * cls(above, power, -angle)
        return None

    @property
    def above(self) -> sympy.Expr:
        """Function N of the bound symbol."""
        return self.args[0].expr

    @property
    def power(self) -> int:
        return int(self.args[1])

    @property
    def written(self) -> sympy.Expr:
        """Quotient as an elementary expression, which is 0/0 at 0."""
        return self.above.subs(BOUND, self.args[2]) / self.args[2] ** self.power

    def _eval_derivative(self, symbol: sympy.Symbol) -> sympy.Expr:
        slope = sympy.expand(BOUND * self.above.diff(BOUND) - self.power * self.above)
        return Quotient.of(slope, self.power + 1, BOUND).subs(BOUND, self.args[2]) * self.args[2].diff(symbol)

    def _eval_subs(self, old: Any, new: Any) -> sympy.Expr:
        """Replace in the angle alone; SymPy would replace the bound symbol too."""
        return self.func(*self.args[:2], self.args[2]._subs(old, new))

    def _eval_evalf(self, prec: int) -> Any:
        at = self.args[2].evalf(mpmath.libmp.prec_to_dps(prec))
        return self.func(*self.args[:2], at) if at.is_Float else None

    def _sympystr(self, printer: Any) -> str:
        return f"({printer._print(self.written)})"

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        value = rf"\left({printer._print(self.written)}\right)"
        return f"{value}^{{{exp}}}" if exp else value


@lru_cache(maxsize=1024)
def taylor(above: sympy.Expr, order: int) -> sympy.Expr:
    """Return a Taylor coefficient at 0 of a function of the bound symbol, exactly."""
    return sympy.expand(above.diff(BOUND, order).subs(BOUND, 0) / sympy.factorial(order))


@lru_cache(maxsize=256)
def mirror(above: sympy.Expr) -> int:
    """Return 1 for an even function of the bound symbol, −1 for an odd one, 0 if expansion shows neither."""
    there = above.subs(BOUND, -BOUND)
    return next((side for side in (1, -1) if sympy.expand(there - side * above) == 0), 0)


def lost(size: Any, power: int) -> int:
    """Return the binary digits that a quotient loses at a number."""
    return (power + BESIDE_ORDER) * max(0, -int(mpmath.mag(size)))


@lru_cache(maxsize=256)
def elementary(expression: sympy.Expr) -> sympy.Expr:
    """Return an expression without quotients, equal for α > 0."""
    if not expression.has(Quotient):
        return expression
    angle = sympy.Dummy("angle", positive=True)  # SymPy takes roots of its powers
    plain = expression.replace(lambda e: isinstance(e, Quotient), lambda e: e.written)
    return sympy.powdenest(sympy.expand_power_base(plain.xreplace({alpha: angle}))).xreplace({angle: alpha})


FUNCTIONS = ("sin", "cos", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "atanh", "exp", "log")
"""Functions that a library may provide in addition to sqrt."""

QUOTIENTS = {sympy.tan: (sympy.sin, sympy.cos), sympy.cot: (sympy.cos, sympy.sin)}

EXPRESSIONS_MAX = 256
"""Number of cached expressions; reading an expression takes longer than evaluating it."""

Step: TypeAlias = Callable[[Sequence[Coefficient], Coefficient, Any], Coefficient]
"""Function that computes one part of an expression from known parts, the value of the symbol and a library."""


def evaluate(expression: sympy.Expr, symbol: sympy.Symbol, value: Coefficient, library: Any = functions) -> Coefficient:
    """Return the value of an elementary expression in one symbol; each part is computed once.

    `library` provides ``sin``, ``cos``, ``sqrt`` for the numbers, ``exp``, ``log`` for rational exponents with
    denominators above 2. It may provide ``constant`` for numbers such as π, ``power`` for integer exponents, and
    ``quotient`` for `Quotient`. Division by zero raises ZeroDivisionError for every number type. A part that is not
    elementary, or contains another symbol, raises ValueError.
    """
    known: list[Coefficient] = []
    for step in _steps(expression, symbol):
        known.append(step(known, value, library))
    return known[-1]


@lru_cache(maxsize=EXPRESSIONS_MAX)
def _steps(expression: sympy.Expr, symbol: sympy.Symbol) -> Sequence[Step]:
    reader = _Reader(symbol)
    reader.place(expression)
    return reader.steps


class _Reader:
    def __init__(self, symbol: sympy.Symbol) -> None:
        self.steps: list[Step] = [lambda known, value, library: value]
        self._symbol, self._places = symbol, {symbol: 0}

    def place(self, e: sympy.Expr) -> int:
        if e not in self._places:
            step = self._step(e)
            self._places[e] = len(self.steps)
            self.steps.append(step)
        return self._places[e]

    def _step(self, e: sympy.Expr) -> Step:
        if e.is_Integer:
            integer = int(e)
            return lambda known, value, library: integer
        if e.is_Add:
            terms = [self.place(a) for a in e.args]
            return lambda known, value, library: sum(known[i] for i in terms)
        if e.is_Mul:
            return self._product(*sympy.fraction(e))
        if e.is_Rational:
            p, q = int(e.p), int(e.q)
            return lambda known, value, library: over(value * 0 + p, q)
        if not e.free_symbols:
            return lambda known, value, library: value * 0 + getattr(library, "constant", _constant)(e)
        return self._power(e) if e.is_Pow else self._function(e)

    def _product(self, numerator: sympy.Expr, denominator: sympy.Expr) -> Step:
        factors = [self.place(a) for a in sympy.Mul.make_args(numerator)]
        if denominator == 1:
            return lambda known, value, library: reduce(mul, (known[i] for i in factors))
        below = self.place(denominator)
        return lambda known, value, library: over(reduce(mul, (known[i] for i in factors)), known[below])

    def _power(self, e: sympy.Expr) -> Step:
        base, exponent = e.as_base_exp()
        if not exponent.is_Rational:
            raise ValueError(f"not an elementary expression in {self._symbol}: {e}")
        at, p, q = self.place(base), int(exponent.p), int(exponent.q)
        if q > 2:  # for positive numbers
            return lambda known, value, library: library.exp(library.log(known[at]) * (value * 0 + p) / q)

        def power(known: Sequence[Coefficient], value: Coefficient, library: Any) -> Coefficient:
            raised = getattr(library, "power", pow)(known[at] if q == 1 else library.sqrt(known[at]), abs(p))
            return raised if p > 0 else over(1 + 0 * raised, raised)

        return power

    def _function(self, e: sympy.Expr) -> Step:
        if isinstance(e, Quotient):
            place = self.place(e.args[2])
            return lambda known, value, library: getattr(library, "quotient", _quotient)(e, known[place])
        if e.func.__name__ not in FUNCTIONS and e.func not in QUOTIENTS:
            raise ValueError(f"not an elementary expression in {self._symbol}: {e}")
        argument = e.args[0]
        if quotient := QUOTIENTS.get(e.func):
            above, below = (self.place(f(argument, evaluate=False)) for f in quotient)
            return lambda known, value, library: over(known[above], known[below])
        name, at = e.func.__name__, self.place(argument)
        return lambda known, value, library: getattr(library, name)(known[at])


def _quotient(e: Quotient, value: Coefficient) -> Coefficient:
    """Return a quotient at a number, perhaps a nested dual one, in the working precision of mpmath."""
    real = value
    while isinstance(real, Dual):
        real = real.re
    if isinstance(real, float):
        return float(_quotient(e, mpmath.mpf(real)))
    if is_zero(real):
        terms = [value * 0 + _constant(taylor(e.above, e.power + count)) for count in range(BESIDE_ORDER + 1)]
        return reduce(lambda total, term: total * value + term, reversed(terms))
    with mpmath.extraprec(lost(real, e.power)):
        return evaluate(e.above, BOUND, value) / value**e.power


def _constant(e: sympy.Expr) -> Any:
    return mpmath.mpf(e.evalf(mpmath.mp.dps + 5))


def over(a: Coefficient, b: Coefficient) -> Coefficient:
    """Return a/b; raise `ZeroDivisionError` where b is 0, for every number type."""
    if is_zero(real_part(b)):
        raise ZeroDivisionError(f"division of {a!r} by {b!r}")
    return a / b
