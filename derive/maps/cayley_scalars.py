r"""Scalars of the Cayley map of order n at ``x = v · v``, in closed form, with their slopes.

.. math::
    f = \frac{2 p q}{N} \quad g = \frac{2 q^2}{N} \quad h = \frac{2 c}{N} \quad
    f_i = \frac{p}{q} \quad h_i = \frac{d}{n q} \qquad N = p^2 + x q^2 = (1 + x)^n

Here c_n and d_n are the brackets of CP23 (88) and (89) divided by x. Elements x of Q(x) give formulas, numbers give
values, and traced numbers give programs.

A slope, marked y, is ``2 d/dx``: the factor of ``v · v°`` in the dual part, since ``x° = 2 v · v°``. Second slopes are
marked yy. The slope of N divided by N is ``e = 2n/(1 + x)``. No formula divides by x or uses |v|, so a pure translation
needs no special case.

Above `HORNER_LIMIT`, p, q, c and d come from a chain of doublings, divided by powers of 1 + x. Every order then
overflows no sooner than order 4. With ``D = (1 + x)^⌊n/2⌋``, the divisor of p, q and d is D. The divisor of c, p² and
x q² is D². The divisors cancel in the scalars.

N is computed as ``p² + x q²``, whose rounding error does not grow with n. ``(N/N)/N``, or ``2/N + (N - N)``,
replaces a quotient by N where N may overflow. On overflow these are NaN, while 2/N would be finite and wrong.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, reduce
from operator import add, sub
from typing import Any

from ..algebra import Coefficient, Isotropic
from ..algebra.arithmetic import PLAIN, Arithmetic, Pair, require_order
from . import polynomials
from .order_charts import has_ladder
from .polynomials import Triple, horner
from .scalars import scalar

HORNER_LIMIT = 8
"""Largest order evaluated by Horner's rule: above it, large alternating coefficients cancel and digits are lost."""

CHAIN_POWER = 4
"""Largest power of 1/(1 + x) in second slopes: ``(1 + x)^4`` must not overflow."""


@dataclass(frozen=True, slots=True)
class Jet:
    """Taylor coefficients in x: the value, the first derivative, half the second and a sixth of the third."""

    value: Coefficient
    first: Coefficient = 0
    half_second: Coefficient = 0
    sixth_third: Coefficient = 0

    def __add__(self, other: Jet) -> Jet:
        return Jet(*map(add, self.terms, other.terms))

    def __sub__(self, other: Jet) -> Jet:
        return Jet(*map(sub, self.terms, other.terms))

    def __mul__(self, other: Jet) -> Jet:
        a, b = self.terms, other.terms
        return Jet(*(reduce(add, (a[i] * b[k - i] for i in range(k + 1))) for k in range(len(a))))

    @property
    def terms(self) -> tuple[Coefficient, Coefficient, Coefficient, Coefficient]:
        return self.value, self.first, self.half_second, self.sixth_third

    def square(self) -> Jet:
        bend = 2 * (self.value * self.half_second) + self.first * self.first
        twist = 2 * (self.value * self.sixth_third + self.first * self.half_second)
        return Jet(self.value * self.value, 2 * (self.value * self.first), bend, twist)

    def named(self, m: Arithmetic, letter: str) -> Jet:
        """Return the jet with its coefficients named p, p_x, p_xx, p_xxx, for the letter p."""
        suffixes = "", "_x", "_xx", "_xxx"
        return Jet(*(m.name(letter + suffix, term) for suffix, term in zip(suffixes, self.terms, strict=True)))


def chain(order: int, x: Coefficient, shrinking: Coefficient, m: Arithmetic) -> dict[int, tuple[Jet, Jet]]:
    """Return the jets of (p_k, q_k), divided by ``(1 + x)^⌊k/2⌋``, for each k on a chain of doublings up to ``order``.

    The steps ``p_2k = p² − x q²``, ``q_2k = 2 p q`` and ``p_(k+1) = p − x q``, ``q_(k+1) = p + q`` avoid alternating
    sums. Derivatives of p_k and q_k are divided by the same power. A doubling of an odd k divides once more by 1 + x.
    """
    argument, two, shrink = Jet(x, 1), Jet(2), Jet(shrinking)
    k, p, q = 1, Jet(1), Jet(1)
    pairs = {1: (p, q)}
    for bit in bin(order)[3:]:
        pp, qq = p.square().named(m, f"p{k}p{k}"), q.square().named(m, f"q{k}q{k}")
        xqq = (argument * qq).named(m, f"xq{k}q{k}")
        odd = k % 2
        k *= 2
        p, q = pp - xqq, two * (p * q)
        if odd:
            p, q = p * shrink, q * shrink
        pairs[k] = p, q = p.named(m, f"p{k}"), q.named(m, f"q{k}")
        if bit == "1":
            k += 1
            p, q = p - argument * q, p + q
            pairs[k] = p, q = p.named(m, f"p{k}"), q.named(m, f"q{k}")
    return pairs


