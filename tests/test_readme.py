"""README: example sessions run, commands exist, links have targets, numbers agree with the benchmark pages."""

from __future__ import annotations

import re
import shlex
import tomllib
from pathlib import Path

import pytest
from click.testing import CliRunner

from derive.cli.commands import cli
from derive.codegen.targets import TARGETS
from tests.support import examples

ROOT = Path(__file__).parent.parent
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```(\w*)\n(.*?)```", TEXT, re.S)
LINES = [re.sub(r"\s+#.*", "", line) for language, block in BLOCKS if language == "sh" for line in block.splitlines()]
QUICK = ("show", "list", "verify --eq")
"""Commands run by this test; tests/derive/cli tests slower ones."""


def test_every_block_is_a_session_or_commands() -> None:
    assert {language for language, _ in BLOCKS} == {"python", "sh"}


def test_every_session_runs_as_printed() -> None:
    sessions = [block for language, block in BLOCKS if language == "python"]
    assert len(sessions) >= 5
    names: dict[str, object] = {}  # sessions use names of earlier sessions
    for number, session in enumerate(sessions):
        assert examples.failures(session, f"README session {number}", names) == ""


@pytest.mark.parametrize("line", LINES)
def test_every_command_exists(line: str) -> None:
    program, *arguments = shlex.split(line.replace("python -m derive", "dualcay"))
    if program == "dualcay":
        command, *rest = arguments
        cli.commands[command].make_context(command, list(rest))
        if line.startswith(tuple(f"dualcay {quick}" for quick in QUICK)):
            done = CliRunner().invoke(cli, arguments)
            assert done.exit_code == 0, done.output
    elif program == "make":
        target = re.compile(rf"^{arguments[0] if arguments else 'generate'}:", re.M)
        assert target.search((ROOT / "Makefile").read_text(encoding="utf-8"))
    elif program == "pip":
        extras = re.findall(r"[^\[\],]+", arguments[-1])[1:]  # folder with extras
        project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
        assert set(extras) <= project["optional-dependencies"].keys()
    else:
        assert line == "python -m pytest -n auto"


@pytest.mark.parametrize("link", re.findall(r"(?:\]\(|src=\")([^)\"]+)", TEXT))
def test_every_link_leads_somewhere(link: str) -> None:
    file, _, section = link.partition("#")
    assert (ROOT / file).exists()
    assert not section or f"\n## {section}\n" in TEXT.lower()


def test_numbers_agree_with_the_benchmark_page() -> None:
    page = (ROOT / "docs" / "benchmarks.md").read_text(encoding="utf-8").splitlines()
    rows = [line for line in TEXT.splitlines() if re.match(r"\| (n|\d+) \| ", line)]
    assert len(rows) > 5
    assert [row for row in rows if row not in page] == []


def test_assurance_page_has_a_section_for_every_target() -> None:
    page = (ROOT / "docs" / "assurance.md").read_text(encoding="utf-8")
    assert re.findall(r"^### (.+)$", page, re.M) == list(TARGETS)
