r"""Cayley map of order n: its formulas in ``x = v · v``, and its chart.

The map takes v to the unit dual quaternion ``q̂ = (1 + v)^(n/2) (1 − v)^(−n/2)`` (CP23 (46)), or to its 6x6 adjoint
matrix. The Cayley map of 4x4 homogeneous matrices has the same rotation but another translation.

Conventions: real part first; ``v = tan(α/2n) u``; quaternions scalar first; ``ω = dcay v̇`` is the space twist.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, ClassVar

import sympy

from ..algebra import Coefficient, Isotropic, Quaternion
from ..algebra.arithmetic import Arithmetic, Pair, require_order
from ..algebra.latex import bracketed, latex
from . import cayley_scalars, polynomials
from .cayley_scalars import CHAIN_POWER, HORNER_LIMIT, CayleyScalars
from .chart import Followed
from .chart_formulas import Map
from .elementary import alpha
from .formula import IsotropicMap, QuaternionMap
from .order_charts import BranchesOfOrder, Derivatives, cayley_gain, near_pole, side_of_step
from .polynomials import FIELD, Triple, rational, x
from .real_constants import NOISE, near_turn

EQUATIONS = {"quaternion": (50, 55), "tensor": (57,), "tangent": (88,), "tangent_inv": (89,)}
"""Numbers of the general equations of each map in CP23."""

_PRINTED = {1: 95, 2: 102, 3: 109, 4: 116, 5: 122}
"""CP23 number of the first of four consecutive equations (q̂, R, dcay, dcay⁻¹), by order."""


_IDENTITIES = {
    "quaternion": ("|q|^2 = 1",),
    "tensor": ("R R^T = I", "det R = 1"),
    "tangent": ("dcay v = 2n/(1+x) v", "dcay^T = R^T dcay", "det dcay = 8n q^2/(1+x)^(n+1)"),
    "tangent_inv": ("dcay dcay^-1 = I",),
}
_SINGULAR = {"quaternion": "none", "tensor": "none", "tangent": "loses rank at {}", "tangent_inv": "pole at {}"}
_SYMBOLS = {
    "quaternion": r"\hat{{q}}",
    "tensor": "R",
    "tangent": r"\mathrm{{dcay}}_{{{}}}",
    "tangent_inv": r"\mathrm{{dcay}}_{{{}}}^{{-1}}",
}


@dataclass(frozen=True)
class Cayley(BranchesOfOrder):
    """Cayley map of order n, ``v = tan(α/2n) u``.

    Parameters
    ----------
    order : int
        Integer n ≥ 1: TypeError for other types, ValueError below 1. In ``derive.Cayley``, also a symbol or expression
        of SymPy: p and q are then sums, the maps are formulas in them, and ``subs(n, 7)`` is the map of one order.
    name, selection : optional
        Name of the module and command-line option, for a user's φ equal to tan(α/2n).

    Examples
    --------
    >>> import derive
    >>> m = derive.Cayley(3)
    >>> m.p, m.q
    (1 - 3*x, 3 - x)
    >>> m.poles, m.singular_angles
    ((sqrt(3),), (2*pi, 3*pi))
    >>> m.tangent_inv.coefficients[1]
    -1/2
    """

    order: int
    vector: ClassVar[str] = "Rodrigues dual vector"
    operator: ClassVar[str] = "dcay"
    name: str = field(default="", repr=False)
    selection: tuple[str, str] = field(default=("", ""), repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "order", require_order(self.order))
        if not self.name:
            object.__setattr__(self, "name", f"cayley{self.order}")
            object.__setattr__(self, "selection", ("-n", str(self.order)))

    @property
    def n(self) -> int:
        """Order n."""
        return self.order

    @cached_property
    def p(self) -> sympy.Expr:
        """Polynomial p_n, CP23 (51)."""
        return polynomials.ring_pair(self.order)[0].as_expr()

    @cached_property
    def q(self) -> sympy.Expr:
        """Polynomial q_n, CP23 (52)."""
        return polynomials.ring_pair(self.order)[1].as_expr()

    @cached_property
    def c(self) -> sympy.Expr:
        """Bracket ``[n (1+x)ⁿ⁻¹ − p q]/x`` of dcay_n."""
        return polynomials.ring_brackets(self.order)[0].as_expr()

    @cached_property
    def d(self) -> sympy.Expr:
        """Bracket ``[(1+x) q − n p]/x`` of dcay_n⁻¹."""
        return polynomials.ring_brackets(self.order)[1].as_expr()

    @property
    def poles(self) -> tuple[sympy.Expr, ...]:
        """Lengths ``Re|v| = tan(kπ/n)`` at the poles of dcay_n⁻¹."""
        return polynomials.poles(self.order)

    @cached_property
    def quaternion(self) -> QuaternionMap:
        """Unit dual quaternion, CP23 (50), (55)."""
        root = (1 + x) ** (self.order * sympy.S.Half)
        return self._formula(QuaternionMap, "quaternion", self.p / root, self.q / root)

    @cached_property
    def tensor(self) -> IsotropicMap:
        """Orthogonal dual tensor, CP23 (57)."""
        return self._isotropic(cayley_scalars.tensor)

    @cached_property
    def tangent(self) -> IsotropicMap:
        """Tangent operator dcay_n, CP23 (88); it takes v̇ to the space twist."""
        return self._isotropic(cayley_scalars.tangent)

    @cached_property
    def tangent_inv(self) -> IsotropicMap:
        """Inverse tangent operator dcay_n⁻¹, CP23 (89); it takes the space twist to v̇."""
        return self._isotropic(cayley_scalars.tangent_inv)

    def _isotropic(self, closed_form: Callable[[int, Any], Isotropic]) -> IsotropicMap:
        coefficients = closed_form(self.order, FIELD.gens[0]).coefficients
        return self._formula(IsotropicMap, closed_form.__name__, *map(rational, coefficients))

    def _formula(self, kind: type[Map], name: str, *coefficients: sympy.Expr) -> Map:
        printed = [_PRINTED[self.order] + list(EQUATIONS).index(name)] if self.order in _PRINTED else []
        angles = self._lost
        lost = f"Re alpha = {angles}" if angles else "no finite v"
        poles = name == "tangent_inv" and angles
        return kind(
            name=name,
            order=self.order,
            coefficients=coefficients,
            equations=(*EQUATIONS[name], *printed),
            identities=_IDENTITIES[name],
            domain=f"every dual vector v with Re q_{self.order} != 0" if poles else "every dual vector v",
            singular=f"{_SINGULAR[name].format(lost)}; v is infinite at Re alpha = {self.edge}",
            symbol=_SYMBOLS[name].format(self.order),
            definition=_definitions(self.order)[name],
        )

    @property
    def _lost(self) -> str:
        """Angles below the edge where dcay_n loses rank, as text."""
        return ", ".join(map(str, self.singular_angles[:-1]))

    # --- chart (see `Chart`) ----------------------------------------------------------------------------------

    @property
    def title(self) -> str:  # type: ignore[override]
        """Headline, such as "Cayley map of order 3"."""
        return f"Cayley map of order {self.order}"

    @property
    def phi(self) -> sympy.Expr:
        return sympy.tan(alpha / (2 * self.order))

    @property
    def cayley(self) -> Cayley:
        return self

    def overflow(self, largest: float) -> tuple[str, float]:
        power = self.order if self.order <= HORNER_LIMIT else CHAIN_POWER
        return f"(1 + x)^{power} overflows", largest ** (0.5 / power)

    @property
    def letters(self) -> tuple[tuple[str, sympy.Expr], ...]:
        return ("p", self.p), ("q", self.q)

    def scalars(self, x: Coefficient, m: Arithmetic) -> CayleyScalars:
        return CayleyScalars(self.order, x, m)

    def coefficient(self, angle: Coefficient, m: Arithmetic) -> Pair:
        r = m.name("r", m.tan(m.div(angle, 2 * self.order)))
        return r, m.name("slope", m.div(1 + r * r, 2 * self.order))

    def coefficient_of(self, angle: Coefficient, sine: Coefficient, cosine: Coefficient, m: Arithmetic) -> Pair:
        next_to, rest, side = near_pole(self.order, angle, sine, cosine, m)
        t = m.name("t", m.tan(m.div(rest, 2 * self.order)))
        r = m.name("r", side * m.where(next_to, 1, t) / m.where(next_to, t, 1))
        return r, m.name("slope", m.div(1 + r * r, 2 * self.order))

    def gain(self, q: Quaternion, size: Coefficient, m: Arithmetic) -> Coefficient:
        return m.name("gain", cayley_gain(self.order, q, size, m))

    def followed(
        self, x: Coefficient, along: Coefficient, e: Quaternion, size: Coefficient, turn: Coefficient, m: Arithmetic
    ) -> Followed:
        if self.order > 2:
            return super().followed(x, along, e, size, turn, m)
        if self.order == 1:
            factor = m.name("factor", m.div(1, e.scalar))
        else:
            side, beyond, more, square = side_of_step(e, size, turn, m)
            factor = m.name("factor", m.where(beyond, side * more, side) / m.where(beyond, square, more))
        return Followed(factor, 0, m.name("fe", factor * e.scalar), 0)

    def back(self, x: Coefficient, fi: Coefficient, m: Arithmetic) -> Pair:
        at = self.scalars(x, m)
        return at.fi, at.hi

    def at_known(self, x: Coefficient, fi: Coefficient, known: Coefficient, m: Arithmetic) -> CayleyScalars:
        """Return scalars at x; next to a whole turn, where q_n has a zero, f_i gives 1/q_n."""
        at = self.scalars(x, m)
        if self.order > 2:
            near = near_turn(fi, at.ai, m)
            at._inverse_q = m.name("iq", m.where(near, fi, 1) / m.name("pq", m.where(near, at.p, at.q)))
        return at

    def _direction(self, at: CayleyScalars, y: Coefficient, r: Coefficient, m: Arithmetic) -> Pair:
        """Return the sign of p q and ``r |q|``; both are NaN where p, ``r |q|`` or (n = 1) x overflows.

        The sign is that of q where p = 0, up to rounding at half a turn, and of the translation along v where q = 0.
        """
        sine = m.name("rq", r * m.abs(at.q))
        either = at.x if self.order == 1 else m.name("either", sine + at.p)
        one = m.name("one", either - either + 1)
        if self.order == 1:
            return one, sine * one
        negative = m.name("qneg", m.less(at.q, 0))
        kept = m.name("kept", m.where(negative, 0, sine))
        turned = m.name("qp", m.where(m.less(m.beside(kept, m.div(at.p, NOISE)), kept), -at.q, at.q))
        backwards = m.both(m.equal(at.q, 0), m.less(y, 0))
        return m.name("sign", one * m.where(m.either(m.less(turned, 0), backwards), -1, 1)), sine * one

    def natural(self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic) -> Triple:
        """Return the principal angle ``2 atan2(r |q|, |p|)``, ``dα/dr = 2n/(1 + x)``, and the sign from `direction`."""
        at = self.scalars(x, m)
        sign, sine = self._direction(at, y, r, m)
        angle = m.name("angle", 2 * m.atan2(sine, m.abs(at.p)))
        return angle, m.name("slope", 2 * self.order / (1 + at.x)), sign

    def unfolded(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        return 2 * self.order * m.atan2(r, 1)

    def turned(self, r: Coefficient, turn: Sequence[Coefficient], m: Arithmetic) -> Derivatives:
        """Return ``r_k = (r cos + sin)/(cos − r sin)``, CP23 (49), and its first two derivatives by r."""
        cosine, sine = turn
        inverse = m.name("iden", m.div(1, cosine - r * sine))
        slope = m.name("slope", inverse * inverse)
        return m.name("rk", (r * cosine + sine) * inverse), slope, m.name("bend", 2 * (sine * inverse) * slope)

    def latex(self) -> str:
        """Return the polynomials and the four maps as LaTeX, in the notation of the paper."""
        return self._aligned((f"{letter}_{{{latex(self.order)}}}", latex(value)) for letter, value in self.letters)


def _definitions(n: int | sympy.Expr) -> dict[str, str]:
    p, q, norm, half = f"p_{{{latex(n)}}}", f"q_{{{latex(n)}}}", _power(n), sympy.Integer(1) * n / 2
    rotation = rf"\frac{{2 {p} {q}}}{{{norm}}}"
    return {
        "quaternion": rf"\frac{{{p} + {q} v}}{{{_power(half)}}}",
        "tensor": rf"I + {rotation} \tilde{{v}} + \frac{{2 {q}^2}}{{{norm}}} \tilde{{v}}^2",
        "tangent": rf"{rotation} I + \frac{{2 {q}^2}}{{{norm}}} \tilde{{v}} + "
        rf"\frac{{2 [{f'{bracketed(n)} {_power(n - 1)}'.rstrip()} - {p} {q}]}}{{x {norm}}} v \otimes v",
        "tangent_inv": rf"\frac{{{p}}}{{2 {q}}} I - \frac{{1}}{{2}} \tilde{{v}} + "
        rf"\frac{{(1 + x) {q} - {f'{bracketed(n)} ' if n != 1 else ''}{p}}}{{{bracketed(2 * n)} x {q}}} v \otimes v",
    }


def _power(exponent: int | sympy.Expr) -> str:
    if exponent == 0:
        return ""
    return "(1 + x)" if exponent == 1 else f"(1 + x)^{{{exponent}}}"
