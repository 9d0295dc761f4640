"""Each kernel function cites existing theorems; `make check-theorems` decides page and controls."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from derive.codegen.signatures import PUBLIC
from derive.pages.explain import COVERAGE
from derive.proof import notation as m
from derive.proof import theorems
from derive.proof.evaluation import NoValueError
from derive.proof.identity import Check, decide
from docs.pages import proving as command
from docs.pages.controls import Control


def test_proved_control_is_an_error(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    claimed = theorems()
    monkeypatch.setattr(command, "decided", lambda _: claimed[:1])
    monkeypatch.setattr(command, "ORDERS", ())
    monkeypatch.setattr(command, "controls", lambda *_: [Control("t", "nothing altered", claimed[0])])
    assert command.main([]) == 1
    assert capsys.readouterr().err == "t: nothing altered\n"


def test_missing_value_is_no_failed_control() -> None:
    def checks() -> Iterator[Check]:
        raise NoValueError("no premise defines it")
        yield

    assert not Control("t", "a", decide("t", (), "", checks)).noticed


# --- coverage of kernel functions -------------------------------------------------------------------------------------

ALIASES = {alias: name for name, row in PUBLIC.items() for alias in row.aliases}


@pytest.mark.smoke
def test_exactly_the_kernel_functions_are_covered() -> None:
    assert set(COVERAGE) == {*PUBLIC, *ALIASES, "singular_angles"}


def test_theorems_exist_and_are_proved() -> None:
    proved = {proof.name for proof in theorems() if proof.proved}
    assert [name for name, row in COVERAGE.items() if not row.theorems or not set(row.theorems) <= proved] == []


ABOUT = {
    "quaternion": {m.q_hat}, "tensor": {m.R}, "pose": {m.Q, m.rho}, "transform_point": {m.R, m.rho, m.point},
    "transform_line": {m.R, m.rho, m.along}, "inverse": {m.R}, "tangent": {m.dcay}, "tangent_inv": {m.dcay_inv},
    "body_tangent": {m.dcay, m.omega_body}, "body_tangent_inv": {m.dcay_inv, m.omega_body}, "twist": {m.dcay, m.omega},
    "body_twist": {m.dcay, m.omega_body}, "rate": {m.dcay_inv, m.omega}, "body_rate": {m.dcay_inv, m.omega_body},
    "tangent_dot": {m.dcay, m.v_dot}, "rate_dot": {m.dcay_inv, m.v_dot}, "twist_jacobian": {m.twist_jacobian},
    "rate_jacobian": {m.rate_jacobian}, "transition": {m.delta, m.rate_jacobian},
    "body_transition": {m.delta, m.body_rate_jacobian}, "cotangent": {m.dcay},
    "from_quaternion": {m.q_hat, m.alpha}, "from_tensor": {m.R, m.alpha}, "from_screw": {m.q_hat, m.alpha},
    "to_screw": {m.R, m.alpha}, "shadow": {m.R_k},
    "shadow_jacobian": {m.R_k}, "principal": {m.R_k}, "compose": {m.first, m.second}, "between": {m.first, m.second},
    "compose_jacobians": {m.omega_1, m.omega_2}, "retract": {m.first, m.second}, "singular_angles": {m.dcay},
}  # fmt: skip
"""Symbols that the theorems cited for a function must contain."""


def test_cited_theorems_mention_the_operator() -> None:
    spoken = {proof.name: set().union(*(equation.symbols for equation in proof.claim)) for proof in theorems()}
    for name, symbols in ABOUT.items():
        assert any(spoken[theorem] >= symbols for theorem in COVERAGE[name].theorems), name


def test_validation_column_matches_the_table() -> None:
    """Compare the column with the signature table, which marks expected values as exact or not."""
    for name, coverage in COVERAGE.items():
        row = PUBLIC.get(ALIASES.get(name, name))
        if row is None:
            assert coverage.validation == "text", name
        else:
            assert coverage.validation == ("exact" if row.exact else "50 digits"), name
            assert row.exact or coverage.only_validated, name
