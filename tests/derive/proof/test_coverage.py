"""Every kernel function is covered, by theorems that exist and a validation that runs it."""

from __future__ import annotations

import pytest

from derive.codegen.signatures import PUBLIC
from derive.proof import theorems
from derive.proof.coverage import COVERAGE

ALIASES = {alias: name for name, row in PUBLIC.items() for alias in row.aliases}


def test_every_kernel_function_is_covered_and_nothing_else() -> None:
    assert set(COVERAGE) == {*PUBLIC, *ALIASES, "singular_angles"}


@pytest.mark.parametrize("name", COVERAGE)
def test_theorems_exist_and_are_proved(name: str) -> None:
    proved = {proof.name for proof in theorems() if proof.proved}
    assert COVERAGE[name].theorems
    assert set(COVERAGE[name].theorems) <= proved


def test_validations_are_those_of_the_table() -> None:
    """Which an expectation must serve, exactly or not, before anything is generated."""
    for name, coverage in COVERAGE.items():
        row = PUBLIC.get(ALIASES.get(name, name))
        if row is None:
            assert coverage.validation == "text", name
        else:
            assert coverage.validation == ("exact" if row.exact else "50 digits"), name
            assert row.exact or coverage.only_validated, name


def test_lines() -> None:
    assert COVERAGE["pose"].lines() == ("theorem: pose", "theorem: orthogonality", "validation: exact")
    assert COVERAGE["from_screw"].lines()[-1] == "validation: 50 digits, alone: tan of a dual angle"
