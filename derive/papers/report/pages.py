"""Report as JSON, Markdown, HTML and LaTeX, mostly by templates."""

from __future__ import annotations

import json
import re
import unicodedata
from typing import Any

from derive.output import render
from derive.proof import Proof

from ..result import Result, Status
from .content import MEANING, Report, command, example, extent, label, place, readings, why
from .difference import differing

SCHEMA = 2


def as_json(report: Report) -> str:
    """Return the report as JSON; `Result.as_json` and `derive.proof.Proof` describe the fields."""
    data = {
        "schema": SCHEMA,
        "equations": [result.as_json() for result in report.results],
        "proofs": [_proof(proof) for proof in report.proofs],
    }
    return json.dumps(data, indent=2, ensure_ascii=False) + "\n"


def as_markdown(report: Report) -> str:
    """Return a Markdown page with formulas in ``math`` spans."""
    return render("report/errata.md.j2", **_common(report), **PAGE)


def as_html(report: Report) -> str:
    """Return a self-contained HTML page with MathML formulas and a filter that needs no network."""
    return render("report/errata.html.j2", mathml=mathml, **_common(report), **PAGE)


def as_latex(report: Report) -> str:
    """Return a LaTeX sheet of the errata for pdflatex."""
    return render("report/errata.tex.j2", escape=escape, HOLDS_IF=Status.HOLDS_IF, **_common(report))


def _common(report: Report) -> dict[str, Any]:
    """Return the data used by all three templates."""
    statuses = {"statuses": MEANING, "ERRATUM": Status.ERRATUM, "AMBIGUOUS": Status.AMBIGUOUS}
    return {"report": report, "label": label, "notes": notes, **statuses}


def differing_sides(result: Result) -> tuple[str, str]:
    """Return the printed and the corrected formula as LaTeX, with differing parts in colour."""
    assert result.equation.corrected is not None
    return differing(result.verdicts[0].statement, result.equation.corrected)


PAGE = {"extent": extent, "place": place, "readings": readings, "why": why, "command": command, "example": example,
        "differing": differing_sides}
"""Further template functions for Markdown and HTML."""


def notes(result: Result) -> tuple[str, ...]:
    """Return the notes on a result: words of the paper, remark, and passage that decides the reading."""
    entry = result.equation
    said = f"In the paper: “{entry.said}”" if entry.said else ""
    fixed = f"The reading follows from {entry.fixed_by}." if entry.fixed_by else ""
    return tuple(note for note in (said, entry.remark, fixed) if note)


def _proof(proof: Proof) -> dict[str, Any]:
    return {
        "statement": proof.statement,
        "scope": proof.scope,
        "status": proof.status,
        "method": proof.method,
        "seconds": round(proof.seconds, 6),
    }


# ---- formulas as MathML, text for LaTeX -----------------------------------------------------------------------

_TEXT = re.compile(r"\\text\{([^{}$]*(?:\$[^$]*\$[^{}$]*)+)\}")


def mathml(latex: str) -> str:
    """Return the formula as displayed MathML."""
    from latex2mathml.converter import convert  # slow import, needed by one format only

    return str(convert(_TEXT.sub(_apart, latex), display="block"))


def _apart(found: re.Match[str]) -> str:
    r"""Move the formulas out of a ``\text`` command."""
    pieces = found.group(1).split("$")
    return "".join(piece if i % 2 else rf"\text{{{piece}}}" for i, piece in enumerate(pieces) if piece)


_SPECIAL = {
    **{c: rf"\{c}" for c in "#$%&_{}"}, "\\": r"\textbackslash{}", "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "−": r"$-$", "…": r"\dots{}", "‖": r"$\|$", "⊗": r"$\otimes$", "·": r"$\cdot$", "×": r"$\times$", "±": r"$\pm$",
    "≠": r"$\neq$", "≤": r"$\leq$", "≥": r"$\geq$", "∈": r"$\in$", "→": r"$\to$", "⁻": "$^-$", "°": "$^\\circ$",
    "√": r"$\surd$", "⇒": r"$\Rightarrow$", "˙": r"$\dot{}$", "∞": r"$\infty$", "ᵀ": "$^T$", "½": r"$\frac12$",
    "′": "$'$", "“": "``", "”": "''", "–": "--", "Φ": r"$\Phi$",
    "İ": r"\.I",
    "⟨": r"$\langle$", "⟩": r"$\rangle$", "↦": r"$\mapsto$",
    "⇔": r"$\Leftrightarrow$", "∂": r"$\partial$", "∘": r"$\circ$", "Δ": r"$\Delta$", "Σ": r"$\sum$",
    **{c: f"$_{i}$" for i, c in enumerate("₀₁₂₃₄₅₆₇₈₉")}, "ₙ": "$_n$", "ₖ": "$_k$",
    **{c: f"$^{i}$" for i, c in enumerate("⁰¹²³⁴⁵⁶⁷⁸⁹")}, "ⁿ": "$^n$",
    **dict(zip("αβθΘφψωρστλεπ", (rf"$\{name}$" for name in (
        "alpha", "beta", "theta", "Theta", "varphi", "psi", "omega", "rho", "sigma", "tau", "lambda", "varepsilon",
        "pi")), strict=True)),
}
LAST_LETTER = "\u017f"  # last letter of LaTeX's T1 fonts
_ACCENTED = re.compile("(\\w)([\u0302\u0303\u0307])")
_ACCENT = {"\u0302": "hat", "\u0303": "tilde", "\u0307": "dot"}


def escape(text: str) -> str:
    """Return plain text escaped for pdflatex."""
    pieces = _ACCENTED.split(_decomposed(text))
    whole = []
    for plain, symbol, accent in zip(pieces[::3], [*pieces[1::3], ""], [*pieces[2::3], ""], strict=True):
        whole.append("".join(map(_escaped, plain)))
        whole.append(rf"$\{_ACCENT[accent]}{{{_escaped(symbol).strip('$')}}}$" if accent else "")
    return "".join(whole)


def _escaped(character: str) -> str:
    if character in _SPECIAL:
        return _SPECIAL[character]
    return character if character <= LAST_LETTER else f"[{unicodedata.name(character, 'unknown').lower()}]"


def _decomposed(text: str) -> str:
    """Split each letter with a hat, tilde or dot into letter and combining accent."""
    pairs = ((character, unicodedata.normalize("NFD", character)) for character in text)
    return "".join(two if two[1:] in _ACCENT and one not in _SPECIAL else one for one, two in pairs)
