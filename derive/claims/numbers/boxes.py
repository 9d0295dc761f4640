"""Sign of a polynomial on a box, by its coefficients in coordinates from 0 to ∞ and by halving of the box.

A variable between two bounds is ``(low + high t)/(1 + t)`` with t from 0 to ∞. If no coefficient in these t is
negative, neither is the polynomial. A negative one may have two others beside it, as in ``a t**2 - b t + c`` with
``b b <= 4 a c``. Else the box is cut at t = 1. All numbers are rational, so equality at a corner is exact.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product
from math import comb, isqrt, lcm, prod

BOXES_MAX = 128
"""Largest number of boxes."""
TERMS_MAX, VARIABLES_MAX = 600, 4
"""Largest number of coefficients, and of variables."""
Polynomial = Mapping[tuple[int, ...], int]
"""Coefficients by exponents."""


@dataclass(frozen=True)
class Interval:
    """Bounds of a variable; `shut` tells of both ends whether they count where a polynomial must not be 0."""

    low: Fraction | None = None  # None stands for infinity
    high: Fraction | None = None
    shut: tuple[bool, bool] = (False, False)


def is_positive(terms: Mapping[tuple[int, ...], Fraction], box: Sequence[Interval], strict: bool = False) -> bool:
    """Return whether a polynomial is proved not to be negative on a box, and nowhere 0 if `strict`."""
    scale = lcm(*(c.denominator for c in terms.values()))
    degrees = [max(powers[i] for powers in terms) for i in range(len(box))]
    if len(box) > VARIABLES_MAX or prod(d + 1 for d in degrees) > TERMS_MAX:
        return False
    whole = {powers: int(c * scale) for powers, c in terms.items()}
    waiting = [_Box(whole, degrees, tuple(shut), (0,) * len(box)) for whole, shut in _unbounded(whole, degrees, box)]
    for _ in range(BOXES_MAX):
        if not waiting:
            return True
        one = waiting.pop()
        if one.is_negative_at_a_corner(strict):
            return False
        if not one.is_proved(strict):
            waiting += one.halves()
    return False


def _unbounded(
    terms: Polynomial, degrees: Sequence[int], box: Sequence[Interval]
) -> Iterator[tuple[Polynomial, list[tuple[bool, bool]]]]:
    """Yield a polynomial in coordinates from 0 to ∞, for both signs of variables without a bound, and the shut ends."""
    choices = [(interval,) if interval.low is not None or interval.high is not None else
               (Interval(Fraction(0), None, (True, False)), Interval(None, Fraction(0), (False, True)))
               for interval in box]  # fmt: skip
    for chosen in product(*choices):
        found, shut = terms, []
        for i, interval in enumerate(chosen):
            found = _mapped(found, i, *_lines(interval), degrees[i])
            shut.append(interval.shut if interval.low is not None else interval.shut[::-1])
        yield found, shut


def _lines(interval: Interval) -> tuple[tuple[int, int], tuple[int, int]]:
    """Return the linear numerator and denominator in t of a variable between two bounds."""
    low, high = interval.low, interval.high
    if low is None or high is None:  # ``low + t`` or ``high - t``
        end, sign = (low, 1) if low is not None else (high or Fraction(0), -1)
        return (end.numerator, sign * end.denominator), (end.denominator, 0)
    scale = lcm(low.denominator, high.denominator)
    return (int(low * scale), int(high * scale)), (scale, scale)


def _mapped(terms: Polynomial, i: int, above: tuple[int, int], below: tuple[int, int], degree: int) -> Polynomial:
    """Return ``below**degree f`` with ``above/below`` for variable i, both linear in a new variable."""
    rows = [_product(_power(above, k), _power(below, degree - k)) for k in range(degree + 1)]
    found: dict[tuple[int, ...], int] = {}
    for powers, c in terms.items():
        for k, factor in enumerate(rows[powers[i]]):
            if factor:
                key = (*powers[:i], k, *powers[i + 1:])
                found[key] = found.get(key, 0) + c * factor
    return {powers: c for powers, c in found.items() if c}


def _power(line: tuple[int, int], exponent: int) -> list[int]:
    a, b = line
    return [comb(exponent, k) * a ** (exponent - k) * b**k for k in range(exponent + 1)]


def _product(a: Sequence[int], b: Sequence[int]) -> list[int]:
    found = [0] * (len(a) + len(b) - 1)
    for i, c in enumerate(a):
        for k, d in enumerate(b):
            found[i + k] += c * d
    return found


@dataclass(frozen=True)
class _Box:
    """Polynomial in coordinates from 0 to ∞, with its degrees, its ends that count, and how often each was cut."""

    terms: Polynomial
    degrees: Sequence[int]
    shut: tuple[tuple[bool, bool], ...]
    cuts: tuple[int, ...]

    def is_negative_at_a_corner(self, strict: bool) -> bool:
        """Return whether the polynomial is certainly negative at a corner, or 0 at one that counts if `strict`."""
        for corner in product(*((0, 1) for _ in self.degrees)):
            c = self.terms.get(tuple(d * end for d, end in zip(self.degrees, corner, strict=True)), 0)
            counts = all(shut[end] for shut, end in zip(self.shut, corner, strict=True))
            if c < 0 or (strict and counts and not c):
                return True
        return False

    def is_proved(self, strict: bool) -> bool:
        left = _without_squares(self.terms)
        if left is None:
            return False
        return not strict or all(_is_apart(left, self.degrees, ends) for ends in product(*map(_places, self.shut)))

    def halves(self) -> Iterator[_Box]:
        """Yield both parts of a box, cut at 1 in the variable that was cut least."""
        i = min(range(len(self.degrees)), key=lambda k: (not self.degrees[k], self.cuts[k], -self.degrees[k]))
        cuts = (*self.cuts[:i], self.cuts[i] + 1, *self.cuts[i + 1:])
        low, high = self.shut[i]
        for above, below, ends in (((0, 1), (1, 1), (low, True)), ((1, 1), (1, 0), (True, high))):
            terms = _mapped(self.terms, i, above, below, self.degrees[i])
            yield replace(self, terms=terms, cuts=cuts, shut=(*self.shut[:i], ends, *self.shut[i + 1:]))


def _without_squares(terms: Polynomial) -> dict[tuple[int, ...], Fraction] | None:
    """Return what is left of the positive terms beside squares that contain all negative ones, or None."""
    left = {powers: Fraction(c) for powers, c in terms.items() if c > 0}
    for powers, c in terms.items():
        if c < 0:
            pairs = ((a, tuple(2 * p - q for p, q in zip(powers, a, strict=True))) for a in left)
            pair = max(((left[a] * left[b], a, b) for a, b in pairs if a < b and b in left), default=None)
            if pair is None or 4 * pair[0] < c * c:
                return None
            part = _root_above(Fraction(c * c) / (4 * pair[0]))
            for one in pair[1:]:
                left[one] *= 1 - part
    return {powers: c for powers, c in left.items() if c}


def _root_above(a: Fraction) -> Fraction:
    """Return a number not below the root of one from 0 to 1, and exact if it is rational."""
    scale = a.denominator * 10**12
    root = isqrt(a.numerator * a.denominator * 10**24)
    exact = root * root == a.numerator * a.denominator * 10**24
    return min(Fraction(root if exact else root + 1, scale), Fraction(1))


def _places(shut: tuple[bool, bool]) -> list[int | None]:
    """Return the ends of a variable that count, or None for its interior if none does."""
    return [end for end in (0, 1) if shut[end]] or [None]


def _is_apart(terms: Iterable[tuple[int, ...]], degrees: Sequence[int], ends: Sequence[int | None]) -> bool:
    """Return whether a positive term shows that a polynomial is not 0 where variables are at some of their ends."""
    return any(all(end is None or power == degree * end for power, degree, end in
                   zip(powers, degrees, ends, strict=True)) for powers in terms)  # fmt: skip
