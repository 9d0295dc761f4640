"""The letters of the paper, and what its extraction keeps of a formula."""

from __future__ import annotations

import re

from ..language.terms import Letter

HAT = "\N{COMBINING CIRCUMFLEX ACCENT}"
LOST = "()[]{}_^|/,;.Σ"
"""What lays a formula out. Signs, hats, stars and primes are compared; so are + − · × = ≠ < and all letters."""

_MARKS = (
    (r"\\mathbf\{\\hat\{r\}\}|\^\{\\mathbf\{r\}\}", ""),  # arrows, which the extraction shows as letters
    (r"\\hat\{(\w)\}", rf"\1{HAT}"),
    (r"\\(stackrel|overset)\{\\mathbf\{\w\}\}\{(\w)\}", r"\2"),  # likewise
    (r"\\(mathbf|vec)\{([^{}]*)\}", r"\2"),
    (r"\\times", "×"), (r"\\cdot", "·"), (r"\\sum", "Σ"), (r"\\infty", "∞"), (r"\\neq", "≠"),
    (r"\\(begin|end)\{\w+\}|\\(left|right|frac|quad|\W)|[$&\s]", ""),
)  # fmt: skip


def marks(latex: str) -> str:
    """The marks of a formula as the extraction has it in LaTeX: commands for layout and arrows dropped."""
    for pattern, mark in _MARKS:
        latex = re.sub(pattern, mark, latex)
    return latex


def hat(name: str, kind: str, prime: str = "") -> Letter:
    """A dual quantity, under a hat."""
    return Letter(f"{name}^{prime}", kind, rf"\hat{{{name}}}{prime}", f"{name}{HAT}{prime}")


def real(name: str, index: int | None = None, star: bool = False, kind: str = "real") -> Letter:
    """A real number such as f, s₁ or b₁*."""
    mark, latex = "*" if star else "", name if index is None else f"{name}_{index}"
    digit = "" if index is None else str(index)
    return Letter(f"{name}{digit}{mark}", kind, f"{latex}^{{*}}" if star else latex, f"{name}{digit}{mark}")


def arrow(name: str, star: bool = False, seen_as: str | None = None) -> Letter:
    """A real vector, under an arrow; `seen_as` is what the extraction has in its place."""
    plain = f"{name}*" if star else name
    suffix = "" if seen_as is None else f" seen as {seen_as}"
    return Letter(f"vector {plain}{suffix}", "real vector", rf"\vec{{{name}}}" + ("^{*}" if star else ""),
                  seen_as or plain)  # fmt: skip


e = Letter("epsilon", "dual unit", "e", "e")
pi = Letter("pi", "π", r"\pi", "p")
i, j, k = (Letter(name, "index", name, name) for name in "ijk")
