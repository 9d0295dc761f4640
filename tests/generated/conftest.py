"""Fixtures of the kernel tests."""

from __future__ import annotations

import importlib
from types import ModuleType

import pytest

from tests.support.kernels import LAWS, load, orders

order = orders(LAWS)


@pytest.fixture
def kernel(order: int) -> ModuleType:
    """Return the kernel module of `order`."""
    return load(order)


@pytest.fixture
def kernels(name: str) -> ModuleType:
    """Return the kernel module of a chart's `name`."""
    return importlib.import_module(f"dualcay.{name}")
