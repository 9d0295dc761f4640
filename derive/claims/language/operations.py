"""Table of the operations in papers' files: what each takes, what it gives, and the operator that it stands for."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from . import calculus, matrices, operator_table, powers
from .calculus import BINDERS
from .names import POSE, TENSOR, TESTS, TWIST, VECTOR, Kind, KindError, article, is_number, name
from .printed import Number, Symbol, Term, text

Gives = Kind | Callable[..., Kind]


@dataclass(frozen=True)
class Operation:
    """Row of the table: `takes` has words of `TESTS`, with "or" between several, for each argument."""

    takes: tuple[str, ...]
    gives: Gives
    term: Callable[..., Term]
    says: str
    example: str
    many: bool = False  # whether the last argument may be repeated
    binds: bool = False  # whether the second argument (of a sum the first) is a letter that the first one varies

    @property
    def operator(self) -> str:
        """Name of the operator; empty if it depends on the number of arguments."""
        return str(getattr(self.term, "name", ""))

    def kind(self, call: str, kinds: Sequence[Kind]) -> Kind:
        """Return the kind of the value for arguments of these kinds; raise KindError."""
        least = len(self.takes)
        if len(kinds) < least or (len(kinds) > least and not self.many):
            raise KindError(f"{call} takes {least}{' or more' if self.many else ''} arguments, got {len(kinds)}")
        for i, kind in enumerate(kinds):
            wanted = self.takes[min(i, least - 1)]
            if not any(TESTS[word](kind) for word in wanted.split(" or ")):
                raise KindError(f"{call} takes {article(wanted)}, got {name(kind)}", i)
        return self.gives(*kinds) if callable(self.gives) else self.gives


def same(kind: Kind, *rest: Kind) -> Kind:
    return kind


def _transposed(kind: Any) -> Kind:
    return kind[1], kind[0]


def _stacked(*kinds: Any) -> Any:
    sizes = [(1, 1) if is_number(kind) else kind for kind in kinds]
    if len({columns for _, columns in sizes}) > 1:
        raise KindError(f"stack takes parts with equal numbers of columns, got {', '.join(map(name, kinds))}")
    return sum(rows for rows, _ in sizes), sizes[0][1]


def _kron(a: Any, b: Any) -> Kind:
    return a[0] * b[0], a[1] * b[1]


def _dot(a: Kind, b: Kind) -> Kind:
    if a != b and not (is_number(a) and is_number(b)):
        raise KindError(f"dot takes columns of one size, got {name(a)} and {name(b)}")
    return "number"


def _exponential(kind: Any) -> Any:
    """Return the kind of an exponential: that of a vector is a quaternion, that of a twist a pose."""
    return {VECTOR: "quaternion", TWIST: POSE, "integer": "number"}.get(kind, kind)


def _number_like(kind: Any) -> Any:
    return "number" if is_number(kind) else kind


def _not_vector(call: str) -> Callable[[Any], Any]:
    """Return the kind of a value like the argument's; a vector, which is a quaternion elsewhere, is refused."""

    def kind_of(kind: Any) -> Any:
        if kind == VECTOR:
            raise KindError(f"{call} takes no vector", 0)
        return _number_like(kind)

    return kind_of


def _skew(kind: Kind) -> Kind:
    return TENSOR if kind == VECTOR else POSE


def _size(kind: Any) -> int:
    return 1 if is_number(kind) else 4 if kind == "quaternion" else kind[0] * kind[1]


def _jacobian(f: Any, letter: Any, *rest: Kind) -> Kind:
    if is_number(letter):
        return (4, 1) if f == "quaternion" else _number_like(f)
    if isinstance(f, tuple) and f[1] != 1:
        raise KindError(f"jacobian by {name(letter)} takes a number, column or quaternion, got {name(f)}")
    return _size(f), _size(letter)


def _group_jacobian(f: Kind, letter: Kind, *rest: Kind) -> Kind:
    rows, columns = (3 if f == TENSOR else 6), _size(letter)
    return (rows, columns)


def _function(row: Callable[..., Term], says: str, example: str) -> Operation:
    return Operation(("number",), "number", row, says, example)


