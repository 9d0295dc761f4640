r"""A chart: one parameterization v = φ(α) u of displacements, as its scalars of ``x = v · v`` and its way back.

Geometry is the same for all charts. With a handful of scalars, each regular at x = 0,

.. math::
    \hat q = s + w\,v \qquad R = I + f\,\tilde v + g\,\tilde v^2 \qquad T = f\,I + g\,\tilde v + h\,v \otimes v \qquad
    T^{-1} = \tfrac12 (f_i\,I - \tilde v + h_i\,v \otimes v)

    f = 2 s w \quad g = 2 w^2 \quad f^2 + x g^2 = 2 g \quad f_i = \frac{f}{g} \quad
    h_i = \frac{1}{x} \left(\frac{2}{f + x h} - f_i\right) \qquad v = \mathrm{gain}(\hat q)\,\mathrm{vec}\,\hat q

where ``ω = T v̇`` is the space twist. Dual parts need slopes: with ``x° = 2 y``, ``y = v · v°``, that of f(x) is
``fy y``, ``fy = 2 f′``. A slope is marked by y, that of a slope by yy.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Protocol

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
"""What every chart's maps are, in its scalars."""


class Scalars(Protocol):
    """The scalars of a chart at one x; a trailing y marks a slope, ``2 d/dx``, two of them the slope of that."""

    @property
    def s(self) -> Coefficient: ...
    @property
    def w(self) -> Coefficient: ...
    @property
    def sy(self) -> Coefficient: ...
    @property
    def wy(self) -> Coefficient: ...
    @property
    def f(self) -> Coefficient: ...
    @property
    def g(self) -> Coefficient: ...
    @property
    def h(self) -> Coefficient: ...
    @property
    def fy(self) -> Coefficient: ...
    @property
    def gy(self) -> Coefficient: ...
    @property
    def hy(self) -> Coefficient: ...
    @property
    def rate(self) -> Coefficient:
        """``1/φ′ = f + x h``, what T does along the axis."""

    @property
    def ratey(self) -> Coefficient: ...
    @property
    def fi(self) -> Coefficient: ...
    @property
    def hi(self) -> Coefficient: ...
    @property
    def fiy(self) -> Coefficient: ...
    @property
    def hiy(self) -> Coefficient: ...
    @property
    def fyy(self) -> Coefficient: ...
    @property
    def gyy(self) -> Coefficient: ...
    @property
    def hyy(self) -> Coefficient: ...
    @property
    def fiyy(self) -> Coefficient: ...
    @property
    def hiyy(self) -> Coefficient: ...

    @property
    def ray(self) -> tuple[Coefficient, Coefficient, Coefficient]:
        """(a, b, size): ``a + b v`` is the quaternion times its positive size, wherever that is cheaper."""


class Chart(Protocol):
    """A parameterization of displacements that can be proved and lowered."""

    def __hash__(self) -> int:
        """Charts do not change: what has been computed of one is kept."""

    @property
    def name(self) -> str:
        """An identifier, the name of its module."""

    @property
    def selection(self) -> tuple[str, str]:
        """The option that selects it in the command and its value: ``-n``, ``3``."""

    @property
    def order(self) -> int:
        """The order n in its name, 1 where there is none."""

    @property
    def title(self) -> str:
        """What it is, as a headline: ``Cayley map of order 3``."""

    @property
    def parameter(self) -> str:
        """φ(α) as text: ``tan(α/6)``."""

    @property
    def phi(self) -> sympy.Expr:
        """φ in `families.alpha`: odd, increasing up to the edge."""

    @property
    def edge(self) -> sympy.Expr:
        """Re α beyond which there is no v: a pole of φ or φ′ = 0; infinite where there is none."""

    @property
    def branches(self) -> int:
        """How many vectors v_k = φ(α + 2πk) u a pose has, k modulo their number; 0 where k is any integer."""

    @property
    def singular_angles(self) -> tuple[sympy.Expr, ...]:
        """Re α > 0 where v, T or its inverse is singular, the edge of the chart last."""

    @property
    def cayley(self) -> Cayley | None:
        """The Cayley map it is, about which there are theorems for every order; None for any other chart."""

    @property
    def base(self) -> Chart | None:
        """The chart whose vectors w, times `factor`, are those of this chart; None where it is no multiple."""

    @property
    def factor(self) -> Fraction:
        """K in ``v = K w``; 1 where there is no base chart."""

    def overflow(self, largest: float) -> tuple[str, float]:
        """Why forward maps are NaN for large v, and the Re|v| beyond which they are, in floats up to `largest`."""

    @property
    def remainder(self) -> float:
        """What scalars as computed are off by at most, however many digits numbers have: 0 of a formula."""

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
        """Functions of x the formulas are written in: p_n and q_n."""

    def scalars(self, x: Coefficient, m: Arithmetic) -> Scalars:
        """The scalars at x."""

    def coefficient(self, angle: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        """φ and φ′ at an angle: ``v = φ(α) u``."""

    def coefficient_of(
        self, angle: Coefficient, sine: Coefficient, cosine: Coefficient, m: Arithmetic
    ) -> tuple[Coefficient, Coefficient]:
        """The same of a quaternion: at an angle, sine ≥ 0 and cosine of whose half are known but for length and sign.

        Next to a pole of φ these say how far it is from there, which the angle, rounded, does not.
        """

    def gain(self, q: Quaternion, size: Coefficient, m: Arithmetic, positive: bool = False) -> Coefficient:
        """The factor in ``v = gain · vec q`` for a quaternion of norm `size`; `positive` says that its scalar is."""

    def back(self, x: Coefficient, fi: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        """The scalars (f_i, h_i) of T⁻¹ at ``v = gain · vec q``, where `fi` is the gain times the scalar of q.

        That is f_i too: for a chart that is folded at its edge, φ′ = 0, it is the better one, since x hardly changes
        there. For others that at x is: the derivative of a gain loses digits where v is small.
        """

    def at_angle(self, x: Coefficient, fi: Coefficient, angle: Coefficient, m: Arithmetic) -> Scalars:
        """Scalars of T⁻¹ at ``v = φ(α) u`` of a known angle, `fi` as in `back`.

        Where φ′ = 0 is near, x says little of the angle: what a rounding of v changes grows with 1/φ′.
        """

    def direction(self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """1 or −1: the axis of the principal angle is that times ``v/|v|``, where ``v = r u``, r ≥ 0."""

    def natural(
        self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic
    ) -> tuple[Coefficient, Coefficient, Coefficient]:
        """The principal angle of ``v = r u``, r ≥ 0, ``dα/dr`` on v's own branch, and the `direction`."""

    def unfolded(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """The angle of ``v = r u`` on its own branch, r > 0."""

    def turned(
        self, r: Coefficient, turn: Sequence[Coefficient], m: Arithmetic
    ) -> tuple[Coefficient, Coefficient, Coefficient]:
        """Return r_k of the vector a `turn` on from ``v = r u``, and its first and second derivatives by r.

        Where v is principal already they are not used, r is ``sqrt(1 + x)``, and they must still be numbers.
        """

    def beyond(
        self, x: Coefficient, table: Sequence[Coefficient], m: Arithmetic
    ) -> tuple[Any, Sequence[Coefficient]]:
        """Whether v lies beyond the principal branch, and the turn that brings it back, from the table `returns`."""

    def turn(self, branch: int) -> tuple[Any, Any]:
        """The two numbers of a turn by so many branches, in the working precision of mpmath."""

    def returns(self) -> Sequence[tuple[Any, Any, Any]]:
        """By turns back, the x beyond which one more is due and its two numbers; empty where every v is principal."""
