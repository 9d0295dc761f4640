"""Claims in plain text: what is refused and where, texts of terms, and values of the operations."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
import sympy

from derive.algebra import Quaternion, matrix
from derive.claims.language.claims import statement
from derive.claims.language.environment import Env
from derive.claims.language.letters import LETTERS, letter, letters
from derive.claims.language.names import Abbreviation, ClaimError, Scope, expanded
from derive.claims.language.operations import OPERATIONS, written
from derive.claims.language.printed import Symbol
from derive.claims.numbers.balls import Balls, precision
from derive.claims.numbers.kinds import KINDS
from derive.claims.numbers.series import SeriesField

LETTER = {
    "v": "vector", "w": "vector", "x": "real", "y": "real", "a": "real", "b": "positive", "c": "real", "n": "order",
    "k": "order", "R": "rotation", "A": "tensor", "B": "tensor", "q": "unit quaternion", "T": "pose", "xi": "twist",
    "p": "vector", "u": "unit vector", "f[k]": "vector",
}  # fmt: skip
SCOPE = Scope(
    {member: symbol for name, kind in LETTER.items() for member, symbol in letters(name, kind).items()},
    {"G": Abbreviation("G", ("w",), "I + skew(w)*norm(w)"), "L": Abbreviation("L", (), "L*2"),
     "M": Abbreviation("M", (), "x*skew(v)")},
)


def value(text: str, **given: object) -> bool:
    """Return whether a claim is true at one point, in balls."""
    claim = expanded(statement(text, SCOPE), SCOPE.abbreviations)
    with precision(256):
        values = {}
        for i, symbol in enumerate(s for s in claim.atoms(Symbol) if s.name in SCOPE.letters and s.quantity.varies):
            kind = KINDS.get(symbol.quantity.name)
            numbers = [Fraction((7 * i + 5 * j) % 11 - 4, 7) or Fraction(1, 3) for j in range(kind.size if kind else 0)]
            plain = [abs(number) for number in numbers] if symbol.name in ("b", "x") else numbers
            values[symbol] = given.get(symbol.name, kind.build(plain) if kind else 3)
        return bool(Env(Balls(), values, dual=False).value(claim))


@pytest.mark.parametrize("name", OPERATIONS)
def test_example_of_an_operation_has_a_value_and_is_its_own_text(name: str) -> None:
    row = OPERATIONS[name]
    text = row.example if row.gives == "truth" else f"{row.example} == {row.example}"
    claim = statement(text, SCOPE)
    assert statement(written(claim), SCOPE) == claim
    if name != "rate":  # which needs letters that move
        assert value(text)


@pytest.mark.parametrize(
    "text",
    ["-a**2 == -(a*a)", "a - (b - c) == a - b + c", "a/(b*c) == a/b/c", "(a + b)**2 == a**2 + 2*a*b + b**2",
     "not (a == b) or a == b", "(-a)**2 == a**2", "0.25 == 1/4", "1 <= 2 <= 2", "R*v != 2*v", "a == a == a",
     "cases(-x, x < 0, x) == norm(x)"],
)  # fmt: skip
def test_text_of_a_term_reads_as_the_term(text: str) -> None:
    claim = statement(text, SCOPE)
    assert statement(written(claim), SCOPE) == claim
    assert value(text)


IDENTITIES = (
    "exp(ad(xi)) == adjoint(exp(xi))", "adjoint(T)*xi == vect(T*skew(xi)*inverse(T))", "log(exp(xi)) == skew(xi)",
    "log(exp(skew(v))) == skew(v)", "rotation_of(q)*v == q*v*conjugate(q)", "rotation_of(exp(v/2)) == exp(skew(v))",
    "left_jacobian(exp(skew(v)), v) == dexp(v)", "right_jacobian(exp(skew(v)), v) == transpose(dexp(v))",
    "left_jacobian(cay(3, v), v) == dcay(3, v)", "jacobian(norm(v), v) == transpose(v)/norm(v)",
    "jacobian(cross(v, w), v) == -skew(w)", "kron(A, B)*vec(R) == vec(B*R*transpose(A))",
    "limit((a*x - sin(a*x))/x**3, x, 0) == a**3/6", "limit((a*x + 1)/(x + b), x, infinity) == a",
    "series(exp(skew(v)), v, 2) == I + skew(v) + skew(v)**2/2", "integral(exp(x), x, 0, a) == exp(a) - 1",
    "det(block([[A, zeros(3, 3)], [B, A]])) == det(A)**2", "entry(T, 4, 4) == 1",
    "sum(k, 0, n, binomial(n, k)*x**k) == (1 + x)**n", "p(3, x) == 1 - 3*x", "cosh(x)**2 == 1 + sinh(x)**2",
    "acos(cos(b)) == b", "asin(sin(b)) == b", "floor(7/2) == 3", "atan2(sin(b), cos(b)) == b",
    "stack(v, w) == block([[v], [w]])", "entry(A, 2, 3) == entry(transpose(A), 3, 2)",
    "G(2*v) == I + 4*norm(v)*skew(v)", "cases(-x, x < 0, x) == norm(x)", "cases(-x, x < 0, x, 0 <= x) == norm(x)",
    "sinc(x)*x == sin(x)", "log(q) == log(-(-q))", "dexp(v)*v == v", "matrix([[a, b], [c, x]])*matrix([[x], [y]]) == "
    "matrix([[a*x + b*y], [c*x + x*y]])", "left_jacobian(exp(xi), xi)*xi == xi", "x**b == exp(b*log(x))",
    "product(k, 1, n, 2*k) == 2**n*factorial(n)",
    "product(k, 1, 2, exp(skew(f[k]))) == exp(skew(f[1]))*exp(skew(f[2]))",
    "sum(k, 0, infinity, x**k/factorial(k)) == exp(x)", "limit((1 + x/n)**n, n, infinity) == exp(x)",
    "limit((I + skew(v)/n)**n, n, infinity) == exp(skew(v))", "limit((I + A/n)**(2*n), n, infinity) == exp(2*A)",
    "at(jacobian(R*exp(skew(v))*w, v), v, 0) == -R*skew(w)", "at(x**2 + y, x, y) == y**2 + y",
    "at(M, x, 2) == 2*skew(v)", "limit(M*x, x, 3) == 9*skew(v)",
    "jacobian(R*w, R) == kron(transpose(w), I)", "jacobian(norm(u)*u, u) == I + dyad(u, u)",
    "jacobian(norm(q)**2, q) == 2*transpose(stack(scalar(q), vector_part(q)))",
    "expectation((A*w)*transpose(A*w), w, dyad(v, v)) == A*v*transpose(A*v)",
    "expectation((x + b)**2, x, a**2) == a**2 + b**2", "sum(k, 1, 10**1, k) == 55",
)  # fmt: skip
"""Identities that hold at the points of `value`; with one sign changed they fail."""


@pytest.mark.parametrize("text", IDENTITIES)
def test_identity_is_true_and_false_with_another_side(text: str) -> None:
    assert value(text)
    left, _, right = text.partition(" == ")
    assert not value(f"2*({left}) == {right}")


def test_derivative_is_taken_at_the_argument_of_a_definition() -> None:
    scope = Scope(SCOPE.letters, {"J": Abbreviation("J", ("w",), "jacobian(cross(w, v)*norm(w), w)")})
    claim = expanded(statement("J(v) == J(v)", scope), scope.abbreviations)
    bound = {part.arguments[1].name for part in claim.arguments}
    assert bound.isdisjoint({"v"})  # the bound letter is not mistaken for v


def test_definitions_do_not_know_letters_of_their_callers() -> None:
    scope = Scope(SCOPE.letters, {"M": Abbreviation("M", (), "x*skew(v)"), "H": Abbreviation("H", ("x",), "M + x*I")})
    claim = expanded(statement("H(2) == M", scope), scope.abbreviations)
    assert written(claim) == "x*skew(v) + 2*I == x*skew(v)"
    fresh = Scope(SCOPE.letters, {"M": Abbreviation("M", (), "x*skew(v)")})
    with pytest.raises(ClaimError, match="here it is a number"):
        statement("limit(M, v, 0) == M", fresh)


def test_roots_that_differ_on_both_sides_have_no_derivative() -> None:
    with pytest.raises(ArithmeticError):
        value("jacobian(norm(v), v) == transpose(v)", v=matrix.shaped([[Fraction(0)]] * 3))


@pytest.mark.parametrize("body", ["norm(x)/x", "sqrt(x**2)/x", "atan2(x, -1)", "atan2(x**3, -x**2)", "acos(cos(x))/x"])
def test_values_that_differ_on_both_sides_have_no_limit(body: str) -> None:
    with pytest.raises(ArithmeticError):
        value(f"limit({body}, x, 0) == 1")


@pytest.mark.parametrize("name", ["sin", "cos", "exp", "log", "sqrt", "atan"])
def test_series_of_functions(name: str) -> None:
    s = sympy.Symbol("s")
    wanted = sympy.series(getattr(sympy, name)((1 + s) / (1 - s / 3)), s, 0, 6).removeO()
    with precision(256):
        field = SeriesField(Balls(), 6)
        at = field.at(Fraction(1), 1)
        found = getattr(field, name)(at / (1 - (at - 1) / 3))
        for k in range(6):
            assert math.isclose(float(found[k]), float(wanted.coeff(s, k)), rel_tol=1e-12, abs_tol=1e-30)


REFUSED = (
    ("v*w == 1", 1, "write dot, cross"), ("foo(v) == 1", 1, "unknown operation 'foo'"), ("v + 1", 1, "a relation"),
    ("__import__('os') == 1", 1, "__import__"), ("v.x == 1", 1, "'v.x'"), ("(lambda: 1)() == 1", 1, "lambda"),
    ("x == 9**9**9", 9, "too large"), ("x**99 == 1", 4, "up to 64"), ("x^2 == 1", 1, "(write ** for a power)"),
    ("dot(x, v) == 1", 1, "columns of one size"),
    ("skew(x) == I", 6, "skew takes a vector"), ("cross(v) == v", 1, "takes 2 arguments"), ("z == v", 1, "letter 'z'"),
    ("x = 1", 3, "a relation is =="), ("v.T == 1", 1, "write transpose(…)"), ("R@v == v", 1, "write * for a product"),
    ("x == a/0", 8, "division by zero"), ("[1] == x", 1, "list"),
    ("entry(v, 4) == 1", 10, "from 1 to 3"), ("matrix([[1], [2, 3]]) == I", 1, "different lengths"),
    ("'a' == x", 1, "'a'"), ("v < w", 5, "an inequality takes numbers"), ("not v", 5, "a relation is expected"),
    ("R == q", 6, "compared with a quaternion"), ("R + v == R", 1, "has no meaning"), ("v/R == v", 1, "write inverse"),
    ("cases(x, x) == 1", 1, "values with relations"), ("cases(x, x > 0, v) == 1", 1, "of one kind"),
    ("sum(k, 0, x, k) == 1", 11, "takes an integer"), ("jacobian(v, 2*v) == I", 13, "varies a letter"),
    ("jacobian(T, T) == I", 13, "not a pose"), ("series(u, u, 1) == u", 11, "not a real unit vector"),
    ("v**2 == 1", 1, "write norm(v)**2"), ("f == v", 1, "unknown letter 'f'"), ("f[9] == v", 3, "from 0 to 6"),
    ("f[x] == v", 3, "an index is an integer"), ("w[1] == v", 1, "no family 'w'"),
    ("infinity + 1 == x", 1, "no meaning"),
    ("product(k, 1, infinity, k) == 1", 15, "takes an integer"), ("at(q, q, 0) == q", 10, "got 0"),
    ("limit(M, v, 0) == M", 1, "here it is a number"),
    ("L == 1", 1, "uses itself"), ("G(v, w) == I", 1, "takes 1"),
    ("block([[A], [v]]) == A", 1, "3, 1 columns"), ("identity(99) == I", 1, "from 1 to 12"), ("", 1, "nothing"),
    ("x == 1e99", 6, "up to 1e20"), ("(" * 60 + "x" + ")" * 60 + " == x == -" + "-" * 60 + "x", None, "brackets"),
    ("(" * 41 + "x" + ")" * 41 + " == x", 41, "brackets"), ("series(x, x, -1) == 1", 14, "from 0 to 64"),
    ("inverse(v) == v", 9, "takes no vector"), ("sqrt(v) == v", 6, "takes no vector"),
    ("x if x else x", 1, "not understood"), ("x == θ", 6, "'θ'"), ("x == True", 6, "True"), ("norm(*v) == 1", 6, "*v"),
    ("x == f'{x}'", 6, "f'"), ("x in v", 1, "x in v"), (" + ".join(["x"] * 2000) + " == x", 1, "are the most"),
)  # fmt: skip


@pytest.mark.parametrize(("text", "column", "message"), REFUSED)
def test_text_that_is_no_claim_is_refused_with_its_place(text: str, column: int | None, message: str) -> None:
    with pytest.raises(ClaimError) as error:
        expanded(statement(text, SCOPE), SCOPE.abbreviations)
    assert message in error.value.message
    assert column in (None, error.value.column)


@pytest.mark.parametrize("kind", [*LETTERS, *(f"constant {kind}" for kind in LETTERS)])
def test_every_kind_of_letter_has_values(kind: str) -> None:
    symbol, shape = letter("a", kind)
    row = KINDS.get(symbol.quantity.name)
    if row is None:
        assert kind.endswith(("order", "branch", "sign"))
        return
    built = row.build([Fraction(j + 2, 3) for j in range(row.size)])
    assert {"quaternion": isinstance(built, Quaternion), "number": not hasattr(built, "map"),
            "integer": not hasattr(built, "map")}.get(shape, shape == matrix.shape(built))  # fmt: skip


@pytest.mark.parametrize(
    ("name", "kind"), [("I", "real"), ("a b", "real"), ("a", "vectr"), ("a", "constant"), ("θ", "real")]
)
def test_letters_are_refused(name: str, kind: str) -> None:
    with pytest.raises(ClaimError):
        letter(name, kind)
