"""Law of few poses of float32: rounding of arguments at half a turn changes no branch, in any function that chooses."""

from __future__ import annotations

import importlib
import itertools
import operator
from collections.abc import Iterator
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from derive.about import FAMILIES, ORDERS
from derive.codegen.rows import Function
from derive.codegen.signatures import POSES, ROTATIONS
from dualcay import _numbers
from tests.support import sampling, thorough

CHARTS = [f"cayley{n}" for n in ORDERS if n > 1] + [name for name in FAMILIES if name != "scaled1"]
"""Charts with a vector at half a turn."""
SAMPLE = [("cayley2", "rotation."), ("exponential", ""), ("orthographic", ""), ("lambert", "rotation.")]
EPS = float(np.finfo(np.float32).eps)
NEARLY = EPS**0.5
"""Allowed share of a result: far above rounding, far below the distance to another branch."""
ANGLES = (np.pi, np.pi - 0.02, np.pi + 0.02)
AXES = [*np.eye(3), *-np.eye(3), *sampling.unit_vectors(sampling.generator("float32"), (6,))]


def pose(u: np.ndarray, angle: float) -> np.ndarray:
    """Return the pose of a turn and a translation; at half a turn its matrix is symmetric to the last bit."""
    T = np.eye(4)
    sine, versine = (0.0, 2.0) if angle == np.pi else (np.sin(angle), 1 - np.cos(angle))
    T[:3, :3] += versine * (np.outer(u, u) - np.eye(3)) + sine * np.cross(np.eye(3), -u)
    T[:3, 3] = 0.3, -0.7, 0.2
    return T


def moved(T: np.ndarray) -> np.ndarray:
    """Return the orthogonal dual tensor of a pose."""
    return np.stack([T[:3, :3], np.cross(np.eye(3), -T[:3, 3]) @ T[:3, :3]])


START = pose(np.array([0.48, 0.6, -0.64]), 0.7)
BACK = np.linalg.inv(START)
SECOND = {
    "compose": lambda T: T @ BACK, "between": lambda T: START @ T, "body": lambda T: START @ T,
    "local": lambda T: T @ START, "interpolate": lambda T: T @ START, "retract": lambda T: T @ BACK,
}  # fmt: skip
"""Pose of the other vector, by the first word of a function, such that the result or the step is the turn T."""


class Given:
    """Arguments of functions of a chart, for results that turn by an angle about an axis."""

    def __init__(self, chart: ModuleType, steps: ModuleType, u: np.ndarray, angle: float) -> None:
        self.chart, self.steps, self.u, self.angle = chart, steps, u, angle
        self.line = np.concatenate([u, np.cross([0.3, -0.7, 0.2], u)])
        self.of_rotations = ".rotation." in chart.__name__

    def own(self, module: ModuleType) -> np.ndarray:
        """Return the vector φ(α) u itself, for an angle that may be beyond half a turn."""
        if self.of_rotations:
            return np.asarray(module.from_angle_axis(np.array(self.angle), self.u))
        return np.asarray(module.from_screw(np.array([self.angle, 0.4]), self.line))

    def of(self, module: ModuleType, T: np.ndarray) -> np.ndarray:
        return np.asarray(module.from_tensor(T[:3, :3] if self.of_rotations else moved(T)))

    def arguments(self, row: Function) -> tuple[np.ndarray, ...]:
        names = [array.name for array in row.arguments]
        T, word = pose(self.u, self.angle), row.source.partition("_")[0]
        if len(names) > 1 and word in SECOND:
            if "delta" in names:
                other = BACK @ T if row.source.startswith("body") else T @ BACK
                return self.of(self.chart, START), self.of(self.steps, other)
            return self.of(self.chart, SECOND[word](T)), self.of(self.chart, START), *([np.array(0.3)] * ("t" in names))
        half = self.angle / 2
        q = np.concatenate([[0.0 if self.angle == np.pi else np.cos(half)], np.sin(half) * self.u])
        known = {
            "T": T, "R": T[:3, :3] if self.of_rotations else moved(T),
            "q": q if self.of_rotations else np.concatenate([q, [0.0, *np.cross(self.u, q[1:] + 0.3)]]),
            "angle": np.array(self.angle) if self.of_rotations else np.array([self.angle, 0.4]),
            "line": self.line, "u": self.u, "axis": self.u,
        }  # fmt: skip
        made = []
        for name in names:
            made.append(known[name] if name in known else self.own(self.steps if name == "w" else self.chart))
        return tuple(made)


