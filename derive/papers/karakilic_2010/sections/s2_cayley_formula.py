"""Section 2, Cayley's formula: lines 53-105."""

from ....algebra import Tensor
from ....maps import rodrigues
from ...numbers.kinds import drawn
from .. import k10_definitions as k10
from . import *

I = identity
A, x, X, z, b, y = hat("A", "orthogonal tensor"), *(hat(name, "dual vector") for name in "xXzby")
B, b_ij = hat("B", "tensor"), hat("b", "tensor")
B_bare = Symbol("B", "tensor", "B", "B")
MOVED = (let(X, image, A, x),)
FROM_A = (*MOVED, let(B, plain(rodrigues.cayley_matrix), A), let(b_ij, plain(rodrigues.cayley_matrix), A))
skew_rodrigues = plain(lambda A: Tensor.skew(rodrigues.rodrigues_vector(A)))
INVARIANT = (let(B, skew_rodrigues, A), let(B_bare, skew_rodrigues, A))
"""Definitions of B̂ by the invariants of Â, without the inverse of Â + I."""
no_half_turn = nonzero(Re(det(A + I)))


def reflections(draw: Draw) -> dict[str, dict[Symbol, object]]:
    """Return an orthogonal tensor with determinant −1."""
    return {"reflection": {A: -drawn("orthogonal tensor", draw)}}


z_i, z_j = component(z, i), component(z, j)
symmetric_part = group(entry(b_ij, i, j) + entry(b_ij, j, i)) * z_i * z_j
quadratic_of_any = (let(b_ij, lambda env, T: T, B),)

ANY_B = (let(B, skew_of, b), let(A, plain(rodrigues.cayley_formula), b))
cay = Symbol("cay", "map", r"\mathrm{cay}")

b1, b2, b3 = (component(b, index) for index in (1, 2, 3))
b_re, b_du = Symbol("b re", "real vector", "b", "b"), Symbol("b du", "real vector", "b^{*}", "b*")
numbers = {star: tuple(real("b", index, star) for index in (1, 2, 3)) for star in (False, True)}
PARTS = (let(b_re, real_of, b), let(b_du, dual_of, b), *k10.components(b, numbers[False], numbers[True]))

