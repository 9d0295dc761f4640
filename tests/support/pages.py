"""Checks of Markdown pages: their sessions, their commands, their links."""

from __future__ import annotations

import re
import shlex
import tomllib
from pathlib import Path

from click.testing import CliRunner

from derive.cli.commands import cli
from tests.support import examples

ROOT = Path(__file__).parents[2]
QUICK = ("show", "list", "verify --eq")  # commands that are run; tests/derive/cli tests slower ones


def blocks(text: str, language: str) -> list[str]:
    """Return the fenced blocks of a language."""
    return re.findall(rf"^```{language}\n(.*?)^```", text, re.S | re.M)


def sessions(text: str, name: str) -> str:
    """Run the sessions of a page, which share names; return differences from their printed results."""
    names: dict[str, object] = {}
    found = [block for block in blocks(text, "python") if ">>>" in block]
    return "".join(examples.failures(block, f"{name}, session {number}", names) for number, block in enumerate(found))


def commands(text: str) -> list[str]:
    """Return the lines of shell blocks without comments and continued lines joined."""
    lines = "\n".join(blocks(text, "sh")).replace("\\\n", " ").splitlines()
    return [line for line in (re.sub(r"(^|\s+)#.*", "", line) for line in lines) if line.strip()]


def check_command(line: str) -> None:
    """Require that a command of dualcay, make or pip exists with these options; quick ones of dualcay must succeed.

    Equations are decided at one order.
    """
    program, *arguments = shlex.split(line.replace("python -m derive", "dualcay"))
    if program == "dualcay":
        command, *rest = arguments
        cli.commands[command].make_context(command, list(rest))
        if line.startswith(tuple(f"dualcay {quick}" for quick in QUICK)) and "-o" not in rest:
            done = CliRunner().invoke(cli, [re.sub(r"^1-\d$", "1", argument) for argument in arguments])
            assert done.exit_code == 0, done.output
    elif program == "make":
        goals = [one for one in arguments if "=" not in one] or ["generate"]
        for goal in goals:
            assert re.search(rf"^{goal}:", (ROOT / "Makefile").read_text(encoding="utf-8"), re.M), f"no target {goal}"
    elif program == "pip":
        extras = {name for found in re.findall(r"\[([^\]]+)\]", arguments[-1]) for name in found.split(",")}
        project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
        assert extras <= project["optional-dependencies"].keys(), f"no extra {extras}"


def dead_links(page: Path) -> list[str]:
    """Return the relative links and pictures of a page whose file is missing."""
    text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.S | re.M)
    links = [*re.findall(r"\]\(([^)\s]+)\)", text), *re.findall(r"(?:src|href)=\"([^\"]+)\"", text)]
    files = {link.partition("#")[0] for link in links if "://" not in link and not link.startswith("#")}
    return sorted(file for file in files if file and not (page.parent / file).exists())
