r"""Proof by components at one order, from the definition, independent of the theorems.

:math:`z = (1 + v)^n` is multiplied out as a dual quaternion of six real symbols. Then :math:`\hat q = z/|z|` (CP23
(46)), R is the sandwich ``q̂ r q̂*`` (24), and ω = vect(R' Rᵀ) (68), with R' as the derivative along v'. The
formulas under test are functions of x, expanded at the dual number :math:`x = v \cdot v` by
:math:`f(x) + \varepsilon x^\circ f'(x)`. All residues are polynomials modulo v·v = x, with x° = 2 v·v°. Denominators
and |z|² are multiplied out; a check ensures that their real parts are not zero. No theorem for all n is used.
Each statement is also evaluated as printed, at a rational point.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial, reduce
from itertools import chain, combinations_with_replacement
from typing import Any

import sympy

from ..algebra.element import Element
from ..maps import Cayley
from . import notation as m
from .evaluation import AtPoint
from .identity import Checks, Equation, Multiplier, Premise, Proof, decide, definition
from .rings import Ring

NORM = m.norm2(m.z)
UNIT = definition(m.q_hat, m.z / sympy.sqrt(NORM))
POWER = definition(m.z, (1 + m.v) ** m.n)
SANDWICH = m.q_hat * m.point * m.conjugate(m.q_hat)
ROTATED = definition(m.R * m.point, SANDWICH)
TWICE = (m.q_hat * (1 + m.point) * m.q_hat, m.z * (1 + m.point) * m.z / NORM)
Statement = tuple[str, tuple[Equation, ...], tuple[Premise, ...]]
"""Name, claim and premises."""

STATEMENTS: tuple[Statement, ...] = (
    ("definition at n", (Equation(m.q_hat**2 * (1 - m.v) ** m.n, (1 + m.v) ** m.n),), (POWER, UNIT)),
    ("quaternion at n", (Equation(*TWICE),), (POWER,)),
    ("tensor at n", (Equation(SANDWICH, m.R * m.point),), (POWER, UNIT)),
    ("orthogonality at n", (Equation(m.R * m.transpose(m.R), m.I, (13, 72, 73)),), (ROTATED,)),
    ("twist at n", (Equation(m.vect(m.rate(m.R) * m.transpose(m.R)), m.dcay * m.rate(m.v)),), (POWER, UNIT, ROTATED)),
    ("inverse at n", (Equation(m.dcay * m.dcay_inv, m.I),), ()),
)
"""Statements proved by components."""

METHOD = "components from the definition, exact polynomials in v1 v2 v3 and their dual parts"
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


Row = Sequence[_Dual]
"""Vector, quaternion, or row of a matrix."""

Matrix = Sequence[Row]


def dot(a: Row, b: Row) -> _Dual:
    return reduce(_Dual.__add__, map(_Dual.__mul__, a, b))


def times(a: Any, factor: _Dual) -> Any:
    """Return a dual number, row or matrix times a dual number."""
    return a * factor if isinstance(a, _Dual) else [times(part, factor) for part in a]


def minus(a: Any, b: Any) -> Any:
    """Return the difference of dual numbers, rows or matrices."""
    return a - b if isinstance(a, _Dual) else [minus(*parts) for parts in zip(a, b, strict=True)]


def hamilton(a: Row, b: Row) -> Row:
    """Return Hamilton's product of quaternions, with i j = k and its cyclic permutations."""
    return [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]  # fmt: skip


def _conjugate(a: Row) -> Row:
    return [a[0], -a[1], -a[2], -a[3]]


