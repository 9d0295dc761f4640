"""First and second derivatives of kernels by JAX or PyTorch, beside differences of the oracle with 100 digits.

``python -m tests.support.derivatives jax --seconds 1500 --seed 1`` tries functions in all charts for some time, and
``python -m tests.support.derivatives jax --name compose`` a function by name.
"""

from __future__ import annotations

import argparse
import importlib
import random
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from pathlib import Path
from time import process_time
from typing import Any

import mpmath
import numpy as np

from derive.about import FAMILIES, ORDERS
from derive.codegen.rows import Table
from derive.codegen.signatures import POSES, ROTATIONS
from derive.maps import Cayley, family
from tests.support import packages, traced
from tests.support.families import oracle_of
from tests.support.libraries import QUICKLY

GATE = 50  # largest error, in eps of the size of a derivative and of its change by the rounding of arguments
ROUND = {"from_quaternion": "quaternion", "from_tensor": "tensor", "from_pose": "pose"}
"""Inverse maps, each tried after the map that gives its argument: their argument has no derivative on its own."""

OF_AXIS = ("angle", "to_screw", "shadow", "shadow_jacobian")
"""Functions of an axis: without rotation they have no derivative, and beside it derivatives grow without bound."""

SIDES = ("principal", "to_screw", "shadow", "shadow_jacobian", *ROUND)
"""Functions that jump at half a turn."""

AT_REST = ("identity", "translation", "angle 1e-300, translation 1", "angle 1e-16, translation 1")
"""Regimes without rotation, or with so little that x = v·v hardly changes a result but may spoil its derivatives."""

AXIS = np.array([2, -2, 1]) / 3
ANGLES = (1e-1, 1e-4, 1e-8, 1e-16, 1e-30, 1e-300)
TYPES = np.float64, np.float32
Library = Callable[..., Mapping[str, np.ndarray]]


def points(chart: str) -> Iterator[tuple[str, float, float, np.ndarray]]:
    """Yield regime, angle, angle left to the edge, and vector.

    Regimes are the identity, translations, tiny angles, far translations, angles about π, and an angle below 2π.
    """
    kernel = importlib.import_module(f"dualcay.{chart}")
    edge = float((Cayley(int(chart[6:])) if chart.startswith("cayley") else family(chart)).edge)
    yield "identity", 0.0, edge, np.zeros(6)
    yield "translation", 0.0, edge, np.array([0, 0, 0, 1.0, 2, 3])
    for angle in ANGLES:
        for far in (1.0, 1e6):
            v = np.array([*angle * AXIS, far, 2 * far, 3 * far])
            yield f"angle {angle:g}, translation {far:g}", angle, edge, v
    about = {f"π {off:+g}": np.pi + off for off in (1e-3, -1e-3, 1e-6, -1e-6, 1e-9, -1e-9)}
    for regime, angle in {"generic": 1.3, "half turn": np.pi, **about, "below 2π": 2 * np.pi - 1e-3}.items():
        v = kernel.from_exponential(np.array([*angle * AXIS, 0.3, -0.5, 0.7]))
        with np.errstate(all="ignore"):
            yield regime, angle, edge - float(kernel.angle(v)[0]), v


def flat(found: Any) -> Any:
    parts = found if isinstance(found, tuple) else (found,)
    return np.concatenate([np.asarray(part, dtype=object).ravel() for part in parts])


