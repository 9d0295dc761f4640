"""Octave, which runs the functions of a MATLAB package on rows of numbers."""

from __future__ import annotations

import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from derive.codegen.rows import Function
from derive.codegen.signatures import POSES, ROTATIONS
from derive.codegen.targets.matlab import name_of

FUNCTIONS = {table.name: table.all_public for table in (POSES, ROTATIONS)}
QUIET = "warning('off', 'Octave:shadowed-function');"
"""Octave warns of a function in a package that has the name of a built-in one, though it hides none."""


def octave(folder: Path, program: str) -> str:
    """Run a program with a package of a folder; return its output, with that of the error that ended it."""
    source = f"{QUIET} addpath('{folder}');\n{program}"
    with tempfile.TemporaryDirectory() as place:
        Path(place, "main.m").write_text(source, encoding="utf-8")
        done = subprocess.run(["octave-cli", "--norc", "main.m"], cwd=place, capture_output=True, text=True)
    return done.stdout + done.stderr


def row(case: Any) -> Function:
    return FUNCTIONS[case.table][case.function]


def run(folder: Path, cases: Sequence[Any], _: Path | None = None) -> list[list[np.ndarray]]:
    """Return the results of each case: an array for each result, with a row for each row of the arguments.

    Octave needs no folder of its own, which runners of compiled languages take last.
    """
    with tempfile.TemporaryDirectory() as place:
        given, made = Path(place, "given"), Path(place, "made")
        given.write_bytes(b"".join(np.ascontiguousarray(array).tobytes() for c in cases for array in c.arguments))
        said = octave(folder, f"in = fopen('{given}'); out = fopen('{made}', 'w');\n" + "\n".join(map(_call, cases)))
        numbers = np.fromfile(made) if made.exists() else np.empty(0)
    sizes = [[(len(c.arguments[0]), array.size) for array in row(c).results] for c in cases]
    assert len(numbers) == sum(count * size for shapes in sizes for count, size in shapes), said
    parts = iter(np.split(numbers, np.cumsum([count * size for shapes in sizes for count, size in shapes])))
    return [[next(parts).reshape(shape) for shape in shapes] for shapes in sizes]


def _call(case: Any) -> str:
    """Return statements that read the arguments of a case as columns, and write its results."""
    reads = "; ".join(f"a{i} = fread(in, [{array.shape[1]} {len(array)}], 'double')"
                      for i, array in enumerate(case.arguments))  # fmt: skip
    made = [f"r{i}" for i in range(len(row(case).results))]
    passed = ", ".join([*(f"a{i}" for i in range(len(case.arguments))), *[str(case.branch)] * row(case).branch])
    called = ".".join(filter(None, ("dualcay", case.table, case.chart, name_of(row(case)))))
    writes = "; ".join(f"fwrite(out, {name}, 'double')" for name in made)
    return f"{reads}; [{', '.join(made)}] = {called}({passed}); {writes};"
