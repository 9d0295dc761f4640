"""Working precision of the tests of this folder."""

from __future__ import annotations

import pytest


@pytest.fixture(autouse=True)
def _of_fifty_digits(fifty_digits: None) -> None:
    """Work with 50 digits in every test of this folder."""
