"""Search for the browser used in tests of the report."""

from __future__ import annotations

import os
import shutil

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
MISSING = "no browser is installed (apt-get install chromium, or name one in the variable CHROMIUM)"


def find() -> str | None:
    """Return the browser named in CHROMIUM, without a check; if CHROMIUM is not set, the first browser found."""
    return os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), None)
