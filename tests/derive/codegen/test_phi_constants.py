"""φ with factors that are no small fractions: what is printed computes the formula to the digits it has."""

from __future__ import annotations

from pathlib import Path

import mpmath
import pytest

from derive.codegen import generate
from derive.maps.split import BITS, LEVELS, polynomial


@pytest.mark.filterwarnings("ignore:invalid value encountered in tan")  # of NaN, beyond the edge
@pytest.mark.parametrize("phi", ["pi*alpha/4", "pi*alpha/4 + alpha**3/1000"])
def test_kernels_are_validated(tmp_path: Path, phi: str) -> None:
    package = generate(phi=phi, name="mine", output=tmp_path)
    assert package.modules[0].validated > 0


def test_numbers_are_split_to_all_levels_whatever_the_precision_around() -> None:
    with mpmath.workdps(60):
        third = mpmath.mpf(1) / 3
    assert mpmath.mp.prec < BITS * LEVELS
    split = polynomial([third])
    assert split.levels[2] != (0,)
    with mpmath.workdps(60):
        assert abs(split.value(0) - third) < 2.0 ** -(BITS * LEVELS)
