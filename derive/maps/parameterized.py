"""Formulas of a chart and their texts, derived from φ and the scalars of the chart."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import fields
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar, cast

import mpmath
import sympy

from ..algebra import Coefficient
from ..algebra.arithmetic import PLAIN, Arithmetic
from .any_phi.closed_inverse import closed_inverse
from .any_phi.edges import angle_of
from .branches import NOISE
from .chart import DEFINITIONS, Chart, Scalars
from .dependent import DependentScalars
from .families import alpha, of_angle
from .formula import Formula, IsotropicMap, QuaternionMap
from .polynomials import x

if TYPE_CHECKING:
    from .cayley import Cayley

Map = TypeVar("Map", bound=Formula)

SYMBOLS = {"quaternion": r"\hat q", "tensor": "R", "tangent": "T", "tangent_inv": "T^{-1}"}
IDENTITIES = {
    "quaternion": ("|q|^2 = 1",),
    "tensor": ("R R^T = I", "det R = 1"),
    "tangent": ("T v = (phi/phi') u", "T^T = R^T T"),
    "tangent_inv": ("T T^-1 = I",),
}


class Parameterized(ABC):
    """Chart v = φ(α) u whose formulas follow from its scalars."""

    order: int
    base: Chart | None = None
    factor: Fraction = Fraction(1)

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields without cached formulas, which hold functions that cannot be pickled."""
        return {field.name: getattr(self, field.name) for field in fields(cast(Any, self))}

    @property
    @abstractmethod
    def phi(self) -> sympy.Expr: ...
    @property
    @abstractmethod
    def edge(self) -> sympy.Expr: ...
    @property
    @abstractmethod
    def singular_angles(self) -> tuple[sympy.Expr, ...]: ...
    @abstractmethod
    def scalars(self, x: Coefficient, m: Arithmetic) -> Scalars: ...

    @abstractmethod
    def coefficient(self, angle: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]: ...

    def coefficient_of(
        self, angle: Coefficient, sine: Coefficient, cosine: Coefficient, m: Arithmetic
    ) -> tuple[Coefficient, Coefficient]:
        return self.coefficient(angle, m)

    @property
    def algebraic(self) -> bool:
        """Tell whether the formulas contain at most one root, sqrt(1 + x/k) with k an integer."""
        return True

    @property
    def remainder(self) -> float:
        return 0.0

    @property
    def letters(self) -> tuple[tuple[str, sympy.Expr], ...]:
        return ()

    @property
    def cayley(self) -> Cayley | None:
        return None

    @property
    def parameter(self) -> str:
        return str(self.phi).replace("alpha", "α").replace("**", "^").replace("*", " ")

    # --- from φ ---------------------------------------------------------------------------------------------------

    @property
    def scale(self) -> sympy.Expr:
        """Factor a(v) as a function of α, from ``q̂ = ±(a + v)ⁿ/(a² + x)^(n/2)``: CP23 (60), (61)."""
        return self.phi * sympy.cot(alpha / (2 * self.order))

    @property
    def range(self) -> sympy.Expr:
        """Length |v| at the edge; infinite at a pole."""
        return self.phi.subs(alpha, self.edge)

    @property
    def limits(self) -> tuple[tuple[sympy.Expr, ...], tuple[sympy.Expr, ...]]:
        """Coefficients of T and of T⁻¹ at α = 0, from ``φ = c₁ α + c₃ α³ + …``."""
        first, third = (self.phi.diff(alpha, k).subs(alpha, 0) / sympy.factorial(k) for k in (1, 3))
        sixth, bend = sympy.Rational(1, 6), 2 * third / first
        tangent = 1 / first, 1 / (2 * first**2), (sixth - bend) / first**3
        return tangent, (first, -sympy.Rational(1, 2), bend / first + sixth / (2 * first))

    @property
    def closed_inverse(self) -> sympy.Expr | None:
        """Closed form of φ⁻¹, with `families.alpha` in place of |v|; None if no form is found."""
        return closed_inverse(self.phi)

    def inverse(self, size: Any) -> Any:
        """Return φ⁻¹ of a length below `range`, in the working precision of mpmath."""
        return angle_of(self.phi, self.edge, mpmath.mpf(size))

    def latex(self) -> str:
        """Return φ and the four maps as LaTeX."""
        maps = (self.quaternion, self.tensor, self.tangent, self.tangent_inv)
        lines = [rf"\varphi &= {sympy.latex(self.phi)}", *(f"{of.symbol} &= {of.definition}" for of in maps)]
        separator = " \\\\\n"
        return f"\\begin{{aligned}}\n{separator.join(lines)}\n\\end{{aligned}}"

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex()}$"

    # --- formulas -------------------------------------------------------------------------------------------------

    @cached_property
    def _values(self) -> Any:
        """Scalars and x as expressions in x; in α for a chart that is not algebraic."""
        return self.scalars(x, PLAIN) if self.algebraic else of_angle(self.phi)

    @cached_property
    def quaternion(self) -> QuaternionMap:
        at = self._values
        return self._formula(QuaternionMap, "quaternion", at.s, at.w)

    @cached_property
    def tensor(self) -> IsotropicMap:
        at = self._values
        return self._formula(IsotropicMap, "tensor", 1 - at.x * at.g, at.f, at.g)

    @cached_property
    def tangent(self) -> IsotropicMap:
        at = self._values
        return self._formula(IsotropicMap, "tangent", at.f, at.g, at.h)

    @cached_property
    def tangent_inv(self) -> IsotropicMap:
        at = self._values
        return self._formula(IsotropicMap, "tangent_inv", at.fi / 2, -sympy.Rational(1, 2), at.hi / 2)

    def _formula(self, kind: type[Map], name: str, *coefficients: sympy.Expr) -> Map:
        poles = [f"Re alpha = {angle}" for angle in self.singular_angles if angle != self.edge]
        size = self.phi.subs(alpha, self.edge)
        infinite = size.is_infinite
        end = "v is infinite" if infinite else "v ends, and with it the domain,"
        end = "there is no edge" if self.edge.is_infinite else f"{end} at Re alpha = {self.edge}"
        lost = {"tangent": "loses rank at", "tangent_inv": "pole at"}.get(name, "") if poles else ""
        coefficients = tuple(c + sympy.Integer(0) for c in coefficients)  # Python integers become SymPy numbers
        return kind(
            name=name,
            order=self.order,
            coefficients=tuple(map(sympy.factor, coefficients)) if self.algebraic else coefficients,
            at=lambda at: tuple(c.xreplace({x: at}) for c in coefficients),
            equations=(),
            identities=IDENTITIES[name],
            domain="every dual vector v" if infinite else f"|Re v| < {size}",
            singular="; ".join(filter(None, (f"{lost} {', '.join(poles)}" if lost else "", end))),
            symbol=SYMBOLS[name],
            definition=DEFINITIONS[name].split(" = ", 1)[1],
        )


