"""Smoke tests, run by `make quick`: every folder of tests and every package of derive has one."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.support.imports import ROOT

pytestmark = pytest.mark.smoke

TESTS = ROOT / "tests"
MARKED = re.compile(r"^(@|pytestmark = )pytest\.mark\.smoke$", re.MULTILINE)


def without_smoke(folders: list[Path]) -> list[str]:
    """Return the folders in which no test file has the smoke marker."""
    files = {folder: folder.rglob("test_*.py") for folder in folders}
    return [
        str(folder.relative_to(TESTS))
        for folder, found in files.items()
        if not any(MARKED.search(file.read_text(encoding="utf-8")) for file in found)
    ]


def test_every_room_has_a_smoke_test():
    rooms = [TESTS / "derive" / file.parent.name for file in (ROOT / "derive").glob("*/__init__.py")]
    assert len(rooms) > 5
    folders = [folder for folder in TESTS.iterdir() if any(folder.rglob("test_*.py"))]
    assert without_smoke([*rooms, *folders]) == []


def test_room_without_smoke_test_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setitem(globals(), "TESTS", tmp_path)
    for room, text in (("marked", "@pytest.mark.smoke\ndef test(): ..."), ("bare", "# no pytest.mark.smoke here")):
        (tmp_path / room).mkdir()
        (tmp_path / room / "test_it.py").write_text(text)
    assert without_smoke([tmp_path / "marked", tmp_path / "bare", tmp_path / "empty"]) == ["bare", "empty"]