class Case:
    """Function of one flat argument, in a module and in the oracle, at vectors by regime and along two directions."""

    def __init__(self, chart: str, name: str, table: Table = POSES, dtype: Any = np.float64) -> None:
        self.row, self.forward, self.dtype = table.public[name], ROUND.get(name), dtype
        self.eps = np.finfo(dtype).eps
        self.given = table.public[self.forward] if self.forward else self.row
        self.step, self.digits = ("1e-60", 200) if self.row.source in OF_AXIS else ("1e-25", 100)
        self.oracle, rng = oracle_of(chart, self.digits), np.random.default_rng(len(name))
        size = sum(a.size for a in self.given.arguments)
        rest = [0.3 * rng.normal(size=a.size) for a in self.given.arguments[1:]]
        self.along, self.second, self.signs = rng.normal(size=(3, size)).astype(dtype)
        self.at = {
            regime: np.concatenate([*self._start(angle, v), *rest])[:size].astype(dtype)
            for regime, angle, left, v in points("exponential" if name == "from_exponential" else chart)
            if not self._left_out(angle, left)
        }

    def _left_out(self, angle: float, left: float) -> bool:
        """Return whether an angle has no derivative, or one beyond the range of floats, or lies on the chart's edge."""
        resting, half = angle < 1e-9, abs(angle - np.pi) < 50 * self.eps
        at_edge = left < 4 * np.sqrt(self.eps)
        return at_edge or (self.row.source in OF_AXIS and resting) or (self.row.source in SIDES and half)

    def _start(self, angle: float, v: np.ndarray) -> list[np.ndarray]:
        """Return the first argument at a vector of the chart: the vector, or its angle and axis."""
        if self.row.source == "from_screw":
            v = np.array([angle, 0.2])
            return [v[: self.row.arguments[0].size], np.array([*AXIS, 0.3, -0.5, 0.7])[: self.row.arguments[1].size]]
        return [v[: self.given.arguments[0].size]]

    def split(self, z: Any) -> list[Any]:
        sizes = [a.size for a in self.given.arguments]
        return [z[end - size : end] for size, end in zip(sizes, np.cumsum(sizes), strict=True)]

    def of(self, module: Any) -> Callable[[Any], Any]:
        """Return the function of a module, or its round trip for an inverse map."""
        outer = getattr(module, self.row.name) if self.forward else lambda found: found

        def function(z: Any) -> Any:
            parts = zip(self.split(z), self.given.arguments, strict=True)
            return outer(getattr(module, self.given.name)(*(part.reshape(a.shape) for part, a in parts)))

        return function

    def before(self, z: Any) -> Any:
        """Return the result of the oracle for the given function: that before an inverse map, or this function."""
        arguments = (self.given.pose or self.given).arguments
        parts = zip(self.given.embedded(self.split(z), mpmath.mpf(0)), arguments, strict=True)
        return getattr(self.oracle, self.given.source)(*(np.array(part).reshape(a.shape) for part, a in parts))

    def value(self, z: Any) -> Any:
        """Return the flat result of the oracle."""
        found = self.before(z)
        return np.array(self.row.part(flat(getattr(self.oracle, self.row.source)(found) if self.forward else found)))

    def exact(self, at: np.ndarray) -> tuple[np.ndarray, np.ndarray, float, float]:
        """Return first and second derivatives of the oracle, and their sizes with their changes by rounding.

        Sizes of a round trip include those of its first map.
        """
        with mpmath.workdps(self.digits):
            along, second, change = map(_number, (self.along, self.second, at * np.sign(self.signs)))
            slope = self._slope

            def terms(value: Any) -> list[Any]:
                first = slope(value, along)
                bend = slope(first, second)
                return [term(_number(at)) for term in (value, first, slope(first, change), bend, slope(bend, change))]

            found = terms(self.value)
            others = terms(lambda z: flat(self.before(z))) if self.forward else found
            sizes = [float(max(map(abs, [*one, *other]))) for one, other in zip(found, others, strict=True)]
            return found[1].astype(float), found[3].astype(float), max(sizes[:3]), max(sizes)

    def _slope(self, function: Any, direction: Any) -> Any:
        """Return the function that is the difference quotient of a function along a direction."""
        h = mpmath.mpf(self.step)
        return lambda z: (function(z + h * direction) - function(z - h * direction)) / (2 * h)

    def error_at_rest(self, module: Any) -> float:
        """Return the largest error of derivatives at rest, in eps of the sizes of value and derivative.

        Changes by the rounding of arguments are smaller there. Dual parts have the second derivatives of real parts.
        """
        points = np.stack([at for regime, at in self.at.items() if regime in AT_REST])
        worst = 0.0
        for at, got in zip(points, traced.derivative(self.of(module), points, self.along), strict=True):
            with mpmath.workdps(self.digits):
                step = mpmath.mpf(self.step) * _number(self.along)
                before, after = self.value(_number(at) - step), self.value(_number(at) + step)
                exact = (after - before) / (2 * mpmath.mpf(self.step))
            size = float(max(map(abs, [*after, *exact])))
            error = np.max(abs(flat(tuple(got)).astype(float) - exact.astype(float)))
            worst = float(np.fmax(worst, error / size / self.eps)) if np.isfinite(error) else np.inf
        return worst


_number = np.vectorize(lambda c: mpmath.mpf(float(c)), otypes=[object])


def errors(case: Case, module: Any, library: Library) -> dict[tuple[str, str], float]:
    """Return errors of all modes by regime and mode, in eps of the sizes."""
    found = library(case.of(module), np.stack(list(case.at.values())), case.along, case.second)
    worst = {}
    for place, (regime, at) in enumerate(case.at.items()):
        first, second, small, large = case.exact(at)
        for mode, values in found.items():
            expected, size = (second, large) if "," in mode else (first, small)
            error = np.max(abs(values[place].astype(float) - expected)) / size / case.eps
            worst[regime, mode] = float(error)
    return worst


