"""Mutants of source lines: a copy of the tree with one token changed, in a Python file or a template."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from functools import partial
from pathlib import Path

from .mutant import KILLED, SURVIVED, Mutant, Room, Verdict

ROOT = Path(__file__).parents[2]
COPIED = ("derive", "templates", "generated", "tests", "pyproject.toml", "docs")

SWAPPED = {
    "sign": {" + ": " - ", " - ": " + ", "(-": "("},
    "factor": {" * ": " / ", " / ": " * ", "**": "*"},
    "comparison": {" < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == "},
    "condition": {" and ": " or ", " or ": " and ", "if not ": "if ", "True": "False", "False": "True"},
    "sibling": {"sin(": "cos(", "cos(": "sin(", "min(": "max(", "max(": "min(", ".re": ".du", ".du": ".re"},
}
"""Tokens and their replacements, by operator."""

TOKENS = {token: (operator, other) for operator, table in SWAPPED.items() for token, other in table.items()}
TOKEN = re.compile("|".join(map(re.escape, sorted(TOKENS, key=len, reverse=True))) + r"|(?<![\w.\"'])\d+(?![\w.\"'])")
PROSE = re.compile(
    r'r?"""[\s\S]*?"""|\{#[\s\S]*?#\}|(?<![\w"\'])#.*|//[^/\n]*$|"(?:[^"\\\n]|\\.)*"|/\*[\s\S]*?\*/', re.M
)
"""Pattern of docstrings, comments and strings; their text is not changed."""

SOURCES = {
    "maps": ("derive/maps",),
    "proof": ("derive/proof",),
    "lowering": ("derive/codegen/lowering", "derive/codegen/programs", "derive/codegen/targets"),
    "templates": ("templates/numpy",),
}
"""Source folders by room; the tests of the same room are run, and for templates the tests of codegen."""

CHARTS = ("-n", "1-4", "--family", "exponential,orthographic,scaled2,sine3,breusing")
STAGES = {
    "generate": ("-m", "derive", "generate", *CHARTS, "-o", "generated/dualcay", "--force"),
    "tests": ("-m", "pytest", "-q", "-x", "--tb=no", "-p", "no:cacheprovider", "-m", "not thorough"),
}
"""Commands that should refuse a mutant; the first writes kernels, on which the tests run."""


def changes(text: str) -> Iterator[tuple[int, str, str, str]]:
    """Yield line number, operator, change in words and changed text, for every token outside prose."""
    prose = [match.span() for match in PROSE.finditer(text)]
    for match in TOKEN.finditer(text):
        start, end = match.span()
        if any(first <= start < last for first, last in prose):
            continue
        operator, other = TOKENS.get(match[0]) or ("constant", str(int(match[0]) + 1))
        line = text.count("\n", 0, start) + 1
        words = " ".join(text.splitlines()[line - 1].split())
        yield line, operator, f"{match[0].strip()} → {other.strip()} in {words}", text[:start] + other + text[end:]


def _mutants(room: str) -> Iterator[Mutant]:
    yield Mutant(room, "none", "unchanged", partial(_trial, room, None, ""))
    for folder in SOURCES[room]:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in (".py", ".j2"):
                name, text = str(path.relative_to(ROOT)), path.read_text(encoding="utf-8")
                for line, operator, change, changed in changes(text):
                    if path.suffix == ".j2" or _compiles(changed):
                        yield Mutant(f"{name}:{line}", operator, change, partial(_trial, room, name, changed))


ROOMS: dict[str, Room] = {room: partial(_mutants, room) for room in SOURCES}


def _compiles(text: str) -> bool:
    try:
        compile(text, "mutant", "exec")
    except SyntaxError:
        return False
    return True


def _trial(room: str, name: str | None, text: str) -> Verdict:
    """Run the commands in a copy of the tree with one changed file."""
    tests = f"tests/derive/{room}" if (ROOT / "tests/derive" / room).is_dir() else "tests/derive/codegen"
    with tempfile.TemporaryDirectory(prefix="dualcay-mutant-") as folder:
        for part in COPIED:
            copy = shutil.copytree if (ROOT / part).is_dir() else shutil.copy2
            copy(ROOT / part, Path(folder, part))  # type: ignore[operator]
        if name:
            Path(folder, name).write_text(text, encoding="utf-8")
        paths = os.pathsep.join([folder, str(Path(folder, "generated"))])
        environment = os.environ | {"PYTHONPATH": paths, "TMPDIR": folder, "PYTHONDONTWRITEBYTECODE": "1"}
        for stage, command in STAGES.items():
            given = [sys.executable, *command, *([tests] if stage == "tests" else [])]
            done = subprocess.run(given, cwd=folder, env=environment, capture_output=True, text=True, check=False)
            if done.returncode:
                said = (done.stdout + done.stderr).strip().splitlines()[-1:]
                return Verdict(KILLED, f"{stage} {''.join(said)}")
    return Verdict(SURVIVED)
