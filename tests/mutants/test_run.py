"""What a test kills is said to be killed, what none can kill to survive; a run goes on where it was stopped."""

from __future__ import annotations

import os
import shutil
import subprocess
from contextlib import ExitStack
from pathlib import Path

import pytest

from tests.mutants import checks, report
from tests.mutants.__main__ import main
from tests.mutants.checks import Checks
from tests.mutants.child import Child, isolated, outcomes
from tests.mutants.knowledge import NotControlled
from tests.mutants.mutant import KILLED, SURVIVED, Fate
from tests.mutants.past import Past, known
from tests.mutants.programs import FORMS, Programs
from tests.mutants.record import Record, read
from tests.mutants.rooms import Files
from tests.mutants.run import Run
from tests.mutants.tree import Deciding

# another test of this process may have imported JAX, which warns of every fork; what is forked here does without it
pytestmark = [pytest.mark.thorough, pytest.mark.filterwarnings("ignore:os.fork:RuntimeWarning")]

THING = "def double(a):\n    return 2 * a\n\n\ndef forgotten(a):\n    return a + 1\n"
TEST = "from derive.toy.thing import double\n\n\ndef test_double():\n    assert double(3) == 6\n"
MORE = "from derive.toy.thing import forgotten\n\n\ndef test_forgotten():\n    assert forgotten(3) == 4\n"
ROOM = Files("toy", "toys: by their tests", ("derive/toy",), Checks("toy", ("derive/toy",), ("tests/derive/toy",)))


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    """A small project: one function with a test, one without."""
    texts = {
        "pyproject.toml": '[tool.pytest.ini_options]\npythonpath = ["."]\n',
        "derive/__init__.py": "",
        "derive/toy/__init__.py": "",
        "derive/toy/thing.py": THING,
        "tests/derive/toy/test_thing.py": TEST,
    }
    for name, text in texts.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    subprocess.run(["git", "init", "--quiet"], cwd=tmp_path, check=True)
    return tmp_path


def run(tree: Path, count: int = 100) -> Record:
    (record,) = Run(tree, tree / ".mutants", "here", seed=1, count=count, jobs=2, say=lambda line: None).rooms([ROOM])
    return record


def killers(record: Record) -> set[str]:
    return {trial.fate.by for trial in record.trials.values() if trial.fate.kind == KILLED}


def test_killed_ones_are_killed_and_survivors_survive(tree: Path) -> None:
    record = run(tree)
    assert killers(record) == {"tests/derive/toy/test_thing.py::test_double"}
    assert {trial.where for trial in record.survivors} == {"derive/toy/thing.py:6"}
    assert "a + 1 → a - 1" in {trial.change for trial in record.survivors}
    assert (tree / "derive/toy/thing.py").read_text(encoding="utf-8") == THING
    score = report.score(record)
    assert (score.killed["tests"], score.others[SURVIVED]) == (6, 5)
    assert score.share == pytest.approx(100 * 6 / 11)
    page = report.page([record], {ROOM.name: ROOM})
    assert "| derive/toy/thing.py:6 | arithmetic operation | `a + 1 → a - 1` |" in page
    assert "5 survive" in page
    assert "Never measured" not in page
    assert "Never measured: attic." in report.page([record], {ROOM.name: ROOM, "attic": ROOM})


