"""Section 7, references to wrong equation numbers: lines 243, 253, 304 and 313."""

from . import *
from . import s06_cayley_quaternions, s07a_fractional_transform, s07c_parameterizations
from .s07_general_order import q_of
from .s07a_fractional_transform import turned

PRINTED = {entry.number: entry.readings[0].statement for section in (
    s06_cayley_quaternions, s07a_fractional_transform, s07c_parameterizations) for entry in section.ENTRIES}
"""Statements by equation number."""


def reference(slug: str, said: str, line: int, named: int, meant: int, part: Term, remark: str) -> Entry:
    """Return the entry about a sentence that cites one equation but means another."""
    wrong, right = (
        proposition(f"({number}) displays it", f"${latex(part)}$ is a part of ({number})") for number in (named, meant)
    )
    where = (let(wrong, lambda env: part in walk(PRINTED[str(named)])),
             let(right, lambda env: part in walk(PRINTED[str(meant)])))
    return equation(slug, "an equation by its number", line, wrong, where=where, said=said, corrected=right,
                    remark=remark)


ENTRIES = (
    reference("theorem-12-reference", "By Equation (47): q ^ _ = 1 + v _ n 2 1 v _ n 2", 243, 47, 46,
              term((1 + v)**(n / 2) * (1 - v)**(-(n / 2))), "Equation (46) is meant; (47) is where the proof arrives."),
    reference("theorem-13-reference", "the parameterization of a displacement obtained from Equation (41)", 253, 41, 46,
              n, "Equation (46) is meant, which has an order n; (41) composes two displacements at n = 2."),
    reference("theorem-16-reference", "According to Equation (61) the following expression is true: a v _ = v _ c o t "
              "α _ + 2 k π 2 n .", 304, 61, 60, turned,
              "Equation (60) is meant; (61) is what the theorem claims, and has no angle."),
    reference("corollary-5-reference", "The orthogonal dual tensor associated with Equation (63) is:", 313, 63, 62,
              q_of, "Equation (62) is meant; (63) is the polynomial p_n."),
)
