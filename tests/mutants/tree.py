"""Copies of the working tree, in which one file at a time is changed, and its digest."""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from .python import Edit

VERSION = 2
"""Counted up when mutants are tried in another way, so that what was found before has to be found again."""

DECIDING = (
    "derive", "templates", "generated", "tests/support", ":(glob)tests/**/conftest.py", "docs/theorems.md",
    "docs/errata.md", "pyproject.toml",
)  # fmt: skip
"""What decides the fate of every mutant; the tests of its room do besides."""

SEEN = (
    "derive", "templates", "generated", "tests", "pyproject.toml", "benchmarks", "docs", "examples", "Makefile",
    "README.md", "CHANGELOG.md", "CITATION.cff", "CONTRIBUTING.md", "SECURITY.md",
)  # fmt: skip
"""What checks may read."""

FOREIGN = ("derive", "dualcay")
"""Packages that a copy must import from itself."""


def files(root: Path, names: tuple[str, ...]) -> list[Path]:
    """Files of the working tree, new ones included and ignored ones left out."""
    command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "--", *names]
    listed = subprocess.run(command, cwd=root, check=True, capture_output=True, text=True).stdout.split("\0")
    return sorted(root / name for name in set(listed) if name and (root / name).is_file())


@dataclass(frozen=True, slots=True)
class Deciding:
    """What decides fates, by digests: all but the tests of a room in one, and each file of tests."""

    base: str
    tests: Mapping[str, str]

    @property
    def name(self) -> str:
        """Of all of it."""
        return _digest([self.base, *(f"{file}\0{found}" for file, found in sorted(self.tests.items()))])

    def changed(self, before: Deciding) -> tuple[str, ...]:
        """Files of tests that are new or otherwise than before."""
        return tuple(sorted(file for file, found in self.tests.items() if before.tests.get(file) != found))


def deciding(root: Path, tests: tuple[str, ...], further: tuple[str, ...] = ()) -> Deciding:
    """What decides, if these are the tests; what is no test in their folders, and further files, decide all fates."""
    listed = files(root, tests) if tests else []
    chosen = [path for path in listed if path.name.startswith("test_")]
    others = sorted({*files(root, (*DECIDING, *further)), *listed} - {*chosen})
    base = _digest([str(VERSION), sys.version, *(f"{path.relative_to(root)}\0{_of(path)}" for path in others)])
    return Deciding(base, {str(path.relative_to(root)): _of(path) for path in chosen})


def _of(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()[:16]


def _digest(lines: Iterable[str]) -> str:
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:16]


class Copy:
    """A copy of a working tree.

    Parameters
    ----------
    root, folder : Path
        The tree, and where the copy is made.
    """

    def __init__(self, root: Path, folder: Path) -> None:
        self.folder = folder
        for path in files(root, SEEN):
            target = folder / path.relative_to(root)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(path, target)
        kernels = folder / "generated"
        self._kernels = {path: path.read_bytes() for path in sorted(kernels.rglob("*")) if path.is_file()}

    @contextmanager
    def changed(self, edit: Edit | None) -> Iterator[None]:
        """The copy with one file changed; afterwards that file, and the kernels, are what they were."""
        if edit is None:
            yield
            return
        path = self.folder / edit.path
        source, times = path.read_bytes(), path.stat()
        path.write_bytes(edit.apply(source))
        os.utime(path, (times.st_atime, times.st_mtime + 10))  # no bytecode of the original answers for it
        try:
            yield
        finally:
            path.write_bytes(source)
            os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
            self._restore_kernels()

    def _restore_kernels(self) -> None:
        for path, content in self._kernels.items():
            if path.read_bytes() != content:
                path.write_bytes(content)


def enter(folder: Path) -> None:
    """Make this process, and those it starts, import everything from a copy."""
    temporary = folder / "tmp"
    temporary.mkdir(exist_ok=True)
    tempfile.tempdir = os.environ["TMPDIR"] = str(temporary)
    elsewhere = [entry for entry in sys.path if not _holds_ours(Path(entry))]
    os.chdir(folder)
    sys.path[:] = [str(folder), str(folder / "generated"), *elsewhere]
    os.environ["PYTHONPATH"] = os.pathsep.join(sys.path[:2])
    forget(*FOREIGN)
    sys.path_importer_cache.clear()


def _holds_ours(entry: Path) -> bool:
    return any((entry / name / "__init__.py").is_file() for name in FOREIGN)


def forget(*packages: str) -> None:
    """Drop packages, so that they are imported again."""
    for name in [name for name in sys.modules if name.partition(".")[0] in packages]:
        del sys.modules[name]
