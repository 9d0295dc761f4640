"""Fixtures for tests of the toolkit."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from derive.claims.report import FORMATS, Report
from derive.codegen.targets import TARGETS
from derive.papers import PAPERS, verify
from tests.support.altered_maps import mutations, stated  # noqa: F401 (fixtures)
from tests.support.packages import unvalidated

settings.register_profile("untimed", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("untimed")


@pytest.fixture
def without_validation(monkeypatch: pytest.MonkeyPatch) -> None:
    """Write kernels without validation, which takes seconds per module."""
    found = {name: unvalidated(target) for name, target in TARGETS.items()}
    monkeypatch.setattr("derive.codegen.build.TARGETS", found)


@pytest.fixture(scope="session")
def karakilic(shared: Callable[[str, Callable[[Path], object]], Path]) -> Path:
    """Folder of K10's reports ``errata.json`` and ``errata.html``, decided once for all processes."""

    def write(folder: Path) -> None:
        report = Report.of(PAPERS, verify("karakilic-2010"), [])
        for form in ("json", "html"):
            (folder / f"errata.{form}").write_text(FORMATS[form](report), encoding="utf-8")

    return shared("karakilic", write)
