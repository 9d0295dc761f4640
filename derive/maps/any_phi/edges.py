r"""Edge of φ, decided by interval arithmetic, and the inverse φ⁻¹ below the edge in closed form.

Intervals on which φ′ is proved to be finite and positive lead from 0 to the edge. They shrink there. Then a zero of φ′
is isolated, or of a function whose zeros are singular points of φ. Near a singular point c, ``φ′ = N Π d_i^(-m_i)``
with N proved to be finite and not 0. Let M be the sum of all m_i with ``d_i(c) = 0``. For M > 1, φ has a pole of
order M − 1, for M = 1 a logarithmic one, and for M < 1 it is finite.

A closed inverse exists for compositions of invertible functions, and where φ² is a quotient of quadratics in α²:

.. math:: \varphi^2 = \frac{\alpha^2 (n_1 + n_2 \alpha^2)}{d_0 + d_1 \alpha^2 + d_2 \alpha^4} \qquad
    \alpha = \sqrt{\frac{2 d_0}{b + \sqrt{b^2 + 4 a d_0}}} \qquad
    a = \frac{n_2}{r^2} - d_2 \quad b = \frac{n_1}{r^2} - d_1

No power of a long r overflows.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache
from typing import Any

import mpmath
import sympy

from ..angle import real_value
from ..elementary import alpha, elementary
from ..grammar import PhiError
from .intervals import Intervals, Undecided, precise

PHI_DIGITS = 60
"""Working digits of numerical decisions."""
EDGE_MAX = 4
"""Largest edge in units of π; charts without an edge are cut there."""
STEP = mpmath.mpf(1) / 8
"""Largest width of an interval, in rad."""
LEAST_STEP, WINDOW = mpmath.ldexp(1, -70), mpmath.ldexp(1, -50)
"""Width below which a point is taken for an edge, and the range beyond it where the edge is looked for."""
CELLS_MAX = 6_000
"""Largest number of intervals; a φ that needs more is refused."""
BESIDE = mpmath.ldexp(1, -190)
"""Distance from a singular point up to which statements are proved."""
TURNING = {sympy.tan: sympy.cos, sympy.log: lambda u: u}
FLAT_MAX, FLAT_WIDTH = 2, mpmath.ldexp(1, -30)
"""Number of minima of φ′ that are kept, and the width of intervals that are too near the edge for one."""
ARCS = (sympy.asin, sympy.acos, sympy.atanh)


@dataclass(frozen=True)
class Edge:
    """Edge of φ: a fold (φ′ = 0), a pole, or the cut at 4π."""

    angle: sympy.Expr
    kind: str
    order: sympy.Rational = field(default=sympy.S.One, compare=False)
    """Order of the pole (0 for a logarithm), or of the zero of φ′ at a fold."""
    flat: tuple[Any, ...] = field(default=(), compare=False)
    """Angles below the edge at and beside the least minima of φ′, the least one first."""


@lru_cache(maxsize=64)
def edge_of(phi: sympy.Expr) -> Edge:
    """Return the edge: the first zero of φ′ or pole of φ, else the cut at 4π; `PhiError` unless φ increases from 0."""
    slope = phi.diff(alpha)
    with precise() as at:
        _require_start(phi, slope)
        cut = EDGE_MAX * mpmath.pi
        marched = list(cells(at, slope, mpmath.mpf(0), cut))
        stopped = marched[-1][1] if marched else mpmath.mpf(0)
        if stopped >= cut:
            return Edge(EDGE_MAX * sympy.pi, "cut", flat=_flat(slope, marched))
        plain = elementary(phi)
        found = _edge_beyond(at, plain, plain.diff(alpha), stopped)
        if found.kind == "cut":
            return Edge(EDGE_MAX * sympy.pi, "cut", flat=_flat(slope, marched))
        return Edge(found.angle, found.kind, found.order, _flat(slope, marched))


def _require_start(phi: sympy.Expr, slope: sympy.Expr) -> None:
    try:
        first = real_value(slope, mpmath.mpf(0), phi)
    except ZeroDivisionError:
        raise PhiError(f"phi = {phi} divides by zero at alpha = 0") from None
    if not first > 0:
        raise PhiError(f"phi'(0) = {mpmath.nstr(first, 5)}, and has to be positive")


def cells(at: Intervals, f: sympy.Expr, low: Any, end: Any, least: Any = LEAST_STEP) -> Iterator[tuple[Any, Any]]:
    """Yield neighbouring intervals on which f is proved to be positive, until one reaches the end or none is found."""
    rise, step = f.diff(alpha), STEP
    for _ in range(CELLS_MAX):
        if low >= end or step < least:
            return
        high = min(low + step, end)
        if _is_positive(at, f, rise, low, high):
            yield low, high
            low, step = high, min(2 * step, STEP)
        else:
            step = step / 4
    raise PhiError(f"nothing decides where phi turns: {CELLS_MAX} intervals end at alpha = {mpmath.nstr(low, 6)}")


def _is_positive(at: Intervals, f: sympy.Expr, rise: sympy.Expr, low: Any, high: Any) -> bool:
    """Return whether f > 0 is proved on an interval, directly or by the mean value theorem."""
    whole, half = at.interval(low, high), (high - low) / 2
    try:
        if at.bounds(at.enclosure(f, whole))[0] > 0:
            return True
        middle = at.bounds(at.enclosure(f, at.interval(low + half, low + half)))[0]
        return bool(middle > half * at.size(at.enclosure(rise, whole))[1])
    except Undecided:
        return False


def require_values(part: sympy.Expr, edge: sympy.Expr) -> None:
    """Raise `PhiError` if a part that cancels in φ is not proved to have values from 0 up to the edge."""
    with precise() as at:
        end = mpmath.mpf(min(edge, EDGE_MAX * sympy.pi).evalf(mpmath.mp.dps)) - WINDOW
        *_, (_, low) = [(0, mpmath.mpf(0)), *cells(at, 1 + part**2, mpmath.mpf(0), end)]
    if low < end:
        where = f"alpha = {mpmath.nstr(low, 6)}"
        raise PhiError(f"{part} cancels in phi, and nothing proves that it has a value at {where}: leave it out")


# --- the edge -----------------------------------------------------------------------------------------------------


def _edge_beyond(at: Intervals, phi: sympy.Expr, slope: sympy.Expr, low: Any) -> Edge:
    """Return the edge just beyond an angle; the kind is a cut if it lies beyond 4π."""
    singular = [(s, *found) for s in _singular(slope) if (found := _zero(at, s, low))]
    if singular:
        root = min(root for _, root, _ in singular)
        kind, order = "pole", _order(at, phi, slope, root)
    elif fold := _zero(at, slope, low):
        root, kind, order = fold[0], "fold", sympy.Integer(fold[1])
    else:
        raise PhiError(f"intervals do not decide whether phi = {phi} increases at alpha = {mpmath.nstr(low, 12)}")
    angle = _named(root)
    beyond = angle != EDGE_MAX * sympy.pi and root > EDGE_MAX * mpmath.pi
    return Edge(angle, "cut" if beyond else kind, order)


def _singular(expression: sympy.Expr) -> set[sympy.Expr]:
    """Return functions of α whose zeros are the singular points of an expression."""
    found = set()
    for part in sympy.preorder_traversal(expression):
        if part.is_Pow and part.has(alpha) and not (part.exp.is_Integer and part.exp > 0):
            found.add(part.base)
        elif part.func in TURNING:
            found.add(TURNING[part.func](part.args[0]))
        elif part.func in ARCS:
            found.add(1 - part.args[0] ** 2)
    return {function for function in found if function.has(alpha)}


def _zero(at: Intervals, f: sympy.Expr, low: Any) -> tuple[Any, int] | None:
    """Return the only zero of f in the window around an angle, and its multiplicity; None if there is none.

    A simple zero is proved by its change of sign. A double zero is proved by exact evaluation at the zero of f′.
    """
    window = at.interval(low - WINDOW, low + WINDOW)
    for multiplicity in (1, 2):
        rise = f.diff(alpha, multiplicity)
        try:
            steep = at.size(at.enclosure(rise, window))[0] > 0
            inside = multiplicity == 2 or at.size(at.enclosure(f, window))[0] == 0
        except Undecided:
            return None
        if not inside:
            return None
        if steep:
            of = f.diff(alpha, multiplicity - 1)
            root = _refined(of, rise, low)
            ends = [at.enclosure(of, at.interval(end, end)) for end in (root - BESIDE, root + BESIDE)]
            changes = at.bounds(ends[0] * ends[1])[1] < 0
            exact = multiplicity == 1 or sympy.expand(f.subs(alpha, _named(root))) == 0
            return (root, multiplicity) if changes and exact else None
    return None


def _refined(f: sympy.Expr, rise: sympy.Expr, root: Any) -> Any:
    for _ in range(8):
        root = root - real_value(f, root, f) / real_value(rise, root, f)
    return root


def _order(at: Intervals, phi: sympy.Expr, slope: sympy.Expr, root: Any) -> sympy.Rational:
    """Return the order of the pole of φ at a singular point; `PhiError` without a proof that it is a pole."""
    order, rest = sympy.S.Zero, sympy.S.One
    for base, power in with_quotients(slope).as_powers_dict().items():
        found = _zero(at, base, root) if base.has(alpha) else None
        order, rest = (order - power * found[1], rest) if found else (order, rest * base**power)
    where = f"alpha = {mpmath.nstr(root, 6)}"
    if not _is_regular(at, rest, root - WINDOW, root):
        raise PhiError(f"nothing proves that phi = {phi} goes to infinity at {where}, where it is singular")
    if order < 1:
        ends = "a chart ends where phi turns or is infinite"
        raise PhiError(f"phi = {phi} is singular at {where}, where it is finite: {ends}")
    return order - 1


def _is_regular(at: Intervals, f: sympy.Expr, low: Any, root: Any) -> bool:
    """Return whether f is proved to be finite and not 0 from an angle up to a singular point.

    At the point, fractional powers of functions that vanish there are 0.
    """
    powers = (part for part in f.atoms(sympy.Pow) if part.base.has(alpha) and part.exp.is_Rational and part.exp > 0)
    none = {part: sympy.S.Zero for part in powers if not part.exp.is_Integer and _zero(at, part.base, root)}
    sides = (f, at.interval(low, low)), (f.xreplace(none), at.interval(root - BESIDE, root + BESIDE))
    try:
        (first, _), (last, most) = (at.bounds(at.enclosure(e, where)) for e, where in sides)
    except Undecided:
        return False
    f, least = (f, last) if first > 0 else (-f, -most)
    *_, (_, end) = [(low, low), *cells(at, f, low, root - 2 * BESIDE, BESIDE)]
    return bool(least > 0 and end == root - 2 * BESIDE)


def with_quotients(expression: sympy.Expr) -> sympy.Expr:
    """Return an expression as one quotient, up to its sign, with sines over cosines in place of tangents."""
    quotient = expression.replace(sympy.tan, lambda u: sympy.sin(u) / sympy.cos(u))
    above, below = sympy.fraction(sympy.together(quotient))
    return sympy.powdenest(sympy.expand_power_base(above / below, force=True), force=True)


def _named(root: Any) -> sympy.Expr:
    """Return the multiple of π or root of a fraction that agrees with a number to 50 digits; else a decimal."""
    for value, make in ((root / mpmath.pi, lambda q: q * sympy.pi), (root**2, sympy.sqrt)):
        near = Fraction(int(mpmath.nint(value * 5040)), 5040)
        if abs(value - mpmath.mpf(near.numerator) / near.denominator) < mpmath.mpf(10) ** -50:
            return make(sympy.Rational(near.numerator, near.denominator))
    return sympy.Float(mpmath.nstr(root, PHI_DIGITS), PHI_DIGITS)


def _flat(slope: sympy.Expr, marched: list[tuple[Any, Any]]) -> tuple[Any, ...]:
    """Return the angles of the least minima of φ′ below the edge, each with two angles beside it.

    There ``φ″/φ′`` is largest, so that Newton's method is in most danger. Kernels are tested at these angles; nothing
    is concluded from them.
    """
    angles = [low for low, high in marched if high - low > FLAT_WIDTH]
    slopes = [real_value(slope, angle, slope) for angle in angles]
    found = list[tuple[Any, Any, Any]]()
    for k in range(1, len(slopes) - 1):
        if slopes[k - 1] > slopes[k] <= slopes[k + 1] and 2 * slopes[k] < slopes[0]:
            found += _minimum(slope, *angles[k - 1 : k + 2])
    return tuple(angle + side * beside for _, angle, beside in sorted(found)[:FLAT_MAX] for side in (0, 1, -1))


def _minimum(slope: sympy.Expr, low: Any, angle: Any, high: Any) -> list[tuple[Any, Any, Any]]:
    """Return the least φ′ between two angles, its angle, and the distance at which φ′ doubles; none on a plateau."""
    least, rise, bend = (slope.diff(alpha, count) for count in range(3))
    for _ in range(8):
        curved = real_value(bend, angle, slope)
        angle = angle - real_value(rise, angle, slope) / curved if curved > 0 else high
        if not low < angle < high:
            return []
    size = real_value(least, angle, slope)
    return [(size, angle, mpmath.sqrt(2 * size / curved))]


def closed_inverse(phi: sympy.Expr) -> sympy.Expr | None:
    """Return φ⁻¹ with `elementary.alpha` in place of the length; None if no form is found.

    The form holds from 0 to the edge of φ, where the root and every function of a composition increase.
    """
    return _unwound(phi) or _root(phi)


def _unwound(phi: sympy.Expr) -> sympy.Expr | None:
    """Return the inverse of a composition of functions and constant factors."""
    rest, found = phi, alpha
    while rest != alpha:
        factor, rest = rest.as_independent(alpha, as_Add=False)
        found = found / factor
        if rest != alpha:
            if rest.func != sympy.sin and not hasattr(rest, "inverse"):  # SymPy's sine has no inverse
                return None
            inverse = sympy.asin if rest.func == sympy.sin else rest.inverse()
            rest, found = rest.args[0], inverse(found)
    return found


def _root(phi: sympy.Expr) -> sympy.Expr | None:
    """Return the inverse if φ² is a quotient of quadratics in α², else None."""
    y = sympy.Dummy("y", positive=True)
    above, below = sympy.fraction(sympy.together((phi**2).subs(alpha, sympy.sqrt(y))))
    if not (above.is_polynomial(y) and below.is_polynomial(y)):
        return None
    N, D = sympy.Poly(above, y), sympy.Poly(below, y)
    if max(N.degree(), D.degree()) > 2:
        return None
    (_, n1, n2), (d0, d1, d2) = ([of.coeff_monomial(y**k) for k in range(3)] for of in (N, D))
    a, b = n2 / alpha**2 - d2, n1 / alpha**2 - d1
    inside = sympy.expand(b**2 + 4 * a * d0)  # its constant term is exactly 0 at a pole of φ
    return sympy.sqrt(2 * d0 / (b + sympy.sqrt(inside)))
