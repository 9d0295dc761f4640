"""Operators make what they say, each change once, and nothing where nothing computes."""

from __future__ import annotations

import ast
from fractions import Fraction

import pytest

from derive.codegen.programs.program import Program, Step
from derive.papers.mutation import try_mutant
from tests.mutants.mutant import Mutant, keyed, sample
from tests.mutants.programs import program_mutants, same_value
from tests.mutants.python import OPERATORS, python_mutants, same_code
from tests.mutants.templates import template_mutants
from tests.mutants.texts import code

pytestmark = pytest.mark.smoke


def applied(source: str, operator: str) -> set[str]:
    """The sources that an operator makes of one."""
    made = [m.site.apply(source.encode()).decode() for m in python_mutants("a.py", source) if m.operator == operator]
    return {ast.unparse(ast.parse(text)) for text in made}


CHANGES = [
    ("arithmetic operation", "y = a + b", {"y = a - b"}),
    ("comparison", "y = a < b", {"y = a <= b", "y = a >= b"}),
    ("and, or, not, truth", "y = not a", {"y = a"}),
    ("constant ± 1", "y = a ** 2", {"y = a ** 3", "y = a ** 1"}),
    ("sign", "y = -a", {"y = a"}),
    ("arguments swapped", "y = f(a, b, a)", {"y = f(b, a, a)", "y = f(a, a, b)"}),
    ("term or factor dropped", "y = a - b", {"y = a", "y = -b"}),
    ("term or factor dropped", "y = a and b", {"y = a", "y = b"}),
    ("element dropped", "y = (a, b)", {"y = (a,)", "y = (b,)"}),
    ("element dropped", "y = {1: a, 2: b}", {"y = {1: a}", "y = {2: b}"}),
    ("statement dropped", "y = a\ny += 1", {"y = a\npass"}),
    ("index shifted", "y = a[i]", {"y = a[i + 1]"}),
    ("condition negated", "y = a if b else c", {"y = a if not b else c"}),
    ("condition negated", "y = [a for a in b if a > c]", {"y = [a for a in b if not a > c]"}),
    ("results swapped", "def f():\n    return (a, b)", {"def f():\n    return (b, a)"}),
    ("sibling function", "y = all(a.re)", {"y = any(a.re)", "y = all(a.du)"}),
]


@pytest.mark.parametrize(("operator", "source", "expected"), CHANGES)
def test_each_operator_makes_what_its_name_says(operator: str, source: str, expected: set[str]) -> None:
    assert applied(source, operator) == expected


def test_every_operator_is_shown_above() -> None:
    assert {operator for operator, _, _ in CHANGES} == set(OPERATORS)


def test_nothing_is_changed_where_nothing_computes() -> None:
    source = (
        '"""A docstring with 1 + 1."""\nfrom a import b\n__all__ = ["c", "d"]\nNumber = int | float\n'
        'def f(a: int | None, b: tuple[int, ...]) -> "a + b":\n    """1 + 1"""\n    x: list[int]\n'
        "y = zip(a, strict=True)\nz = run(timeout=30)\nw = gcd(a, b)\n"
    )
    assert not list(python_mutants("a.py", source))


def test_lines_and_text_of_a_change_are_found_in_long_statements() -> None:
    source = "α = 1\nβ = f(\n    α + 2,\n    γ,\n)\n"
    (mutant,) = (m for m in python_mutants("a.py", source) if m.operator == "arithmetic operation")
    assert (mutant.where, mutant.change, mutant.site.lines) == ("a.py:3", "α + 2 → α - 2", (2, 5))
    assert mutant.site.apply(source.encode()).decode() == source.replace("α + 2", "(α - 2)")


def test_the_same_code_is_seen_to_be_the_same() -> None:
    assert same_code("def f(a):\n    return a + 1", "def f(a):\n\n    return (a + 1)")
    assert not same_code("def f(a):\n    return a + 1", "def f(a):\n    return a + 2")
    assert not same_code("y = 1", "y = True")


def test_templates_are_changed_outside_of_comments_and_docstrings_only() -> None:
    source = '{# 1 #}\n"""1 and 2"""\n# 3\n    x = a + 4  # 5\n{% if n == 1 %}\n    go({{ n }}, m)\n{% endif %}\n'
    made = {(m.line, m.operator) for m in template_mutants("numpy/a.py.j2", source)}
    assert {line for line, _ in made} == {4, 5, 6}
    assert {operator for line, operator in made if line == 4} == {
        "arithmetic operation", "constant ± 1", "statement dropped",
    }  # fmt: skip
    assert (5, "condition negated") in made
    assert (6, "hole dropped") in made
    pages = {m.change for m in template_mutants("report/a.html.j2", "<p>1 and 2 {{ a - 1 }}</p>\n")}
    assert not [change for change in pages if "and" in change.partition("⟦")[2]]


def program(*steps: tuple[str, str, tuple[str | int | Fraction, ...]], outputs: tuple[str, ...]) -> Program:
    return Program("f", (("v", ("v1", "v2")),), tuple(Step(n, op, args, False) for n, op, args in steps), outputs)


DIFFERENCE = program(("d", "sub", ("v1", "v2")), ("e", "mul", (3, "d")), outputs=("e", "d"))


