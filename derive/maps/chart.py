r"""Chart of displacements, ``v = φ(α) u``, given by its scalars at ``x = v · v`` and inverse maps.

All charts share the formulas below. Charts differ in their scalars, which are regular at x = 0:

.. math::
    \hat q = s + w\,v \qquad R = I + f\,\tilde v + g\,\tilde v^2 \qquad T = f\,I + g\,\tilde v + h\,v \otimes v \qquad
    T^{-1} = \tfrac12 (f_i\,I - \tilde v + h_i\,v \otimes v)

    f = 2 s w \quad g = 2 w^2 \quad f^2 + x g^2 = 2 g \quad f_i = \frac{f}{g} \quad
    h_i = \frac{1}{x} \left(\frac{2}{f + x h} - f_i\right) \qquad v = \mathrm{gain}(\hat q)\,\mathrm{vec}\,\hat q

Here ``ω = T v̇`` is the space twist. Dual parts need slopes: with ``y = v · v°`` and ``x° = 2 y``, the dual part
of f(x) is ``fy y``, where ``fy = 2 f′``. A trailing y marks a slope, yy a second slope.
"""

from __future__ import annotations

import inspect
from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import fields
from fractions import Fraction
from functools import cached_property
from types import FunctionType
from typing import Any, ClassVar, NamedTuple, cast

import sympy

from ..algebra import Coefficient, Quaternion
from ..algebra.arithmetic import Arithmetic, Marked, Pair
from .chart_formulas import ChartFormulas, Scalars
from .polynomials import Triple
from .real_constants import NOISE, NOISE_OF_STEPS, SMALL, at_turn, number, plus, times


class Followed(NamedTuple):
    """Vector ``of_e vec e + of_v v`` after a step from v, with data of T⁻¹ there."""

    of_e: Coefficient
    of_v: Coefficient  # 0 unless the axis of v stays
    fe: Coefficient  # f_i by the quaternion, which knows the distance from a whole turn
    known: Coefficient  # number by which `Chart.at_known` knows the angle
    lost: Coefficient = 0  # 1 where the distance from a whole turn is rounding noise, so that f_i is any large number