t = operator_table
OPERATIONS: dict[str, Operation] = {
    "norm": Operation(("number or column or quaternion",), "number", t.norm,
                      "magnitude of a number, column or quaternion", "norm(v)"),
    "dot": Operation(("column", "column"), _dot, t.dot, "scalar product of two columns", "dot(v, w)"),
    "cross": Operation(("vector", "vector"), VECTOR, t.cross, "vector product", "cross(v, w)"),
    "distance": Operation(("vector", "vector"), "number", matrices.distance,
                          "shortest distance of two lines, given by unit dual vectors", "distance(v, w)"),
    "dyad": Operation(("vector", "vector"), TENSOR, t.dyad, "dyadic product v wᵀ", "dyad(v, w)"),
    "skew": Operation(("vector or twist",), _skew, t.skew, "matrix with skew(v) w = v × w; of a twist its 4x4 matrix",
                      "skew(v)"),
    "vect": Operation(("tensor or pose",), lambda k: VECTOR if k == TENSOR else TWIST, t.vect,
                      "axial vector of (A − Aᵀ)/2; of a 4x4 twist matrix its twist", "vect(R)"),
    "transpose": Operation(("matrix",), _transposed, t.transpose, "transpose", "transpose(R)"),
    "inverse": Operation(("number or quaternion or square matrix",), _not_vector("inverse"), matrices.inverse,
                         "inverse of a number, quaternion or square matrix", "inverse(A)"),
    "det": Operation(("square matrix",), "number", t.det, "determinant", "det(A)"),
    "trace": Operation(("square matrix",), "number", t.trace, "trace", "trace(R)"),
    "conjugate": Operation(("quaternion",), "quaternion", t.conjugate, "conjugate of a quaternion", "conjugate(q)"),
    "scalar": Operation(("quaternion",), "number", t.quaternion_scalar, "scalar part of a quaternion", "scalar(q)"),
    "vector_part": Operation(("quaternion",), VECTOR, t.quaternion_vector, "vector part of a quaternion",
                             "vector_part(q)"),
    "re": Operation(("value",), same, t.Re, "real part", "re(a)"),
    "du": Operation(("value",), same, t.Du, "dual part", "du(a)"),
    "exp": Operation(("number or quaternion or twist or square matrix",), _exponential, matrices.exp,
                     "exponential of a number, skew tensor, twist or its 4x4 matrix (a pose), or vector as a pure "
                     "quaternion (a quaternion)", "exp(skew(v))"),
    "log": Operation(("number or quaternion or tensor or pose",), _number_like, matrices.log,
                     "principal logarithm of a number, quaternion, rotation (a skew tensor) or pose (a 4x4 twist "
                     "matrix); none at a half turn", "log(R)"),
    "sqrt": Operation(("number or quaternion",), _not_vector("sqrt"), t.root, "square root that is not negative",
                      "sqrt(x)"),
    "sin": _function(t.sin, "sine", "sin(a)"),
    "cos": _function(t.cos, "cosine", "cos(a)"),
    "tan": _function(t.tan, "tangent", "tan(a)"),
    "cot": _function(t.cot, "cotangent", "cot(a)"),
    "asin": _function(matrices.asin, "arc sine in [−π/2, π/2]", "asin(x)"),
    "acos": _function(matrices.acos, "arc cosine in [0, π]", "acos(x)"),
    "atan": _function(t.arctan, "arc tangent in (−π/2, π/2)", "atan(x)"),
    "atan2": Operation(("number", "number"), "number", matrices.atan2, "angle of the point (x, y) in (−π, π]",
                       "atan2(y, x)"),
    "sinh": _function(matrices.sinh, "hyperbolic sine", "sinh(x)"),
    "cosh": _function(matrices.cosh, "hyperbolic cosine", "cosh(x)"),
    "tanh": _function(matrices.tanh, "hyperbolic tangent", "tanh(x)"),
    "sinc": _function(matrices.sinc, "sin x/x, and 1 at 0", "sinc(x)"),
    "vector": Operation(("number", "number", "number"), VECTOR, matrices.vector, "vector of three components",
                        "vector(a, b, c)"),
    "stack": Operation(("number or matrix", "number or matrix"), _stacked, matrices.stacked,
                       "parts one below the other", "stack(w, v)", many=True),
    "kron": Operation(("matrix", "matrix"), _kron, matrices.kron, "Kronecker product", "kron(A, B)"),
    "vec": Operation(("matrix",), lambda k: (k[0] * k[1], 1), matrices.vec, "columns one below the other", "vec(A)"),
    "adjoint": Operation(("pose",), (6, 6), matrices.adjoint_of, "6x6 matrix that moves twists", "adjoint(T)"),
    "ad": Operation(("twist",), (6, 6), matrices.ad, "6x6 matrix of the bracket of twists", "ad(xi)"),
    "rotation_of": Operation(("quaternion",), TENSOR, matrices.rotation_of, "rotation r ↦ q r q⁻¹", "rotation_of(q)"),
    "pose_of": Operation(("tensor", "vector"), POSE, matrices.pose_of, "4x4 matrix of rotation and translation",
                         "pose_of(R, p)"),
    "rate": Operation(("value",), same, t.rate, "time derivative; of a constant letter 0", "rate(v)"),
    "jacobian": Operation(("value", "column or quaternion or tensor"), _jacobian, calculus.jacobian,
                          "derivative by the components of a letter, all of them free: of a quaternion 4, of a tensor "
                          "9 in the order of vec", "jacobian(norm(v), v)", binds=True),
    "left_jacobian": Operation(("tensor or pose", "column"), _group_jacobian, calculus.left_jacobian,
                               "J with ω = J v̇ in the space frame, of a rotation (3 rows) or pose (6 rows)",
                               "left_jacobian(exp(skew(v)), v)", binds=True),
    "right_jacobian": Operation(("tensor or pose", "column"), _group_jacobian, calculus.right_jacobian,
                                "the same in the body frame", "right_jacobian(exp(skew(v)), v)", binds=True),
    "sum": Operation(("integer", "integer", "integer or infinity", "value"), lambda k, a, b, term: term, t.summation,
                     "sum over an integer letter", "sum(k, 0, n, x**k)", binds=True),
    "product": Operation(("integer", "integer", "integer", "value"), lambda k, a, b, term: term, t.product,
                         "product over an integer letter, the first factor on the left", "product(k, 1, n, x + k)",
                         binds=True),
    "all": Operation(("integer", "integer", "integer", "relation"), "truth", t.every,
                     "relation for every value of an integer letter", "all(k, 1, 3, entry(cross(v, v), k) == 0)",
                     binds=True),
    "at": Operation(("value", "value", "value"), same, calculus.value_at,
                    "value where a letter has this value; 0 is the zero of its kind", "at(exp(skew(v)), v, 0)",
                    binds=True),
    "expectation": Operation(("value", "column", "number or square matrix"), same, calculus.expectation,
                             "mean of a formula of second degree in a letter with mean 0 and this covariance",
                             "expectation((a*x)**2, x, b)", binds=True),
    "limit": Operation(("value", "number", "number or infinity"), same, calculus.limit, "limit from both sides",
                       "limit(sin(x)/x, x, 0)", binds=True),
    "integral": Operation(("value", "number", "number", "number"), same, calculus.integral, "integral over a letter",
                          "integral(cos(t), t, 0, a)", binds=True),
    "series": Operation(("value", "column", "integer"), same, calculus.taylor,
                        "Taylor polynomial in a letter, removable singularities filled",
                        "series(exp(x), x, 3)", binds=True),
    "binomial": Operation(("integer", "integer"), "integer", t.binomial, "binomial coefficient", "binomial(n, k)"),
    "factorial": Operation(("integer",), "integer", t.factorial, "factorial", "factorial(k)"),
    "floor": Operation(("number",), "integer", matrices.floor, "largest integer below", "floor(n/2)"),
    "p": Operation(("integer", "number"), "number", powers.p, "polynomial p_n of CP23 of x = |v|²", "p(n, x)"),
    "q": Operation(("integer", "number"), "number", powers.q, "polynomial q_n of CP23 of x = |v|²", "q(n, x)"),
    "cay": Operation(("integer", "vector"), TENSOR, powers.cay, "rotation of tan(α/2n) u", "cay(n, v)"),
    "dcay": Operation(("integer", "vector"), TENSOR, powers.dcay, "tangent operator of cay", "dcay(n, v)"),
    "dexp": Operation(("vector",), TENSOR, powers.dexp, "tangent operator of exp(skew(v))", "dexp(v)"),
    "implies": Operation(("relation", "relation"), "truth", t.implies, "the second where the first is true",
                         "implies(x > 0, sqrt(x**2) == x)"),
}
"""Operations by name. `matrix`, `block`, `entry`, `identity` and `zeros` take literals; `claims` has their rules."""

