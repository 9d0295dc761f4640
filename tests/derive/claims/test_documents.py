"""Documents with claims in comments: every format says the same, places are exact, hostile files end with an error."""

from __future__ import annotations

import json
import os
import tomllib
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import pytest

import derive
from derive.claims.documents import READERS, content
from derive.claims.documents.comments import PARTS_MAX
from derive.claims.documents.files import BYTES_MAX, DEPTH_MAX, FILES_MAX, SheetError
from derive.claims.draft import draft
from derive.claims.language.claims import ROW_MAX
from derive.claims.sheet import BYTES_MAX as SHEET_MAX
from derive.claims.sheet import EQUATIONS_MAX, MESSAGE_MAX, load
from derive.output.shown import seen
from tests.support.command import dualcay

Say = Callable[[str, str], str]


def written(folder: Path, name: str, text: str | bytes) -> Path:
    file = folder / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(text if isinstance(text, bytes) else text.encode())
    return file


def environment(name: str) -> Say:
    return lambda label, latex: rf"\begin{{{name}}}\label{{{label}}}{chr(10)}  {latex}{chr(10)}\end{{{name}}}"


def of_lines(sign: str) -> Callable[..., str]:
    return lambda *lines: "\n".join(f"{sign} dualcay: {line}" if i == 0 else f"{sign}    {line}"
                                    for i, line in enumerate(lines))  # fmt: skip


def in_html(*lines: str) -> str:
    return f"<!-- dualcay: {chr(10).join(lines)} -->"


def in_rest(*lines: str) -> str:
    return "\n\n.. dualcay: " + "\n   ".join(lines) + "\n"


TEX = {name: environment(name) for name in ("equation", "equation*", "align", "gather*", "multline", "eqnarray")} | {
    "alignat": lambda label, latex: rf"\begin{{alignat}}{{2}}\label{{{label}}} {latex} \end{{alignat}}",
    "of three": lambda label, latex: rf"\begin{{IEEEeqnarray*}} {{rCl}}{latex}\label{{{label}}}\end{{IEEEeqnarray*}}",
    "bracket": lambda label, latex: rf"\[ {latex} \label{{{label}}} \]",
    "dollars": lambda label, latex: f"text $a$ $${latex}\\label{{{label}}}$$ text",
}  # fmt: skip
MARKDOWN = {
    "dollars": lambda label, latex: f"$$\n{latex}\n$$ ({label})",
    "fence": lambda label, latex: f"```math\n{latex} \\label{{{label}}}\n```",
    "pandoc": lambda label, latex: f"$${latex}$$ {{#{label}}}",
    "myst": lambda label, latex: f"```{{math}}\n:label: {label}\n{latex}\n```",
    "colon": lambda label, latex: f":::{{math}}\n---\nlabel: {label}\n---\n{latex}\n:::",
    "align": environment("align"),
}
REST = {
    "block": lambda label, latex: f"\n.. math::\n   :label: {label}\n\n   {latex}\n",
    "line": lambda label, latex: f"\n.. math:: {latex}\n   :label: {label}\n",
}  # fmt: skip
WAYS = [
    *((".tex", say, of_lines("%")) for say in TEX.values()), *((".md", say, in_html) for say in MARKDOWN.values()),
    *((".rst", say, in_rest) for say in REST.values()), *((".ipynb", say, in_html) for say in MARKDOWN.values()),
    (".ipynb", MARKDOWN["dollars"], of_lines("#")),
]  # fmt: skip
PASSED_OVER = {
    ".tex": "\\verb|$$| \\$$\n% \\begin{equation}\n\\begin{verbatim}\n\\[ x \\]\n% dualcay: claim 1\n\\end{verbatim}\n"
            "\\newcommand{\\be}{\\begin{equation}}\n\\iffalse\n$$x$$\n% dualcay: claim 1\n\\fi\n",
    ".md": "`$$` \\$$ <!-- $$ -->\n```tex\n$$\n<!-- dualcay: claim 1 -->\n```\n~~~\n```math\n~~~\n",
    ".rst": "Code::\n\n   .. math:: x\n   .. dualcay: claim 1\n\n.. code-block:: rst\n\n   .. math:: x\n",
}


