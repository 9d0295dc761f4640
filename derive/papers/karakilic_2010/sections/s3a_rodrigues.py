"""Section 3, the Rodrigues equations in dual form, (1)-(7): lines 109-161."""

from ....maps import rodrigues
from .. import k10_definitions as k10
from . import *

# ---- the equations of motion ----------------------------------------------------------------------------------

A, x, X = hat("A", "orthogonal tensor"), hat("x", "dual vector"), hat("X", "dual vector")
B, b_hat = hat("B", "tensor"), hat("b", "dual vector")
MOVED = (let(X, image, A, x), let(B, plain(rodrigues.cayley_matrix), A),
         let(b_hat, plain(rodrigues.rodrigues_vector), A))
no_half_turn = nonzero(Re(det(A + identity)))

EQUATIONS = (
    equation("rodrigues-matrix", "Rodrigues equation with B̂", 111, equal(X - x, B * (X + x)),
             extract=shown(r"\hat{X} - \hat{x} = \hat{B}(\hat{X} + \hat{x})"), where=MOVED, condition=no_half_turn),
    equation("rodrigues-vector", "Rodrigues equation with b̂", 115, equal(X - x, cross(b_hat, X + x)),
             extract=shown(r"\hat{X} - \hat{x} = \hat{b} \times (\hat{X} + \hat{x})."), where=MOVED,
             condition=no_half_turn),
)

# ---- the rhombus of figure 1 ----------------------------------------------------------------------------------

f_hat, axis, Q = hat("f", "angle"), Symbol("axis", "unit vector"), Symbol("Q", "orthogonal tensor")
size, height = Symbol("size", "dual number"), Symbol("height", "dual number")
x_across, X_across = hat("x", "dual vector", "'"), hat("X", "dual vector", "'")
FIGURE = (
    let(axis, k10.axis_of, Q), let(x, k10.raised, size, height, Q), let(x_across, k10.across, size, Q),
    let(X, k10.turned, x, f_hat, axis), let(X_across, k10.projected, X, axis),
    let(A, screw_tensor, f_hat, axis), let(b_hat, plain(rodrigues.rodrigues_vector), A),
)
turned_less = nonzero(Re(cos(f_hat / 2)))
ratio = length(X_across - x_across) / length(X_across + x_across)
seen = nonzero(Re(length(X_across + x_across)))

RHOMBUS = (
    equation("rhombus", "X̂' and x̂' are sides of a rhombus", 117,
             both(equal(length(X_across), length(x_across)), zero(dot(X_across + x_across, X_across - x_across))),
             where=FIGURE),
    equation("vertex-angle", "f̂ is the angle of X̂' and x̂'", 117,
             equal(dot(X_across, x_across), length(X_across) * length(x_across) * cos(f_hat)), where=FIGURE),
    equation("projected", "Rodrigues equation of the projections", 123,
             equal(X_across - x_across, cross(b_hat, X_across + x_across)),
             extract=shown(r"\hat{X}' - \hat{x}' = \hat{b} \times (\hat{X}' + \hat{x}')"), where=FIGURE,
             condition=turned_less),
    equation("diagonals", "lengths of the diagonals", 123,
             equal(length(X_across - x_across), length(b_hat) * length(X_across + x_across)),
             extract=shown(r"\|\hat{X}' - \hat{x}'\| = \|\hat{b}\| \|\hat{X}' + \hat{x}'\|"), where=FIGURE,
             condition=turned_less),
    equation("ratio", "norm of b̂ as a ratio", 125, equal(length(b_hat), ratio),
             extract=shown(r"\left\| \hat{b} \right\| = \frac{\left\| \hat{X}' - \hat{x}' \right\|}{\left\| \hat{X}' + "
                           r"\hat{x}' \right\|}"), where=FIGURE, condition=seen),
    equation("half-angle", "the ratio as a tangent", 129,
             equal(ratio, (length(X_across - x_across) / 2) / (length(X_across + x_across) / 2), Tan(f_hat / 2)),
             extract=shown(r"\hat{X}' - \hat{x}' \hat{X}' + \hat{x}' = \hat{X}' - \hat{x}' \hat{X}' + \hat{x}' 2 = Tan "
                           r"\frac{\hat{f}}{2}"),
             where=FIGURE, lost="2", condition=both(seen, at_least(Tan(f_hat / 2), 0)),
             fixed_by="figure 1, lines 125 and 133: the same ratio, so that both diagonals are halved",
             remark="The extraction has one 2 for both. Beyond a half turn the tangent is negative."),
    equation("1", "norm of the dual Rodrigues vector", 133, equal(length(b_hat), ratio),
             extract=shown(r"\left\| \hat{b} \right\| = \frac{\left\| \hat{X}' - \hat{x}' \right\|}{\left\| \hat{X}' + "
                           r"\hat{x}' \right\|}"), where=FIGURE, condition=seen),
)