def modes(jvp: Any, jacrev: Any, function: Any, at: Any, along: Any, second: Any) -> dict[str, Any]:
    """Return first and second derivatives along directions by forward and reverse mode and all compositions."""

    def forward(f: Any, d: Any) -> Any:
        return lambda z: jvp(f, (z,), (d,))[1]

    def reverse(f: Any, d: Any) -> Any:
        return lambda z: jacrev(f)(z) @ d

    both = {"forward": forward, "reverse": reverse}
    found = {name: mode(function, along)(at) for name, mode in both.items()}
    for inner, one in both.items():
        found |= {f"{outer}, {inner}": other(one(function, along), second)(at) for outer, other in both.items()}
    return found


def modes_in_jax(function: Any) -> Callable[..., dict[str, Any]]:
    """Return the function of a point and two directions that gives the derivatives of a function by mode."""
    import jax

    def flat_of(z: Any) -> Any:
        return jax.numpy.concatenate([part.ravel() for part in jax.tree.leaves(function(z))])

    jax.config.update("jax_enable_x64", True)
    return partial(modes, jax.jvp, jax.jacrev, flat_of)


def by_jax(function: Any, *given: Any) -> dict[str, np.ndarray]:
    """Return derivatives at a batch of points by one compiled call."""
    import jax

    mapped = jax.vmap(modes_in_jax(function), in_axes=(0, None, None))
    return {mode: np.asarray(found) for mode, found in jax.jit(mapped, compiler_options=QUICKLY)(*given).items()}


def by_traces(function: Any, points: np.ndarray, *along: np.ndarray) -> dict[str, np.ndarray]:
    """Return derivatives at points by what JAX traces, which NumPy runs."""
    one = modes_in_jax(function)
    found = [traced.run(one, at, *along) for at in points]
    return {mode: np.stack([each[mode] for each in found]) for mode in found[0]}


def by_torch(function: Any, *given: Any) -> dict[str, np.ndarray]:
    """Return derivatives at a batch of points."""
    import torch

    def flat_of(z: Any) -> Any:
        found = function(z)
        return torch.cat([part.reshape(-1) for part in (found if isinstance(found, tuple) else (found,))])

    one = partial(modes, torch.func.jvp, torch.func.jacrev, flat_of)
    mapped = torch.func.vmap(one, in_dims=(0, None, None))
    return {mode: found.numpy() for mode, found in mapped(*map(torch.asarray, given)).items()}


LIBRARIES = {"jax": by_jax, "torch": by_torch}
Try = tuple[str, str, Table, Any]


def tries(seed: int, chosen: str = "") -> list[Try]:
    """Return every function, or a chosen one, with both types, each in a chart drawn by a seed, in random order."""
    charts, draw = [*(f"cayley{n}" for n in ORDERS), *FAMILIES], random.Random(seed)
    found = [(name, table) for table in (POSES, ROTATIONS) for name in table.public if chosen in ("", name)]
    rows = [(name, table, dtype) for name, table in found for dtype in TYPES]
    draw.shuffle(rows)
    draw.shuffle(charts)
    return [(charts[i % len(charts)], *row) for i, row in enumerate(rows)]


def above_gate(package: str, one: Try, library: Library, share: int = 1) -> dict[tuple[str, str], float]:
    """Return errors above the gate by regime and mode, in a share of the regimes; NaN is above."""
    chart, name, table, dtype = one
    module = importlib.import_module(".".join(filter(None, (package, table.name, chart))))
    case = Case(chart, name, table, dtype)
    case.at = dict(list(case.at.items())[::share])
    found = errors(case, module, library)
    return {place: error for place, error in found.items() if not error <= GATE}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("library", choices=LIBRARIES)
    parser.add_argument("--name", default="", choices=["", *POSES.public], help="function to try (default: all)")
    parser.add_argument("--seconds", type=float, default=60, help="processor time")
    parser.add_argument("--seed", type=int, default=0)
    given, count, wrong = parser.parse_args(), 0, 0
    with tempfile.TemporaryDirectory() as folder:
        packages.write(ORDERS, "array-api", Path(folder) / "of_tries", FAMILIES)
        sys.path.insert(0, folder)
        for one in tries(given.seed, given.name):
            if process_time() > given.seconds:
                break
            found = above_gate("of_tries", one, LIBRARIES[given.library])
            count, wrong = count + 1, wrong + bool(found)
            print(one[0], one[1], one[2].name or "poses", one[3].__name__, found or "", flush=True)
    print(f"{count} functions, {wrong} with errors above the gate")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
