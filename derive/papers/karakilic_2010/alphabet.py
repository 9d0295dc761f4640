"""The letters of the paper, the marks of its own, and what its extraction keeps of them."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable
from itertools import pairwise
from typing import Any

from derive.algebra import Dual, Tensor, Vector, dual_part, real_part
from derive.algebra.mixed import MeaninglessError
from derive.proof.ratio import NotExactError

from ..evaluation import Env
from ..fields import Decimal60
from ..notation import define
from ..terms import ATOM, LIST, NOTATIONS, POWER, PRODUCT, RELATION, SUM, Letter, Term

HAT = "\N{COMBINING CIRCUMFLEX ACCENT}"
LOST = "()[]{}_^|/,;.Σ"
"""What lays a formula out. Signs, hats, stars and primes are compared; so are + − · × = ≠ < and all letters."""

_MARKS = (
    (r"\\hat\{(\w)\}", rf"\1{HAT}"),
    (r"\\(stackrel|overset)\{\\mathbf\{\w\}\}\{(\w)\}", r"\2"),  # an arrow, which the extraction shows as a letter
    (r"\\(mathbf|vec)\{([^{}]*)\}", r"\2"),
    (r"\\times", "×"), (r"\\cdot", "·"), (r"\\sum", "Σ"), (r"\\infty", "∞"), (r"\\neq", "≠"),
    (r"\\(begin|end)\{\w+\}|\\(left|right|frac|quad|\W)|[$&\s]", ""),
)  # fmt: skip


def marks(latex: str) -> str:
    """The marks of a formula as the extraction has it in LaTeX: commands for layout and arrows dropped."""
    for pattern, mark in _MARKS:
        latex = re.sub(pattern, mark, latex)
    return latex


# ---- letters --------------------------------------------------------------------------------------------------


def hat(name: str, kind: str, prime: str = "") -> Letter:
    """A dual quantity, under a hat."""
    return Letter(f"{name}^{prime}", kind, rf"\hat{{{name}}}{prime}", f"{name}{HAT}{prime}")


def real(name: str, index: int | None = None, star: bool = False, kind: str = "real") -> Letter:
    """A real number such as f, s₁ or b₁*."""
    mark, latex = "*" if star else "", name if index is None else f"{name}_{index}"
    digit = "" if index is None else str(index)
    return Letter(f"{name}{digit}{mark}", kind, f"{latex}^{{*}}" if star else latex, f"{name}{digit}{mark}")


def arrow(name: str, star: bool = False, seen_as: str | None = None) -> Letter:
    """A real vector, under an arrow; `seen_as` is what the extraction has in its place."""
    plain = f"{name}*" if star else name
    suffix = "" if seen_as is None else f" seen as {seen_as}"
    return Letter(f"vector {plain}{suffix}", "real vector", rf"\vec{{{name}}}" + ("^{*}" if star else ""),
                  seen_as or plain)  # fmt: skip


e = Letter("epsilon", "constant", "e", "e")
pi = Letter("pi", "constant", r"\pi", "p")

# ---- marks of this paper --------------------------------------------------------------------------------------


_norm, _tangent = NOTATIONS["norm"].value, NOTATIONS["tan"].value


def _power_of_tangent(exponent: int) -> Callable[[Env, Any], Any]:
    return lambda env, a: env.power(_tangent(env, a), exponent)


Sin = define("K10 Sin", r"\operatorname{{Sin}} {0}", "Sin{0}", PRODUCT, (POWER,), lambda env, a: env.field.sin(a))
Cos = define("K10 Cos", r"\operatorname{{Cos}} {0}", "Cos{0}", PRODUCT, (POWER,), lambda env, a: env.field.cos(a))
Tan = define("K10 Tan", r"\operatorname{{Tan}} {0}", "Tan{0}", PRODUCT, (POWER,), _tangent)
Tan2, Tan3 = (
    define(f"K10 Tan{k}", rf"\operatorname{{{{Tan}}}}^{k} {{0}}", f"Tan{k}{{0}}", PRODUCT, (POWER,),
           _power_of_tangent(k))
    for k in (2, 3)
)  # fmt: skip
natural = define("K10 natural", "e^{{{0}}}", "e{0}", POWER, (LIST,), lambda env, a: env.field.exp(a))
length = define("K10 length", r"\left\|{0}\right\|", "|{0}|", ATOM, (LIST,), _norm)
square_root = define("K10 power 1/2", r"\left({0}\right)^{{\frac{{1}}{{2}}}}", "({0})12", POWER, (LIST,),
                     lambda env, a: env.field.sqrt(a))  # fmt: skip
group = define("K10 group", r"\left({0}\right)", "({0})", ATOM, (LIST,), lambda env, a: a)
pair = define("K10 vectors side by side", r"{0}\, {1}", "{0}{1}", PRODUCT, (PRODUCT, PRODUCT),
              lambda env, a, b: a.dot(b))  # fmt: skip
inner = define("K10 row by column", r"{0}^{{T}}\, {1}", "{0}T{1}", PRODUCT, (ATOM, ATOM), lambda env, a, b: a.dot(b))
quadratic = define("K10 quadratic form", r"{0}^{{T}}\, {1}\, {0}", "{0}T{1}{0}", PRODUCT, (ATOM, ATOM),
                   lambda env, a, T: a.dot(T @ a))  # fmt: skip
parts = define("K10 parts", r"\left({0}, {1}\right)", "({0},{1})", ATOM, (LIST,),
               lambda env, a, b: Vector.dual(a, b) if isinstance(a, Vector) else Dual(a, b))  # fmt: skip
column = define("K10 column", r"\left({0}, {1}, {2}\right)", "({0},{1},{2})", ATOM, (LIST,),
                lambda env, *a: Vector(*a))  # fmt: skip
matrix = define(
    "matrix", r"\begin{{bmatrix}} {0} & {1} & {2} \\ {3} & {4} & {5} \\ {6} & {7} & {8} \end{{bmatrix}}",
    "{0}{1}{2}{3}{4}{5}{6}{7}{8}", ATOM, (LIST,), lambda env, *a: Tensor.from_entries(a),
)  # fmt: skip


def _at(structure: Any, *indices: int) -> Any:
    if not all(index in (1, 2, 3) for index in indices):
        raise MeaninglessError(f"no component {indices}")
    if isinstance(structure, Tensor):
        row, column = indices
        return structure[row - 1, column - 1]
    return tuple(structure)[indices[0] - 1]


entry = define("K10 entry", "{0}_{{{1}{2}}}", "{0}{1}{2}", ATOM, (ATOM,), lambda env, T, i, j: _at(T, i, j))
component = define("K10 component", "{0}_{{{1}}}", "{0}{1}", ATOM, (ATOM,), lambda env, v, i: _at(v, i))
coefficient = define("K10 coefficient", "{0}_{{{1}}}", "{0}{1}", ATOM, (ATOM,), lambda env, f, k: f(k))


def _compare(env: Env, relation: Callable[[Any, Any], bool], *sides: Any) -> bool:
    """Dual numbers in the order of their real parts, then of their dual parts; generic symbols have no order."""
    if not isinstance(env.field, Decimal60):
        raise NotExactError("an inequality")
    return all(relation((real_part(a), dual_part(a)), (real_part(b), dual_part(b))) for a, b in pairwise(sides))


at_least = define("K10 at least", r" \geq ", "≥", RELATION, (SUM,), lambda env, *a: _compare(env, operator.ge, *a))
ordered = define("K10 ordered", " < ", "<", RELATION, (SUM,), lambda env, *a: _compare(env, operator.lt, *a))


def _provided(env: Env, statement: Term, condition: Term) -> bool:
    """Where the condition cannot be decided, as for generic symbols, the statement has to hold without it."""
    try:
        needed = bool(env.value(condition))
    except NotExactError:
        needed = True
    return not needed or bool(env.value(statement))


provided = define("K10 provided", r"{0}, \quad {1}", "{0},{1}", LIST, (LIST,), _provided, lazy=True)
"""A formula with the domain printed beside it."""

i, j, k = (Letter(name, "index", name, name) for name in "ijk")


def _all_pairs(env: Env, body: Term) -> list[Any]:
    return [env.bound(i, a).bound(j, b).value(body) for a in (1, 2, 3) for b in (1, 2, 3)]


def _ordered_pairs(env: Env, body: Term, strict: bool) -> list[Any]:
    pairs = [(a, b) for a in (1, 2, 3) for b in (1, 2, 3) if a < b or (a == b and not strict)]
    return [env.bound(i, a).bound(j, b).value(body) for a, b in pairs]


everywhere = define("K10 everywhere", r"{0} \quad (i, j = 1, 2, 3)", "{0}", LIST, (LIST,),
                    lambda env, body: all(_all_pairs(env, body)), lazy=True)  # fmt: skip
sum_all = define("K10 sum over i and j", r"\sum_{{i, j}} {0}", "Σ{0}", PRODUCT, (PRODUCT,),
                 lambda env, body: sum(_all_pairs(env, body)), lazy=True)  # fmt: skip
sum_upper = define("K10 sum over i ≤ j", r"\sum_{{i \leq j}} {0}", "Σ{0}", PRODUCT, (PRODUCT,),
                   lambda env, body: sum(_ordered_pairs(env, body, False)), lazy=True)  # fmt: skip
sum_above = define("K10 sum over i < j", r"\sum_{{i < j}} {0}", "Σ{0}", PRODUCT, (PRODUCT,),
                   lambda env, body: sum(_ordered_pairs(env, body, True)), lazy=True)  # fmt: skip
