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
from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from dataclasses import fields
from fractions import Fraction
from functools import cached_property
from types import FunctionType
from typing import TYPE_CHECKING, Any, ClassVar, TypeAlias, TypeVar, cast

import mpmath
import sympy
from sympy.core.traversal import bottom_up

from ..algebra import Coefficient, Quaternion
from ..algebra.arithmetic import PLAIN, Arithmetic
from ..algebra.latex import latex
from ..output.typeset import Typeset
from .angle_of_length import angle_of
from .families import alpha, of_angle
from .formula import Formula, IsotropicMap, QuaternionMap
from .polynomials import Pair, Triple, x
from .real_constants import number, plus, times

if TYPE_CHECKING:
    from .cayley import Cayley

Map = TypeVar("Map", bound=Formula)

DEFINITIONS = {
    "quaternion": r"\hat q = s + w\,v",
    "tensor": r"R = I + f\,\tilde v + g\,\tilde v^2 \qquad f = 2 s w \quad g = 2 w^2",
    "tangent": r"T = f\,I + g\,\tilde v + h\,v \otimes v",
    "tangent_inv": r"T^{-1} = \tfrac12 (f_i\,I - \tilde v + h_i\,v \otimes v) \qquad f_i = \frac{f}{g}",
}
"""LaTeX of the maps of every chart in terms of its scalars."""

LETTERS = (
    (r"\alpha", r"\text{dual angle}"),
    ("u", r"\text{unit dual vector of the screw axis}"),
    ("v", r"\varphi(\alpha)\,u"),
    ("x", r"v \cdot v"),
    (r"\tilde v\,a", r"v \times a \text{ for every vector } a"),
    ("I\\,a", "a"),
)
"""LaTeX of the letters of every chart."""

IDENTITIES = {
    "quaternion": ("|q|^2 = 1",),
    "tensor": ("R R^T = I", "det R = 1"),
    "tangent": ("T v = (phi/phi') u", "T^T = R^T T"),
    "tangent_inv": ("T T^-1 = I",),
}

Scalars: TypeAlias = Any
"""Scalars of a chart at x: s, w, f, g, h, fi, hi, and ``rate = 1/φ′ = f + x h``, the factor of T along the axis.

Their slopes, ``2 d/dx``, are sy, wy, fy, gy, hy, fiy, hiy and ratey; second slopes are fyy, gyy, hyy, fiyy and hiyy.
``ray`` is (a, b, size) with ``a + b v = size · q̂``. The positive size is 1 unless another size costs less.
"""


