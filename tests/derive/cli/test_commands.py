"""Commands of ``dualcay``: output, exit codes and messages."""

from __future__ import annotations

import itertools
import json
import os
import re
import shlex
import subprocess
import sys
import tomllib
from pathlib import Path

import click
import pytest

import derive
from derive import about
from derive.__main__ import NEEDED
from derive.claims.language.letters import LETTERS
from derive.claims.language.operations import OPERATIONS
from derive.claims.report import FORMATS
from derive.cli import commands, display, options
from derive.codegen import Difference
from derive.codegen.package import command as header
from derive.codegen.targets import TARGETS
from derive.maps import Cayley
from derive.papers import PAPERS
from tests.support.command import ROOT, dualcay


@pytest.mark.smoke
def test_generate_writes_a_package_and_says_what_was_proved(tmp_path: Path):
    done = dualcay("generate", "-n", "2", "-o", str(tmp_path / "k"))
    assert done.returncode == 0
    assert "cayley2.py" in done.stdout
    assert "proofs" in done.stdout
    assert done.stderr == ""
    names = {p.relative_to(tmp_path / "k").as_posix() for p in (tmp_path / "k").rglob("*") if p.is_file()}
    assert names == {"cayley2.py", "rotation/cayley2.py", *TARGETS["numpy"].shared(), *TARGETS["numpy"].index(())}


def test_check_reports_a_stale_file_and_the_command_that_accepts_it(tmp_path: Path, without_validation):
    folder = str(tmp_path / "k")
    dualcay("generate", "-n", "2", "-o", folder)
    assert dualcay("generate", "-n", "2", "-o", folder, "--check").returncode == 0
    (tmp_path / "k" / "cayley2.py").write_text("# python -m derive generate -n 2 --target numpy\n")
    (tmp_path / "k" / "mine.py").write_text("")
    done = dualcay("generate", "-n", "2", "-o", folder, "--check")
    assert done.returncode == 1
    assert "stale: " in done.stdout
    assert "foreign: " in done.stdout
    assert "+ORDER = 2" in done.stdout
    assert f"accept with:  dualcay generate -n 2 -o {folder}\n" in done.stderr


@pytest.mark.parametrize("options", [(), ("--target", "array-api", "--max-n", "9", "--force")])
def test_accepting_command_repeats_every_option(tmp_path: Path, monkeypatch, options: tuple[str, ...]):
    stale = Difference(tmp_path / "f.py", "stale")
    given = ("generate", "-n", "6", *options, "-o", str(tmp_path / "the user's kernels"))
    monkeypatch.setattr("derive.codegen.build.check_charts", lambda *_, **__: [stale])
    done = dualcay(*given, "--check")
    assert done.returncode == 1
    assert done.stderr == f"1 file(s) differ; accept with:  {shlex.join(('dualcay', *given))}\n"


def test_accepting_command_begins_as_typed(monkeypatch):
    for started, name in (("/usr/bin/dualcay", "dualcay"), ("/x/derive/__main__.py", "python -m derive")):
        monkeypatch.setattr("sys.argv", [started, "generate", "--check"])
        assert options.without_check() == f"{name} generate"


def test_foreign_file_is_overwritten_only_if_forced(tmp_path: Path, without_validation):
    (tmp_path / "cayley2.py").write_text("mine = 1\n")
    done = dualcay("generate", "-n", "2", "-o", str(tmp_path))
    assert done.returncode == 3
    assert "not a generated file, so not overwritten" in done.stderr
    assert [p.name for p in tmp_path.iterdir()] == ["cayley2.py"]
    assert dualcay("generate", "-n", "2", "-o", str(tmp_path), "--force").returncode == 0


def test_import_of_a_half_written_package_says_how_to_finish_it(tmp_path: Path, monkeypatch, without_validation):
    folder, replace, renames = tmp_path / "the kernels", os.replace, itertools.count(1)

    def fails(source: Path, target: Path) -> None:
        if Path(target).is_relative_to(folder) and next(renames) == 4:  # after the notice and another file
            raise OSError(28, "No space left on device", str(target))
        replace(source, target)

    monkeypatch.setattr(os, "replace", fails)
    assert "half-written until the command runs again" in dualcay("generate", "-n", "1", "-o", str(folder)).stderr
    load = [sys.executable, "-c", "import sys, importlib; importlib.import_module('the kernels.cayley1')"]
    done = subprocess.run(load, cwd=tmp_path, capture_output=True, text=True, check=False)
    command = f"python -m derive generate -n 1 --target numpy -o '{folder}'"
    assert done.stderr.endswith(f"ImportError: the kernels is half-written: finish it with  {command}\n")
    checked = dualcay("generate", "-n", "1", "-o", str(folder), "--check")
    assert checked.returncode == 1
    assert f"unfinished: {folder}/.dualcay-ready (a run is writing here, or was killed" in checked.stdout
    assert f"stale: {folder}/__init__.py" in checked.stdout
    assert dualcay(*shlex.split(command)[3:]).returncode == 0
    assert dualcay("generate", "-n", "1", "-o", str(folder), "--check").returncode == 0
    subprocess.run(load, cwd=tmp_path, check=True)


