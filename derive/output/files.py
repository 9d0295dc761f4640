"""Write generated files to disk, all or none, or compare them with the files on disk.

A process killed at any moment leaves the old files, the new files, or a notice. All new files are staged first. One
rename marks them ready; then they move to their places one by one. After a kill, the next run that finds ready files
moves the rest. Meanwhile a notice replaces the file that a user of the folder reads first. A loss of power may do harm.
"""

from __future__ import annotations

import difflib
import io
import os
import re
import shutil
import sys
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

STAGED, READY, LOCK = ".dualcay-staged", ".dualcay-ready", ".dualcay-lock"
LEFTOVERS = frozenset({STAGED, READY, LOCK})
"""Names that a killed process can leave in a folder, until the next process writes there."""


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Wait until no other process holds the folder, then hold it; Windows has no such lock."""
    if sys.platform == "win32":
        yield
        return
    import fcntl

    path = folder / LOCK
    while True:
        handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o644)
        fcntl.flock(handle, fcntl.LOCK_EX)
        if os.fstat(handle).st_nlink:
            break
        os.close(handle)  # the previous holder removed this file: wait for the new one
    try:
        yield
    finally:
        path.unlink(missing_ok=True)
        os.close(handle)


def encoded(content: str | bytes) -> bytes:
    return content.encode("utf-8") if isinstance(content, str) else content


def exchange(folder: Path, texts: Mapping[str, str | bytes], notices: Mapping[str, str]) -> None:
    """Replace files of a locked folder; ``notices`` are temporary texts of some files until all others are in place."""
    body = {name: text for name, text in texts.items() if name not in notices}
    staged = folder / STAGED
    try:
        for step, files in enumerate((notices, body, {name: texts[name] for name in notices})):
            for name, text in files.items():
                path = staged / str(step) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(encoded(text))
        staged.rename(folder / READY)
    except BaseException:
        shutil.rmtree(staged, ignore_errors=True)
        raise
    finish(folder)


def finish(folder: Path) -> None:
    """Move ready files to their places in a locked folder, and delete staged files."""
    if (folder / STAGED).exists():
        shutil.rmtree(folder / STAGED)
    ready = folder / READY
    if not ready.exists():
        return
    for step in sorted(ready.iterdir()):
        for path in sorted(path for path in step.rglob("*") if path.is_file()):
            place = folder / path.relative_to(step)
            place.parent.mkdir(parents=True, exist_ok=True)
            os.replace(path, place)
    shutil.rmtree(ready)


HELP = r"(?:(?:function .*\n)?(?:%.*\n)+\n)?"
MARK = re.compile(HELP + r'(?:\S{1,2} |\{"made by": ")(python -m derive generate\b.*?)(?:",)?$', re.MULTILINE)
"""First line of every generated file: a comment with the command that makes it, or the first member of JSON.

In files of MATLAB the help text, which must come first, stands before it.
"""
HEAD_LETTERS = 20_000  # length of the text in which the command is looked for


class RefusedError(Exception):
    """Error of a refused write: an existing file is not generated, or a folder cannot be written."""


@dataclass(frozen=True, slots=True)
class Difference:
    """File that differs from the generated one: stale, missing, foreign, or unfinished (left by a killed run)."""

    path: Path
    kind: str
    diff: str = ""
    reason: str = ""


def header_command(path: Path) -> str | None:
    """Return the command that a generated file bears; None for any other file."""
    try:
        if not path.is_file():  # opening a pipe would wait for its writer
            return None
        with path.open(encoding="utf-8") as file:
            return _command(file.read(HEAD_LETTERS))
    except (OSError, UnicodeDecodeError):
        return None


def _command(text: str) -> str | None:
    return found[1] if (found := MARK.match(text)) else None


def _target(command: str | None) -> str | None:
    return found[1] if (found := re.search(r" --target (\S+)", command or "")) else None


def _bytes(path: Path) -> bytes | None:
    try:
        return path.read_bytes()
    except (FileNotFoundError, NotADirectoryError, IsADirectoryError):
        return None


def _read(path: Path) -> str | None:
    found = _bytes(path)
    try:
        return None if found is None else found.decode("utf-8")
    except UnicodeDecodeError:
        return None


def put(file: Path, content: str | bytes) -> None:
    """Write a file whole: a process killed at any moment leaves the old one or the new one."""
    write(file.parent, {file.name: content}, force=True)


def put_picture(file: Path, figure: Any) -> None:
    """Write a picture of Matplotlib whole, without date and version, so that equal data give equal bytes."""
    drawn, form = io.BytesIO(), file.suffix[1:].lower()
    figure.savefig(drawn, format=form, metadata={"Date": None, "Creator": None} if form == "svg" else None)
    put(file, drawn.getvalue())


def write(
    folder: Path, texts: Mapping[str, str | bytes], force: bool = False, notices: Mapping[str, str] | None = None
) -> list[Path]:
    """Write files into a folder, all or none, and return the changed ones; other files stay.

    A run waits for any other run in the same folder, and finishes the work of a killed run. The folder is made if
    missing; a symbolic link is followed. ``notices`` are temporary texts of some files while the others are replaced.
    Without notices, a kill may leave some files old and some new. Raise `RefusedError` if `refuse` does, or if the
    folder cannot be written.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        _refuse_links(folder, texts)
        with locked(folder):
            finish(folder)
            refuse(folder, texts, force)
            changed = [name for name, text in texts.items() if _bytes(folder / name) != encoded(text)]
            if changed:
                names = dict.fromkeys((*changed, *(notices or ())))
                exchange(folder, {name: texts[name] for name in names}, notices or {})
    except OSError as error:
        left = "; half-written until the command runs again" if os.path.exists(folder / READY) else ""
        raise RefusedError(f"cannot write {error.filename or folder}: {error.strerror or error}{left}") from error
    return [folder / name for name in changed]


