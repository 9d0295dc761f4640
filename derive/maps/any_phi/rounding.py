r"""Digits that floats lose in φ and φ′, bounded by interval arithmetic.

Let u be the rounding error of one operation. A bound ``N(e) u`` of the error of an expression e follows from its parts.
Each function adds ``|f'(e)| N(e)``, each factor the other factors times its N, each operation the size of its result.
An angle α has the error ``α u`` of its own, and a length r that of r. The error of φ is harmless if it is not much
greater than ``(r + α φ′) u``, the effect of both.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import mpmath
import sympy

from ..elementary import alpha
from ..grammar import PhiError
from .edges import Edge
from .intervals import Intervals, Undecided, precise

LOST_MAX = 64
"""Largest error of φ, divided by the effect of rounding α and r."""
FLAT_BITS_MAX = 22
"""Largest number of bits that φ′ may lose where it is least."""
PARTS, HALVED_MAX = 64, 8


def require_digits(phi: sympy.Expr, edge: Edge, first: Any) -> None:
    """Raise `PhiError` if cancellation in φ or φ′ loses digits beyond a first angle."""
    slope = phi.diff(alpha)
    with precise() as at:
        end = mpmath.mpf(edge.angle.evalf(mpmath.mp.dps))
        last = end if edge.kind == "cut" else end - mpmath.ldexp(end, -10)
        pending = [(first + (last - first) * k / PARTS, (last - first) / PARTS, 0) for k in range(PARTS)]
        while pending:
            low, width, depth = pending.pop()
            if not _keeps_digits(at, phi, slope, low, low + width):
                if depth == HALVED_MAX:
                    near = f"terms of phi = {phi} cancel near alpha = {mpmath.nstr(low, 4)}"
                    raise PhiError(f"{near}: an angle would lose more than {LOST_MAX.bit_length() - 1} bits")
                pending += [(low, width / 2, depth + 1), (low + width / 2, width / 2, depth + 1)]
        for angle in edge.flat[:1]:
            there = at.interval(angle, angle)
            size = at.size(at.enclosure(slope, there))[0]
            if noise(at, slope, there) > 2**FLAT_BITS_MAX * size:
                least = f"phi' of phi = {phi} falls to {mpmath.nstr(size, 3)}"
                raise PhiError(f"{least} at alpha = {mpmath.nstr(angle, 6)}: 1/phi' would lose half of its digits")


def _keeps_digits(at: Intervals, phi: sympy.Expr, slope: sympy.Expr, low: Any, high: Any) -> bool:
    whole, start = at.interval(low, high), at.interval(low, low)
    try:
        size, steep = at.size(at.enclosure(phi, start))[0], at.size(at.enclosure(slope, whole))[0]
        return bool(noise(at, phi, whole) <= LOST_MAX * (size + low * steep))
    except Undecided:
        return False


def noise(at: Intervals, e: sympy.Expr, where: Any) -> Any:
    """Return a bound of the rounding error of an expression, in rounding errors of 1."""
    if e == alpha or e.is_Integer:
        return mpmath.mpf(0)
    size = at.size(at.enclosure(e, where))[1]
    if alpha not in e.free_symbols:
        return size
    parts = [part for part in e.args if not (e.is_Pow and part == e.exp)]
    errors = [noise(at, part, where) for part in parts]
    if e.is_Add:
        return mpmath.fsum(errors) + size
    if e.is_Mul:
        sizes = [at.size(at.enclosure(part, where))[1] for part in parts]
        return size + mpmath.fsum(error * mpmath.fprod(sizes[:k] + sizes[k + 1 :]) for k, error in enumerate(errors))
    return size + errors[0] * at.size(at.enclosure(_change(e), where))[1]


@lru_cache(maxsize=256)
def _change(e: sympy.Expr) -> sympy.Expr:
    u = sympy.Dummy("u")
    return e.func(u, *e.args[1:]).diff(u).subs(u, e.args[0])
