"""Symbols of the paper, and the characters that its text extraction lost."""

from __future__ import annotations

from ..language.terms import Symbol

PAPER = "condurache-popa-2023"

LOST = "_^-()[]{}|√/⊗≠⇒⇔∈∀⟨⟩,;.'∞"
"""What the extraction lost or scattered. Digits, symbols, +, ±, ·, ×, ~, ˙, =, ε survive, and in order."""


def real(name: str) -> Symbol:
    """A real number, written like the real part of the dual one."""
    return Symbol(name, "real", name, name)


def dual(name: str, latex: str | None = None, text: str | None = None) -> Symbol:
    """A dual number, underlined."""
    return Symbol(f"{name}_", "dual number", rf"\underline{{{latex or name}}}", text or name)


def real_vector(name: str, text: str | None = None) -> Symbol:
    """A vector of the Euclidean space."""
    return Symbol(f"{name} real", "real vector", rf"\mathbf{{{name}}}", text or name)


def vector(name: str, latex: str | None = None, text: str | None = None) -> Symbol:
    """A dual vector, underlined."""
    return Symbol(name, "dual vector", rf"\underline{{\mathbf{{{latex or name}}}}}", text or name)


def unit(name: str, latex: str | None = None, text: str | None = None) -> Symbol:
    """A unit dual vector."""
    return Symbol(name, "unit vector", rf"\underline{{\mathbf{{{latex or name}}}}}", text or name)


def quaternion(name: str, latex: str | None = None, text: str | None = None) -> Symbol:
    """A unit dual quaternion."""
    return Symbol(name, "unit quaternion", rf"\underline{{\hat{{\mathbf{{{latex or name}}}}}}}", text or f"{name}^")


def tensor(name: str, quantity: str = "tensor") -> Symbol:
    """A dual tensor."""
    return Symbol(name, quantity, rf"\underline{{\mathbf{{{name}}}}}", name)


n = Symbol("n", "order", "n", "n")
alpha = Symbol("alpha", "angle", r"\underline{\alpha}", "α")
u = unit("u")
v = vector("v")
X = Symbol("X", "dual number", "X", "X")
