"""Oracles of chart families, and errors of results relative to their condition.

As in `oracle`, no code under test is used. A family is defined by |v| as a function of θ = α/2n, and by its inverse.
"""

from __future__ import annotations

import functools
from collections.abc import Sequence
from types import ModuleType
from typing import Any

import mpmath
import numpy as np

from derive.codegen.signatures import FUNCTIONS, PUBLIC
from tests.support import errors, sampling
from tests.support.nilpotent import dot, inverse
from tests.support.oracle import Oracle, SineOracle


class ScaledOracle(Oracle):
    """Oracle of v = 2n tan θ u."""

    def base(self, v: Any) -> Any:
        return v[0] * 0 + 2 * self.order

    def size(self, theta: Any) -> Any:
        return 2 * self.order * self.field.tan(theta)


class BreusingOracle(Oracle):
    """Oracle of v = sin θ/√cos θ u; half turns are added to θ until cos θ > 0, and cos² θ + x cos θ = 1."""

    def cosine(self, v: Any) -> Any:
        x = dot(v, v)
        return 2 / (x + self.field.sqrt(x * x + 4))

    def base(self, v: Any) -> Any:
        return self.field.sqrt(self.cosine(v))

    def size(self, theta: Any) -> Any:
        sine, cosine = self.field.sin(theta), self.field.cos(theta)
        sign = -1 if cosine.re < 0 else 1
        return sign * sine / self.field.sqrt(sign * cosine)


class ExponentialOracle(Oracle):
    """Oracle of v = 2θ u, θ = α/2."""

    def base(self, v: Any) -> Any:
        return angle_by_tangent(self.field, dot(v, v))

    def size(self, theta: Any) -> Any:
        return 2 * theta


def angle_by_tangent(field: Any, square: Any) -> Any:
    """Return α/tan(α/2) from α², with all nilpotent parts; a root would lose them near 0, so a series is used there."""
    if abs(real(square)) < 1e-30:
        return 2 - square / 6 - square * square / 360 - square * square * square / 15120
    angle = field.sqrt(square)
    return angle / field.tan(angle / 2)


def real(number: Any) -> Any:
    """Return the real part of a number with nested nilpotent parts."""
    return real(number.re) if hasattr(number, "re") and hasattr(number, "du") else number


ORACLES = {
    "exponential": (ExponentialOracle, 1),
    "orthographic": (SineOracle, 1), "lambert": (SineOracle, 2), "sine3": (SineOracle, 3), "sine4": (SineOracle, 4),
    "breusing": (BreusingOracle, 2), "wiener_milenkovic": (ScaledOracle, 2),
    **{f"scaled{n}": (ScaledOracle, n) for n in range(1, 6)},
}  # fmt: skip
"""Class and order of the oracle, by name of a family's module."""


DIGITS = 60
GATE = 8  # largest allowed error, in eps of size and condition of a result; `make accuracy` found half of it
VECTORS = ("v0", "v1", "v2", "delta")  # names of further arguments that are vectors of the chart, or steps
BY_STEPS = ("retract_jacobians", "body_retract_jacobians")  # functions with products of operators as results
BY_ENDS = ("local_jacobians", "body_local_jacobians")
BY_FACTORS = ("compose_jacobians", "between_jacobians", *BY_STEPS, *BY_ENDS)
STEPS = ("retract", "body_retract", *BY_STEPS)


@functools.cache
def oracle_of(name: str, digits: int = DIGITS) -> Oracle:
    """Return the oracle of a chart by name, shared by all tests because it remembers results."""
    if name.startswith("cayley"):
        return Oracle(int(name.removeprefix("cayley")), digits)
    if name not in ORACLES:
        raise LookupError(f"no oracle of the family {name}: state its class and order in ORACLES, {__name__}")
    kind, order = ORACLES[name]
    return kind(order, digits)


def vectors(oracle: Oracle, low: float, high: float, count: int = 4) -> np.ndarray:
    """Return dual vectors with rotation angles drawn log-uniformly between two bounds."""
    rng = sampling.generator("families", low, high)
    angles = np.exp(rng.uniform(np.log(low), np.log(high), count))
    axes, rest = sampling.unit_vectors(rng, (count,)), rng.normal(size=(count, 3))
    sizes = [float(oracle.size(oracle.field.number(a) / (2 * oracle.order) + _dual_zero(oracle)).re) for a in angles]
    return np.concatenate([np.array(sizes)[:, np.newaxis] * axes, rest], axis=-1)


def _dual_zero(oracle: Oracle) -> Any:
    return oracle.unpack((0, 0))[0]


def arguments(kernels: ModuleType, name: str, v: np.ndarray) -> list[np.ndarray]:
    """Return the arguments of a function: first v or its pose, then any second argument."""
    first = FUNCTIONS[name].arguments[0].name
    given = {"q": kernels.quaternion, "R": kernels.tensor, "T": kernels.pose, "w": kernels.to_exponential}
    if first == "angle":
        return [np.array(part) for part in kernels.to_screw(v)]
    others = []
    for argument in FUNCTIONS[name].arguments[1:]:
        drawn = np.roll(sampling.dual_vectors(name, count=len(v))[:, : argument.size], 1)
        if argument.name in VECTORS:  # another axis, and so short that no product lies beyond the edge
            drawn[:, :3] = 0.1 * np.roll(v[:, :3], 1, axis=-1)
        others.append(drawn.reshape(-1, *argument.shape))
    return [given.get(first, np.array)(v), *others]


