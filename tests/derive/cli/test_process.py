"""Command ``dualcay`` as a process: exit code, streams, encoding, imports."""

from __future__ import annotations

import os

import pytest

import derive
from derive.__main__ import NEEDED
from derive.codegen import Difference
from tests.support.command import dualcay, in_a_process


def test_process_has_exit_code_and_separate_streams():
    done = in_a_process("nonsense")
    assert (done.returncode, done.stdout) == (2, "")
    assert "No such command 'nonsense'" in done.stderr


@pytest.mark.parametrize("place", ["derive.cli.commands.run_module", "derive.cli.run"])
def test_interrupt_prints_one_line_and_exits_with_130(place: str):
    module, _, name = place.rpartition(".")
    code = (
        "import importlib, os, signal, sys, time\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # a background job has no such handler
        f"setattr(importlib.import_module({module!r}), {name!r}, lambda *_: os.kill(os.getpid(), signal.SIGINT))\n"
        "from derive.__main__ import main\n"
        "sys.exit(main())"
    )
    done = in_a_process("show", "-n", "2", code=code)
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "dualcay: interrupted\n")


@pytest.mark.parametrize("encoding", ["cp1252", ""])
def test_output_is_utf8_in_any_locale(encoding: str):
    variables = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0", "PYTHONIOENCODING": encoding}
    done = in_a_process("show", "--help", **variables)
    assert (done.returncode, done.stderr) == (0, "")
    assert "v = tan(α/2n) u" in done.stdout


def test_folder_name_that_is_not_utf8_is_printed_unchanged(monkeypatch: pytest.MonkeyPatch):
    name = os.fsdecode(b"k\xff")
    monkeypatch.setattr("derive.codegen.build.check_charts", lambda folder, *_, **__: [Difference(folder, "missing")])
    done = dualcay("generate", "--check", "-o", name)
    assert (done.returncode, done.stdout) == (1, f"missing: {name}\n")


@pytest.mark.parametrize(
    "arguments",
    [["--help"], ["-h"], ["--version"], ["-V"], ["generate", "--help"], ["verify", "--help"], ["show", "--phi", "a#b"]],
)
def test_help_version_and_wrong_syntax_load_nothing_heavy(arguments: list[str]):
    code = (
        "import sys\nfrom derive.__main__ import NEEDED, main\ncode = main()\n"
        "sys.exit(10 * code + bool({'numpy', *NEEDED} - {'click'} & sys.modules.keys()))"
    )
    assert in_a_process(*arguments, code=code).returncode == (20 if "--phi" in arguments else 0)


def test_completion_offers_commands_and_names():
    code = "import sys; sys.argv[0] = 'dualcay'; from derive.__main__ import main; sys.exit(main())"
    for words, offered in (("dualcay gen", "plain,generate"), ("dualcay generate --target nu", "plain,numpy")):
        place = str(len(words.split()) - 1)
        done = in_a_process(code=code, _DUALCAY_COMPLETE="bash_complete", COMP_WORDS=words, COMP_CWORD=place)
        assert offered in done.stdout.splitlines()


WITHOUT = (
    "import importlib.util, sys\n"
    "found = importlib.util.find_spec\n"
    "importlib.util.find_spec = lambda name, *a: None if name in {missing} else found(name, *a)\n"
    "from derive.__main__ import main\n"
    "sys.exit(main())"
)


def test_missing_libraries_are_named_with_the_installation():
    done = in_a_process("list", code=WITHOUT.format(missing=("sympy", "jinja2")))
    assert done.returncode == 3
    said = 'dualcay: needs jinja2, sympy: install with  pip install ".[derive]"  in the folder of its source\n'
    assert done.stderr == said


@pytest.mark.parametrize("arguments", [(), ("--help",), ("-h",), ("generate", "--help"), ("--version",), ("-V",)])
def test_help_and_version_need_no_libraries(arguments: tuple[str, ...]):
    done = in_a_process(*arguments, code=WITHOUT.format(missing=NEEDED))
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("dualcay")
    assert derive.__version__ in done.stdout
    version = {"--version", "-V"} & set(arguments)
    assert ('pip install ".[derive]"' in done.stdout) == (not version)
    assert done.stdout.count("\n") <= 4


def test_names_of_the_toolkit_say_what_they_need():
    code = (
        "import sys\nfrom derive.__main__ import NEEDED\nsys.modules |= dict.fromkeys(NEEDED)\nimport derive\n"
        "for name in derive._HOMES:\n    try:\n        getattr(derive, name)\n"
        "    except ModuleNotFoundError as error:\n        print(error.name in NEEDED, error)"
    )
    lines = in_a_process(code=code).stdout.splitlines()
    assert len(lines) == len(derive._HOMES)
    assert all(line.startswith("True derive.") and 'pip install ".[derive]"' in line for line in lines)
