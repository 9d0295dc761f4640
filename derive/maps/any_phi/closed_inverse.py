r"""Closed form of φ⁻¹, for φ a composition of invertible functions, or φ² a quotient of quadratics in α².

.. math:: \varphi^2 = \frac{\alpha^2 (n_1 + n_2 \alpha^2)}{d_0 + d_1 \alpha^2 + d_2 \alpha^4} \qquad
    \alpha = r \sqrt{\frac{2 d_0}{b + \sqrt{b^2 + 4 a d_0 r^2}}} \qquad
    a = n_2 - d_2 r^2 \quad b = n_1 - d_1 r^2

The formula gives the root that is 0 at r = 0, and loses no digits there.
"""

from __future__ import annotations

from typing import Any

import sympy

from ..families import alpha

PRINCIPAL = {sympy.sin: sympy.asin}
"""Inverse functions up to the first fold, in addition to the inverses of SymPy."""
DEGREE = 2


def closed_inverse(phi: sympy.Expr) -> sympy.Expr | None:
    """Return φ⁻¹ with `families.alpha` in place of the length; None if no form is found.

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
            inverse = _inverse(rest)
            if inverse is None:
                return None
            rest, found = rest.args[0], inverse(found)
    return found


def _inverse(of: sympy.Expr) -> Any:
    """Return the inverse of a function; None where SymPy has none."""
    if of.func in PRINCIPAL:
        return PRINCIPAL[of.func]
    return of.inverse() if hasattr(of, "inverse") else None


def _root(phi: sympy.Expr) -> sympy.Expr | None:
    """Return the inverse of an algebraic φ, from α² as the root of a quadratic."""
    y = sympy.Dummy("y", positive=True)
    above, below = sympy.fraction(sympy.together((phi**2).subs(alpha, sympy.sqrt(y))))
    if not (above.is_polynomial(y) and below.is_polynomial(y)):
        return None
    N, D = sympy.Poly(above, y), sympy.Poly(below, y)
    if max(N.degree(), D.degree()) > DEGREE:
        return None
    (_, n1, n2), (d0, d1, d2) = ([of.coeff_monomial(y**k) for k in range(DEGREE + 1)] for of in (N, D))
    a, b = n2 - d2 * alpha**2, n1 - d1 * alpha**2
    inside = sympy.factor(sympy.expand(b**2 + 4 * a * d0 * alpha**2))
    return alpha * sympy.sqrt(2 * d0 / (b + sympy.sqrt(inside)))