class Components:
    """Definition and formulas of one Cayley map, expanded in six real symbols."""

    def __init__(self, cayley: Cayley) -> None:
        self.cayley = cayley
        self.ring = Ring(extra=("d1", "d2", "d3"))
        self.zero, self.one = (_Dual(self.ring.constant(k), self.ring.constant(0)) for k in (0, 1))
        self.identity = [[self.one if i == j else self.zero for j in range(4)] for i in range(4)]
        self.v = [_Dual(part, self.ring.symbol(f"d{i}")) for i, part in enumerate(self.ring.v, 1)]
        self.one_plus_v = [self.one, *self.v]
        self.x = dot(self.v, self.v)
        self.z = self.defined()
        self.norm = dot(self.z, self.z)  # |z|²
        self.rotation: Matrix = list(zip(*map(self.sandwich, self.identity[1:]), strict=True))[1:]  # |z|² R

    def defined(self) -> Row:
        return self.power(self.one_plus_v)

    def sandwich(self, r: Row) -> Row:
        return hamilton(hamilton(self.z, r), _conjugate(self.z))

    def power(self, base: Row) -> Row:
        result: Row = self.identity[0]
        for bit in f"{self.cayley.order:b}":
            result = hamilton(result, result)
            if bit == "1":
                result = hamilton(result, base)
        return result

    def _at_dual(self, polynomial: Element) -> _Dual:
        """Return f(x) + ε x° f'(x)."""
        return _Dual(polynomial, self.x.du * self.ring.derivative(polynomial, "x"))

    def _expand(self, coefficients: Sequence[Any]) -> tuple[list[_Dual], _Dual]:
        """Return the numerators of coefficients at the dual x, and their common denominator."""
        lifted = [self.ring.lift(coefficient, {m.x: self.x.re}) for coefficient in coefficients]
        numerators, denominator = self.ring.cleared(lifted)
        return [self._at_dual(numerator) for numerator in numerators], self._at_dual(denominator)

    def _isotropic(self, coefficients: Sequence[Any]) -> tuple[Matrix, _Dual]:
        """Return the entries of a I + b skew(v) + c v⊗v, and their common denominator."""
        (a, b, c), denominator = self._expand(coefficients)
        v1, v2, v3 = self.v
        others = [[a, -v3 * b, v2 * b], [v3 * b, a, -v1 * b], [-v2 * b, v1 * b, a]]
        rows = zip(self.v, others, strict=True)
        return [[p * c * q + entry for q, entry in zip(self.v, row, strict=True)] for p, row in rows], denominator

    def definition(self) -> Checks:
        """Decide (z/|z|)² (1 - v)ⁿ = (1 + v)ⁿ."""
        yield _multiplier(NORM, self.norm)
        product = hamilton(self.z, self.power(_conjugate(self.one_plus_v)))
        yield from _checks("z (1-v)^n - |z|^2", minus(product, times(self.identity[0], self.norm)))

    def quaternion(self) -> Checks:
        """Decide q̂ ⊗ q̂ = z ⊗ z / |z|², an equation that determines q̂ up to its sign."""
        s, t = self.cayley.quaternion.coefficients
        (ss, st, tt), denominator = self._expand((s * s, s * t, t * t))
        yield _multiplier(NORM, self.norm)
        yield _multiplier(m.below(m.q_hat), denominator)
        for i, j in combinations_with_replacement(range(4), 2):
            weight = tt if i else st if j else ss
            stated = weight * self.one_plus_v[i] * self.one_plus_v[j]
            yield from _checks(f"q_{i} q_{j}", self.z[i] * self.z[j] * denominator - self.norm * stated)

    def tensor(self) -> Checks:
        """Decide whether R from the sandwich equals a I + b skew(v) + c v⊗v."""
        formula, denominator = self._isotropic(self.cayley.tensor.coefficients)
        yield _multiplier(NORM, self.norm)
        yield _multiplier(m.below(m.R), denominator)
        yield from _checks("R", minus(times(self.rotation, denominator), times(formula, self.norm)))

    def orthogonality(self) -> Checks:
        """Decide R Rᵀ = I by six entries, since the product is symmetric."""
        yield _multiplier(NORM, self.norm, 2)
        unit = times(self.identity, self.norm * self.norm)
        for i, j in combinations_with_replacement(range(3), 2):
            yield from _checks(f"(R R^T)_{i + 1}{j + 1}", dot(self.rotation[i], self.rotation[j]) - unit[i][j])

    def twist(self) -> Checks:
        """Decide vect(R' Rᵀ) = dcay v' in the three dual basis directions.

        With R = M/|z|², R' Rᵀ = M' Mᵀ/|z|⁴ + (scalar) R Rᵀ, and the second term is symmetric.
        """
        formula, denominator = self._isotropic(self.cayley.tangent.coefficients)
        yield _multiplier(NORM, self.norm, 2)
        yield _multiplier(m.below(m.dcay), denominator)
        square = self.norm * self.norm
        for direction in range(3):
            rate = self._rate(f"v{direction + 1}")
            for i, (a, b) in enumerate(CYCLIC):
                twice = dot(rate[a], self.rotation[b]) - dot(rate[b], self.rotation[a])
                stated = square * formula[i][direction]
                yield from _checks(f"omega_{i + 1} along e{direction + 1}", twice * denominator - stated - stated)
            along = [[_Dual(self.zero.re, entry.re) for entry in row] for row in rate]
            dual_rate = self._rate(f"d{direction + 1}")  # the rate along ε e_j must be ε times the rate along e_j
            yield from _checks(f"rate along eps e{direction + 1}", minus(dual_rate, along))

    def _rate(self, name: str) -> Matrix:
        """Return the derivative of |z|² R by a component of v or of its dual part."""
        return [[entry.derivative(name) for entry in row] for row in self.rotation]

    def inverse(self) -> Checks:
        """Decide dcay dcay⁻¹ = I."""
        tangent, below_tangent = self._isotropic(self.cayley.tangent.coefficients)
        inverse, below_inverse = self._isotropic(self.cayley.tangent_inv.coefficients)
        yield _multiplier(m.below(m.dcay), below_tangent)
        yield _multiplier(m.below(m.dcay_inv), below_inverse)
        product = [[dot(row, column) for column in zip(*inverse, strict=True)] for row in tangent]
        unit = times([row[1:] for row in self.identity[1:]], below_tangent * below_inverse)
        yield from _checks("dcay dcay^-1", minus(product, unit))

    def proofs(self, statements: Sequence[Statement] = STATEMENTS) -> Iterator[Proof]:
        """Decide the statements one after the other; controls pass altered statements."""
        point = AtPoint(self.cayley.order)
        checks = (self.definition, self.quaternion, self.tensor, self.orthogonality, self.twist, self.inverse)
        for (name, claim, premises), decision in zip(statements, checks, strict=True):
            equations = (*claim, *(premise.equation for premise in premises))
            printed = (check for equation in equations for check in point.checks(equation))
            everything = partial(chain, printed, decision())
            yield decide(name, claim, METHOD, everything, f"n = {self.cayley.order}", premises)


def _checks(label: str, value: Any, *place: int) -> Checks:
    """Yield both parts of each entry of a dual number, row or matrix."""
    if isinstance(value, _Dual):
        yield f"{label}{list(place) or ''}, real part", value.re
        yield f"{label}{list(place) or ''}, dual part", value.du
    else:
        for i, entry in enumerate(value):
            yield from _checks(label, entry, *place, i)


def _multiplier(term: sympy.Expr, value: _Dual, power: int = 1) -> Multiplier:
    """Return a dual number as a multiplier; a nonzero real part certifies that it is no zero divisor."""
    return Multiplier(term, power, bool(value.re))
