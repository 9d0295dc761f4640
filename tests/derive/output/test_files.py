"""Files are written whole, all or none, and compared as a set."""

from __future__ import annotations

from pathlib import Path

import pytest

from derive.output import RefusedError, files

OURS = "# python -m derive generate -n 1 --target numpy\nx = 1\n"


def test_only_changed_files_are_written(tmp_path: Path):
    assert [p.name for p in files.write(tmp_path / "new" / "folder", {"a.py": OURS, "b.py": OURS})] == ["a.py", "b.py"]
    changed = files.write(tmp_path / "new" / "folder", {"a.py": OURS, "b.py": OURS + "y = 2\n"})
    assert [p.name for p in changed] == ["b.py"]
    assert sorted(p.name for p in (tmp_path / "new" / "folder").iterdir()) == ["a.py", "b.py"]


def test_a_file_without_our_header_is_refused_and_nothing_else_is_written(tmp_path: Path):
    (tmp_path / "b.py").write_text("mine = True\n")
    with pytest.raises(RefusedError, match=r"not a generated file, so not overwritten: .*b\.py \(--force overwrites\)"):
        files.write(tmp_path, {"a.py": OURS, "b.py": OURS})
    assert [p.name for p in tmp_path.iterdir()] == ["b.py"]
    files.write(tmp_path, {"a.py": OURS, "b.py": OURS}, force=True)
    assert (tmp_path / "b.py").read_text() == OURS


def test_a_failure_half_way_leaves_the_old_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    files.write(tmp_path, {"a.py": OURS, "b.py": OURS})
    texts = {"a.py": OURS + "new\n", "b.py": OURS + "new\n"}

    def full(descriptor: int, *args: object, **kwargs: object):
        raise OSError(28, "No space left on device", str(tmp_path))

    monkeypatch.setattr(files.os, "fdopen", full)
    with pytest.raises(RefusedError, match="No space left"):
        files.write(tmp_path, texts)
    assert {p.name: p.read_text() for p in tmp_path.iterdir()} == {"a.py": OURS, "b.py": OURS}


def test_a_folder_that_is_a_file_is_refused(tmp_path: Path):
    (tmp_path / "file").write_text("")
    with pytest.raises(RefusedError, match="cannot write"):
        files.write(tmp_path / "file", {"a.py": OURS})


def test_comparison_finds_stale_missing_and_foreign(tmp_path: Path):
    files.write(tmp_path, {"a.py": OURS, "same.py": OURS})
    (tmp_path / "notes.txt").write_text("not ours")
    found = list(files.compare(tmp_path, {"a.py": OURS + "y = 2\n", "b.py": OURS, "same.py": OURS}))
    assert [(d.path.name, d.kind) for d in found] == [("a.py", "stale"), ("b.py", "missing"), ("notes.txt", "foreign")]
    assert "+y = 2" in found[0].diff


def test_a_header_is_a_comment_with_the_command(tmp_path: Path):
    for text, command in [
        (OURS, "python -m derive generate -n 1 --target numpy"),
        ("// python -m derive generate -n 2 --target c\n", "python -m derive generate -n 2 --target c"),
        ("x = 'python -m derive generate'\n", None),
        ("", None),
    ]:
        (tmp_path / "f").write_text(text)
        assert files.header_command(tmp_path / "f") == command
    (tmp_path / "f").write_bytes(b"\xff\xfe")
    assert files.header_command(tmp_path / "f") is None
