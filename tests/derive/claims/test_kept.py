"""Results kept from run to run: what decides a claim, broken files, full folders, parallel and killed runs."""

from __future__ import annotations

import os
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from derive.claims import kept, run
from derive.claims.report import FORMATS, Report
from derive.claims.result import undecided
from derive.claims.sheet import Sheet, sheet
from tests.support.command import dualcay, in_a_process

ROWS = {
    "1": 'claim = "G(v)*w == w + cross(v, w)"', "2": 'claim = "x**2/x == x"\ndomain = "norm(x) < 3"',
    "3": 'claim = "cross(v, w) == cross(w, v)"',
    "4": 'claim = "dot(omega, w) == dot(v, w)"\ncorrected = "dot(omega, w) == 2*dot(v, w)"',
}  # fmt: skip
TEXT = '[letters]\nv = "vector"\nw = "vector"\nx = "real"\n'
TEXT += '[definitions]\n"G(w)" = "I + skew(w)"\n"H(u)" = "2*u"\nomega = "2*v"\n'
TEXT += "\n".join(f'[[equation]]\nnumber = "{number}"\n{row}' for number, row in ROWS.items())
STATED = """[paper]\nconditions = "stated"\n[letters]\nx = "real"\n[[equation]]\nnumber = "5"\nline = 3\nsaid = "square"
reading = [{ claim = "x**2 == x" }, { claim = "x*x == x**2", note = "other" }]"""
ALL = ["1", "2", "3", "4"]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv(kept.VARIABLE, str(tmp_path / "cache"))
    return tmp_path / "cache"


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Let each claim be undecided at once, and the process of equation 3 die; return the numbers asked for."""
    numbers: list[str] = []

    def decide(worker: object, sheet: Sheet, place: int, seconds: float) -> tuple[object, bool]:
        numbers.append((entry := sheet.entries()[place]).number)
        return undecided(sheet.slug, entry, "no"), entry.number != "3"

    monkeypatch.setattr(run._Worker, "decide", decide)
    return numbers


def again(asked: list[str], text: str = TEXT, seconds: float = 60.0) -> list[str]:
    """Return the numbers that are asked for when a text is decided."""
    asked.clear()
    assert len(run.check_sheets([sheet(text, "a.toml")], seconds=seconds, keep=True)) == 4
    return sorted(asked)


@pytest.mark.parametrize("text", [TEXT, STATED])
def test_a_second_run_decides_nothing_and_gives_the_same_bytes_in_every_format(folder: Path, monkeypatch, text: str):
    read = sheet(text, "a.toml")
    fresh, first = run.check_sheets([read]), run.check_sheets([read], keep=True)
    monkeypatch.setattr(run._Worker, "decide", lambda *_: pytest.fail("decided again"))
    second = run.check_sheets([read], keep=True)
    assert fresh == first == second
    for form in FORMATS.values():
        assert len({form(Report.of([read], results, ())) for results in (fresh, first, second)}) == 1
    assert len({result.status for result in second}) == len(second)


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("", "", ["3"]),
        ('"1"\n', '"1"\nat = "b.tex:3"\ntitle = "t"\nremark = "r"\nlatex = "x"\nproposed = true\n', ["3"]),
        ('"1"', '"7"', ["3", "7"]), ("w + cross", "w - cross", ["1", "3"]), ("norm(x) < 3", "norm(x) < 4", ["2", "3"]),
        ('domain = "norm(x) < 3"', "", ["2", "3"]), ("== 2*dot", "== 3*dot", ["3", "4"]), ("I + skew", "I - skew", ALL),
        ("x**2/x == x", "H(x) == x + x", ["2", "3"]), ("x**2/x == x", "H(v) == v + v", ["2", "3"]),
        ('x = "real"', 'x = "positive"', ["2", "3"]), ('x = "real"', 'x = "constant real"', ["2", "3"]),
    ],
)  # fmt: skip
def test_what_decides_a_claim_and_nothing_else_has_it_decided_again(folder: Path, asked, old, new, expected):
    assert (again(asked), again(asked, TEXT.replace(old, new))) == (ALL, expected)


def test_limit_and_toolkit_decide_too(folder: Path, asked, monkeypatch):
    assert again(asked) == again(asked, seconds=2.0) == ALL
    assert again(asked) == again(asked, seconds=2.0) == ["3"]
    monkeypatch.setattr(kept, "toolkit", lambda: "another")
    assert again(asked) == ALL


WRONG = ['{"status": "holds"}', "[]", "3", '{"verdicts": [{"statement": 9}]}']


@pytest.mark.parametrize(
    "spoil",
    [
        lambda path, old, other: b"", lambda path, old, other: old[:-2], lambda path, old, other: other,
        lambda path, old, other: old.replace(b'"no"', b'"on"'), lambda path, old, other: old + b"\xff",
        lambda path, old, other: old.partition(b"\n")[2], lambda path, old, other: old + b" " * kept.FILE_MAX,
        *(lambda path, old, other, text=text: f"{kept._mark(path, text)}\n{text}".encode() for text in WRONG),
    ],
)  # fmt: skip
def test_broken_files_are_decided_again_and_replaced(folder: Path, asked, spoil):
    again(asked)
    files = {path: path.read_bytes() for path in folder.rglob("*.json")}
    for path, other in zip(files, (*list(files.values())[1:], b"x"), strict=True):
        path.write_bytes(spoil(path, files[path], other))
    assert again(asked) == ALL
    assert {path: path.read_bytes() for path in folder.rglob("*.json")} == files


@pytest.mark.parametrize("shift", range(3))
def test_the_folder_is_bounded_and_what_was_not_needed_goes_first(folder: Path, asked, monkeypatch, shift: int):
    again(asked)
    for place, path in enumerate(sorted(folder.rglob("*.json"))):
        os.utime(path, ((place + shift) % 3, (place + shift) % 3))
    monkeypatch.setattr(kept, "BYTES_MAX", 3 * kept.BLOCK)
    altered = TEXT.replace("w + cross", "w - cross")
    assert [again(asked, altered), again(asked, altered)] == [["1", "3"], ["3"]]
    assert len(list(folder.rglob("*.json"))) == 3


@pytest.mark.parametrize("place", ["/proc/self/fd/no", __file__, ""])
def test_without_a_folder_to_write_claims_are_decided(asked, monkeypatch, place: str):
    monkeypatch.setenv(kept.VARIABLE, place)
    assert again(asked) == again(asked) == ALL


RUN = """
import os, signal, sys
from derive.claims import run
from derive.claims.result import undecided
from derive.claims.sheet import sheet
moves, replace = [], os.replace
def dying(*names):
    moves.append(names)
    if len(moves) == int(sys.argv[1]):
        os.kill(os.getpid(), signal.SIGKILL)
    replace(*names)
