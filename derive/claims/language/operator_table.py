"""Table of operators with their LaTeX, their characters in the extracted text, and their values.

A call of an operator builds a term: ``equal(R, I + 2 * q * skew(q))``. Papers add their own operators with `define`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from functools import reduce
from itertools import count, islice, pairwise, permutations
from typing import Any

from sympy import LeviCivita

from ...algebra import Quaternion, Structure, Tensor, Vector, matrix
from ...algebra.element import NotExactError
from ..numbers.balls import BlurredError
from ..numbers.fields import UndefinedError, innermost
from . import values
from .environment import Env
from .printed import (
    ATOM,
    LIST,
    OPERATORS,
    POWER,
    PRODUCT,
    RELATION,
    SUM,
    Apply,
    Number,
    OperatorRow,
    Symbol,
    Term,
    Trait,
)


def define(name: str, *row: Any, **rest: Any) -> OperatorRow:
    """Add an operator with the fields of `OperatorRow` to the table and return it; its call builds a term."""
    if name in OPERATORS:
        raise ValueError(f"operator {name!r} is defined twice")
    OPERATORS[name] = OperatorRow(name, *row, **rest)
    return OPERATORS[name]


# ---- arithmetic: terms built by Python's operators -------------------------------------------------------------

define("plus", "{0} + {1}", "{0}+{1}", SUM, (SUM, PRODUCT), lambda env, a, b: values.add(a, b))
define("minus", "{0} - {1}", "{0}-{1}", SUM, (SUM, PRODUCT), lambda env, a, b: values.add(a, values.negative(b)))
define("negative", "-{0}", "-{0}", SUM, (PRODUCT,), lambda env, a: values.negative(a))
define("times", r"{0}\, {1}", "{0} {1}", PRODUCT, (PRODUCT, PRODUCT), lambda env, a, b: values.multiply(a, b))
over = define("over", r"\frac{{{0}}}{{{1}}}", "{0}/{1}", POWER, (LIST, LIST), lambda env, a, b: _quotient(env, a, b))


def _quotient(env: Env, a: Any, b: Any) -> Any:
    size = b.norm2() if isinstance(b, Quaternion) else b
    if not isinstance(size, Structure | values.Either) and env.field.vanishes(innermost(size)):
        raise UndefinedError("division by zero")
    return values.divide(a, b)


def _root(env: Env, a: Any) -> Any:
    if isinstance(a, Quaternion) and all(c == 0 for c in a.vector):
        a = a.scalar
    return env.field.power(a, Fraction(1, 2)) if isinstance(a, Quaternion) else env.field.sqrt(a)


root = define("root", r"\sqrt{{{0}}}", "√{0}", POWER, (LIST,), _root)
pm = define("pm", r"\pm {0}", "±{0}", SUM, (PRODUCT,), lambda env, a: values.Either(a, values.negative(a)))
bracket = define("bracket", r"\left[{0}\right]", "({0})", ATOM, (LIST,), lambda env, a: a)


# ---- relations and lists --------------------------------------------------------------------------------------


def _chain(env: Env, *sides: Any) -> bool:
    return all(values.equal(env.field, env.now(a), env.now(b)) for a, b in pairwise(sides))


equal = define("equal", " = ", "=", RELATION, (SUM,), _chain)
both = define("both", r" ;\quad ", ";", LIST, (LIST,), lambda env, *parts: all(parts), traits=Trait.JOINS)
nonzero = define("nonzero", r"{0} \neq 0", "{0}≠0", RELATION, (SUM,),
                 lambda env, a: not values.equal(env.field.certain, env.now(a), 0), traits=Trait.DELICATE)
negated = define("negated", r"\neg\left({0}\right)", "not {0}", RELATION, (LIST,),
                 lambda env, a: not env.certain.value(a), lazy=True, traits=Trait.DELICATE)


def _implied(env: Env, premise: Term, conclusion: Term) -> bool:
    """Return whether a premise implies a conclusion, which must be true where the premise is undecidable."""
    try:
        return not env.certain.value(premise) or bool(env.value(conclusion))
    except NotExactError:
        if env.value(conclusion):
            return True
        raise


implies = define("implies", r"{0} \Rightarrow {1}", "{0}⇒{1}", LIST, (LIST, LIST), _implied, lazy=True,
                 traits=Trait.DELICATE | Trait.JOINS)
iff = define("iff", r"{0} \Leftrightarrow {1}", "{0}⇔{1}", LIST, (LIST, LIST), lambda env, a, b: a == b,
             traits=Trait.DELICATE | Trait.JOINS)
remark = define("remark", r"{0},\quad {1}", "{0},{1}", LIST, (LIST, LIST), lambda env, statement, words: statement,
                traits=Trait.JOINS)


def words(latex: str, text: str) -> Symbol:
    """Return a symbol for printed words without a value, such as "a ∈ R", for use in `remark`."""
    return Symbol(f"words:{text}", "words", latex, text)


def _cases(env: Env, *arms: Term) -> Any:
    for value, condition in zip(arms[::2], arms[1::2], strict=True):
        if env.value(condition):
            return env.value(value)
    raise UndefinedError("no case applies")


def cases(*arms: tuple[Any, Term]) -> Apply:
    """Return a term defined by cases: ``cases((value, condition), ...)``."""
    name = f"cases{len(arms)}"
    if name not in OPERATORS:
        rows = range(0, 2 * len(arms), 2)
        inside = r"\\ ".join(f"{{{i}}}, & {{{i + 1}}}" for i in rows)
        latex = rf"\begin{{{{cases}}}} {inside} \end{{{{cases}}}}"
        text = ",".join(f"{{{i}}},{{{i + 1}}}" for i in rows)
        define(name, latex, text, ATOM, (LIST,), _cases, lazy=True, traits=Trait.DELICATE)
    return Apply(name, *(part for arm in arms for part in arm))


infinity = Symbol("infinity", "∞", r"\infty", "∞")


def _counting(counted: Callable[..., int]) -> Callable[..., int]:
    def value(env: Env, *numbers: Any) -> int:
        if not all(isinstance(number, int) for number in numbers):
            raise NotExactError("a count of what is no integer")
        if any(number < 0 for number in numbers):
            raise UndefinedError("a count of a negative number")
        return counted(*numbers)

    return value


factorial = define("factorial", "{0}!", "{0}!", ATOM, (ATOM,), _counting(math.factorial))


TERMS_MAX, NEGLIGIBLE = 400, 12
"""Terms of an infinite sum, after which it is not known to converge, and negligible ones in a row that end it."""


def _over_index(combined: Callable[[Any, Any], Any], empty: int) -> Callable[..., Any]:
    """Return the value of a sum or product; an infinite one ends where its terms have become negligible."""

    def value(env: Env, index: Term, low: Term, high: Term, body: Term) -> Any:
        first, last = (None if end == infinity else env.value(end) for end in (low, high))
        if not (isinstance(first, int) and isinstance(last, int | None)):
            raise NotExactError("a sum of n terms")
        if last is None and not env.field.ordered:
            raise NotExactError("an infinite sum")
        terms = (env.bound(index, k).value(body) for k in count(first))
        if last is not None:
            return reduce(combined, list(islice(terms, max(0, last + 1 - first))) or [empty])
        total, small = next(terms), 0
        for term in islice(terms, TERMS_MAX):
            total = combined(total, term)
            small = small + 1 if all(map(env.field.negligible, values.coefficients(term))) else 0
            if small == NEGLIGIBLE:
                return total
        raise BlurredError

    return value


def _with_index(name: str, symbol: str, value: Callable[..., Any]) -> OperatorRow:
    latex = symbol + "_{{{0}={1}}}^{{{2}}} {3}"
    return define(name, latex, "{0}={1}{2}{3}", PRODUCT, (LIST, LIST, LIST, PRODUCT), value, lazy=True)


summation = _with_index("sum", r"\sum", _over_index(values.add, 0))
product = _with_index("product", r"\prod", _over_index(values.multiply, 1))


def _floor(env: Env, a: Any, b: int) -> int:
    if not isinstance(a, int):
        raise NotExactError("the floor of n over a number")
    return a // b


floor_over = define("floor", r"\left\lfloor {0}/{1} \right\rfloor", "{0}/{1}", ATOM, (ATOM, ATOM), _floor)
binomial = define("binomial", r"\binom{{{0}}}{{{1}}}", "{0} {1}", ATOM, (LIST, LIST), _counting(math.comb))


def _every(env: Env, index: Term, low: Term, high: Term, body: Term) -> bool:
    return all(env.bound(index, k).value(body) for k in range(env.value(low), env.value(high) + 1))


every = define("every", r"{3} \quad \text{{for every ${0} = {1}, …, {2}$}}", "{3}", LIST, (LIST,), _every, lazy=True)


# ---- dual parts -----------------------------------------------------------------------------------------------

epsilon = Symbol("epsilon", "dual unit", r"\varepsilon", "ε")
Re = define("Re", r"\operatorname{{Re}} {0}", "Re {0}", PRODUCT, (ATOM,), lambda env, a: env.number(values.re(a)),
            traits=Trait.APART)
Du = define("Du", r"\operatorname{{Du}} {0}", "Du {0}", PRODUCT, (ATOM,), lambda env, a: env.number(values.du(a)),
            traits=Trait.APART)


# ---- vectors, tensors, quaternions ----------------------------------------------------------------------------

norm = define("norm", r"\left|{0}\right|", "|{0}|", ATOM, (LIST,), lambda env, a: values.norm(env.field, a),
              traits=Trait.LENGTH)
dot = define("dot", r"{0} \cdot {1}", "{0}·{1}", PRODUCT, (PRODUCT, PRODUCT), lambda env, a, b: values.dot(a, b))
cross = define("cross", r"{0} \times {1}", "{0}×{1}", PRODUCT, (ATOM, ATOM), lambda env, a, b: a.cross(b))


def _triple(env: Env, *vectors: Vector) -> Any:
    """Return the determinant of three rows by Leibniz's formula."""
    rows = [tuple(v) for v in vectors]
    return sum(int(LeviCivita(*p)) * math.prod(row[i] for row, i in zip(rows, p, strict=True))
               for p in permutations(range(3)))