def rounded(array: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Return numbers of float32 after a change of up to half an eps of the largest one."""
    return (array + EPS / 2 * abs(array).max() * rng.uniform(-1, 1, array.shape)).astype(np.float32)


def several(found: Any) -> tuple[np.ndarray, ...]:
    return found if isinstance(found, tuple) else (found,)


def wrong(name: str, folder: str) -> Iterator[str]:
    """Yield the calls whose rounded arguments give another branch than the exact ones in a batch of float64."""
    chart, steps = (importlib.import_module(f"dualcay.{folder}{each}") for each in (name, "exponential"))
    edge, rng = np.inf if name == "exponential" else chart.singular_angles()[-1], sampling.generator(name)
    for row in (row for row in (ROTATIONS if folder else POSES).public.values() if row.real):
        # vectors that end at half a turn lose half of their digits there, and shadows of half a turn end at 3π
        ends = any(array.vector for array in row.arguments) if edge < 3.2 else abs(edge - 3 * np.pi) < 1
        if ends and (edge < 3.2 or row.source.startswith("shadow")):
            continue
        function = getattr(chart, row.name)
        given = [Given(chart, steps, u, angle).arguments(row) for u in AXES for angle in ANGLES if angle <= edge]
        data = [[rounded(array, rng) for array in arguments] for arguments in given]
        right = several(function(*map(np.array, zip(*given))))
        for place, arguments in enumerate(data):
            found = several(function(*arguments))
            for part, exact in zip(found, (each[place] for each in right), strict=True):
                if not np.allclose(part, exact, NEARLY, NEARLY * (1 + abs(exact).max())):
                    yield f"{row.name}{arguments}: {part}, {exact}"
            if place == 0:
                few = several(function(*(np.stack([array, array]) for array in arguments)))
                if not all(map(np.array_equal, found, (each[1] for each in few))):
                    yield f"{row.name}{arguments}: {found}, {few} in a batch"


@pytest.mark.parametrize("chart", thorough.sampled(itertools.product(CHARTS, ("", "rotation.")), SAMPLE))
def test_rounding_changes_no_branch(chart: tuple[str, str]) -> None:
    assert list(wrong(*chart)) == []


@pytest.mark.parametrize("size", [1.0, 64.0, 0.0, 0.7, 3.1e-30])
def test_terms_that_float32_loses_are_lost(size: float) -> None:
    """Compare with sums of float32 at sizes that float32 holds, for terms beside half the spacing of its numbers."""
    of = np.float32
    size = float(of(size))
    for term in size * EPS * np.array([0.0, 0.2, 0.26, 0.4, 0.51, 0.9, 1.1, 4.0, np.nan]):
        for signed in (float(of(term)), -float(of(term))):
            found, whole = _numbers.Singles.beside(size, signed), of(size) + of(signed)
            assert [found < size, found == size] == [whole < of(size), whole == of(size)], signed
    assert _numbers.Singles.beside(0.0, -1e-45) < 0


def test_noise_that_chooses_a_branch_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """Control: the rule of float64 takes noise of float32 for a sign, in every map that has one."""
    monkeypatch.setattr(_numbers.Singles, "beside", staticmethod(operator.add))
    seen = {call.partition("[")[0] for call in wrong("lambert", "")}
    assert seen >= {"from_tensor", "from_quaternion", "compose", "between", "principal", "local", "compose_jacobians"}
