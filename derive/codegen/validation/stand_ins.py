"""Short replacements of SciPy for run-time parts that import it; tests call the library itself."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import SimpleNamespace
from typing import Any

import numpy as np

LONGEST_STEP = 0.04


class RungeKutta:
    """Classical method of four stages with the attributes of SciPy's solvers; it ignores the tolerances."""

    def __init__(self, fun: Any, t0: float, y0: Any, t_bound: float, max_step: float, **tolerances: Any) -> None:
        self.fun, self.t, self.y, self.t_bound, self.max_step = fun, t0, y0, t_bound, max_step
        self.f, self.status = np.asarray(fun(t0, y0)), "running"

    def step(self) -> None:
        h = min(LONGEST_STEP, self.max_step, self.t_bound - self.t)
        k1 = self.f
        k2 = np.asarray(self.fun(self.t + h / 2, self.y + h / 2 * k1))
        k3 = np.asarray(self.fun(self.t + h / 2, self.y + h / 2 * k2))
        k4 = np.asarray(self.fun(self.t + h, self.y + h * k3))
        self.before = self.t_old, y_old, _ = self.t, self.y, self.f
        self.t, self.y = self.t + h, y_old + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        self.f = np.asarray(self.fun(self.t, self.y))
        self.status = "running" if self.t < self.t_bound else "finished"

    def dense_output(self) -> Callable[[Any], Any]:
        """Return the cubic polynomial with the values and slopes at both ends of the last step."""
        (t0, y0, f0), y1, f1, h = self.before, self.y, self.f, self.t - self.t_old

        def local(t: Any) -> Any:
            s = (np.asarray(t) - t0) / h
            basis = (1 - s) ** 2 * (1 + 2 * s), s**2 * (3 - 2 * s), h * s * (1 - s) ** 2, -h * s**2 * (1 - s)
            return sum(np.multiply.outer(value, weight) for value, weight in zip((y0, y1, f0, f1), basis, strict=True))

        return local


class Polynomial:
    """Polynomial through samples, in place of a spline."""

    def __init__(self, t: Any, values: Any) -> None:
        self.coefficients = np.linalg.solve(np.vander(t, increasing=True), values)

    def __call__(self, t: Any) -> Any:
        powers = np.power.outer(np.asarray(t, float), np.arange(len(self.coefficients)))
        return powers @ self.coefficients

    def derivative(self) -> Polynomial:
        slope = object.__new__(Polynomial)
        slope.coefficients = self.coefficients[1:] * np.arange(1, len(self.coefficients))[:, None]
        return slope


def bisected(function: Callable[[float], float], a: float, b: float) -> float:
    """Return a zero of a function between two places where its signs differ."""
    above = function(a) > 0
    for _ in range(60):
        middle = (a + b) / 2
        a, b = (middle, b) if (function(middle) > 0) == above else (a, middle)
    return (a + b) / 2


class Kept:
    """Quaternions of SciPy's rotations and transforms, kept as they are given; the scalar is first."""

    def __init__(self, q: Any, scalar_first: bool = False) -> None:
        halves = np.split(np.asarray(q), np.shape(q)[-1] // 4, axis=-1)
        self.halves = halves if scalar_first else [np.roll(half, 1, axis=-1) for half in halves]

    def components(self, scalar_first: bool) -> Any:
        return np.concatenate([h if scalar_first else np.roll(h, -1, axis=-1) for h in self.halves], axis=-1)

    as_quat = as_dual_quat = components


QUATERNIONS = SimpleNamespace(from_quat=Kept, from_dual_quat=Kept)
SCIPY = SimpleNamespace(
    integrate=SimpleNamespace(DOP853=RungeKutta),
    interpolate=SimpleNamespace(CubicSpline=Polynomial),
    optimize=SimpleNamespace(brentq=bisected),
    spatial=SimpleNamespace(transform=SimpleNamespace(Rotation=QUATERNIONS, RigidTransform=QUATERNIONS)),
)

def _modules(name: str, value: Any) -> Iterator[tuple[str, Any]]:
    yield name, value
    for inner, member in vars(value).items() if isinstance(value, SimpleNamespace) else ():
        if isinstance(member, SimpleNamespace):
            yield from _modules(f"{name}.{inner}", member)


@contextmanager
def standing_in() -> Iterator[None]:
    """Replace SciPy among the imported modules."""
    replaced = dict(_modules("scipy", SCIPY))
    before = {name: sys.modules[name] for name in replaced if name in sys.modules}
    sys.modules.update(replaced)
    try:
        yield
    finally:
        for name in replaced:
            del sys.modules[name]
        sys.modules.update(before)
