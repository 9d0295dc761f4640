"""Errors against angle, in double precision, of our kernels and of other libraries: the data of the figures.

All libraries are given the same screws ξ at every angle (rotation α u, translation of size one). Forward maps and
Jacobians start from the vector of each map rounded to doubles, for Cayley maps v = tan(α/2n) u. They are compared with
the exact map of the rounded vector. Inverse maps all start from one matrix, exp ξ rounded to doubles.
"""

from __future__ import annotations

import functools
import math
import multiprocessing
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks.accuracy import peers
from benchmarks.accuracy.measure import DIGITS, PROCESSES
from tests.support import errors, kernels, sampling
from tests.support.exponential import ExponentialScales, exponential, rodrigues
from tests.support.first_principles import pack, rounded
from tests.support.nilpotent import Nil, inverse, matmul, transpose, vect
from tests.support.oracle import oracle_of

ORDERS = (1, 2, 3, 8)
SAMPLES = 6
SMALL = 10.0 ** np.linspace(-16, 0, 65)
WHOLE = np.linspace(0, 2 * np.pi, 65)[1:-1]
TO_PI = 10.0 ** np.linspace(-12, 0, 49)
ANGLES = {"small": SMALL, "whole": WHOLE, "to pi": np.pi - TO_PI}

# Errors in eps by (part of the result, name of the library or chart).
Point = dict[tuple[str, str], float]


@functools.cache
def libraries() -> list[peers.Peer]:
    return peers.installed()


def exponentials() -> list[peers.Peer]:
    """Return our exponential map, then the exponential maps of libraries."""
    return [peers.ours(), *libraries()]


def screws(panel: str, index: int) -> np.ndarray:
    """Draw exponential coordinates of shape (SAMPLES, 6)."""
    rng = sampling.generator("curve", panel, index)
    axis, shift = (sampling.unit_vectors(rng, (SAMPLES,)) for _ in range(2))
    return np.concatenate([ANGLES[panel][index] * axis, shift], axis=-1)


def homogeneous(tensor: Any) -> np.ndarray:
    """Return [Q ρ; 0 1] of a dual tensor (I + ε skew ρ) Q."""
    q, q_dual = pack(tensor)
    rho = vect(matmul(q_dual, transpose(q)))
    zero = q[0][0] * 0
    rows = [(*row, shift) for row, shift in zip(q, rho, strict=True)]
    return np.array([*rows, (zero, zero, zero, zero + 1)], dtype=object)


def blocks(jacobian: np.ndarray) -> np.ndarray:
    """Return the dual tensor (2, 3, 3) of a 6x6 Jacobian [[A, 0], [B, A]]."""
    return np.stack([jacobian[:3, :3], jacobian[3:, :3]])


class Errors:
    """Largest error of every curve at one angle."""

    def __init__(self) -> None:
        self.point: Point = {}
        self.oracle = oracle_of(1, DIGITS)

    def add(self, parts: tuple[str, ...], name: str, got: Any, exact: Any, scale: Nil) -> None:
        """Record the real and dual error of a result under two parts, or the larger one under a single part."""
        found = errors.errors(got, exact, scale, self.oracle)
        for part, error in zip(parts, found if len(parts) == 2 else [max(found)], strict=True):
            self.point[part, name] = max(error, self.point.get((part, name), 0.0))


def forward(xi: np.ndarray, result: Errors) -> None:
    """Add the errors of pose, T and T⁻¹, computed from v or ξ."""
    unpack = result.oracle.unpack
    exact = [exponential(unpack(row)) for row in xi]
    allowed = [ExponentialScales(row) for row in xi]
    for peer in exponentials():
        for (tensor, _), scale, got in zip(exact, allowed, peer.exp(xi), strict=True):
            size = Nil(scale.tensor.re, scale.position)
            result.add(("Q", "ρ"), peer.name, got, homogeneous(tensor), size)
        if peer.jacobian is not None:
            for (_, operator), scale, got in zip(exact, allowed, peer.jacobian(xi), strict=True):
                result.add(("T",), peer.name, blocks(got), pack(operator), scale.tangent)
        principal = np.linalg.norm(xi[0, :3]) < np.pi - 1e-6
        if peer.jacobian_inv is not None and (principal or not peer.through_log):
            for (_, operator), scale, got in zip(exact, allowed, peer.jacobian_inv(xi), strict=True):
                result.add(("T⁻¹",), peer.name, blocks(got), pack(inverse(operator)), scale.near_pole)
    for n in ORDERS:
        kernel, oracle = kernels.load(n), oracle_of(n, DIGITS)
        v = rounded(np.stack([pack(rodrigues(n, unpack(row), oracle.field)) for row in xi]), np.float64)
        results = (kernel.pose(v), kernel.tangent(v), kernel.tangent_inv(v))
        for row, pose, tangent, tangent_inv in zip(v, *results, strict=True):
            own = errors.scales(n, row)
            operator = oracle.operator_by_spin(unpack(row))
            result.add(("Q", "ρ"), f"n = {n}", pose, oracle.pose(row), Nil(own.tensor.re, own.position))
            result.add(("T",), f"n = {n}", tangent, pack(operator), own.tangent)
            result.add(("T⁻¹",), f"n = {n}", tangent_inv, pack(inverse(operator)), own.near_pole)


