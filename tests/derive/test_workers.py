"""Processes that execute charts: they change nothing but the time it takes, and none is left."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from derive.codegen import ValidationFailed, generate_charts
from derive.codegen.compiler import build_charts
from derive.maps import Cayley
from tests.support.command import ROOT
from tests.support.counting import Counting, Dying

CHARTS = [Cayley(n) for n in (3, 2)]


def test_results_are_those_of_one_process():
    alone, lines = build_charts(CHARTS, Counting()), list[str]()
    beside = build_charts(CHARTS, Counting(), lines.append, processes=2)
    assert beside.texts == alone.texts
    counts = [[(m.name, m.validated, m.replayed, m.tested) for m in package.modules] for package in (alone, beside)]
    assert counts[0] == counts[1]
    assert [replayed for _, _, replayed, _ in counts[0]] == [2, 1]
    assert len(lines) == len(set(lines)) == 4 * len(CHARTS)


@pytest.mark.parametrize("processes", [1, 2])
def test_geometry_of_high_orders_is_shown_in_order_3_which_is_not_published(processes):
    high, higher, low = Cayley(9), Cayley(10), Cayley(3)
    alone = build_charts([high, higher], Counting(), processes=processes)
    beside = build_charts([low, high, higher], Counting())
    assert [m.validated for m in alone.modules] == [m.validated for m in beside.modules[1:]]
    assert [m.replayed for m in alone.modules] == [1, 1]
    assert beside.texts.keys() - alone.texts.keys() == {f"{low.name}.py", f"rotation/{low.name}.py"}
    with pytest.raises(ValidationFailed, match=low.name):
        build_charts([high], Counting((low.name,)), processes=processes)


@pytest.mark.parametrize("processes", [1, 2])
def test_the_first_failure_is_told_in_the_order_of_charts_and_nothing_written(tmp_path: Path, monkeypatch, processes):
    monkeypatch.setattr("derive.codegen.compiler.TARGETS", {"numpy": Counting(("cayley3", "cayley2"))})
    with pytest.raises(ValidationFailed, match=r"^cayley3\.pose, component 0: 1 is not 2$"):
        generate_charts(CHARTS, "numpy", tmp_path / "k", processes=processes)
    assert not (tmp_path / "k").exists()
    assert multiprocessing.active_children() == []


@pytest.mark.smoke
def test_a_process_that_dies_is_told():
    with pytest.raises(ChildProcessError, match="a worker process died"):
        build_charts(CHARTS, Dying(), processes=2)
    assert multiprocessing.active_children() == []


def test_a_number_of_processes_is_positive():
    with pytest.raises(ValueError, match="processes must be an integer >= 1, got 0"):
        build_charts(CHARTS, Counting(), processes=0)


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
def test_none_is_left_when_the_first_is_interrupted_or_killed(tmp_path: Path, name: str):
    """A terminal sends an interrupt to all of them, here to the first last."""
    ending = signal.Signals[name]  # Windows has one of them only
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
        out, err = first.communicate(timeout=20)
        until(lambda: not any(map(alive, begun)))
    finally:
        first.kill()
    if ending == signal.SIGINT:
        assert (out, err, first.returncode) == ("interrupted\n", "", 0)
        assert not any(path.exists() for path in begun.values())
    assert len([*tmp_path.iterdir()]) == 2  # no further call began, and none saw the interrupt itself


def until(reached) -> None:
    end = time.monotonic() + 20
    while not reached():
        assert time.monotonic() < end
        time.sleep(0.05)


def alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    return Path(f"/proc/{process}/stat").read_text().split()[2] != "Z" if Path("/proc").is_dir() else True