def test_programs_are_changed_in_operation_operand_constant_and_outputs() -> None:
    made = {(operator, words) for operator, words, _ in program_mutants(DIFFERENCE)}
    assert made == {
        ("operation", "d = sub(v1, v2) → d = add(v1, v2)"),
        ("operands swapped", "d = sub(v1, v2) → d = sub(v2, v1)"),
        ("operand", "d = sub(v1, v2) → d = sub(v2, v2)"),
        ("operand", "d = sub(v1, v2) → d = sub(v1, v1)"),
        ("operation", "e = mul(3, d) → e = div(3, d)"),
        ("constant", "e = mul(3, d) → e = mul(4, d)"),
        ("constant", "e = mul(3, d) → e = mul(2, d)"),
        ("constant", "e = mul(3, d) → e = mul(-3, d)"),
        ("operand", "e = mul(3, d) → e = mul(3, v2)"),
        ("order of outputs", "outputs 0 and 1 swapped"),
    }
    assert not [words for _, words, changed in program_mutants(DIFFERENCE) if same_value(DIFFERENCE, changed)]


def test_equal_programs_are_seen_to_be_equal_whatever_functions_mean() -> None:
    turned = program(("d", "sub", ("v2", "v1")), ("r", "sqrt", ("d",)), outputs=("r",))
    again = program(("m", "mul", (-1, "v1")), ("d", "add", ("m", "v2")), ("r", "sqrt", ("d",)), outputs=("r",))
    other = program(("d", "sub", ("v1", "v2")), ("r", "sqrt", ("d",)), outputs=("r",))
    assert same_value(turned, again)
    assert not same_value(turned, other)
    assert same_value(
        program(("h", "mul", (Fraction(1, 2), "v1")), outputs=("h",)), program(("h", "div", ("v1", 2)), outputs=("h",))
    )


def test_programs_are_equal_where_they_differ_only_in_what_is_never_selected() -> None:
    guarded = ("still", "eq", ("v1", 0)), ("safe", "where", ("still", 1, "v1"))
    share, chosen = ("share", "div", ("v2", "safe")), ("r", "where", ("still", 0, "share"))
    found = program(*guarded, share, chosen, outputs=("r",))
    other_guard = program(guarded[0], ("safe", "where", ("still", "v2", "v1")), share, chosen, outputs=("r",))
    other_side = program(*guarded, share, ("r", "where", ("still", "share", 0)), outputs=("r",))
    assert same_value(found, other_guard)
    assert not same_value(found, other_side)
    assert not same_value(found, program(*guarded, share, outputs=("share",)))


def test_a_sample_changes_little_when_mutants_come_and_go() -> None:
    many = [Mutant("a.py", line, "sign", f"-x{line % 50} → x{line % 50}", None) for line in range(100)]
    first, fewer = sample(keyed(many), 1, 20), sample(keyed(many[1:]), 1, 20)
    assert len(keyed(many)) == 100
    assert len(first.keys() & fewer.keys()) >= 18
    assert sample(keyed(many), 1, 20) == first != sample(keyed(many), 2, 20)


def test_a_statement_of_a_paper_with_one_mark_changed() -> None:
    from derive.papers import PAPERS
    from derive.papers.decide import decide
    from derive.papers.mutation import mutants, true_statements

    paper = PAPERS[1]
    (entry,) = (entry for entry in paper.entries() if entry.number == "1")
    (statement, *_) = true_statements(decide(paper.slug, entry, paper.lost))
    scores = [try_mutant(entry, change, statement, mutant) for change, mutant in mutants(statement)]
    assert all(score.killed + score.meaningless + len(score.survivors) == 1 for score in scores)
    assert sum(score.killed for score in scores)


@pytest.mark.parametrize(
    ("before", "after", "same"),
    [
        ("a, b = v; return a - b", "c, d = v; return c - d", True),
        ("a, b = v; return a - b", "a, b = v; return b - a", False),
        ("a = v; b = a; return a", "a = v; a = a; return a", False),
        ("return v", "return w", False),
        ("a = v; return lambda: a", "b = v; return lambda: b", False),
        ("'Text.'; return v  # so", "return v", True),
    ],
)
def test_python_is_the_same_but_for_names_of_variables_comments_and_docstrings(before, after, same) -> None:
    assert (code("a.py", f"def f(v, w): {before}\n") == code("a.py", f"def f(v, w): {after}\n")) == same


@pytest.mark.parametrize(
    ("before", "after", "same"),
    [
        ("int a = n; // so\n return a;", "int b = n;\n return b;", True),
        ("int a = n; return a;", "int a = n; return n;", False),
        ("int a = n; return tan(a);", "int a = n; return sin(a);", False),
        ("int a = n; int b = a; return a;", "int a = n; int b = a; return b;", False),
    ],
)
def test_c_is_the_same_but_for_names_of_variables_comments_and_layout(before, after, same) -> None:
    assert (code("a.h", f"int f(int n) {{\n{before}\n}}\n") == code("a.h", f"int f(int n) {{ {after}\n}}\n")) == same


def test_other_texts_are_the_same_to_the_byte() -> None:
    assert code("CMakeLists.txt", "a  b") != code("CMakeLists.txt", "a b")
