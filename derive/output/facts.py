"""Page with its facts as JSON beside it."""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from . import files


def json_rows(**facts: Any) -> str:
    """Return facts as JSON, those of a list on a line each, so that differences of two versions are short.

    Examples
    --------
    >>> print(json_rows(schema=1, sides=[{"left": "α"}, {"left": "β"}]), end="")
    {"schema": 1,
    "sides": [
    {"left": "α"},
    {"left": "β"}
    ]}
    """
    texts = (
        "[\n" + ",\n".join(json.dumps(row, ensure_ascii=False) for row in value) + "\n]"
        if isinstance(value, list) else json.dumps(value, ensure_ascii=False) for value in facts.values()
    )  # fmt: skip
    return "{" + ",\n".join(f'"{name}": {text}' for name, text in zip(facts, texts, strict=True)) + "}\n"


def beside(output: Path, page: str, facts: str) -> dict[str, str]:
    """Return the texts of a page and of its facts by file name."""
    return {output.name: page, output.with_suffix(".json").name: facts}


def stale(output: Path, texts: Mapping[str, str]) -> list[files.Difference]:
    """Return the differences of a page and what stands beside it; other files of the folder do not count."""
    known = {output.parent / name for name in texts}
    return [found for found in files.compare(output.parent, texts) if found.path in known]


def writable(output: Path | None) -> bool:
    """Tell whether a page and its facts can be written, if a page is named; say on stderr why not."""
    try:
        if output is not None:
            files.refuse(output.parent, beside(output, "", ""), force=True)
    except files.RefusedError as error:
        print(f"error: {error}", file=sys.stderr)
        return False
    return True


def deliver(output: Path, texts: Mapping[str, str], check: bool, module: str) -> int:
    """Write a page and its facts, or compare them; the exit code is 1 if a file is stale."""
    if not check:
        files.write(output.parent, texts, force=True)
        return 0
    found = stale(output, texts)
    for difference in found:
        print(f"{difference.path} is stale; accept with:  python -m {module} -o {output}", file=sys.stderr)
    return 1 if found else 0
