r"""Cayley map of order n: its formulas in ``x = v · v``, and its chart.

The values are unit dual quaternions, ``q̂ = (1 + v)^(n/2) (1 − v)^(−n/2)`` (CP23 (46)), or equally 6x6 adjoint
matrices. The Cayley map of 4x4 homogeneous matrices has the same rotation but another translation.

Conventions: real part first; ``v = tan(α/2n) u``; quaternions scalar first; ``ω = dcay v̇`` is the space twist.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import sympy

from ..algebra import Coefficient, Quaternion
from ..algebra.arithmetic import Arithmetic
from . import branches, closed_forms, gains, near_pole, polynomials
from .cayley_scalars import CayleyScalars
from .evaluation import CHAIN_POWER, HORNER_LIMIT
from .families import alpha
from .formula import LATEX_ORDER, IsotropicMap, QuaternionMap
from .parameterized import Parameterized
from .polynomials import FIELD, rational, require_order, x

EQUATIONS = {"quaternion": (50, 55), "tensor": (57,), "tangent": (88,), "tangent_inv": (89,)}
"""Numbers of the general equations of each map in CP23."""

_PRINTED = {1: 95, 2: 102, 3: 109, 4: 116, 5: 122}
"""Number of the first of the four equations (q̂, R, dcay, dcay⁻¹) in CP23, by order."""


@dataclass(frozen=True)
class Cayley(branches.BranchesOfOrder, Parameterized):
    """Cayley map of order n, ``v = tan(α/2n) u``.

    Parameters
    ----------
    order : int
        Integer n ≥ 1: TypeError for other types, ValueError below 1.
    name, selection : optional
        Name of the module and command-line option, for a user's φ equal to tan(α/2n).

    Attributes
    ----------
    p, q, c, d : Expr
        The polynomials of order n in `derive.x` (see `polynomials`).
    quaternion : QuaternionMap
        Unit dual quaternion ``(p + q v)/(1+x)^(n/2)``, CP23 (50), (55).
    tensor : IsotropicMap
        Orthogonal dual tensor, CP23 (57).
    tangent, tangent_inv : IsotropicMap
        Tangent operator dcay_n and its inverse, CP23 (88), (89).

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
        return polynomials.p(self.order)

    @cached_property
    def q(self) -> sympy.Expr:
        """Polynomial q_n, CP23 (52)."""
        return polynomials.q(self.order)

    @cached_property
    def c(self) -> sympy.Expr:
        """Bracket ``[n (1+x)ⁿ⁻¹ − p q]/x`` of dcay_n."""
        return polynomials.c(self.order)

    @cached_property
    def d(self) -> sympy.Expr:
        """Bracket ``[(1+x) q − n p]/x`` of dcay_n⁻¹."""
        return polynomials.d(self.order)

    @property
    def poles(self) -> tuple[sympy.Expr, ...]:
        """Lengths ``Re|v| = tan(kπ/n)`` at the poles of dcay_n⁻¹."""
        return polynomials.poles(self.order)

    @cached_property
    def quaternion(self) -> QuaternionMap:
        """Unit dual quaternion, CP23 (50), (55)."""
        n = self.order
        root = (1 + x) ** sympy.Rational(n, 2)
        return QuaternionMap(
            name="quaternion",
            order=n,
            coefficients=(self.p / root, self.q / root),
            at=lambda at: closed_forms.quaternion(n, at),
            equations=self._equations("quaternion"),
            identities=("|q|^2 = 1",),
            domain="every dual vector v",
            singular=f"none; v is infinite at {self._chart_edge}",
            symbol=r"\hat{q}",
            definition=rf"\frac{{p_{{{n}}} + q_{{{n}}} v}}{{{_power(sympy.Rational(n, 2))}}}",
        )

    @cached_property
    def tensor(self) -> IsotropicMap:
        """Orthogonal dual tensor, CP23 (57)."""
        p, q, norm = self._letters
        return self._isotropic(
            "tensor",
            equations=self._equations("tensor"),
            identities=("R R^T = I", "det R = 1"),
            domain="every dual vector v",
            singular=f"none; v is infinite at {self._chart_edge}",
            symbol="R",
            definition=rf"I + \frac{{2 {p} {q}}}{{{norm}}} \tilde{{v}} + \frac{{2 {q}^2}}{{{norm}}} \tilde{{v}}^2",
        )

    @cached_property
    def tangent(self) -> IsotropicMap:
        """Tangent operator dcay_n, CP23 (88): space twist from v̇."""
        n = self.order
        p, q, norm = self._letters
        return self._isotropic(
            "tangent",
            equations=self._equations("tangent"),
            identities=("dcay v = 2n/(1+x) v", "dcay^T = R^T dcay", "det dcay = 8n q^2/(1+x)^(n+1)"),
            domain="every dual vector v",
            singular=f"loses rank at {self._rank_loss}; v is infinite at {self._chart_edge}",
            symbol=rf"\mathrm{{dcay}}_{{{n}}}",
            definition=(
                rf"\frac{{2 {p} {q}}}{{{norm}}} I + \frac{{2 {q}^2}}{{{norm}}} \tilde{{v}} + "
                rf"\frac{{2 [{f'{n} {_power(n - 1)}'.rstrip()} - {p} {q}]}}{{x {norm}}} v \otimes v"
            ),
        )

    @cached_property
    def tangent_inv(self) -> IsotropicMap:
        """Inverse tangent operator dcay_n⁻¹, CP23 (89): v̇ from the space twist."""
        n = self.order
        p, q, _ = self._letters
        return self._isotropic(
            "tangent_inv",
            equations=self._equations("tangent_inv"),
            identities=("dcay dcay^-1 = I",),
            domain="every dual vector v" if n < 3 else f"every dual vector v with Re q_{n} != 0",
            singular=f"pole at {self._rank_loss}; v is infinite at {self._chart_edge}",
            symbol=rf"\mathrm{{dcay}}_{{{n}}}^{{-1}}",
            definition=(
                rf"\frac{{{p}}}{{2 {q}}} I - \frac{{1}}{{2}} \tilde{{v}} + "
                rf"\frac{{(1 + x) {q} - {f'{n} ' if n > 1 else ''}{p}}}{{{2 * n} x {q}}} v \otimes v"
            ),
        )

    # --- chart (see `Chart`) ----------------------------------------------------------------------------------

    @property
    def title(self) -> str:
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

    def coefficient(self, angle: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        r = m.name("r", m.tan(m.div(angle, 2 * self.order)))
        return r, m.name("slope", m.div(1 + r * r, 2 * self.order))

    def coefficient_of(
        self, angle: Coefficient, sine: Coefficient, cosine: Coefficient, m: Arithmetic
    ) -> tuple[Coefficient, Coefficient]:
        next_to, rest, side = near_pole.sides(self.order, angle, sine, cosine, m)
        t = m.name("t", m.tan(m.div(rest, 2 * self.order)))
        r = m.name("r", side * m.where(next_to, 1, t) / m.where(next_to, t, 1))
        return r, m.name("slope", m.div(1 + r * r, 2 * self.order))

    def gain(self, q: Quaternion, size: Coefficient, m: Arithmetic, positive: bool = False) -> Coefficient:
        return m.name("gain", gains.gain(self.order, q, size, m, positive))

    def back(self, x: Coefficient, fi: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        at = self.scalars(x, m)
        return at.fi, at.hi

    def at_angle(self, x: Coefficient, fi: Coefficient, angle: Coefficient, m: Arithmetic) -> CayleyScalars:
        return self.scalars(x, m)

    def direction(self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        return branches.direction(self.order, self.scalars(x, m), y, r, m)

    def natural(
        self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic
    ) -> tuple[Coefficient, Coefficient, Coefficient]:
        return branches.natural(self.order, self.scalars(x, m), y, r, m)

    def unfolded(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        return 2 * self.order * m.atan2(r, 1)

    def turned(self, r: Coefficient, turn: Sequence[Coefficient], m: Arithmetic) -> branches.Derivatives:
        return branches.turned(r, turn, m)

    def returns(self) -> tuple[tuple[Any, Any, Any], ...]:
        return tuple(branches.returns(self.order))

    def latex(self) -> str:
        """Return the polynomials and the four maps as LaTeX, in the paper's letters."""
        n = self.order
        values = (("p", self.p), ("q", self.q))
        lines = [f"{letter}_{{{n}}} &= {sympy.latex(value, order=LATEX_ORDER)}" for letter, value in values]
        maps = (self.quaternion, self.tensor, self.tangent, self.tangent_inv)
        lines += [f"{item.symbol} &= {item.definition}" for item in maps]
        separator = " \\\\\n"
        return f"\\begin{{aligned}}\n{separator.join(lines)}\n\\end{{aligned}}"

    @property
    def _letters(self) -> tuple[str, str, str]:
        return f"p_{{{self.order}}}", f"q_{{{self.order}}}", _power(self.order)

    @property
    def _chart_edge(self) -> str:
        return f"Re alpha = {sympy.pi * self.order}"

    @property
    def _rank_loss(self) -> str:
        angles = self.singular_angles[:-1]
        return f"Re alpha = {', '.join(map(str, angles))}" if angles else "no finite v"

    def _equations(self, name: str) -> tuple[int, ...]:
        printed = _PRINTED.get(self.order)
        return EQUATIONS[name] if printed is None else (*EQUATIONS[name], printed + list(EQUATIONS).index(name))

    def _isotropic(self, name: str, **texts: Any) -> IsotropicMap:
        closed_form = getattr(closed_forms, name)
        coefficients = closed_form(self.order, FIELD.gens[0]).coefficients
        return IsotropicMap(
            name=name,
            order=self.order,
            coefficients=tuple(map(rational, coefficients)),
            at=lambda at: closed_form(self.order, at),
            **texts,
        )


def _power(exponent: int | sympy.Rational) -> str:
    """LaTeX of a power of 1 + x."""
    if exponent == 0:
        return ""
    return "(1 + x)" if exponent == 1 else f"(1 + x)^{{{exponent}}}"