ENTRIES = (
    equation("length", "a spherical motion keeps lengths", 55, equal(length(X), length(x)),
             extract=shown(r"\left\| \hat{X} \right\| = \left\| \hat{x} \right\|"), where=MOVED, also=reflections),
    equation("orthogonal-diagonals", "difference and sum are orthogonal", 59, equal(inner(X - x, X + x), 0),
             extract=shown(r"(\hat{X} - \hat{x})^T (\hat{X} + \hat{x}) = 0."), where=MOVED, also=reflections),
    equation("sum-and-difference", "sum and difference from x̂", 63,
             both(equal(X + x, (A + I) * x), equal(x, (A + I) ** (-1) * (X + x)), equal(group(X - x), (A - I) * x)),
             extract=shown(r"\hat{X} + \hat{x} = (\hat{A} + I)\hat{x} \hat{x} = (\hat{A} + I)^{-1}(\hat{X} + \hat{x}) "
                           r"(\hat{X} - \hat{x}) = (\hat{A} - I)\hat{x}"),
             where=MOVED, condition=no_half_turn, also=reflections),
    equation("difference-from-sum", "difference from sum", 68, equal(X - x, (A - I) * (A + I) ** (-1) * (X + x)),
             extract=shown(r"\hat{X} - \hat{x} = (\hat{A} - I)(\hat{A} + I)^{-1}(\hat{X} + \hat{x})"),
             where=MOVED, condition=no_half_turn, also=reflections),
    equation("b-orthogonal", "B̂(X̂ + x̂) is orthogonal to X̂ + x̂", 70, zero(dot(B * (X + x), X + x)), where=FROM_A,
             condition=no_half_turn),
    equation("quadratic-form", "the quadratic form of B̂ vanishes", 72,
             equal(quadratic(z, B), sum_all(symmetric_part), 0),
             extract=shown(r"\hat{z}^{T}\hat{B}\hat{z} = \sum (\hat{b}_{ij} + \hat{b}_{ji})\hat{z}_{i}\hat{z}_{j} = "
                           r"0."),
             components=True, where=FROM_A, condition=no_half_turn,
             remark="Both sides are 0, whichever i and j the sum is over."),
    equation("quadratic-expansion", "the expansion, as the step that has to show B̂ skew", 72,
             (Reading(equal(quadratic(z, B), sum_all(symmetric_part)), "the sum is over all i and j"),
              Reading(equal(quadratic(z, B), sum_upper(symmetric_part)), "over i ≤ j"),
              Reading(equal(quadratic(z, B), sum_above(symmetric_part)), "over i < j")),
             extract=shown(r"\hat{z}^{T}\hat{B}\hat{z} = \sum (\hat{b}_{ij} + \hat{b}_{ji})\hat{z}_{i}\hat{z}_{j}"),
             where=quadratic_of_any, corrected=equal(quadratic(z, B), half * sum_all(symmetric_part)),
             remark="The sum over all i and j counts each product twice, the others err in the squares. The matrix is "
                    "not yet known to be skew; the conclusion stands."),
    equation("skew-entries", "entries of B̂", 74,
             everywhere(both(equal(entry(b_ij, i, i), 0), equal(entry(b_ij, i, j), -entry(b_ij, j, i)))),
             extract=shown(r"\hat{b}_{ii} = 0 \hat{b}_{ij} = -\hat{b}_{ji}"), components=True, where=FROM_A,
             condition=no_half_turn),
    equation("skew", "B̂ is skew-symmetric", 74, equal(B, -transpose(B)), extract=shown(r"\hat{B} = -\hat{B}^T"),
             where=FROM_A, condition=no_half_turn),
    equation("not-singular", "I − B̂ is not singular", 76, nonzero(Re(det(I - B))),
             where=(let(B, skew_of, b),), because=equal(det(I - B), 1 + norm(b)**2)),
    equation("b-matrix", "B̂ from Â", 78, equal(B_bare, (A - I) * (A + I) ** (-1)),
             extract=shown(r"B = (\hat{A} - I)(\hat{A} + I)^{-1}"), where=INVARIANT, condition=no_half_turn),
    equation("b-times", "B̂(Â + I)", 79, equal(B * (A + I), group(A - I)),
             extract=shown(r"\hat{B}(\hat{A} + I) = (\hat{A} - I)"), where=INVARIANT, condition=no_half_turn),
    equation("b-plus-identity", "B̂ + I", 80, equal(B + I, A - B * A),
             extract=shown(r"\hat{B} + I = \hat{A} - \hat{B}\hat{A}"), where=INVARIANT, condition=no_half_turn),
    equation("a-from-b", "Â from B̂", 81, equal((I + B) * (I - B) ** (-1), A),
             extract=shown(r"(I + \hat{B})(I - \hat{B})^{-1} = \hat{A}"), where=INVARIANT, condition=no_half_turn),
    equation("cayley-formula", "Cayley formula", 85, equal(A, (I + B) * (I - B) ** (-1)),
             extract=shown(r"\hat{A} = (I + \hat{B})(I - \hat{B})^{-1}"), where=INVARIANT, condition=no_half_turn),
    equation("transposed", "transpose of Â", 89,
             equal(transpose(A), transpose(I + B) * transpose(group((I - B) ** (-1))),
                   (I + transpose(B)) * (I - transpose(B)) ** (-1), (I - B) * (I + B) ** (-1)),
             extract=shown(r"\hat{A}^{T} = (I + \hat{B})^{T} ((I - \hat{B})^{-1})^{T} = (I + \hat{B}^{T})(I - "
                           r"\hat{B}^{T})^{-1} = (I - \hat{B})(I + \hat{B})^{-1}"), where=ANY_B),
    equation("orthogonal", "every skew-symmetric B̂ gives an orthogonal Â", 95,
             equal(A * transpose(A), transpose(A) * A, I),
             extract=shown(r"\hat{A}\hat{A}^{T} = \hat{A}^{T}\hat{A} = I"), where=ANY_B),
    equation("every-orthogonal", "a B̂ for a given orthogonal Â", 109, reaches(cay, A),
             where=(let(cay, k10.cayley_map),), condition=no_half_turn, also=reflections,
             remark="Where Â = (I + B̂)(I − B̂)⁻¹ the inverse of Â + I is (I − B̂)/2. So half turns and "
             "reflections have no B̂."),
    equation("matrix", "the matrix of b̂", 101, equal(B, matrix(0, -b3, b2, b3, 0, -b1, -b2, b1, 0)),
             extract=shown(r"\hat{B} = \begin{bmatrix} 0 & -\hat{b}_3 & \hat{b}_2 \\ \hat{b}_3 & 0 & -\hat{b}_1 \\ "
                           r"-\hat{b}_2 & \hat{b}_1 & 0 \end{bmatrix}"), components=True,
                           where=(let(B, k10.cross_matrix, b),)),
    equation("vector", "components of b̂", 103,
             equal(b, parts(b_re, b_du), column(*(numbers[False][n] + e * numbers[True][n] for n in range(3))),
                   column(b1, b2, b3)),
             extract=shown(r"\hat{b} = (b, b^*) = (b_1 + eb_1^*, b_2 + eb_2^*, b_3 + eb_3^*) = (\hat{b}_1, \hat{b}_2, "
                           r"\hat{b}_3)"), components=True, where=PARTS),
    equation("product", "B̂ as a vector product", 105, equal(B * y, cross(b, y)),
             extract=shown(r"\hat{B} \quad \hat{y} = \hat{b} \times \hat{y}."), where=(let(B, skew_of, b),)),
)
