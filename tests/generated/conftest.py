"""Fixtures of the kernel tests."""

from __future__ import annotations

from types import ModuleType

import pytest

from tests.support.kernels import ORDERS, load


@pytest.fixture(params=ORDERS, ids=lambda n: f"n={n}")
def order(request: pytest.FixtureRequest) -> int:
    """Every committed order in turn."""
    return int(request.param)


@pytest.fixture
def kernel(order: int) -> ModuleType:
    """The kernel module of `order`."""
    return load(order)