class Chart(Typeset, ABC):
    """Parameterization of displacements, as an immutable data class for proofs and for lowering to programs."""

    name: str  # name of the generated module, an identifier
    selection: tuple[str, str]  # command-line option and its value, such as -n, 3
    order: int  # order n; 1 for a chart without an order
    title: str  # headline, such as "Cayley map of order 3"
    vector: ClassVar[str] = "dual vector"  # name of v in the field
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
    def phi(self) -> sympy.Expr:
        """Odd function φ of `families.alpha`, increasing up to the edge."""

    @property
    @abstractmethod
    def edge(self) -> sympy.Expr:
        """Largest Re α of the chart: a pole of φ or a zero of φ′; infinite for a chart without an edge."""

    @property
    @abstractmethod
    def branches(self) -> int:
        """Period in k of the vectors ``v_k = φ(α + 2πk) u`` of a pose; 0 if they have no period."""

    @property
    @abstractmethod
    def singular_angles(self) -> tuple[sympy.Expr, ...]:
        """Angles Re α > 0 where v, T or T⁻¹ is singular; the edge, if any, comes last."""

    @property
    def algebraic(self) -> bool:
        """Tell whether the formulas are algebraic in x, with at most one root sqrt(1 + x/k), k an integer."""
        return True

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
    def cayley(self) -> Cayley | None:
        """Chart itself if it is a Cayley map, with theorems for every order; None otherwise."""
        return None

    @property
    def parameter(self) -> str:
        """Text of φ(α), such as ``tan(α/6)``."""
        return str(self.phi).replace("alpha", "α").replace("**", "^").replace("*", " ")

    def require_kernels(self) -> None:
        """Raise `PhiError` if kernels cannot compute the chart."""

    # --- scalars and inverse maps ---------------------------------------------------------------------------------

    @abstractmethod
    def overflow(self, largest: float) -> tuple[str, float]:
        """Return the reason for NaN at large v, and the limit of Re|v| in forward maps, for floats up to `largest`."""

    @abstractmethod
    def scalars(self, x: Coefficient, m: Arithmetic) -> Scalars:
        """Return the scalars at x."""

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

    @abstractmethod
    def at_angle(self, x: Coefficient, fi: Coefficient, angle: Coefficient, m: Arithmetic) -> Scalars:
        """Return the scalars of T⁻¹ at a known angle, with `fi` as in `back`.

        Near a fold, x alone determines the angle badly: the error grows with 1/φ′.
        """

    # --- branches -------------------------------------------------------------------------------------------------

    def direction(self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """Return the sign, 1 or −1, in the axis ``u = ±v/|v|`` of the principal angle, for ``r = |v|``."""
        return self.natural(x, y, r, m)[2]

    @abstractmethod
    def natural(self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic) -> Triple:
        """Return the principal angle of ``v = r u``, r ≥ 0, ``dα/dr`` on the branch of v, and the `direction`."""

    @abstractmethod
    def unfolded(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """Return the angle of ``v = r u``, r > 0, on the branch of v."""

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

    # --- from φ ---------------------------------------------------------------------------------------------------

    @property
    def scale(self) -> sympy.Expr:
        """Factor a(v) as a function of α, from ``q̂ = ±(a + v)ⁿ/(a² + x)^(n/2)``: CP23 (60), (61)."""
        return self.phi * sympy.cot(alpha / (2 * self.order))

    @property
    def range(self) -> sympy.Expr:
        """Length |v| at the edge; infinite at a pole."""
        end = self.phi.subs(alpha, self.edge)
        return end if end.evalf().is_finite else sympy.oo

    @property
    def angle(self) -> sympy.Expr:
        """Angle φ⁻¹(|v|), as a function of x, up to the edge."""
        found: sympy.Expr = self.unfolded(x, sympy.sqrt(x), PLAIN)
        return found.replace(sympy.atan2, lambda sine, cosine: sympy.atan(sine / cosine))  # the cosine is positive

    @property
    def ends(self) -> bool:
        """Tell whether vectors longer than `range` have no pose."""
        return not self.range.is_infinite

    @property
    def limits(self) -> tuple[tuple[sympy.Expr, ...], tuple[sympy.Expr, ...]]:
        """Coefficients of T and of T⁻¹ at α = 0, from ``φ = c₁ α + c₃ α³ + …``."""
        first, third = (self.phi.diff(alpha, k).subs(alpha, 0) / sympy.factorial(k) for k in (1, 3))
        sixth, bend = sympy.Rational(1, 6), 2 * third / first
        tangent = 1 / first, 1 / (2 * first**2), (sixth - bend) / first**3
        return tangent, (first, -sympy.Rational(1, 2), bend / first + sixth / (2 * first))

    def inverse(self, size: Any) -> Any:
        """Return φ⁻¹ of a length below `range`, in the working precision of mpmath."""
        return angle_of(self.phi, self.edge, mpmath.mpf(size))

    # --- formulas -------------------------------------------------------------------------------------------------

    @cached_property
    def quaternion(self) -> QuaternionMap:
        """Unit dual quaternion ``s + w v``, scalar first; defined up to the edge."""
        return self._formula(QuaternionMap, "quaternion", self._values.s, self._values.w)

    @cached_property
    def tensor(self) -> IsotropicMap:
        """Orthogonal dual tensor R, which takes body to space; defined up to the edge."""
        at = self._values
        return self._formula(IsotropicMap, "tensor", 1 - at.x * at.g, at.f, at.g)

    @cached_property
    def tangent(self) -> IsotropicMap:
        """Tangent operator T, which takes v̇ to the space twist; it loses rank at whole turns."""
        at = self._values
        return self._formula(IsotropicMap, "tangent", at.f, at.g, at.h)

    @cached_property
    def tangent_inv(self) -> IsotropicMap:
        """Inverse tangent operator T⁻¹, which takes the space twist to v̇; whole turns are its poles."""
        at = self._values
        return self._formula(IsotropicMap, "tangent_inv", at.fi / 2, -sympy.Rational(1, 2), at.hi / 2)

    def latex(self) -> str:
        """Return φ, the scalars and the four maps as LaTeX, with every letter defined."""
        s, w = self.quaternion.coefficients
        (fi, _, hi), tangent = self.tangent_inv.coefficients, self.tangent.coefficients
        scalars = zip(("s", "w", "f", "g", "h", "f_i", "h_i"), (s, w, *tangent, 2 * fi, 2 * hi), strict=True)
        return self._aligned((letter, latex(value)) for letter, value in scalars)

    def _aligned(self, letters: Iterable[tuple[str, str]]) -> str:
        """Return equations in LaTeX: the letters of every chart, further letters, then the four maps."""
        maps = (self.quaternion, self.tensor, self.tangent, self.tangent_inv)
        first = ((r"\varphi(\alpha)", latex(self.phi)), *LETTERS, *letters)
        equations = (*first, *((of.symbol, of.definition) for of in maps))
        lines = " \\\\\n".join(f"{left} &= {right}" for left, right in equations)
        return f"\\begin{{aligned}}\n{lines}\n\\end{{aligned}}"

    def _typeset(self) -> str:
        return self.latex()

    @cached_property
    def _values(self) -> Any:
        """Scalars and x, as expressions in x for an algebraic chart, otherwise in α."""
        return self.scalars(x, PLAIN) if self.algebraic else of_angle(self.phi)

    def _formula(self, kind: type[Map], name: str, *coefficients: sympy.Expr) -> Map:
        poles = [f"Re alpha = {angle}" for angle in self.singular_angles if angle != self.edge]
        infinite = self.range.is_infinite
        end = "v is infinite" if infinite else "v ends, and with it the domain,"
        end = f"{end} at Re alpha = {self.edge}"
        end = "no edge; angles beyond 4*pi are not listed" if self.edge.is_infinite else end
        lost = {"tangent": "loses rank at", "tangent_inv": "pole at"}.get(name, "") if poles else ""
        domain = "every dual vector v" if infinite else f"Re|v| < {self.range}"
        coefficients = tuple(c + sympy.Integer(0) for c in coefficients)  # Python integers become SymPy numbers
        symbol, _, definition = DEFINITIONS[name].partition(" = ")
        return kind(
            name=name,
            order=self.order,
            coefficients=tuple(map(factored, coefficients)) if self.algebraic else coefficients,
            equations=(),
            identities=IDENTITIES[name],
            domain=f"{domain} off the poles" if lost and name == "tangent_inv" else domain,
            singular=f"{lost} {', '.join(poles)}; {end}" if lost else end,
            symbol=symbol,
            definition=definition,
            **{} if self.algebraic else {"angle": self.angle, "at_zero": self._at_zero[name]},
        )

    @property
    def _at_zero(self) -> dict[str, tuple[sympy.Expr, ...]]:
        """Coefficients of the maps at α = 0, by name."""
        tangent, tangent_inv = self.limits
        f, g, _ = tangent
        of_tensors = {"tensor": (sympy.Integer(1), f, g), "tangent": tangent, "tangent_inv": tangent_inv}
        return {"quaternion": (sympy.Integer(1), f / 2), **of_tensors}


def factored(expression: sympy.Expr) -> sympy.Expr:
    """Return the factors of an expression, with products that SymPy keeps when it rebuilds them, as copies do."""
    return bottom_up(sympy.factor(expression), lambda e: e.func(*e.args) if e.args else e)
