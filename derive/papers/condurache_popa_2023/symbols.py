"""Symbols of the paper, and characters lost by its text extraction."""

from __future__ import annotations

from ..language.notation import dyad, identity, norm, skew
from ..language.terms import Symbol

LOST = "_^-()[]{}|√/⊗≠⇒⇔∈∀⟨⟩,;.'∞"
"""Characters lost or scattered by the extraction. Digits, letters, +, ±, ·, ×, ~, ˙, =, ε survive in order."""


def real(name: str) -> Symbol:
    """Return the symbol of a real number."""
    return Symbol(name, "real", name, name)


def dual(name: str, latex: str | None = None, text: str | None = None) -> Symbol:
    """Return the symbol of a dual number, underlined."""
    return Symbol(f"{name}_", "dual number", rf"\underline{{{latex or name}}}", text or name)


def real_vector(name: str, text: str | None = None) -> Symbol:
    """Return the symbol of a real vector."""
    return Symbol(f"{name} real", "real vector", rf"\mathbf{{{name}}}", text or name)


def vector(name: str, latex: str | None = None, text: str | None = None) -> Symbol:
    """Return the symbol of a dual vector, underlined."""
    return Symbol(name, "dual vector", rf"\underline{{\mathbf{{{latex or name}}}}}", text or name)


def unit(name: str, latex: str | None = None, text: str | None = None) -> Symbol:
    """Return the symbol of a unit dual vector."""
    return Symbol(name, "unit vector", rf"\underline{{\mathbf{{{latex or name}}}}}", text or name)


def quaternion(name: str, latex: str | None = None, text: str | None = None) -> Symbol:
    """Return the symbol of a unit dual quaternion."""
    return Symbol(name, "unit quaternion", rf"\underline{{\hat{{\mathbf{{{latex or name}}}}}}}", text or f"{name}^")


def tensor(name: str, quantity: str = "tensor") -> Symbol:
    """Return the symbol of a dual tensor."""
    return Symbol(name, quantity, rf"\underline{{\mathbf{{{name}}}}}", name)


n = Symbol("n", "order", "n", "n")
alpha = Symbol("alpha", "angle", r"\underline{\alpha}", "α")
u = unit("u")
v = vector("v")
I, V, VV, x = identity, skew(v), dyad(v, v), norm(v) ** 2
R, Q = tensor("R", "orthogonal tensor"), Symbol("Q", "real tensor", r"\mathbf{Q}", "Q")
rho = Symbol("rho", "real vector", r"\boldsymbol{\rho}", "ρ")
q_hat = Symbol("q", "quaternion", r"\underline{\hat{\mathbf{q}}}", "q^")
