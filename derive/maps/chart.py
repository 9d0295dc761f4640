r"""Chart: a parameterization v = φ(α) u of displacements, given by scalars of ``x = v · v`` and inverse maps.

All charts share the same geometry and differ in scalars, each regular at x = 0:

.. math::
    \hat q = s + w\,v \qquad R = I + f\,\tilde v + g\,\tilde v^2 \qquad T = f\,I + g\,\tilde v + h\,v \otimes v \qquad
    T^{-1} = \tfrac12 (f_i\,I - \tilde v + h_i\,v \otimes v)

    f = 2 s w \quad g = 2 w^2 \quad f^2 + x g^2 = 2 g \quad f_i = \frac{f}{g} \quad
    h_i = \frac{1}{x} \left(\frac{2}{f + x h} - f_i\right) \qquad v = \mathrm{gain}(\hat q)\,\mathrm{vec}\,\hat q

Here ``ω = T v̇`` is the space twist. Dual parts need slopes: with ``y = v · v°`` and ``x° = 2 y``, the dual part
of f(x) is ``fy y``, where ``fy = 2 f′``. A trailing y marks a slope, yy a second slope.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias

import sympy

from ..algebra import Coefficient, Quaternion
from ..algebra.arithmetic import Arithmetic
from .formula import IsotropicMap, QuaternionMap

if TYPE_CHECKING:
    from .cayley import Cayley

DEFINITIONS = {
    "quaternion": r"\hat q = s + w\,v",
    "tensor": r"R = I + f\,\tilde v + g\,\tilde v^2 \qquad f = 2 s w \quad g = 2 w^2",
    "tangent": r"T = f\,I + g\,\tilde v + h\,v \otimes v",
    "tangent_inv": r"T^{-1} = \tfrac12 (f_i\,I - \tilde v + h_i\,v \otimes v) \qquad f_i = \frac{f}{g}",
}
"""LaTeX of the maps of every chart in terms of its scalars."""


Scalars: TypeAlias = Any
"""Scalars of a chart at x: s, w, f, g, h, fi, hi, and ``rate = 1/φ′ = f + x h``, the factor of T along the axis.

