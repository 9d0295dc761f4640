"""Operators of matrices of any shape, and of poses and twists as matrices; relations; functions of numbers."""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import flint

from ...algebra import Quaternion, Structure, Tensor, Vector, matrix
from ...algebra.element import NotExactError
from ...algebra.first_principles import quaternion_exponential, tensor_by_sandwich, tensor_exponential
from ...algebra.matrix import Matrix
from ...algebra.pose import distance as distance_of_lines
from ...algebra.pose import distance_of_parallels
from ..numbers.balls import Ball, BlurredError, arb
from ..numbers.fields import UndefinedError, innermost
from . import values
from .environment import Env
from .names import latex_of
from .operator_table import define
from .printed import ATOM, LIST, OPERATORS, POWER, PRODUCT, RELATION, SUM, Apply, OperatorRow, Term, Trait
from .values import halves, pose, rotation, skew, translation, vect

# ---- literals ---------------------------------------------------------------------------------------------------


def literal(kind: str, rows: list[list[Term]]) -> Apply:
    """Return the term of a matrix of numbers (``matrix``) or of blocks (``block``), written row by row."""
    sizes = [len(row) for row in rows]
    name = f"{kind} {'+'.join(map(str, sizes))}"
    if name not in OPERATORS:
        places = iter(range(sum(sizes)))
        shown = r" \\ ".join(" & ".join(f"{{{next(places)}}}" for _ in row) for row in rows)
        places = iter(range(sum(sizes)))
        listed = [", ".join(f"{{{next(places)}}}" for _ in row) for row in rows]
        column = kind == "block" and set(sizes) == {1}
        text = f"stack({', '.join(listed)})" if column else f"{kind}([[{'], ['.join(listed)}]])"

        def value(env: Env, *entries: Any) -> Any:
            found = iter(map(matrix.exactly, entries))
            return matrix.blocks([[next(found) for _ in range(size)] for size in sizes])

        define(name, rf"\begin{{{{bmatrix}}}} {shown} \end{{{{bmatrix}}}}", text, ATOM, (LIST,), value)
    return Apply(name, *(entry for row in rows for entry in row))


def stacked(*parts: Term) -> Apply:
    """Return the term of parts one below the other."""
    return literal("block", [[part] for part in parts])


vector = define("vector", r"\begin{{bmatrix}} {0} \\ {1} \\ {2} \end{{bmatrix}}", "vector({0}, {1}, {2})", ATOM,
                (LIST,), lambda env, *components: Vector(*map(matrix.exactly, components)))


def _entry(env: Env, a: Any, i: Any, j: Any = 1) -> Any:
    rows = matrix.rows_of(a if not isinstance(a, Quaternion) else matrix.shaped([[c] for c in a]))
    if not (isinstance(i, int) and isinstance(j, int) and 1 <= i <= len(rows) and 1 <= j <= len(rows[0])):
        raise UndefinedError(f"no entry {i}, {j}")
    return rows[i - 1][j - 1]


_component = define("entry of column", "{0}_{{{1}}}", "entry({0}, {1})", ATOM, (ATOM, LIST), _entry)
_of_matrix = define("entry", "{0}_{{{1},{2}}}", "entry({0}, {1}, {2})", ATOM, (ATOM, LIST, LIST), _entry)


def entry(a: Term, *indices: Term) -> Apply:
    """Return the term of an entry, by one index or two, counted from 1."""
    return (_component if len(indices) == 1 else _of_matrix)(a, *indices)


def member(family: str, index: Term, members: Sequence[Term]) -> Apply:
    """Return the term of a member of a family of letters, counted from 0."""
    name = f"member of {family}"

    def value(env: Env, index: Term, *members: Term) -> Any:
        i = env.value(index)
        if not (isinstance(i, int) and 0 <= i < len(members)):
            raise BlurredError(f"no member {i} of {family}")
        return env.value(members[i])

    if name not in OPERATORS:
        define(name, rf"{latex_of(family)}_{{{{{{0}}}}}}", f"{family}[{{0}}]", ATOM, (LIST,), value, lazy=True)
    return Apply(name, index, *members)


identity_of = define("identity matrix", "I_{{{0}}}", "identity({0})", ATOM, (LIST,),
                     lambda env, n: matrix.exactly(matrix.identity(n)))
zeros = define("zeros", r"0_{{{0} \times {1}}}", "zeros({0}, {1})", ATOM, (LIST, LIST),
               lambda env, m, n: matrix.shaped([[Fraction(0)] * n for _ in range(m)]))
kron = define("kron", r"{0} \boxtimes {1}", "kron({0}, {1})", PRODUCT, (ATOM, ATOM),
              lambda env, a, b: matrix.kron(a, b))
vec = define("vec", r"\operatorname{{vec}} {0}", "vec({0})", PRODUCT, (ATOM,),
             lambda env, a: matrix.shaped([[e] for column in zip(*matrix.rows_of(a), strict=True) for e in column]))

