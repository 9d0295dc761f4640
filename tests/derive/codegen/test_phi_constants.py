"""Charts of φ with irrational constants: kernels compute them to full precision."""

from __future__ import annotations

from pathlib import Path

import mpmath
import numpy as np
import pytest

from derive.algebra.arithmetic import PLAIN
from derive.codegen.build import print_package
from derive.codegen.signatures import POSES
from derive.codegen.targets import TARGETS
from derive.codegen.validation import validate
from derive.codegen.validation.loading import loaded, module_of
from derive.maps import parameterization
from derive.maps.real_constants import BITS, LEVELS, polynomial
from derive.output import files


@pytest.mark.parametrize("phi", ["pi*alpha/4", pytest.param("alpha*(pi + alpha**2)/4", marks=pytest.mark.thorough)])
def test_kernels_are_validated_and_hold_in_single_precision(tmp_path: Path, phi: str) -> None:
    """Require small integers in the split of π: powers of a long integer overflow float32 and spoil v = 0."""
    chart = parameterization(phi, "mine")
    files.write(tmp_path / "of_mine", print_package([chart], TARGETS["numpy"]).texts)
    assert validate(tmp_path / "of_mine", chart, geometry=True) > 500
    v = np.linspace(0, 1, 12, dtype=np.float32).reshape(2, 6)[::-1]
    with loaded(tmp_path / "of_mine") as package:
        kernels = module_of(package, chart, POSES)
        for name in ("quaternion", "tangent", "tangent_inv", "principal"):
            single, double = (getattr(kernels, name)(np.append(v, [6 * [0]], 0).astype(t)) for t in ("f4", "f8"))
            # a few dozen operations on values below 10, each with an error of eps/2
            assert np.all(abs(single - double) < 200 * np.finfo(np.float32).eps), name


def test_all_levels_are_split_at_any_working_precision() -> None:
    with mpmath.workdps(60):
        third = mpmath.mpf(1) / 3
    assert mpmath.mp.prec < BITS * LEVELS
    split = polynomial([third])
    assert split.levels[2] != (0,)
    with mpmath.workdps(60):
        assert abs(split.at(mpmath.mpf(0), PLAIN, "") - third) < 2.0 ** -(BITS * LEVELS)