CONSTANTS: dict[str, tuple[Symbol, Kind]] = {
    "I": (t.identity, TENSOR), "pi": (t.pi, "number"), "eps": (t.epsilon, "number"),
    "infinity": (t.infinity, "infinity"),
}


def term(call: str, arguments: Sequence[Term], kinds: Sequence[Kind]) -> tuple[Term, Kind]:
    row = OPERATIONS[call]
    kind = row.kind(call, kinds)
    return row.term(*arguments), kind


OR, AND, NOT, RELATION, SUM, PRODUCT, POWER, ATOM = range(8)
"""Binding strengths, in Python's order."""

INFIX: dict[str, tuple[str, int, int, int]] = {
    "or": (" or ", OR, OR, AND), "both": (" and ", AND, AND, NOT), "equal": (" == ", RELATION, SUM, SUM),
    "unlike": (" != ", RELATION, SUM, SUM), "less": (" < ", RELATION, SUM, SUM),
    "at most": (" <= ", RELATION, SUM, SUM),
    "greater": (" > ", RELATION, SUM, SUM), "at least": (" >= ", RELATION, SUM, SUM),
    "plus": (" + ", SUM, SUM, PRODUCT),
    "minus": (" - ", SUM, SUM, PRODUCT), "times": ("*", PRODUCT, PRODUCT, POWER),
    "over": ("/", PRODUCT, PRODUCT, POWER),
    "power": ("**", POWER, ATOM, POWER),
}  # fmt: skip
"""Sign, strength of the result, and least strengths of the left and right operand."""