def document(suffix: str, parts: list[str]) -> str:
    """Return the text of a document; in a notebook, a part that begins with # is a cell of code."""
    if suffix != ".ipynb":
        return PASSED_OVER[suffix] + "\n" + "\n".join(parts)
    kinds = [("code" if part.startswith("#") else "markdown", part) for part in (PASSED_OVER[".md"], *parts)]
    cells = [{"cell_type": kind, "source": part.splitlines(keepends=True)} for kind, part in kinds]
    return json.dumps({"nbformat": 4, "cells": [{"cell_type": "raw", "source": "$$x$$"}, *cells]}, indent=1)


@pytest.mark.parametrize("number", range(len(WAYS)))
def test_every_format_and_display_says_the_same_at_its_lines(number: int, tmp_path: Path) -> None:
    suffix, say, comment = WAYS[number]
    parts = [comment("letters v = vector; w[k] = vector"), comment("definition G(w) = I", "+ skew(w)"),
             say("a:1", "u = v_1"), comment("claim G(v) ==", "zz"), comment("domain v != 0"), say("b", "w = x"),
             say("c", "y = 2"), comment("remark Of [c]; as said"), comment("claim [b] v == v")]  # fmt: skip
    file = written(tmp_path, f"paper{suffix}", document(suffix, parts))
    tables, wrong = content(file)
    assert not wrong
    assert tables["letters"] == {"v": "vector", "w[k]": "vector"}
    assert {head: text.split() for head, text in tables["definitions"].items()} == {"G(w)": ["I", "+", "skew(w)"]}
    rows = tables["equation"]
    assert [(row["number"], row["latex"]) for row in rows] == [("a:1", "u = v_1"), ("b", "w = x"), ("c", "y = 2")]
    assert (rows[0]["claim"].split(), rows[0]["domain"]) == (["G(v)", "==", "zz"], "v != 0")
    assert (rows[1]["claim"], rows[2]["remark"]) == ("v == v", "Of [c]; as said")
    lines = file.read_text().split("\n")
    for row, latex in zip(rows, ("u = v_1", "w = x", "y = 2"), strict=True):
        name, _, line = row["at"].rpartition(":")
        assert name == str(file)
        below = lines[int(line) - 1 : int(line) + 4]
        assert any(latex in text for text in below), below
    problem = next(problem for problem in load(file).problems if "'zz'" in problem.message)
    assert (problem.file, problem.equation) == (str(file), "equation a:1")
    assert lines[(problem.line or 0) - 1].find("zz") >= 0
    if suffix != ".ipynb":
        assert lines[(problem.line or 0) - 1][(problem.column or 0) - 1 :].startswith("zz")
    assert [row["number"] for row in load(file).unread] == ["c"]


ROWS = r"""\begin{align} % dualcay: claim 1
  a &= [b] \label{one} \\[2pt] % dualcay: claim 1b
  % dualcay: domain 1
  \begin{bmatrix} a \\ b \end{bmatrix} &= c \\ % dualcay: claim 2
    &= d \label{two} \nonumber \\

  e &= f % dualcay: claim 3
\end{align}
% dualcay: claim [one] 1c
% dualcay: domain 3
$$a$$ $$b$$
\end{document}
$$c$$
% dualcay: claim 4
"""


