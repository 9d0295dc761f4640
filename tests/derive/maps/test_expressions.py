"""Text of φ: accepted grammar, reasons given for refusals, no execution of user text; evaluation of expressions."""

from __future__ import annotations

import builtins
import os
import random
import re
from collections.abc import Callable
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy

from derive.algebra import Dual, functions
from derive.claims.language.grammar import DECIMAL_EXPONENT_MAX, DIGITS_MAX
from derive.maps import PhiError, grammar, parameterization
from derive.maps.any_phi import expressions
from derive.maps.any_phi.expressions import parity, parsed
from derive.maps.elementary import FUNCTIONS, alpha, evaluate

WORDS = (
    "alpha", "n", "pi", "1", "2", "40", "0.1", "1e-3", ".5", "+", "-", "*", "/", "**", "(", ")", ",", ".", "sin", "cos",
    "tan", "asin", "atan", "exp", "log", "sqrt", "sinh", "lambda", ":", "__import__", "'os'", "system", "eval", "open",
    "[", "]", "{", "}", "=", ":=", "if", "else", "for", "in", "1j", "True", "None", "@", "_", "__class__", ";", "\n",
    "9" * 40,
)  # fmt: skip


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("sin(alpha/6)", sympy.sin(alpha / 6)),
        ("4*tan(alpha/4)", 4 * sympy.tan(alpha / 4)),
        ("alpha/(1 + alpha**2/40)", alpha / (1 + alpha**2 / 40)),
        ("2*n*tan(alpha/(2*n))", 6 * sympy.tan(alpha / 6)),
        ("0.1*alpha - -1.5e-2*alpha", sympy.Rational(23, 200) * alpha),
        (" 4*tan(α/4) + α", 4 * sympy.tan(alpha / 4) + alpha),
        ("sqrt(2)*sin(alpha/pi)", sympy.sqrt(2) * sympy.sin(alpha / sympy.pi)),
    ],
)
def test_accepted_texts(text: str, expected: sympy.Expr):
    assert parsed(text, 3) == expected
    assert parity(expected) == -1


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("__import__('os').system('true')", "not understood in phi: \"__import__"),
        ("alpha.real", "not understood in phi: 'alpha.real'"),
        ("beta*2", "not understood in phi: 'beta'"),
        ("[alpha]", "not understood in phi"),
        ("sin(alpha, 2)", "not understood in phi"),
        ("alpha#c", "not understood in phi: '#'"),
        *((f"alpha{mark}", f"not understood in phi: {mark!r}") for mark in "\n\r\f\v\t\\\x85\u2028\uff11"),
        ("\nalpha", "not understood in phi: '\\n'"),
        ("(alpha\n/2)", "not understood in phi: '\\n'"),
        ("alpha^3 + alpha", "(write ** for a power)"),
        ("alpha +", "phi is no expression"),
        ("", "phi is no expression"),
        ("alpha/0", "divides by zero"),
        ("alpha/(1 - 1)", "divides by zero"),
        ("alpha**alpha", "powers in phi are numbers"),
        ("alpha*9**9**9", "powers in phi are numbers"),
        ("alpha*(9**16)**16*(((9**16)**16)**16)", "too large"),
        ("1e99*alpha", "up to 1e20"),
        ("1" * 50 + "*alpha", "at most 30 digits"),
        ("-" * 40 + "alpha", "brackets in each other"),
        ("+".join(["2"] * 99), "parts, and 150 are the most"),
        ("x" * 1000, "1000 characters"),
        ("cos(alpha)", "not odd by its structure"),
        ("alpha*(alpha + 1)**2", "not odd by its structure"),
        ("alpha*exp(alpha)", "not odd by its structure"),
        ("alpha**3", "phi'(0) = 0"),
        ("-alpha", "phi'(0) = -1"),
        ("alpha*sqrt(alpha**2 - 1)", "no real number"),
    ],
)
def test_refusals_name_their_reason(text: str, reason: str):
    with pytest.raises(PhiError, match=re.escape(reason)):
        parameterization(text, "mine")


AT_LIMITS = [
    (lambda k: f"alpha**{k}", expressions.EXPONENT_MAX),
    (lambda k: f"alpha**(-{k})", expressions.EXPONENT_MAX),
    (lambda k: f"alpha**(1/{k})", expressions.EXPONENT_MAX),
    (lambda k: f"alpha**(-{expressions.EXPONENT_MAX - 1}/{k})", expressions.EXPONENT_MAX),
    (lambda k: "1" * k, DIGITS_MAX),
    (lambda k: f"1.{'1' * (k - 1)}", DIGITS_MAX),
    (lambda k: f"1e{k}", DECIMAL_EXPONENT_MAX),
    (lambda k: f"1e-{k}", DECIMAL_EXPONENT_MAX),
    (lambda k: f"alpha{' ' * (k - 7)}+0", grammar.PHI.characters_max),
]


