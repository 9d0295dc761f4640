"""Commands run in this process write kernels without validating them; commands in processes validate."""

from __future__ import annotations

import pytest


@pytest.fixture(autouse=True)
def _printed_only(without_validation: None) -> None:
    """Skip validation in every test of this folder."""
