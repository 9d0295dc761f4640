"""Commands in the test process write kernels without validation; commands in other processes validate."""

from __future__ import annotations

import pytest


@pytest.fixture(autouse=True)
def _printed_only(without_validation: None) -> None:
    """Skip validation in every test of this folder."""
