r"""The componentwise road: proofs at one order from the definition, independent of the theorems.

:math:`z = (1 + v)^n` is multiplied out as a dual quaternion of six real symbols. Then :math:`\hat q = z/|z|` (CP23
(46)), R is the sandwich ``q̂ r q̂*`` (24), and ω = vect(R' Rᵀ) (68) with every entry differentiated along v'. The
formulas under test are functions of x, expanded at the dual number :math:`x = v \cdot v` by
:math:`f(x) + \varepsilon x^\circ f'(x)`. All residues are polynomials modulo v·v = x, with x° = 2 v·v°. Denominators
and |z|² are multiplied out; a check ensures that their real parts are not zero. No proof for every order is used.
Each statement is also evaluated as printed, at a rational point.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from itertools import chain
from typing import Any

import sympy

from ..algebra.element import Element
from .at_order import CayleyFormulas
from .at_point import AtPoint
from .identity import Check, Claim, Multiplier, Proof, decide
from .notation import (
    I,
    R,
    below,
    conjugate,
    dcay,
    dcay_inv,
    n,
    norm2,
    point,
    q_hat,
    rate,
    transpose,
    v,
    vect,
    x,
    z,
)  # fmt: skip
from .statement import Equation, Premise, definition
from .vector_ring import Ring

NORM = norm2(z)
UNIT = definition(q_hat, z / sympy.sqrt(NORM))
POWER = definition(z, (1 + v) ** n)
ROTATED = definition(R * point, q_hat * point * conjugate(q_hat))
Statement = tuple[str, tuple[Equation, ...], tuple[Premise, ...]]
"""Name, claim and premises."""

STATEMENTS: tuple[Statement, ...] = (
    ("definition at n", (Equation(q_hat**2 * (1 - v) ** n, (1 + v) ** n),), (POWER, UNIT)),
    ("quaternion at n", (Equation(q_hat * (1 + point) * q_hat, z * (1 + point) * z / NORM),), (POWER,)),
    ("tensor at n", (Equation(q_hat * point * conjugate(q_hat), R * point),), (POWER, UNIT)),
    ("orthogonality at n", (Equation(R * transpose(R), I, (13, 72, 73)),), (ROTATED,)),
    ("twist at n", (Equation(vect(rate(R) * transpose(R)), dcay * rate(v)),), (POWER, UNIT, ROTATED)),
    ("inverse at n", (Equation(dcay * dcay_inv, I),), ()),
)
"""Statements of the componentwise road."""

METHOD = "componentwise from the definition, exact polynomials in v1 v2 v3 and their dual parts"
CYCLIC = ((2, 1), (0, 2), (1, 0))  # vect(T) takes T_32 - T_23, T_13 - T_31, T_21 - T_12


class _Dual:
    """Dual number ``re + ε du`` over the exact ring, independent of the class `Dual` that formulas use."""

    __slots__ = ("du", "re")

    def __init__(self, re: Element, du: Element) -> None:
        self.re, self.du = re, du

    def __add__(self, other: _Dual) -> _Dual:
        return _Dual(self.re + other.re, self.du + other.du)

    def __sub__(self, other: _Dual) -> _Dual:
        return _Dual(self.re - other.re, self.du - other.du)

    def __neg__(self) -> _Dual:
        return _Dual(-self.re, -self.du)

    def __mul__(self, other: _Dual) -> _Dual:
        return _Dual(self.re * other.re, self.re * other.du + self.du * other.re)

    def derivative(self, name: str) -> _Dual:
        derivative = self.re.ring.derivative
        return _Dual(derivative(self.re, name), derivative(self.du, name))


_Row = list[_Dual]


def _sum(terms: Iterator[_Dual] | Sequence[_Dual]) -> _Dual:
    first, *rest = terms
    for term in rest:
        first = first + term
    return first


def hamilton(a: Sequence[_Dual], b: Sequence[_Dual]) -> _Row:
    """Return Hamilton's product of quaternions, with i j = k and its cyclic permutations."""
    return [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]


def _conjugate(a: Sequence[_Dual]) -> _Row:
    return [a[0], -a[1], -a[2], -a[3]]