Their slopes, ``2 d/dx``, are sy, wy, fy, gy, hy, fiy, hiy and ratey; second slopes are fyy, gyy, hyy, fiyy and hiyy.
``ray`` is (a, b, size): ``a + b v`` is the quaternion times the positive size, 1 unless another size is cheaper.
"""


class Chart(Protocol):
    """Parameterization of displacements that can be proved and lowered."""

    def __hash__(self) -> int:
        """Return the hash: charts are immutable, and results about them are cached."""

    @property
    def name(self) -> str:
        """Name of the generated module, an identifier."""

    @property
    def selection(self) -> tuple[str, str]:
        """Command-line option that selects the chart, and its value: ``-n``, ``3``."""

    @property
    def order(self) -> int:
        """Order n; 1 for a chart without an order."""

    @property
    def title(self) -> str:
        """Headline, such as ``Cayley map of order 3``."""

    @property
    def parameter(self) -> str:
        """Text of φ(α), such as ``tan(α/6)``."""

    @property
    def phi(self) -> sympy.Expr:
        """Function φ of `families.alpha`: odd, increasing up to the edge."""

    @property
    def edge(self) -> sympy.Expr:
        """Largest Re α of the chart: a pole of φ or a zero of φ′; infinite for a chart without an edge."""

    @property
    def branches(self) -> int:
        """Number of vectors v_k = φ(α + 2πk) u of a pose, k modulo this number; 0 if every integer k counts."""

    @property
    def singular_angles(self) -> tuple[sympy.Expr, ...]:
        """Angles Re α > 0 where v, T or T⁻¹ is singular; the edge, if any, comes last."""

    @property
    def cayley(self) -> Cayley | None:
        """Chart itself if it is a Cayley map, whose theorems hold at every order; None otherwise."""

    @property
    def base(self) -> Chart | None:
        """Base chart with the vectors w in ``v = factor · w``; None for a chart that is no multiple."""

    @property
    def factor(self) -> Fraction:
        """Factor K in ``v = K w``; 1 without a base chart."""

    def overflow(self, largest: float) -> tuple[str, float]:
        """Return the reason why forward maps are NaN for large v, and the limit of Re|v|.

        `largest` is the largest finite float.
        """

    @property
    def remainder(self) -> float:
        """Bound of the approximation error of scalars at any number of digits; 0 for closed formulas."""

    @property
    def quaternion(self) -> QuaternionMap: ...
    @property
    def tensor(self) -> IsotropicMap: ...
    @property
    def tangent(self) -> IsotropicMap: ...
    @property
    def tangent_inv(self) -> IsotropicMap: ...

    @property
    def letters(self) -> Sequence[tuple[str, sympy.Expr]]:
        """Functions of x in the formulas, by letter: p_n and q_n."""

    def scalars(self, x: Coefficient, m: Arithmetic) -> Scalars:
        """Return the scalars at x."""

    def coefficient(self, angle: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        """Return φ and φ′ at an angle."""

    def coefficient_of(
        self, angle: Coefficient, sine: Coefficient, cosine: Coefficient, m: Arithmetic
    ) -> tuple[Coefficient, Coefficient]:
        """Return φ and φ′ at the angle of a quaternion.

        Sine ≥ 0 and cosine of half the angle are given up to a common factor. Unlike the rounded angle, they determine
        the distance to a pole of φ.
        """

    def gain(self, q: Quaternion, size: Coefficient, m: Arithmetic, positive: bool = False) -> Coefficient:
        """Return the factor in ``v = gain · vec q`` for a quaternion of norm `size`.

        `positive` states that the scalar part is positive.
        """

    def back(self, x: Coefficient, fi: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        """Return the scalars (f_i, h_i) of T⁻¹ at ``v = gain · vec q``.

        `fi` is f_i computed as the gain times the scalar part of q. This value is better for a chart with a fold at its
        edge, where x hardly changes. For other charts f_i computed from x is better: the derivative of the gain loses
        digits for small v.
        """

    def at_angle(self, x: Coefficient, fi: Coefficient, angle: Coefficient, m: Arithmetic) -> Scalars:
        """Return the scalars of T⁻¹ at a known angle, with `fi` as in `back`.

        Near a fold, x alone determines the angle badly: the error grows with 1/φ′.
        """

    def direction(self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """Return the sign, 1 or −1, in the axis ``u = ±v/|v|`` of the principal angle, for ``r = |v|``."""

    def natural(
        self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic
    ) -> tuple[Coefficient, Coefficient, Coefficient]:
        """Return the principal angle of ``v = r u``, r ≥ 0, ``dα/dr`` on the branch of v, and the `direction`."""

    def unfolded(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """Return the angle of ``v = r u``, r > 0, on the branch of v."""

    def turned(
        self, r: Coefficient, turn: Sequence[Coefficient], m: Arithmetic
    ) -> tuple[Coefficient, Coefficient, Coefficient]:
        """Return r_k of the vector one `turn` away from ``v = r u``, and its first and second derivatives by r.

        For a principal v the results are unused but must be numbers; r is then ``sqrt(1 + x)``.
        """

    def beyond(
        self, x: Coefficient, table: Sequence[Coefficient], m: Arithmetic
    ) -> tuple[Any, Sequence[Coefficient]]:
        """Return whether v lies beyond the principal branch, and the turn back, from the table `returns`."""

    def turn(self, branch: int) -> tuple[Any, Any]:
        """Return the two numbers that describe a turn by `branch` branches, in the working precision of mpmath."""

    def returns(self) -> Sequence[tuple[Any, Any, Any]]:
        """Return a table with a row for each turn back: the limit of x, and the two numbers of the turn.

        For a multiple K of a base chart the limit applies to ``x/K²``. The table is empty if every v is principal.
        """
