"""What the command prints is tested here, not whether kernels are right (commands in processes see to it)."""

from __future__ import annotations

import pytest


@pytest.fixture(autouse=True)
def _printed_only(without_validation: None) -> None:
    """For every test of this room."""
