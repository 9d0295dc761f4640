"""Formulas in one line of Unicode, and text escaped for LaTeX: symbols, sub- and superscripts, accents."""

from __future__ import annotations

import re
import unicodedata

import pytest

from derive.papers import PAPERS
from derive.papers.language.printed import latex
from derive.papers.report.plain import escape, plain

GREEK = ("alpha", "beta", "theta", "pi", "rho", "sigma", "tau", "phi", "psi", "omega", "varepsilon", "varphi")
SIGNS = {
    "\\otimes": "CIRCLED TIMES", "\\cdot": "MIDDLE DOT", "\\times": "MULTIPLICATION SIGN", "\\pm": "PLUS-MINUS SIGN",
    "\\mp": "MINUS-OR-PLUS SIGN", "\\neq": "NOT EQUAL TO", "\\geq": "GREATER-THAN OR EQUAL TO",
    "\\leq": "LESS-THAN OR EQUAL TO", "\\in": "ELEMENT OF", "\\Rightarrow": "RIGHTWARDS DOUBLE ARROW",
    "\\Leftrightarrow": "LEFT RIGHT DOUBLE ARROW", "\\mapsto": "RIGHTWARDS ARROW FROM BAR", "\\to": "RIGHTWARDS ARROW",
    "\\sum": "GREEK CAPITAL LETTER SIGMA", "\\infty": "INFINITY", "\\langle": "MATHEMATICAL LEFT ANGLE BRACKET",
    "\\rangle": "MATHEMATICAL RIGHT ANGLE BRACKET", "\\lfloor": "LEFT FLOOR", "\\rfloor": "RIGHT FLOOR",
    "\\angle": "ANGLE", "\\forall": "FOR ALL", "\\exists": "THERE EXISTS", "\\circ": "RING OPERATOR",
    "\\|": "DOUBLE VERTICAL LINE", "\\{": "LEFT CURLY BRACKET", "\\}": "RIGHT CURLY BRACKET", "\\#": "NUMBER SIGN",
    "\\dots": "HORIZONTAL ELLIPSIS", "\\ldots": "HORIZONTAL ELLIPSIS", "\\cdots": "HORIZONTAL ELLIPSIS",
    "\\Theta": "GREEK CAPITAL LETTER THETA", "\\Phi": "GREEK CAPITAL LETTER PHI",
    "\\lambda": "GREEK SMALL LETTER LAMDA", "\\Delta": "GREEK CAPITAL LETTER DELTA", "\\mu": "GREEK SMALL LETTER MU",
}  # fmt: skip
WORDS = {"arctan", "cos", "cot", "det", "exp", "lim", "log", "sin", "tan"}
"""LaTeX commands shown as their own names."""


@pytest.mark.parametrize("name", GREEK)
def test_greek_letters(name: str) -> None:
    assert unicodedata.name(plain(f"\\{name}")) == f"GREEK SMALL LETTER {name.removeprefix('var').upper()}"


@pytest.mark.parametrize(("command", "name"), SIGNS.items())
def test_sign_is_one_character(command: str, name: str) -> None:
    assert unicodedata.name(plain(command)) == name
    assert plain(f"a {command} b") == f"a {plain(command)} b"


def test_every_command_of_the_papers_has_a_sign() -> None:
    terms = [
        term
        for paper in PAPERS
        for entry in paper.entries()
        for term in (*(reading.statement for reading in entry.readings), entry.corrected, entry.condition)
    ]
    commands = {command for term in terms if term is not None for command in re.findall(r"\\([A-Za-z]+)", latex(term))}
    assert len(commands) > 50
    assert {command for command in commands if plain(f"\\{command}") == command} == WORDS


