"""Seeded test poses, regime by regime.

A sample consists of a rotation angle, a unit axis, a translation along the axis, and a random rest of the dual part.
Poses have natural sizes in every regime: v = tan(α/2n) u, and v° is the derivative along the screw plus a normal
vector.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable

import numpy as np

# Number of poses per regime, few because the oracle is slow; every (order, regime) has its own seed.
COUNT = 3
# Number of poses in batches that run recorded programs; fewer poses may run one by one, those of float32 in double.
CROWD = 25

Angles = Callable[[np.random.Generator, int, int], np.ndarray]


def _log_uniform(rng: np.random.Generator, low: float, high: float, count: int) -> np.ndarray:
    return 10.0 ** rng.uniform(low, high, count)


def _shadow_angles(rng: np.random.Generator, order: int, count: int) -> np.ndarray:
    """Draw angles beyond the principal range and away from multiples of π, where charts have poles or change sides."""
    if order == 2:
        return rng.uniform(np.pi + 0.2, 2 * np.pi - 0.2, count)
    turns = rng.integers(1, order - 1, count, endpoint=True)
    return 2 * np.pi * turns + rng.uniform(0.2, np.pi - 0.2, count) * rng.choice([-1, 1], count)


ANGLES: dict[str, Angles] = {
    "uniform": lambda rng, n, count: rng.uniform(0.05, 3.0, count),
    "angle 1e-12": lambda rng, n, count: 1e-12 * rng.uniform(0.5, 2.0, count),
    "angle 1e-7": lambda rng, n, count: 1e-7 * rng.uniform(0.5, 2.0, count),
    "middle band": lambda rng, n, count: _log_uniform(rng, -5, -2, count),
    "below pi": lambda rng, n, count: np.pi - _log_uniform(rng, -7, -2, count),
    "above pi": lambda rng, n, count: np.pi + _log_uniform(rng, -7, -2, count),
    "at pi": lambda rng, n, count: np.full(count, np.pi),
    "near 2 pi": lambda rng, n, count: 2 * np.pi - _log_uniform(rng, -5, -1, count) * rng.choice([-1, 1], count),
    "shadow": _shadow_angles,
    "coordinate axes": lambda rng, n, count: np.pi - _log_uniform(rng, -7, -2, count),
    "translation 1e6": lambda rng, n, count: rng.uniform(0.05, 3.0, count),
    "pure rotation": lambda rng, n, count: rng.uniform(0.05, 3.0, count),
    "pure translation": lambda rng, n, count: np.zeros(count),
    "identity": lambda rng, n, count: np.zeros(count),
}

# Regimes inside the principal range, where every order is well conditioned.
PRINCIPAL = (
    "uniform", "angle 1e-12", "angle 1e-7", "middle band", "below pi", "coordinate axes", "translation 1e6",
    "pure rotation", "pure translation", "identity",
)  # fmt: skip
# Regimes outside the principal range: n = 1 has no v at π, and only n ≥ 2 has v at 2π and beyond.
OUTSIDE = ("above pi", "at pi", "near 2 pi", "shadow")
REGIMES = PRINCIPAL + OUTSIDE


def has_regime(order: int, regime: str) -> bool:
    """Return whether the chart of this order reaches the regime."""
    return order > 1 or regime in PRINCIPAL


def generator(*key: object, seed: int = 0) -> np.random.Generator:
    """Return a generator of random numbers; key and seed determine it, in every process and on every machine."""
    return np.random.default_rng(zlib.crc32(repr((*key, seed) if seed else key).encode()))


def _filled(values: np.ndarray, rng: np.random.Generator, dtype: type) -> np.ndarray:
    """Convert doubles to another type, with random digits beyond double precision."""
    if np.finfo(dtype).eps >= np.finfo(float).eps:
        return values.astype(dtype)
    return values.astype(dtype) * (1 + np.finfo(float).eps * rng.uniform(-0.5, 0.5, values.shape).astype(dtype))


def unit_vectors(rng: np.random.Generator, shape: tuple[int, ...]) -> np.ndarray:
    vectors = rng.normal(size=(*shape, 3))
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def _leading_in_turn(vectors: np.ndarray) -> np.ndarray:
    """Rotate components so that each in turn is the largest; inverse maps of matrices branch on the largest one."""
    for i, row in enumerate(vectors):
        row[:] = np.roll(row, i - np.argmax(np.abs(row)))
    return vectors


def poses(order: int, regime: str, dtype: type = np.float64, count: int = COUNT, seed: int = 0) -> np.ndarray:
    """Draw Rodrigues dual vectors of a regime, shape (count, 6)."""
    rng = generator(order, regime, np.dtype(dtype).name, seed=seed)
    angle = ANGLES[regime](rng, order, count)
    if np.dtype(dtype) == np.float32:
        # Single precision would round smaller distances to π away.
        angle = np.where(np.abs(angle - np.pi) < 1e-4, np.pi + 1e-3 * np.sign(angle - np.pi), angle)
    axis, moment = _leading_in_turn(unit_vectors(rng, (count,))), rng.normal(size=(count, 3))
    if regime == "coordinate axes":
        axis = np.sign(axis) * (abs(axis) == abs(axis).max(axis=-1, keepdims=True))
    size = 1e6 if regime == "translation 1e6" else 1.0
    tangent = np.tan(angle / (2 * order))[:, None]
    along = rng.normal(size=(count, 1)) * (1 + tangent**2) / (2 * order)
    dual = size * (along * axis + tangent * np.cross(moment, axis) + rng.normal(size=(count, 3)) / order)
    if regime in ("pure rotation", "identity"):
        dual = np.zeros((count, 3))
    return _filled(np.concatenate([tangent * axis, dual], axis=-1), rng, dtype)


def dual_vectors(key: str, dtype: type = np.float64, count: int = COUNT, seed: int = 0) -> np.ndarray:
    """Draw twists, rates or lines: six normally distributed numbers in each row."""
    rng = generator(key, np.dtype(dtype).name, seed=seed)
    return _filled(rng.normal(size=(count, 6)), rng, dtype)


def points(key: str, dtype: type = np.float64, count: int = COUNT, seed: int = 0) -> np.ndarray:
    rng = generator(key, np.dtype(dtype).name, seed=seed)
    return _filled(rng.normal(size=(count, 3)), rng, dtype)


def screws(order: int, dtype: type = np.float64, count: int = COUNT) -> tuple[np.ndarray, np.ndarray]:
    """Draw principal dual angles (count, 2), Re in (0, π), and unit dual axes (count, 6)."""
    rng = generator("screw", order, np.dtype(dtype).name)
    angle = np.stack([rng.uniform(0.05, 3.0, count), rng.normal(size=count)], axis=-1)
    axis = unit_vectors(rng, (count,))
    return angle.astype(dtype), np.concatenate([axis, np.cross(rng.normal(size=(count, 3)), axis)], -1).astype(dtype)
