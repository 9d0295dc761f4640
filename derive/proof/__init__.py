"""Proofs: identities decided exactly, for every order n at once and, on a second road, at each order asked for.

====================== ==============================================================================
marks                  the letters and marks of statements, SymPy expressions, and how they are printed
statement              `Equation`, and `Premise`: what a theorem takes as given
identity               `Proof`, and `decide`: every residue is zero, no multiplier is
differential_ring      polynomials modulo relations, localized, with a derivation; n stays a symbol
evaluation             what an expression is, once its letters have values
setting                the values that premises give, in such a ring
theorem                `Theorem`: what it claims, takes as given, and supposes with others that it rests on
methods                to decide one: as an identity, or by a start and a law
coefficients           series with binomial coefficients, decided for all n and j
formulas               the coefficients of R, dcay and its inverse that the theorems speak of
polynomial_theorems    theorems on p_n, q_n for all n
map_theorems           theorems on tensor, quaternion and tangent operators for all n
displacement_theorems  theorems on screws, poses, lines, shadows and composition
calculus_theorems      theorems on derivatives of the tangent operators
transport_theorems     theorems on rates where branches change, and on twists of products
every_order            all of these, proved once per process
at_order               the formulas of one order are the theorems' instances
computations           and so is what `derive.maps` computes in other ways
exact, element         the exact ring of vector components modulo v·v = x
polynomial_backend     its polynomials, by python-flint or SymPy
ratio                  rational functions as numbers, with roots of squares and sines of given angles
components             the componentwise road at one order, from the definition
at_point               statements about one order, evaluated as printed
scalars                the scalars of any algebraic chart are its formulas, and those of its φ
any_phi                theorems on every parameterization v = φ(α) u
limit_theorems         theorems on what maps tend to as the order grows, and how fast
instances_of_phi       the formulas of a chart in α are their instances
proved                 `Proved` and the way to it
controls               every theorem and every check with one thing wrong, which must fail
coverage               which theorem, or which validation, covers each kernel function
page                   all of this as Markdown
====================== ==============================================================================

``python -m derive.proof`` proves everything and sees all controls fail.
"""

from __future__ import annotations

from ..algebra.element import Element
from .every_order import citing, theorems
from .identity import Proof, decide
from .proved import ProofFailed, Proved, proofs, prove
from .scalars import is_algebraic, root_of
from .vector_ring import Ring

__all__ = [
    "Element", "Proof", "ProofFailed", "Proved", "Ring", "citing", "decide", "is_algebraic", "proofs", "prove",
    "root_of", "theorems",
]  # fmt: skip
