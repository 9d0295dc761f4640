"""Section 7, equations that are named by another number: lines 243, 253, 304 and 313."""

from __future__ import annotations

from ...equation import Equation, equation
from ...language.claims import proposition
from ...language.evaluation import let
from ...language.terms import Term, latex, term
from ..alphabet import n, v
from ..meanings.references import displays
from . import s06_cayley_quaternions, s07a_fractional_transform, s07c_parameterizations
from .s07_general_order import q_of
from .s07a_fractional_transform import turned

KNOWN = (*s06_cayley_quaternions.ENTRIES, *s07a_fractional_transform.ENTRIES, *s07c_parameterizations.ENTRIES)


def reference(slug: str, title: str, line: int, named: int, meant: int, part: Term, remark: str) -> Equation:
    """A sentence that takes something from an equation, which another one displays."""
    said, right = (
        proposition(f"({number}) displays it", f"${latex(part)}$ is a part of ({number})") for number in (named, meant)
    )
    where = (let(said, displays(KNOWN, str(named), part)), let(right, displays(KNOWN, str(meant), part)))
    return equation(slug, title, line, said, where=where, corrected=right, remark=remark)


ENTRIES = (
    reference("theorem-12-reference", "what the proof of Theorem 12 begins with", 243, 47, 46,
              term((1 + v)**(n / 2) * (1 - v)**(-(n / 2))), "Equation (46) is meant; (47) is where the proof arrives."),
    reference("theorem-13-reference", "where the parameterization of Theorem 13 is obtained", 253, 41, 46, n,
              "Equation (46) is meant, which has an order n; (41) composes two displacements at n = 2."),
    reference("theorem-16-reference", "what the proof of Theorem 16 follows from", 304, 61, 60, turned,
              "Equation (60) is meant; (61) is what the theorem claims, and has no angle."),
    reference("corollary-5-reference", "the quaternion of which Corollary 5 is the tensor", 313, 63, 62, q_of,
              "Equation (62) is meant; (63) is the polynomial p_n."),
)  # fmt: skip
