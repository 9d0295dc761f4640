"""``import derive``: from an installation, also with another distribution's files in the same folder."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import derive
from tests.support.imports import ROOT, sources


def installed(folder: Path) -> Path:
    """Return an installed folder of the toolkit, with empty subpackages."""
    place = folder / "derive"
    for name in derive._OWN:
        if name.endswith(".py"):
            place.mkdir(exist_ok=True)
            shutil.copy(ROOT / "derive" / name, place)
        else:
            (place / name).mkdir(parents=True)
            (place / name / "__init__.py").touch()
    (place / "_templates").mkdir()
    (place / "left_by_an_editor~").touch()
    (place / "left_by_git" / "__pycache__").mkdir(parents=True)
    return place


def imported(folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-c", "import derive"], cwd=folder, capture_output=True, text=True)


def test_own_modules_are_listed() -> None:
    rooms = {name[0] for name, _ in sources("derive") if len(name) > 1}
    files = {f"{name[0] if name else '__init__'}.py" for name, _ in sources("derive") if len(name) <= 1}
    files -= {f"{room}.py" for room in rooms}
    assert {room for room in rooms if (ROOT / "derive" / room / "__init__.py").exists()} <= derive._OWN
    assert {name for name in files if (ROOT / "derive" / name).exists()} <= derive._OWN
    assert all((ROOT / "derive" / name).exists() for name in derive._OWN)


@pytest.mark.parametrize("foreign", ["config.py", "trace/__init__.py"])
def test_files_of_another_distribution_are_named(tmp_path: Path, foreign: str) -> None:
    place = installed(tmp_path)
    assert imported(tmp_path).returncode == 0, imported(tmp_path).stderr
    (place / foreign).parent.mkdir(exist_ok=True)
    (place / foreign).touch()
    done = imported(tmp_path)
    last = done.stderr.splitlines()[-1]
    assert last.startswith(f"ImportError: {place} holds files of another distribution ({foreign.partition('/')[0]})")
    assert "cannot be installed together" in last
    assert "pip uninstall derive" in last
