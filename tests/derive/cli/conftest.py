"""Fixture of the tests of commands: in the test process, kernels are written without validation."""

from __future__ import annotations

import pytest


@pytest.fixture(autouse=True)
def _printed_only(without_validation: None) -> None:
    """Skip validation in every test of this folder."""
