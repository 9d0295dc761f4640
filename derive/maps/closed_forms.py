"""Cayley maps of order n in closed form, at ``x = v · v`` of any number type; `cayley_scalars` has the formulas.

Elements of Q(x) give formulas, other numbers give values, and `Dual` numbers give values at dual vectors.
Angles: ``v = tan(α/2n) u`` with α the dual angle and u the unit dual vector of the screw axis.
"""

from __future__ import annotations

from ..algebra import Coefficient, Isotropic
from ..algebra.arithmetic import PLAIN
from ..algebra.cayley_pairs import Pair, require_order
from .cayley_scalars import CayleyScalars


def scalars(n: int, at: Coefficient) -> CayleyScalars:
    """Return the scalars of order n at a number x."""
    return CayleyScalars(require_order(n), at, PLAIN)


def quaternion(n: int, at: Coefficient) -> Pair:
    """Return (s, w) of the unit dual quaternion ``s + w v``, CP23 (50), (55), defined for every v.

    For v on branch k and even n, the result is ``(−1)ᵏ`` times the principal q̂.
    """
    at_x = scalars(n, at)
    return at_x.s, at_x.w


def tensor(n: int, at: Coefficient) -> Isotropic:
    """Return the orthogonal dual tensor, CP23 (57), defined for every v; note ``ṽ² = v⊗v − x I``."""
    at_x = scalars(n, at)
    return Isotropic(1 - at * at_x.g, at_x.f, at_x.g, at)


def tangent(n: int, at: Coefficient) -> Isotropic:
    """Return the tangent operator dcay_n, CP23 (88): space twist ``ω = dcay_n v̇``.

    The operator is defined for every v. Its rank drops at ``q_n = 0``: at Re α = 2πk, 1 ≤ k ≤ ⌊(n−1)/2⌋.
    """
    at_x = scalars(n, at)
    return Isotropic(at_x.f, at_x.g, at_x.h, at)


def tangent_inv(n: int, at: Coefficient) -> Isotropic:
    """Return the inverse tangent operator dcay_n⁻¹, CP23 (89): ``v̇ = dcay_n⁻¹ ω`` from the space twist.

    The operator is defined where ``Re q_n ≠ 0``. The poles are Re α = 2πk, 1 ≤ k ≤ ⌊(n−1)/2⌋ (none for n = 1, 2).
    """
    at_x = scalars(n, at)
    one = 1 + 0 * at  # at n = 1 all values are int, and int / int would not have the type of `at`
    return Isotropic(one * at_x.fi / 2, -one / 2, one * at_x.hi / 2, at)
