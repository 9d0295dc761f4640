"""Section 2.3, dual tensors: lines 72-86."""

from functools import reduce
from operator import add

from ....algebra import Tensor
from ..definitions import dual_algebra
from . import *
from .s02_2_dual_vectors import BASIS, basis, lam, mu

T_, A_ = tensor("T"), tensor("A")
T, T0 = (
    Symbol(f"{name} real", "real tensor", rf"\mathbf{{{latex}}}", name) for name, latex in (("T", "T"), ("T0", "T^0"))
)
a_, b_, c_, d_ = (vector(name) for name in "abcd")
v1, v2, v3 = (vector(f"v{i}", f"v}}_{{{i}", f"v{i}") for i in (1, 2, 3))
lam1, lam2 = (Symbol(f"lambda{i}", "dual number", rf"\underline{{\lambda}}_{i}", f"λ{i}") for i in (1, 2))
turn = quaternion("B")
e1, e2, e3 = basis
columns = {name: Symbol(f"components of {name}", "function", rf"\underline{{{name}}}", name) for name in "ab"}
frame = Symbol("frame", "function", r"\underline{\mathbf{e}}", "e")
i = Symbol("i", "index", "i", "i")
column_row = define(
    "column times row", "{0}\\, {1}^{{T}}", "{0} {1}^T", POWER, (ATOM, ATOM),
    lambda env, a, b: Tensor.from_entries(a(j) * b(k) for j in (1, 2, 3) for k in (1, 2, 3)),
)
component = define("component", "{0}_{{{1}}}", "{0} {1}", ATOM, (ATOM, LIST), lambda env, f, k: f(k))
rows = define(
    "rows", r"\begin{{pmatrix}} {0} & {1} & {2} \\ {3} & {4} & {5} \\ {6} & {7} & {8} \end{{pmatrix}}",
    "({0},{1},{2},{3},{4},{5},{6},{7},{8})", ATOM, (LIST,), lambda env, *entries: Tensor.from_entries(entries),
)

components = plain(lambda a, frame: lambda k: frame(k).dot(a))
FRAME = (
    let(frame, dual_algebra.frame, turn), let(columns["a"], components, a_, frame),
    let(columns["b"], components, b_, frame),
)
axial_of_A = Symbol("a of A", "dual vector", r"\underline{\mathbf{a}}", "a")
SKEW = (let(A_, plain(lambda T: T - T.transpose), T_), let(axial_of_A, dual_algebra.axial, A_))
regular = nonzero(Re(triple(v1, v2, v3)))
a1, a2, a3 = (component(columns["a"], k) for k in (1, 2, 3))
dyad_matrix = Symbol("matrix of a⊗b", "tensor", r"\left[\underline{a} \otimes \underline{b}\right]", "ab")
a_tilde = Symbol("matrix of a~", "tensor", r"\tilde{\underline{a}}", "a~")

ENTRIES = (
    equation("7", equal(T_ * (lam1 * v1 + lam2 * v2), lam1 * (T_ * v1) + lam2 * (T_ * v2))),
    equation("tensor-module",
             equal(T_, reduce(add, (bracket(dot(a, T_ * b)) * dyad(a, b) for a in basis for b in basis))), where=BASIS),
    equation("tensor-parts", equal(T_, T + epsilon * T0), where=(let(T, real_of, T_), let(T0, dual_of, T_))),
    equation("8", equal(dot(v1, T_ * v2), dot(v2, transpose(T_) * v1))),
    equation("9", equal(triple(T_ * v1, T_ * v2, T_ * v3), det(T_) * triple(v1, v2, v3)), claimed=regular),
    equation("10", equal(skew(a_) * b_, cross(a_, b_))),
    equation("skew-symmetric", equal(A_, -transpose(A_)), where=SKEW),
    equation("axial-vector", equal(A_ * b_, cross(axial_of_A, b_)), where=SKEW),
    equation("axial-vector-is-vect", equal(axial_of_A, vect(A_)), where=SKEW),
    equation("axial-vector-unique", equal(vect(skew(c_)), c_)),
    equation("skew-module",
             both(equal(skew(lam * a_ + mu * b_), lam * skew(a_) + mu * skew(b_)), equal(vect(skew(a_)), a_),
                  equal(skew(vect(A_)), A_)),
             where=SKEW),
    equation("vect", equal(vect(T_), vect(half * (T_ - transpose(T_))))),
    equation("11",
             equal(trace(T_),
                   (triple(T_ * v1, v2, v3) + triple(v1, T_ * v2, v3) + triple(v1, v2, T_ * v3)) / triple(v1, v2, v3)),
             claimed=regular),
    equation("12", equal(bracket(dyad(a_, b_)) * v, bracket(dot(v, b_)) * a_)),
    equation("dyad-product", equal(bracket(dyad(a_, b_)) * bracket(dyad(c_, d_)), bracket(dot(b_, c_)) * dyad(a_, d_))),
    equation("components", equal(a_, summation(i, 1, 3, component(columns["a"], i) * component(frame, i))),
             where=FRAME),
    equation("dyad-matrix", equal(dyad_matrix, column_row(columns["a"], columns["b"])),
             where=(*FRAME,
                    let(dyad_matrix, plain(lambda a, b, frame: dual_algebra.matrix(frame, lambda e: e.dot(b) * a)), a_,
                        b_, frame))),
    equation("skew-matrix",
             (Reading(equal(a_tilde, rows(0, -a3, a2, a3, 0, -a1, -a2, a1, 0)), "minus at the entries 12, 23, 31"),
              Reading(equal(a_tilde, rows(0, a3, -a2, -a3, 0, a1, a2, -a1, 0)), "minus at the entries 13, 21, 32")),
             where=(*FRAME, let(a_tilde, plain(lambda a, frame: dual_algebra.matrix(frame, a.cross)), a_, frame))),
)
