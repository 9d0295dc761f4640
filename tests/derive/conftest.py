"""Roads that lead to the same texts sooner."""

from __future__ import annotations

import pytest

from derive.codegen.targets import TARGETS
from tests.support.packages import unvalidated


@pytest.fixture
def without_validation(monkeypatch: pytest.MonkeyPatch) -> None:
    """Kernels are written as they are printed: to look at them takes seconds a module."""
    found = {name: unvalidated(target) for name, target in TARGETS.items()}
    monkeypatch.setattr("derive.codegen.publish.TARGETS", found)
