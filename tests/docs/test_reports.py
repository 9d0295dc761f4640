"""Reports of measurements: each begins with the introduction that its command writes."""

from __future__ import annotations

import pytest

from benchmarks import page as speed
from benchmarks.accuracy import report as accuracy
from tests.support import pages


@pytest.mark.parametrize(
    ("name", "introduction"), [("accuracy", accuracy.INTRODUCTION), ("benchmarks", speed.INTRODUCTION)]
)
def test_page_begins_with_its_introduction(name: str, introduction: str) -> None:
    assert (pages.ROOT / "docs" / f"{name}.md").read_text(encoding="utf-8").startswith(introduction)
