"""Every kernel function is covered, by theorems that exist and a validation that runs it."""

from __future__ import annotations

import pytest
from derive.codegen.validation.maps_at import MAPS

from derive.codegen.module import PUBLIC
from derive.codegen.signatures import SIGNATURES
from derive.codegen.validation import exact
from derive.maps import Cayley
from derive.proof import Ring, theorems
from derive.proof.coverage import COVERAGE

ALIASES = {"dcay": "tangent", "dcay_inv": "tangent_inv"}


def test_every_kernel_function_is_covered_and_nothing_else() -> None:
    assert set(COVERAGE) == set(PUBLIC)


@pytest.mark.parametrize("name", COVERAGE)
def test_theorems_exist_and_are_proved(name: str) -> None:
    proved = {proof.name for proof in theorems() if proof.proved}
    assert COVERAGE[name].theorems
    assert set(COVERAGE[name].theorems) <= proved


def test_validations_run_what_they_say() -> None:
    exactly = {case.function for case in exact.expectations(Cayley(3), Ring)}
    for name, coverage in COVERAGE.items():
        function = ALIASES.get(name, name)
        if coverage.validation == "exact":
            assert function in exactly, name
        elif coverage.validation == "50 digits":
            assert function in MAPS, name
            assert coverage.only_validated, name
        else:
            assert function not in SIGNATURES, name


def test_lines() -> None:
    assert COVERAGE["pose"].lines() == ("theorem: pose", "theorem: orthogonality", "validation: exact")
    assert COVERAGE["from_screw"].lines()[-1] == "validation: 50 digits, alone: tan of a dual angle"
