"""The README's sessions run, and its commands exist."""

from __future__ import annotations

import doctest
import re
from pathlib import Path

import pytest

from derive.cli.commands import cli

README = Path(__file__).parent.parent / "README.md"


def test_every_session_runs_as_printed() -> None:
    text = README.read_text(encoding="utf-8")
    sessions = re.findall(r"```python\n(.*?)```", text, re.S)
    assert len(sessions) >= 2
    names: dict[str, object] = {}  # later sessions go on with the names of earlier ones
    for number, session in enumerate(sessions):
        test = doctest.DocTestParser().get_doctest(session, names, f"README session {number}", str(README), 0)
        assert test.examples
        assert doctest.DocTestRunner().run(test, clear_globs=False).failed == 0
        names = test.globs


@pytest.mark.parametrize("line", re.findall(r"^dualcay .*$", README.read_text(encoding="utf-8"), re.M))
def test_every_command_parses(line: str) -> None:
    _, command, *arguments = re.sub(r"\s+#.*", "", line).split()
    cli.commands[command].make_context(command, arguments)
