"""Put generated texts on disk, all or none, or compare them with what is there."""

from __future__ import annotations

import difflib
import os
import re
import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

MARK = re.compile(r"\S{1,2} (python -m derive generate\b.*)")
"""The first line of every generated file: a comment with the command that makes it."""


class RefusedError(Exception):
    """A file in the way does not bear the generated header, or a folder cannot be written."""


@dataclass(frozen=True, slots=True)
class Difference:
    """A file that is not what the generator would write; ``kind`` is stale, missing or foreign."""

    path: Path
    kind: str
    diff: str = ""


def header_command(path: Path) -> str | None:
    """The command in the first line of a generated file; None for any other file."""
    try:
        with path.open(encoding="utf-8") as file:
            found = MARK.match(file.readline())
    except (OSError, UnicodeDecodeError):
        return None
    return found.group(1) if found else None


def write(folder: Path, texts: Mapping[str, str], force: bool = False) -> list[Path]:
    """Write files into a folder, each whole and all or none; returns those whose text changed.

    Raises
    ------
    RefusedError
        If a file in the way is not a generated one (unless forced), or the folder cannot be written.
    """
    targets = {folder / name: text for name, text in texts.items()}
    foreign = [path for path in targets if path.exists() and header_command(path) is None]
    if foreign and not force:
        names = ", ".join(map(str, foreign))
        raise RefusedError(f"not a generated file, so not overwritten: {names} (--force overwrites)")
    try:
        folder.mkdir(parents=True, exist_ok=True)
        changed = [path for path, text in targets.items() if _read(path) != text]
        _replace_all({path: targets[path] for path in changed})
    except OSError as error:
        raise RefusedError(f"cannot write {error.filename or folder}: {error.strerror}") from error
    return changed


def _replace_all(texts: Mapping[Path, str]) -> None:
    """Write every text beside its place first; only when all are on disk does the first one move."""
    staged: dict[Path, Path] = {}
    try:
        for path, text in texts.items():
            handle, name = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
            staged[path] = Path(name)
            with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
                file.write(text)
            os.chmod(name, 0o644)
        for path, temporary in staged.items():
            os.replace(temporary, path)
    finally:
        for temporary in staged.values():
            temporary.unlink(missing_ok=True)


def _read(path: Path) -> str | None:
    try:
        return path.read_bytes().decode("utf-8")
    except (FileNotFoundError, UnicodeDecodeError):
        return None


def compare(folder: Path, texts: Mapping[str, str]) -> Iterator[Difference]:
    """What in the folder differs from the texts; Python files without the generated header are foreign."""
    for name, text in texts.items():
        path = folder / name
        found = _read(path)
        if found is None:
            yield Difference(path, "missing")
        elif found != text:
            old, new = found.splitlines(keepends=True), text.splitlines(keepends=True)
            lines = difflib.unified_diff(old, new, f"{path} (on disk)", f"{path} (generated)")
            yield Difference(path, "stale", "".join(lines))
    if folder.is_dir():
        for path in sorted(folder.iterdir()):
            if path.name not in texts and path.is_file() and header_command(path) is None:
                yield Difference(path, "foreign")
