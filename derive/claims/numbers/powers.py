"""Powers with integer letters in the exponent, such as ``x**(2*n + 1)``, over a field of generators.

Each irreducible factor f of a base has a positive generator for each integer m in exponents. It is ``f**(m/2)`` if f is
positive, else ``abs(f)**((m - 1)/2)`` for odd m and ``abs(f)**(m/2)`` for even m: a proof takes both.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy

from ...algebra import Dual, Quaternion, Structure, Vector, real_part
from ...algebra.element import NotExactError
from .intervals import Monomial


def is_whole(field: Any, monomial: Monomial) -> bool:
    """Return whether a monomial is a product of integers."""
    return all(name in field.integers and power > 0 for name, power in monomial)


def power(field: Any, base: Any, exponent: Any) -> Any:
    """Return a power whose exponent is a polynomial in integers with rational coefficients."""
    if isinstance(base, Quaternion | Vector):
        return _of_quaternion(field, base if isinstance(base, Quaternion) else Quaternion(0, base), exponent)
    if isinstance(base, Structure):
        raise NotExactError("a power of a matrix with a letter as exponent")
    if isinstance(base, Dual):
        return base.apply(lambda a: power(field, a, exponent), lambda a: exponent * power(field, a, exponent) / a)
    base, found = field.element(base), field.element(1)
    for monomial, multiple in field.terms(exponent) if base != 1 else ():
        if multiple.denominator > 2 or (multiple.denominator == 2 and not field.is_positive(base)):
            raise NotExactError("a root that is none of a positive square")
        found = found * field.power(_to_the(field, base, monomial), multiple)
    return found


def _to_the(field: Any, base: Any, monomial: Monomial) -> Any:
    """Return a number to the power of an integer."""
    if not monomial:
        return base
    if not base or not is_whole(field, monomial):
        raise NotExactError("an exponent that is no integer")
    found = field.element(1)
    for factor, count in _factors(field, base):
        found = found * _factor_to_the(field, factor, monomial) ** count
    return found


def _factors(field: Any, a: Any) -> Iterator[tuple[Any, int]]:
    """Yield the factors of a number with exponents: -1, primes, and polynomials, positive if they have one sign."""
    rest = a
    for part, sign in ((a.numerator, 1), (a.denominator, -1)):
        for factor, count in field.ring.library.factors(part):
            number = field.ring.fraction(factor, field.ring.library.one)
            number = -number if _sign(number) < 0 else number
            rest = rest / number ** (sign * count)
            yield number, sign * count
    (constant,) = field.ring.library.terms(rest.numerator).values()
    if constant < 0:
        yield field.element(-1), 1
    for number, sign in ((constant.numerator, 1), (constant.denominator, -1)):
        for prime, count in sympy.factorint(abs(number)).items():
            yield field.element(int(prime)), sign * count


def _sign(a: Any) -> int:
    """Return the sign of a number, 0 if it has no definite one."""
    try:
        return int(a.sign())
    except NotExactError:
        return 0


def _factor_to_the(field: Any, factor: Any, monomial: Monomial) -> Any:
    if factor == -1:
        return field.element(field.parity(monomial))
    is_odd = not _sign(factor) and field.parity(monomial) < 0
    half = field.half_power(factor, monomial, is_odd)
    return half * half * factor if is_odd else half * half


def _of_quaternion(field: Any, q: Quaternion, exponent: Any) -> Quaternion:
    """Return a power of ``size (cos a + u sin a)``; that of an integer does not depend on the sign of the size."""
    w = q.vector
    if real_part(w.dot(w)) == 0:
        size = power(field, q.scalar, exponent)
        return Quaternion(size, exponent * size / q.scalar * w)
    length = field.magnitude(w)
    if all(multiple.denominator == 1 and is_whole(field, monomial) for monomial, multiple in field.terms(exponent)):
        angle = field.line(length, q.scalar)
        size = power(field, length / field.sin(angle), exponent)
    else:
        angle = field.atan2(length, q.scalar)
        size = power(field, field.sqrt(q.norm2()), exponent)
    return Quaternion(size * field.cos(exponent * angle), size * field.sin(exponent * angle) / length * w)