PREFIX = {"negative": ("-", PRODUCT, POWER), "negated": ("not ", NOT, NOT), "nonzero": ("{} != 0", RELATION, SUM)}
LOCAL = ("limit at", "integral", "value at", "expectation")
"""Operators whose letter has no value outside."""
NAMES = {symbol: name for name, (symbol, _) in CONSTANTS.items()}
CALLS = {row.operator or name: name for name, row in OPERATIONS.items()} | {"entry of column": "entry", "bracket": ""}
"""Name of a call by the name of its operator."""


def written(term: Term) -> str:
    """Return a term as a claim; an operator that no call stands for keeps the characters of its text."""
    return _written(term)[0]


def _written(term: Term) -> tuple[str, int]:
    if isinstance(term, Number):
        return (str(term.value), ATOM) if term.value >= 0 else (str(term.value), PRODUCT)
    if isinstance(term, Symbol):
        return NAMES.get(term, str(term.args[3])), ATOM
    name, arguments = term.operator.name, term.arguments
    if BINDERS.get(name) == 1 and name not in LOCAL and str(arguments[1].args[3]) == written(arguments[2]):
        arguments = (*arguments[:2], *arguments[3:])
    if name in INFIX and len(arguments) >= 2:
        sign, level, left, right = INFIX[name]
        return sign.join(_at_least(a, right if i else left) for i, a in enumerate(arguments)), level
    if name in PREFIX:
        sign, level, least = PREFIX[name]
        inside = _at_least(arguments[0], least)
        return (sign.format(inside) if "{" in sign else sign + inside), level
    if name in CALLS:
        return f"{CALLS[name]}({', '.join(map(written, arguments))})", ATOM
    if not arguments:
        return text(term), ATOM
    return term.operator.text.format(*map(written, arguments)) if "{0}" in term.operator.text else text(term), ATOM


def _at_least(term: Term, least: int) -> str:
    shown, level = _written(term)
    return shown if level >= least else f"({shown})"
