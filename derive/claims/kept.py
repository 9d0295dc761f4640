"""Results kept from run to run, so that a claim that did not change is not decided again.

Each is a small file of JSON. Its name is a hash of all that decides it: the claim with number, letters, definitions,
domain and correction, the limit of processor time, and the toolkit with its libraries. Broken files are ignored.
"""

from __future__ import annotations

import json
import os
import sys
from contextlib import suppress
from dataclasses import fields
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any

import flint
import mpmath
import sympy

from ..about import __version__
from ..output.files import RefusedError, put
from .equation import Entry
from .language.printed import Term
from .result import Counterexample, Result, Status, Verdict
from .sheet import Sheet

VARIABLE = "DUALCAY_CACHE"
"""Variable of the environment that names the folder; nothing is kept if it is empty."""
BYTES_MAX, FILE_MAX, BLOCK = 50_000_000, 1_000_000, 4096
"""Largest size of all files and of one, and the least that a file takes on a disk."""
SHOWN = {"title", "remark", "source", "home", "at", "printed", "proposed"}
"""Fields of an entry that decide nothing; its number decides which points are tried."""


def folder() -> Path | None:
    """Return the folder of results: the one that `VARIABLE` names, or one among the caches of the user."""
    if (named := os.environ.get(VARIABLE)) is not None:
        return Path(named) if named else None
    variable, usual = {
        "win32": ("LOCALAPPDATA", "~/AppData/Local"), "darwin": ("", "~/Library/Caches"),
    }.get(sys.platform, ("XDG_CACHE_HOME", "~/.cache"))  # fmt: skip
    given = os.environ.get(variable, "")
    base = Path(given if os.path.isabs(given) else os.path.expanduser(usual))
    return base / "dualcay" if base.is_absolute() else None  # a user may have no home


@cache
def toolkit() -> str:
    """Return a hash of the sources of the toolkit, with the versions of Python and of libraries that decide."""
    versions = (sys.version, __version__, *(library.__version__ for library in (flint, mpmath, sympy)))
    found = sha256(repr(versions).encode())
    for path in sorted(Path(__file__).parents[1].rglob("*.py")):
        found.update(sha256(path.name.encode() + path.read_bytes()).digest())
    return found.hexdigest()


class Store:
    """Results in a folder, of claims decided within a limit; without a folder nothing is kept."""

    def __init__(self, folder: Path | None, seconds: float) -> None:
        self.folder, self.seconds, self.grown = folder, seconds, False

    def find(self, sheet: Sheet, entry: Entry) -> Result | None:
        """Return the result of an entry; None if there is none, or its file is broken."""
        with suppress(OSError, ValueError, LookupError, TypeError, AttributeError, RecursionError):
            path = self._path(sheet, entry)
            if path is not None and path.is_file() and path.stat().st_size <= FILE_MAX:
                mark, _, text = path.read_text(encoding="utf-8").partition("\n")
                if mark == _mark(path, text):
                    os.utime(path)  # it was needed now, so others go first
                    return _unpacked(json.loads(text), sheet.slug, entry)
        return None

    def keep(self, sheet: Sheet, result: Result) -> None:
        """Write the file of a result, unless it is too long or the folder cannot be written."""
        with suppress(OSError, RefusedError, RecursionError):
            path, text = self._path(sheet, result.equation), _packed(result)
            if path is not None and len(text) < FILE_MAX // 2:
                put(path, f"{_mark(path, text)}\n{text}")
                self.grown = True

    def shrink(self) -> None:
        """Remove the results that were not needed for the longest time, if all take more than `BYTES_MAX`."""
        files, room = self.folder.glob("??/*.json") if self.folder and self.grown else (), BYTES_MAX
        with suppress(OSError):  # another process removes files too
            found = [(path.stat(), path) for path in files]
            for stat, path in sorted(found, key=lambda row: -row[0].st_mtime):
                room -= max(stat.st_size, BLOCK)
                if room < 0:
                    path.unlink()

    def _path(self, sheet: Sheet, entry: Entry) -> Path | None:
        if self.folder is None:
            return None
        deciding = {f.name: getattr(entry, f.name) for f in fields(entry) if f.name not in SHOWN}
        text = json.dumps([toolkit(), self.seconds, sheet.lost, deciding], default=_parts)
        name = sha256(text.encode()).hexdigest()
        return self.folder / name[:2] / f"{name}.json"


def _mark(path: Path, text: str) -> str:
    """Return the first line of a file, which tells whether the rest is whole and in its place."""
    return sha256(f"{path.stem}\n{text}".encode()).hexdigest()


def _parts(part: Any) -> Any:
    """Return what JSON lacks by its parts: a term, a reading, a definition, or a leaf of SymPy as text."""
    if isinstance(part, Term):
        return [type(part).__name__, *part.args]
    if not hasattr(part, "__dataclass_fields__"):
        return str(part)
    return {**vars(part), "known": getattr(part, "known", {}).get(())}  # names without parameters stand in conditions


def _packed(result: Result) -> str:
    places = [reading.statement for reading in result.equation.readings]
    return json.dumps(result.own, default=lambda part: places.index(part) if isinstance(part, Term) else vars(part))


def _unpacked(own: dict[str, Any], slug: str, entry: Entry) -> Result:
    for row in own["verdicts"]:
        row["statement"] = entry.readings[row["statement"]].statement
    for row in (own, *own["verdicts"]):
        for name in row.keys() & {"counterexample", "outside"}:
            row[name] = row[name] and Counterexample(**{**row[name], "sides": tuple(row[name]["sides"])})
    own |= {name: tuple(own[name]) for name in ("changes", "vacuous", "needs")}
    own |= {"status": Status(own["status"]), "verdicts": tuple(Verdict(**row) for row in own["verdicts"])}
    return Result(slug, entry, **own)