def test_long_tests_are_asked_last_and_longer_ones_left_out(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    quick = run(tree)
    monkeypatch.setattr(checks, "LONG", -1.0)
    shutil.rmtree(tree / ".mutants")
    assert run(tree).trials == quick.trials
    monkeypatch.setattr(checks, "TOO_LONG", -1.0)
    shutil.rmtree(tree / ".mutants")
    with pytest.raises(NotControlled, match=r"no test .* can be used: .*takes long.*test_thing\.py::test_double"):
        run(tree)


def test_a_run_goes_on_where_it_stopped_until_the_tree_changes(tree: Path) -> None:
    first = run(tree, 4)
    (kept,) = (tree / ".mutants").rglob("toy.jsonl")
    (looked,) = (tree / ".mutants").rglob("checks-toy-*.pickle")
    found = looked.stat().st_mtime_ns
    lines = kept.read_text(encoding="utf-8").splitlines()
    kept.write_text("\n".join(lines[:3]) + "\n", encoding="utf-8")
    assert run(tree, 4) == first
    assert looked.stat().st_mtime_ns == found
    again = kept.read_text(encoding="utf-8").splitlines()
    assert again[:3] == lines[:3]
    assert len(again) == len(lines)
    (tree / "tests/derive/toy/test_thing.py").write_text(TEST + "\n# changed\n", encoding="utf-8")
    assert run(tree, 4).trials == first.trials
    assert len(list((tree / ".mutants").rglob("toy.jsonl"))) == 2


def test_a_new_file_of_tests_is_asked_of_survivors_alone_and_other_fates_stand(tree: Path) -> None:
    first = run(tree)
    (tree / "tests/derive/toy/test_more.py").write_text(MORE, encoding="utf-8")
    second = run(tree)
    assert killers(second) == {*killers(first), "tests/derive/toy/test_more.py::test_forgotten"}
    assert not second.survivors
    kept = max((tree / ".mutants").rglob("toy.jsonl"), key=lambda path: path.stat().st_mtime)
    tried = kept.read_text(encoding="utf-8").splitlines()[1:]
    assert len(tried) == len(first.survivors) + 1, "they, and the unchanged tree"
    assert run(tree) == second


def test_a_fate_stands_as_long_as_what_decided_it_is_the_same() -> None:
    before = Deciding("base", {"tests/test_a.py": "1", "tests/test_b.py": "1"})
    killed = {"a": Fate(KILLED, "tests", "tests/test_a.py::test"), "b": Fate(KILLED, "tests", "tests/test_b.py::test"),
              "proved": Fate(KILLED, "proof", "n = 1"), "alive": Fate(SURVIVED)}  # fmt: skip
    past = Past(before, {"takes long": ["tests/test_a.py::long", "tests/test_b.py::long"]}, killed)
    found = known([past], Deciding("base", {"tests/test_a.py": "1", "tests/test_b.py": "2", "tests/test_c.py": "1"}))
    assert (found.settled.keys(), found.alive) == ({"a", "proved"}, {"alive"})
    assert found.changed == ("tests/test_b.py", "tests/test_c.py")
    assert found.left_out == {"takes long": ["tests/test_a.py::long"]}
    assert known([past], before).settled == killed
    elsewhere = known([past], Deciding("other", before.tests))
    assert (elsewhere.settled, elsewhere.alive, elsewhere.former.keys()) == ({}, set(), {"a", "b", "proved"})
    assert known([past], Deciding("base", {})).settled.keys() == {"proved", "alive"}, "fewer tests kill no more"


def test_what_killed_a_mutant_before_is_asked_first_and_nothing_else_if_it_still_kills(tree: Path) -> None:
    last = "tests/derive/toy/test_thing.py::test_last"
    (tree / "tests/derive/toy/test_thing.py").write_text(
        TEST + "\n\ndef test_last():\n    test_double()\n", encoding="utf-8"
    )
    first = run(tree)
    assert killers(first) == {last.replace("last", "double")}
    (kept,) = (tree / ".mutants").rglob("toy.jsonl")
    before = kept.read_text(encoding="utf-8")
    kept.write_text(before.replace("::test_double", "::test_last"), encoding="utf-8")
    (tree / "pyproject.toml").write_text('[tool.pytest.ini_options]\npythonpath = [".", "."]\n', encoding="utf-8")
    again = run(tree)
    assert killers(again) == {last}
    assert again.survivors == first.survivors


def test_a_record_is_read_as_it_was_written_and_says_what_to_ask_first_elsewhere(tree: Path) -> None:
    last = "tests/derive/toy/test_thing.py::test_last"
    (tree / "tests/derive/toy/test_thing.py").write_text(
        TEST + "\n\ndef test_last():\n    test_double()\n", encoding="utf-8"
    )
    first = run(tree)
    first.write(tree)
    assert read(tree, "toy") == first
    (kept,) = (tree / "tests/mutants/fates").iterdir()
    kept.write_text(kept.read_text(encoding="utf-8").replace("::test_double", "::test_last"), encoding="utf-8")
    shutil.rmtree(tree / ".mutants")
    assert killers(run(tree)) == {last}
    assert read(tree, "attic") is None


def test_a_former_verdict_is_not_taken_on_trust(tree: Path) -> None:
    first = run(tree)
    (tree / "tests/derive/toy/test_thing.py").write_text(TEST.replace("== 6", "> 0"), encoding="utf-8")
    assert len(run(tree).survivors) > len(first.survivors)


def test_a_tree_that_fails_its_own_checks_is_refused(tree: Path) -> None:
    (tree / "tests/derive/toy/test_thing.py").write_text(TEST.replace("6", "7"), encoding="utf-8")
    with pytest.raises(NotControlled, match="test_double"):
        run(tree)


def test_jobs_have_limits() -> None:
    def endless() -> None:
        while True:
            pass

    jobs = [lambda _: (ExitStack(), Child(endless, limit=1)), lambda _: (ExitStack(), Child(lambda: os._exit(1)))]
    assert {number: outcome.how for number, outcome in outcomes(jobs, [0, 1])} == {0: "timeout", 1: "crashed"}
    with pytest.raises(RuntimeError, match="ZeroDivisionError"):
        isolated(lambda: 1 / 0)


@pytest.mark.parametrize("form", FORMS)
def test_a_wrong_program_fails_validation_in_each_form(form: str) -> None:
    def fate() -> Fate:
        room = Programs()
        wanted = (m for m in room.mutants(Path()) if m.site[2] == "pose" and m.site[4] == form)
        return room.trial(next(m for m in wanted if m.operator == "operation"), None)

    assert isolated(fate) == Fate(KILLED, "validation", "ValidationFailed")


def test_bad_options_are_named(capsys: pytest.CaptureFixture[str]) -> None:
    for arguments in (["--room", "attic"], ["--floor", "attic=9"]):
        with pytest.raises(SystemExit, match="2"):
            main(arguments)
        assert "no room attic: expected programs, proof" in capsys.readouterr().err
