"""Results that the examples print, at the top of their pages; an example runs again when its file changes."""

from __future__ import annotations

import hashlib
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from derive.output.files import put

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"
KEPT = ROOT / "build" / "docs" / "printed"


def result(example: Path) -> str:
    """Return what an example prints, without its progress; nothing if it needs JAX and JAX is missing."""
    text = example.read_text(encoding="utf-8")
    if "import jax\n" in text and find_spec("jax") is None:
        return ""
    kept = KEPT / f"{example.stem}-{hashlib.sha256(text.encode()).hexdigest()[:16]}.txt"
    if not kept.exists():
        paths = os.pathsep.join([str(ROOT), str(ROOT / "generated"), os.environ.get("PYTHONPATH", "")])
        done = subprocess.run(
            [sys.executable, "-m", f"examples.{example.stem}"], cwd=ROOT, env=os.environ | {"PYTHONPATH": paths},
            capture_output=True, text=True, check=True,
        )  # fmt: skip
        lines = (line.rpartition("\r")[2].rstrip() for line in done.stdout.split("\n"))
        put(kept, "\n".join(line for line in lines if "% Completed" not in line))
    return kept.read_text(encoding="utf-8")


def with_result(source: str, printed: str) -> str:
    """Return the page of an example with its result below the title.

    Examples
    --------
    >>> print(with_result("Title\\n=====\\n\\nRun it.\\n", "42\\n"))
    Title
    =====
    <BLANKLINE>
    It prints:
    <BLANKLINE>
    .. code-block:: text
    <BLANKLINE>
        42
    <BLANKLINE>
    Run it.
    <BLANKLINE>
    """
    block = "".join(f"    {line}\n" if line else "\n" for line in printed.strip("\n").split("\n"))
    text = f"It prints:\n\n.. code-block:: text\n\n{block}\n"
    return re.sub(r"^(.+\n=+\n\n)", lambda title: title[1] + text, source, count=1, flags=re.MULTILINE)


def run(app: Any) -> None:
    """Run the examples whose results are not kept, two at a time."""
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(result, sorted(EXAMPLES.glob("*.py"))))


def insert(app: Any, name: str, source: list[str]) -> None:
    """Insert a result into the page that the gallery wrote."""
    example = EXAMPLES / f"{name.removeprefix('examples/')}.py"
    if name.startswith("examples/") and example.exists() and (printed := result(example)):
        source[0] = with_result(source[0], printed)


def setup(app: Any) -> dict[str, bool]:
    """Connect the results to Sphinx."""
    app.connect("builder-inited", run)
    app.connect("source-read", insert)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
