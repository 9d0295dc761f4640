"""Letters of a claim in polar form: a vector is a length times a direction, a rotation turns by an angle about one.

Lengths and angles of rotation are generators with a range, directions have two stereographic coordinates. So lengths,
logarithms and their rates are rational, and no frame is chosen. Left out are the vector 0, rotations by 0 and π, and
one direction.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from enum import Enum, auto
from fractions import Fraction
from itertools import permutations
from typing import Any

import sympy

from ...algebra import Dual, Quaternion, Vector
from ...algebra.element import NotExactError
from ...algebra.first_principles import tensor_by_sandwich
from ...algebra.matrix import shaped
from ..language.matrices import entry, stacked
from ..language.printed import Number, Symbol, Term, symbols
from ..numbers.generators import Generators
from ..numbers.kinds import KINDS, ORDER, jet, sphere
from ..numbers.signed import Bound
from .terms import whole

POSITIVE = (sympy.Integer(0), sympy.oo)
HALF_TURN = (sympy.Integer(0), sympy.pi)
ALL = (-sympy.oo, sympy.oo)
LENGTHS = ("X", "A")
"""Coordinates whose ends no direction belongs to."""
COSINE = (sympy.Integer(-1), sympy.Integer(1))
RATES, DUAL = ("'", "''"), "°"
Make = Callable[[Generators, dict[str, Any]], Any]


def _rotation(field: Generators, c: Mapping[str, Any]) -> Any:
    half = c["A"] * Fraction(1, 2)
    return tensor_by_sandwich(Quaternion(field.cos(half), sphere((1, c["s"], c["t"])) * field.sin(half)))


def _pose(field: Generators, c: Mapping[str, Any]) -> Any:
    rows = zip(_rotation(field, c).rows, (c["x"], c["y"], c["z"]), strict=True)
    return shaped([*((*row, d) for row, d in rows), (0, 0, 0, 1)])


def _vector(field: Generators, c: Mapping[str, Any]) -> Any:
    return sphere((1, c["s"], c["t"])) * c["X"]


def _tangent(field: Generators, c: Mapping[str, Any]) -> Any:
    return sphere((1, c["s"], c["t"])) * field.tan(c["A"])


def _six(field: Generators, c: Mapping[str, Any]) -> Any:
    return shaped([[a] for a in (*_vector(field, c), c["x"], c["y"], c["z"])])


_DIRECTION = {"s": ALL, "t": ALL}
_POINT = {"x": ALL, "y": ALL, "z": ALL}
FORMS: Mapping[str, tuple[Mapping[str, tuple[Bound, Bound]], Make]] = {
    "real vector": ({"X": POSITIVE, **_DIRECTION}, _vector),
    "real unit vector": (_DIRECTION, lambda field, c: sphere((1, c["s"], c["t"]))),
    "rotation": ({"A": HALF_TURN, **_DIRECTION}, _rotation),
    "pose 4x4": ({"A": HALF_TURN, **_DIRECTION, **_POINT}, _pose),
    "twist": ({"X": POSITIVE, **_DIRECTION, **_POINT}, _six),
    "wrench": ({"X": POSITIVE, **_DIRECTION, **_POINT}, _six),
}
"""Coordinates with their intervals and the builder of a value, for kinds with a polar form."""
TANGENT = {"A": (sympy.Integer(0), sympy.pi / 2), **_DIRECTION}, _tangent
"""Form of a vector by the tangent of an angle, of which a claim about every order takes multiples."""


def _in_plane(field: Generators, c: Mapping[str, Any]) -> Any:
    return Vector(field.sqrt(1 - c["c"] ** 2), 0, c["c"])


def _form(letter: Symbol) -> str:
    """Return the name of the kind of a letter, that of the real kind for a dual vector or an orthogonal tensor."""
    name = letter.quantity.name.removeprefix("constant ")
    real = {"dual vector": "real vector", "unit vector": "real unit vector", "orthogonal tensor": "rotation"}
    return real.get(name, name)


FIRST: tuple[Mapping[str, tuple[Mapping[str, tuple[Bound, Bound]], Make]], ...] = (
    {"real vector": ({"X": POSITIVE}, lambda field, c: Vector(0, 0, 1) * c["X"]),
     "real unit vector": ({}, lambda field, c: Vector(field.element(0), 0, 1))},
    {"real vector": ({"X": POSITIVE, "c": COSINE}, lambda field, c: _in_plane(field, c) * c["X"]),
     "real unit vector": ({"c": COSINE}, lambda field, c: _in_plane(field, c))},
)  # fmt: skip
"""Forms of the first two vectors, if a frame is chosen along them: by their lengths and the cosine between them."""


class Way(Enum):
    """Form of letters: in polar form, also with a frame along the first two vectors, or by free components."""

    POLAR = auto()
    FRAMED = auto()
    COMPONENTS = auto()


def forms(letters: Sequence[Symbol], way: Way) -> dict[Symbol, tuple[Mapping[str, tuple[Bound, Bound]], Make]]:
    """Return the coordinates and builders of the letters that have other ones than their kind."""
    if way is Way.COMPONENTS:
        return {}
    found = {a: FORMS[_form(a)] for a in letters if _form(a) in FORMS}
    if way is Way.FRAMED:
        for a, first in zip((a for a in letters if _form(a) in FIRST[0]), FIRST, strict=False):
            found[a] = first[_form(a)]
    return found


def _intervals(
    letter: Symbol, form: Mapping[str, tuple[Bound, Bound]] | None, bounds: Mapping[str, tuple[Bound, Bound]]
) -> dict[str, tuple[Bound, Bound]]:  # fmt: skip
    """Return the intervals of the coordinates of a letter, within the bounds of its length or value in a domain."""
    kind = KINDS[letter.quantity.name]
    if kind.still:
        raise NotExactError(f"no polar form of a {_form(letter)}")
    free = POSITIVE if kind.spread == "positive" else ALL
    found = {str(i): free for i in range(kind.projective, kind.size)} if form is None else dict(form)
    bounded = next((stem for stem in ("X", "A", "0") if stem in found), None)
    if letter.name in bounds and bounded is not None:
        (low, high), (least, most) = found[bounded], bounds[letter.name]
        found[bounded] = max(low, least), min(high, most)
    return found


class Polar:
    """Values of letters over a field of generators; `field` makes it from names, intervals, integers and steps.

    Dual letters have dual parts if `dual`, else their real parts alone. `counts` are orders and branches of any size.
    If the frame is `free`, the first direction is that of its third axis now.
    """

    def __init__(
        self, letters: Sequence[Symbol], depth: int, bounds: Mapping[str, tuple[Bound, Bound]],
        field: Callable[..., Generators], closed: Collection[str] = (), dual: bool = False, way: Way = Way.POLAR,
        counts: Sequence[Symbol] = (), free: bool = False,
    ) -> None:  # fmt: skip
        self.depth, self.dual, self.forms = depth, dual, forms(letters, way)
        if counts:
            plain = (a for a in self.forms if self.forms[a][1] is _vector and a.name not in bounds)
            self.forms |= dict.fromkeys(plain, TANGENT)
        if way is Way.FRAMED and (depth or dual):
            raise NotExactError("no frame along moving vectors")
        first = next((a.name for a in letters if "s" in self.forms.get(a, ((),))[0]), "") if free else ""
        self.along_axis = {f"{first}.s", f"{first}.t"}
        stems = {a: _intervals(a, self.forms[a][0] if a in self.forms else None, bounds) for a in letters}
        intervals = {f"{a.name}.{stem}": ends for a in letters for stem, ends in stems[a].items()}
        parts = ("", DUAL) if dual else ("",)
        names = [name + part + dots for name in intervals for part in parts for dots in ("", *RATES[:depth])]
        integers = [f"{a.name}.0" for a in letters if KINDS[a.quantity.name].spread == "integer"]
        least = {f"{a.name}.0": (sympy.Integer(a.quantity is ORDER), sympy.oo) for a in counts}
        names, integers, intervals = [*names, *least], [*integers, *least], intervals | least
        ranges = {name: ends for name, ends in intervals.items() if ends != ALL}
        reached = {f"{a.name}.{stem}" for a in self.forms for stem in ("X", "c") if way is Way.FRAMED}
        shut = {name for name in ranges if name.split(".")[0] in closed} | (reached & set(ranges)) | set(least)
        self.field = field(names, ranges, integers, closed=shut)
        self.field.limits = {name for name in ranges if name.split(".")[1] in LENGTHS}
        quotients = ((key.partition("/"), ends) for key, ends in bounds.items() if "/" in key)
        self.field.ratios = {((f"{a}.0", 1), (f"{n}.0", -1)): ends for (a, _, n), ends in quotients}
        self.field.endless = {f"{a.name}.A" for a, form in self.forms.items() if form is TANGENT}
        # a length reaches 0, not its upper end
        self.field.endless |= {name for name in self.field.limits - shut if name.endswith(".X")}
        self.values = {a: self._value(a, list(stems[a])) for a in letters}
        self.values |= {a: self.field.symbol(f"{a.name}.0") for a in counts}

    def _value(self, letter: Symbol, stems: Sequence[str]) -> Any:
        kind = KINDS[letter.quantity.name]
        numbers = {stem: self._number(letter, stem) for stem in stems}
        if letter in self.forms:
            return self.forms[letter][1](self.field, numbers)
        return kind.build([*[1] * kind.projective, *numbers.values()])

    def _number(self, letter: Symbol, stem: str) -> Any:
        """Return a coordinate with its rates, which are 0 for constants and integers, and its dual part."""
        kind, name = KINDS[letter.quantity.name], f"{letter.name}.{stem}"
        still = kind.constant or kind.spread == "integer"

        def part(of: str) -> Any:
            value = self.field.element(0) if of in self.along_axis else self.field.symbol(of)
            return jet(value, [0 * value if still else self.field.symbol(of + dots) for dots in RATES[: self.depth]])

        if not self.dual:
            return part(name)
        return Dual(part(name), part(name + DUAL) if kind.dual else 0 * part(name))


def bounds(parts: Sequence[Term]) -> dict[str, tuple[Bound, Bound]]:
    """Return the intervals of numbers and of magnitudes that the relations of a domain give, by letter.

    That of ``a`` between multiples of an order n stands at ``a/n``.
    """
    found: dict[str, tuple[Bound, Bound]] = {}
    for letter, low, high in (row for part in parts for row in _bound(part)):
        least, most = found.get(letter, ALL)
        found[letter] = max(least, low), min(most, high)
    return found


def closed_letters(parts: Sequence[Term]) -> set[str]:
    """Return the letters with a bound that the domain includes."""
    rows = (row for part in parts if part.operator.name in ("at most", "at least") for row in _bound(part))
    return {name.partition("/")[0] for name, *_ in rows}


def _bound(part: Term) -> Iterator[tuple[str, Bound, Bound]]:
    """Yield letter and bounds of a relation of a letter, or of its magnitude, and a number."""
    name = part.operator.name if not isinstance(part, Number | Symbol) else ""
    if name not in ("less", "at most", "greater", "at least"):
        return
    below = name in ("less", "at most")
    a, b = part.arguments
    for inner, outer, is_upper in ((a, b, below), (b, a, not below)):
        (over, rest), inner = _order(outer), whole(inner)
        end, is_length = _constant(rest), inner.operator.name == "norm"
        subject = _of_length(inner.arguments[0]) if is_length else inner
        if end is not None and isinstance(subject, Symbol):
            least = -end if is_length else -sympy.oo
            if is_upper or not is_length:  # a magnitude above a bound leaves two intervals
                yield (subject.name + over, least, end) if is_upper else (subject.name + over, end, sympy.oo)


def _order(term: Term) -> tuple[str, Term]:
    """Return the name of an order after a slash, and the other factor, of a product with an order; else the term."""
    for a, b in permutations(term.arguments) if term.operator.name == "times" else ():
        if isinstance(a, Symbol) and a.quantity is ORDER:
            return f"/{a.name}", b
    return "", term


def _of_length(subject: Term) -> Term:
    """Return the twist of which a term is the first part, else the term."""
    found = symbols(subject)
    for letter in found:
        if len(found) == 1 and subject == stacked(*(entry(letter, Number(i)) for i in (1, 2, 3))):
            return letter
    return subject


def _constant(term: Term) -> Bound | None:
    """Return a number of numerals and π, or None."""
    if isinstance(term, Number):
        return sympy.Rational(term.value.numerator, term.value.denominator)
    if isinstance(term, Symbol):
        return sympy.pi if term.quantity.name == "π" else None
    parts = [_constant(a) for a in term.arguments]
    if any(part is None for part in parts):
        return None
    forms: dict[str, Callable[..., Any]] = {
        "over": lambda a, b: a / b, "negative": lambda a: -a, "times": lambda a, b: a * b, "bracket": lambda a: a,
        "plus": lambda a, b: a + b, "minus": lambda a, b: a - b,
    }  # fmt: skip
    return forms[term.operator.name](*parts) if term.operator.name in forms else None
