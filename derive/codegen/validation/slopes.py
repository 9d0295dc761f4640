"""Execution of the rules at scalar programs for every φ: slopes and values are equal in an exact ring.

The rules run on elements of the ring of the theorems on every φ. Their text is proved, not sampled.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import sympy

from ...algebra.element import Element
from ...proof import phi_theorems as every
from ...proof.notation import alpha
from ...proof.setting import Setting, Symbols
from ..lowering.scalar_programs import SCALARS, SQUARES
from .runtime import Case, Loaded

PHI, RATE, SIZE, SINE, COSINE = every.phi, 1 / every.phi_1, every.size, every.sine, every.cosine
VALUES: Mapping[str, sympy.Expr] = {
    **{premise.equation.left.name: premise.equation.right for premise in every.SCALARS}, "rate": RATE,
    "a": PHI * COSINE / SINE, "b": sympy.Integer(1), "size": PHI / SINE, "gain": PHI / (SIZE * SINE),
    "angle": alpha, "slope": RATE, "sign": sympy.Integer(1), "own": alpha, "within": alpha,
}  # fmt: skip
"""Results of scalar programs at a vector of length φ(α); ``a + b v`` has a constant b."""

EXPONENTIAL = {PHI: alpha, every.phi_1: 1, every.phi_2: 0, every.phi_3: 0}
"""Replacements that make the exponential of another chart."""

BY_ANGLE = {
    PHI: every.phi_1, every.phi_1: every.phi_2, every.phi_2: every.phi_3, alpha: 1, SINE: COSINE / 2, COSINE: -SINE / 2,
}  # fmt: skip
"""Derivatives by α."""


def by_angle(value: sympy.Expr) -> sympy.Expr:
    return sympy.Add(*(sympy.diff(value, one) * rate for one, rate in BY_ANGLE.items()))


def by_square(value: sympy.Expr) -> sympy.Expr:
    """Return a slope, twice the derivative by x = φ²."""
    return by_angle(value) / (PHI * every.phi_1)


def by_term(value: sympy.Expr) -> sympy.Expr:
    return by_square(value) / 2


def by_length(value: sympy.Expr) -> sympy.Expr:
    return PHI * by_square(value)


def named(result: str) -> sympy.Expr:
    """Return the result of a scalar program by its name; the name of a slope ends in y."""
    return by_square(named(result[:-1])) if result.endswith("y") else VALUES[result]


def results(name: str) -> list[sympy.Expr]:
    """Return the results of a scalar program."""
    return [PHI, every.phi_1, alpha] if name == "coefficient" else [named(result) for result in SCALARS[name].results]


GIVEN = {"x": PHI**2, SQUARES[0]: PHI**2, "r": PHI, "alpha": alpha, "fe": PHI * COSINE / SINE}
"""Arguments of scalar programs at that vector; 0 for others."""


def arguments(name: str) -> list[sympy.Expr]:
    return [GIVEN.get(argument, sympy.Integer(0)) for argument in SCALARS[name].arguments]


class Programs:
    """Scalar programs of every chart, or with replacements of one, on elements of a ring."""

    def __init__(self, at: Setting, replaced: Mapping[sympy.Expr, Any]) -> None:
        self.at, self.replaced = at, replaced

    def values(self, expressions: Iterable[sympy.Expr]) -> list[Any]:
        return [self.at.value(value.xreplace(self.replaced)) for value in expressions]

    def __getattr__(self, name: str) -> Any:
        found, known = self.values(results(name)), self.values(arguments(name))

        def program(m: Any, *given: Any) -> list[Any]:
            if SQUARES[0] in SCALARS[name].arguments:
                given = sum(given), *known[1:]
            if any(one - other for one, other in zip(given, known, strict=True)):
                raise ValueError(f"{name} is called at another vector")
            return found

        return program


class Array(Element):
    """Ring element with a `shape`, which the rules take for a moving number."""

    __slots__ = ()
    shape = ()


def slopes(loaded: Loaded) -> Iterator[Case]:
    """Cases of the rules at scalar programs: differences from derivatives in the ring, true if they are not 0."""
    part = loaded.part("_slopes")
    at = Setting(Symbols((COSINE, SINE, *every.PHI, alpha, SIZE)), every.SQUARES[:1])
    roots = [at.value(root) for root in (PHI, alpha, PHI / SINE)]
    m = SimpleNamespace(
        held=lambda a: a,
        sqrt=lambda a: next(root for root in roots if not root * root - a),
        where=lambda near, a, b: a if near else b,
    )
    c, e = Programs(at, {}), Programs(at, EXPONENTIAL)

    def case(name: str, found: Sequence[Any], expected: Iterable[sympy.Expr], of: Programs = c) -> Case:
        pairs = list(zip(found, of.values(expected), strict=True))
        off = [bool((Fraction(one) if isinstance(one, float) else one) - other) for one, other in pairs]  # 0/2 is 0.0
        return name, off, [False] * len(off)

    for near in (True, False):  # shares have two forms, and the point at which signs are taken selects one
        at.ring.point = {str(symbol): Fraction(1 if near else 5) for symbol in at.ring.symbols}
        for function, of, own, by in (
            (part.share_of_square, PHI**2, alpha / PHI, by_square),
            (part.share_of_angle, alpha**2, PHI / alpha, lambda value: by_angle(value) / alpha),
        ):
            expected = own, by(own), by(by(own)), by(every.phi_1)
            found = function(m, c, e, at.value(of))
            yield case(function.__name__, found, expected[: len(found)])
    for name, rule in part.SLOPES.items():
        if rule is not None and name != "gain":
            yield from _of_program(part, m, c, name, case)
    name, given = "tangent_dot_scalars", e.values(arguments("tangent_dot_scalars"))
    rows = part.SLOPES[name](m, e, getattr(e, name)(m, *given), given)
    yield case("slopes of exp(δ)", [row[0] for row in rows], [by_square(value) / 2 for value in results(name)], e)
    yield case("slopes of a ray", *_of_ray(part, m, c))
    yield case("slopes of gain", *_of_gain(part, m, c))


def _of_program(part: Any, m: Any, c: Programs, name: str, case: Callable[..., Case]) -> Iterator[Case]:
    """Yield cases of a scalar program of x, of x and the length r, or of an angle."""
    program, given = getattr(c, name), c.values(arguments(name))
    found = program(m, *given)
    bare = SimpleNamespace(**{**vars(m), "held": lambda a: 0})
    ends = part.LAST[name](bare, c, program, found, given) if name in part.LAST else []
    values = results(name)[: len(found) - len(ends)]
    if ends:
        yield case(f"last results of {name}", ends, results(name)[len(values) :])
    by, place = by_term, 0
    if SCALARS[name].arguments[-1] == "alpha":
        by = by_angle
    elif SCALARS[name].arguments[-1] == "r":
        by, place = by_length, -1
    kept = [i for i, result in enumerate(SCALARS[name].results[: len(values)]) if result != "size"]
    rows = part.SLOPES[name](m, c, found, given)
    yield case(f"slopes of {name}", [rows[i][place] for i in kept], [by(values[i]) for i in kept])


def _of_ray(part: Any, m: Any, c: Programs) -> tuple[list[Any], list[sympy.Expr]]:
    """Return slopes of ``a + b v = size q`` at a constant size, and their values."""
    found, given = list(c.ray(m, c.at.value(PHI**2))), [c.at.value(PHI**2)]
    found[1] = Array(c.at.ring, found[1].numerator, found[1].denominator)
    rows = part.SLOPES["ray"](m, c, found, given)[:2]
    return [row[0] for row in rows], [PHI / SINE * by_square(value) / 2 for value in (COSINE, SINE / PHI)]


def _of_gain(part: Any, m: Any, c: Programs) -> tuple[list[Any], list[sympy.Expr]]:
    """Return derivatives of the gain by the parts of a quaternion of any size, and their values."""
    axis = [sympy.Rational(number, 3) for number in (2, -2, 1)]
    given = c.values([SIZE * COSINE, *(SIZE * SINE * u for u in axis), SIZE])
    (value,), (row,) = results("gain"), part.SLOPES["gain"](m, c, c.values(results("gain")), given)
    turn, stretch = 2 * by_angle(value) / SIZE, sympy.diff(value, SIZE)
    return row[:4], [COSINE * stretch - SINE * turn, *(u * (SINE * stretch + COSINE * turn) for u in axis)]
