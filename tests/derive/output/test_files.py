"""Writing of files, all or none; comparison of whole folders."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from derive.output import RefusedError, files

pytestmark = pytest.mark.smoke

OURS = "# python -m derive generate -n 1 --target numpy\nx = 1\n"


def test_only_changed_files_are_written(tmp_path: Path):
    assert [p.name for p in files.write(tmp_path / "new" / "folder", {"a.py": OURS, "b.py": OURS})] == ["a.py", "b.py"]
    changed = files.write(tmp_path / "new" / "folder", {"a.py": OURS, "b.py": OURS + "y = 2\n"})
    assert [p.name for p in changed] == ["b.py"]
    assert sorted(p.name for p in (tmp_path / "new" / "folder").iterdir()) == ["a.py", "b.py"]


def test_file_without_header_is_refused_and_nothing_written(tmp_path: Path):
    (tmp_path / "b.py").write_text("mine = True\n")
    with pytest.raises(RefusedError, match=r"not a generated file, so not overwritten: .*b\.py \(--force overwrites\)"):
        files.write(tmp_path, {"a.py": OURS, "b.py": OURS})
    assert [p.name for p in tmp_path.iterdir()] == ["b.py"]
    files.write(tmp_path, {"a.py": OURS, "b.py": OURS}, force=True)
    assert (tmp_path / "b.py").read_text() == OURS


def test_full_disk_leaves_old_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    files.write(tmp_path, {"a.py": OURS, "b.py": OURS})
    texts = {"a.py": OURS + "new\n", "b.py": OURS + "new\n"}
    write_bytes = Path.write_bytes

    def full(path: Path, content: bytes):
        if path.name == "b.py":
            raise OSError(28, "No space left on device", str(path))
        return write_bytes(path, content)

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(RefusedError, match=r"No space left on device$"):
        files.write(tmp_path, texts)
    assert {p.name: p.read_text() for p in tmp_path.iterdir()} == {"a.py": OURS, "b.py": OURS}


@pytest.mark.parametrize("force", [False, True])
def test_folder_in_place_of_a_file_is_refused_and_vice_versa(tmp_path: Path, force: bool):
    (tmp_path / "b.py").mkdir()
    (tmp_path / "sub").write_text(OURS)
    for name in ("b.py", "sub/c.py"):
        with pytest.raises(RefusedError, match="a file and a folder of one name"):
            files.write(tmp_path, {"a.py": OURS, name: OURS}, force)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["b.py", "sub"]


def test_pipes_and_dangling_links_are_refused_and_not_opened(tmp_path: Path):
    os.mkfifo(tmp_path / "pipe.py")
    (tmp_path / "a.py").symlink_to("nowhere")
    for name in ("pipe.py", "a.py"):
        with pytest.raises(RefusedError, match="not a generated file"):
            files.write(tmp_path, {name: OURS})
    files.write(tmp_path, {"a.py": OURS}, force=True)
    assert not (tmp_path / "a.py").is_symlink()


@pytest.mark.parametrize("place", ["/proc/nowhere", "/proc/self/fd", "/sys/kernel"])
def test_folder_that_takes_no_file_is_refused_before_any_work(place: str):
    """Try folders that refuse root too; permissions would not."""
    if Path(place).parent.is_dir():
        with pytest.raises(RefusedError, match=rf"^cannot write {place}: "):
            files.refuse(Path(place), {"a.py": OURS})


@pytest.mark.parametrize("make", [os.mkfifo, lambda path: path.symlink_to("/dev/null")], ids=["pipe", "device"])
def test_pipe_or_device_is_not_replaced(tmp_path: Path, make):
    make(tmp_path / "a.md")
    with pytest.raises(RefusedError, match=r"not a file, so not replaced: .*a\.md"):
        files.put(tmp_path / "a.md", "text")
    assert not (tmp_path / "a.md").is_file()


@pytest.mark.parametrize("content", ["text\n", b"\xff\x00"])
def test_one_file_is_written_whole_and_only_if_it_changes(tmp_path: Path, content):
    file = tmp_path / "new" / "a.md"
    files.put(file, content)
    first = file.stat()
    files.put(file, content)
    assert (file.stat().st_ino, file.stat().st_mtime_ns) == (first.st_ino, first.st_mtime_ns)
    files.put(file, b"other")
    assert file.stat().st_ino != first.st_ino  # another file took its place
    assert file.read_bytes() == b"other"
    assert [path.name for path in file.parent.iterdir()] == ["a.md"]


def test_link_to_a_folder_is_followed(tmp_path: Path):
    (tmp_path / "real").mkdir()
    (tmp_path / "link").symlink_to("real")
    files.write(tmp_path / "link", {"a.py": OURS, "b.py": OURS})
    assert (tmp_path / "link").is_symlink()
    assert sorted(p.name for p in (tmp_path / "real").iterdir()) == ["a.py", "b.py"]
    assert list(files.compare(tmp_path / "link", {"a.py": OURS, "b.py": OURS})) == []
    (tmp_path / "dangling").symlink_to("nowhere")
    with pytest.raises(RefusedError, match="cannot write"):
        files.write(tmp_path / "dangling", {"a.py": OURS})
    assert not (tmp_path / "nowhere").exists()


@pytest.mark.parametrize("name", ["sub", ".dualcay-staged", ".dualcay-ready", ".dualcay-lock"])
def test_links_within_a_folder_are_not_followed(tmp_path: Path, name: str):
    folder, outside = tmp_path / "kernels", tmp_path / "outside"
    folder.mkdir()
    (outside / "0").mkdir(parents=True)
    (outside / "0" / "mine.py").write_text("mine = True\n")
    for target in (outside, tmp_path / "nowhere"):
        (folder / name).symlink_to(target)
        for force in (False, True):
            with pytest.raises(RefusedError, match="a link within the folder is not followed, remove it first"):
                files.write(folder, {"a.py": OURS, "sub/b.py": OURS}, force)
        assert [path.name for path in folder.iterdir()] == [name]
        (folder / name).unlink()
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["0", "kernels", "mine.py", "outside"]


def test_names_that_differ_in_case_only_are_refused(tmp_path: Path):
    files.write(tmp_path, {"mine.py": OURS, "sub/a.py": OURS})
    for texts in ({"b.py": OURS, "Mine.py": OURS}, {"sub/A.py": OURS}):
        with pytest.raises(RefusedError, match=r"differs in case only: .*/(Mine|A)\.py"):
            files.write(tmp_path, texts, force=True)
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["a.py", "mine.py", "sub"]


def test_a_place_below_a_file_is_refused_before_any_work(tmp_path: Path):
    (tmp_path / "file").write_text("")
    for place in ("file", "file/sub", "file/sub/sub"):
        with pytest.raises(RefusedError, match=r"cannot write .*: .*file is no folder"):
            files.refuse(tmp_path / place, {"a.py": OURS})
    files.refuse(tmp_path / "new" / "folder", {"a.py": OURS})


def test_folder_holds_one_target(tmp_path: Path):
    files.write(tmp_path, {"a.py": OURS})
    (tmp_path / "mine.py").write_text("mine = True\n")
    other = {"a.h": "// python -m derive generate -n 1 --target c\n"}
    for force in (False, True):
        with pytest.raises(RefusedError, match=r"holds kernels of the target numpy \(a\.py\).*those of c into another"):
            files.write(tmp_path, other, force)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.py", "mine.py"]
    (tmp_path / "a.py").unlink()
    files.write(tmp_path, other)
    with pytest.raises(RefusedError, match=r"holds kernels of the target c \(a\.h\).*those of numpy into another"):
        files.write(tmp_path, {"a.py": OURS})
    files.write(tmp_path, {"report.md": "# no kernel, so of no target\n"})


def test_comparison_finds_stale_missing_and_foreign(tmp_path: Path):
    files.write(tmp_path, {"a.py": OURS, "same.py": OURS})
    (tmp_path / "notes.txt").write_text("not ours")
    found = list(files.compare(tmp_path, {"a.py": OURS + "y = 2\n", "b.py": OURS, "same.py": OURS}))
    assert [(d.path.name, d.kind) for d in found] == [("a.py", "stale"), ("b.py", "missing"), ("notes.txt", "foreign")]
    assert "+y = 2" in found[0].diff


def test_comparison_finds_forged_headers_folders_and_leftovers(tmp_path: Path):
    texts = {"a.py": OURS, "sub/b.py": OURS}
    files.write(tmp_path, texts)
    (tmp_path / "__pycache__").mkdir()
    (tmp_path / "sub" / "__pycache__").mkdir()
    assert list(files.compare(tmp_path, texts)) == []
    (tmp_path / "forged.py").write_text(OURS)
    (tmp_path / "capped.py").write_text(OURS)
    (tmp_path / "further").mkdir()
    (tmp_path / "sub" / "c.py").write_text("")
    (tmp_path / "a.so").symlink_to("nowhere")
    (tmp_path / ".dualcay-staged").mkdir()
    found = list(files.compare(tmp_path, texts, {"capped.py": "too large"}))
    assert [(d.path.relative_to(tmp_path).as_posix(), d.kind, d.reason.split(":")[0]) for d in found] == [
        (".dualcay-staged", "unfinished", "a run is writing here, or was killed"),
        ("a.so", "foreign", ""),
        ("capped.py", "foreign", "too large"),
        ("forged.py", "foreign", "not made by what its first line says"),
        ("further", "foreign", ""),
        ("sub/c.py", "foreign", ""),
    ]


def test_comparison_ignores_caches_of_python_only(tmp_path: Path):
    files.write(tmp_path, {"a.py": OURS, "sub/b.py": OURS})
    (tmp_path / "__pycache__").mkdir()
    (tmp_path / "__pycache__2").mkdir()
    (tmp_path / "sub" / "__pycache__").write_text("")
    found = [(d.path.name, d.kind) for d in files.compare(tmp_path, {"a.py": OURS, "sub/b.py": OURS})]
    assert found == [("__pycache__2", "foreign"), ("__pycache__", "foreign")]


def test_folder_in_place_of_a_file_is_missing(tmp_path: Path):
    (tmp_path / "a.py").mkdir()
    assert [d.kind for d in files.compare(tmp_path, {"a.py": OURS})] == ["missing"]


def test_header_is_a_comment_with_the_command(tmp_path: Path):
    for text, command in [
        (OURS, "python -m derive generate -n 1 --target numpy"),
        ("// python -m derive generate -n 2 --target c\n", "python -m derive generate -n 2 --target c"),
        ("function f(v)\n%F  Help\n\n% python -m derive generate -n 2\n%#codegen\n", "python -m derive generate -n 2"),
        ("% List\n%   f - Help\n\n% python -m derive generate -n 2\n", "python -m derive generate -n 2"),
        ("function f(v)\n%F  Help\n\nx = v;\n% python -m derive generate -n 2\n", None),
        ("x = 'python -m derive generate'\n", None),
        ("", None),
    ]:
        (tmp_path / "f").write_text(text)
        assert files.header_command(tmp_path / "f") == command
    (tmp_path / "f").write_bytes(b"\xff\xfe")
    assert files.header_command(tmp_path / "f") is None
