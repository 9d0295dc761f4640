"""Proofs: identities decided exactly, for every order n at once and, on a second road, at each order asked for.

==================== ==============================================================================
identity             `Proof`, and `decide`: every residue is zero
differential_field   Q(n, x)(p, q) with a derivation, in which n stays a symbol
induction            theorems on p_n, q_n for all n
map_theorems         theorems on tensor, quaternion and tangent operators for all n
every_order          all of these, proved once per process
at_order             the formulas of one order are the theorems' instances
exact, element       the exact ring of vector components modulo v·v = x
polynomial_backend   its polynomials, by python-flint or SymPy
ratio                rational functions as numbers, with roots of squares and sines of given angles
components           the componentwise road at one order, from the definition
scalars              the scalars of any algebraic chart are its formulas, and those of its φ
proved               `Proved` and the way to it
==================== ==============================================================================
"""

from __future__ import annotations

from .element import Element
from .every_order import theorems
from .exact import Ring
from .identity import Proof, decide
from .proved import ProofFailed, Proved, proofs, prove
from .scalars import root_of

__all__ = ["Element", "Proof", "ProofFailed", "Proved", "Ring", "decide", "proofs", "prove", "root_of", "theorems"]
