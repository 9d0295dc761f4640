"""Page on which a reader tries claims: answers without NumPy, threads and processes, and links that fill its form."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace as Namespace

import pytest
from docutils import nodes
from docutils.utils import new_document

from docs._ext import answers, in_browser, try_it

ALONE = """
import json, subprocess, sys, threading
sys.platform, PACKED = "emscripten", {*sys.stdlib_module_names, "derive", "answers", "flint", *sys.argv[1:]}
class Packed:
    def find_spec(name, path=None, target=None):
        if name.partition(".")[0] not in PACKED: raise ImportError(f"{name} is not packed")
def refuse(*arguments, **named): raise RuntimeError("a browser starts no thread and no process")
sys.meta_path.insert(0, Packed)
threading.Thread.start = subprocess.Popen.__init__ = refuse
import answers, derive
print(repr(derive.check("skew(v)*w == cross(v, w)", v="vector", w="vector")))
for question in json.loads(sys.stdin.read()): print(answers.answered(*question))
"""
"""Program that answers questions as in a browser."""

ASKED = [
    *(("decided", form) for form in try_it.examples().values()),
    *(("shown", {"chart": chart}) for chart in (*try_it.CHARTS, "alpha**2")),
    *(("printed", {"chart": try_it.CHARTS[1], "target": target}) for target in try_it.TARGETS if target),
]
UNREAD = [
    ("decided", {"letters": "v = vector", "claim": "norm(v"}, "claim, column 5: a claim is no expression: 'norm(v'"),
    ("decided", {"letters": "v = real; v = real", "claim": "v == v"}, "v is given twice"),
    ("decided", {"letters": "v", "claim": "v == v"}, "expected a name, = and a text, got 'v'"),
    ("shown", {"chart": "17"}, "the page takes orders up to 16; the command dualcay takes more"),
]
SHEET = """text = r'''
[letters]
v = "vector"
[[equation]]
number = "3"
claim = "v == -v"
'''
>>> derive.check("w == 1", w="real", domain="w > 0")
"""


@pytest.mark.parametrize("every", [4, pytest.param(1, marks=pytest.mark.thorough)])
def test_answers_need_only_what_is_packed(tmp_path: Path, every: int) -> None:
    for name, content in try_it.toolkit().items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_bytes(content)
    questions = [(name, json.dumps(form)) for name, form in ASKED[::every]]
    command = [sys.executable, "-c", ALONE, *try_it.LIBRARIES]
    env = {**os.environ, "DUALCAY_CACHE": str(tmp_path / "cache")}
    done = subprocess.run(command, cwd=tmp_path, input=json.dumps(questions), capture_output=True, text=True, env=env)
    assert done.stderr == ""
    assert not (tmp_path / "cache").exists()
    checked, *found = done.stdout.splitlines()
    assert checked == "<Result holds>"
    for line, question in zip(found, questions, strict=True):
        assert json.loads(line) == json.loads(answers.answered(*question)), question


@pytest.mark.parametrize(("name", "form", "error"), UNREAD)
def test_what_cannot_be_read_is_said(name: str, form: dict[str, str], error: str) -> None:
    assert json.loads(answers.answered(name, json.dumps(form))) == {"errors": [error]}


def test_every_claim_of_the_reports_fills_a_form_that_is_read() -> None:
    assert [place for place, form in in_browser.claims().items() if not answers.read(form)[0].entries()] == []


def test_links_stand_beside_entries_and_below_claims() -> None:
    page, (first, second) = new_document("page"), ("kindr-411", "vslam-handbook-205")
    cell = nodes.entry("", nodes.raw("", f'<a id="{second}">', format="html"))
    page += [nodes.paragraph("", "", ids=[first]), nodes.paragraph("", "", ids=["other"]), cell]
    page += nodes.literal_block("", SHEET)
    in_browser.add_links(Namespace(env=Namespace(current_document=Namespace(docname="field"))), page)
    claims = ["letters=v+%3D+vector&claim=v+%3D%3D+-v", "letters=w+%3D+real&claim=w+%3D%3D+1&domain=w+%3E+0"]
    found = re.findall(r'href="try.html\?(.*?)"', page.astext().replace("&amp;", "&"))
    assert found == [f"entry={first}", f"entry={second}", *claims]


def test_page_without_pyodide_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(try_it, "ENGINE", tmp_path / "assets" / "engine")
    try_it.pack()
    assert '"files": []' in try_it.page()
