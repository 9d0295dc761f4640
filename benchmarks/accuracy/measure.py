"""Errors of kernel functions by function, order, regime and type, on seeded samples, kept cases and random inputs."""

from __future__ import annotations

import multiprocessing
import time
import warnings
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from derive.codegen.signatures import POSES, ROTATIONS
from tests.support import cases, kernels, ranges, rotations, sampling
from tests.support.accuracy import FUNCTIONS, Trial
from tests.support.calculus import CALCULUS
from tests.support.cases import DTYPES, TRIALS, Case

ORDERS = (1, 2, 3, 4, 5, 6, 7, 8, 16, 32, 64)
DIGITS = 60
COUNT = 6  # samples of a regime
PROCESSES = 2


@dataclass(frozen=True)
class Group:
    """Functions measured on the same samples: table, orders, regimes and number of samples."""

    table: str
    functions: tuple[str, ...]
    orders: tuple[int, ...] = ORDERS
    regimes: tuple[str, ...] = sampling.REGIMES
    count: int = COUNT


FEW, SOME = 3, (1, 2, 3, 8)
"""Number of samples, and orders, for functions with slow exact values and for rotations."""

GROUPS = (
    Group(POSES.name, FUNCTIONS),
    Group(POSES.name, CALCULUS, SOME, count=FEW),
    Group(ROTATIONS.name, rotations.FUNCTIONS, SOME, rotations.REGIMES, FEW),
)


@dataclass(frozen=True)
class Task:
    """Work of one call of a worker process: a group of functions in one regime, or kept cases of one order."""

    folder: Path
    order: int
    group: Group = GROUPS[0]
    regime: str = ""
    dtype: str = ""
    seed: int = 0
    kept: tuple[Case, ...] = ()


@dataclass(frozen=True)
class Measurement:
    """Largest errors of a function in a regime, in eps of (real, dual) part, with their gates and the worst input."""

    function: str
    order: int
    dtype: str
    regime: str
    errors: tuple[float, float]
    gates: tuple[float, float]
    case: Case | None  # None if no sample was in range
    left_out: int  # number of samples for which powers of 1 + v·v overflow
    table: str = POSES.name

    @property
    def inside(self) -> bool:
        return self.regime in sampling.PRINCIPAL


def vectors(function: str, given: tuple[np.ndarray, ...]) -> tuple[np.ndarray, ...]:
    """Return the arguments that are vectors of poses: the first one, or both."""
    row = POSES.functions.get(function)
    both = row is not None and row.arguments[-1].vector
    return given if both else given[:1]


def measured(trial: Trial, function: str, table: str = POSES.name) -> Measurement | None:
    """Return the largest real and the largest dual error of a function in a trial; None without samples."""
    worst, errors, gates, given, left_out = -1.0, [0.0, 0.0], None, None, 0
    for result in getattr(trial, function)():
        gates = result.gates
        if not all(ranges.in_range(trial.order, v) for v in vectors(function, result.given)):
            left_out += 1
            continue
        # NaN and a wrong type count as infinite errors.
        kept = result.got.dtype == trial.dtype
        nearest = min(trial.in_eps(result), key=lambda pair: max(pair[0] / gates[0], pair[1] / gates[1]))
        found = [error if kept else float("inf") for error in nearest]
        errors = [max(pair) for pair in zip(errors, found, strict=True)]
        fraction = max(error / gate for error, gate in zip(found, gates, strict=True))
        if fraction > worst:
            worst, given = fraction, result.given
    if gates is None:
        return None
    case = None if given is None else Case.of(trial, function, given, worst, table)
    dtype, largest = cases.name_of(trial.dtype), (errors[0], errors[1])
    return Measurement(function, trial.order, dtype, trial.regime, largest, gates, case, left_out, table)


def work(task: Task) -> list[Measurement]:
    """Return the measurements of a task; this runs in a worker process."""
    with warnings.catch_warnings():
        # Overflow shows in the measured error.
        warnings.simplefilter("ignore", RuntimeWarning)
        if task.kept:
            modules = ((case, kernels.load(task.order, task.folder, case.table)) for case in task.kept)
            found = [measured(case.trial(module, DIGITS), case.function, case.table) for case, module in modules]
        else:
            group, options = task.group, {"digits": DIGITS, "count": task.group.count, "seed": task.seed}
            module = kernels.load(task.order, task.folder, group.table)
            trial = TRIALS[group.table](module, task.order, task.regime, DTYPES[task.dtype], **options)
            found = [measured(trial, function, group.table) for function in group.functions]
    return [measurement for measurement in found if measurement is not None]


def types() -> list[str]:
    """Return the names of types, with long double only if it is longer than double."""
    longer = np.finfo(np.longdouble).eps < np.finfo(np.float64).eps
    return [name for name in DTYPES if longer or name != "longdouble"]


def sample_tasks(folder: Path, seed: int = 0) -> list[Task]:
    """Return tasks on seeded samples; slow tasks come first, so that all processes end at about the same time."""
    return [
        Task(folder, order, group, regime, dtype, seed)
        for order in reversed(ORDERS)
        for group in GROUPS
        if order in group.orders
        for regime in group.regimes
        if sampling.has_regime(order, regime)
        for dtype in types()
    ]


def replay_tasks(folder: Path, kept: Iterable[Case], size: int = 20) -> list[Task]:
    tasks = []
    for order in ORDERS:
        own = [case for case in kept if case.order == order and case.dtype in types()]
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
    return (measurement.case for measurement in measurements if measurement.case is not None)
