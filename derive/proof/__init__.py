"""Exact proofs of identities, for every order n at once and, independently, at each requested order.

====================== =========================================================================
notation               symbols and operators of statements, as SymPy expressions, and their printers
statement              `Equation` and `Premise`
identity               `Proof` and `decide`: all residues must be 0, all multipliers nonzero
theorem                `Theorem`: claim, premises and method
methods                decisions by identity, by induction on n, or by a differential equation
coefficients           power series with binomial coefficients, decided for all n and j
evaluation             values of expressions, given the values of their symbols
setting                a differential ring in which the premises of a theorem hold
differential_ring      rational functions with relations and a derivation; n stays a symbol
formulas               coefficients of R, dcay and its inverse in the theorems
polynomial_theorems    theorems for all n on p_n and q_n
map_theorems           theorems for all n on tensor, quaternion and tangent operators
displacement_theorems  theorems for all n on screws, poses, lines, shadows and composition
calculus_theorems      theorems for all n on derivatives of the tangent operators
transport_theorems     theorems for all n on rates at changes of branch, and on twists of products
phi_theorems           theorems on every parameterization v = φ(α) u
limit_theorems         theorems on the limit of growing order, and its rate
at_order               formulas and functions of one order as instances of the theorems
scalars                formulas of a chart, compared with its scalars and its φ
vector_ring            `Ring`: components of a vector modulo v·v = x
components             proof by components at one order, from the definition
texts                  formulas in docstrings and comments, read and compared
at_point               printed statements about one order, evaluated at a rational point
proved                 all theorems for all n; `Proved`: a chart with its proofs, made only by `prove`
controls               altered theorems, formulas and definitions, which must fail
series_certificate     sums of binomials and their laws as integer lists
certificate            certificate of a proof: both sides of its equations as integer lists
coverage               theorems and validation behind each kernel function
page                   docs/theorems.md
sheet                  lines of the formula sheet
====================== =========================================================================

``python -m derive.proof`` proves everything and runs all controls.
"""

from __future__ import annotations

from ..algebra.element import Element
from .identity import Proof, decide
from .proved import ProofFailed, Proved, citing, proofs, prove, shown, theorems
from .scalars import is_algebraic, root_of
from .vector_ring import Ring

__all__ = [
    "Element", "Proof", "ProofFailed", "Proved", "Ring", "citing", "decide", "is_algebraic", "proofs", "prove",
    "root_of", "shown", "theorems",
]  # fmt: skip
