"""First and second derivatives of kernels by JAX or PyTorch, beside differences of the oracle with 100 digits."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from types import ModuleType
from typing import Any

import mpmath
import numpy as np

from derive.codegen.signatures import PUBLIC
from tests.support.families import ORACLES
from tests.support.libraries import QUICKLY
from tests.support.oracle import Oracle

DIGITS = 100
STEP = 1e-25
"""Step of central differences; with 100 digits they keep 50, at second derivatives too."""

GATE = 50  # largest error, in eps of the size of a derivative and of its change by the rounding of arguments
ROUND = {"from_quaternion": "quaternion", "from_tensor": "tensor", "from_pose": "pose"}
"""Inverse maps, each tried after the map that gives its argument: their argument has no derivative on its own."""

AXIS = np.array([2, -2, 1]) / 3
Library = Callable[..., dict[str, np.ndarray]]


def oracle(name: str) -> Oracle:
    if name.startswith("cayley"):
        return Oracle(int(name.removeprefix("cayley")), DIGITS)
    kind, order = ORACLES[name]
    return kind(order, DIGITS)


def points(kernel: ModuleType) -> Iterator[tuple[str, np.ndarray]]:
    """Yield vectors by regime: the identity, translations, tiny angles, far translations, about π, below 2π."""
    yield "identity", np.zeros(6)
    yield "translation", np.array([0, 0, 0, 1.0, 2, 3])
    for angle in (1e-1, 1e-8, 1e-16, 1e-300):
        for far in (1.0, 1e6):
            yield f"angle {angle:g}, translation {far:g}", np.array([*angle * AXIS, far, 2 * far, 3 * far])
    for name, angle in (("generic", 1.3), ("half turn", np.pi), ("below 2π", 2 * np.pi - 1e-3)):
        yield name, kernel.from_exponential(np.array([*angle * AXIS, 0.3, -0.5, 0.7]))
    for off in (1e-3, -1e-3, 1e-9, -1e-9):
        yield f"π {off:+g}", kernel.from_exponential(np.array([*(np.pi + off) * AXIS, 0.3, -0.5, 0.7]))


def flat(found: Any) -> Any:
    parts = found if isinstance(found, tuple) else (found,)
    return np.concatenate([np.asarray(part, dtype=object).ravel() for part in parts])


class Case:
    """Function of one flat argument, in a module and in the oracle, at a vector and along two directions."""

    def __init__(self, chart: str, name: str, v: np.ndarray) -> None:
        self.chart, self.name, rng = oracle(chart), name, np.random.default_rng(len(name))
        self.arguments = PUBLIC[name].arguments
        rest = [0.3 * rng.normal(size=a.size) for a in self.arguments[1:]]
        self.at = np.concatenate([v, *rest])
        self.along, self.second, self.change = rng.normal(size=(3, self.at.size))
        self.change = self.at * np.sign(self.change)

    def split(self, z: Any) -> list[Any]:
        ends = np.cumsum([a.size for a in self.arguments])
        return [z[end - a.size : end].reshape(a.shape) for a, end in zip(self.arguments, ends, strict=True)]

    def of(self, module: Any) -> Callable[[Any], Any]:
        """Return the function of a module, or its round trip for an inverse map."""
        if forward := ROUND.get(self.name):
            return lambda z: getattr(module, self.name)(getattr(module, forward)(z))
        return lambda z: getattr(module, self.name)(*self.split(z))

    def exact(self) -> tuple[np.ndarray, np.ndarray, float, float]:
        """Return first and second derivatives of the oracle, and their sizes with their changes by rounding."""
        with mpmath.workdps(DIGITS):
            h, at = mpmath.mpf(STEP), np.array([mpmath.mpf(c) for c in self.at])
            along, second, change = (
                np.array([mpmath.mpf(c) for c in d]) for d in (self.along, self.second, self.change)
            )

            def slope(function: Any, direction: Any) -> Any:
                return lambda z: (function(z + h * direction) - function(z - h * direction)) / (2 * h)

            value = lambda z: flat(self.of(self.chart)(z))  # noqa: E731
            first = slope(value, along)
            bend = slope(first, second)
            terms = value, first, slope(first, change), bend, slope(bend, change)
            sizes = [max(abs(c) for c in term(at)) for term in terms]
            small, large = float(max(sizes[:3])), float(max(sizes))
            return first(at).astype(float), bend(at).astype(float), small, large


def errors(case: Case, module: Any, library: Library, dtype: Any = np.float64) -> dict[str, float]:
    """Return errors of all modes, in eps of the sizes."""
    case.at = case.at.astype(dtype).astype(float)
    first, second, small, large = case.exact()
    eps, found = np.finfo(dtype).eps, library(case.of(module), case.at, case.along, case.second, dtype)
    pairs = {mode: (second, large) if "," in mode else (first, small) for mode in found}
    return {mode: float(np.max(abs(found[mode] - pairs[mode][0]))) / pairs[mode][1] / eps for mode in found}


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


def by_jax(function: Any, *given: Any) -> dict[str, np.ndarray]:
    import jax

    def flat_of(z: Any) -> Any:
        return jax.numpy.concatenate([part.ravel() for part in jax.tree.leaves(function(z))])

    *values, dtype = given
    compiled = jax.jit(partial(modes, jax.jvp, jax.jacrev, flat_of), compiler_options=QUICKLY)
    return {mode: np.asarray(found) for mode, found in compiled(*(value.astype(dtype) for value in values)).items()}


def by_torch(function: Any, *given: Any) -> dict[str, np.ndarray]:
    import torch

    def flat_of(z: Any) -> Any:
        found = function(z)
        return torch.cat([part.reshape(-1) for part in (found if isinstance(found, tuple) else (found,))])

    *values, dtype = given
    tensors = [torch.asarray(value.astype(dtype)) for value in values]
    return {mode: found.numpy() for mode, found in modes(torch.func.jvp, torch.func.jacrev, flat_of, *tensors).items()}
