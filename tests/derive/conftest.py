"""Fixtures for tests of the toolkit."""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, settings

from derive.codegen.targets import TARGETS
from tests.support.altered_maps import mutations, stated  # noqa: F401 (fixtures)
from tests.support.packages import unvalidated

settings.register_profile("untimed", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("untimed")


@pytest.fixture
def without_validation(monkeypatch: pytest.MonkeyPatch) -> None:
    """Write kernels without validation, which takes seconds per module."""
    found = {name: unvalidated(target) for name, target in TARGETS.items()}
    monkeypatch.setattr("derive.codegen.publish.TARGETS", found)
