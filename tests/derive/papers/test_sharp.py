"""Sharpness of conditions, shown by denominators that every evaluation meets."""

from __future__ import annotations

import pytest

from derive.papers.condurache_popa_2023.cp23_notation import alpha, u, v
from derive.papers.language.operator_table import (
    Re,
    both,
    cases,
    cos,
    cot,
    det,
    equal,
    implies,
    nonzero,
    norm,
    remark,
    root,
    sin,
    skew,
    tan,
    words,
)  # fmt: skip
from derive.papers.language.operator_table import identity as I
from derive.papers.language.printed import Symbol
from derive.papers.sharp import is_sharp

a, b, c = (Symbol(name, "dual number") for name in "abc")


@pytest.mark.parametrize(
    ("condition", "statement"),
    [(nonzero(Re(b)), equal(a / b, c)), (nonzero(b), equal(a / b, c)),
     (remark(nonzero(Re(b)), words("", "")), equal(a / b, c)),
     (nonzero(Re(b)), both(equal(a, c), equal(c, a / (2 / b)))), (nonzero(Re(sin(alpha))), equal(a, cot(alpha))),
     (nonzero(Re(b)), equal(a / (b**2 * c), c)), (nonzero(Re(b)), equal(a / (c * b**2), c)),
     (both(nonzero(Re(b)), nonzero(Re(c))), equal(a / (c * b), c)), (nonzero(Re(v)), equal(v / norm(v) ** 2, v)),
     (nonzero(Re(1 - b)), equal(a / root((1 - b) ** 3), a)),
     (nonzero(Re(cos(alpha / 2))), equal(v, tan(alpha / 2) * u)),
     (nonzero(Re(b)), equal(b ** (-1), a)), (nonzero(Re(det(I + skew(v)))), equal((I + skew(v)) ** (-1), I))],
    ids=str,
)  # fmt: skip
def test_condition_on_a_denominator_is_sharp(condition, statement) -> None:
    assert is_sharp(condition, statement)


@pytest.mark.parametrize(
    ("condition", "statement"),
    [(nonzero(Re(a)), equal(a / b, c)), (implies(nonzero(Re(b)), nonzero(Re(b))), equal(a / b, c)),
     (remark(nonzero(Re(a)), words("", "")), equal(a / b, c)), (both(nonzero(Re(b)), nonzero(Re(a))), equal(a / b, c)),
     (nonzero(Re(b)), equal(a / (b + 1), c)),
     (nonzero(Re(b)), equal(a, cases((a / b, nonzero(Re(b))), (a, equal(a, a))))),
     (nonzero(Re(sin(alpha / 2))), equal(v, tan(alpha / 2) * u)), (equal(b, 1), equal(a / b, c))],
    ids=str,
)  # fmt: skip
def test_condition_without_a_matching_denominator_is_not_sharp(condition, statement) -> None:
    assert not is_sharp(condition, statement)
