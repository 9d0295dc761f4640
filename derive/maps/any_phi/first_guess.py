"""Angle of a length ``|v|`` beyond the range of `near_zero`, by a proved number of Newton's steps from a guess.

A guess is φ⁻¹ in closed form, a fitted polynomial, or the middle of a bracket after a proved number of halvings. Let e
bound the error of a guess on an interval of angles. If ``K = max |φ″|/(2 min φ′)`` on this interval widened by e, the
error after a step is at most ``K e²``. Intervals up to the edge, and bounds of φ′ and φ″ on them, prove the numbers of
steps and halvings. A φ for which no number is proved is refused.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import mpmath
import sympy

from ...algebra.arithmetic import PLAIN
from ..angle import angle_of, real_value
from ..elementary import elementary
from ..grammar import PhiError
from ..real_constants import polynomial
from .edges import Edge, closed_inverse, with_quotients
from .guesses import LENGTH, LOGARITHM, Closed, Fitted, Guess, Halved, Variable, derivatives, fold, pole
from .intervals import Intervals, Undecided, precise
from .near_zero import chebyshev_points, interpolated

GUESS_DEGREE = 12
"""Degree of a fitted polynomial."""
TOLERANCE = mpmath.mpf(10) ** -30
"""Error after Newton's last step, relative to the distance to the edge, or to the angle if the edge is a cut."""
STEPS_MAX, STEPS_HALVED = 7, 5
"""Largest number of Newton steps, and the number after halvings."""
HALVINGS_MAX = 32
DIGITS = 53
"""Binary digits of the distance to a pole to which steps are proved; floats resolve no angles nearer to it.

At a fold with a zero of φ′ of order m, the length has the digits of the power m + 1 of the distance.
"""
PARTS, PARTS_MAX = 48, 6000
PARTED_MAX, PARTED_FOR_FEWER = 16, {"steps": 3, "count": 13}
"""Largest number of times that an interval is halved to prove any number, and to prove fewer steps or halvings."""


def guess(phi: sympy.Expr, edge: Edge, limit: Fraction) -> Guess:
    """Return the first guess for x beyond a limit; `PhiError` if no guess is proved to lead to the root."""
    if edge.kind == "pole" and not edge.order:
        raise PhiError(f"phi = {phi} grows like a logarithm near its edge {edge.angle}: floats lose the angle there")
    if edge.kind == "fold" and edge.order > 1 and not edge.angle > sympy.pi:
        raise PhiError(f"phi' of phi = {phi} has a double zero at its edge {edge.angle}: floats lose the angle there")
    with precise() as at:
        end, start = mpmath.mpf(edge.angle.evalf(mpmath.mp.dps)), mpmath.mpf(limit.numerator) / limit.denominator
        first = angle_of(phi, edge.angle, mpmath.sqrt(start)) * mpmath.mpf("0.98")
        for found in _guesses(phi, edge, first, end):
            if (proved := _proved(at, edge, found, first)) is not None:
                return proved
    reason = "no first guess is proved to lead Newton's method to the angle of every length"
    raise PhiError(f"phi = {phi} is not inverted to full precision: {reason}")


def _guesses(phi: sympy.Expr, edge: Edge, first: Any, end: Any) -> Iterator[Guess]:
    size = mpmath.inf if edge.kind == "pole" else _square(phi, end)
    # near a fold √(1 − x/X) determines the angle more accurately than the length does
    if edge.kind != "fold" and (inverse := closed_inverse(elementary(phi))) is not None:
        yield Closed(phi, end, size, 1, inverse)
    variables = [LENGTH, LOGARITHM]
    if edge.kind != "cut":
        variables = [fold(size, edge.order) if edge.kind == "fold" else pole(real_value(phi, end / 2, phi), edge.order)]
    for variable in variables:
        yield _fitted(phi, edge, variable, first, end)
    halved = Halved(phi, end, size, STEPS_HALVED, elementary(phi), None, 1)
    if edge.kind != "pole":
        yield halved
    else:
        powers = with_quotients(halved.f).as_powers_dict()
        f = sympy.Mul(*(base ** (-power / edge.order) for base, power in powers.items()))
        yield replace(halved, f=f, order=edge.order)


