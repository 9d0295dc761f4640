"""Errors and times of a chart outside the catalogue, from kernels that are printed for the measurement alone.

Errors are in eps of the result's size and condition (`FloatCase.scales`), times in nanoseconds per pose.
"""

from __future__ import annotations

import math
import random
import sys
from collections.abc import Iterator, Mapping
from functools import partial
from timeit import repeat
from types import ModuleType
from typing import Any

import mpmath
import numpy as np

from .. import about
from ..algebra import Dual
from ..algebra.pose import Screw, tensor_from_screw
from ..codegen.build import print_package
from ..codegen.signatures import POSES
from ..codegen.targets import TARGETS
from ..codegen.validation.calls import Case, algebraic, of_tensor, selecting
from ..codegen.validation.decimals import EXACT_DIGITS
from ..codegen.validation.float_cases import FloatCase
from ..codegen.validation.loading import loaded, module_of
from ..codegen.validation.screws import covering
from ..codegen.validation.vectors import Vectors, flat, vectors_of
from ..maps.chart import Chart
from ..output import files
from ..scratch import scratch

SEED, SAMPLES = 11, 4
SIZES = (1, 10_000)
"""Numbers of poses at which times are measured."""
SECONDS, ROUNDS = 0.02, 5
"""Least time of a measured loop, and number of loops, of which the fastest counts."""


def measure(chart: Chart, angles: Mapping[str, float], functions: tuple[str, ...], timed: tuple[str, ...]) -> Any:
    """Return ``errors`` by function and angle, and ``nanoseconds`` by function and number of poses."""
    target = TARGETS[about.TARGET]
    with scratch() as folder:
        files.write(folder, print_package([chart], target).texts)
        with loaded(folder) as package:
            kernels = module_of(package, chart, POSES)
            errors: dict[str, dict[str, float]] = {function: {} for function in functions}
            for label, angle in angles.items():
                for function, error in _errors(kernels, chart, angle, functions):
                    errors[function][label] = max(error, errors[function].get(label, 0.0))
            return {"errors": errors, "nanoseconds": {function: _times(kernels, function) for function in timed}}


def _errors(kernels: ModuleType, chart: Chart, angle: float, functions: tuple[str, ...]) -> Iterator[tuple[str, float]]:
    with mpmath.workdps(EXACT_DIGITS):
        at = vectors_of(chart)
        for case in _cases(at, angle):
            if case.function in functions and angle < at.edge and (case.branch is None or angle < math.pi):
                exact = FloatCase(case.row, case.branch, case.arguments, case.compute, at)
                shapes = (array.shape for array in case.row.arguments)
                given = (np.array(a, float).reshape(shape) for a, shape in zip(case.arguments, shapes, strict=True))
                found = np.asarray(getattr(kernels, case.function)(*given), float).ravel()
                size = max(exact.scales) * sys.float_info.epsilon
                off = max(abs(mpmath.mpf(a) - b) for a, b in zip(found, case.result, strict=True))
                yield case.function, float(f"{float(off / size):.2g}")


def _cases(at: Vectors, angle: float) -> Iterator[Case]:
    """Yield calls at screws of an angle, with arguments that floats hold exactly."""
    for screw in list(covering(random.Random(SEED), 2.0**-8))[:SAMPLES]:
        turned = Screw(Dual(mpmath.mpf(angle), screw.angle.du), screw.axis)
        if angle < at.edge:
            v = tuple(mpmath.mpf(float(c)) for c in flat(at.at(turned)))
            yield from algebraic(at, [[v, v, v]])
            yield from selecting(at, of_tensor(tensor_from_screw(turned), 0))


def _times(kernels: ModuleType, function: str) -> dict[str, float]:
    found = {}
    for size in SIZES:
        v = kernels.random((size,) if size > 1 else (), rng=np.random.default_rng(SEED))
        given = kernels.pose(v) if function.startswith("from") else v
        count, call = 1, partial(getattr(kernels, function), given)
        while min(repeat(call, number=count, repeat=1)) < SECONDS:
            count *= 2
        once = min(repeat(call, number=count, repeat=ROUNDS))
        found[str(size)] = float(f"{once / count / size * 1e9:.3g}")
    return found
