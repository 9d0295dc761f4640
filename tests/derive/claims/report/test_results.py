"""Presentation of a result: as data, in a notebook, as a table row, in words, and in one line of Unicode."""

from __future__ import annotations

import re
import unicodedata
from types import SimpleNamespace

import pytest

from derive import check
from derive.claims.equation import Entry, Reading, equation
from derive.claims.language.operator_table import Re, equal, nonzero
from derive.claims.language.printed import Symbol, latex
from derive.claims.report.content import Report, domain, example, extent
from derive.claims.report.forms import as_text, table
from derive.claims.report.plain import _SIGNS as SIGNS
from derive.claims.report.plain import escape, in_line, plain
from derive.claims.result import Counterexample, Result, Status, Verdict
from derive.papers import PAPERS

a, b = Symbol("a", "dual number"), Symbol("b", "dual number")
SHOWN = Counterexample("generic point 1", {"a": ["0.5", "-0.25"], r"\alpha": ["2"]}, (["0.5", "3"], ["0.5", "4"]))
SOURCE = "derive/papers/condurache_popa_2023/sections/s09a_explicit_orders.py"


def entry(number: str = "7", **rest: object) -> Entry:
    given = {"extract": "a = b", "said": "words", "remark": "A sign is missing. More.", "source": SOURCE, **rest}
    return equation(number, equal(a, b), title="title", line=3, **given)


def result(status: Status = Status.HOLDS, number: str = "7", **rest: object) -> Result:
    verdicts = (Verdict(equal(a, b), "note", status is not Status.ERRATUM, "method",
                        SHOWN if status is Status.ERRATUM else None),)  # fmt: skip
    of_result = {name: rest.pop(name) for name in ("verdicts", "exact") if name in rest}
    given = {"verdicts": verdicts, **of_result}
    return Result(PAPERS[0].slug, entry(number, **rest), status, "exact", **given)


ERRATUM = result(Status.ERRATUM, corrected=equal(a, -b), claimed=nonzero(a), stated="for a ≠ 0")
IF = result(Status.HOLDS_IF, condition=nonzero(Re(b)), corrected=None, exact=True)


def test_data_of_an_erratum() -> None:
    assert ERRATUM.as_json() == {
        "paper": "condurache-popa-2023", "equation": "7", "title": "title", "status": "erratum",
        "printed": "a = b", "corrected": "a = -b", "claimed": r"a \neq 0", "stated": "for a ≠ 0",
        "condition": None, "exact": None, "readings": [{"latex": "a = b", "verdict": "false", "note": "note"}],
        "reading_count": 1, "capped": False,
        "counterexample": {"point": "generic point 1", "letters": {"a": ["0.5", "-0.25"], r"\alpha": ["2"]},
                           "sides": (["0.5", "3"], ["0.5", "4"]), "proof": ""},
        "method": "exact", "anchor": "condurache-popa-2023-7", "section": "9", "line": 3, "source": SOURCE,
        "said": "words", "remark": "A sign is missing. More.", "claim": None, "domain": None,
        "outside": None, "certainty": "", "points": 0, "changes": (), "vacuous": (), "needs": (), "cuts": "", "at": "",
        "latex": None, "proposed": False,
    }  # fmt: skip


def test_only_errata_have_corrections_and_counterexamples() -> None:
    found = IF.as_json()
    assert (found["corrected"], found["counterexample"], found["claimed"], found["stated"]) == (None,) * 4
    assert (found["condition"], found["exact"], found["status"]) == (r"\operatorname{Re} b \neq 0", True, "holds-if")
    unclear = result(Status.AMBIGUOUS, corrected=equal(a, -b), exact=True).as_json()
    assert (unclear["corrected"], unclear["exact"], unclear["capped"]) == (None, None, False)


def test_notebook_shows_the_correction_beside_the_printed_form() -> None:
    assert ERRATUM._repr_latex_() == (
        r"$\displaystyle \begin{gathered} \text{(7) erratum:}\quad a = b \\ \longrightarrow\quad a = -b \end{gathered}$"
    )
    assert IF._repr_latex_() == r"$\displaystyle \text{(7) holds-if:}\quad a = b$"
    assert repr(IF) == "<Result condurache-popa-2023 (7): holds-if>"


def test_row_of_a_table() -> None:
    row = {"paper": "condurache-popa-2023", "equation": "7", "printed": r"$\displaystyle a = b$", "method": "exact"}
    assert ERRATUM.cells() == {**row, "status": "erratum", "corrected": r"$\displaystyle a = -b$"}
    assert IF.cells() == {**row, "status": "holds-if", "corrected": ""}


@pytest.mark.parametrize(
    ("source", "section"),
    [(SOURCE, "9"), ("derive/papers/x/sections/s12_2_more.py", "12.2"), ("derive/papers/x/sections/s10_end.py", "10"),
     ("", "")],
)  # fmt: skip
def test_section_is_read_from_the_module_name(source: str, section: str) -> None:
    assert result(source=source).section == section


# ---- in words --------------------------------------------------------------------------------------------------------


def test_lines_for_found_and_stated_domains() -> None:
    both = {"condition": nonzero(Re(b)), "claimed": nonzero(a), "stated": (1, "x")}
    assert domain(result(Status.HOLDS_IF, **both)) == ("at least where Re b ≠ 0", "for a ≠ 0, as stated")
    assert domain(IF) == ("if Re b ≠ 0",)
    assert domain(ERRATUM) == ("for a ≠ 0, as stated",)
    assert domain(result()) == ()
    assert domain(result(Status.ERRATUM, **both))[0] == "where Re b ≠ 0"
    assert extent(IF) == "if"