class QuaternionChart(Parameterized):
    """Chart whose angle and axis follow from its quaternion ``s + w v``."""

    @abstractmethod
    def scalars(self, x: Coefficient, m: Arithmetic) -> DependentScalars: ...

    def back(self, x: Coefficient, fi: Coefficient, m: Arithmetic) -> tuple[Coefficient, Coefficient]:
        return fi, self.scalars(x, m).hi

    def at_angle(self, x: Coefficient, fi: Coefficient, angle: Coefficient, m: Arithmetic) -> DependentScalars:
        """Return scalars with the given f_i and with h_i from it: for any error of f_i, T⁻¹ along the axis is φ′."""
        at = self.scalars(x, m)
        at.fi = fi
        return at

    def direction(self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """Return the sign of sin α on the branch of v.

        For sin α = 0 return the sign of w at half a turn, or the sign of the translation along v at a whole turn.
        """
        return self._direction(self.scalars(x, m), y, m)

    def _direction(self, at: DependentScalars, y: Coefficient, m: Arithmetic) -> Coefficient:
        # at half a turn s is 0 up to rounding; with w > 0 the direction of v is kept
        kept = m.name("kept", m.where(m.less(at.w, 0), 0, NOISE))
        turned = m.name("turned", m.where(m.less(kept + at.s, kept), -at.w, at.w))
        backwards = m.both(m.equal(at.w, 0), m.less(y, 0))
        one = m.name("one", at.s - at.s + 1)  # NaN where x overflows
        return m.name("sign", one * m.where(m.either(m.less(turned, 0), backwards), -1, 1))

    def natural(
        self, x: Coefficient, y: Coefficient, r: Coefficient, m: Arithmetic
    ) -> tuple[Coefficient, Coefficient, Coefficient]:
        at = self.scalars(x, m)
        sign = self._direction(at, y, m)
        return m.name("angle", 2 * m.atan2(r * m.abs(at.w), m.abs(at.s))), at.rate, sign
