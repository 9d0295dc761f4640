"""Characters of formulas, compared with the extracted text of a paper, which may be LaTeX or lack its layout."""

from __future__ import annotations

import re

from .language.names import GREEK
from .language.printed import Term, latex


class Latex(str):
    """Extract that is LaTeX."""


_LATEX = (
    (r"\\text\{[^{}]*\}", ""),  # words, which are not the paper's
    (r"\\mathbf\{\\hat\{r\}\}|\^\{\\mathbf\{r\}\}|\\vec\b", ""),  # arrows; the first two are extracted as letters
    (r"\\(stackrel|overset)\{\\mathbf\{\w\}\}\{(\w)\}", r"\2"),
    (r"\\(begin|end)\{\w+\}|\\(left|right|frac|quad|mathbf|mathrm|operatorname|\W)|[$&\s]", ""),
    (r"\\sum", "Σ"), (r"\\cdot", "·"), (r"\\(sin|cos|tan)", r"\1"), ("Sin", "sin"), ("Cos", "cos"), ("Tan", "tan"),
)  # fmt: skip


def characters(formula: str) -> str:
    """Return the characters of a LaTeX formula in order, without layout commands and arrows."""
    for pattern, character in _LATEX:
        formula = re.sub(pattern, character, formula)
    return formula


_SIGNS = dict(zip(GREEK, "αβγδεζηθικλμνξρστυϕχψωΓΔΘΛΞΣΦΨΩ", strict=True)) | {
    "varepsilon": "ε", "varphi": "φ", "pi": "π", "cdot": "·", "times": "×", "pm": "±",
    **{name: name for name in ("sin", "cos", "tan", "cot", "arctan", "exp", "log", "det", "lim")},
}  # fmt: skip
"""Characters of LaTeX commands; all others are layout, or lost by the extraction."""
_ACCENTS = {r"\tilde": "~", r"\dot": "˙", "": ""}


def plain(formula: str) -> str:
    """Return the characters of a LaTeX formula in order without its layout; an accent follows its letters."""
    formula = re.sub(r"\\(begin|end)\{\w+\}|\\[^a-zA-Z]|[&$\s]", " ", formula)
    formula = re.sub(r"\\(?!(?:tilde|dot)\b)([a-zA-Z]+)", lambda found: _SIGNS.get(found[1], " "), formula)
    while "{" in formula:
        formula = re.sub(r"(\\tilde|\\dot|)\{([^{}]*)\}", lambda found: found[2] + _ACCENTS[found[1]], formula)
    return formula.replace(" ", "")


def faithful(reading: Term, extract: str, lost: str) -> bool:
    """Return whether a reading has the same characters as the extract, in order, apart from lost ones and spaces.

    A tilde may precede or follow the index of its symbol.
    """
    drop = str.maketrans("", "", lost + " ")
    form = latex(reading)
    lines = (characters(form), characters(extract)) if isinstance(extract, Latex) else (plain(form), extract)
    left, right = (re.sub(r"~(\d+)", r"\1~", line.translate(drop)) for line in lines)
    return left == right
