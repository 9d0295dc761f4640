"""Which marks are put in where they were lost, and how many: small displays of every kind of value, written out."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from derive.papers.language.evaluation import Env
from derive.papers.language.notation import Re, pm
from derive.papers.language.terms import MARKS, Letter, Number, Term, latex, text
from derive.papers.numbers.residues import Reduced, Residue
from derive.papers.readings import items
from derive.papers.readings.items import OpenError, Shape
from derive.papers.readings.search import Side
from derive.papers.readings.tokens import Place, Token

a, b, c, d = (Letter(name, "dual number") for name in "abcd")
v, w = Letter("v", "dual vector"), Letter("w", "dual vector")
q, p = Letter("q", "quaternion"), Letter("p", "quaternion")  # the magnitude of q is a residue, that of p is none
n, f, I = Letter("n", "order"), Letter("f", "function"), Letter("I", "identity")
S, T = Letter("S", "tensor"), Letter("T", "tensor")
plus, dot, cross = (Token(mark=MARKS[name], place=Place.BETWEEN) for name in ("plus", "dot", "cross"))
tilde, either = Token(mark=MARKS["skew"], place=Place.AFTER), Token(mark=pm, place=Place.BEFORE)
real_part = Token(mark=Re, place=Place.BEFORE)
one, two, three, four = map(Number, (1, 2, 3, 4))


def side(*tokens: Term | Token, dual: bool = False, radicals: bool = False, quaternions: bool = True,
         cap: int = 10_000) -> Side:  # fmt: skip
    point = Reduced([x for x in dict.fromkeys(tokens) if isinstance(x, Letter) and x.kind.exact], dual, moving=False)
    values = {**point.values, n: 7, f: lambda x: x * x + 1}
    marks = [token if isinstance(token, Token) else Token(token) for token in tokens]
    return Side(marks, Env(point.field, values, {}, dual, False), radicals, quaternions, cap)


def shown(found: Side) -> dict[str, int]:
    """The readings without a minus in front, and how many marks were put in."""
    readings = [(text(item.term), item.marks) for item in found.readings().values()]
    assert len(dict(readings)) == len(readings)
    return {reading: marks for reading, marks in readings if not reading.startswith("-")}


NUMBERS = [
    ((a, b), {"a b": 0, "a-b": 1, "a/b": 1}),
    ((a, two), {"a-2": 1, "a/2": 1, "a^2": 1, "a^-2": 2}),
    ((a, one), {"a-1": 1, "a^-1": 2}),
    ((a, Number(0)), {"a-0": 1}),
    ((a, Number(64)), {"a-64": 1, "a/64": 1, "a^64": 1, "a^-64": 2}),
    ((a, Number(65)), {"a-65": 1, "a/65": 1}),
    ((two, a), {"2 a": 0, "2-a": 1, "2/a": 1}),
    ((one, a), {"1-a": 1, "1/a": 1}),
    ((two, three), {"2/3": 1}),
    ((two, four), {}),
    ((four, two), {}),
    ((a, plus, b), {"a+b": 0}),
    ((two, plus, a), {"2+a": 0}),
    ((two, plus, three), {}),
    ((two, n), {"2 n": 0, "2-n": 1, "2/n": 1}),
    ((n, two), {"n-2": 1, "n/2": 1, "n^2": 1, "n^-2": 2}),
    ((a, n), {"a n": 0, "a-n": 1, "a/n": 1, "a^n": 1, "a^-n": 2}),
    ((n, a), {"n a": 0, "n-a": 1, "n/a": 1}),
    ((a, dot, b), {"a·b": 0}),
    ((a, dot, b, c), {"a·b c": 0, "a·b-c": 1, "a·b/c": 1, "a·(b-c)": 2}),
    ((either, a, b), {"a b": 0, "a-b": 1, "a/b": 1}),
    ((either, a), {"a": 0}),
    ((f, a), {"f a": 1}),
    ((f, two), {"f 2": 1}),
]  # fmt: skip

QUATERNIONS = [
    ((a, v), {"a v": 0, "a-v": 1, "a |v|": 1, "a-|v|": 2, "a/|v|": 2}),
    ((v, a), {"v-a": 1, "v/a": 1, "|v| a": 1, "|v|-a": 2, "|v|/a": 2}),
    ((v, w), {"v w": 0, "v-w": 1, "v⊗w": 1, "|v| w": 1, "|v|-w": 2}),
    ((a, plus, v), {"a+v": 0, "a+|v|": 1}),
    ((q, a), {"q a": 0, "q-a": 1, "q/a": 1, "|q| a": 1, "|q|-a": 2, "|q|/a": 2, "|q-a|": 2}),
    ((a, q), {"a q": 0, "a-q": 1, "a/q": 1, "a |q|": 1, "a-|q|": 2, "a/|q|": 2, "|a-q|": 2}),
    ((q, v), {"q v": 0, "q-v": 1, "q |v|": 1, "|q| v": 1, "|q v|": 1, "q-|v|": 2, "q/|v|": 2, "|q|-v": 2, "|q-v|": 2,
              "|q|-|v|": 3, "|q|/|v|": 3}),
    ((v, two), {"v-2": 1, "v/2": 1, "v^2": 1, "|v|^2": 2, "v^-2": 2, "|v|-2": 2, "|v|/2": 2, "|v-2|": 2, "|v/2|": 2,
                "|v|^-2": 3}),
    ((q, two), {"q-2": 1, "q/2": 1, "q^2": 1, "|q|^2": 2, "q^-2": 2, "|q|-2": 2, "|q|/2": 2, "|q/2|": 2, "|q|^-2": 3}),
    ((p, two), {"p-2": 1, "p/2": 1, "p^2": 1, "|p|^2": 2, "|p^2|": 2, "p^-2": 2, "|p|^-2": 3, "|p^-2|": 3}),
    ((v, cross, w), {"v×w": 0, "|v×w|": 1}),
    ((v, dot, w), {"v·w": 0, "|v|·w": 1}),
]  # fmt: skip

TENSORS = [
    ((v, w), {"v-w": 1, "v⊗w": 1, "|v| w": 1}),
    ((I, v, tilde), {"(I v)~": 0, "I-v~": 1}),
    ((v, tilde, two), {"v~^2": 1}),
    ((v, tilde, w), {"v~ w": 0, "|v~ w|": 1}),
    ((v, tilde, w, tilde), {"(v~ w)~": 0, "v~ w~": 0, "v~-w~": 1}),
    ((v, tilde, a), {"v~/a": 1}),
    ((a, v, tilde), {"(a v)~": 0}),
    ((a, I), {"a I": 0}),
    ((two, I), {"2 I": 0}),
    ((I, two), {"I^2": 1}),
    ((I, a), {"I/a": 1}),
    ((T, S), {"T S": 0, "T-S": 1}),
    ((two, T), {"2 T": 0}),
    ((T, two), {"T^2": 1}),
    ((T, two, S), {"T^2 S": 1, "T-2 S": 1, "T^2-S": 2}),
]  # fmt: skip
"""Where numbers and vectors make no quaternions."""

RADICALS = [
    ((a, b), {"a b": 0, "a-b": 1, "a/b": 1, "√a-b": 2, "√a/b": 2}),
    ((b, plus, c), {"b+c": 0, "√b+c": 1}),
]
"""Around sums and quotients, not around letters and products."""

DUAL = [((real_part, a), {"Re a": 0}), *RADICALS]


@pytest.mark.parametrize("fast", [True, False])
@pytest.mark.parametrize(
    ("tokens", "expected", "how"),
    [*((*case, {}) for case in (*NUMBERS, *QUATERNIONS)), *((*case, {"dual": True}) for case in NUMBERS),
     *((*case, {"quaternions": False}) for case in TENSORS), *((*case, {"radicals": True}) for case in RADICALS),
     *((*case, {"radicals": True, "dual": True}) for case in DUAL)],
)  # fmt: skip
def test_a_display_has_these_readings(monkeypatch, tokens, expected, how, fast: bool) -> None:
    if not fast:
        monkeypatch.setattr(items, "coordinates", lambda value: None)
    assert shown(side(*tokens, **how)) == expected


@pytest.mark.parametrize(
    ("tokens", "expected"),
    [((I, T), {"I-T": 1}), ((T, I), {"T-I": 1}), ((a, I, T), {"a I-T": 1, "a (I-T)": 2})],
)
def test_a_multiple_of_the_unit_tensor_is_no_factor(tokens, expected) -> None:
    assert shown(side(*tokens, quaternions=False)) == expected


def test_functions_are_applied_and_squared() -> None:
    found = {latex(item.term): item.marks for item in side(f, two, a).readings().values()}
    assert {reading: marks for reading, marks in found.items() if not reading.startswith("-")} == {
        r"f\left(2\right)\, a": 1, r"f\left(2\, a\right)": 1, r"f\left(2\right) - a": 2, r"f\left(2 - a\right)": 2,
        r"\frac{f\left(2\right)}{a}": 2, r"f\left(\frac{2}{a}\right)": 2, r"\left(f^{2}\right)\left(a\right)": 2,
    }  # fmt: skip


def test_a_mark_in_front_is_of_what_follows_or_of_a_part_of_it() -> None:
    found = shown(side(real_part, a, b, dual=True))
    assert found == {"Re (a b)": 0, "Re a b": 0, "Re (a/b)": 1, "Re a-b": 1, "Re a/b": 1, "Re (a-b)": 2}


def forms(values: list[Residue]) -> Iterator[tuple[Residue, bool, int]]:
    """Every formula of letters in their order: its value, whether it is a difference, how many marks were put in."""
    if len(values) == 1:
        yield values[0], False, 0
    for k in range(1, len(values)):
        for x, left, m in forms(values[:k]):
            for y, right, n in forms(values[k:]):
                yield x * y, False, m + n + left + right  # brackets around differences
                yield x - y, True, m + n + 1 + right
                yield x / y, False, m + n + 1


@pytest.mark.parametrize("fast", [True, False])
@pytest.mark.parametrize("tokens", [(a, b), (a, b, a), (a, b, c), (a, b, c, d)])
def test_letters_have_all_their_formulas_with_the_fewest_marks(monkeypatch, tokens, fast: bool) -> None:
    if not fast:
        monkeypatch.setattr(items, "coordinates", lambda value: None)
    found = side(*tokens)
    expected: dict[int, int] = {}
    for value, difference, marks in forms([found.env.value(letter) for letter in tokens]):
        for number, more in ((value, 0), (-value, 1 + difference)):
            expected[number.value] = min(marks + more, expected.get(number.value, marks + more))
    assert {item.key[0]: item.marks for item in found.readings().values()} == expected


# ---- how many are listed ---------------------------------------------------------------------------------------------


def test_as_many_readings_are_listed_as_allowed() -> None:
    assert len(side(a, b, cap=6).readings()) == 6
    with pytest.raises(OpenError):
        side(a, b, cap=5).readings()
    with pytest.raises(OpenError):
        side(a, b, c, cap=27).readings()


@pytest.mark.parametrize(
    ("tokens", "cap", "opened"), [((a, b), 2, True), ((a, b), 3, False), ((a, plus, b), 1, False), ((v, w), 4, True)]
)
def test_a_stretch_is_open_beyond_the_cap(tokens, cap: int, opened: bool) -> None:
    found = side(*tokens, cap=cap)
    for _ in range(2):
        if opened:
            with pytest.raises(OpenError):
                found.table(0, len(tokens))
        else:
            assert found.table(0, len(tokens))


@pytest.mark.parametrize(
    ("tokens", "shape"),
    [((a,), Shape.ATOM), ((two,), Shape.NUMERAL), ((a, plus, b), Shape.SUM), ((a, dot, b), Shape.PRODUCT)],
)
def test_looks_say_what_may_stand_beside(tokens, shape: Shape) -> None:
    (item,) = side(*tokens).table(0, len(tokens)).values()
    assert item.shape is shape
