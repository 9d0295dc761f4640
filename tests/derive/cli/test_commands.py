"""The command as a person runs it: output, exit codes, messages, no traceback."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from derive.codegen.targets import TARGETS
from tests.support.command import dualcay, in_a_process


@pytest.mark.smoke
def test_generate_writes_a_package_and_says_what_was_proved(tmp_path: Path):
    done = dualcay("generate", "-n", "2", "-o", str(tmp_path / "k"))
    assert done.returncode == 0
    assert "cayley2.py" in done.stdout
    assert "theorems" in done.stdout
    assert done.stderr == ""
    names = sorted(p.name for p in (tmp_path / "k").iterdir())
    assert names == sorted(["cayley2.py", *TARGETS["numpy"].shared])


def test_check_passes_and_names_a_stale_file_with_the_accepting_command(tmp_path: Path):
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
    assert f"accept with:  python -m derive generate -o {folder}" in done.stderr


@pytest.mark.parametrize(
    ("arguments", "code", "message"),
    [
        (["generate", "-n", "0"], 2, "an order is an integer n >= 1, got '0'"),
        (["generate", "-n", "2.5"], 2, "expected orders such as 7 or 1-5,8, got '2.5'"),
        (["generate", "-n", "-3"], 2, "expected orders such as 7 or 1-5,8, got '-3'"),
        (["generate", "-n", "5-2"], 2, "a range runs upwards over at most 10000 orders, got '5-2'"),
        (["generate", "-n", "65", "-o", "k"], 2, "order 65 is above the cap 64; raise it with --max-n"),
        (["generate", "-n", "2", "--target", "fortran"], 2, "'fortran' is not"),
        (["show"], 2, "Missing option '-n'"),
        (["show", "-n", "2", "--what", "p,r"], 2, "expected names out of p, q, quaternion"),
        (["nonsense"], 2, "No such command 'nonsense'"),
        (["generate", "-n", "2", "-o", "/proc/nowhere"], 3, "cannot write /proc/nowhere"),
    ],
)
def test_bad_input_gets_a_message_and_its_exit_code(tmp_path: Path, arguments, code, message):
    done = dualcay(*arguments, cwd=tmp_path)
    assert done.returncode == code
    assert message in done.stderr
    assert done.stdout == ""
    assert list(tmp_path.iterdir()) == []


def test_a_foreign_file_is_not_overwritten_unless_forced(tmp_path: Path):
    (tmp_path / "cayley2.py").write_text("mine = 1\n")
    done = dualcay("generate", "-n", "2", "-o", str(tmp_path))
    assert done.returncode == 3
    assert "not a generated file, so not overwritten" in done.stderr
    assert [p.name for p in tmp_path.iterdir()] == ["cayley2.py"]
    assert dualcay("generate", "-n", "2", "-o", str(tmp_path), "--force").returncode == 0


def test_the_cap_can_be_raised(tmp_path: Path):
    assert dualcay("generate", "-n", "6", "--max-n", "5", "-o", str(tmp_path / "k")).returncode == 2
    assert dualcay("show", "-n", "66", "--max-n", "66", "--what", "p").returncode == 0


@pytest.mark.parametrize(
    ("form", "expected"),
    [
        ("text", "p_3 = 1 - 3*x"),
        ("latex", r"p_{3} = 1 - 3 x"),
        ("markdown", "## n = 3\n\n$$p_{3} = 1 - 3 x$$"),
    ],
)
def test_show_prints_formulas(form, expected):
    done = dualcay("show", "-n", "3", "--format", form)
    assert done.returncode == 0
    assert expected in done.stdout


def test_show_prints_json():
    found = json.loads(dualcay("show", "-n", "1-2", "--what", "q,tangent", "--format", "json").stdout)
    assert [entry["n"] for entry in found] == [1, 2]
    assert found[0] == {"n": 1, "q": "1", "tangent": {"I": "2/(1 + x)", "skew(v)": "2/(1 + x)", "v⊗v": "0"}}


def test_list_names_what_there_is():
    done = dualcay("list")
    assert done.returncode == 0
    for word in ("numpy", "committed: 1, 2, 3, 4, 5, 8", "tangent_inv", "transform_line"):
        assert word in done.stdout


# --- what only a process shows ------------------------------------------------------------------------------------


def test_a_process_ends_with_the_code_and_keeps_its_streams_apart():
    done = in_a_process("show", "-n", "2", "--what", "tensor", LC_ALL="C.UTF-8")
    assert (done.returncode, done.stderr) == (0, "")
    assert "v⊗v" in done.stdout
    done = in_a_process("show")
    assert (done.returncode, done.stdout) == (2, "")
    assert "Missing option '-n'" in done.stderr


def test_an_interrupted_process_says_so_without_a_traceback():
    code = (
        "import os, signal, sys\n"
        "from derive.cli import commands\n"
        "commands.Cayley = lambda order: os.kill(os.getpid(), signal.SIGINT)\n"
        "sys.exit(commands.run())"
    )
    done = in_a_process("show", "-n", "2", code=code)
    assert (done.returncode, done.stdout, done.stderr.strip()) == (3, "", "aborted")


def test_without_its_libraries_the_command_says_what_to_install():
    code = (
        "import importlib.util, sys\n"
        "found = importlib.util.find_spec\n"
        "importlib.util.find_spec = lambda name, *a: None if name in ('sympy', 'jinja2') else found(name, *a)\n"
        "from derive.__main__ import main\n"
        "sys.exit(main())"
    )
    done = in_a_process("list", code=code)
    assert done.returncode == 3
    assert done.stderr == 'dualcay: needs jinja2, sympy: install with  pip install "dualcay[derive]"\n'
