"""Operators with a bound letter: derivatives by a vector, limits, Taylor polynomials and integrals.

Each evaluates its first argument at other values of the letter. Substitution treats the letter as local, by `BINDERS`.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import reduce
from typing import Any

from ...algebra import Dual, Quaternion, Structure, Tensor, matrix
from ...algebra.element import NotExactError
from ..numbers.balls import BlurredError, is_sharp, widened
from ..numbers.fields import UndefinedError, innermost
from ..numbers.series import Series, SeriesField
from . import values
from .environment import Env
from .operator_table import define, infinity
from .printed import ATOM, LIST, PRODUCT, SUM, Number, OperatorRow, Term, symbols, walk

BINDERS: dict[str, int] = {"sum": 0, "product": 0, "every": 0}
"""Place of the bound letter among the arguments, by operator."""
SPARE = 8
"""Terms of a series that quotients of singular terms may use up."""


def _binding(name: str, latex: str, text: str, slots: tuple[int, ...], value: Callable[..., Any]) -> OperatorRow:
    BINDERS[name] = 1
    return define(name, latex, text, PRODUCT, slots, value, lazy=True)


# ---- values near a point ----------------------------------------------------------------------------------------


def _seeded(field: SeriesField, value: Any, direction: Any) -> Any:
    """Return ``value + s direction``; rates and dual parts stay constant."""
    if isinstance(value, Structure):
        parts = iter(tuple(direction))
        return value.map(lambda c: _seeded(field, c, next(parts)))
    if isinstance(value, Dual):
        return Dual(_seeded(field, value.re, direction), value.du)
    return field.at(value, direction)


def coefficient(field: SeriesField, value: Any, power: int) -> Any:
    """Return the coefficient of a power of the small parameter, of each number of a value."""
    if isinstance(value, Structure):
        return value.map(lambda c: coefficient(field, c, power))
    if isinstance(value, Dual):
        return Dual(coefficient(field, value.re, power), coefficient(field, value.du, power))
    if isinstance(value, Series) and value.field is field:
        return value.upto(power + 1)[power]
    return value if power == 0 else 0 * value


def _expanded(env: Env, body: Term, letter: Term, at: Any, direction: Any, terms: int) -> list[Any]:
    """Return the Taylor coefficients of a term along a direction; both sides of the point must agree."""

    def along(sign: int) -> tuple[SeriesField, list[Any]]:
        field = SeriesField(env.field, terms + SPARE)
        moved = _seeded(field, at, direction * sign)
        found = dataclasses.replace(env, field=field).bound(letter, moved).value(body)
        return field, [coefficient(field, found, k) * sign**k for k in range(terms)]

    field, found = along(1)
    if field.one_sided and not all(map(env.equal, found, along(-1)[1])):
        raise UndefinedError("no derivative: both sides differ")
    return found


def _directions(at: Any) -> Iterator[Any]:
    """Yield a direction for each component of a value; those of a matrix in the order of `vec`."""
    if not isinstance(at, Structure):
        yield 1
        return
    size = len(tuple(at))
    columns = len(matrix.rows_of(at)[0]) if isinstance(at, matrix.Matrix | Tensor) else 1
    for i in sorted(range(size), key=lambda i: i % columns):
        yield at.map(_marks(size, i))


def _marks(size: int, i: int) -> Callable[[Any], int]:
    """Return a function that is 1 at its call i, else 0."""
    places = iter(range(size))
    return lambda component: int(next(places) == i)


def _derivatives(env: Env, body: Term, letter: Term, at: Term) -> tuple[Any, list[Any]]:
    place = env.value(at)
    found = [_expanded(env, body, letter, place, direction, 2) for direction in _directions(place)]
    return found[0][0], [slope for _, slope in found]


# ---- operators --------------------------------------------------------------------------------------------------


def _column(a: Any) -> Any:
    return matrix.shaped([[c] for c in a]) if isinstance(a, Quaternion) else a


def _jacobian(env: Env, body: Term, letter: Term, at: Term) -> Any:
    columns = list(map(_column, _derivatives(env, body, letter, at)[1]))
    return columns[0] if len(columns) == 1 else matrix.blocks([columns])


def _of_group(left: bool) -> Callable[..., Any]:
    """Return the left Jacobian (twist in the space frame) or the right one (body frame) of a rotation or pose."""

    def jacobian(env: Env, body: Term, letter: Term, at: Term) -> Any:
        g, slopes = _derivatives(env, body, letter, at)
        back = _group_inverse(g)
        products = [values.multiply(s, back) if left else values.multiply(back, s) for s in slopes]
        columns = [values.vect(p) for p in map(matrix.exactly, products)]
        return columns[0] if len(columns) == 1 else matrix.blocks([columns])

    return jacobian


def _group_inverse(g: Any) -> Any:
    if isinstance(g, Tensor):
        return g.transpose
    back = values.rotation(g).transpose
    return values.pose(back, -(back @ values.translation(g)))


def _value_at(env: Env, body: Term, letter: Term, at: Term) -> Any:
    return env.bound(letter, env.value(at)).value(body)


LINEAR = frozenset((
    "negative", "bracket", "transpose", "skew", "vect", "trace", "vec", "conjugate", "scalar of quaternion",
    "vector of quaternion", "vector", "plus", "minus", "Re", "Du",
))  # fmt: skip
PRODUCTS = frozenset(("times", "dot", "cross", "dyad", "kron"))
"""Operators that keep the degree of a formula, and those that add the degrees of their arguments."""


def degree(body: Term, letter: Term) -> int:
    """Return a bound of the degree of a formula that is a polynomial in a letter; raise NotExactError if it is none."""
    if letter not in symbols(body):
        return 0
    name, arguments = body.operator.name, body.arguments
    if body == letter:
        return 1
    if name in PRODUCTS:
        return sum(degree(a, letter) for a in arguments)
    if name == "power" and isinstance(arguments[1], Number) and arguments[1].value >= 0:
        return degree(arguments[0], letter) * arguments[1].value
    if name == "over" and letter not in symbols(arguments[1]):
        return degree(arguments[0], letter)
    if name in LINEAR or name.split()[0] in ("entry", "matrix", "block"):
        return max(degree(a, letter) for a in arguments)
    raise NotExactError(f"the expectation of {name}, which is no polynomial")


def _expectation(env: Env, body: Term, letter: Term, covariance: Term) -> Any:
    """Return the mean of a formula of second degree in a letter with mean 0: its terms by those of the covariance."""
    if degree(body, letter) > 2:
        raise NotExactError("the expectation of a formula of higher degree than 2")
    S = matrix.rows_of(matrix.exactly(env.value(covariance)))
    size = range(len(S))
    if not all(env.field.same(S[i][j], S[j][i]) for i in size for j in range(i)):
        raise UndefinedError("a covariance that is not symmetric")

    def at(*marks: tuple[int, int]) -> Any:
        components = [sum(sign for place, sign in marks if place == i) for i in size]
        return env.bound(letter, matrix.shaped([[Fraction(c)] for c in components])).value(body)

    def total(*terms: tuple[Any, Any]) -> Any:
        return reduce(values.add, (value * weight for value, weight in terms))

    mean = at()
    ahead, back = ([at((i, sign)) for i in size] for sign in (1, -1))
    found = [(mean, 1)]
    for i in size:
        found += [(ahead[i], S[i][i] / 2), (back[i], S[i][i] / 2), (mean, -S[i][i])]
        for j in range(i):
            found += [(at((i, 1), (j, 1)), S[i][j]), (ahead[i], -S[i][j]), (ahead[j], -S[i][j]), (mean, S[i][j])]
    return total(*found)


def _limit(env: Env, body: Term, letter: Term, at: Term) -> Any:
    if at == infinity:
        field = SeriesField(env.field, 2 + SPARE)
        found = dataclasses.replace(env, field=field).bound(letter, 1 / field.at(0, 1)).value(body)
        return coefficient(field, found, 0)
    return _expanded(env, body, letter, env.value(at), 1, 1)[0]


def _taylor(env: Env, body: Term, letter: Term, at: Term, order: Term) -> Any:
    """Return the Taylor polynomial about 0, along the ray through the value of the letter."""
    k, place = env.value(order), env.value(at)
    if all(env.field.vanishes(innermost(c)) for c in (place if isinstance(place, Structure) else [place])):
        ray = place.map(lambda c: 1) if isinstance(place, Structure) else 1
        return _expanded(env, body, letter, 0 * place, ray, 1)[0]
    found = _expanded(env, body, letter, 0 * place, _plain(place), k + 1)
    total = found[0]
    for term in found[1:]:
        total = values.add(total, term)
    return total


def _plain(a: Any) -> Any:
    """Return a value that does not move, which a ray can follow."""
    if any(isinstance(c, Dual) for c in (a if isinstance(a, Structure) else [a])):
        raise NotExactError("the series in a letter that moves or is dual")
    return a


TERMS = 16
"""Even terms of the Taylor polynomials that an integral uses."""
PIECES = (2, 8, 24)
"""Numbers of equal parts of the interval of an integral, tried in turn."""
KINKED, PIECES_CHECKED = ("norm", "root", "floor of number", "acos", "asin", "atan2 of two", "log"), 7
"""Operators with kinks or steps, over which the sum depends on the parts, and the number of parts that shows it."""
REMAINDER = 1024
"""Bound on the terms left out, in sizes of the last one; for analytic functions they fall geometrically."""


def _integral(env: Env, body: Term, letter: Term, low: Term, high: Term) -> Any:
    """Return the integral by Taylor polynomials about the middle of equal parts, with what they leave out as error."""
    if not env.field.ordered:
        raise NotExactError("an integral")
    a, b = env.value(low), env.value(high)
    sums = (_by_taylor(env, body, letter, a, b, pieces) for pieces in PIECES)
    result = next((found for found in sums if all(map(is_sharp, values.coefficients(found)))), None)
    if result is None:
        raise BlurredError
    kinked = any(node.operator.name in KINKED and letter in symbols(node) for node in walk(body))
    if kinked and not env.equal(result, _by_taylor(env, body, letter, a, b, PIECES_CHECKED)):
        raise NotExactError("an integral over a kink or step of its integrand")
    return result


def _by_taylor(env: Env, body: Term, letter: Term, a: Any, b: Any, pieces: int) -> Any:
    half = (b - a) / Fraction(2 * pieces)
    parts: list[Any] = []
    error: Any = 0
    for i in range(pieces):
        found = _expanded(env, body, letter, a + half * (2 * i + 1), 1, 2 * TERMS)
        terms = [found[k] * (2 * half ** (k + 1) / Fraction(k + 1)) for k in range(0, 2 * TERMS, 2)]
        parts.append(reduce(values.add, terms))
        error = sum((abs(c) for term in terms[-2:] for c in values.coefficients(term)), error)
    return _widened(reduce(values.add, parts), error * REMAINDER)


def _widened(value: Any, error: Any) -> Any:
    if isinstance(value, Structure):
        return value.map(lambda c: _widened(c, error))
    if isinstance(value, Dual):
        return Dual(_widened(value.re, error), _widened(value.du, error))
    return widened(value, error)


jacobian = _binding("jacobian", r"\frac{{\partial}}{{\partial {1}}} {0}", "jacobian({0}, {1})", (PRODUCT, ATOM, LIST),
                    _jacobian)
left_jacobian = _binding("left jacobian", r"J^{{l}}_{{{1}}}\left({0}\right)", "left_jacobian({0}, {1})",
                         (LIST, ATOM, LIST), _of_group(True))
right_jacobian = _binding("right jacobian", r"J^{{r}}_{{{1}}}\left({0}\right)", "right_jacobian({0}, {1})",
                          (LIST, ATOM, LIST), _of_group(False))
value_at = _binding("value at", r"\left. {0} \right|_{{{1} = {2}}}", "at({0}, {1}, {2})", (SUM, ATOM, LIST), _value_at)
expectation = _binding("expectation", r"\operatorname{{E}}_{{{1}}}\left[{0}\right]", "expectation({0}, {1}, {2})",
                       (LIST, ATOM, LIST), _expectation)
limit = _binding("limit at", r"\lim_{{{1} \to {2}}} {0}", "limit({0}, {1}, {2})", (PRODUCT, ATOM, LIST), _limit)
taylor = _binding("series", r"\operatorname{{series}}_{{{1}}}^{{{3}}} {0}", "series({0}, {1}, {3})",
                  (PRODUCT, ATOM, LIST, LIST), _taylor)
integral = _binding("integral", r"\int_{{{2}}}^{{{3}}} {0}\, d{1}", "integral({0}, {1}, {2}, {3})",
                    (SUM, ATOM, LIST, LIST), _integral)
