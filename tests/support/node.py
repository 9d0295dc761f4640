"""Search for node, which runs JavaScript in the tests."""

from __future__ import annotations

import shutil

MISSING = "node is not installed (apt-get install nodejs)"


def find() -> str | None:
    return shutil.which("node")