def _polynomial(letter: str, derivative: int, by_chain: Callable[[Any, Jet, Jet], Coefficient]) -> scalar:
    """Return the scalar for a derivative of p, q, c or d, by Horner's rule or from the jets of the chain."""
    return scalar(lambda at: at._at_x(letter, derivative) if at._expanded else by_chain(at, *at._jets))


class CayleyScalars:
    """Scalars at x of the Cayley map of one order, each computed and named on first use."""

    def __init__(self, order: int, x: Coefficient, m: Arithmetic) -> None:
        self.order = order
        self.x = x
        self.m = m

    _expanded = property(lambda at: at.order <= HORNER_LIMIT)
    _chain = cached_property(lambda at: chain(at.order, at.x, at._shrinking, at.m))
    _jets = cached_property(lambda at: at._chain[at.order])
    _beyond_one = scalar(lambda at: 1 + at.x, "x1")

    @cached_property
    def _shrinking(self) -> Coefficient:
        """Factor ``1/(1 + x)``, NaN where ``(1 + x)^CHAIN_POWER`` overflows: second slopes would be wrong there."""
        square = self.m.name("x2", self._beyond_one * self._beyond_one)
        fourth = self.m.name("x4", square * square)
        return self.m.name("u", self.m.div(fourth, fourth) / self._beyond_one)

    def _at_x(self, letter: str, derivative: int) -> Coefficient:
        pair = polynomials.ring_pair if letter in "pq" else polynomials.ring_brackets
        polynomial = pair(self.order)[letter in "qd"]
        for _ in range(derivative):
            polynomial = polynomial.diff(polynomials.RING_X)
        return horner(polynomial, self.x)

    p = _polynomial("p", 0, lambda at, p, q: p.value)  # CP23 (51)
    q = _polynomial("q", 0, lambda at, p, q: q.value)  # CP23 (52)
    dp = _polynomial("p", 1, lambda at, p, q: p.first)
    dq = _polynomial("q", 1, lambda at, p, q: q.first)
    ddq = _polynomial("q", 2, lambda at, p, q: 2 * q.half_second)
    # [n (1+x)ⁿ⁻¹ − p q]/x = 2 (p q′ − q p′)
    c = _polynomial("c", 0, lambda at, p, q: 2 * (at.p * at.dq - at.q * at.dp))
    dc = _polynomial("c", 1, lambda at, p, q: 4 * (at.p * q.half_second - at.q * p.half_second))

    _cubic = cached_property(lambda at: 3 * (at.p * at._jets[1].sixth_third - at.q * at._jets[0].sixth_third))
    ddc = _polynomial("c", 2, lambda at, p, q: 4 * (at._cubic + p.first * q.half_second - q.first * p.half_second))
    # [(1+x) q − n p]/x = q − 2 q′ − 2 p′
    d = _polynomial("d", 0, lambda at, p, q: at.q - 2 * (at.dq + at.dp))
    dd = _polynomial("d", 1, lambda at, p, q: at.dq - 4 * (q.half_second + p.half_second))
    ddd = _polynomial("d", 2, lambda at, p, q: at.ddq - 12 * (q.sixth_third + p.sixth_third))

    # --- norm -------------------------------------------------------------------------------------------------

    _qq = scalar(lambda at: at.q * at.q, "qq")
    norm = scalar(lambda at: at.p * at.p + at.x * at._qq, "N")  # N = p² + x q² = (1 + x)ⁿ

    @cached_property
    def root(self) -> Coefficient:
        """Root ``(1 + x)^(n/2)`` of the norm; for even n it is the norm of order n/2, without a square root."""
        if self.order % 2:
            return self.m.name("root", self.m.sqrt(self.norm))
        p, q = self._half
        root = p * p + self.x * (q * q)
        return self.m.name("root", root if self._expanded or self.order % 4 == 0 else root * self._shrinking)

    @cached_property
    def _half(self) -> Pair:
        half = self.order // 2
        if self._expanded:
            p, q = (horner(polynomial, self.x) for polynomial in polynomials.ring_pair(half))
            return self.m.name("ph", p), self.m.name("qh", q)
        first, second = self._chain[half]
        return first.value, second.value

    _twice_inverse_norm = scalar(lambda at: at.m.div(2, at.norm) + (at.norm - at.norm if at._expanded else 0), "r")
    _growth = scalar(lambda at: 2 * at.order / at._beyond_one, "e")  # 2 N′/N = 2n/(1 + x)

    # --- q̂ = s + w v, CP23 (50), (55) -------------------------------------------------------------------------

    _inverse_root = scalar(lambda at: at.m.div(at.root / at.root if at._expanded else 1, at.root), "r")
    s = scalar(lambda at: at.p * at._inverse_root)
    w = scalar(lambda at: at.q * at._inverse_root)
    sy = scalar(lambda at: at.w * at.m.name("minus_e", -at.order / (1 + at.x)))  # 2 s′ = −n w/(1 + x)
    wy = scalar(lambda at: 2 * at.dq * at._inverse_root + at.sy)  # 2 w′ = 2 q′/√N − n w/(1 + x)

    @property
    def ray(self) -> Triple:
        """Triple (p, q, size), where ``p + q v = size · q̂``; only half-angle formulas use the size."""
        return self.p, self.q, self.root if self.order > 1 and has_ladder(self.order) else 1

    # --- R = I + f skew(v) + g skew(v)², T = f I + g skew(v) + h v⊗v, CP23 (57), (88) --------------------------

    f = scalar(lambda at: at.p * at.q * at._twice_inverse_norm)
    g = scalar(lambda at: at._qq * at._twice_inverse_norm)
    h = scalar(lambda at: at.c * at._twice_inverse_norm)

    rate = property(lambda at: at._growth)  # 2n/(1 + x), the factor of T along the axis
    ratey = scalar(lambda at: -at._falling, "ey")  # −4n/(1 + x)²
    _growing_g = scalar(lambda at: at._growth * at.g, "eg")
    _falling = scalar(lambda at: 2 * at._growth / at._beyond_one, "ee")  # −2 e′ = e²/n
    fy = scalar(lambda at: at.h - at._growing_g)  # 2 f′ = h − 2n g/(1 + x)
    gy = scalar(lambda at: at._rising - at._growing_g)  # 2 g′ = 8 q q′/N − 2n g/(1 + x)
    _rising = scalar(lambda at: 4 * at.dq * (at.q * at._twice_inverse_norm), "qr")  # 8 q q′/N
    hy = scalar(lambda at: at._bending - at._growth * at.h)  # 2 h′ = 4 c′/N − 2n h/(1 + x)
    _bending = scalar(lambda at: 2 * at.dc * at._twice_inverse_norm, "cr")  # 4 c′/N
    fyy = scalar(lambda at: at.hy - at._growing_gy + at._falling_g)  # 2 fy′ = hy − e gy + (e²/n) g
    _growing_gy = scalar(lambda at: at._growth * at.gy, "egy")
    _falling_g = scalar(lambda at: at._falling * at.g, "eeg")

    @cached_property
    def gyy(self) -> Coefficient:
        """Second slope of g, ``2 gy′ = 16 (q q″ + q′²)/N − e (gy + 8 q q′/N) + (e²/n) g``."""
        bend = 8 * ((self.q * self.ddq + self.dq * self.dq) * self._twice_inverse_norm)
        return self.m.name("gyy", bend - (self._growing_gy + self._growth * self._rising) + self._falling_g)

    # 2 hy′ = 8 c″/N − e (hy + 4 c′/N) + (e²/n) h
    _bend = property(lambda at: 4 * (at.ddc * at._twice_inverse_norm))
    hyy = scalar(lambda at: at._bend - at._growth * (at.hy + at._bending) + at._falling * at.h)

    # --- T⁻¹ = (fi I − skew(v) + hi v⊗v)/2, CP23 (89) ----------------------------------------------------------

    ai = scalar(lambda at: at.m.div(at._beyond_one, at.order))  # 2 φ′ = (1 + x)/n
    _inverse_q = scalar(lambda at: at.m.div(1, at.q), "iq")
    _bracket = scalar(lambda at: at.d * at._inverse_q, "diq")
    _log_slope = scalar(lambda at: at.dq * at._inverse_q, "dqiq")  # q′/q
    fi = scalar(lambda at: at.p * at._inverse_q)
    hi = scalar(lambda at: at.m.div(at._bracket, at.order))
    fiy = scalar(lambda at: -(at.c * (at._inverse_q * at._inverse_q)))  # 2 fi′ = −c/q²

    # 2 hi′ = 2 (d′ − d q′/q)/(n q)
    hiy = scalar(lambda at: at.m.div((2 * at.dd - 2 * at.dq * at._bracket) * at._inverse_q, at.order))
    # 2 fiy′ = (4 c q′/q − 2 c′)/q²
    fiyy = scalar(lambda at: (4 * at.c * at._log_slope - 2 * at.dc) * at._inverse_q * at._inverse_q)

    @cached_property
    def hiyy(self) -> Coefficient:
        """Second slope of h_i, ``2 hiy′ = 4 (d″ − d q″/q)/(n q) − 4 (q′/q) hiy``."""
        bend = self.m.div(4 * ((self.ddd - self.ddq * self._bracket) * self._inverse_q), self.order)
        return self.m.name("hiyy", bend - 4 * self._log_slope * self.hiy)


def scalars(n: int, at: Coefficient) -> CayleyScalars:
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
