r"""φ⁻¹ in closed form: of functions of one another, each with an inverse; of φ² a quotient of quadratics in α².

.. math:: \varphi^2 = \frac{\alpha^2 (n_1 + n_2 \alpha^2)}{d_0 + d_1 \alpha^2 + d_2 \alpha^4} \qquad
    \alpha = r \sqrt{\frac{2 d_0}{b + \sqrt{b^2 + 4 a d_0 r^2}}} \qquad
    a = n_2 - d_2 r^2 \quad b = n_1 - d_1 r^2

the root that is 0 at r = 0, as it loses no digits there.
"""

from __future__ import annotations

from typing import Any

import sympy

from ..families import alpha

PRINCIPAL = {sympy.sin: sympy.asin}
"""Inverses up to the first fold, which SymPy does not call so."""
DEGREE = 2


def closed_inverse(phi: sympy.Expr) -> sympy.Expr | None:
    """Return φ⁻¹ as an expression in `families.alpha`, which there is a length; None where none is found.

    It is that of the lengths from 0 to the edge of φ: no layer of what increases turns before, and no root.
    """
    return _unwound(phi) or _root(phi)


def _unwound(phi: sympy.Expr) -> sympy.Expr | None:
    """Of a function of a function, with numbers as factors."""
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
    """The function that undoes one; None where SymPy names none."""
    if of.func in PRINCIPAL:
        return PRINCIPAL[of.func]
    return of.inverse() if hasattr(of, "inverse") else None


def _root(phi: sympy.Expr) -> sympy.Expr | None:
    """Of what is algebraic, by α² as the root of a quadratic."""
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
