"""Reports shared by several tests."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from derive.papers import PAPERS, verify
from derive.papers.report import FORMATS, Report


@pytest.fixture(scope="session")
def karakilic(shared: Callable[[str, Callable[[Path], object]], Path]) -> Path:
    """Folder of K10's reports ``errata.json`` and ``errata.html``, decided once for all processes."""

    def write(folder: Path) -> None:
        report = Report.of(PAPERS, verify("karakilic-2010"), [])
        for form in ("json", "html"):
            (folder / f"errata.{form}").write_text(FORMATS[form](report), encoding="utf-8")

    return shared("karakilic", write)