def test_rows_of_an_environment_are_equations_with_the_comments_after_their_first_sign(tmp_path: Path) -> None:
    tables, wrong = content(written(tmp_path, "a.tex", ROWS))
    found = [(row["number"], row["at"].rpartition(":")[2], row.get("claim"), row.get("domain"))
             for row in tables["equation"]]  # fmt: skip
    assert found == [("one", "2", "1", "1"), ("two", "4", "2", None), ("line 7", "7", "3", "3"),
                     ("line 11", "11", None, None), ("line 11 (2)", "11", None, None)]  # fmt: skip
    assert [error.at[1] for _, error in wrong if error.at] == [2, 9]
    assert all("has a claim already" in error.message for _, error in wrong)


COMMENTS = [
    (": clam a == b", "expected letters, definition, claim"), (":", "got ''"), (": letters v", "expected a name"),
    (": letters v = vectr", "no kind 'vectr'"), (": letters v = real; v = vector", "v has another meaning in line 3"),
    (": definition G(v = v", "a definition is a name"), (": definition G = 2 +", "is no expression"),
    (": claim", "expected a text after claim"),
    (": claim [nowhere] 1 == 1", "no equation with the label nowhere"), (": claim x ==== 1", "is no expression"),
    (": claim __import__('os').system('true') == 1", "not understood"),
    (" claim 1 == 1", "expected a colon"), ("\tletters v = real", "expected a colon"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "message"), COMMENTS)
def test_wrong_comment_is_a_problem_at_its_line(text: str, message: str, tmp_path: Path) -> None:
    file = written(tmp_path, "a.tex", f"$$1 = 1$$\n\n% dualcay{text}\n")
    problem = load(file).problems[0]
    assert (problem.file, problem.line) == (str(file), 3)
    assert message in str(problem)


def test_comment_before_all_equations_has_none_and_is_no_unread_equation(tmp_path: Path) -> None:
    file = written(tmp_path, "a.tex", "% dualcay: claim 1 == 1\n$$1 = 1$$")
    done = dualcay("verify", str(file))
    assert "no displayed equation stands before" in done.stderr
    assert done.stdout.endswith("0 decided, 1 unread, 1 not understood\n")
    assert "paper" not in done.stdout, "a table of nothing"


OUTSIDE = ("../other/out", "sub/../../other/out", "/etc/passwd", "C:/a", r"\jobname", "", "link", "folder/out", "none",
           "paper", "loop", "pipe", "a" * 5000)  # fmt: skip


@pytest.mark.parametrize("name", OUTSIDE)
@pytest.mark.parametrize("command", ["input", "include"])
def test_files_outside_and_loops_are_refused_at_their_line(command: str, name: str, tmp_path: Path) -> None:
    folder = tmp_path / "in"
    outside = written(tmp_path / "other", "out.tex", "$$secret$$")
    file = written(folder, "paper.tex", f"$$a$$ \\input{{sub/two}} $$c$$\n\\{command}{{{name}}}\n")
    written(folder, "sub/two.tex", "\n$$b$$")
    written(folder, "loop.tex", r"\input{loop}")
    (folder / "link.tex").symlink_to(outside)
    (folder / "folder").symlink_to(outside.parent)
    os.mkfifo(folder / "pipe.tex")
    tables, [(_, error)] = content(file)
    assert [row["latex"] for row in tables["equation"]] == ["a", "b", "c"]
    assert tables["equation"][1]["number"] == "sub/two.tex line 2"
    assert tables["equation"][1]["at"] == f"{folder / 'sub' / 'two.tex'}:2"
    assert error.at == ((str(folder / "loop.tex"), 1) if name == "loop" else (str(file), 2))