# ---- real and dual parts --------------------------------------------------------------------------------------

f, f_ = real("f", quantity="real angle"), real("f", star=True)
b, b_ = arrow("b"), arrow("b", star=True)
s, s_, s_hat = arrow("s"), arrow("s", star=True), hat("s", "dual vector")
turn = Symbol("turn", "unit vector")
OF_ANY = (let(b_hat, multiple, size, turn),)
OF_SCREW = (let(f_hat, from_parts, f, f_), let(b_hat, k10.screw_rodrigues, f_hat, turn))
PARTS = (
    let(b, real_of, b_hat), let(b_, dual_of, b_hat),
    let(s_hat, k10.direction, b_hat), let(s, real_of, s_hat), let(s_, dual_of, s_hat),
)
slope: Term = f_ / 2 * group(1 + Tan2(f / 2))
forward = ordered(Number(0), Tan(f / 2))
LEGIBLE = "(5), line 151: the same quotient, with its star"

DUAL_PARTS = (
    equation("2", "norm of b̂ by parts", 138, equal(length(b_hat), length(b) + e * (dot(b, b_) / length(b))),
             extract=shown(r"\left\| \hat{b} \right\| = \left\| b \right\| + e \frac{b \cdot b}{\left\| b \right\|}"),
             where=(*OF_ANY, *PARTS), lost="*", condition=nonzero(b), fixed_by=LEGIBLE),
    equation("3", "tangent of half the dual angle", 143, equal(Tan(f_hat / 2), Tan(f / 2) + e * slope),
             extract=shown(r"Tan\frac{\hat{f}}{2} = Tan\frac{f}{2} + e\frac{f^*}{2}(1 + Tan^2\frac{f}{2})"),
             where=OF_SCREW, condition=nonzero(cos(f / 2))),
    equation("4", "both norms", 148, equal(length(b) + e * (pair(b, b_) / length(b)), Tan(f / 2) + e * slope),
             extract=shown(r"\| \stackrel{\mathbf{r}}{b} \| + e \frac{\stackrel{\mathbf{r}}{b} "
                           r"\stackrel{\mathbf{r}}{b}}{\| \stackrel{\mathbf{r}}{b} \|} = Tan \frac{f}{2} + e "
                           r"\frac{f^*}{2} (1 + Tan^2 \frac{f}{2})"),
             where=(*OF_SCREW, *PARTS), lost="*", condition=forward, fixed_by=LEGIBLE),
    equation("real-norm", "norm of the real Rodrigues vector", 151, equal(length(b), Tan(f / 2)),
             extract=shown(r"\left\| \stackrel{\mathbf{r}}{b} \right\| = Tan \frac{f}{2}"), where=(*OF_SCREW, *PARTS),
             condition=at_least(Tan(f / 2), 0), remark="Beyond a half turn it is −Tan f/2."),
    equation("5", "dual part of the norm", 151, equal(pair(b, b_) / length(b), slope),
             extract=shown(r"\frac{\stackrel{\mathbf{r}}{b} \stackrel{\mathbf{r}}{b}^{*}}{\left\| "
                           r"\stackrel{\mathbf{r}}{b} \right\|} = \frac{f^{*}}{2} (1 + Tan^{2} \frac{f}{2})"),
             where=(*OF_SCREW, *PARTS), condition=forward),
    equation("6", "b* along s", 155, equal(dot(s, b_), slope),
             extract=shown(r"\mathbf{\hat{r}}_{s.b*}^{\mathbf{r}} = \frac{f^*}{2} (1 + Tan^2 \frac{f}{2})"),
             where=(*OF_SCREW, *PARTS), lost="·", condition=forward),
    equation("7", "unit dual Rodrigues vector", 161,
             equal(s_hat, s + e * s_, b_hat / length(b_hat),
                   b / length(b) + e * group(b_ / length(b) - (dot(b, b_) / length(b)**3) * b)),
             where=(*OF_ANY, *PARTS), condition=nonzero(b), fixed_by="(8)-(10), which are its components",
             remark="The extraction of the display shows most letters under its arrows as r."),
)

ENTRIES = (*EQUATIONS, *RHOMBUS, *DUAL_PARTS)