# ---- functions of matrices --------------------------------------------------------------------------------------


def invert(env: Env, a: Any) -> Any:
    """Return the inverse of a number, quaternion or matrix; a zero divisor has none."""
    if not isinstance(a, Matrix):
        return env.field.power(matrix.exactly(a), -1)
    if env.field.vanishes(innermost(matrix.det(a))):
        raise UndefinedError("the inverse of a singular matrix")
    return matrix.inverse(a)


inverse = define("inverse", "{0}^{{-1}}", "inverse({0})", POWER, (ATOM,), invert)


# ---- poses and twists -------------------------------------------------------------------------------------------


def _adjoint(T: Any) -> Any:
    """Return the 6x6 matrix that moves twists, angular part first."""
    R = rotation(T)
    return matrix.blocks([[R, 0 * R], [Tensor.skew(translation(T)) @ R, R]])


def _ad(xi: Matrix) -> Any:
    w, v = map(Tensor.skew, halves(xi))
    return matrix.blocks([[w, 0 * w], [v, w]])


pose_of = define("pose of", r"\begin{{bmatrix}} {0} & {1} \\ 0 & 1 \end{{bmatrix}}", "pose_of({0}, {1})", ATOM,
                 (LIST, LIST), lambda env, R, p: pose(R, p))
adjoint_of = define("adjoint", r"\operatorname{{Ad}}\left({0}\right)", "adjoint({0})", ATOM, (LIST,),
                    lambda env, T: _adjoint(T))
ad = define("ad", r"\operatorname{{ad}}\left({0}\right)", "ad({0})", ATOM, (LIST,), lambda env, xi: _ad(xi))
rotation_of = define("rotation of quaternion", r"R\left({0}\right)", "rotation_of({0})", ATOM, (LIST,),
                     lambda env, q: tensor_by_sandwich(q) / q.norm2())

# ---- exponential and logarithm ----------------------------------------------------------------------------------


def _shifts(env: Env, w: Vector) -> tuple[Any, Any]:
    """Return ``(1 − cos α)/α²`` and ``(α − sin α)/α³`` for α = |w|, or their values at 0."""
    square = w.dot(w)
    if env.field.vanishes(innermost(square)):
        return Fraction(1, 2) - square / Fraction(24), Fraction(1, 6) - square / Fraction(120)
    angle = env.field.sqrt(square)
    return (1 - env.field.cos(angle)) / square, (angle - env.field.sin(angle)) / (angle * square)


def _exponential(env: Env, a: Any) -> Any:
    """Return the exponential of a number, vector (as a pure quaternion), quaternion, twist or square matrix."""
    if isinstance(a, Quaternion):
        return quaternion_exponential(a.vector, env.field) * env.field.exp(a.scalar)
    if isinstance(a, Vector):
        return quaternion_exponential(a, env.field)
    if isinstance(a, Matrix) and len(a.rows[0]) == 1:
        a = skew(a)
    if not isinstance(a, Structure):
        return env.field.exp(a)
    if isinstance(a, Matrix) and len(a.rows) == 4 and env.equal(a, skew(vect(a))):
        w, v = halves(vect(a))
        W, (b, c) = Tensor.skew(w), _shifts(env, w)
        return pose(tensor_exponential(w, env.field), (Tensor.identity() + W * b + W @ W * c) @ v)
    if isinstance(a, Tensor) and env.equal(a, Tensor.skew(a.vect())):
        return tensor_exponential(a.vect(), env.field)
    return _of_balls(a)


def _of_balls(a: Any) -> Any:
    """Return the exponential of any square matrix of balls, which Arb bounds."""
    rows = [[arb(entry) for entry in row] for row in matrix.rows_of(a)]
    if any(entry is None for row in rows for entry in row):
        raise NotExactError("the exponential of a matrix that is neither skew nor a twist")
    found = flint.arb_mat(rows).exp().tolist()
    return matrix.shaped([[Ball(entry) for entry in row] for row in found])


def _rotation_vector(env: Env, R: Any) -> Any:
    """Return the rotation vector shorter than π; a half turn has none."""
    if not env.equal(R @ R.transpose, Tensor.identity()):
        raise UndefinedError("the logarithm of a matrix that is no rotation")
    w, cosine = matrix.exactly(R).vect(), (R.trace() - 1) / Fraction(2)
    square = w.dot(w)
    if env.field.vanishes(innermost(square)):
        if innermost(cosine) < 0:
            raise UndefinedError("the logarithm of a half turn")
        return w
    sine = env.field.sqrt(square)
    angle = env.field.atan2(sine, cosine)
    return w * (angle / sine)