class Chart(ChartFormulas):
    """Parameterization of displacements, as an immutable data class for proofs and for lowering to programs."""

    name: str  # name of the generated module, an identifier
    selection: tuple[str, str]  # command-line option and its value, such as -n, 3
    title: str  # headline, such as "Cayley map of order 3"
    vector: ClassVar[str] = "dual vector"  # name of v in the field
    operator: ClassVar[str] = ""  # name of T in the field, if any
    base: Chart | None = None  # chart of the vector w, with v = factor · w
    factor: Fraction = Fraction(1)  # factor of the base chart; 1 without one

    def __init_subclass__(cls, **keywords: Any) -> None:
        """Give members that override documented ones their docstrings."""
        super().__init_subclass__(**keywords)
        for name, member in vars(cls).items():
            if isinstance(member, FunctionType | property | cached_property) and member.__doc__ is None:
                member.__doc__ = inspect.getdoc(getattr(super(cls, cls), name, None))

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields, without cached results."""
        return {field.name: getattr(self, field.name) for field in fields(cast(Any, self))}

    @property
    @abstractmethod
    def branches(self) -> int:
        """Period in k of the vectors ``v_k = φ(α + 2πk) u`` of a pose; 0 if they have no period."""

    @property
    def remainder(self) -> float:
        """Bound of the approximation error of the scalars at any precision; 0 for closed formulas."""
        return 0.0

    @property
    def steep(self) -> tuple[Any, ...]:
        """Angles below the edge, as mpmath numbers, near which the inverse of φ is hardest to find; often none."""
        return ()

    @property
    def letters(self) -> Sequence[tuple[str, sympy.Expr]]:
        """Letters in the formulas and the functions of x for which they stand, such as p_n and q_n."""
        return ()

    @property
    def cayley(self) -> Any:
        """Chart itself if it is a Cayley map, with theorems for every order; None otherwise."""
        return None

    @property
    def parameter(self) -> str:
        """Text of φ(α), such as ``tan(α/6)``."""
        return str(self.written).replace("alpha", "α").replace("**", "^").replace("*", " ")

    def require_kernels(self) -> None:
        """Raise `PhiError` if kernels cannot compute the chart."""

    # --- scalars and inverse maps ---------------------------------------------------------------------------------

    @abstractmethod
    def overflow(self, largest: float) -> tuple[str, float]:
        """Return the reason for NaN at large v, and the limit of Re|v| in forward maps, for floats up to `largest`."""

    @abstractmethod
    def coefficient(self, angle: Coefficient, m: Arithmetic) -> Pair:
        """Return φ and φ′ at an angle."""

    def coefficient_of(self, angle: Coefficient, sine: Coefficient, cosine: Coefficient, m: Arithmetic) -> Pair:
        """Return φ and φ′ at the angle of a quaternion.

        The arguments `sine` ≥ 0 and `cosine` belong to half the angle, up to a common factor. They give all digits of
        the distance to a pole of φ; the rounded angle does not.
        """
        return self.coefficient(angle, m)

    @abstractmethod
    def gain(self, q: Quaternion, size: Coefficient, m: Arithmetic) -> Coefficient:
        """Return the factor in ``v = gain · vec q`` for a quaternion of norm `size`.

        The sign is that of the scalar part of q. It is 1 if the scalar part is 0 up to rounding, at half a turn: the
        side of the given vector part stands. The vector ends at the edge, despite rounding.
        """

    @property
    def folds(self) -> bool:
        """True if v is finite at the edge and φ turns back there: an angle beyond it by rounding is the edge."""
        return not self.range.is_infinite

    def inside(self, x: Coefficient, m: Arithmetic) -> Coefficient:
        """Return 1, or a smaller factor for a vector of square x that is beyond the edge by rounding."""
        if self.range.is_infinite:
            return 1
        over = m.name("over", plus(x, number(-(self.range**2)), m, "overx"))
        beyond = m.name("excess", over + m.abs(over))  # twice the excess, or 0
        return m.div(1, 1 + 2 * times(number(1 / self.range**2), beyond, m, "share"))

    @abstractmethod
    def back(self, x: Coefficient, fi: Coefficient, m: Arithmetic) -> Pair:
        """Return the scalars (f_i, h_i) of T⁻¹ at ``v = gain · vec q``.

        The argument `fi` is f_i as the gain times the scalar part of q. Near a fold at the edge, where x hardly
        changes, `fi` is more accurate than f_i from x. Other charts use f_i from x: the gain loses digits at small v.
        """

    def known(self, angle: Coefficient, m: Arithmetic) -> Coefficient:
        """Return the number by which `at_known` knows an angle: the angle itself."""
        return angle

    @abstractmethod
    def at_known(self, x: Coefficient, fi: Coefficient, known: Coefficient, m: Arithmetic) -> Scalars:
        """Return the scalars of T⁻¹ at the number `known` of an angle, with `fi` as in `back`.

        Near a fold, x alone determines the angle badly: the error grows with 1/φ′.
        """

    # --- branches -------------------------------------------------------------------------------------------------

    def followed(
        self, x: Coefficient, along: Coefficient, e: Quaternion, size: Coefficient, turn: Coefficient, m: Arithmetic
    ) -> Followed:
        """Return the vector that a step from v leads to, as factors of vec e and of v.

        The product e = exp(δ/2) q̂(v), or its reverse, has the norm `size`; ``along = v · vec e``; `turn` is the scalar
        part of exp(δ/2). The angle is that nearest the projection of v's angle on the new axis. Where vec e vanishes
        at a whole turn, up to rounding beside v, the axis of v stays.
        """
        ss = m.name("ss", e.vector.dot(e.vector))
        still, resting = m.name("still", m.equal(ss, 0)), m.name("resting", m.equal(x, 0))
        # NaN where the square overflows
        length = m.name("length", m.sqrt(m.where(still, 1 + ss, ss)) + (ss - ss))
        r = m.name("rv", m.sqrt(m.where(resting, 1 + x, x)))
        own = self.unfolded(x, r, cast(Arithmetic, Marked(m, "v")))
        own, part = m.name("ownv", m.where(resting, 0, own)), m.name("part", along / r)
        # an angle within half a turn has all digits near the identity, for both signs of e
        falling = m.name("falling", m.less(e.scalar, 0))
        cosine = m.name("cosine", m.where(falling, -e.scalar, e.scalar))
        # vec e has its own direction, unless it is short, and along v but for rounding
        across, below = m.sqrt(m.abs(ss - part * part)), m.where(m.less(length, cosine), cosine, length)
        noise = m.name("noise", across / NOISE_OF_STEPS + ss / (NOISE * below))
        apart = m.name("apart", m.less(cosine, m.beside(cosine, noise)))
        projected = m.name("projected", m.where(apart, own * part / length, own))
        sine = m.name("sine", m.where(still, ss, length))
        angle = m.name("folded", m.where(falling, -2, 2) * m.atan2(sine, cosine))
        turns = m.name("turns", projected - angle + 2 * m.atan2(m.tan(m.div(angle - projected, 2)), 1))
        # a multiple of 2π up to rounding; set to 0 on the principal branch, where rounding would spoil small angles
        principal = m.name("principal", m.less(m.abs(turns), 1))
        turned = m.name("turned", m.either(apart, principal))
        sine = m.name("sinen", m.where(turned, sine, part))
        rest = m.name("rest", m.where(turned, angle, 2 * part / m.where(turned, 1, e.scalar)))
        alpha = m.name("alphan", rest + m.where(principal, 0, turns))
        rk, slope = self.coefficient_of(alpha, sine, e.scalar, cast(Arithmetic, Marked(m, "n")))
        lost = m.name("lost", m.where(turned, 0, at_turn(part, cosine, rk, m)))
        sharp = m.where(m.name("sharp", m.equal(lost, 0)), part, m.div(cosine, SMALL))
        below = m.where(turned, m.where(still, e.scalar, length), sharp)
        rk = m.name("above", m.where(m.both(turned, still), 2 * slope, rk))
        factor = m.name("factor", rk / m.name("below", below))
        of_e, of_v = m.where(turned, factor, 0), m.where(turned, 0, rk / r)
        known = self.known(alpha, cast(Arithmetic, Marked(m, "n")))
        return Followed(m.name("ofe", of_e), m.name("ofv", of_v), m.name("fe", factor * e.scalar), known, lost)

    def direction(self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """Return the sign, 1 or −1, in the axis ``u = ±v/|v|`` of the principal angle, for ``r = |v|``."""
        return self.natural(x, y, r, m)[2]

    @abstractmethod
    def natural(self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic) -> Triple:
        """Return the principal angle of ``v = r u``, r ≥ 0, ``dα/dr`` on the branch of v, and the `direction`."""

    @abstractmethod
    def turned(self, r: Coefficient, turn: Sequence[Coefficient], m: Arithmetic) -> Triple:
        """Return r_k of the vector one `turn` away from ``v = r u``, and its first and second derivatives by r."""

    @abstractmethod
    def beyond(self, x: Coefficient, table: Sequence[Coefficient], m: Arithmetic) -> tuple[Any, Coefficient, Pair]:
        """Return whether v lies beyond the principal branch, then x or an unused number, and the turn back.

        Limits and turns come from the table `returns`. The unused number is near x at half a turn.
        """

    @abstractmethod
    def turn(self, branch: int) -> tuple[Any, Any]:
        """Return the two numbers that describe a turn by `branch` branches, in the working precision of mpmath."""

    @abstractmethod
    def returns(self) -> Sequence[tuple[Any, Any, Any]]:
        """Return a table with a row for each turn back: the limit of x, and the two numbers of the turn.

        For a multiple K of a base chart the limit applies to ``x/K²``. The table is empty if every v is principal.
        """
