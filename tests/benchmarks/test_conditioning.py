"""Check of the figure on conditioning: measured errors agree with the predicted lines."""

from __future__ import annotations

import mpmath
import pytest

from benchmarks import conditioning
from tests.support import sampling


@pytest.mark.parametrize(
    ("order", "branch", "near_half_turn"), [(3, 0, False), (3, 1, False), (8, 3, False), (2, 0, True), (1, 0, True)]
)
def test_errors_are_of_the_size_of_the_condition(order: int, branch: int, near_half_turn: bool) -> None:
    """Allow a factor of 20 at distances up to 1e-6: errors consist of some roundings in different directions."""
    directions = sampling.unit_vectors(sampling.generator("conditioning"), (4,))
    with mpmath.workdps(30):
        for distance in ("1e-6", "1e-10"):
            alpha = mpmath.pi - mpmath.mpf(distance) if near_half_turn else mpmath.mpf(distance)
            lost = conditioning.condition(order, branch, alpha)
            assert lost < 2 if (order, branch) in ((3, 0), (2, 0)) else lost > 1e5
            assert lost / 20 < conditioning.relative_error(order, branch, alpha, directions) < 20 * lost
