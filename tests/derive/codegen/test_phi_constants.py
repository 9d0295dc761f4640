"""φ with factors that are no small fractions: what is printed computes the formula to the digits it has."""

from __future__ import annotations

from pathlib import Path

import mpmath

from derive.codegen import generate
from derive.codegen.facts import Facts
from derive.codegen.lowered import lower
from derive.codegen.module import module_name, module_text, shared_texts
from derive.codegen.targets import TARGETS
from derive.codegen.validation import validate
from derive.maps import parameterization
from derive.maps.split import BITS, LEVELS, polynomial
from derive.output import files
from derive.proof import prove


def test_kernels_are_validated_and_replayed(tmp_path: Path) -> None:
    package = generate(phi="pi*alpha/4", name="mine", output=tmp_path)
    assert package.modules[0].validated > 0


def test_a_factor_beside_another_term_has_all_digits(tmp_path: Path) -> None:
    chart, target = parameterization("pi*alpha/4 + alpha**3/1000", "mine"), TARGETS["numpy"]
    proved = prove(chart)
    text = {module_name(chart, target): module_text(Facts(proved, lower(proved)), target)}
    files.write(tmp_path / "of_mine", {**shared_texts(target), **text})
    assert validate(tmp_path / "of_mine", chart) > 1000


def test_numbers_are_split_to_all_levels_whatever_the_precision_around() -> None:
    with mpmath.workdps(60):
        third = mpmath.mpf(1) / 3
    assert mpmath.mp.prec < BITS * LEVELS
    split = polynomial([third])
    assert split.levels[2] != (0,)
    with mpmath.workdps(60):
        assert abs(split.value(0) - third) < 2.0 ** -(BITS * LEVELS)
