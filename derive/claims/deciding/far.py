"""Numbers where a generator is infinite: at half turns its tangent, and at one direction its coordinates.

The degree of a number in the generator tells whether it is 0 there, and its leading coefficients whether it is not.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from fractions import Fraction
from typing import Any

import sympy

from ...algebra.element import Element, NotExactError
from ..numbers.intervals import interval


def is_apart_at_infinity(signs: Any, a: Element) -> bool:
    """Return whether a number is not 0 where a generator is infinite, as at half turns, in the domain."""
    for name in _hidden(signs, a).intersection(_infinite(signs)):
        i = signs.ring.index(name)
        outside = any(_vanishes_far(signs, b, i) for b in signs.apart) or any(_is_far(signs, b, i) for b in signs.gaps)
        if not outside and not _is_apart_far(signs, a, i):
            return False
    return True


def _hidden(signs: Any, a: Element) -> set[str]:
    """Return the generators in a number and in the factors of its powers with integer letters."""
    factors = [factor for factor, name, _ in signs.field.powers.values() if name in signs.field.used(a)]
    found: set[str] = signs.field.used(a).union(*map(signs.field.used, factors))
    return found


def _growth(signs: Any, a: Element, i: int) -> tuple[Element, list[Element]]:
    """Return the degree of a quotient in a generator, and the leading coefficients of the factors above."""
    degree, leading = signs.field.element(0), []
    powers = {name: (factor, twice) for factor, name, twice in signs.field.powers.values()}
    for part, sign in ((a.numerator, 1), (a.denominator, -1)):
        for factor, count in signs.ring.library.factors(part):
            number = signs.ring.fraction(factor, signs.ring.library.one)
            base, m = next((powers[name] for name in signs.field.used(number) & {*powers}
                            if number == signs.field.symbol(name)), (number, Fraction(2)))
            if not {*powers}.isdisjoint(signs.field.used(base)) and signs.ring.names[i] in _hidden(signs, base):
                raise NotExactError("a sum of powers with integer letters")
            highest = int(base.numerator.degrees()[i])
            degree = degree + m * Fraction(sign * count * highest, 2)
            leading += [_leading(signs, base.numerator, i)] if highest and sign > 0 else []
    return degree, leading


def _vanishes_far(signs: Any, a: Element, i: int) -> bool:
    """Return whether a number is 0 where a generator is infinite."""
    with suppress(NotExactError):
        return bool(_growth(signs, a, i)[0].sign() < 0)
    return False


def _is_far(signs: Any, a: Element, i: int) -> bool:
    """Return whether a number has constants as leading coefficients, and is not 0 where a generator is infinite."""
    with suppress(NotExactError):
        degree, leading = _growth(signs, a, i)
        every = len(leading) == len(signs.ring.library.factors(a.numerator))
        return every and not any(map(signs.field.used, leading)) and bool(degree.sign() >= 0)
    return False


def _is_apart_far(signs: Any, a: Element, i: int) -> bool:
    """Return whether a number is proved not to be 0 where a generator is infinite; it may be if a root is too."""
    used, name = signs.field.used(a), signs.ring.names[i]
    if any(root in used and name in signs.field.used(square) for square, root in signs.field.extensions):
        return False
    with suppress(NotExactError):
        degree, leading = _growth(signs, a, i)
        return bool(degree.sign() > 0 or (not degree and all(map(signs.is_nonzero, leading))))
    return False


def _infinite(signs: Any) -> Iterator[str]:
    """Yield the generators that are infinite at values of letters: tangents, and coordinates of directions."""
    yield from () if signs.free else signs.outward
    for (what, monomial), name in signs.field.meanings.items():
        low, high = interval(signs.field, monomial)
        end, most = signs.field.steps * sympy.pi, max(abs(low), abs(high))
        reached = most > end or (most == end and any(other in signs.ring.closed for other, _ in monomial))
        if what == "tangent" and reached:
            yield name


def _leading(signs: Any, polynomial: Any, i: int) -> Element:
    """Return the coefficient of the highest power of a generator in a polynomial."""
    terms = signs.ring.library.terms(polynomial).items()
    power = max(powers[i] for powers, _ in terms)
    found: Element = sum((c * signs.field.product([(name, k) for name, k in zip(signs.ring.names, powers, strict=True)
                                                  if k and name != signs.ring.names[i]])
                          for powers, c in terms if powers[i] == power), signs.field.element(0))  # fmt: skip
    return found
