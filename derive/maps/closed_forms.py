r"""The Cayley maps of order n in closed form, at ``x = v · v`` of any number type.

One source serves all uses: elements of Q(x) give the formulas, ``Fraction`` and mpmath numbers give values, `Dual`
numbers give dual vectors' values, traced values give programs. The normaliser is written ``p_n² + x q_n²``, which is
``(1 + x)ⁿ`` with a rounding error that does not grow with n. Only x is needed, never |v|: a pure translation is no
special case.

Angles: ``v = tan(α/2n) u`` with α the dual angle and u the unit dual vector of the screw axis.
"""

from __future__ import annotations

from ..algebra import Coefficient, Isotropic, Quaternion, Vector
from ..algebra.functions import sqrt
from .polynomials import Pair, brackets, pair_by_squaring, require_order


def norm(n: int, at: Coefficient) -> Coefficient:
    """Return ``p_n² + x q_n² = (1 + x)ⁿ``."""
    p, q = pair_by_squaring(n, at)
    return p * p + at * (q * q)


def norm_root(n: int, at: Coefficient) -> Coefficient:
    """Return ``(1 + x)^(n/2)``, positive root: ``p² + x q²`` of order n/2 for even n, a square root for odd n."""
    return sqrt(norm(n, at)) if require_order(n) % 2 else norm(n // 2, at)


def quaternion(n: int, at: Coefficient) -> Pair:
    r"""Return (s, t) of the unit dual quaternion ``s + t v``, CP23 (50), (55).

    .. math:: \hat q = \frac{p_n + q_n v}{(1+x)^{n/2}}

    Defined for every v. With v on branch k and even n this is ``(−1)ᵏ q̂`` of the principal branch.
    """
    p, q = pair_by_squaring(n, at)
    root = norm_root(n, at)
    return p / root, q / root


def tensor(n: int, at: Coefficient) -> Isotropic:
    r"""Return the orthogonal dual tensor, CP23 (57).

    .. math:: R = I + \frac{2 p_n q_n}{(1+x)^n}\,\tilde v + \frac{2 q_n^2}{(1+x)^n}\,\tilde v^2

    Defined for every v. ``ṽ² = v⊗v − x I`` turns the coefficient of I into ``(p_n² − x q_n²)/(1+x)ⁿ``.
    """
    p, q = pair_by_squaring(n, at)
    n2 = p * p + at * (q * q)
    return Isotropic((p * p - at * (q * q)) / n2, 2 * (p * q) / n2, 2 * (q * q) / n2, at)


def tangent(n: int, at: Coefficient) -> Isotropic:
    r"""Return the tangent operator dcay_n, CP23 (88): space twist ``ω = dcay_n v̇``.

    .. math::
        \mathrm{dcay}_n = \frac{2 p_n q_n}{(1+x)^n}\,I + \frac{2 q_n^2}{(1+x)^n}\,\tilde v
            + \frac{2 c_n}{(1+x)^n}\,v \otimes v, \qquad x\,c_n = n (1+x)^{n-1} - p_n q_n

    Defined for every v; loses rank at ``q_n = 0``, that is Re α = 2πk, 1 ≤ k ≤ ⌊(n−1)/2⌋.
    """
    p, q = pair_by_squaring(n, at)
    c, _ = brackets(n, at)
    n2 = p * p + at * (q * q)
    return Isotropic(2 * (p * q) / n2, 2 * (q * q) / n2, 2 * c / n2, at)


def tangent_inv(n: int, at: Coefficient) -> Isotropic:
    r"""Return the inverse tangent operator dcay_n⁻¹, CP23 (89): ``v̇ = dcay_n⁻¹ ω`` from the space twist.

    .. math::
        \mathrm{dcay}_n^{-1} = \frac{p_n}{2 q_n}\,I - \frac12\,\tilde v + \frac{d_n}{2 n q_n}\,v \otimes v,
            \qquad x\,d_n = (1+x)\,q_n - n\,p_n

    Defined where ``Re q_n ≠ 0``; the poles are Re α = 2πk, 1 ≤ k ≤ ⌊(n−1)/2⌋ (none for n = 1, 2).
    """
    p, q = pair_by_squaring(n, at)
    _, d = brackets(n, at)
    one = 1 + 0 * at  # at n = 1 everything is an int, and int / int would leave the number type of `at`
    return Isotropic(one * p / (2 * q), -one / 2, one * d / (2 * n * q), at)


def quaternion_from_vector(n: int, v: Vector) -> Quaternion:
    """Return the unit (dual) quaternion of the vector `v`, CP23 (50)."""
    s, t = quaternion(n, v.dot(v))
    return Quaternion(s, v * t)