@pytest.mark.parametrize(("write", "limit"), AT_LIMITS)
def test_limits_hold_exactly(write: Callable[[int], str], limit: int):
    assert parsed(write(limit)) is not None
    with pytest.raises(PhiError):
        parsed(write(limit + 1))


@pytest.mark.parametrize("name", ["", "a b", "1a", "lambda", "ä", "a-b", "../a"])
def test_names_are_identifiers(name: str):
    with pytest.raises(PhiError, match="an identifier"):
        parameterization("alpha/2", name)


def test_user_text_is_never_run(monkeypatch: pytest.MonkeyPatch):
    """Parse 1000 random strings of words; expect an expression or a `PhiError`, and no side effect."""

    def called(*_: object, **__: object) -> None:
        raise AssertionError("user text was run")

    for module, name in ((os, "system"), (os, "popen"), (builtins, "eval"), (builtins, "exec"), (builtins, "open")):
        monkeypatch.setattr(module, name, called)
    draw, found = random.Random(2023), 0
    for _ in range(1000):
        text = draw.choice(("", " ")).join(draw.choices(WORDS, k=draw.randrange(1, 12)))
        try:
            found += isinstance(parsed(text, 3), sympy.Expr)
        except PhiError:
            continue
    assert found > 10


# --- evaluation -------------------------------------------------------------------------------------------------------

a = sympy.Symbol("a")
AT = Fraction(5, 16)
EXPRESSIONS = (
    sympy.tan(a / 4) ** 2 - 3 * a + 1,
    sympy.cot(a) / (a * (1 + a**2)),
    sympy.sqrt(1 + a) ** 3 + sympy.cbrt(a) ** -2 + a ** sympy.Rational(-3, 2),
    a / 7 + sympy.Rational(2, 3) + sympy.pi * a,
    sum(getattr(sympy, name)(a / 3) for name in FUNCTIONS),
)


@pytest.mark.smoke
@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_values_and_slopes_match_sympy(expression: sympy.Expr) -> None:
    with mpmath.workdps(30):
        at = mpmath.mpf(AT.numerator) / AT.denominator
        found = evaluate(expression, a, Dual(at, mpmath.mpf(3)))
        there = {a: sympy.Rational(AT.numerator, AT.denominator)}
        for got, wanted in ((found.re, expression), (found.du, 3 * expression.diff(a))):
            assert mpmath.almosteq(got, mpmath.mpf(wanted.subs(there).evalf(35)), rel_eps=mpmath.mpf(10) ** -27)
        assert mpmath.almosteq(evaluate(expression, a, at), found.re)


@pytest.mark.smoke
def test_rational_functions_of_fractions_are_fractions() -> None:
    assert evaluate((a**3 - 1) / (a + 2) + sympy.Rational(1, 3), a, AT) == (AT**3 - 1) / (AT + 2) + Fraction(1, 3)


@pytest.mark.smoke
def test_every_part_is_computed_once() -> None:
    asked: list[str] = []

    def told(name: str) -> Callable[[Any], Any]:
        def function(value: Any) -> Any:
            asked.append(name)
            return getattr(functions, name)(value)

        return function

    library = SimpleNamespace(sin=told("sin"), cos=told("cos"))
    expression = sympy.sin(a) * sympy.tan(a) + sympy.cot(a) ** 2 - sympy.cos(a) / sympy.cos(2 * a)
    evaluate(expression, a, mpmath.mpf(1), library)
    assert sorted(asked) == ["cos", "cos", "sin"]


@pytest.mark.smoke
def test_other_functions_and_divisions_by_zero_are_refused() -> None:
    for expression in (1 / a, sympy.cot(a), a**-2):
        for zero in (0.0, mpmath.mpf(0), np.float64(0), Fraction(0)):  # a NumPy quotient would be infinite
            if not (isinstance(zero, Fraction) and expression.has(sympy.cot)):
                with pytest.raises(ZeroDivisionError):
                    evaluate(expression, a, zero)
    other = sympy.Symbol("b")
    for expression in (sympy.gamma(a), 2**a, a**sympy.pi, a**a, other, sympy.sin(a + other), other**2):
        with pytest.raises(ValueError, match="not an elementary expression in a: "):
            evaluate(expression, a, 1.0)
