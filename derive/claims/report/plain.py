r"""LaTeX formulas as one line of Unicode: ``\frac{f^{*}}{2}`` becomes ``f*/2``; and Unicode text as LaTeX.

Only LaTeX produced by this package's notation is supported; an unknown command is replaced by its own name.
"""

from __future__ import annotations

import html
import re
import unicodedata
from collections.abc import Iterator

_TOKENS = re.compile(r"\\[A-Za-z]+|\\.|[{}^_&]|\s+|.")
_SUPERSCRIPTS = str.maketrans("0123456789+-()nTk*", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁽⁾ⁿᵀᵏ*")
_SUBSCRIPTS = str.maketrans("0123456789+-()nkij", "₀₁₂₃₄₅₆₇₈₉₊₋₍₎ₙₖᵢⱼ")
_ACCENTS = {"\\hat": "\u0302", "\\tilde": "\u0303", "\\dot": "\u0307", "\\vec": "\u20d7", "\\overline": "\u0305",
            "\\ddot": "\u0308", "\\underline": ""}
_SIGNS = {
    "\\varepsilon": "ε", "\\pi": "π", "\\alpha": "α", "\\theta": "θ", "\\Theta": "Θ", "\\omega": "ω", "\\rho": "ρ",
    "\\sigma": "σ", "\\tau": "τ", "\\psi": "ψ", "\\phi": "φ", "\\varphi": "φ", "\\beta": "β", "\\lambda": "λ",
    "\\mu": "μ", "\\Delta": "Δ", "\\Phi": "Φ",
    "\\otimes": "⊗", "\\cdot": "·", "\\times": "×", "\\pm": "±", "\\mp": "∓", "\\neq": "≠", "\\geq": "≥", "\\leq": "≤",
    "\\in": "∈", "\\Rightarrow": "⇒", "\\Leftrightarrow": "⇔", "\\neg": "not ", "\\mapsto": "↦", "\\to": "→",
    "\\sum": "Σ", "\\infty": "∞", "\\langle": "⟨", "\\rangle": "⟩", "\\lfloor": "⌊", "\\rfloor": "⌋", "\\angle": "∠",
    "\\forall": "∀", "\\exists": "∃", "\\circ": "∘", "\\|": "‖", "\\{": "{", "\\}": "}", "\\#": "#", "\\mathbb": "",
    "\\left": "", "\\right": "", "\\mathbf": "", "\\mathrm": "", "\\operatorname": "", "\\text": "", "\\,": " ",
    "\\;": " ", "\\quad": "  ", "\\\\": "; ", "\\ldots": "…", "\\cdots": "…", "\\dots": "…", "\\ ": " ",
    "$": "", "\\boldsymbol": "",
}
_WHOLE = re.compile(r"[^\s+\-−·×/=]+")


def plain(latex: str) -> str:
    line = _sequence(iter(_TOKENS.findall(latex)))
    return unicodedata.normalize("NFC", re.sub(r"\s+", " ", line).strip())


def _sequence(tokens: Iterator[str]) -> str:
    parts: list[str] = []
    for token in tokens:
        if token == "}":
            break
        parts.append(_part(token, tokens))
    return "".join(parts)


def _part(token: str, tokens: Iterator[str]) -> str:
    if token == "{":
        return _sequence(tokens)
    if token in ("^", "_"):
        return _script(_argument(tokens), token)
    if token in ("\\frac", "\\tfrac"):
        above, below = _argument(tokens), _argument(tokens)
        return f"{_grouped(above)}/{_grouped(below)}"
    if token == "\\binom":
        return f"C({_argument(tokens)}, {_argument(tokens)})"
    if token == "\\sqrt":
        return f"√{_grouped(_argument(tokens))}"
    if token in _ACCENTS:
        symbol = _argument(tokens).strip()
        return symbol[:1] + _ACCENTS[token] + symbol[1:]
    if token in ("\\begin", "\\end"):
        _argument(tokens)
        return "[" if token == "\\begin" else "]"
    if token == "&":
        return " "
    return _SIGNS.get(token, f"{token[1:]} " if token.startswith("\\") else token)


def _argument(tokens: Iterator[str]) -> str:
    token = next((token for token in tokens if not token.isspace()), "")
    return _part(token, tokens) if token else ""


def _script(value: str, sign: str) -> str:
    table = _SUPERSCRIPTS if sign == "^" else _SUBSCRIPTS
    if all(ord(character) in table for character in value):
        return value.translate(table)
    return f"{sign}{value}" if len(value) == 1 else f"{sign}({value})"


def _grouped(value: str) -> str:
    value = value.strip()
    bracketed = value.startswith("(") and value.endswith(")") and ")" not in value[1:-1]
    return value if _WHOLE.fullmatch(value) or bracketed else f"({value})"


# ---- text for Markdown ------------------------------------------------------------------------------------------


_FORMULA = re.compile(r"\$(?!\s)([^$]+)(?<!\s)\$(?!\d)")
_MARKUP = re.compile(r"[\\`*_\[\]|$~]|^[-+#]|(?<=^\d)[.)]|(?<=^\d\d)[.)]")


def prose(text: str) -> str:
    """Return words, with formulas between dollars, as Markdown in which they mean no tag, link, cell or formula."""
    pieces = enumerate(_FORMULA.split(" ".join(text.split())))
    return "".join(in_line(in_cell(p)) if i % 2 else _MARKUP.sub(r"\\\g<0>", html.escape(p, False)) for i, p in pieces)


def in_line(latex: str) -> str:
    """Return a formula within a line of Markdown; a backtick would end it, and a bare & or row stands in no formula."""
    if re.search(r"&|\\\\", latex) and r"\begin" not in latex:
        latex = rf"\begin{{aligned}} {latex} \end{{aligned}}"
    return f"$`{' '.join(latex.replace('`', chr(39)).split())}`$"


def in_cell(latex: str) -> str:
    """Return a formula without bars, which would end a cell of a table in Markdown."""
    return latex.replace(r"\|", r"\Vert ").replace("|", r"\vert ")


def code(text: str) -> str:
    """Return words as code within a line or cell of Markdown."""
    return "`" + " ".join(text.replace("`", "'").replace("|", "\\|").split()) + "`"


# ---- text for LaTeX ---------------------------------------------------------------------------------------------

_SPECIAL = {
    **{sign: f"${command}$" for command, sign in _SIGNS.items() if len(sign) == 1 and not sign.isascii()},
    **{chr(sign): f"$_{chr(index)}$" for index, sign in _SUBSCRIPTS.items()},
    **{chr(sign): f"$^{chr(power)}$" for power, sign in _SUPERSCRIPTS.items() if chr(power) != "*"},
    **{c: rf"\{c}" for c in "#$%&_{}"}, "\\": r"\textbackslash{}", "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}", "…": r"\dots{}", "−": "$-$", "°": r"$^\circ$", "√": r"$\surd$", "˙": r"$\dot{}$",
    "½": r"$\frac12$", "′": "$'$", "“": "``", "”": "''", "–": "--", "∂": r"$\partial$", "İ": r"\.I",
}
_MARKS = {mark: command for command, mark in _ACCENTS.items() if mark}
_LAST_LETTER = "\u017f"  # last letter of LaTeX's T1 fonts


def escape(text: str) -> str:
    """Return plain text escaped for pdflatex."""
    pairs = ((character, unicodedata.normalize("NFD", character)) for character in text)
    split = "".join(two if two[1:] in _MARKS and one not in _SPECIAL else one for one, two in pairs)
    return re.sub(rf"(\w)([{''.join(_MARKS)}])|.", _escaped, split, flags=re.DOTALL)


def _escaped(found: re.Match[str]) -> str:
    """Return the LaTeX of a character, or of a letter with its accent."""
    letter, mark = found.groups()
    if mark:
        return f"${_MARKS[mark]}{{{escape(letter).strip('$')}}}$"
    character = found[0]
    known = character if character <= _LAST_LETTER else f"[{unicodedata.name(character, 'unknown').lower()}]"
    return _SPECIAL.get(character, known)
