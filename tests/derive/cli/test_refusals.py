"""Refused commands: a message of a few lines, an exit code, nothing printed, nothing written, no work begun."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from derive.cli import commands
from docs.pages import field, proving
from proofs import rounding
from tests.support.command import dualcay

K10 = "verify --paper karakilic-2010 --eq"
MINE = "generate -o k --name mine --phi"
SHEET = "the sheet needs -o with an ending .html or .pdf"
DEVICES = ("con", "NUL", "aux", "com0", "Lpt9")

REFUSED = [
    ("generate -n 0", "an order is an integer n >= 1, got '0'"),
    ("generate -n 2.5", "expected orders such as 7 or 1-5,8, got '2.5'"),
    ("generate -n -3", "expected orders such as 7 or 1-5,8, got '-3'"),
    ("generate -n 5-2", "a range runs upwards over at most 10000 orders, got '5-2'"),
    ("generate -n 65 -o k", "order 65 is above the cap 64; raise it with --max-n"),
    ("generate -n 6 --max-n 5 -o k", "order 6 is above the cap 5"),
    ("generate -n 2 --target fortran", "'fortran' is not"),
    ("generate -n 2 --target c", "-o"),
    ("generate -n 2 -o ''", "expected a name, got an empty one"),
    ("show", "Missing option '-n'"),
    ("show -n 2 --what p,r", "expected names out of p, q, quaternion"),
    ("show --family lambert --what p", "only Cayley maps have p, not lambert"),
    ("show --family lamb", "a family is one of"),
    ("show --phi alpha**2", "not odd by its structure"),
    ("show --phi alpha²", "'²' (write ** for a power)"),
    ("show --what sheet", SHEET),
    ("show --what sheet -o sheet.txt", SHEET),
    ("show --what sheet -n 2 -o sheet.pdf", "no chart, no --format"),
    ("show --what sheet --format json -o sheet.pdf", "no chart, no --format"),
    ("show --what sheet,p -n 2", "or sheet alone, got 'sheet'"),
    ("show --what p -n 2 -o p.html", "add --what sheet"),
    ("compare --family none", "a family is one of"),
    ("compare --phi cos(alpha)", "not odd by its structure"),
    ("nonsense", "No such command 'nonsense'"),
    (f"{K10} 99", "no equation '99' (nearest: 9, 19, "),
    (f"{K10} 22,zero-component", "no equation 'zero-component' (nearest: zero-components, "),
    (f"{K10} 22 -o ''", "expected a name, got an empty one"),
    ("verify --paper euler-1776", "'karakilic-2010'"),
    ("verify --format pdf", "'markdown'"),
    ("verify -n 0", "an order is an integer n >= 1"),
    ("verify -n 65", "above the cap 64"),
    ("verify --check", "--check needs the file that -o names"),
    ("verify --data", "--data needs the file that -o names"),
    ("verify --claim 'v*v == 1' --let v=vector", "column 1"),
    ("check 'v*v == 1' --let v=vector", "column 1"),
    ("check paper.tex", "expected a claim, got the name of a file: dualcay verify paper.tex"),
    ("verify --claim 'v == v' --let v", "expected NAME=KIND"),
    ("verify --let v=vector", "belong to --claim"),
    ("verify --claim 'v == v' --let v=vectr", "expected vector"),
    ("verify a.toml --paper karakilic-2010", "one of"),
    ("generate -o k --phi alpha/2", "--phi and --name belong together"),
    ("generate -o k --name mine", "--phi and --name belong together"),
    (f"{MINE} 'alpha + 1'", "not odd by its structure"),
    (f"{MINE} '0*alpha'", "phi'(0) = 0.0, and has to be positive"),
    (f"""{MINE} "__import__('os').system('true')" """, "not understood in phi"),
    (f"{MINE} 'n*alpha'", "give its value, by -n or as order="),
    (f"{MINE} 'n*alpha' -n 2,3", "n in phi has one value"),
    (f"{MINE} 'alpha#c'", "not understood in phi: '#'"),
    (f"{MINE} 'alpha\n'", "not understood in phi"),
    (f"{MINE} 'alpha*tan(pi/2 - 1 - alpha**2)'", "poses that turn further, up to pi, have no v"),
    *((f"generate -o k --phi 'sin(alpha/3)' --name {shlex.quote(name)}", said) for name, said in (
        *((name, "with a leading underscore") for name in ("_native", "_tools", "_chart", "__main__", "_mine")),
        *((name, "is reserved in packages of kernels") for name in (
            "convert", "matrix6", "backend", "importlib", "sorted", "compiled", "geometry", "tiles", "Convert",
            "BACKEND", "Geometry",
        )),
        *((name, "is the name of a device on Windows") for name in DEVICES),
        *((name, "is the name of a committed module") for name in ("Cayley2", "lambert")),
        ("a" * 300, "a name has at most 100 letters, got 300"), ("not a name", "an identifier"),
        *((name, "would hide that of C") for name in ("math", "Time", "Python")),
        *((name, "the folder of rotations") for name in ("rotation", "Rotation_mine")),
        *((name, "is the name of the chart of phi = ")
          for name in ("cayley7", "Sine7", "sine7", "scaled7", "reduced_euler_rodrigues")),
    )),
]  # fmt: skip
"""Commands with a part of the message, of exit code 2."""


@pytest.mark.parametrize(
    ("code", "line", "message"), [*((2, *one) for one in REFUSED), (3, "verify a.toml", "a.toml: No such file")]
)
def test_refusal_is_a_message_and_an_exit_code(tmp_path: Path, code: int, line: str, message: str) -> None:
    done = dualcay(*shlex.split(line), cwd=tmp_path)
    assert (done.returncode, done.stdout) == (code, "")
    assert message in " ".join(done.stderr.split())
    assert done.stderr.count("\n") <= 5  # usage, hint at help, empty line, message of two lines at most
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("command", ["generate -n 2 -o", "verify -o", "compare -n 2 --plot"])
@pytest.mark.parametrize(
    ("place", "message"),
    [("file/in", "'file' is no folder"), ("file/a/b.svg", "'file' is no folder"), ("a" * 256, "at most 255 bytes")],
)
def test_a_place_where_nothing_can_be_written_is_refused_first(tmp_path: Path, monkeypatch, command, place, message):
    monkeypatch.setattr(commands, "run_module", lambda *_: pytest.fail("worked in vain"))
    (tmp_path / "file").write_text("mine")
    done = dualcay(*command.split(), place, cwd=tmp_path)
    assert done.returncode == 2
    assert message in done.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


NOWHERE = "/proc/self/fd/no/file.svg"  # root too can write nothing there


@pytest.mark.parametrize(
    ("code", "command", "work", "message"),
    [
        *((3, command, work, r"^dualcay: cannot write /proc/self/fd/no\S*: .+\n$") for command, work in (
            (f"generate -n 2 -o {NOWHERE}", "derive.codegen.build.prove"),
            (f"verify -o {NOWHERE}", "derive.cli.verify._of_papers"),
            (f"verify --claim 1==1 -o {NOWHERE}", "derive.cli.verify.check_sheets"),
            (f"compare -n 2 --plot {NOWHERE}", "derive.pages.comparison.compared"),
            (f"show --what sheet -o {NOWHERE.replace('svg', 'html')}", "derive.pages.sheet_files.page"),
        )),
        (2, "compare -n 2 --plot plot.xyz", "derive.pages.comparison.compared", "expected an ending out of"),
    ],
)  # fmt: skip
def test_what_cannot_be_written_is_refused_before_any_work(tmp_path, monkeypatch, code, command, work, message):
    monkeypatch.setattr(work, lambda *_, **__: pytest.fail("worked in vain"))
    done = dualcay(*command.split(), cwd=tmp_path)
    assert (done.returncode, list(tmp_path.iterdir())) == (code, [])
    assert re.search(message, done.stderr)


@pytest.mark.parametrize("module", [proving, field, rounding])
def test_a_page_that_cannot_be_written_is_refused_before_any_work(monkeypatch, capsys, module):
    for work in ("decided", "require"):
        monkeypatch.setattr(module, work, lambda *_, **__: pytest.fail("worked in vain"), raising=False)
    assert module.main(["-o", NOWHERE]) == 3
    assert capsys.readouterr().err.startswith("error: cannot write /proc/self/fd/no: ")
