"""What the command for witnesses writes, and that importing it writes nothing."""

from __future__ import annotations

import json
import runpy
import sys
from importlib import resources
from pathlib import Path

import pytest

import derive.papers
from derive.papers import PAPERS, equation, witnesses
from derive.papers.condurache_popa_2023.alphabet import LOST
from derive.papers.language.evaluation import let
from derive.papers.language.notation import Re, equal, nonzero, pm
from derive.papers.language.terms import Letter
from derive.papers.witnesses import witness

NAME = "derive.papers.witnesses"
a, b, q, w = (*(Letter(name, "real") for name in "ab"), Letter("q", "unit quaternion"), Letter("w", "number"))


class Small:
    """A paper with two entries."""

    slug, lost, package = "small", LOST, "small"

    @staticmethod
    def entries():
        return (equation("1", "title", 1, equal(a, a, 1 * a), said="in words"),
                equation("2", "title", 1, nonzero(1 + a * a), said="in words"))  # fmt: skip


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(derive.papers, "PAPERS", (Small(),))
    monkeypatch.setattr(resources, "files", lambda package: tmp_path)
    monkeypatch.delitem(sys.modules, NAME)
    return tmp_path


def test_the_command_writes_a_line_for_each_entry(folder: Path) -> None:
    runpy.run_module(NAME, run_name="__main__")
    text = (folder / "witnesses.json").read_text(encoding="utf-8")
    first, *lines, last = text.splitlines()
    assert (first, last, text[-1], len(lines)) == ("{", "}", "\n", 2)
    found = json.loads(text)
    assert list(found) == ["1", "2"]
    assert found["1"]["point"] == "generic point 1"
    assert found["1"]["values"] == [found["1"]["letters"]["a"]]
    assert found["2"]["values"] == [["true"]]


def test_importing_it_writes_nothing(folder: Path) -> None:
    runpy.run_module(NAME)
    assert list(folder.iterdir()) == []


def test_committed_files_are_written_that_way() -> None:
    for paper in PAPERS:
        path = Path(str(resources.files(paper.package).joinpath(witnesses.FILE)))
        lines = (
            f"{json.dumps(number)}: {json.dumps(w, ensure_ascii=False)}"
            for number, w in witnesses.committed(paper).items()
        )
        assert path.read_text(encoding="utf-8") == "{\n" + ",\n".join(lines) + "\n}\n"


# ---- one witness -----------------------------------------------------------------------------------------------------


def of(statement, **rest):
    return witness(Small(), equation("1", "title", 1, statement, said="in words", **rest))


def test_equal_sides_are_shown_once_and_others_each() -> None:
    statement = equal(a + b, b + a)
    found = of(statement)
    assert list(found) == ["point", "letters", "values"]
    assert list(found["letters"]) == ["a", "b"]
    total = sum(float(found["letters"][name][0]) for name in "ab")
    assert [[float(part) for part in side] for side in found["values"]] == [[pytest.approx(total, rel=1e-15)]]
    either = of(equal(pm(a), -a))["values"]
    assert [float(part) for (part,) in either] == pytest.approx([float(side) for (side,) in either])
    assert len(either) == 2


def test_the_point_lies_inside_of_the_domain() -> None:
    found = of(equal(w, 1 / a), where=[let(w, lambda env, a: 1 / a, a)], condition=nonzero(Re(a)))
    assert (found["point"], list(found["letters"])) == ("generic point 1", ["a"])
    found = of(equal(a * b, b), claimed=equal(b, 0), stated=(1, "for b = 0"))
    assert found["point"] == "b: 0"
    assert list(found["letters"]) == ["a", "b"]
    assert len(of(equal(q, q))["letters"]["q"]) == 8


def test_numbers_have_thirty_digits() -> None:
    ((value,),) = of(equal(a, a))["values"]
    assert len(value.removeprefix("-").removeprefix("0.")) <= 30 < len(value) + 4
