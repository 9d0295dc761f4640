"""Whether a mutant says the same as what it was made from, decided exactly: then no check can tell the two apart.

What is compared are the parts in which the two differ, from the smallest one up, whatever their letters stand for:
definitions are forgotten, but for what functions are. So a mutant is not equivalent because both happen to be true.
Two parts say the same if

* they have the same value: ``|a − b|`` and ``|b − a|``;
* one is the opposite of the other, where only its magnitude matters, or whether it is 0: ``a − b ≠ 0``, ``b − a ≠ 0``;
* they are zero or infinite at the same places, where they must be neither: ``a ≠ 0``, ``a² ≠ 0`` and ``1/a ≠ 0``;
* and besides their product is a square, where they must be positive: ``0 < a`` and ``0 < 1/a``.

What has an order n is compared at each of the orders that it is executed at.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import partial
from typing import Any

from derive.algebra import Dual, Structure
from derive.algebra.exact import Element
from derive.algebra.polynomial_backend import Polynomial, Polynomials

from .equation import Equation
from .language import values
from .language.evaluation import Env
from .language.notation import equal, nonzero
from .language.terms import Apply, Letter, Number, Term, Trait, letters, marked, takes_apart
from .numbers.generic import Generic
from .numbers.kinds import BRANCH, KINDS, ORDER, SIGN
from .numbers.residues import Reduced, Residue
from .readings.items import MEANINGLESS

STEPS = 24
"""Sine and cosine of multiples of angle/24 are exact, and at order n of angle/4n."""
FREE = {"number": "dual number"}
"""What stands for letters that only a definition has a value for, once that is forgotten."""
NUMBERS = (Element, Residue, Dual, int, Fraction)
FIXED = (ORDER, BRANCH, SIGN)
Pair = tuple[Term, Term]
"""A part of a formula before and after the change."""
Comparison = Callable[[Env, Term, Term], bool]


def equivalent(entry: Equation, changed: Pair, orders: Sequence[int]) -> bool:
    """Whether a changed statement or domain of an entry says the same as it did."""
    return any(_everywhere(entry, pair, orders, comparison) for pair, comparison in reversed(list(_compared(changed))))


def _compared(pair: Pair, joined: bool = True) -> Iterator[tuple[Pair, Comparison]]:
    """The parts in which two formulas differ, the widest first, with what makes them the same."""
    yield pair, _same
    before, after = pair
    if not (isinstance(before, Apply) and isinstance(after, Apply) and before.args[0] == after.args[0]):
        return
    if len(before.arguments) != len(after.arguments):
        return
    different = [(a, b) for a, b in zip(before.arguments, after.arguments, strict=True) if a != b]
    if len(different) != 1:
        return
    (inside,) = different
    traits = before.mark.traits
    if Trait.LENGTH in traits:
        yield inside, _opposite
    elif joined and Trait.ASCENDS in traits and len(before.arguments) == 2 and before.arguments[0] == Number(0):
        yield inside, _same_sign
    elif before.mark is nonzero:
        yield inside, _vanish_together if joined else _opposite
    elif before.mark is equal and len(before.arguments) == 2 and Number(0) in before.arguments:
        yield inside, _opposite
    joined &= Trait.JOINS in traits and not before.mark.lazy and before.mark.name != "iff"
    yield from _compared(inside, joined)


def _everywhere(entry: Equation, pair: Pair, orders: Sequence[int], comparison: Comparison) -> bool:
    """Whether a comparison holds at generic values of all letters, at each order and branch."""
    if marked(Trait.DELICATE, *pair):  # what is so at generic values need not be so at others
        return False
    try:
        if comparison is _same and not all(_same(env, *pair) for env in _environments(entry, pair, orders, Reduced)):
            return False
    except MEANINGLESS:
        pass  # residues refute; they do not decide
    try:
        return all(comparison(env, *pair) for env in _environments(entry, pair, orders, Generic))
    except MEANINGLESS:  # not exact, or no value
        return False


def _environments(entry: Equation, pair: Pair, orders: Sequence[int], make: Callable[..., Generic]) -> Iterator[Env]:
    functions = {f: d for f, d in entry.definitions.items() if f.kind is KINDS["function"]}
    mentioned = dict.fromkeys(letter for part in pair for letter in letters(part))
    needed = dict.fromkeys(x for f in mentioned if f in functions for x in functions[f].arguments)
    free = [x for x in {**mentioned, **needed} if x not in functions and x.kind.varies]
    fixed = {x.kind: x for x in free if x.kind in FIXED}
    stand_ins = {x: Letter(x.name, FREE.get(x.kind.name, x.kind.name)) for x in free if x.kind not in FIXED}
    for n in orders if ORDER in fixed else (0,):
        branches = range((entry.branches or n) if BRANCH in fixed else 1)
        for k, sign in itertools.product(branches, (1, -1) if SIGN in fixed else (1,)):
            point = make(stand_ins.values(), takes_apart(*pair), entry.moving, 4 * n or STEPS,
                         framed=not entry.components)  # fmt: skip
            chosen = {x: {ORDER: n, BRANCH: k, SIGN: sign}[kind] for kind, x in fixed.items()}
            known = {x: point.values[stand_in] for x, stand_in in stand_ins.items()}
            yield Env(point.field, {**known, **chosen}, functions, point.dual, point.moving)


def _same(env: Env, a: Term, b: Term) -> bool:
    first, second = env.value(a), env.value(b)
    if isinstance(first, values.Either) and isinstance(second, values.Either):
        orders = ((second.first, second.second), (second.second, second.first))
        return any(all(map(partial(_equal, env), (first.first, first.second), order)) for order in orders)
    return _equal(env, first, second)


def _opposite(env: Env, a: Term, b: Term) -> bool:
    return _equal(env, env.value(a), values.negative(env.value(b)))


def _equal(env: Env, first: Any, second: Any) -> bool:
    """Whether two numbers or two structures are equal: a truth or a function has no value to compare."""
    numbers = isinstance(first, NUMBERS) and isinstance(second, NUMBERS)
    if isinstance(first, bool) or not (numbers or (isinstance(first, Structure) and type(first) is type(second))):
        return False
    return values.equal(env.field, first, second)


def _vanish_together(env: Env, a: Term, b: Term) -> bool:
    """Whether two numbers are neither 0 nor infinite at the same places."""
    first, second = env.value(a), env.value(b)
    if _opposite(env, a, b):
        return True
    if not (isinstance(first, Element) and isinstance(second, Element) and first and second):
        return False
    library = first.ring.library
    one, other = (_zeros_and_poles(library, x) for x in (first, second))
    tangents = [i for i, name in enumerate(first.ring.names) if name.startswith("tan_")]
    at_infinity = all(_degree(library, first, i) * _degree(library, second, i) != 0
                      or _degree(library, first, i) == _degree(library, second, i) for i in tangents)  # fmt: skip
    return at_infinity and _divides_a_power(library, one, other) and _divides_a_power(library, other, one)


def _same_sign(env: Env, a: Term, b: Term) -> bool:
    """Whether two numbers are positive at the same places: neither vanishes alone, and their product is a square."""
    product = env.value(a) * env.value(b)
    return _vanish_together(env, a, b) and isinstance(product, Element) and bool(product.sqrt())


def _zeros_and_poles(library: Polynomials, a: Element) -> Polynomial:
    """Numerator times denominator, in lowest terms."""
    common = a.numerator.gcd(a.denominator)
    return (a.numerator / common) * (a.denominator / common)


def _degree(library: Polynomials, a: Element, i: int) -> int:
    """The order of the pole where a generator is infinite: it is 0 if there is a value other than 0."""
    parts = (library.terms(part) for part in (a.numerator, a.denominator))
    above, below = (max(exponents[i] for exponents in part) for part in parts)
    return above - below


def _divides_a_power(library: Polynomials, a: Polynomial, b: Polynomial) -> bool:
    """Whether all factors of one polynomial, numbers apart, are factors of another."""
    while not _is_constant(library, a):
        common = a.gcd(b)
        if _is_constant(library, common):
            return False
        a = a / common
    return True


def _is_constant(library: Polynomials, a: Polynomial) -> bool:
    return not any(any(exponents) for exponents in library.terms(a))