triple = define("triple", r"\left\langle {0}, {1}, {2} \right\rangle", "{0},{1},{2}", ATOM, (LIST,), _triple)
dyad = define("dyad", r"{0} \otimes {1}", "{0}⊗{1}", PRODUCT, (ATOM, ATOM), lambda env, a, b: Tensor.dyad(a, b))
couple = define("couple", r"\left({0},\, {1}\right)", "({0},{1})", ATOM, (LIST, LIST),
                lambda env, a, b: values.add(values.quaternion(a), b))
skew = define("skew", r"\tilde{{{0}}}", "{0}~", ATOM, (ATOM,), lambda env, a: values.skew(a))
transpose = define("transpose", r"{0}^{{T}}", "{0}^T", POWER, (ATOM,), lambda env, a: matrix.transposed(a))
det = define("det", r"\det {0}", "det {0}", PRODUCT, (ATOM,), lambda env, a: values.det(a))
trace = define("trace", r"\operatorname{{trace}} {0}", "trace {0}", PRODUCT, (ATOM,),
               lambda env, a: sum(row[i] for i, row in enumerate(matrix.rows_of(a))))
vect = define("vect", r"\operatorname{{vect}} {0}", "vect {0}", PRODUCT, (ATOM,), lambda env, a: values.vect(a))
quaternion_scalar = define("scalar of quaternion", r"\operatorname{{Sc}} {0}", "Sc {0}", PRODUCT, (ATOM,),
                           lambda env, a: values.quaternion(a).scalar)
