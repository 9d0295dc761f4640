"""The letters of the paper, with the meaning it gives them, and the marks its extraction lost."""

from __future__ import annotations

from ..language.terms import Letter

PAPER = "condurache-popa-2023"

LOST = "_^-()[]{}|√/⊗≠⇒⇔∈∀⟨⟩,;.'∞"
"""What the extraction lost or scattered. Digits, letters, +, ±, ·, ×, ~, ˙, =, ε survive, and in order."""


def real(name: str) -> Letter:
    """A real number, written like the real part of the dual one."""
    return Letter(name, "real", name, name)


def dual(name: str, latex: str | None = None, text: str | None = None) -> Letter:
    """A dual number, underlined."""
    return Letter(f"{name}_", "dual number", rf"\underline{{{latex or name}}}", text or name)


def real_vector(name: str, text: str | None = None) -> Letter:
    """A vector of the Euclidean space."""
    return Letter(f"{name} real", "real vector", rf"\mathbf{{{name}}}", text or name)


def vector(name: str, latex: str | None = None, text: str | None = None) -> Letter:
    """A dual vector, underlined."""
    return Letter(name, "dual vector", rf"\underline{{\mathbf{{{latex or name}}}}}", text or name)


def unit(name: str, latex: str | None = None, text: str | None = None) -> Letter:
    """A unit dual vector."""
    return Letter(name, "unit vector", rf"\underline{{\mathbf{{{latex or name}}}}}", text or name)


def quaternion(name: str, latex: str | None = None, text: str | None = None) -> Letter:
    """A unit dual quaternion."""
    return Letter(name, "unit quaternion", rf"\underline{{\hat{{\mathbf{{{latex or name}}}}}}}", text or f"{name}^")


def tensor(name: str, kind: str = "tensor") -> Letter:
    """A dual tensor."""
    return Letter(name, kind, rf"\underline{{\mathbf{{{name}}}}}", name)


n = Letter("n", "order", "n", "n")
alpha = Letter("alpha", "angle", r"\underline{\alpha}", "α")
u = unit("u")
v = vector("v")
X = Letter("X", "dual number", "X", "X")