MANY = 100_000
HOSTILE = {
    "displays.tex": ("$$a$$\n" * MANY, f"at most {PARTS_MAX} displayed"), "empty.rst": ("", "no displayed"),
    "bytes.tex": (b"a" * (BYTES_MAX + 1), str(BYTES_MAX)), "tree.toml": ("#" * (SHEET_MAX + 1), str(SHEET_MAX)),
    "comments.tex": ("$$a$$\n" + "% dualcay: claim a\n" * MANY, f"at most {PARTS_MAX}"),
    "claims.tex": ("$$a$$\n% dualcay: claim 1 == 1\n" * (EQUATIONS_MAX + 1), f"at most {EQUATIONS_MAX} equations"),
    "binary.tex": (bytes(range(256)) * 999, "expected UTF-8"), "zero.md": ("$$a\0$$", "0x0"),
    "open.tex": ("\\begin{equation}\n" + "a\n" * MANY, "open.tex:1: no displayed equation; equation begins in"),
    "dollars.md": ("$$\n" * (MANY + 1), f"begins in line {MANY + 1} and has no"),
    "fence.md": ("```math\na", "a block math begins in line 1"),
    "files.tex": ("\\input{none}" * MANY, f"at most {FILES_MAX} files"),
    "tree.tex": ("\\input{tree1}\\input{tree1}", f"at most {FILES_MAX} files"),
    "deep.ipynb": ("[" * MANY, "not JSON"), "cut.ipynb": ('{"nbformat": 4, "cells": [', "not JSON"),
    "old.ipynb": ('{"nbformat": 3, "cells": []}', "expected a notebook"), "list.ipynb": ("[]", "expected a notebook"),
    "cell.ipynb": ('{"nbformat": 4, "cells": [3]}', "expected a notebook"),
    "source.ipynb": ('{"nbformat": 4, "cells": [{"source": [3]}]}', "is no text"),
    "digits.ipynb": ("1" * MANY, "not JSON"),
}  # fmt: skip


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_file_is_one_line(name: str, tmp_path: Path) -> None:
    text, message = HOSTILE[name]
    for i in range(1, DEPTH_MAX):
        written(tmp_path, f"tree{i}.tex", f"\\input{{tree{i + 1}}}" * 2)
    file = written(tmp_path, name, text)
    with pytest.raises(SheetError, match=f"^{file}:") as error:
        load(file)
    assert message in str(error.value)
    assert "\n" not in str(error.value)
    done = dualcay("verify", str(file))
    assert (done.returncode, done.stdout) == (2, "")


LONG = ["$$a" + "=b" * MANY, "$$a$$" + "\\verb|" * MANY, "$" * MANY * 2, "\\begin" * MANY, "\\label{" * MANY,
        "\\begin{align}" + "{" * MANY, "\\begin{align}" + "\\\\[" * 900 + "a" * MANY, "`" * MANY, "<!--" * MANY,
        ":" * MANY, " " * MANY, "%" + " " * 9 * MANY + "x", "<!-- #" + " " * 9 * MANY + "x -->"]  # fmt: skip


@pytest.mark.parametrize("suffix", READERS)
def test_huge_lines_are_read(suffix: str, tmp_path: Path) -> None:
    for text in LONG:
        whole = json.dumps({"nbformat": 4, "cells": [{"cell_type": "markdown", "source": text}]})
        file = written(tmp_path, f"a{suffix}", whole if suffix == ".ipynb" else f"{text}\n$$z$$\n\n.. math:: z\n")
        with suppress(SheetError):  # such as for a display that does not end
            assert content(file)[0]["equation"]


@pytest.mark.parametrize(("each", "message"), [("{} + 1", f"at most {ROW_MAX} definitions"), ("{}" + " + 1" * 15, "")])
def test_definitions_in_a_long_row_are_a_problem_at_the_claim(each: str, message: str, tmp_path: Path) -> None:
    rows = (f"% dualcay: definition d{i + 1} = {each.format(f'd{i}')}" for i in range(2 * ROW_MAX))
    lines = ("% dualcay: letters d0 = real", *rows, "$$d_{100} = 1$$ $$1$$", f"% dualcay: claim d{2 * ROW_MAX} == 1")
    file = written(tmp_path, "a.tex", "\n".join(lines))
    (problem,) = load(file).problems
    assert (problem.file, problem.line) == (str(file), len(lines))
    assert message in problem.message
    assert "latex = 'd_{100} = 1'\nclaim = \"\"  # not understood: " in draft(file, {})[0]


