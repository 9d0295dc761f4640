"""Doors to the command: the action's steps, the hook of pre-commit, and the tool for language models."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys

import pytest
import yaml

from derive.cli.commands import cli
from tests.support.command import ROOT, in_a_process

SHEET = "[letters]\nx = 'real'\n[[equation]]\nnumber = '1'\nclaim = '{}'\n"
TRUE, FALSE, UNREAD = map(SHEET.format, ("x == x", "x == x + 1", "x = x"))


@pytest.mark.parametrize(
    ("files", "pattern", "strict", "code", "counts"),
    [
        ({"a b.toml": TRUE, "c/d/e.toml": FALSE}, "**/*.toml", "", 0, "2 decided, 0 unread: 1 false, 1 holds"),
        ({"a b.toml": FALSE}, "a b.toml", "yes", 1, "1 decided, 0 unread: 1 false"),
        ({"a.toml": UNREAD, "b.toml": TRUE}, "b.toml\na.toml\n", "yes", 2,
         "1 decided, 0 unread, 1 not understood: 1 holds"),
        ({}, "*.toml", "", 2, "nothing was decided"), ({}, "a.toml", "", 3, "could not decide: see the log"),
    ],
)  # fmt: skip
def test_the_action_writes_counts_annotations_and_a_report(tmp_path, files, pattern, strict, code, counts):
    command = f'#!/bin/sh\nexec {shlex.quote(sys.executable)} -m derive "$@"\n'
    for name, text in {".bin/dualcay": command, **files}.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
        (tmp_path / name).chmod(0o755)
    action = yaml.safe_load((ROOT / "action.yml").read_text(encoding="utf-8"))
    (step,) = (step for step in action["runs"]["steps"] if step.get("id") == "verify")
    inputs = {"inputs.files": pattern, "inputs.strict": strict, "inputs.report": "report", "runner.temp": str(tmp_path)}
    given = {name: re.sub(r"\$\{\{ (\S+) \}\}", lambda m: inputs[m[1]], text) for name, text in step["env"].items()}
    given |= {"GITHUB_STEP_SUMMARY": "summary", "GITHUB_OUTPUT": "output", "GITHUB_ACTION_PATH": str(ROOT)}
    given |= {"PATH": f"{tmp_path / '.bin'}{os.pathsep}{os.environ['PATH']}", "PYTHONPATH": str(ROOT)}
    run = ["bash", "-c", step["run"]]
    done = subprocess.run(run, cwd=tmp_path, env=os.environ | given, capture_output=True, text=True, check=False)
    assert done.returncode == code, done.stderr
    assert counts in (tmp_path / "summary").read_text()
    assert ("::error" in done.stdout) is (code in (1, 2) or "false" in counts)
    if files:
        assert {path.suffix for path in (tmp_path / "report").iterdir()} == {".txt", ".html", ".json", ".md", ".sarif"}
        assert (tmp_path / "output").read_text() == f"counts={counts}\n"


def test_the_hook_is_a_command_for_files_of_claims():
    (hook,) = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text(encoding="utf-8"))
    program, command, *options = shlex.split(hook["entry"])
    names = ("claims.toml", "a/b.claims.toml", "pyproject.toml", "claims.toml.orig")
    found = [name for name in names if re.search(hook["files"], name)]
    assert (program, found) == ("dualcay", ["claims.toml", "a/b.claims.toml"])
    cli.commands[command].make_context(command, [*options, *found])


def test_the_tool_for_language_models_names_a_missing_library():
    done = in_a_process(code="import sys; sys.modules['mcp'] = None; from derive.mcp import main; sys.exit(main())")
    assert (done.returncode, done.stdout) == (3, "")
    assert done.stderr.startswith("derive.mcp: needs mcp")


@pytest.mark.mcp
@pytest.mark.filterwarnings("ignore")
def test_a_language_model_gets_the_result_and_errors_by_the_tool():
    import asyncio

    from mcp import Client, StdioServerParameters

    async def asked() -> list[tuple[bool, str]]:
        env = {**os.environ, "PYTHONPATH": os.pathsep.join((str(ROOT), *sys.path))}
        async with Client(StdioServerParameters(command=sys.executable, args=["-m", "derive.mcp"], env=env)) as client:
            (tool,) = (await client.list_tools()).tools
            assert (tool.name, [*tool.input_schema["properties"]]) == ("check", ["claim", "letters", "domain"])
            assert "unit quaternion" in client.instructions
            calls = [{"claim": "sqrt(x**2) == x", "letters": {"x": "real"}, "domain": "x > 0"},
                     {"claim": "x == y", "letters": {"x": "real"}}]  # fmt: skip
            return [(r.is_error, r.content[0].text) for call in calls for r in [await client.call_tool("check", call)]]

    (fine, text), (wrong, message) = asyncio.run(asked())
    assert (fine, json.loads(text)["status"], wrong) == (False, "holds", True)
    assert "column 6: unknown letter 'y'" in message
