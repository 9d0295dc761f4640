"""Symbols and operators of the paper, and characters of a formula kept by its text extraction."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable
from itertools import pairwise
from typing import Any

from ...algebra import Dual, Tensor, Vector, dual_part, real_part
from ...algebra.element import NotExactError
from ...algebra.mixed import MeaninglessError
from ..language.environment import Env
from ..language.operator_table import cos, define, norm, sin, tan
from ..language.printed import ATOM, LIST, POWER, PRODUCT, RELATION, SUM, OperatorRow, Symbol, Term, Trait

HAT = "\N{COMBINING CIRCUMFLEX ACCENT}"
LOST = "()[]{}_^|/,;.Σ"
"""Layout characters, which are ignored in comparisons."""

_LATEX = (
    (r"\\mathbf\{\\hat\{r\}\}|\^\{\\mathbf\{r\}\}", ""),  # arrows, extracted as letters
    (r"\\hat\{(\w)\}", rf"\1{HAT}"),
    (r"\\(stackrel|overset)\{\\mathbf\{\w\}\}\{(\w)\}", r"\2"),  # arrows over a letter
    (r"\\(mathbf|vec)\{([^{}]*)\}", r"\2"),
    (r"\\times", "×"), (r"\\cdot", "·"), (r"\\sum", "Σ"), (r"\\infty", "∞"), (r"\\neq", "≠"),
    (r"\\(begin|end)\{\w+\}|\\(left|right|frac|quad|\W)|[$&\s]", ""),
)


def shown(latex: str) -> str:
    """Return the characters of a formula in the extracted text, without layout commands and arrows."""
    for pattern, character in _LATEX:
        latex = re.sub(pattern, character, latex)
    return latex


def hat(name: str, quantity: str, prime: str = "") -> Symbol:
    """Return the symbol of a dual quantity, with a hat."""
    return Symbol(f"{name}^{prime}", quantity, rf"\hat{{{name}}}{prime}", f"{name}{HAT}{prime}")


def real(name: str, index: int | None = None, star: bool = False, quantity: str = "real") -> Symbol:
    """Return the symbol of a real number such as f, s₁ or b₁*."""
    suffix, latex = "*" if star else "", name if index is None else f"{name}_{index}"
    digit = "" if index is None else str(index)
    return Symbol(f"{name}{digit}{suffix}", quantity, f"{latex}^{{*}}" if star else latex, f"{name}{digit}{suffix}")


def arrow(name: str, star: bool = False, seen_as: str | None = None) -> Symbol:
    """Return the symbol of a real vector, with an arrow; `seen_as` replaces it in the extracted text."""
    plain = f"{name}*" if star else name
    suffix = "" if seen_as is None else f" seen as {seen_as}"
    return Symbol(f"vector {plain}{suffix}", "real vector", rf"\vec{{{name}}}" + ("^{*}" if star else ""),
                  seen_as or plain)


e = Symbol("epsilon", "dual unit", "e", "e")
pi = Symbol("pi", "π", r"\pi", "p")
i, j, k = (Symbol(name, "index", name, name) for name in "ijk")


# ---- operators ------------------------------------------------------------------------------------------------


def _function(name: str, function: OperatorRow, exponent: int = 1) -> OperatorRow:
    """Return a capitalized function such as Sin, or a power of it."""
    shown, power = ("", "") if exponent == 1 else (f"^{exponent}", str(exponent))
    return define(f"K10 {name}{power}", rf"\operatorname{{{{{name}}}}}{shown} {{0}}", f"{name}{power}{{0}}", PRODUCT,
                  (POWER,), lambda env, a: env.field.power(function.value(env, a), exponent), traits=function.traits)


Sin, Cos = _function("Sin", sin), _function("Cos", cos)
Tan = _function("Tan", tan)
Tan2, Tan3 = _function("Tan", tan, 2), _function("Tan", tan, 3)
length = define("K10 length", r"\left\|{0}\right\|", "|{0}|", ATOM, (LIST,), norm.value, traits=norm.traits)
square_root = define("K10 power 1/2", r"\left({0}\right)^{{\frac{{1}}{{2}}}}", "({0})12", POWER, (LIST,),
                     lambda env, a: env.field.sqrt(a))
group = define("K10 group", r"\left({0}\right)", "({0})", ATOM, (LIST,), lambda env, a: a)
pair = define("K10 vectors side by side", r"{0}\, {1}", "{0}{1}", PRODUCT, (PRODUCT, PRODUCT),
              lambda env, a, b: a.dot(b))
inner = define("K10 row by column", r"{0}^{{T}}\, {1}", "{0}T{1}", PRODUCT, (ATOM, ATOM), lambda env, a, b: a.dot(b))
quadratic = define("K10 quadratic form", r"{0}^{{T}}\, {1}\, {0}", "{0}T{1}{0}", PRODUCT, (ATOM, ATOM),
                   lambda env, a, T: a.dot(T @ a))
parts = define("K10 parts", r"\left({0}, {1}\right)", "({0},{1})", ATOM, (LIST,),
               lambda env, a, b: Vector.dual(a, b) if isinstance(a, Vector) else Dual(a, b))
column = define("K10 column", r"\left({0}, {1}, {2}\right)", "({0},{1},{2})", ATOM, (LIST,), lambda env, *a: Vector(*a))
matrix = define(
    "matrix", r"\begin{{bmatrix}} {0} & {1} & {2} \\ {3} & {4} & {5} \\ {6} & {7} & {8} \end{{bmatrix}}",
    "{0}{1}{2}{3}{4}{5}{6}{7}{8}", ATOM, (LIST,), lambda env, *a: Tensor.from_entries(a),
)


def _at(structure: Any, *indices: int) -> Any:
    if not all(index in (1, 2, 3) for index in indices):
        raise MeaninglessError(f"no component {indices}")
    if isinstance(structure, Tensor):
        row, column = indices
        return structure[row - 1, column - 1]
    return tuple(structure)[indices[0] - 1]


entry = define("K10 entry", "{0}_{{{1}{2}}}", "{0}{1}{2}", ATOM, (ATOM,), lambda env, T, i, j: _at(T, i, j))
coefficient = define("K10 coefficient", "{0}_{{{1}}}", "{0}{1}", ATOM, (ATOM,), lambda env, f, k: f(k))
component = define("K10 component", "{0}_{{{1}}}", "{0}{1}", ATOM, (ATOM,), lambda env, v, i: _at(v, i))


def _compare(env: Env, relation: Callable[[Any, Any], bool], *sides: Any) -> bool:
    """Compare dual numbers by real parts, then by dual parts; raise for generic symbols."""
    if not env.field.ordered:
        raise NotExactError("an inequality")
    return all(relation((real_part(a), dual_part(a)), (real_part(b), dual_part(b))) for a, b in pairwise(sides))


at_least = define("K10 at least", r" \geq ", "≥", RELATION, (SUM,), lambda env, *a: _compare(env, operator.ge, *a))
ordered = define("K10 ordered", " < ", "<", RELATION, (SUM,), lambda env, *a: _compare(env, operator.lt, *a))


def _provided(env: Env, statement: Term, condition: Term) -> bool:
    """Return whether the condition implies the statement; an undecidable condition counts as true."""
    try:
        needed = bool(env.value(condition))
    except NotExactError:
        needed = True
    return not needed or bool(env.value(statement))


provided = define("K10 provided", r"{0}, \quad {1}", "{0},{1}", LIST, (LIST,), _provided, lazy=True, traits=Trait.JOINS)
"""Formula with its printed domain."""


def _at_pairs(env: Env, body: Term, related: Callable[[int, int], bool] = lambda a, b: True) -> list[Any]:
    return [env.bound(i, a).bound(j, b).value(body) for a in (1, 2, 3) for b in (1, 2, 3) if related(a, b)]


everywhere = define("K10 everywhere", r"{0} \quad (i, j = 1, 2, 3)", "{0}", LIST, (LIST,),
                    lambda env, body: all(_at_pairs(env, body)), lazy=True)
sum_all = define("K10 sum over i and j", r"\sum_{{i, j}} {0}", "Σ{0}", PRODUCT, (PRODUCT,),
                 lambda env, body: sum(_at_pairs(env, body)), lazy=True)
sum_upper = define("K10 sum over i ≤ j", r"\sum_{{i \leq j}} {0}", "Σ{0}", PRODUCT, (PRODUCT,),
                   lambda env, body: sum(_at_pairs(env, body, operator.le)), lazy=True)
sum_above = define("K10 sum over i < j", r"\sum_{{i < j}} {0}", "Σ{0}", PRODUCT, (PRODUCT,),
                   lambda env, body: sum(_at_pairs(env, body, operator.lt)), lazy=True)
