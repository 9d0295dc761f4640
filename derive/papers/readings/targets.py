"""What a stretch may be asked for: residues of its components, and what becomes of them on the way down."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache

from ..numbers.residues import PRIME, square_root

Target = tuple[int, ...]
"""A number; a number and a vector along one direction; or a tensor by I, ṽ and v ⊗ v or ṽ²."""


class UndecidedSearchError(Exception):
    """The search cannot tell."""


@lru_cache(100_000)
def inverse(a: int) -> int:
    """Of a residue that is not 0."""
    return pow(a, -1, PRIME)


def scaled(factor: int, t: Target) -> Target:
    """A multiple."""
    return tuple([factor * c % PRIME for c in t])


def less(t: Target, a: Target) -> Target:
    """A difference."""
    return tuple([(c - d) % PRIME for c, d in zip(t, a, strict=True)])


def ratio(t: Target, b: Target) -> Iterator[int]:
    """The number f with ``t = f b``, if there is one."""
    k = next((k for k, c in enumerate(b) if c), None)
    if k is not None:
        f = t[k] * inverse(b[k]) % PRIME
        if f and scaled(f, b) == t:
            yield f


def times(a: Target, b: Target, square: int) -> Target:
    """A product of pairs; the vector's own square is ``-square``, so that they are a field."""
    return ((a[0] * b[0] - square * a[1] * b[1]) % PRIME, (a[0] * b[1] + a[1] * b[0]) % PRIME)


def reciprocal(a: Target, square: int) -> Target:
    """Of a pair that is not 0."""
    return scaled(inverse((a[0] * a[0] + square * a[1] * a[1]) % PRIME), (a[0], -a[1]))


def power(a: Target, e: int, square: int) -> Target:
    """Of a pair that is not 0."""
    base: Target = a if e > 0 else reciprocal(a, square)
    result: Target = (1, 0)
    for bit in bin(abs(e))[2:]:
        result = times(result, result, square)
        result = times(result, base, square) if bit == "1" else result
    return result


def roots(t: int, e: Fraction) -> Iterator[int]:
    """Every a with ``a^e = t``; (PRIME − 1)/2 is a prime, so odd roots are unique."""
    if t == 0:
        yield from (0,) * (e > 0)
        return
    number = pow(t, e.denominator, PRIME) if e > 0 else pow(inverse(t), e.denominator, PRIME)
    m, known = abs(e.numerator), [number]
    while m % 2 == 0:
        m //= 2
        found = [square_root(a) for a in known]
        known = [s * a % PRIME for a in found if a is not None for s in (1, -1)]
    yield from (pow(a, pow(m, -1, PRIME - 1), PRIME) for a in known)
