"""Section 3, components of the dual Rodrigues vector, (8)-(22): lines 153-248."""

from functools import partial
from typing import Any

from .. import k10_definitions as k10
from . import *
from .s3a_rodrigues import OF_ANY, OF_SCREW, PARTS, b, b_, b_hat, f, forward, s, s_, s_hat, slope, turn

b1, b2, b3 = bs = tuple(real("b", index) for index in (1, 2, 3))
b1_, b2_, b3_ = bs_ = tuple(real("b", index, star=True) for index in (1, 2, 3))
s1, s2, s3 = ss = tuple(real("s", index) for index in (1, 2, 3))
s1_, s2_, s3_ = ss_ = tuple(real("s", index, star=True) for index in (1, 2, 3))

COMPONENTS = (*PARTS, *k10.components(b_hat, bs, bs_), *k10.components(s_hat, ss, ss_))
ANY, SCREW = (*OF_ANY, *COMPONENTS), (*OF_SCREW, *COMPONENTS)
axes = k10.special_axes(turn)
relation = partial(equation, components=True, also=axes)

T: Term = Tan(f / 2)
general = both(nonzero(s1), nonzero(s2), nonzero(s3))
"""Assumption of the paper after line 219."""

# ---- (8)-(13): any dual vector --------------------------------------------------------------------------------

total = b1 * b1_ + b2 * b2_ + b3 * b3_
_S = (r"s_{%d}^{*} = \frac{b_{%d}^{*} \left\| \stackrel{\mathbf{r}}{b} \right\|^{2} - b_{%d} (b_{1} b_{1}^{*} + b_{2} "
      r"b_{2}^{*} + b_{3} b_{3}^{*})}{\left\| \stackrel{\mathbf{r}}{b} \right\|^{3}}")
_B = (r"b_{%d}^{*} = \frac{s_{%d}^{*} \left\| b \right\|^{3} + b_{%d} b_{%d} b_{%d}^{*} + b_{%d} b_{%d} b_{%d}^{*}}"
      r"{\left\| b \right\|^{2} - b_{%d}^{2}}")


def from_b(number: str, line: int, n: int) -> Entry:
    """Return the entry for one of (8)-(10)."""
    b_n, b_n_, s_n_ = bs[n - 1], bs_[n - 1], ss_[n - 1]
    return relation(number, f"s{n}* from b̂", line,
                    equal(s_n_, (b_n_ * length(b)**2 - b_n * group(total)) / length(b)**3),
                    extract=shown(_S % (n, n, n)), where=ANY, condition=nonzero(b))


def back_to_b(number: str, line: int, n: int, others: tuple[int, int]) -> Entry:
    """Return the entry for one of (11)-(13)."""
    b_n, (m, o) = bs[n - 1], others
    below = length(b)**2 - b_n**2
    above = ss_[n - 1] * length(b)**3 + b_n * bs[m - 1] * bs_[m - 1] + b_n * bs[o - 1] * bs_[o - 1]
    return relation(number, f"b{n}* from ŝ and the others", line, equal(bs_[n - 1], above / below),
                    extract=shown(_B % (n, n, n, m, m, n, o, o, n)), where=ANY, condition=nonzero(below),
                    remark="Not where b lies along that axis.")


VECTOR = (
    relation("unit-rodrigues", "unit Rodrigues vector", 153, equal(s, b / length(b)),
             extract=shown(r"\stackrel{\mathbf{r}}{s} = \frac{\stackrel{\mathbf{b}}{b}}{\left\|\stackrel{\mathbf{r}}{b}"
                           r"\right\|}"), where=ANY, condition=nonzero(b)),
    from_b("8", 166, 1), from_b("9", 169, 2), from_b("10", 174, 3),
    back_to_b("11", 179, 1, (2, 3)), back_to_b("12", 182, 2, (1, 3)), back_to_b("13", 185, 3, (1, 2)),
)

# ---- (14)-(17): displacements ---------------------------------------------------------------------------------


def linear(n: int, first: Term, second: Term) -> Term:
    """Return the right side of one of (14)-(16), with its two products in printed order."""
    return (ss_[n - 1] * T + first + second) / (1 - ss[n - 1] ** 2)


cubed = s1_ * Tan3(f / 2) + s1 * s2 * Tan2(f / 2) * b2_ + s1 * s3 * Tan2(f / 2) * b3_
full_turn = ordered(Number(0), f, 2 * pi)
half_turn = ordered(Number(0), f, pi)
right_14, right_15, right_16 = (
    linear(1, s1 * s2 * b2_, s1 * s3 * b3_), linear(2, s1 * s2 * b1_, s2 * s3 * b3_),
    linear(3, s3 * s1 * b1_, s3 * s2 * b2_),
)
BEYOND = "Beyond a half turn ‖b‖ is −Tan f/2, and s, which has the direction of b, is opposite to the axis."

