"""Worker processes: they change only the time of a build, and all of them end."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import time
from contextlib import nullcontext
from pathlib import Path

import pytest

from derive.claims.result import Status
from derive.claims.run import check
from derive.codegen import ValidationFailed, generate_charts
from derive.codegen.build import GEOMETRY, build
from derive.codegen.validation import compiled
from derive.maps import Cayley
from derive.workers import SlowError, mapping, run
from tests.support.command import ROOT
from tests.support.counting import Counting, Dying
from tests.support.staying import meet, until

CHARTS = [Cayley(n) for n in (1, 2)]
LIMIT = 1
"""Processor time in tests of limits."""


def test_result_does_not_depend_on_the_number_of_processes():
    alone, lines = build(CHARTS, Counting()), list[str]()
    beside = build(CHARTS, Counting(), lambda _: nullcontext(lines.append), processes=2)
    assert beside.texts == alone.texts
    assert [m.counts for m in beside.modules] == [m.counts for m in alone.modules]
    assert [m.counts.replayed for m in alone.modules] == [1, 1]
    assert len(lines) == len(set(lines)) == 4 * (len(CHARTS) + 1)


def test_geometry_is_checked_once_in_a_chart_that_is_published_only_if_asked_for():
    alone, beside = build(CHARTS[:1], Counting()), build([GEOMETRY, CHARTS[0]], Counting())
    assert [m.counts for m in alone.modules] == [m.counts for m in beside.modules[1:]]
    assert [m.counts.replayed for m in beside.modules] == [2, 1]
    assert beside.texts.keys() - alone.texts.keys() == {f"{GEOMETRY.name}.py", f"rotation/{GEOMETRY.name}.py"}
    with pytest.raises(ValidationFailed, match=GEOMETRY.name):
        build(CHARTS[:1], Counting((GEOMETRY.name,)))


@pytest.mark.parametrize("processes", [1, 2])
def test_first_failure_is_reported_in_the_order_of_charts_and_nothing_written(tmp_path: Path, monkeypatch, processes):
    monkeypatch.setattr("derive.codegen.build.TARGETS", {"numpy": Counting(("cayley1", "cayley2"))})
    with pytest.raises(ValidationFailed, match=r"^cayley1\.pose, component 0: 1 is not 2$"):
        generate_charts(CHARTS, "numpy", tmp_path / "k", processes=processes)
    assert not (tmp_path / "k").exists()
    assert multiprocessing.active_children() == []


@pytest.mark.smoke
def test_death_of_a_worker_is_reported():
    with pytest.raises(ChildProcessError, match="a worker process died"):
        build(CHARTS, Dying(), processes=2)
    assert multiprocessing.active_children() == []


def test_this_process_takes_part(tmp_path: Path):
    with mapping(meet, 2) as results:
        assert os.getpid() in list(results([tmp_path, tmp_path]))


def test_number_of_processes_is_positive():
    with pytest.raises(ValueError, match="processes must be an integer >= 1, got 0"):
        build(CHARTS, Counting(), processes=0)


BUSY = """
import signal, sys
from pathlib import Path
from derive.workers import workers
from tests.support.staying import stay
if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.default_int_handler)
    folder = Path(sys.argv[1])
    try:
        with workers(2) as pool:
            for call in [pool.submit(stay, folder) for _ in range(5)]:
                call.result()
    except KeyboardInterrupt:
        print("interrupted")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
@pytest.mark.parametrize("name", ["SIGINT", "SIGKILL"])
def test_no_worker_is_left_when_the_main_process_is_interrupted_or_killed(tmp_path: Path, name: str):
    """Interrupt the workers and the main process, as a terminal does, or kill the main process alone."""
    ending = signal.Signals[name]  # Windows lacks one of these signals
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-c", BUSY, str(tmp_path)]
    first = subprocess.Popen(
        command, env=env, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    try:
        until(lambda: len([*tmp_path.iterdir()]) == 2 and all(path.read_text() for path in tmp_path.iterdir()))
        begun = {int(path.name): Path(path.read_text()) for path in tmp_path.iterdir()}
        if ending == signal.SIGINT:
            for process in begun:
                os.kill(process, ending)
            time.sleep(0.2)
        first.send_signal(ending)
        out, err = first.communicate()
        until(lambda: not any(map(alive, begun)))
    finally:
        first.kill()
    if ending == signal.SIGINT:
        assert (out, err, first.returncode) == ("interrupted\n", "", 0)
        assert not any(path.exists() for path in begun.values())
    assert len([*tmp_path.iterdir()]) == 2  # no further call began, and no call was interrupted


def alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    return Path(f"/proc/{process}/stat").read_text().split()[2] != "Z" if Path("/proc").is_dir() else True


# --- limits of processor time -----------------------------------------------------------------------------------------

posix = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such limit")


DECIDE = f"""
import importlib, time
module = importlib.import_module("derive.claims.decide")
def decided(*given, early):
    time.sleep({1.5 * LIMIT})
    early(of(*given, early=early))
    pow(3, 10**10)  # one call of C
of, module.decide = module.decide, decided
"""


@posix
def test_a_claim_is_stopped_if_it_computes_long_and_not_if_it_waits(tmp_path, monkeypatch, capfd):
    """Expect the result found before; the page of formulas in use has a claim that is stopped without one."""
    (tmp_path / "sitecustomize.py").write_text(DECIDE)  # each worker loads it when it begins
    monkeypatch.syspath_prepend(tmp_path)
    found = check("x + x == 2*x", x="real", seconds=LIMIT)
    assert (found.status, found.method, capfd.readouterr().err) == (Status.HOLDS, "exact", "")


@posix
def test_a_program_is_stopped_if_it_computes_long_and_not_if_it_sleeps():
    assert run(["sh", "-c", "sleep 2.5; echo slept"], 1).stdout == "slept\n"
    with pytest.raises(SlowError, match=r"^sh was stopped after 1 s of processor time$"):
        run(["sh", "-c", "while :; do :; done"], 1)
    assert run(["sh", "-c", "kill -9 $$"], 1).returncode == -9


@posix
@pytest.mark.parametrize("compiler", [True, False])
def test_a_compiler_or_a_test_that_never_ends_is_named(tmp_path: Path, monkeypatch, compiler):
    def limited(command, seconds):
        name = Path(command[0]).name
        if compiler or name == "double":
            raise SlowError(f"{name} was stopped after {seconds} s")
        return subprocess.CompletedProcess(command, 0)

    monkeypatch.setenv("CC", "true")
    monkeypatch.setattr(compiled, "run", limited)
    said = rf"^test_cayley1\.c \(double\): {'true' if compiler else 'double'} was stopped after {compiled.SECONDS} s$"
    with pytest.raises(ValidationFailed, match=said):
        compiled.test(tmp_path, Cayley(1))