@pytest.mark.parametrize(
    ("symbols", "sides", "lines"),
    [({"a": ["0.5", "-0.25"], r"\alpha": ["2"]}, (["0.5", "3"], ["0.5", "4"]),
      ("a = 0.5 - ε 0.25", "α = 2", "number 2 of 2: left 3, right 4")),
     ({"v": list("123456")}, (["1"], ["2"]), ("v = (1, 2, 3) + ε (4, 5, 6)", "left 1, right 2")),
     ({"q": list("12345678")}, (), ("q = (1, 2, 3, 4) + ε (5, 6, 7, 8)", "the point: the statement is false")),
     ({"v": list("123")}, (["1"], []), ("v = (1, 2, 3)", "the point: the statement is false")),
     ({}, (["0.12345678901234"], ["0.12345678991234"]), ("left 0.1234567890, right 0.1234567899",)),
     ({}, (["0.12345678901234", "7"], ["0.12345678991234", "8"]), ("number 2 of 2: left 7, right 8",)),
     ({"a": ["0.12345678901234"]}, (["1"], ["1"]), ("a = 0.1234567890", "left 1, right 1"))],
)  # fmt: skip
def test_counterexample_in_lines(symbols, sides, lines) -> None:
    assert example(Counterexample("the point", symbols, sides)) == lines


def test_a_letter_has_rates_or_a_dual_part_only_if_its_kind_and_the_claim_do() -> None:
    def lines(claim: str, **letters: str) -> tuple[str, ...]:
        found = check(claim, **letters)
        assert found.counterexample is not None
        return example(found.counterexample, found.equation)

    assert "omega = (2, -2, 3)" in lines("rate(g) == cross(g, omega)", g="vector", omega="vector")
    assert "xi = (2, -1, 1, 1, -1, -2)" in lines("rate(T) == T*exp(xi)", T="pose", xi="twist")
    assert lines("a*v == v", a="dual number", v="vector")[1:] == ("v = (2, -2, 3)", "number 4 of 6: left -4, right 0")


# ---- tables ----------------------------------------------------------------------------------------------------------


def chapter(*results: Result):
    (found,) = Report.of(PAPERS, results, ()).chapters
    return found


def test_erratum_has_three_rows() -> None:
    grid = table(chapter(ERRATUM), Status.ERRATUM)
    assert [column.heading for column in grid.columns] == ["equation", "printed", "corrected"]
    first, second, third = grid.rows
    assert set(grid.remarks) == {second[0], third[0]}
    assert tuple(first) == ("(7)\ntitle", "a = b\nfor a ≠ 0, as stated", "a = -b")
    assert tuple(second) == ("how it is known", "exact", "")
    assert tuple(third) == (
        "where they differ", "a = 0.5 - ε 0.25\nα = 2\nnumber 2 of 2: left 3, right 4",
        "in full: dualcay verify --paper condurache-popa-2023 --eq 7 --format json",
    )  # fmt: skip


def test_other_tables_have_a_row_for_each_entry_or_reading() -> None:
    others = (Verdict(equal(a, b), "one", True, ""), Verdict(equal(b, a), "", False, ""))
    unclear = result(Status.AMBIGUOUS, verdicts=others)
    assert list(map(tuple, table(chapter(unclear), Status.AMBIGUOUS).rows)) == [
        ("(7)\ntitle", "a = b\none", "true"), ("", "b = a", "false"),
    ]  # fmt: skip
    assert list(map(tuple, table(chapter(IF), Status.HOLDS_IF).rows)) == [("(7)\ntitle", "a = b", "if Re b ≠ 0\nexact")]
    assert list(map(tuple, table(chapter(result()), Status.HOLDS).rows)) == [("(7)\ntitle", "a = b", "exact")]
    assert table(chapter(unclear), Status.AMBIGUOUS).title.startswith("CP23, ambiguous: ")


def test_text_has_a_table_for_each_status_and_for_proofs() -> None:
    proof = SimpleNamespace(scope="all orders", status="proved", statement="a = a")
    alone, proved = (as_text(Report.of(PAPERS, [IF, ERRATUM], proofs)) for proofs in ((), (proof,)))
    heads = [line.strip() for line in alone.splitlines() if line.strip().startswith(("CP23, ", "equations", "proofs"))]
    assert [head.split(":")[0] for head in heads] == ["equations decided", "CP23, erratum", "CP23, holds-if"]
    assert proved.startswith(alone)
    rest = proved.removeprefix(alone)
    assert all(part in rest for part in ("proofs", "all orders", "proved", "a = a"))


def test_results_are_sorted_by_paper() -> None:
    report = Report.of(PAPERS, [IF, result(number="8")], (), "..")
    assert [r.equation.number for r in report.results] == ["7", "8"]
    assert [c.paper.slug for c in report.chapters] == [PAPERS[0].slug]
    assert report.link(IF) == f"../{SOURCE}"
    assert Report.of(PAPERS, [IF], ()).link(IF) == ""
    assert Reading(equal(a, b)).note == ""


# --- formulas in one line of Unicode ----------------------------------------------------------------------------------

WORDS = {"arctan", "cos", "cot", "det", "exp", "lim", "log", "sin", "tan"}
"""LaTeX commands shown as their own names."""


def test_greek_letters_have_their_names() -> None:
    for command, sign in SIGNS.items():
        if "Α" <= sign <= "ω" and command != "\\sum":
            name = command[1:].removeprefix("var").replace("lambda", "lamda").upper()
            assert unicodedata.name(sign).split()[-1] == name


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


def test_rows_of_a_display_are_a_formula_in_markdown() -> None:
    assert in_line(r"a &= b \\ &= c") == r"$`\begin{aligned} a &= b \\ &= c \end{aligned}`$"
    cases = r"\begin{cases} a & b \\ c & d \end{cases}"
    assert in_line(cases) == f"$`{cases}`$"