def refuse(folder: Path, texts: Mapping[str, str | bytes], force: bool = False) -> None:
    """Raise RefusedError if files may not, or cannot, be written into a folder.

    A file in the way must be a generated one, unless forced. No folder or device may be in the way, and no folder
    within may be a link. No name may differ from one that is there in case only. The folder may not contain kernels of
    another target.
    """
    if not folder.is_dir():
        if file := not_a_folder(folder):
            raise RefusedError(f"cannot write {folder}: {file} is no folder")
        _try(folder)
        return
    _try(folder)
    _refuse_links(folder, texts)
    paths = [folder / name for name in texts]
    parents = _folders(folder, texts) | {folder}
    there = {_folded(path): path.name for parent in parents if parent.is_dir() for path in parent.iterdir()}
    if alike := [path for path in paths if there.get(_folded(path), path.name) != path.name]:
        raise RefusedError(f"a file there has a name that differs in case only: {', '.join(map(str, alike))}")
    blocked = [path for path in paths if path.is_dir() and not path.is_symlink()]
    blocked += sorted(path for path in parents if os.path.lexists(path) and not path.is_dir())
    if blocked:
        raise RefusedError(f"a file and a folder of one name, remove it first: {', '.join(map(str, blocked))}")
    foreign = [path for path in paths if os.path.lexists(path) and header_command(path) is None]
    if foreign and not force:
        names = ", ".join(map(str, foreign))
        raise RefusedError(f"not a generated file, so not overwritten: {names} (--force overwrites)")
    if devices := [path for path in paths if path.exists() and not path.is_file()]:
        raise RefusedError(f"not a file, so not replaced: {', '.join(map(str, devices))}")
    given = {target for text in texts.values() if isinstance(text, str) and (target := _target(_command(text)))}
    for path in sorted(folder.iterdir()) if given else ():
        found = _target(header_command(path))
        if found and found not in given:
            raise RefusedError(
                f"{folder} holds kernels of the target {found} ({path.name}), and a folder holds those of one: "
                f"write those of {', '.join(sorted(given))} into another (-o), or remove the others first"
            )


def _try(folder: Path) -> None:
    """Make a file for a moment in a folder, or in the nearest one above; raise RefusedError if that fails."""
    there = next(part for part in (folder, *folder.absolute().parents) if part.is_dir())
    try:
        tempfile.TemporaryFile(dir=there).close()
    except OSError as error:
        raise RefusedError(f"cannot write {folder}: {there}: {error.strerror}") from error


def not_a_folder(path: Path) -> Path | None:
    """Return the part of a path that exists and is no folder, so that nothing can be written below it."""
    found = next((part for part in (path, *path.parents) if os.path.lexists(part)), path)
    return None if found.is_dir() or not os.path.lexists(found) else found


def _folded(path: Path) -> Path:
    """Return a path whose last name has no capitals, as some file systems ignore case."""
    return path.with_name(path.name.lower())


def _folders(folder: Path, texts: Mapping[str, str | bytes]) -> set[Path]:
    return {folder / parent for name in texts for parent in PurePosixPath(name).parents} - {folder}


def _refuse_links(folder: Path, texts: Mapping[str, str | bytes]) -> None:
    """Raise RefusedError if a link would lead out of a folder."""
    within = _folders(folder, texts) | {folder / name for name in LEFTOVERS}
    if links := sorted(path for path in within if path.is_symlink()):
        raise RefusedError(f"a link within the folder is not followed, remove it first: {', '.join(map(str, links))}")


def compare(folder: Path, texts: Mapping[str, str], unmade: Mapping[str, str] | None = None) -> Iterator[Difference]:
    """Yield the differences between a folder and texts; any other file is foreign, except caches of Python.

    ``unmade`` gives the reason for each file without a text, by name.
    """
    for name, text in texts.items():
        path = folder / name
        found = _read(path)
        if found is None:
            yield Difference(path, "missing")
        elif found != text:
            old, new = found.splitlines(keepends=True), text.splitlines(keepends=True)
            lines = difflib.unified_diff(old, new, f"{path} (on disk)", f"{path} (generated)")
            yield Difference(path, "stale", "".join(lines))
    files = {folder / name for name in texts}
    folders = _folders(folder, texts) | {folder}
    reasons = {folder / name: reason for name, reason in (unmade or {}).items()}
    for parent in sorted(folders):
        if parent.is_dir():
            yield from _extra(parent, files | folders, reasons)


def _extra(folder: Path, known: set[Path], reasons: Mapping[Path, str]) -> Iterator[Difference]:
    for path in sorted(folder.iterdir()):
        if path.name in LEFTOVERS:
            yield Difference(path, "unfinished", reason="a run is writing here, or was killed: the next one finishes")
        elif path not in known and not (path.name == "__pycache__" and path.is_dir()):
            command = header_command(path)
            claim = f"not made by what its first line says: {command}" if command else ""
            reason = next((why for place, why in reasons.items() if place.is_relative_to(path)), claim)
            yield Difference(path, "foreign", reason=reason)
