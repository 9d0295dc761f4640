"""Storage of the worst inputs of each kernel function, in benchmarks/worst_cases.json.

A case holds function, order, type, regime (which decides the gate) and arguments. Hexadecimal arguments are the same
numbers on every machine. Each case is tried on all branches of its function.
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
KEPT = 2  # number of cases kept per function, inside and again outside the principal range

CASES_MAX = 190  # largest number of cases in the file; cases nearest to their gates are kept

TRIALS: dict[str, type[Trial]] = {POSES.name: CalculusTrial, ROTATIONS.name: RotationTrial}
"""Class of trials by name of the table of functions."""

Key = tuple[str, str, bool]


def name_of(dtype: Any) -> str:
    return next(name for name, known in DTYPES.items() if known is dtype)


def encode(value: Any) -> str:
    """Return a float of any type as a sum of doubles, in hexadecimal."""
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
    """Stored input; `fraction` is its error divided by the gate, measured when the input was found."""

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
        """Key of cases that compete for storage; gates, and so keys, differ inside and outside the principal range."""
        return self.table, self.function, self.regime in sampling.PRINCIPAL

    def trial(self, module: ModuleType, digits: int = DIGITS) -> Trial:
        dtype = DTYPES[self.dtype]
        given = tuple(np.array([[decode(c, dtype) for c in a]], dtype=dtype) for a in self.arguments)
        return TRIALS[self.table](module, self.order, self.regime, dtype, digits=digits, given=given)


def read(path: Path = FILE) -> tuple[list[Case], int]:
    """Return the stored cases, and the number of seeds searched so far."""
    if not path.exists():
        return [], 0
    content = json.loads(path.read_text(encoding="utf-8"))
    cases = [
        Case(**{**entry, "arguments": tuple(map(tuple, entry["arguments"])), "fraction": float(entry["fraction"])})
        for entry in content["cases"]
    ]
    return cases, content["searched"]


def write(cases: Iterable[Case], searched: int, path: Path = FILE) -> None:
    """Write the cases with the largest fractions, at most `CASES_MAX`, one per line and in a fixed order."""
    largest = sorted(cases, key=lambda case: -case.fraction)[:CASES_MAX]
    ordered = sorted(largest, key=lambda case: (case.key, case.fraction, case.arguments))
    kept = (vars(case) | {"fraction": str(case.fraction)} for case in ordered)
    lines = [json.dumps({name: value for name, value in entry.items() if value != ""}) for entry in kept]
    text = f'{{"searched": {searched}, "cases": [\n' + ",\n".join(lines) + "\n]}\n"
    path.write_text(text, encoding="utf-8")


def worst(cases: Iterable[Case], count: int = KEPT) -> list[Case]:
    """Return the cases with the largest fractions, at most `count` per key and one per input."""
    inputs = {(case.key, case.arguments): case for case in sorted(cases, key=lambda case: case.fraction)}
    found: dict[Key, list[Case]] = {}
    for case in sorted(inputs.values(), key=lambda case: -case.fraction):
        found.setdefault(case.key, []).append(case)
    return [case for of_key in found.values() for case in of_key[:count]]