def test_messages_are_short(tmp_path: Path) -> None:
    file = written(tmp_path, "a.tex", f"$$1 = 1$$\n% dualcay: letters v = {'vector ' * MANY}")
    assert len(str(load(file).problems[0])) < MESSAGE_MAX + 999


HARM = "\x1b]0;a\x07\x9b31m\u202e\u2066\n::error::x\ud800\0\x7f[/x]"
"""Signs that a terminal or a workflow may obey, that turn the order of text, or that no file can hold."""


@pytest.mark.parametrize("form", ["text", "html", "json", "github"])
@pytest.mark.parametrize("suffix", [".ipynb", ".toml"])
def test_no_sign_of_a_document_does_more_than_be_seen(suffix: str, form: str, tmp_path: Path) -> None:
    said = ["$$x\n\\label{" + HARM + "}$$\n", "<!-- dualcay: letters x = real -->\n", "$$y\\label{b}" + HARM + "$$\n",
            "<!-- dualcay: claim x == 1 -->\n<!-- dualcay: remark " + HARM + "-->",
            f"<!-- dualcay: claim [{HARM}] y == 1 -->"]  # fmt: skip
    text = json.dumps({"nbformat": 4, "cells": [{"cell_type": "markdown", "source": said}]})
    if suffix == ".toml":
        name = json.dumps(HARM.replace("\ud800", "")).replace("\x7f", "\\u007f").replace("\x9b", "\\u009b")
        row = "[[equation]]\nnumber = {}\nclaim = '{} == 1'\nlatex = {}\nremark = {}\n"
        text = f"[paper]\nshort = {name}\n[letters]\nx = 'real'\n"
        text += row.format(name, "y", name, name) + row.format(name[:-1] + 'b"', "x", name, name)
    file = written(tmp_path, f"a{suffix}", text)
    done = dualcay("verify", file.name, "--format", form, cwd=tmp_path)
    assert done.returncode == 2
    assert "false" in done.stdout
    printed = [done.stdout, done.stderr]
    if suffix == ".ipynb" and form == "text":
        printed.append(draft(file, {})[0])
        assert [row["number"] for row in tomllib.loads(printed[-1])["equation"]][1] == "b"
    for out in printed:
        assert out == seen(out)
    assert not any(line.lstrip().startswith("::") for line in done.stderr.splitlines())


def test_false_claim_hidden_in_forty_equations_is_found_with_its_line(tmp_path: Path) -> None:
    lines = ["% dualcay: letters x = real", r"\input{rest}"]
    for i in range(40):
        lines += ["", rf"\begin{{equation}}\label{{eq:{i}}}", rf"  x + {i} = {i} + x", r"\end{equation}",
                  f"% dualcay: claim x + {i} == {i + (i == 23)} + x"]  # fmt: skip
    written(tmp_path, "rest.tex", "\\[ x = y \\]\n$$ \\hat x $$\n")
    file = written(tmp_path, "paper.tex", "\n".join(lines))
    done = dualcay("verify", file.name, "--format", "json", cwd=tmp_path)
    data = json.loads(done.stdout)
    false = [row for row in data["equations"] if row["status"] == "false"]
    assert [(row["equation"], row["at"]) for row in false] == [("eq:23", f"paper.tex:{3 + 5 * 23 + 1}")]
    assert [row["at"] for row in data["unread"]] == ["rest.tex:1", "rest.tex:2"]
    assert (done.returncode, len(data["equations"])) == (0, 40)
    text = dualcay("verify", file.name, "--eq", "eq:23,rest.tex line 2", cwd=tmp_path).stdout
    assert text.endswith("1 decided, 1 unread: 1 false\n")
    assert [str(result.status) for result in derive.verify(file, "eq:0")] == ["holds"]
