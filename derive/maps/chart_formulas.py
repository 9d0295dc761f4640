"""Formulas of a chart: the four maps with their texts, from φ and the scalars."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable
from functools import cached_property
from typing import Any, TypeAlias, TypeVar

import mpmath
import sympy
from sympy.core.traversal import bottom_up

from ..algebra import Coefficient
from ..algebra.arithmetic import PLAIN, Arithmetic
from ..algebra.latex import Typeset, latex
from .angle import angle_of
from .elementary import alpha, elementary, of_angle
from .formula import Formula, IsotropicMap, QuaternionMap
from .polynomials import x

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


class ChartFormulas(Typeset, ABC):
    """Formulas of a `Chart`, as expressions in x or α."""

    order: int  # order n; 1 for a chart without an order

    @property
    @abstractmethod
    def phi(self) -> sympy.Expr:
        """Odd function φ of `elementary.alpha`, increasing up to the edge."""

    @property
    @abstractmethod
    def edge(self) -> sympy.Expr:
        """Largest Re α of the chart: a pole of φ or a zero of φ′; infinite for a chart without an edge."""

    @property
    @abstractmethod
    def singular_angles(self) -> tuple[sympy.Expr, ...]:
        """Angles Re α > 0 where v, T or T⁻¹ is singular; the edge, if any, comes last."""

    @property
    def algebraic(self) -> bool:
        """Tell whether the formulas are algebraic in x, with at most one root sqrt(1 + x/k), k an integer."""
        return True

    @abstractmethod
    def scalars(self, x: Coefficient, m: Arithmetic) -> Scalars:
        """Return the scalars at x."""

    @abstractmethod
    def unfolded(self, x: Coefficient, r: Coefficient, m: Arithmetic) -> Coefficient:
        """Return the angle of ``v = r u``, r > 0, on the branch of v."""

    # --- from φ ---------------------------------------------------------------------------------------------------

    @property
    def written(self) -> sympy.Expr:
        """Formula of φ in elementary functions, which may be 0/0 at α = 0."""
        return elementary(self.phi)

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
        first = ((r"\varphi(\alpha)", latex(self.written)), *LETTERS, *letters)
        equations = (*first, *((of.symbol, of.definition) for of in maps))
        lines = " \\\\\n".join(f"{left} &= {right}" for left, right in equations)
        return f"\\begin{{aligned}}\n{lines}\n\\end{{aligned}}"

    def _typeset(self) -> str:
        return self.latex()

    @cached_property
    def _values(self) -> Any:
        """Scalars and x, as expressions in x for an algebraic chart, otherwise in α."""
        return self.scalars(x, PLAIN) if self.algebraic else of_angle(self.written)

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
        tangent, tangent_inv = self.limits
        f, g, _ = tangent
        of_tensors = {"tensor": (sympy.Integer(1), f, g), "tangent": tangent, "tangent_inv": tangent_inv}
        return {"quaternion": (sympy.Integer(1), f / 2), **of_tensors}


def factored(expression: sympy.Expr) -> sympy.Expr:
    """Return the factors of an expression, with products that SymPy keeps when it rebuilds them, as copies do."""
    return bottom_up(sympy.factor(expression), lambda e: e.func(*e.args) if e.args else e)
