r"""Number of preimages of q and −q under the Cayley map of order n, for every n, without formula (49).

Let q = c + s u be a unit quaternion with s ≠ 0 (Re s ≠ 0 if q is dual). Each preimage of ±q is a multiple v = t u,
since the vector part of :math:`(1 + v)^n` is a multiple of v. Define

.. math:: H_n(t) = (1 + it)^n (c - is) = G_n + i F_n

The vector t u is a preimage of q or −q if :math:`F_n(t) = 0`. Then :math:`H_n` is real, positive for q and negative
for −q. The preimages are thus the real roots of :math:`F_n`. All roots are real and simple, so the degree counts them:

* real: :math:`F_n(t) = 0` means :math:`(1 + it)^n (c - is) = (1 - it)^n (c + is)`, so |1 + it| = |1 − it|. The
  difference of the squares is −4 Im t, so Im t = 0;
* simple: :math:`F_n' = n G_{n-1}` and :math:`F_n = F_{n-1} + t G_{n-1}`. A double root would be a root of
  :math:`F_{n-1}^2 + G_{n-1}^2 = (1 + t^2)^{n-1} (c^2 + s^2)`, which has no real root. A simple root of the real parts
  extends to exactly one dual root, by Taylor's formula;
* degree: the coefficient of :math:`t^n` is ±s for even n and ±c for odd n. The coefficient is 0 if and only if
  Re q² = (−1)ⁿ; then the degree is n − 1, otherwise n;
* signs: :math:`G_n F_n' - F_n G_n' = n (F_{n-1}^2 + G_{n-1}^2) > 0`. Between successive simple roots
  :math:`F_n'` changes its sign, and so does :math:`G_n`: one root gives q, the next −q.

Translations have Re s = 0: v may be taken along the displacement, and :math:`F_n` has nonzero roots from order 3 on.
At order 1 the root gives q if c > 0, else −q. At order 2 the two roots give both, if s ≠ 0.

The module checks the polynomial identities on which these steps and the induction on n depend.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache

from ....algebra.element import Element
from ....algebra.exact import RationalFunctions
from ....claims.language.environment import Env

Step = Callable[..., tuple[Element, Element]]
"""Function from ``F``, ``G`` and t to both polynomials of the next order."""


def next_parts(F: Element, G: Element, t: Element) -> tuple[Element, Element]:
    """Return the imaginary and the real part of ``(G + iF)(1 + it)``."""
    return F + t * G, G - t * F


def counted_by_roots(env: Env) -> bool:
    """Return whether all identities behind the number of preimages hold."""
    return all(_identities(next_parts).values())


@cache
def _identities(step: Step) -> Mapping[str, bool]:
    """Return the truth of each identity by name; n and the polynomials of order n − 1 are symbols."""
    field = RationalFunctions(["n", "t", "F", "G", "c", "s", "x", "y"])
    n, t, F, G, c, s, x, y = (field.symbol(name) for name in ("n", "t", "F", "G", "c", "s", "x", "y"))
    F_1, G_1 = step(F, G, t)  # polynomials of order n, from order n − 1
    slope_F, slope_G = n * G, -n * F  # induction hypothesis at order n
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
    """Return whether the coefficients of tⁿ repeat after four orders; F has ±s at even and ±c at odd orders."""
    a, b = -s, c
    for last in (s, c, s, c):
        if a not in (last, -last):
            return False
        (a, b), (a_0, b_0) = step(a, b, t), step(a, b, 0 * t)
        a, b = (a - a_0) / t, (b - b_0) / t
    return a == -s and b == c