def _logarithm(env: Env, a: Any) -> Any:
    """Return the principal logarithm of a number, quaternion, rotation or pose."""
    if isinstance(a, Quaternion):
        size, square = env.field.sqrt(a.norm2()), a.vector.dot(a.vector)
        if env.field.vanishes(innermost(square)):
            if innermost(a.scalar) < 0:
                raise UndefinedError("the logarithm of a negative number")
            return Quaternion(env.field.log(size), a.vector / a.scalar)
        length = env.field.sqrt(square)
        return Quaternion(env.field.log(size), a.vector * (env.field.atan2(length, a.scalar) / length))
    if isinstance(a, Tensor):
        return Tensor.skew(_rotation_vector(env, a))
    if not isinstance(a, Matrix):
        return env.field.log(a)
    w = _rotation_vector(env, rotation(a))
    W, (b, c) = Tensor.skew(w), _shifts(env, w)
    back = (Tensor.identity() + W * b + W @ W * c).inverse()
    return skew(matrix.blocks([[w], [back @ translation(a)]]))


exp = define("exp", r"\exp {0}", "exp {0}", PRODUCT, (ATOM,), _exponential, traits=Trait.TRANSCENDENTAL)
log = define("log", r"\log {0}", "log({0})", PRODUCT, (ATOM,), _logarithm, traits=Trait.TRANSCENDENTAL)


# ---- relations --------------------------------------------------------------------------------------------------

unlike = define("unlike", r"{0} \neq {1}", "{0} != {1}", RELATION, (SUM, SUM),
                lambda env, a, b: not values.equal(env.field.certain, env.now(a), env.now(b)), traits=Trait.DELICATE)


def _ordered(name: str, sign: str, latex: str, test: Callable[[Any, Any], bool]) -> OperatorRow:
    """Return a relation of real numbers, which compares real parts; it needs a field in which numbers have signs."""

    def value(env: Env, a: Any, b: Any) -> bool:
        if not env.field.ordered:
            raise NotExactError("an inequality")
        a, b = innermost(env.now(a)), innermost(env.now(b))
        return env.field.compared(test, a, b)

    return define(name, f"{{0}} {latex} {{1}}", f"{{0}} {sign} {{1}}", RELATION, (SUM, SUM), value,
                  traits=Trait.DELICATE)


less = _ordered("less", "<", "<", operator.lt)
at_most = _ordered("at most", "<=", r"\leq", operator.le)
greater = _ordered("greater", ">", ">", operator.gt)
at_least = _ordered("at least", ">=", r"\geq", operator.ge)
either = define("or", r" \;\text{or}\; ", " or ", LIST, (RELATION,), lambda env, *parts: any(parts),
                traits=Trait.DELICATE)

# ---- functions of numbers ---------------------------------------------------------------------------------------


def _function(name: str, latex: str, value: Callable[..., Any]) -> OperatorRow:
    return define(name, rf"{latex} {{0}}", f"{name}({{0}})", PRODUCT, (ATOM,), value, traits=Trait.TRANSCENDENTAL)


def _hyperbolic(sign: int) -> Callable[[Env, Any], Any]:
    return lambda env, a: (env.field.exp(a) + sign * env.field.exp(-a)) / 2


def _sinc(env: Env, a: Any) -> Any:
    """Return ``sin a/a``, at 0 by its series to second order, which rates need."""
    return 1 - a * a / 6 if env.field.vanishes(innermost(a)) else env.field.sin(a) / a


acos = _function("acos", r"\arccos", lambda env, a: env.field.acos(a))
asin = _function("asin", r"\arcsin", lambda env, a: env.field.asin(a))
sinh = _function("sinh", r"\sinh", _hyperbolic(-1))
cosh = _function("cosh", r"\cosh", _hyperbolic(1))
tanh = _function("tanh", r"\tanh", lambda env, a: _hyperbolic(-1)(env, a) / _hyperbolic(1)(env, a))
sinc = _function("sinc", r"\operatorname{{sinc}}", _sinc)
atan2 = define("atan2 of two", r"\operatorname{{atan2}}\left({0}, {1}\right)", "atan2({0}, {1})", ATOM, (LIST, LIST),
               lambda env, y, x: env.field.atan2(y, x), traits=Trait.TRANSCENDENTAL)


def _floor(env: Env, a: Any) -> Any:
    if isinstance(a, int | Fraction):
        return int(a // 1)
    return env.field.floor(a)


floor = define("floor of number", r"\left\lfloor {0} \right\rfloor", "floor({0})", ATOM, (LIST,), _floor)


def _distance(env: Env, a: Vector, b: Vector) -> Any:
    normal = values.re(a).cross(values.re(b))
    if all(env.field.same(innermost(c), 0) for c in normal):
        return distance_of_parallels(a, b, env.field)
    return distance_of_lines(a, b, env.field, env.field.absolute)


distance = define("distance", r"d\left({0}, {1}\right)", "distance({0}, {1})", ATOM, (LIST, LIST), _distance,
                  traits=Trait.APART)
