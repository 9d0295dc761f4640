"""Table of operators with their LaTeX, their plain text, and their values.

A call of an operator builds a term: ``equal(R, I + 2 * q * skew(q))``.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from functools import reduce
from itertools import count, islice, pairwise
from typing import Any

from ...algebra import Quaternion, Structure, Tensor, matrix
from ...algebra.element import Element, NotExactError
from ..numbers.balls import BlurredError
from ..numbers.fields import UndefinedError, innermost
from . import values
from .binomial_sums import binomial_sum
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
    symbols,
    walk,
)


def define(name: str, *row: Any, **rest: Any) -> OperatorRow:
    """Add an operator with the fields of `OperatorRow` to the table and return it; its call builds a term."""
    if name in OPERATORS:
        raise ValueError(f"operator {name!r} is defined twice")
    OPERATORS[name] = OperatorRow(name, *row, **rest)
    return OPERATORS[name]


# ---- arithmetic: terms built by Python's operators -------------------------------------------------------------

define("plus", "{0} + {1}", "{0}+{1}", SUM, (SUM, PRODUCT), lambda env, a, b: values.add(a, b))
define("minus", "{0} - {1}", "{0}-{1}", SUM, (SUM, PRODUCT), lambda env, a, b: values.add(a, -b))
define("negative", "-{0}", "-{0}", SUM, (PRODUCT,), lambda env, a: -a)
define("times", r"{0}\, {1}", "{0} {1}", PRODUCT, (PRODUCT, PRODUCT), lambda env, a, b: values.multiply(a, b))
over = define("over", r"\frac{{{0}}}{{{1}}}", "{0}/{1}", POWER, (LIST, LIST), lambda env, a, b: _quotient(env, a, b))


def _quotient(env: Env, a: Any, b: Any) -> Any:
    size = b.norm2() if isinstance(b, Quaternion) else b
    if not isinstance(size, Structure) and env.field.vanishes(innermost(size)):
        raise UndefinedError("division by zero")
    return values.divide(a, b)


def _root(env: Env, a: Any) -> Any:
    if isinstance(a, Quaternion) and all(c == 0 for c in a.vector):
        a = a.scalar
    return env.field.power(a, Fraction(1, 2)) if isinstance(a, Quaternion) else env.field.sqrt(a)


root = define("root", r"\sqrt{{{0}}}", "√{0}", POWER, (LIST,), _root)


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


def words(latex: str, text: str) -> Symbol:
    """Return a symbol for words without a value."""
    return Symbol(f"words:{text}", "words", latex, text)


RELATIONS = frozenset(("less", "at most", "greater", "at least", "unlike", "equal", "nonzero"))
STILL = ("order", "branch", "integer", "sign", "index")
"""Quantities that do not move."""


def difference(relation: Term) -> Term:
    """Return the difference of both sides of a relation; of one with a single side, this side."""
    a, *rest = relation.arguments
    return a if not rest or rest[0] == Number(0) else a - rest[0]


def _crosses(env: Env, condition: Term) -> bool:
    """Return whether sides of a relation that move are equal now, so that another case may apply nearby.

    Relations of orders do not move. At a zero of their difference, both sides of a relation are written as 0.
    """
    relations = (node for node in walk(condition) if node.operator.name in RELATIONS
                 and not (symbols(node) and all(a.quantity.name in STILL for a in symbols(node))))  # fmt: skip
    zero = env.field.vanishes if env.moving else env.field.crosses
    gaps = (env.now(env.value(difference(node))) for node in relations)
    return any(all(map(zero, values.coefficients(gap))) for gap in gaps)


def _cases(env: Env, *arms: Term) -> Any:
    for value, condition in zip(arms[::2], arms[1::2], strict=False):
        if _crosses(env, condition):
            raise BlurredError
        if env.value(condition):
            return env.value(value)
    if len(arms) % 2:
        return env.value(arms[-1])
    raise UndefinedError("no case applies")


def cases(*arms: Term) -> Apply:
    """Return a value by cases: ``cases(value, condition, ..., otherwise)``, the last one if there is any."""
    name = f"cases{len(arms)}"
    if name not in OPERATORS:
        conditions = [f"{{{i + 1}}}" if i + 1 < len(arms) else r"\text{{otherwise}}" for i in range(0, len(arms), 2)]
        inside = r"\\ ".join(f"{{{2 * i}}}, & {shown}" for i, shown in enumerate(conditions))
        latex = rf"\begin{{{{cases}}}} {inside} \end{{{{cases}}}}"
        text = f"cases({', '.join(f'{{{i}}}' for i in range(len(arms)))})"
        define(name, latex, text, ATOM, (LIST,), _cases, lazy=True, traits=Trait.DELICATE)
    return Apply(name, *arms)


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
    """Return the value of a sum or product; one without end stops at negligible terms, and its rest has no bound."""

    def value(env: Env, index: Term, low: Term, high: Term, body: Term) -> Any:
        first, last = (None if end == infinity else env.value(end) for end in (low, high))
        if isinstance(last, Element) and combined is values.add:
            return binomial_sum(env, index, first, last, body)
        if not (isinstance(first, int) and isinstance(last, int | None)):
            raise NotExactError("a product of n factors")
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
dyad = define("dyad", r"{0} \otimes {1}", "{0}⊗{1}", PRODUCT, (ATOM, ATOM), lambda env, a, b: Tensor.dyad(a, b))
skew = define("skew", r"\tilde{{{0}}}", "{0}~", ATOM, (ATOM,), lambda env, a: values.skew(a))
transpose = define("transpose", r"{0}^{{T}}", "{0}^T", POWER, (ATOM,), lambda env, a: matrix.transposed(a))
det = define("det", r"\det {0}", "det {0}", PRODUCT, (ATOM,), lambda env, a: values.det(a))
trace = define("trace", r"\operatorname{{trace}} {0}", "trace {0}", PRODUCT, (ATOM,),
               lambda env, a: sum(row[i] for i, row in enumerate(matrix.rows_of(a))))
vect = define("vect", r"\operatorname{{vect}} {0}", "vect {0}", PRODUCT, (ATOM,), lambda env, a: values.vect(a))
quaternion_scalar = define("quaternion scalar", r"\operatorname{{Sc}} {0}", "Sc {0}", PRODUCT, (ATOM,),
                           lambda env, a: values.quaternion(a).scalar)
quaternion_vector = define("quaternion vector", r"\operatorname{{Vec}} {0}", "Vec {0}", PRODUCT, (ATOM,),
                           lambda env, a: values.quaternion(a).vector)
conjugate = define("conjugate", "{0}^{{*}}", "{0}*", POWER, (ATOM,), lambda env, a: values.quaternion(a).conjugate())
rate = define("rate", r"\dot{{{0}}}", "{0}˙", ATOM, (ATOM,), lambda env, a: env.rate(a), traits=Trait.RATE)

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