LINEAR = (
    relation("real-parameters", "real Rodrigues parameters", 190,
             both(equal(b1, s1 * T), equal(b2, s2 * T), equal(length(b), T), equal(b3, s3 * T)),
             extract=shown(r"b_1 = s_1 Tan \frac{f}{2} b_2 = s_2 Tan \frac{f}{2} \left\| \stackrel{\mathbf{r}}{b} "
                           r"\right\| = Tan \frac{f}{2} b_3 = s_3 Tan \frac{f}{2}"),
             where=SCREW, condition=forward),
    relation("with-tangents", "(11) with tangents", 198, equal(b1_, cubed / (Tan2(f / 2) - s1**2 * Tan2(f / 2))),
             extract=shown(r"b_{1}^{*} = \frac{s_{1}^{*}Tan^{3}\frac{f}{2} + s_{1}s_{2}Tan^{2}\frac{f}{2}b_{2}^{*} + "
                           r"s_{1}s_{3}Tan^{2}\frac{f}{2}b_{3}^{*}}{Tan^{2}\frac{f}{2} - s_{1}^{2}Tan^{2}\frac{f}{2}}"),
             where=SCREW, condition=both(forward, nonzero(1 - s1**2))),
    relation("14", "b1* from the others", 202, provided(equal(b1_, right_14), full_turn),
             extract=shown(r"b_{1}^{*} = \frac{s_{1}^{*}Tan\frac{f}{2} + s_{1}s_{2}b_{2}^{*} + s_{1}s_{3}b_{3}^{*}}"
                           r"{1 - s_{1}^{2}}, \quad 0 < f < 2p"),
             where=SCREW, remark=BEYOND,
             corrected=provided(provided(equal(b1_, right_14), nonzero(1 - s1**2)), half_turn)),
    relation("15", "b2* from the others", 207, equal(b2_, right_15),
             extract=shown(r"b_2^* = \frac{s_2^* Tan \frac{f}{2} + s_1 s_2 b_1^* + s_2 s_3 b_3^*}{1 - s_2^2}"),
             where=SCREW, condition=both(forward, nonzero(1 - s2**2)), remark=BEYOND),
    relation("16", "b3* from the others", 210, equal(b3_, right_16),
             extract=shown(r"b_3^* = \frac{s_3^* Tan \frac{f}{2} + s_3 s_1 b_1^* + s_3 s_2 b_2^*}{1 - s_3^2}"),
             where=SCREW, condition=both(forward, nonzero(1 - s3**2)), remark=BEYOND),
    relation("unit-norm", "ŝ is a unit dual vector", 212, equal(length(s_hat), 1),
             extract=shown(r"\|\hat{s}\| = 1"), where=ANY, condition=nonzero(b)),
    relation("17", "ŝ is a unit dual vector, by parts", 214,
             both(equal(s1**2 + s2**2 + s3**2, 1), equal(s1 * s1_ + s2 * s2_ + s3 * s3_, 0)),
             extract=shown(r"s_1^2 + s_2^2 + s_3^2 = 1, s_1s_1^* + s_2s_2^* + s_3s_3^* = 0."), where=ANY,
             condition=nonzero(b)),
)

# ---- line 219 and (18)-(22) -----------------------------------------------------------------------------------

equations: dict[str, tuple[Term, Term]] = {
    "14": (b1_, right_14), "15": (b2_, right_15), "16": (b3_, right_16),
    "18": (b1_, (slope - s2 * b2_ - s3 * b3_) / s1),
    "19": (s2 * b2_ + s3 * b3_, group(1 - s1**2) * slope - s1 * s1_ * T),
    **{number: (bs_[n], ss_[n] * T + ss[n] * slope) for n, number in enumerate(("22", "20", "21"))},
}
"""Both sides of equations by number."""

SOLUTION = r"b_%d^* = s_%d^* Tan \frac{f}{2} + s_%d \frac{f^*}{2} (1 + Tan^2 \frac{f}{2})"


def solution(number: str, line: int, n: int, restated: bool = False) -> Entry:
    """Return the entry for one of (20)-(22)."""
    name, title = (f"conclusion-{number}", ", restated") if restated else (number, "")
    return relation(name, f"dual Rodrigues parameter b{n}*{title}", line, equal(*equations[number]),
                    extract=shown(SOLUTION % (n, n, n)), where=SCREW, condition=forward)


