"""Symbols of the paper, and characters of a formula kept by its text extraction."""

from __future__ import annotations

import re

from ..language.terms import Symbol

HAT = "\N{COMBINING CIRCUMFLEX ACCENT}"
LOST = "()[]{}_^|/,;.Σ"
"""Layout characters, which are ignored in comparisons."""

_LATEX = (
    (r"\\mathbf\{\\hat\{r\}\}|\^\{\\mathbf\{r\}\}", ""),  # arrows, extracted as letters
    (r"\\hat\{(\w)\}", rf"\1{HAT}"),
    (r"\\(stackrel|overset)\{\\mathbf\{\w\}\}\{(\w)\}", r"\2"),  # arrows over a letter
    (r"\\(mathbf|vec)\{([^{}]*)\}", r"\2"),
    (r"\\times", "×"), (r"\\cdot", "·"), (r"\\sum", "Σ"), (r"\\infty", "∞"), (r"\\neq", "≠"),
    (r"\\(begin|end)\{\w+\}|\\(left|right|frac|quad|\W)|[$&\s]", ""),
)


def shown(latex: str) -> str:
    """Return the characters of a formula in the extracted text, without layout commands and arrows."""
    for pattern, character in _LATEX:
        latex = re.sub(pattern, character, latex)
    return latex


def hat(name: str, quantity: str, prime: str = "") -> Symbol:
    """Return the symbol of a dual quantity, with a hat."""
    return Symbol(f"{name}^{prime}", quantity, rf"\hat{{{name}}}{prime}", f"{name}{HAT}{prime}")


def real(name: str, index: int | None = None, star: bool = False, quantity: str = "real") -> Symbol:
    """Return the symbol of a real number such as f, s₁ or b₁*."""
    suffix, latex = "*" if star else "", name if index is None else f"{name}_{index}"
    digit = "" if index is None else str(index)
    return Symbol(f"{name}{digit}{suffix}", quantity, f"{latex}^{{*}}" if star else latex, f"{name}{digit}{suffix}")


def arrow(name: str, star: bool = False, seen_as: str | None = None) -> Symbol:
    """Return the symbol of a real vector, with an arrow; `seen_as` replaces it in the extracted text."""
    plain = f"{name}*" if star else name
    suffix = "" if seen_as is None else f" seen as {seen_as}"
    return Symbol(f"vector {plain}{suffix}", "real vector", rf"\vec{{{name}}}" + ("^{*}" if star else ""),
                  seen_as or plain)


e = Symbol("epsilon", "dual unit", "e", "e")
pi = Symbol("pi", "π", r"\pi", "p")
i, j, k = (Symbol(name, "index", name, name) for name in "ijk")