class Components:
    """Definition and formulas of one Cayley map, expanded in six real symbols.

    Parameters
    ----------
    cayley : CayleyFormulas
        Map to prove, e.g. ``derive.Cayley(7)``.
    backend : {"flint", "sympy"}, optional
        Polynomial library of the exact ring.
    """

    def __init__(self, cayley: CayleyFormulas, backend: str | None = None) -> None:
        self.cayley = cayley
        self.ring = Ring(vectors=("v",), extra=("d1", "d2", "d3"), backend=backend)
        zero = self.ring.constant(0)
        self.zero, self.one = _Dual(zero, zero), _Dual(self.ring.constant(1), zero)
        self.v = [_Dual(self.ring.symbol(f"v{i}"), self.ring.symbol(f"d{i}")) for i in (1, 2, 3)]
        self.x = _sum([c * c for c in self.v])
        self.z = self.defined()
        self.norm = _sum([c * c for c in self.z])  # |z|²
        units = [[self.one if i == k else self.zero for i in range(4)] for k in (1, 2, 3)]
        images = [self.sandwich(unit)[1:] for unit in units]
        self.rotation = [list(row) for row in zip(*images, strict=True)]  # |z|² R

    def defined(self) -> _Row:
        """Return (1 + v)ⁿ."""
        return self.power([self.one, *self.v])

    def sandwich(self, r: _Row) -> _Row:
        """Return z r z*."""
        return hamilton(hamilton(self.z, r), _conjugate(self.z))

    def power(self, base: _Row) -> _Row:
        """Return the n-th power of a quaternion."""
        result = [self.one, self.zero, self.zero, self.zero]
        for bit in f"{self.cayley.order:b}":
            result = hamilton(result, result)
            if bit == "1":
                result = hamilton(result, base)
        return result

    def _at_dual(self, polynomial: Element) -> _Dual:
        """Return f(x) + ε x° f'(x)."""
        return _Dual(polynomial, self.x.du * self.ring.derivative(polynomial, "x"))

    def _expand(self, coefficients: Sequence[Any]) -> tuple[_Row, _Dual]:
        """Return the numerators of coefficients at the dual x, and their common denominator."""
        lifted = [self.ring.lift(coefficient, {x: self.x.re}) for coefficient in coefficients]
        numerators, denominator = self.ring.cleared(lifted)
        return [self._at_dual(numerator) for numerator in numerators], self._at_dual(denominator)

    def _isotropic(self, coefficients: Sequence[Any]) -> tuple[list[_Row], _Dual]:
        """Return the entries of a I + b skew(v) + c v⊗v, and their common denominator."""
        (a, b, c), denominator = self._expand(coefficients)
        v1, v2, v3 = self.v
        skew = [[self.zero, -v3, v2], [v3, self.zero, -v1], [-v2, v1, self.zero]]
        scaled = [c * component for component in self.v]
        matrix = [[b * skew[i][j] + scaled[i] * self.v[j] for j in range(3)] for i in range(3)]
        for i in range(3):
            matrix[i][i] = matrix[i][i] + a
        return matrix, denominator

    def definition(self) -> Iterator[Check | Multiplier]:
        """Decide (z/|z|)² (1 - v)ⁿ = (1 + v)ⁿ."""
        yield _multiplier(NORM, self.norm)
        product = hamilton(self.z, self.power(_conjugate([self.one, *self.v])))
        for k, value in enumerate(product):
            yield from _checks(f"z (1-v)^n - |z|^2, component {k}", value - self.norm if k == 0 else value)

    def quaternion(self) -> Iterator[Check | Multiplier]:
        """Decide q̂ ⊗ q̂ = z ⊗ z / |z|², which fixes the quaternion up to its sign."""
        s, t = self.cayley.quaternion.coefficients
        (ss, st, tt), denominator = self._expand((s * s, s * t, t * t))
        yield _multiplier(NORM, self.norm)
        yield _multiplier(below(q_hat), denominator)
        formula = [[ss] + [st * c for c in self.v]] + [[tt * a * b for b in self.v] for a in self.v]
        for i in range(4):
            for j in range(i, 4):
                stated = formula[0][j] if i == 0 else formula[i][j - 1]
                residue = self.z[i] * self.z[j] * denominator - self.norm * stated
                yield from _checks(f"q_{i} q_{j}", residue)

    def tensor(self) -> Iterator[Check | Multiplier]:
        """Decide whether R from the sandwich equals a I + b skew(v) + c v⊗v."""
        formula, denominator = self._isotropic(self.cayley.tensor.coefficients)
        yield _multiplier(NORM, self.norm)
        yield _multiplier(below(R), denominator)
        for i in range(3):
            for j in range(3):
                residue = self.rotation[i][j] * denominator - self.norm * formula[i][j]
                yield from _checks(f"R_{i + 1}{j + 1}", residue)

    def orthogonality(self) -> Iterator[Check | Multiplier]:
        """Decide R Rᵀ = I by six entries, since the product is symmetric."""
        yield _multiplier(NORM, self.norm, 2)
        square = self.norm * self.norm
        for i in range(3):
            for j in range(i, 3):
                product = _sum([self.rotation[i][k] * self.rotation[j][k] for k in range(3)])
                yield from _checks(f"(R R^T)_{i + 1}{j + 1}", product - square if i == j else product)

    def twist(self) -> Iterator[Check | Multiplier]:
        """Decide vect(R' Rᵀ) = dcay v' in the three dual basis directions.

        With R = M/|z|², R' Rᵀ = M' Mᵀ/|z|⁴ + (scalar) R Rᵀ, and the second term is symmetric.
        """
        formula, denominator = self._isotropic(self.cayley.tangent.coefficients)
        yield _multiplier(NORM, self.norm, 2)
        yield _multiplier(below(dcay), denominator)
        square = self.norm * self.norm
        for direction in range(3):
            rate = [[entry.derivative(f"v{direction + 1}") for entry in row] for row in self.rotation]
            for i, (a, b) in enumerate(CYCLIC):
                twice = _sum([rate[a][k] * self.rotation[b][k] - rate[b][k] * self.rotation[a][k] for k in range(3)])
                stated = square * formula[i][direction]
                yield from _checks(f"omega_{i + 1} along e{direction + 1}", twice * denominator - stated - stated)
            for i in range(9):  # the rate along ε e_j is ε times the rate along e_j
                entry, along = self.rotation[i // 3][i % 3], rate[i // 3][i % 3]
                dual_rate = entry.derivative(f"d{direction + 1}")
                yield from _checks(f"rate {i} along eps e{direction + 1}", dual_rate - _Dual(self.zero.re, along.re))

    def inverse(self) -> Iterator[Check | Multiplier]:
        """Decide dcay dcay⁻¹ = I."""
        tangent, below_tangent = self._isotropic(self.cayley.tangent.coefficients)
        inverse, below_inverse = self._isotropic(self.cayley.tangent_inv.coefficients)
        yield _multiplier(below(dcay), below_tangent)
        yield _multiplier(below(dcay_inv), below_inverse)
        unit = below_tangent * below_inverse
        for i in range(3):
            for j in range(3):
                product = _sum([tangent[i][k] * inverse[k][j] for k in range(3)])
                yield from _checks(f"(dcay dcay^-1)_{i + 1}{j + 1}", product - unit if i == j else product)

    def proofs(self, statements: Sequence[Statement] | None = None) -> Iterator[Proof]:
        """Decide the statements one after the other; controls pass altered statements."""
        point = AtPoint(self.cayley.order)
        checks = (self.definition, self.quaternion, self.tensor, self.orthogonality, self.twist, self.inverse)
        for (name, claim, premises), decision in zip(statements or STATEMENTS, checks, strict=True):
            equations = (*claim, *(premise.equation for premise in premises))
            printed = (check for equation in equations for check in point.checks(equation))
            claimed = Claim(name, claim, METHOD, premises)
            yield decide(claimed, partial(chain, printed, decision()), f"n = {self.cayley.order}")


def _checks(label: str, value: _Dual) -> Iterator[Check]:
    yield f"{label}, real part", value.re
    yield f"{label}, dual part", value.du


def _multiplier(term: sympy.Expr, value: _Dual, power: int = 1) -> Multiplier:
    """Return a dual number as a multiplier, which is not a zero divisor if its real part is not zero."""
    return Multiplier(term, power, bool(value.re))


