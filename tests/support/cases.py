"""Inputs on which a kernel function once had its largest error, kept in a file that only grows.

A case names the function, the order, the type, the regime (which decides what is allowed there) and the arguments in
hexadecimal, so that it is the same number everywhere. All branches of the function are tried on it.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from derive.codegen.signatures import POSES, ROTATIONS
from tests.support import sampling
from tests.support.accuracy import Trial
from tests.support.calculus import CalculusTrial
from tests.support.first_principles import DIGITS
from tests.support.rotations import RotationTrial

FILE = Path(__file__).parents[2] / "benchmarks" / "worst_cases.json"
DTYPES: dict[str, Any] = {"float32": np.float32, "float64": np.float64, "longdouble": np.longdouble}
WORSE = 1.1  # a case is kept if it is this much worse than those kept before
ENOUGH = 0.25  # and its error more than this part of what is allowed: what stays far below guards nothing

TRIALS: dict[str, type[Trial]] = {POSES.name: CalculusTrial, ROTATIONS.name: RotationTrial}
"""By the table of the functions that are tried."""

Key = tuple[str, str, int, str, bool]


def name_of(dtype: Any) -> str:
    return next(name for name, known in DTYPES.items() if known is dtype)


def encode(value: Any) -> str:
    """A float of any type as a sum of doubles, in hexadecimal."""
    parts = []
    while True:
        head = float(value)
        parts.append(re.sub(r"\.?0+p", "p", head.hex()))
        value = value - np.asarray(head, dtype=np.asarray(value).dtype)[()]
        if value == 0 or not math.isfinite(head):
            return " ".join(parts)


def decode(text: str, dtype: Any) -> Any:
    head, *tail = (dtype(float.fromhex(part)) for part in text.split())
    return sum(tail, start=head)


@dataclass(frozen=True)
class Case:
    """One input; `fraction` is its error over the gate when it was found."""

    function: str
    order: int
    dtype: str
    regime: str
    arguments: tuple[tuple[str, ...], ...]
    fraction: float
    table: str = POSES.name

    @classmethod
    def of(
        cls, trial: Trial, function: str, given: tuple[np.ndarray, ...], fraction: float, table: str = POSES.name
    ) -> Case:
        arguments = tuple(tuple(encode(c) for c in argument) for argument in given)
        fraction = float(f"{fraction:.3g}")
        return cls(function, trial.order, name_of(trial.dtype), trial.regime, arguments, fraction, table)

    @property
    def key(self) -> Key:
        """Cases of one key compete: inside and outside the principal range different errors are allowed."""
        return self.table, self.function, self.order, self.dtype, self.regime in sampling.PRINCIPAL

    def trial(self, module: ModuleType, digits: int = DIGITS) -> Trial:
        dtype = DTYPES[self.dtype]
        given = tuple(np.array([[decode(c, dtype) for c in a]], dtype=dtype) for a in self.arguments)
        return TRIALS[self.table](module, self.order, self.regime, dtype, digits=digits, given=given)


def read(path: Path = FILE) -> tuple[list[Case], int]:
    """The cases, and how many seeds have been searched."""
    if not path.exists():
        return [], 0
    content = json.loads(path.read_text(encoding="utf-8"))
    cases = [
        Case(**{**entry, "arguments": tuple(map(tuple, entry["arguments"])), "fraction": float(entry["fraction"])})
        for entry in content["cases"]
    ]
    return cases, content["searched"]


def write(cases: Iterable[Case], searched: int, path: Path = FILE) -> None:
    """One case a line, in order, so that a change shows as the lines added."""
    ordered = sorted(cases, key=lambda case: (case.key, case.fraction, case.arguments))
    kept = (vars(case) | {"fraction": str(case.fraction)} for case in ordered)
    lines = [json.dumps({name: value for name, value in entry.items() if value != ""}) for entry in kept]
    text = f'{{"searched": {searched}, "cases": [\n' + ",\n".join(lines) + "\n]}\n"
    path.write_text(text, encoding="utf-8")


def added(kept: list[Case], found: Iterable[Case]) -> list[Case]:
    """Those kept, and of those found the worst of each key if it is clearly worse."""
    record: dict[Key, float] = {}
    for case in kept:
        record[case.key] = max(case.fraction, record.get(case.key, 0.0))
    known = {(case.key, case.arguments) for case in kept}
    best: dict[Key, Case] = {}
    for case in found:
        worse = case.fraction > max(ENOUGH, WORSE * record.get(case.key, 0.0))
        if worse and (case.key, case.arguments) not in known:
            old = best.get(case.key)
            best[case.key] = case if old is None or case.fraction > old.fraction else old
    return [*kept, *best.values()]
