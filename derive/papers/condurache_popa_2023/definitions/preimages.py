r"""Number of vectors that the map of order n takes to q or −q, for every n, without the formula (49).

For a unit quaternion q = c + s u, s ≠ 0 (for dual ones, the real part of s), a preimage of ±q is a multiple v = t u,
for the vector part of :math:`(1 + v)^n` is one of v. With

.. math:: H_n(t) = (1 + it)^n (c - is) = G_n + i F_n

t u is a preimage of q or −q where :math:`F_n(t) = 0`: then :math:`H_n` is real, and of q where it is positive. So the
preimages are the real roots of a polynomial, and there are as many as its degree if all are real and simple:

* real: :math:`F_n(t) = 0` says :math:`(1 + it)^n (c - is) = (1 - it)^n (c + is)`, so that |1 + it| = |1 − it|, and the
  difference of their squares is −4 Im t;
* simple: :math:`F_n' = n G_{n-1}` and :math:`F_n = F_{n-1} + t G_{n-1}`, so at a double root
  :math:`F_{n-1}^2 + G_{n-1}^2 = (1 + t^2)^{n-1} (c^2 + s^2)` is 0, which it is for no real t. A simple root of the real
  parts is that of one dual number, by Taylor's formula;
* the degree is n unless the coefficient of :math:`t^n`, one of ±s and ±c in turn, is 0: where Re q² = (−1)ⁿ, and then
  it is n − 1;
* signs: :math:`G_n F_n' - F_n G_n' = n (F_{n-1}^2 + G_{n-1}^2) > 0`. At successive simple roots :math:`F_n'` changes
  its sign, hence so does :math:`G_n`: of two roots one gives q and one −q.

For Re s = 0, the translations, v may be taken along the displacement, and :math:`F_n` has more roots than 0 from order
3 on. At order 1 the one root has the sign of c; at order 2 the two give q and −q where s ≠ 0.

What is computed are the polynomial identities that these steps, and induction on n, rest on.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache

from derive.algebra.element import Element
from derive.algebra.exact import RationalFunctions

from ...language.evaluation import Env

Step = Callable[..., tuple[Element, Element]]
"""Function from ``F``, ``G`` and t to the next of both."""


def next_parts(F: Element, G: Element, t: Element) -> tuple[Element, Element]:
    """Return imaginary and real part of ``(G + iF)(1 + it)``."""
    return F + t * G, G - t * F


def counted_by_roots(env: Env) -> bool:
    """Return whether every identity holds that the number of preimages rests on."""
    return all(_identities(next_parts).values())


@cache
def _identities(step: Step) -> Mapping[str, bool]:
    """Return the truth of the identities by name, with symbols for n and for the polynomials of order n − 1."""
    field = RationalFunctions(["n", "t", "F", "G", "c", "s", "x", "y"])
    n, t, F, G, c, s, x, y = (field.symbol(name) for name in ("n", "t", "F", "G", "c", "s", "x", "y"))
    F_1, G_1 = step(F, G, t)  # of order n, from those of order n − 1
    slope_F, slope_G = n * G, -n * F  # what is assumed of order n
    size = F * F + G * G
    return {
        "roots are real": (1 - y) ** 2 + x * x - ((1 + y) ** 2 + x * x) == -4 * y,
        "size": (1 + t * t) * size == F_1 * F_1 + G_1 * G_1,
        "slope of F": slope_F + G_1 + t * slope_G == (n + 1) * G_1,
        "slope of G": slope_G - F_1 - t * slope_F == -(n + 1) * F_1,
        "signs alternate": G_1 * slope_F - F_1 * slope_G == n * size,
        "degree": _degrees_rise(c, s, t, step),
        "degree of even order": c * c - s * s - (c * c + s * s) == -2 * s * s,
        "degree of odd order": c * c - s * s + (c * c + s * s) == 2 * c * c,
    }


def _degrees_rise(c: Element, s: Element, t: Element, step: Step) -> bool:
    """Return whether the coefficients of tⁿ repeat after four orders: in F ±s at even orders and ±c at odd ones."""
    a, b = -s, c
    for last in (s, c, s, c):
        if a not in (last, -last):
            return False
        (a, b), (a_0, b_0) = step(a, b, t), step(a, b, 0 * t)
        a, b = (a - a_0) / t, (b - b_0) / t
    return a == -s and b == c
