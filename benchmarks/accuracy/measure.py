"""Errors of kernel functions by function, order, regime and type, on seeded samples, kept cases and random inputs."""

from __future__ import annotations

import multiprocessing
import time
import warnings
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from derive.codegen.signatures import POSES, ROTATIONS
from tests.support import cases, kernels, sampling
from tests.support.cases import DTYPES, Case
from tests.support.trial import Trial

ORDERS = (1, 2, 3, 8)
SOME = (2, 3)
"""Orders of rotations alone."""
TYPES = ("float32", "float64")
DIGITS = 60
COUNT = 2  # samples of a regime
PROCESSES = 2


@dataclass(frozen=True)
class Task:
    """Work of one call of a worker process: all functions of one order and type, or kept cases of one order."""

    folder: Path
    order: int
    table: str = POSES.name
    dtype: str = ""
    inside: bool = True
    seed: int = 0
    kept: tuple[Case, ...] = ()


@dataclass(frozen=True)
class Measurement:
    """Largest error of a function, in eps of the size of a part of its result, with its gate and the worst input."""

    function: str
    order: int
    dtype: str
    regime: str
    error: float
    gate: float
    case: Case
    table: str = POSES.name

    @property
    def inside(self) -> bool:
        return self.regime in sampling.PRINCIPAL


def measured(trials: Iterable[Trial], function: str) -> Measurement | None:
    """Return the largest error of a function in trials; None if every result is out of range.

    An error in eps of the norms alone is quick, and not smaller: calls in its order are measured until none is worse.
    """
    worst, found = -1.0, None
    calls = [(trial, call) for trial in trials for call in trial.calls(function)]
    results = [(call.bound(), trial, call) for trial, call in calls if call.finite()]
    for bound, trial, call in sorted(results, key=lambda result: -result[0]):
        if bound <= worst:
            break
        error = call.error(call.among())
        if error > worst:
            worst, found = error, Measurement(
                function, trial.order, cases.name_of(trial.dtype), trial.regime, error, call.gate,
                Case.of(trial, call, error / call.gate), trial.chart.table.name,
            )  # fmt: skip
    return found


def replayed(case: Case, folder: Path) -> Measurement:
    """Return the measurement of a kept case."""
    call = case.call(kernels.load(case.order, folder, case.table), DIGITS)
    error = call.error(call.among()) if call.finite() else float("inf")
    case = replace(case, fraction=float(f"{error / call.gate:.3g}"))
    return Measurement(case.function, case.order, case.dtype, case.regime, error, call.gate, case, case.table)


def work(task: Task) -> list[Measurement]:
    """Return the measurements of a task; this runs in a worker process."""
    with warnings.catch_warnings():
        # Overflow shows in the measured error.
        warnings.simplefilter("ignore", RuntimeWarning)
        if task.kept:
            return [replayed(case, task.folder) for case in task.kept]
        module, options = kernels.load(task.order, task.folder, task.table), {"digits": DIGITS, "seed": task.seed}
        regimes = (r for r in sampling.REGIMES if (r in sampling.PRINCIPAL) == task.inside)
        trials = [
            Trial(module, task.order, regime, DTYPES[task.dtype], count=COUNT, **options)
            for regime in regimes
            if sampling.has_regime(task.order, regime)
        ]
        found = [measured(trials, function) for function in cases.TABLES[task.table].public]
    return [measurement for measurement in found if measurement is not None]


def sample_tasks(folder: Path, seed: int = 0) -> list[Task]:
    """Return tasks on seeded samples; slow tasks come first, so that all processes end at about the same time."""
    return [
        Task(folder, order, table, dtype, inside, seed)
        for table, orders in ((POSES.name, ORDERS), (ROTATIONS.name, SOME))
        for order in reversed(orders)
        for inside in (True, False)
        for dtype in TYPES
    ]


def replay_tasks(folder: Path, kept: Iterable[Case], size: int = 20) -> list[Task]:
    tasks = []
    for order in ORDERS:
        own = [case for case in kept if case.order == order and case.dtype in TYPES]
        tasks += [Task(folder, order, kept=tuple(own[i : i + size])) for i in range(0, len(own), size)]
    return tasks


def run(tasks: list[Task], advance: Callable[[], None], deadline: float | None = None) -> Iterator[Measurement]:
    """Yield the measurements of tasks run in parallel; skip tasks left at the deadline (of `time.monotonic`)."""
    # Forked processes would inherit threads of the compared libraries.
    context = multiprocessing.get_context("spawn")
    with context.Pool(PROCESSES) as pool:
        for found in pool.imap(work, tasks):
            yield from found
            advance()
            if deadline is not None and time.monotonic() > deadline:
                pool.terminate()
                return


def cases_of(measurements: Iterable[Measurement]) -> Iterator[Case]:
    return (measurement.case for measurement in measurements)
