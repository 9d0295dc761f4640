"""Temporary folders: those of killed processes go, those of living ones stay."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from derive.workers import PREFIX, scratch
from tests.support.command import ROOT

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no locks of folders")

HOLD = """
import time
from derive.workers import scratch
with scratch() as folder:
    (folder / "file").touch()
    print("held", flush=True)
    time.sleep(600)
"""


@pytest.fixture
def temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Provide the folder of temporary folders, also for other processes."""
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr(tempfile, "tempdir", None)
    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    return tmp_path


def test_folder_of_a_process_stays_while_it_lives_and_goes_when_it_was_killed(temporary: Path) -> None:
    (temporary / f"{PREFIX}link").symlink_to(ROOT)
    (temporary / "dualcay-mine").mkdir()
    others = {f"{PREFIX}link", "dualcay-mine"}
    command = [sys.executable, "-c", HOLD]
    first, second = (subprocess.Popen(command, stdout=subprocess.PIPE, text=True) for _ in range(2))
    for process in (first, second):
        assert process.stdout is not None
        assert process.stdout.readline() == "held\n"
    with scratch() as own:
        assert len(list(temporary.iterdir())) == 5
        first.kill()
        first.communicate()
        with scratch():
            assert len(list(temporary.iterdir())) == 5
        assert list(own.iterdir()) == []
    second.kill()
    second.communicate()
    with scratch():
        pass
    assert {path.name for path in temporary.iterdir()} == others
