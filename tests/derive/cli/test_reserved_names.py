"""``dualcay generate --name --phi``: reserved names and bad φ are refused; the module agrees with its header."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from derive import generate
from derive.cli import display
from derive.codegen import catalogue
from derive.codegen.targets import TARGETS
from tests.support.command import ROOT, dualcay


@pytest.mark.parametrize("target", TARGETS)
def test_names_of_shared_files_and_words_of_the_language_are_reserved(target: str) -> None:
    endings = (f".{TARGETS[target].extension}", ".d.ts")
    homes = {Path(TARGETS[target].file("chart", table)).parent for table in TARGETS[target].tables}
    beside = [Path(file) for file in TARGETS[target].shared() if file.endswith(endings)]
    stems = {file.name.partition(".")[0] for file in beside if file.parent in homes}
    folders = {part.lstrip("+") for file in TARGETS[target].shared() for part in Path(file).parts[:-1]}
    assert {*stems, *folders, *TARGETS[target].words} <= catalogue.reserved_names()


def test_names_of_included_headers_are_reserved() -> None:
    texts = [path.read_text(encoding="utf-8") for path in (ROOT / "templates").rglob("*.h*")]
    included = {name for text in texts for name in re.findall(r"#include <(\w+)\.h>", text)}
    assert {"math", "Python"} <= included
    assert {name.lower() for name in included} <= catalogue.C_HEADERS


@pytest.mark.parametrize(
    ("name", "phi"),
    [
        *(("sine7", "sin(alpha/14)"), ("cayley7", "tan(alpha/14)"), ("sine6", "sin(alpha/6)")),
        *((name, "alpha/2") for name in ("cayley07", "a" * 100, "com", "con1")),
    ],
)
def test_chart_may_have_its_own_name(name: str, phi: str) -> None:
    assert [chart.name for chart in catalogue.charts((), (), phi, name)] == [name]


def test_repeated_name_is_shown_once() -> None:
    once, twice = (dualcay("show", "-n", "3", "--what", what).stdout for what in ("q,p", "q,p,q"))
    assert twice == once
    assert once.index("q_3") < once.index("p_3")


def test_progress_of_a_check_counts_the_modules_in_the_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    generate([1], output=tmp_path)
    totals: list[int] = []
    steps: list[str] = []

    @contextmanager
    def counted(total: int) -> Iterator[Callable[[str], None]]:
        totals.append(total)
        yield steps.append

    monkeypatch.setattr(display, "progress", counted)
    assert dualcay("generate", "-n", "2", "-o", str(tmp_path), "--check").returncode == 1  # cayley2 is missing
    assert totals == [len(steps)] == [4]  # two modules, and two steps for each


def test_a_phi_that_is_a_sine_is_written_and_checked(tmp_path: Path):
    folder = str(tmp_path / "kernels")
    arguments = ("--phi", "2*sin(alpha/(2*n))", "-n", "1", "--name", "mine", "-o", folder)
    done = dualcay("generate", *arguments)
    assert done.returncode == 0
    assert "phi = 2*sin(alpha/(2*n)) is the chart 2 sine1: its programs and proofs are used\n" in done.stderr
    text = (tmp_path / "kernels" / "mine.py").read_text(encoding="utf-8")
    assert text.startswith("# python -m derive generate --phi '2*sin(alpha/(2*n))' --name mine -n 1 --target numpy\n")
    assert dualcay("generate", *arguments, "--check").returncode == 0
    (tmp_path / "kernels" / "mine.py").write_text(f"{text}# more\n", encoding="utf-8")
    assert dualcay("generate", *arguments, "--check").returncode == 1


def test_a_long_phi_stays_on_the_first_line_where_the_check_reads_it(tmp_path: Path):
    folder = tmp_path / "kernels"
    arguments = ("--phi", " + ".join(["alpha/10"] * 20), "--name", "mine", "-o", str(folder))
    assert dualcay("generate", *arguments).returncode == 0
    assert dualcay("generate", "--family", "exponential", "-o", str(folder), "--check").returncode == 0
    (folder / "cut.py").write_text("# python -m derive generate --phi 'alpha/(1 +\n")
    done = dualcay("generate", *arguments, "--check")
    assert (done.returncode, done.stderr.count("Traceback")) == (1, 0)
    assert f"foreign: {folder / 'cut.py'} (not made by what its first line says" in done.stdout
