"""Page on motion: its sessions run, its links have targets."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.support import examples

PAGE = Path(__file__).parent.parent / "docs" / "motion.md"
TEXT = PAGE.read_text(encoding="utf-8")


def test_every_session_runs_as_printed() -> None:
    names: dict[str, object] = {}  # sessions use names of earlier sessions
    sessions = re.findall(r"```python\n(.*?)```", TEXT, re.S)
    assert len(sessions) >= 6
    for number, session in enumerate(sessions):
        assert examples.failures(session, f"session {number}", names) == ""


@pytest.mark.parametrize("link", re.findall(r"\]\(([^)#]+)", TEXT))
def test_every_link_leads_somewhere(link: str) -> None:
    assert (PAGE.parent / link).exists()
