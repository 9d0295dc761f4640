"""Exchange of files: a kill at any step leaves old files, new files or a notice; the next run repairs the folder."""

from __future__ import annotations

import itertools
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from derive.output import RefusedError, compare, write
from derive.output.files import LEFTOVERS
from tests.support.staying import until

ROOT = Path(__file__).parents[3]
HEAD = "# python -m derive generate -n 1 --target numpy\n"
NOTICE = {"__init__.py": HEAD + "raise ImportError\n"}
OTHER = {"other.py": HEAD}
MINE = {"mine.txt": "mine"}


def texts(version: str, entry: str) -> dict[str, str]:
    return {"__init__.py": HEAD + entry, "a.py": HEAD + version, "sub/b.py": HEAD + version, "same.py": HEAD}


OLD = texts("old", "entry")
NEWS = [texts("new", "entry"), texts("new", "new entry")]


def folder_with(path: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        (path / name).parent.mkdir(parents=True, exist_ok=True)
        (path / name).write_text(text)
    return path


def held(folder: Path) -> dict[str, str]:
    """Return the texts of a folder by file name, leftovers of a killed run excluded."""
    names = (path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())
    return {name: (folder / name).read_text() for name in names if name.split("/")[0] not in LEFTOVERS}


def leftovers(folder: Path) -> set[str]:
    return LEFTOVERS & set(os.listdir(folder))


def run(*command: object, **options: object) -> subprocess.Popen[str]:
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    return subprocess.Popen([sys.executable, *map(str, command)], env=env, text=True, **options)


def waiting(process: subprocess.Popen[str]) -> bool:
    """Tell whether a process waits for a lock, as Linux lists it."""
    lines = (line.split() for line in Path("/proc/locks").read_text().splitlines())
    return any(line[1] == "->" and line[5] == str(process.pid) for line in lines)


def killed_runs(new: dict[str, str], folders: list[Path], root: Path) -> list[list[Path]]:
    """Return copies of each folder after runs killed at step 0, 1, 2, ...; the last run is complete."""
    roots = [root / str(n) for n in range(len(folders))]
    pairs = itertools.chain(*zip(folders, roots, strict=True))
    assert run(ROOT / "tests" / "support" / "killed.py", json.dumps(new), json.dumps(NOTICE), *pairs).wait() == 0
    return [sorted(each.iterdir(), key=lambda path: int(path.name)) for each in roots]


def state(folder: Path, old: dict[str, str], new: dict[str, str]) -> str:
    found = held(folder)
    if found.get("__init__.py") == NOTICE["__init__.py"]:
        assert {d.path.name for d in compare(folder, new)} >= {"__init__.py"}
        return "notice"
    assert found in (old | MINE, new | MINE)
    return "old" if found == old | MINE else "new"


@pytest.mark.parametrize(
    ("old", "new"), [pytest.param({}, NEWS[0], marks=pytest.mark.thorough), (OLD, NEWS[1])], ids=["first", "new entry"]
)
def test_kill_leaves_old_or_new_files(tmp_path, old, new):
    (folders,) = killed_runs(new, [folder_with(tmp_path / "old", old | MINE)], tmp_path / "once")
    states = [state(folder, old, new) for folder in folders]
    assert [key for key, _ in itertools.groupby(states)] == ["old", "notice", "new"]  # no other order
    changed = {name for name in new if old.get(name) != new[name]} - {"__init__.py"}
    assert states.count("notice") >= len(changed) + 1
    halves = [folder for folder, found in zip(folders, states, strict=True) if found == "notice"]
    for again in killed_runs(new, halves, tmp_path / "twice"):  # the repairing run is killed too
        states_again = [state(folder, old, new) for folder in again]
        assert [key for key, _ in itertools.groupby(states_again)] == ["notice", "new"]
    for folder, found in zip(folders, states, strict=True):
        write(folder, OTHER)  # any later run repairs the folder
        mended = held(folder)
        assert mended == new | OTHER | MINE or (found == "old" and mended == old | OTHER | MINE)
        assert not leftovers(folder)
        write(folder, new, notices=NOTICE)
        assert held(folder) == new | OTHER | MINE


def test_failure_between_moves_is_reported_as_half_written(tmp_path, monkeypatch):
    folder, replace = folder_with(tmp_path, OLD), os.replace

    def fails(source: Path, target: Path) -> None:
        if target.name == "b.py":
            raise PermissionError(13, "Permission denied", str(target))
        replace(source, target)

    monkeypatch.setattr(os, "replace", fails)
    with pytest.raises(RefusedError, match=r"b\.py: Permission denied; half-written until the command runs again$"):
        write(folder, NEWS[0], notices=NOTICE)
    assert state(folder, OLD, NEWS[0]) == "notice"
    monkeypatch.undo()
    write(folder, NEWS[0], notices=NOTICE)
    assert held(folder) == NEWS[0]


HOLD = """
import sys, time, pathlib
from derive.output.files import locked
with locked(pathlib.Path(sys.argv[1])):
    print("held", flush=True)
    time.sleep(600)
"""
WRITE = """
import json, sys, pathlib
from derive.output import write
write(pathlib.Path(sys.argv[1]), json.loads(sys.argv[2]), notices=json.loads(sys.argv[3]))
"""


@pytest.mark.skipif(not Path("/proc/locks").exists(), reason="needs the list of locks of Linux")
def test_run_waits_for_a_living_writer_only(tmp_path):
    folder = folder_with(tmp_path / "real", OLD)
    (tmp_path / "link").symlink_to("real")
    holds = run("-c", HOLD, folder, stdout=subprocess.PIPE)
    assert holds.stdout.readline() == "held\n"
    waits = run("-c", WRITE, tmp_path / "link", json.dumps(NEWS[0]), json.dumps(NOTICE))
    until(lambda: waits.poll() is not None or waiting(waits))
    assert waits.poll() is None
    assert held(folder) == OLD
    holds.kill()
    holds.communicate()
    assert waits.wait() == 0
    assert held(folder) == NEWS[0]
    assert not leftovers(folder)


@pytest.mark.skipif(not Path("/proc/locks").exists(), reason="needs the list of locks of Linux")
def test_files_that_appear_during_a_wait_are_checked(tmp_path):
    holds = run("-c", HOLD, tmp_path, stdout=subprocess.PIPE)
    assert holds.stdout.readline() == "held\n"
    header = {"a.h": "// python -m derive generate -n 1 --target c\n"}
    waits = run("-c", WRITE, tmp_path, json.dumps(header), "{}", stderr=subprocess.PIPE)
    until(lambda: waits.poll() is not None or waiting(waits))
    assert waits.poll() is None
    folder_with(tmp_path, OTHER)
    holds.kill()
    holds.communicate()
    assert "a folder holds those of one" in waits.communicate()[1]
    assert held(tmp_path) == OTHER


MANY = """
import sys, pathlib
from derive.output import write
from derive.output.files import locked
folder, own = pathlib.Path(sys.argv[1]), sys.argv[2]
for n in range(20):
    texts = {f"{i}.py": f"# python -m derive generate\\n{own} {n}\\n" for i in range(8)}
    write(folder, texts, notices={"0.py": "# python -m derive generate\\n"})
    with locked(folder):
        found = {(folder / name).read_text() for name in texts}
        assert len(found) == 1, found
"""


def test_concurrent_runs_do_not_mix(tmp_path):
    runs = [run("-c", MANY, tmp_path, own) for own in ("one", "two", "three")]
    assert [each.wait() for each in runs] == [0, 0, 0]
    assert not leftovers(tmp_path)
