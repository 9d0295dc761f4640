r"""Dual Rodrigues vector and the dual Cayley formula, K10 (Karakılıç 2010, "The dual Rodrigues parameters").

An orthogonal dual tensor A with dual angle ``f + ε f*`` about the unit dual vector ŝ (its screw axis) has

.. math:: B = (A - I)(A + I)^{-1} = \widetilde{b}, \qquad A = (I + B)(I - B)^{-1}, \qquad
        b = \tan\tfrac{f + ε f^*}{2}\,ŝ

The vector b is v of order n = 1. Components are in the space frame, in the order of the basis.
"""

from __future__ import annotations

from typing import Any

from ..algebra import Tensor, Vector, functions


def cayley_matrix(A: Tensor) -> Tensor:
    """Return ``B = (A − I)(A + I)⁻¹``, K10 section 2: skew-symmetric where A is orthogonal.

    Raises
    ------
    ZeroDivisionError
        If ``A + I`` is exactly singular: at a half turn, and for every reflection.
    """
    unit = Tensor.identity()
    B: Tensor = (A - unit) @ (A + unit).inverse()
    return B


def cayley_formula(b: Vector) -> Tensor:
    """Return ``A = (I + B)(I − B)⁻¹`` with ``B = skew(b)``, K10's Cayley formula; ``det(I − B) = 1 + b·b``."""
    unit, B = Tensor.identity(), Tensor.skew(b)
    A: Tensor = (unit + B) @ (unit - B).inverse()
    return A


def rodrigues_vector(A: Tensor) -> Vector:
    """Return b with ``A x − x = b × (A x + x)`` for all x, from the invariants: ``b = 2 vect A / (1 + tr A)``.

    No inverse is taken, so the result is independent of `cayley_matrix`. Singular at half turns.
    """
    b: Vector = A.vect() * 2 / (1 + A.trace())
    return b


def direction(b: Vector, library: Any = functions) -> Vector:
    """Return ``ŝ = b/|b|`` of a dual vector, K10 (7): the unit dual Rodrigues vector.

    Parameters
    ----------
    b : Vector
        Dual vector with non-zero real part.
    library
        Provides ``sqrt`` of its coefficients.
    """
    s: Vector = b / library.sqrt(b.dot(b))
    return s
