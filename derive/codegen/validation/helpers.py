"""What stands beside the kernels of a Python package: `matrix6`, and where there are, `identity` and `random`.

Nothing of random poses is known but how they are distributed: means of many of them are compared. They are off by
their standard deviation over the square root of the number; five times that is what is allowed.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np

from ..rows import Table
from ..signatures import POSES
from .errors import ValidationFailed
from .rounding import Array

COUNT, SEED = 2000, 7

SIGNS = 11
"""A seed of its own: signs drawn as poses are would go with them."""

LENGTH = 2.5
SIGMAS = 5 / math.sqrt(COUNT)

UNIFORM, SQUARED = 1 / math.sqrt(12), math.sqrt(4 / 45)
"""Standard deviations of a number uniform in [0, 1), and of its square."""

ON_SPHERE = {3: 1 / math.sqrt(3), 4: 1 / 2}
"""Of a component of a unit vector, by the number of components."""


def helpers(package: ModuleType, module: ModuleType, table: Table = POSES) -> int:
    """Call them, of the module of a table; return how many calls are as they must be.

    Raises
    ------
    ValidationFailed
        Naming the function and what is wrong with it.
    """
    moves = table is POSES
    checks: list[Callable[[], None]] = [lambda: _matrix6(package.matrix6)] if moves else []
    if hasattr(module, "random"):
        size = table.functions["inverse"].shape
        checks += [lambda: _rest(module, size), lambda: _calls(module, size, moves)]
        checks += [lambda: _by_angle(module, moves), lambda: _uniform(module, moves)]
    for check in checks:
        check()
    return len(checks)


def _require(right: Any, what: str) -> None:
    if not np.all(right):
        raise ValidationFailed(what)


def _refused(function: Callable[..., Any], words: str, *arguments: Any, **options: Any) -> None:
    try:
        function(*arguments, **options)
    except ValueError as error:
        _require(words in str(error), f"{words!r} is not in {str(error)!r}")
    else:
        raise ValidationFailed(f"taken for right: {words}")


def _matrix6(matrix6: Callable[[Array], Array]) -> None:
    D = np.arange(1.0, 73.0).reshape(4, 2, 3, 3)
    for given in (D, D[0], D.reshape(2, 2, 2, 3, 3)):
        re, du = given[..., 0, :, :], given[..., 1, :, :]
        _require(matrix6(given) == np.block([[re, np.zeros_like(re)], [du, re]]), "matrix6 has wrong entries")
    _refused(matrix6, "D must have shape (..., 2, 3, 3)", np.zeros((2, 3, 4)))


def _rest(module: ModuleType, size: tuple[int, ...]) -> None:
    _require(module.identity().shape == size and not module.identity().any(), "identity moves")


def _calls(module: ModuleType, size: tuple[int, ...], moves: bool) -> None:
    for shape in ((), (3,), (2, 3)):
        _require(module.random(shape).shape == (*shape, *size), "random has another shape")
    _require(module.random(3).shape == (3, *size), "random has another shape")
    again = module.random(3, rng=np.random.default_rng(SEED))
    _require(module.random(3, rng=SEED) == again, "random is not that of its seed")
    largest = module.singular_angles()[-1]
    for angle in (-0.1, *([1.1 * largest] if math.isfinite(largest) else [])):
        _refused(module.random, "max_angle must be in [0, ", max_angle=angle)
    for length in (-0.1, math.nan) if moves else ():
        _refused(module.random, "max_translation must be >= 0", max_translation=length)
    still = module.random(3, max_angle=0, rng=SEED, **({"max_translation": 0} if moves else {}))
    _require(abs(still) == 0, "random moves by more than it may")


def _by_angle(module: ModuleType, moves: bool) -> None:
    most = 0.9 * min(math.pi, module.singular_angles()[-1])
    v = module.random(COUNT, max_angle=most, rng=SEED, **({"max_translation": LENGTH} if moves else {}))
    angle, axis = module.to_screw(v) if moves else module.to_angle_axis(v)
    _distributed((angle[:, 0] if moves else angle) / most, "angles of random")
    _directed(axis[:, :3], "axes of random")
    if moves:
        _translations(module, v, LENGTH, axis[:, :3])


def _uniform(module: ModuleType, moves: bool) -> None:
    v = module.random(COUNT, rng=SEED)
    _require(abs(module.principal(v) - v) <= 1e-9 * (1 + abs(v)), "random is not principal")
    quaternion = module.quaternion(v)[:, :4]
    signed = quaternion * np.sign(np.random.default_rng(SIGNS).uniform(-1, 1, (COUNT, 1)))
    _directed(signed, "quaternions of random")
    if moves:
        _translations(module, v, 1.0, quaternion[:, 1:] / np.linalg.norm(quaternion[:, 1:], axis=-1, keepdims=True))


def _translations(module: ModuleType, v: Array, most: float, axes: Array) -> None:
    rho = module.pose(v)[:, :3, 3]
    length = np.linalg.norm(rho, axis=-1)
    _distributed(length / most, "translations of random")
    _directed(rho / length[:, np.newaxis], "directions of random")
    along = np.sum(rho / length[:, np.newaxis] * axes, axis=-1)
    _require(abs(along.mean()) <= SIGMAS * ON_SPHERE[3], "translations of random follow the axis")


def _distributed(share: Array, what: str) -> None:
    """Uniform in [0, 1)."""
    _require((share >= -1e-12) & (share < 1 + 1e-9), f"{what} are beyond their bound")
    _require(abs(share.mean() - 1 / 2) <= SIGMAS * UNIFORM, f"{what} have another mean")
    _require(abs((share**2).mean() - 1 / 3) <= SIGMAS * SQUARED, f"{what} have another variance")


def _directed(units: Array, what: str) -> None:
    """Uniform on a sphere, and independent of the order in which they are drawn."""
    size = units.shape[-1]
    _require(abs(units.mean(axis=0)) <= SIGMAS * ON_SPHERE[size], f"{what} prefer a side")
    spread = SIGMAS * math.sqrt(3 / (size * (size + 2)) - 1 / size**2)
    _require(abs((units**2).mean(axis=0) - 1 / size) <= spread, f"{what} prefer an axis")