def _fitted(phi: sympy.Expr, edge: Edge, variable: Variable, first: Any, end: Any) -> Fitted:
    def value(angle: Any) -> Any:
        r = real_value(phi, angle, phi)
        return variable.of(r**2, mpmath.sqrt(r**2), PLAIN)

    ends = [value(first), 0 if variable.from_edge else value(end)]
    low, high = sorted(map(mpmath.mpf, ends))
    nodes = chebyshev_points(low, high, GUESS_DEGREE + 1)
    angles = [angle_of(phi, edge.angle, mpmath.sqrt(variable.back(z))) for z in nodes]
    values = [(end - a) / z if variable.from_edge else a for z, a in zip(nodes, angles, strict=True)]
    centre, scale = (low + high) / 2, int(mpmath.ceil(mpmath.log((high - low) / 2, 2)))
    middle = Fraction(int(mpmath.nint(centre * 2 ** (4 - scale))), 1) * Fraction(2) ** (scale - 4)
    centre = mpmath.mpf(middle.numerator) / middle.denominator
    coefficients = interpolated([(z - centre) / mpmath.mpf(2) ** scale for z in nodes], values)
    size = mpmath.inf if edge.kind == "pole" else _square(phi, end)
    return Fitted(phi, end, size, 1, variable, polynomial(coefficients, scale, 1, middle))


def _square(phi: sympy.Expr, angle: Any) -> Any:
    return real_value(phi, angle, phi) ** 2


# --- proofs of the number of steps --------------------------------------------------------------------------------


def _proved(at: Intervals, edge: Edge, found: Guess, first: Any) -> Guess | None:
    """Return a guess with the number of steps or halvings that is proved at all angles beyond the first; else None."""
    if isinstance(found, Closed):
        return found  # exact up to rounding
    parts = _parts(edge, first, found.edge)[::-1]
    pending, most = [(low, high, 0) for low, high in parts], 1
    for low, _ in parts:
        if (need := _needed(at, edge, found, low, low, most)) is None:
            return None  # no smaller interval can help
        most = max(most, need)
    proved, most = ("count", most + 1) if isinstance(found, Halved) else ("steps", most)
    for _ in range(PARTS_MAX):
        if not pending:
            return replace(found, **{proved: most})
        low, high, depth = pending.pop()
        need = _needed(at, edge, found, low, high, most)
        if need is not None and (need <= most or depth >= PARTED_FOR_FEWER[proved]):
            most = max(most, need)
        elif depth == PARTED_MAX:
            return None
        else:
            middle = (low + high) / 2
            pending += [(middle, high, depth + 1), (low, middle, depth + 1)]
    return None


def _parts(edge: Edge, first: Any, end: Any) -> list[tuple[Any, Any]]:
    """Return intervals from the first angle to the edge, or to the last angle before it that floats resolve."""
    if edge.kind == "cut":
        ends = [first + (end - first) * k / PARTS for k in range(PARTS + 1)]
    else:
        digits = DIGITS if edge.kind == "pole" else math.ceil(DIGITS / (edge.order + 1))
        ends = [end - (end - first) * mpmath.mpf(2) ** (-k / 4) for k in range(4 * digits)]
    return list(itertools.pairwise(ends))


def _needed(at: Intervals, edge: Edge, found: Guess, low: Any, high: Any, least: int) -> int | None:
    """Return the number of steps, or from ``least`` on of halvings, that an interval needs; None if none is proved."""
    left = low if edge.kind == "cut" else found.edge - high
    try:
        if not isinstance(found, Halved):
            error = found.error(at, low, high)
            if found.to_edge and 4 * error > left:
                return None  # a step could be longer than the way to the edge
            return _steps(at, found.phi, error, low, high, left)
        for count in range(least, HALVINGS_MAX):
            error = replace(found, count=count).error(at, low, high)
            steps = _steps(at, found.f, error, low, high, found.edge if found.order else left, found.bends)
            if steps is not None and steps <= found.steps:
                return count
    except (Undecided, ZeroDivisionError):
        pass
    return None


def _steps(
    at: Intervals, f: sympy.Expr, error: Any, low: Any, high: Any, left: Any, bends: Sequence[sympy.Expr] = ()
) -> int | None:
    """Return the number of Newton steps on f after which the error is within the tolerance; None if not proved.

    ``bends`` are further expressions of ``f″/f′``.
    """
    around, width = at.interval(low - error, high + error), high - low + 2 * error
    ratio = min((_ratio(at, f, around), *(_bounded(at, bend, around, width) for bend in bends)))
    for step in range(STEPS_MAX + 1):
        if error <= TOLERANCE * left:
            return step
        error = ratio * error**2
    return None


def _ratio(at: Intervals, f: sympy.Expr, around: Any) -> Any:
    """Return ``max |f″|/(2 min |f′|)``, infinite if nothing is proved."""
    try:
        steep, bend = (at.size(at.enclosure(of, around)) for of in derivatives(f))
        return bend[1] / (2 * steep[0]) if steep[0] else mpmath.inf
    except Undecided:
        return mpmath.inf


def _bounded(at: Intervals, bend: sympy.Expr, around: Any, width: Any) -> Any:
    """Return a bound of the same ratio from a bound b of ``f″/f′``: f′ changes by at most ``e^(w b)`` on a width w."""
    try:
        most = at.size(at.enclosure(bend, around))[1]
        return most / 2 * mpmath.exp(width * most)
    except Undecided:
        return mpmath.inf