os.replace = dying
run._Worker.decide = lambda w, s, i, t: (undecided(s.slug, s.entries()[i], "no"), True)
row = '[[equation]]\\nnumber = "%d"\\nclaim = "x == %d"\\n'
text = '[letters]\\nx = "real"\\n' + "".join(row % (i, i) for i in range(40))
print(len(run.check_sheets([sheet(text, "a.toml")], keep=True)), len(moves))
"""


def test_parallel_and_killed_runs_leave_whole_files(folder: Path):
    with ThreadPoolExecutor() as pool:
        done = [*pool.map(lambda at: in_a_process(str(at), code=RUN), (0, 0, 5, 10))]
    assert {one.stdout.split()[0] for one in done if one.returncode == 0} == {"40"}
    assert in_a_process("0", code=RUN).stdout == "40 0\n"


@pytest.mark.parametrize(
    ("platform", "variables", "expected"),
    [("linux", {"XDG_CACHE_HOME": "x"}, "/h/.cache/dualcay"), ("linux", {"XDG_CACHE_HOME": "/x"}, "/x/dualcay"),
     ("darwin", {"XDG_CACHE_HOME": "/x"}, "/h/Library/Caches/dualcay"), ("win32", {"LOCALAPPDATA": "/l"}, "/l/dualcay"),
     ("win32", {}, "/h/AppData/Local/dualcay"), ("linux", {kept.VARIABLE: "here"}, "here")],
)  # fmt: skip
def test_folders_of_platforms(monkeypatch, platform, variables, expected):
    monkeypatch.delenv(kept.VARIABLE)
    monkeypatch.setattr(sys, "platform", platform)
    for name, value in {"HOME": "/h", "XDG_CACHE_HOME": "", **variables}.items():
        monkeypatch.setenv(name, value)
    assert kept.folder() == Path(expected)


def test_the_command_keeps_results_of_files_unless_told_and_none_of_the_papers(folder: Path, tmp_path: Path):
    (tmp_path / "a.toml").write_text(TEXT)
    dualcay("verify", str(tmp_path / "a.toml"), "--eq", "1", "--no-cache")
    dualcay("verify", "--paper", "karakilic-2010", "--eq", "22")
    assert not folder.exists()
    dualcay("verify", str(tmp_path / "a.toml"), "--eq", "1")
    assert len(list(folder.rglob("*.json"))) == 1