def inverse_maps(xi: np.ndarray, result: Errors) -> None:
    """Add the errors of v or ξ, computed from poses."""
    dual = [result.oracle.unpack(row) for row in xi]
    pairs = [exponential(row) for row in dual]
    poses = np.stack([rounded(homogeneous(tensor), np.float64) for tensor, _ in pairs])
    given = [(errors.entry_twists(r), np.array(pack(r), dtype=float).reshape(2, 9)) for r, _ in pairs]
    scales = [errors.branch_scale(t, row, *g) for (_, t), row, g in zip(pairs, dual, given, strict=True)]
    for peer in exponentials():
        for row, scale, got in zip(dual, scales, peer.log(poses), strict=True):
            result.add(("log", "log°"), peer.name, got, pack(row), scale)
    for n in ORDERS:
        oracle = oracle_of(n, DIGITS)
        for row, entries, got in zip(dual, given, kernels.load(n).from_pose(poses), strict=True):
            v = rodrigues(n, row, oracle.field)
            scale = errors.branch_scale(oracle.operator_by_spin(v), v, *entries)
            result.add(("log", "log°"), f"n = {n}", got, pack(v), scale)


def point(task: tuple[str, int]) -> tuple[str, int, Point]:
    """Return the errors at one angle of a panel; this runs in a worker process."""
    panel, index = task
    result, xi = Errors(), screws(panel, index)
    with warnings.catch_warnings():
        # Warnings are ignored, since their causes show as errors.
        warnings.simplefilter("ignore")
        if panel != "to pi":
            forward(xi, result)
        if panel != "whole":
            inverse_maps(xi, result)
    return panel, index, result.point


Curves = dict[tuple[str, str, str], np.ndarray]
"""Errors at ANGLES[panel], by (panel, part, name)."""


def curves(report: Callable[[int, int], None]) -> Curves:
    """Compute all curves; `report(done, total)` is called after every angle."""
    tasks = [(panel, i) for panel, angles in ANGLES.items() for i in range(len(angles))]
    found: Curves = {}
    for done, (panel, index, errors_there) in enumerate(_points(tasks), 1):
        for (part, name), error in errors_there.items():
            row = found.setdefault((panel, part, name), np.full(len(ANGLES[panel]), np.nan))
            row[index] = error
        report(done, len(tasks))
    return found


SEARCHED, SEEDS = 10**5, 10
"""Number of random screws of a search for the largest error of poses, and number of searches."""

PARTS = 16
"""Number of equal parts of a screw, a power of two: its pose is a power of the pose of one part."""


def searched(count: int = SEARCHED, seeds: int = SEEDS) -> dict[str, float]:
    """Return the largest errors of Q and ρ over several searches of ``count`` random screws, in eps."""
    found = [_largest(seed, count) for seed in range(seeds)]
    return {part: max(errors_there[part] for errors_there in found) for part in found[0]}


