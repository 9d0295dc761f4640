"""Section 7, references to wrong equation numbers: lines 243, 253, 304 and 313."""

from . import *
from . import s06_cayley_quaternions, s07a_fractional_transform, s07c_parameterizations
from .general_order import q_of
from .s07a_fractional_transform import turned

PRINTED = {entry.number: entry.readings[0].statement for section in (
    s06_cayley_quaternions, s07a_fractional_transform, s07c_parameterizations) for entry in section.ENTRIES}
"""Statements by equation number."""


def reference(slug: str, named: int, meant: int, part: Term) -> Entry:
    """Return the entry about a sentence that cites one equation but means another, which has a part."""
    wrong, right = (
        proposition(f"({number}) displays it", f"${latex(part)}$ is a part of ({number})") for number in (named, meant)
    )
    where = (let(wrong, lambda env: part in walk(PRINTED[str(named)])),
             let(right, lambda env: part in walk(PRINTED[str(meant)])))
    return equation(slug, wrong, where=where, corrected=right)


ENTRIES = (
    reference("theorem-12-reference", 47, 46, term((1 + v)**(n / 2) * (1 - v)**(-(n / 2)))),
    reference("theorem-13-reference", 41, 46, n),
    reference("theorem-16-reference", 61, 60, turned),
    reference("corollary-5-reference", 63, 62, q_of),
)
