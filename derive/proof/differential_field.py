r"""The field in which identities are decided for every order n at once.

n, x and the two polynomials are independent symbols of :math:`F = \mathbb{Q}(n, x)(p, q)`, with the derivation

.. math:: x' = 1, \quad p' = \frac{n (p - q)}{2 (1 + x)}, \quad q' = \frac{1}{2 x}
          \left[\frac{n (p + x q)}{1 + x} - q\right]

which p_n, q_n satisfy for every n (proved by induction in :mod:`~derive.proof.induction`). An identity of F therefore
becomes one of rational functions of x, or of v, at every n. It holds for dual x and v as well, wherever the real parts
of the denominators do not vanish.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any, TypeVar

import sympy
from sympy.polys.fields import field

from ..algebra import Coefficient, Quaternion, Tensor, Vector
from .identity import Check

Triple = tuple[Coefficient, Coefficient, Coefficient]
Moving = TypeVar("Moving", Tensor, Quaternion)
CoefficientsOfOrder = Callable[[Coefficient, Coefficient, Coefficient, Coefficient], Triple]


def p_slope(n: Coefficient, x: Coefficient, p: Coefficient, q: Coefficient) -> Coefficient:
    """dp_n/dx."""
    return n * (p - q) / (2 * (1 + x))


def q_slope(n: Coefficient, x: Coefficient, p: Coefficient, q: Coefficient) -> Coefficient:
    """dq_n/dx."""
    return (n * (p + x * q) / (1 + x) - q) / (2 * x)


def tensor(n: Coefficient, x: Coefficient, p: Coefficient, q: Coefficient) -> Triple:
    """Coefficients of I, skew(v), v⊗v in R, CP23 (57) with skew(v)² = v⊗v − x I."""
    power = p * p + x * q * q
    return 1 - 2 * x * q * q / power, 2 * p * q / power, 2 * q * q / power


def tangent(n: Coefficient, x: Coefficient, p: Coefficient, q: Coefficient) -> Triple:
    """Coefficients of I, skew(v), v⊗v in dcay, CP23 (88)."""
    power = p * p + x * q * q
    bracket = (n * power / (1 + x) - p * q) / x
    return 2 * p * q / power, 2 * q * q / power, 2 * bracket / power


def tangent_inv(n: Coefficient, x: Coefficient, p: Coefficient, q: Coefficient) -> Triple:
    """Coefficients of I, skew(v), v⊗v in the inverse of dcay, CP23 (89)."""
    bracket = ((1 + x) * q - n * p) / x
    return p / (2 * q), (x - x - 1) / 2, bracket / (2 * n * q)


@dataclass(frozen=True)
class Formulas:
    """The formulas the theorems speak of, each a function of (n, x, p_n, q_n)."""

    tensor: CoefficientsOfOrder = tensor
    tangent: CoefficientsOfOrder = tangent
    tangent_inv: CoefficientsOfOrder = tangent_inv


class Setting:
    """F with the components of a vector adjoined, ``v3² = square − v1² − v2²``, and the derivation carried along.

    Parameters
    ----------
    square : {"x", "1"}
        The square of the vector: x for v itself, 1 for a unit vector (then p, q are functions of x = X², X = |v|).
    """

    def __init__(self, square: str = "x") -> None:
        field_, n, x, p, q, v1, v2, v3 = field("n,x,p,q,v1,v2,v3" if square == "x" else "n,X,p,q,v1,v2,v3", sympy.QQ)
        self.zero, self.one = field_.zero, field_.one
        self.n, self.p, self.q = n, p, q
        self.x = x if square == "x" else x * x
        self.variable = x
        self.components = (v1, v2, v3)
        self.v = Vector(v1, v2, v3)
        self._relation = (v3**2 + v2**2 + v1**2 - (x if square == "x" else self.one)).numer

    @property
    def symbols(self) -> tuple[Coefficient, Coefficient, Coefficient, Coefficient]:
        """n, x, p, q: the arguments of a formula."""
        return self.n, self.x, self.p, self.q

    @property
    def power(self) -> Coefficient:
        """(1 + x)ⁿ as p² + x q², which it equals for every n."""
        return self.p**2 + self.x * self.q**2

    def isotropic(self, coefficients: Triple, factor: Coefficient = 1) -> Tensor:
        """``a I + b skew(v) + c v⊗v``, entry by entry, times a factor that clears the denominators."""
        a, b, c = (factor * coefficient for coefficient in coefficients)
        tensor: Tensor = Tensor.identity() * a + Tensor.skew(self.v) * b + Tensor.dyad(self.v, self.v) * c
        return tensor

    def slope(self, value: Coefficient) -> Coefficient:
        """Derivative by the generator (x, or X), which p and q follow and the components do not."""
        element = self.zero + value
        chain = self.x.diff(self.variable)
        by_p, by_q = element.diff(self.p), element.diff(self.q)
        inner = p_slope(*self.symbols) * by_p + q_slope(*self.symbols) * by_q
        return element.diff(self.variable) + chain * inner

    def rates(self, structure: Moving, factor: Coefficient) -> Iterator[Moving]:
        """Derivative with respect to v1, then v2, then v3, which x = v·v, p and q follow; each times the factor."""
        slope = structure.map(lambda value: factor * self.slope(value))
        for component in self.components:
            explicit = structure.map(partial(self._explicit_rate, component, factor))
            yield explicit + slope * (2 * component)

    def _explicit_rate(self, component: Coefficient, factor: Coefficient, value: Coefficient) -> Coefficient:
        return factor * (self.zero + value).diff(component)

    def residue(self, value: Coefficient) -> Any:
        """The numerator modulo the relation between the components: zero exactly when the value is."""
        return (self.zero + value).numer.rem([self._relation])

    def entries(self, label: str, difference: Tensor | Vector) -> Iterator[Check]:
        """The residue of every entry."""
        for i, value in enumerate(difference):
            place = f"({i // 3 + 1}, {i % 3 + 1})" if isinstance(difference, Tensor) else f"{i + 1}"
            yield f"{label}, entry {place}", self.residue(value)