def test_check_regenerates_only_modules_that_match_their_header(tmp_path: Path, without_validation):
    folder = tmp_path / "k"
    derive.generate([1], output=folder)
    head = "# python -m derive generate -n {} --target {}\n"
    forged = {
        "cayley3.py": head.format(2, "numpy"),  # another order
        "cayley5.py": head.format(5, "array-api"),  # another target
        "cayley7.py": head.format(7, "numpy --phi x"),  # another command
        "cayley77.py": head.format("7" * 5000, "numpy"),
        "helper.py": head.format(8, "numpy"),
    }
    for name, text in forged.items():
        (folder / name).write_text(text)
    (folder / "cayley99.py").write_text(head.format(99, "numpy --max-n 99"))
    (folder / "motions").mkdir()
    done = dualcay("generate", "-n", "1", "-o", str(folder), "--check")
    assert done.returncode == 1
    claim = "not made by what its first line says"
    for name, text in forged.items():
        assert f"foreign: {folder / name} ({claim}: {text.strip()[2:]})\n" in done.stdout
    reason = "order 99 is above the cap 64, so not compared; raise it with --max-n"
    assert f"foreign: {folder}/cayley99.py ({reason})\n" in done.stdout
    assert f"foreign: {folder}/motions\n" in done.stdout
    assert f"{len(forged) + 4} file(s) differ" in done.stderr  # two more list cayley99


def test_command_in_a_header():
    assert header("c") == "python -m derive generate --target c"
    assert header("numpy", Cayley(6)) == "python -m derive generate -n 6 --target numpy"
    both = header("numpy", Cayley(6), Cayley(65))
    assert both == "python -m derive generate -n 6,65 --target numpy --max-n 65"


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("show -n 3", ["p_3 = 1 - 3*x"]),
        ("show -n 3 --format latex", [r"p_{3} = 1 - 3 x"]),
        ("show -n 3 --format markdown", ["## n = 3\n\n$$p_{3} = 1 - 3 x$$"]),
        ("show --family lambert,sine3 --what tangent", ["name = lambert, phi = sin(alpha/4)\n  tangent = ("]),
        ("show --phi sinh(alpha/3)", ["name = phi, phi = sinh(alpha/3)\n  quaternion = (cos(alpha/2)) 1"]),
        ("show --phi tan(alpha/(2*n)) -n 7 --what p", ["p_7 = 1 - 21*x"]),
        ("show -n 66 --max-n 66 --what p", ["p_66 = "]),
        ("list", ["numpy", "committed: 1, 2, 3, 4, 5, 8", "tangent_inv", "transform_line"]),
        ("list --claims", [*LETTERS, *(row.example for row in OPERATIONS.values())]),
    ],
)
def test_formulas_and_catalogues_are_printed(line: str, expected: list[str]):
    done = dualcay(*line.split())
    assert (done.returncode, [words for words in expected if words not in done.stdout]) == (0, [])


def test_show_prints_json():
    found = json.loads(dualcay("show", "-n", "1-2", "--what", "q,tangent", "--format", "json").stdout)
    assert [entry["n"] for entry in found] == [1, 2]
    assert found[0] == {"n": 1, "q": "1", "tangent": {"I": "2/(1 + x)", "skew(v)": "2/(1 + x)", "v⊗v": "0"}}


# --- help before other modules are loaded -------------------------------------------------------------------------


def test_about_matches_the_tables_it_names():
    assert tuple(TARGETS) == about.TARGETS
    assert tuple(paper.slug for paper in PAPERS) == about.PAPERS
    assert tuple(FORMATS) == about.FORMATS
    assert all(hasattr(Cayley, name) for name in about.FORMULAS)


def test_needed_libraries_match_the_extra():
    extra = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    installed = {re.split(r"[>=\[]", requirement)[0] for requirement in extra["derive"]}
    assert {name.removeprefix("python-") for name in installed} == set(NEEDED)


def test_every_option_has_help():
    for command in commands.cli.commands.values():
        for parameter in command.params:
            if isinstance(parameter, click.Option):  # the help of a command names its files
                assert parameter.help, f"{command.name} {parameter.opts}"


# --- tables and progress ------------------------------------------------------------------------------------------


def test_tables_fit_the_screen(tmp_path: Path, monkeypatch):
    (tmp_path / "k").mkdir()
    monkeypatch.setenv("COLUMNS", "20")
    done = dualcay("generate", "-n", "1", "-o", "k", cwd=tmp_path)
    # nothing is validated, so the table has no columns of calls
    assert re.fullmatch(r"kernels in k\ncayley1.py\n  proofs: \d+\n  lines: \d+\n", done.stdout)
    monkeypatch.setenv("COLUMNS", "40")
    for line in ("list", "list --claims"):
        assert max(map(len, dualcay(*line.split()).stdout.splitlines())) <= 40


def test_progress_on_a_pipe_is_silent_for_short_runs_and_sparse_for_long_ones(monkeypatch, capsys):
    with display.progress(2) as step:
        step("first")
    assert capsys.readouterr().err == ""
    monkeypatch.setattr(display, "FIRST_PAUSE", 10.0)
    clock = iter([0.0, 9.0, 12.0, 20.0, 33.0])
    monkeypatch.setattr(display.time, "monotonic", lambda: next(clock))
    with display.progress(4) as step:
        for line in ("first", "second", "third", "fourth"):
            step(line)
    assert capsys.readouterr().err == "12 s: 1/4  second\n33 s: 3/4  fourth\n"
