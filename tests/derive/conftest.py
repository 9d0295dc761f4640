"""Fixtures for tests of the toolkit."""

from __future__ import annotations

import pytest

from derive.codegen.targets import TARGETS
from tests.support.altered_maps import mutations, stated  # noqa: F401 (fixtures)
from tests.support.packages import unvalidated


@pytest.fixture
def without_validation(monkeypatch: pytest.MonkeyPatch) -> None:
    """Write kernels without validation, which takes seconds per module."""
    found = {name: unvalidated(target) for name, target in TARGETS.items()}
    monkeypatch.setattr("derive.codegen.publish.TARGETS", found)