quaternion_vector = define("vector of quaternion", r"\operatorname{{Vec}} {0}", "Vec {0}", PRODUCT, (ATOM,),
                           lambda env, a: values.quaternion(a).vector)
conjugate = define("conjugate", "{0}^{{*}}", "{0}*", POWER, (ATOM,), lambda env, a: values.quaternion(a).conjugate())
rate = define("rate", r"\dot{{{0}}}", "{0}˙", ATOM, (ATOM,), lambda env, a: env.rate(a), traits=Trait.RATE)
ddt = define("ddt", r"\frac{{d}}{{dt}} {0}", "d/dt{0}", PRODUCT, (PRODUCT,), lambda env, a: env.rate(a),
             traits=Trait.RATE)

half = Number(1) / 2
identity = Symbol("I", "identity", "I", "I")
pi = Symbol("pi", "π", r"\pi", "π")


# ---- functions ------------------------------------------------------------------------------------------------


def _function(name: str, value: Callable[..., Any], traits: Trait = Trait.NONE) -> OperatorRow:
    traits |= Trait.TRANSCENDENTAL
    return define(name, rf"\{name} {{0}}", name + " {0}", PRODUCT, (POWER,), value, traits=traits)


sin = _function("sin", lambda env, a: env.field.sin(a))
cos = _function("cos", lambda env, a: env.field.cos(a))
tan = _function("tan", lambda env, a: _quotient(env, env.field.sin(a), env.field.cos(a)), Trait.OVER_COSINE)
cot = _function("cot", lambda env, a: _quotient(env, env.field.cos(a), env.field.sin(a)), Trait.OVER_SINE)
arctan = _function("arctan", lambda env, a: env.field.atan(a))


def _squared(f: OperatorRow) -> OperatorRow:
    return define(f"{f.name}²", rf"\{f.name}^2 {{0}}", f"{f.name}^2 {{0}}", PRODUCT, (POWER,),
                  lambda env, a: env.field.power(f.value(env, a), 2), traits=f.traits)


cos2, tan2 = _squared(cos), _squared(tan)
at = define("at", r"{0}\left({1}\right)", "{0} {1}", ATOM, (ATOM, LIST), lambda env, f, a: f(a))
reaches = define("reaches", r"{0} : \cdot \mapsto {1} \text{{ for some argument}}", "{0}{1}", RELATION, (SUM, SUM),
                 lambda env, f, target: f.reaches(env.field, target) > 0, traits=Trait.DELICATE)
branches = define("branches", r"\#\, {0}^{{-1}}\left({1}\right) = {2}", "{0}{1}{2}", RELATION, (ATOM, LIST, SUM),
                  lambda env, f, target, n: f.reaches(env.field, target) == n, traits=Trait.DELICATE)
"""Claims about a `values.Map`; "onto" means ``reaches(f, q)`` for every q."""


def zero(a: Term | int) -> Apply:
    """Return the condition ``a = 0``."""
    return equal(a, Number(0))