def _largest(seed: int, count: int) -> dict[str, float]:
    """Return the largest errors of Q and ρ over random screws, in eps; angles up to 2π, translations of size one.

    The exact poses are power series in longdouble, whose own errors are below 0.05 eps; scales are as in the curves.
    """
    rng = sampling.generator("search", seed)
    axis, shift = (sampling.unit_vectors(rng, (count,)) for _ in range(2))
    xi = np.concatenate([rng.uniform(0, 2 * np.pi, (count, 1)) * axis, shift], axis=-1)
    step = np.zeros((count, 4, 4), np.longdouble)
    for (i, j), k in {(2, 1): 0, (0, 2): 1, (1, 0): 2}.items():
        step[:, i, j], step[:, j, i] = xi[:, k], -xi[:, k]
    step[:, :3, 3] = xi[:, 3:]
    step /= PARTS
    exact = term = np.broadcast_to(np.eye(4, dtype=np.longdouble), step.shape)
    for k in range(1, 20):
        term = term @ step / k
        exact = exact + term
    for _ in range(PARTS.bit_length() - 1):
        exact = exact @ exact
    off = peers.ours().exp(xi) - exact
    half = np.linalg.norm(xi[:, :3], axis=-1) / 2
    across = np.where(half > 0, np.sin(half) / np.where(half > 0, half, 1), 1)
    sizes = {"Q": np.sqrt(3), "ρ": np.sqrt(1 + 2 * across**2)}  # norms of Q and T
    parts = {"Q": (off[:, :3, :3] ** 2).sum(axis=(1, 2)), "ρ": (off[:, :3, 3] ** 2).sum(axis=1)}
    return {part: float(np.max(np.sqrt(parts[part]) / sizes[part]) / np.finfo(float).eps) for part in parts}


MAY_BE = 2
"""Error in eps that is always allowed to our exponential, even if another library is more accurate."""

COMPARED = ("Q", "ρ", "log", "log°")
"""Parts of the exponential map and its logarithm."""


@dataclass(frozen=True)
class Behind:
    """Angle at which the error of our exponential exceeds both `MAY_BE` and the error of the best library."""

    panel: str
    part: str
    angle: float
    error: float
    library: str
    least: float


def behind(found: Curves) -> list[Behind]:
    """Return the angles at which our exponential is less accurate than allowed."""
    worse = []
    for (panel, part, name), row in found.items():
        others = {other: r for (p, q, other), r in found.items() if (p, q) == (panel, part) and other in peers.MAKERS}
        if name != "exponential" or part not in COMPARED or not others:
            continue
        for i, error in enumerate(row):
            best = min(others, key=lambda other: others[other][i])
            if error > max(MAY_BE, others[best][i]):
                angle = float(ANGLES[panel][i])
                worse.append(Behind(panel, part, angle, float(error), best, float(others[best][i])))
    return worse


def _points(tasks: list[tuple[str, int]]) -> Iterator[tuple[str, int, Point]]:
    with multiprocessing.get_context("spawn").Pool(PROCESSES) as pool:
        yield from pool.imap_unordered(point, tasks, chunksize=4)


@dataclass(frozen=True)
class Drawn:
    """Text beside the figures: file names with captions, and lines on the accuracy of the exponential."""

    captions: Sequence[tuple[str, str]]
    standing: Sequence[str]


def standing(found: Curves, random: Mapping[str, float]) -> list[str]:
    """Return lines on the errors of our exponential map, also over random screws, and beside other libraries.

    Errors are rounded up to halves: another search finds inputs that are a little worse.
    """
    largest = {
        part: max([float(np.nanmax(row)) for (_, p, name), row in found.items() if (p, name) == (part, "exponential")])
        for part in COMPARED
    }
    largest |= {part: max(error, largest[part]) for part, error in random.items()}
    sizes = ", ".join(f"{part} {math.ceil(2 * error) / 2:g}" for part, error in largest.items())
    bound = f"the best of these libraries or {MAY_BE} eps, whichever is larger"
    said = f"`exponential` is off by at most, in eps: {sizes}; Q and ρ over {SEEDS * SEARCHED} random screws besides."
    short = behind(found)
    if not short:
        return [f"{said} At no angle of the figures is it off by more than {bound}."]
    lines = []
    for panel, part in dict.fromkeys((b.panel, b.part) for b in short):
        here = [b for b in short if (b.panel, b.part) == (panel, part)]
        angles, most = [b.angle for b in here], max(here, key=lambda b: b.error - b.least)
        where = f"{len(here)} of {len(ANGLES[panel])} angles, from {min(angles):.3g} to {max(angles):.3g}"
        worst = f"most at {most.angle:.3g}: {most.error:.2g} eps, {most.library} {most.least:.2g}"
        lines.append(f"- {part} at {where}, {worst} FALLS SHORT")
    return [f"{said} It is off by more than {bound} in", "", *lines]
