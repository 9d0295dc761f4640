"""Storage of the worst inputs of each kernel function, in benchmarks/worst_cases.json.

A case holds function, order, type, regime and arguments. Hexadecimal arguments are the same
numbers on every machine. Functions that choose a branch have it, too.
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
from tests.support.regimes import Call
from tests.support.trial import DIGITS, Trial

FILE = Path(__file__).parents[2] / "benchmarks" / "worst_cases.json"
DTYPES: dict[str, Any] = {"float32": np.float32, "float64": np.float64, "longdouble": np.longdouble}
KEPT = 2  # number of cases kept per function, inside and again outside the principal range

CASES_MAX = 190  # largest number of cases in the file; cases nearest to their gates are kept

TABLES = {POSES.name: POSES, ROTATIONS.name: ROTATIONS}

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
    branch: tuple[int, ...] = ()

    @classmethod
    def of(cls, trial: Trial, call: Call, fraction: float) -> Case:
        arguments = tuple(tuple(map(encode, np.ravel(argument))) for argument in call.given)
        name, fraction = call.row.name, float(f"{fraction:.3g}")
        place = trial.order, name_of(trial.dtype), trial.regime
        return cls(name, *place, arguments, fraction, trial.chart.table.name, call.branch)

    @property
    def key(self) -> Key:
        """Key of cases that compete for storage, inside and outside the principal range."""
        return self.table, self.function, self.regime in sampling.PRINCIPAL

    def call(self, module: ModuleType, digits: int = DIGITS) -> Call:
        dtype, row = DTYPES[self.dtype], TABLES[self.table].public[self.function]
        given = tuple(
            np.array([decode(text, dtype) for text in argument], dtype).reshape(array.shape)
            for argument, array in zip(self.arguments, row.arguments, strict=True)
        )
        return Trial(module, self.order, self.regime, dtype, digits=digits).call(row, given, self.branch)


def read(path: Path = FILE) -> tuple[list[Case], int]:
    """Return the stored cases, and the number of seeds searched so far."""
    if not path.exists():
        return [], 0
    content = json.loads(path.read_text(encoding="utf-8"))
    cases = [
        Case(
            **entry
            | {"arguments": tuple(map(tuple, entry["arguments"])), "fraction": float(entry["fraction"])}
            | {"branch": tuple(entry.get("branch", ()))}
        )
        for entry in content["cases"]
    ]
    return cases, content["searched"]


def write(cases: Iterable[Case], searched: int, path: Path = FILE) -> None:
    """Write the cases with the largest fractions, at most `CASES_MAX`, one per line and in a fixed order."""
    largest = sorted(cases, key=lambda case: -case.fraction)[:CASES_MAX]
    ordered = sorted(largest, key=lambda case: (case.key, case.fraction, case.arguments))
    kept = (vars(case) | {"fraction": str(case.fraction)} for case in ordered)
    lines = [json.dumps({name: value for name, value in entry.items() if value not in ("", ())}) for entry in kept]
    text = f'{{"searched": {searched}, "cases": [\n' + ",\n".join(lines) + "\n]}\n"
    path.write_text(text, encoding="utf-8")


def worst(cases: Iterable[Case], count: int = KEPT) -> list[Case]:
    """Return the cases with the largest fractions, at most `count` per key and one per input."""
    inputs = {(case.key, case.arguments): case for case in sorted(cases, key=lambda case: case.fraction)}
    found: dict[Key, list[Case]] = {}
    for case in sorted(inputs.values(), key=lambda case: -case.fraction):
        found.setdefault(case.key, []).append(case)
    return [case for of_key in found.values() for case in of_key[:count]]
