"""Files of the two papers: what they state beside their claims, and refusals of altered entries."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import derive
from derive.claims.decide import decide
from derive.claims.equation import UndecidedError
from derive.claims.extracted import characters, plain
from derive.claims.result import Status
from derive.claims.sheet import Sheet, sheet
from derive.papers import PAPERS
from tests.support.command import dualcay
from tests.support.imports import ROOT

CP23, K10 = PAPERS


def altered(old: str, new: str) -> Sheet:
    """Return the paper with one change in its text, which stands there once."""
    (text,) = (text for text, _ in (paper.request for paper in PAPERS) if text.count(old) == 1)
    return sheet(text.replace(old, new), "altered.toml")


@pytest.mark.parametrize(
    ("number", "old", "new", "reason"),
    [("10", "q3s == (p3s*norm(pr)**2 - p3*", "q3s == (p3s*norm(pr)**2 - p2*", "not have the characters of line 174"),
     ("18", "(slope - s2*b2s - s3*b3s)/s1", "(slope + s2*b2s - s3*b3s)/s1", "not have the characters of line 227"),
     ("real-norm", 'condition = "T >= 0"', 'condition = "T > 0"', "true outside its condition"),
     ("step-21", "u3*(h3 - (u3s*tan(f/2) + u3*slope))", "u3*(h3 - (u3s*tan(f/2) - u3*slope))", "has no correction"),
     ("quadratic-expansion", "1/2*Sum_all", "1/3*Sum_all", "correction is false"),
     ("no-field", "(e*ad)*e == 0", "(e*ad)*e == e", "supporting identity is not proved"),
     ("31", "1 + v _ 2 v ~ _ v _ + (", "1 v _ 2 v ~ _ v _ + (", "not have the characters of line 172"),
     ("111", "16*dyad(v, v))\"", "15*dyad(v, v))\"", "correction is false"),
     ("double-cover", "4*dyad(q_v, q_v)", "3*dyad(q_v, q_v)", "supporting identity is not proved")],
)  # fmt: skip
def test_altered_entry_is_refused(number: str, old: str, new: str, reason: str) -> None:
    paper = altered(old, new)
    (entry,) = paper.entries({number})
    with pytest.raises(UndecidedError, match=reason):
        decide(paper.slug, entry, paper.lost)


@pytest.mark.parametrize(
    ("old", "new", "problem"),
    [('line = 133', 'line = "133"', "equation 1: line is an integer, got str"),
     ('note = "over i < j"', 'remark = "over i < j"', "equation quadratic-expansion: unknown key remark"),
     ('condition = "T >= 0"', 'condition = "T >= "', "equation real-norm, column 1: condition: "),
     ('undecided = "which functions', 'claim = "v == v"\nundecided = "which functions',
      "equation no-transcendental-functions: an equation has a claim, such as claim = \"a == b\"; or it is undecided"),
     ("line_t == Rt*line_0", "line_t == line_0*Rt", "equation 66, column 11: a vector * a tensor")],
)  # fmt: skip
def test_what_cannot_be_read_is_one_line(old: str, new: str, problem: str) -> None:
    (found,) = altered(old, new).problems
    assert re.match(rf"altered\.toml:\d+: {re.escape(problem)}", str(found))


def test_order_that_a_domain_names_is_tried_whichever_are_asked_for() -> None:
    (result,) = derive.verify(CP23.slug, "99", [6])
    assert (result.status, result.method) == (Status.HOLDS_IF, "exact")


TRANSCRIPT = re.search(r"```toml\n(.*?)```", (ROOT / "docs/howto/extend.md").read_text("utf-8"), re.DOTALL)[1]
"""Example of the page on papers."""


def test_transcript_of_a_user_is_decided_without_registration(tmp_path: Path) -> None:
    wrong = '[[equation]]\nnumber = "4"\nlatex = "f = f^{*}"\nclaim = "f == fs"\n'
    words = '[[equation]]\nnumber = "5"\ntitle = "a name"\nsaid = "called f"\nundecided = "a name is no statement"\n'
    (tmp_path / "mine.toml").write_text(TRANSCRIPT + wrong + words, encoding="utf-8")
    right, false, named = derive.verify(tmp_path / "mine.toml")
    assert (right.status, right.method, right.exact) == (Status.HOLDS_IF, "exact", True)
    assert false.status is Status.UNDECIDED
    assert false.method.startswith("(4) is false and has no correction: refuted at ")
    assert (named.status, named.method) == (Status.UNDECIDED, "a name is no statement")
    shown = dualcay("verify", str(tmp_path / "mine.toml"), "--strict")
    assert shown.returncode == 1
    assert "(4) is false" in shown.stdout
    assert "a name is no statement" in shown.stdout


@pytest.mark.parametrize(
    ("claim", "narrow", "right"),
    [("(x - 1)*(x - 7/3) == 0", "x == 1", "x == 1 or x == 7/3"), ("x**2 == 4", "x == 2", "x == 2 or x == -2"),
     ("sin(x) == 0 and x**2 < 10", "x == 0", "x == 0 or x == pi or x == -pi")],
)  # fmt: skip
def test_equation_as_condition_names_all_solutions(claim: str, narrow: str, right: str) -> None:
    text = '''[paper]\nconditions = "stated"\n[letters]\nx = "real"
[[equation]]\nnumber = "1"\nclaim = "{}"\ncondition = "{}"'''
    (entry,) = sheet(text.format(claim, right), "right.toml").entries()
    assert decide("right", entry).status in (Status.HOLDS_IF, Status.UNREFUTED)
    (entry,) = sheet(text.format(claim, narrow), "narrow.toml").entries()
    with pytest.raises(UndecidedError, match="true outside its condition"):
        decide("narrow", entry)


@pytest.mark.parametrize("relation", ["r + x == 2*x", "not r == x + 1"])
def test_named_relation_is_as_exact_as_its_definition(relation: str) -> None:
    text = f'''[paper]\nconditions = "stated"\n[letters]\nx = "real"\n[definitions]\n"named(r)" = "{relation}"
[[equation]]\nnumber = "1"\nclaim = "named(x)"'''
    (entry,) = sheet(text, "named.toml").entries()
    assert decide("named", entry).method == "exact"


@pytest.mark.parametrize(
    ("formula", "expected"),
    [(r"\frac{1}{2}\, \tilde{\underline{\mathbf{v}}}_{1}", "12v~_1"), (r"\dot{\underline{\boldsymbol{\omega}}}", "ω˙"),
     (r"\tilde{\tilde{a}\, b}^{T}", "a~b~^T"),
     (r"\operatorname{atan2}\left(\pm \sin \frac{\alpha}{2}\right)", "atan2(±sinα2)"),
     (r"\sum_{k=0}^{\infty} \begin{cases} a, & \text{when } b\\ c \end{cases}", "_k=0^a,whenbc")],
)  # fmt: skip
def test_characters_of_latex_without_its_layout(formula: str, expected: str) -> None:
    assert plain(formula) == expected


def test_characters_of_printed_latex() -> None:
    assert characters(r"\left\| \hat{b} \right\| = \frac{\hat{X}' - \hat{x}'}{2}") == r"\hat{b}={\hat{X}'-\hat{x}'}{2}"
    assert characters(r"\stackrel{\mathbf{r}}{b} \cdot Tan\frac{f}{2}, \quad \text{ of (14)}") == "b·tan{f}{2},"