@pytest.mark.parametrize(
    ("formula", "line"),
    [(r"\frac{a}{b}", "a/b"), (r"\frac{a + b}{c - d}", "(a + b)/(c - d)"), (r"\tfrac12", "1/2"), (r"\frac 1 2", "1/2"),
     (r"\frac{(a + b)}{(c)(d + e)}", "(a + b)/((c)(d + e))"), (r"\frac{2\, a}{b}", "(2 a)/b"),
     (r"\frac{ab}{c_{1}}", "ab/c₁"),
     (r"\sqrt{a}", "√a"), (r"\sqrt{a - b}", "√(a - b)"), (r"\sqrt{(a)}", "√(a)"),
     (r"\binom{n}{2k}", "C(n, 2k)"), (r"\hat{a}", "â"), (r"\tilde{v}_{1}", "ṽ₁"), (r"\dot{ab}", "ȧb"),
     (r"\ddot{a}", "ä"), (r"\vec{a}", "a\u20d7"), (r"\overline{a}", "a\u0305"), (r"\underline{\mathbf{v}}", "v"),
     (r"\hat {a} b", "â b"), (r"a^{2}", "a²"), (r"a^2", "a²"), (r"a^{-n}", "a⁻ⁿ"), (r"a^{T}", "aᵀ"), (r"a^{*}", "a*"),
     (r"a^{n + 1}", "a^(n + 1)"), (r"a^{x}", "a^x"), (r"a^{k}", "aᵏ"), (r"a_{ij}", "aᵢⱼ"), (r"a_{n}", "aₙ"),
     (r"a_{x}", "a_x"), (r"a_{xy}", "a_(xy)"), (r"a_{0}^{3}", "a₀³"), (r"a_{(4)}", "a₍₄₎"), (r"a^{(5)}", "a⁽⁵⁾"),
     (r"a_6^7", "a₆⁷"), (r"a_8^9", "a₈⁹"), (r"a_{1+2}^{3-4}", "a₁₊₂³⁻⁴"), (r"a_{5-k}", "a₅₋ₖ"),
     (r"a_{37}^{016}", "a₃₇⁰¹⁶"),
     (r"\left(a\right)", "(a)"), (r"\mathbb{R}", "R"), (r"\mathrm{d}", "d"), (r"\operatorname{Re} a", "Re a"),
     (r"\text{if } a", "if a"), (r"a\,b\;c\ d\quad e", "a b c d e"), (r"\boldsymbol{a}", "a"), (r"$a$", "a"),
     (r"\neg\left(a\right)", "not (a)"), (r"\sin a", "sin a"), (r"\log\alpha", "log α"),
     (r"\begin{cases} a, & b \\ c, & d \end{cases}", "[ a, b ; c, d ]"), (r"\foo a", "foo a"),
     ("  a   b ", "a b"), ("", "")],
)  # fmt: skip
def test_formulas_in_one_line(formula: str, line: str) -> None:
    assert plain(formula) == unicodedata.normalize("NFC", line)


# ---- for LaTeX -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("sign", "…‖⊗·×±≠≤≥∈→⇒∞⟨⟩↦⇔∘ΔΣΦαβθΘφψωρστλεπ₀₁₂₃₄₅₆₇₈₉ₙₖ⁰¹²³⁴⁵⁶⁷⁸⁹ⁿ⁻ᵀ#{}")
def test_escaped_sign_reads_as_the_sign(sign: str) -> None:
    assert escape(sign).isascii()
    assert plain(escape(sign)) == sign


@pytest.mark.parametrize(
    ("text", "escaped"),
    [("a & b_c", r"a \& b\_c"), ("5 % $2", r"5 \% \$2"), ("\\", r"\textbackslash{}"), ("~", r"\textasciitilde{}"),
     ("^", r"\textasciicircum{}"), ("a − b", "a $-$ b"), ("√2", r"$\surd$2"), ("90°", r"90$^\circ$"),
     ("½", r"$\frac12$"),
     ("f′", "f$'$"), ("“so”", "``so''"), ("1–2", "1--2"), ("˙", r"$\dot{}$"), ("∂", r"$\partial$"), ("İ", r"\.I"),
     ("é", "é"), ("x̂ + ã b̂c", r"$\hat{x}$ + $\tilde{a}$ $\hat{b}$c"), ("ṽẋ", r"$\tilde{v}$$\dot{x}$"),
     ("θ̂", r"$\hat{\theta}$"),
     ("☃", "[snowman]"), ("", "")],
)  # fmt: skip
def test_text_for_latex(text: str, escaped: str) -> None:
    assert escape(text) == escaped