def scale(function: Any, given: list[np.ndarray], exact: list[Any]) -> list[float]:
    """Return the norm of each part of a result plus its change per relative change of every argument component.

    The function returns the parts of its result.
    """
    step = mpmath.mpf(2) ** -80
    sizes = [errors.norm(part) for part in exact]
    for i, argument in enumerate(given):
        for index, component in np.ndenumerate(argument):
            moved = argument.astype(object)
            with mpmath.workdps(DIGITS):
                moved[index] = mpmath.mpmathify(component) * (1 + step)
            other = function(*given[:i], moved, *given[i + 1 :])
            sizes = [size + errors.norm((b - a) / step) for size, a, b in zip(sizes, exact, other, strict=True)]
    return sizes


def scale_of_factors(oracle: Oracle, name: str, one: np.ndarray, other: np.ndarray) -> list[float]:
    """Return the effect of rounding the factors of Jacobians such as T(v')⁻¹ R T(v) and T(v')⁻¹ R' dexp(δ).

    Each factor is computed separately, with an error relative to its norm. At whole turns, and at an edge with φ′ = 0,
    a factor is nearly singular, but the product is near I. Changes of the arguments do not show this error.
    """
    result = oracle.unpack(getattr(oracle, name.removesuffix("_jacobians"))(one, other))
    back = errors.majorant(inverse((oracle.step_operator if name in BY_ENDS else oracle.operator_by_spin)(result)))
    first, second = oracle.unpack(one), oracle.unpack(other)
    moved = errors.majorant(oracle.operator_by_spin(first))
    if name in BY_STEPS:
        moving = errors.majorant(oracle.step_operator(second))
        steps = errors.majorant(ExponentialOracle(1, DIGITS).rotation(second))
    else:
        moving, steps = errors.majorant(oracle.operator_by_spin(second)), errors.size(oracle.tensor(other))
    turned = errors.size(oracle.tensor(one))
    by_second = name in ("retract_jacobians", "between_jacobians")  # R of the second argument, else of the first
    products = (back * steps * moved, back * moving) if by_second else (back * moved, back * turned * moving)
    products = (back * moved, back * moving) if name in BY_ENDS else products
    return [float(part) for product in products for part in (product.re, product.du)]


def parts(result: Any) -> list[Any]:
    """Return the real and dual part of each result; a transformed point counts as one part."""
    if isinstance(result, tuple):
        return [part for array in result for part in errors.parts(array)]
    return [result] if np.shape(result) == (3,) else list(errors.parts(result))


def worst(kernels: ModuleType, oracle: Oracle, name: str, v: np.ndarray, branch: int | None = None) -> float:
    """Return the largest error of a function at vectors, in eps of the scale of each part of its result."""
    return worst_of(kernels, oracle, name, arguments(kernels, name, v), *(() if branch is None else (branch,)))


def worst_of(
    kernels: ModuleType, oracle: Oracle, name: str, given: list[np.ndarray], *chosen: int, enough: float = 0.0
) -> float:
    """Return the largest error of a function at given arguments, on a branch if one is given.

    Scales cost far more than results. An error of at most `enough` eps of the norms, parts of the scales, needs none.
    """

    def function(*values: Any) -> Any:
        return parts(getattr(oracle, name)(*values, *chosen))

    found = getattr(kernels, name)(*given, *chosen)
    largest = 0.0
    for i in range(len(given[0])):
        one = [np.asarray(argument[i]) for argument in given]
        got = parts(tuple(array[i] for array in found) if isinstance(found, tuple) else found[i])
        exact = function(*one)
        off = [errors.norm(b - a.astype(object)) / np.finfo(float).eps for a, b in zip(got, exact, strict=True)]
        sizes = [errors.norm(part) for part in exact]
        if not all(error <= enough * size for error, size in zip(off, sizes, strict=True)):
            sizes = scale(function, one, exact)
            if name in BY_FACTORS:
                sizes = [a + b for a, b in zip(sizes, scale_of_factors(oracle, name, *one), strict=True)]
        largest = max(largest, *(float(error / size) if error else 0.0 for error, size in zip(off, sizes, strict=True)))
    return largest


def require(kernels: ModuleType, oracle: Oracle, name: str, given: list[np.ndarray], *chosen: int) -> None:
    """Require errors of a function within the gate."""
    error = worst_of(kernels, oracle, name, given, *chosen, enough=GATE)
    assert error <= GATE, (name, error, given)


def require_every_function(
    kernels: ModuleType, oracle: Oracle, regimes: Sequence[tuple[float, float]], branch: int = 0
) -> None:
    """Test each function in one regime of angles; the next function takes the next regime."""
    for place, name in enumerate(PUBLIC):
        low, high = regimes[place % len(regimes)]
        if name in ("to_screw", "angle") and high < 1e-200:
            low, high = 1e-9, 1e-5  # at 1e-300, v°/|v| overflows, and the oracle treats the angle as zero
        given = arguments(kernels, name, vectors(oracle, low, high, 1))
        require(kernels, oracle, name, given, *((branch,) if PUBLIC[name].branch else ()))


def edge_of(name: str) -> float:
    """Return the angle at which a family ends; 2π for the exponential, because its oracle does not count turns."""
    return 2 * np.pi if name == "exponential" else oracle_of(name).order * np.pi


def half_product(omega: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Return the dual quaternion ω q/2 of a dual vector ω and a dual quaternion q."""

    def product(w: np.ndarray, p: np.ndarray) -> np.ndarray:
        return np.concatenate([[-w @ p[1:]], p[0] * w + np.cross(w, p[1:])])

    return np.concatenate([product(omega[:3], q[:4]), product(omega[:3], q[4:]) + product(omega[3:], q[:4])]) / 2
