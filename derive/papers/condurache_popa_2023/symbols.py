"""Symbols of the paper, and the characters that its text extraction lost."""

from __future__ import annotations

from ..language.terms import Symbol

PAPER = "condurache-popa-2023"

LOST = "_^-()[]{}|√/⊗≠⇒⇔∈∀⟨⟩,;.'∞"
"""Characters that the extraction lost or scattered. Digits, letters, +, ±, ·, ×, ~, ˙, =, ε survive in order."""


def real(name: str) -> Symbol:
    """Return a real number."""
    return Symbol(name, "real", name, name)


def dual(name: str, latex: str | None = None, text: str | None = None) -> Symbol:
    """Return a dual number, underlined."""
    return Symbol(f"{name}_", "dual number", rf"\underline{{{latex or name}}}", text or name)


def real_vector(name: str, text: str | None = None) -> Symbol:
    """Return a vector of the Euclidean space."""
    return Symbol(f"{name} real", "real vector", rf"\mathbf{{{name}}}", text or name)


def vector(name: str, latex: str | None = None, text: str | None = None) -> Symbol:
    """Return a dual vector, underlined."""
    return Symbol(name, "dual vector", rf"\underline{{\mathbf{{{latex or name}}}}}", text or name)


def unit(name: str, latex: str | None = None, text: str | None = None) -> Symbol:
    """Return a unit dual vector."""
    return Symbol(name, "unit vector", rf"\underline{{\mathbf{{{latex or name}}}}}", text or name)


def quaternion(name: str, latex: str | None = None, text: str | None = None) -> Symbol:
    """Return a unit dual quaternion."""
    return Symbol(name, "unit quaternion", rf"\underline{{\hat{{\mathbf{{{latex or name}}}}}}}", text or f"{name}^")


def tensor(name: str, quantity: str = "tensor") -> Symbol:
    """Return a dual tensor."""
    return Symbol(name, quantity, rf"\underline{{\mathbf{{{name}}}}}", name)


n = Symbol("n", "order", "n", "n")
alpha = Symbol("alpha", "angle", r"\underline{\alpha}", "α")
u = unit("u")
v = vector("v")
X = Symbol("X", "dual number", "X", "X")