SYSTEM = identity - dyad(s, s)
SOLVED = (
    relation("zero-components", "b* from (14)-(16) where one or two of s1, s2, s3 are 0", 219,
             nonzero(det(SYSTEM)), where=SCREW, claimed=zero(s1 * s2 * s3),
             stated=(219, "If one or two of them are equal to zero"),
             said="If one or two of them are equal to zero then one can obtain the solutions of b_i^* 's from (14), "
                  "(15), (16).",
             because=equal(det(identity - dyad(turn, turn)), 0),
             corrected=implies(forward, equal(b_, T * s_ + slope * s)),
             remark="(14)-(16) are (I − s ⊗ s) b* = Tan f/2 s*, a singular system: they leave b* free along s. With "
             "(6) they have one solution, the same as for other s."),
    relation("denominators", "the denominators of (14)-(16)", 219,
             both(*(iff(nonzero(1 - s_n**2), negated(both(zero(s_m), zero(s_o))))
                    for s_n, s_m, s_o in ((s1, s2, s3), (s2, s3, s1), (s3, s1, s2)))), where=ANY,
             condition=nonzero(b),
             because=equal(1 - component(turn, 1)**2, component(turn, 2)**2 + component(turn, 3)**2),
             remark="So they are not zero where no s is."),
    relation("6-expanded", "(6) by components", 223, equal(s1 * b1_ + s2 * b2_ + s3 * b3_, slope),
             extract=shown(r"s_1b_1^* + s_2b_2^* + s_3b_3^* = \frac{f^*}{2}(1 + Tan^2\frac{f}{2})."), where=SCREW,
             condition=forward),
    relation("18", "b1* from (6)", 227, equal(*equations["18"]),
             extract=shown(r"b_1^* = \frac{\frac{f^*}{2}(1 + Tan^2\frac{f}{2}) - s_2b_2^* - s_3b_3^*}{s_1}"),
             where=SCREW, claimed=nonzero(s1), stated=(225, "Since $s_1 \\neq 0$"), condition=forward),
    relation("19", "(14) and (18)", 232, equal(*equations["19"]),
             extract=shown(r"s_2 b_2^* + s_3 b_3^* = (1 - s_1^2) \frac{f^*}{2} (1 + Tan^2 \frac{f}{2}) - s_1 s_1^* Tan "
                           r"\frac{f}{2} ."), where=SCREW, condition=forward),
    solution("20", 237, 2), solution("21", 242, 3), solution("22", 247, 1),
)

# ---- derivation steps of (19)-(22) ----------------------------------------------------------------------------
# Each step uses only the equations it cites: they are solved for the unknown, and all other symbols are free.

unit = Symbol("s^", "unit vector", r"\hat{s}")


def solved(unknown: Symbol, left: Term, right: Term) -> Definition:
    """Return the definition of an unknown as the solution of a linear equation."""

    def solution(env: Env, *_: Any) -> Any:
        at_0, at_1 = (env.bound(unknown, value).value(left - right) for value in (0, 1))
        return -at_0 / (at_1 - at_0)

    return let(unknown, solution, *(symbol for symbol in symbols(left - right) if symbol != unknown))


def step(number: str, line: int, given: Definition, conclusion: str) -> Entry:
    """Return the entry about a derivation step whose conclusion is a numbered equation."""
    left, right = equations[conclusion]
    return equation(f"step-{conclusion}", f"{number} give ({conclusion})", line, equal(left, right), claimed=general,
                    stated=(219, r"Now we take $s_1 \neq 0, s_2 \neq 0, s_3 \neq 0$"), condition=nonzero(cos(f / 2)),
                    where=(*k10.components(unit, ss, ss_), given), components=True)


(_, on_14), (_, on_15), (_, on_18), (sum_19, on_19), (_, on_20), (_, on_21) = (
    equations[number] for number in ("14", "15", "18", "19", "20", "21")
)

STEPS = (
    step("(14) and (18)", 230, solved(b2_, on_14, on_18), "19"),
    step("(18) and (15)", 235, solved(b2_, b2_, on_15.xreplace({b1_: on_18})), "20"),
    step("(20) and (19)", 240, solved(b3_, sum_19.xreplace({b2_: on_20}), on_19), "21"),
    step("(20), (21) and (15)", 245, solved(b1_, on_20, on_15.xreplace({b3_: on_21})), "22"),
)

ENTRIES = (*VECTOR, *LINEAR, *SOLVED, *STEPS)
